"""Sweeps of costly cases: planned in parts, each computed by a job into a journal, merged into one cube."""
