"""Scenes: what is simulated, frozen and in SI units, and the cases of a study."""
