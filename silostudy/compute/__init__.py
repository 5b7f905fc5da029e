"""Stages that compute cubes from scenes, one file a stage."""
