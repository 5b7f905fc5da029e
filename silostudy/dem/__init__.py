"""Discrete elements: discs in a plane silo, stepped by a kernel compiled from the pieces that a scene calls for."""

from silostudy.dem import cache

cache.prepare()  # before anything is compiled
