"""From scenes to cubes: one file a stage."""
