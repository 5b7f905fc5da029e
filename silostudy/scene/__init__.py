"""What is simulated: frozen scenes in SI units, and the cases of a study."""
