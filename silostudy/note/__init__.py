"""The calculation note of a silo: every number from the cubes, every formula with its numbers put in, as one HTML file."""
