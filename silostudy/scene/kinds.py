"""For each kind of study, how a validated scene configuration becomes a frozen scene.

A builder takes (study, folder of the study file, name for errors) once and returns build(config, settings) -> scene.
"""

from collections.abc import Callable
from importlib import import_module

ROOMS = {"pressure": "build", "buckling": "shell"}  # kinds whose builder stands in a file of another name


def builder(kind: str) -> Callable[..., Callable]:
    """The builder of a kind of study: kind_builder of its file in this room, imported when asked for."""
    return getattr(import_module(f"silostudy.scene.{ROOMS.get(kind, kind)}"), f"{kind}_builder")


def traits_of(kind: str) -> Callable[..., list[dict[str, float]]]:
    """For a kind that may ask for an accuracy: traits(study, scenes) -> what its errors hang on, from its builder's file."""
    return getattr(import_module(f"silostudy.scene.{ROOMS.get(kind, kind)}"), f"{kind}_traits")


def cost_of(kind: str) -> Callable[..., float]:
    """For a kind whose cases are computed in parts: cost(scene) -> seconds, from its file in this room."""
    return import_module(f"silostudy.scene.{kind}").cost
