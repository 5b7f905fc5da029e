"""The kinds of study: what the key `kind` of a study file may say.  Each is imported when asked for, and no other."""

from importlib import import_module

from silostudy.config.study import BaseStudy

KINDS = ("pressure", "buckling", "shell", "seismic", "grains", "scenes", "packing", "stability", "accuracy")


def study_model(kind: str) -> type[BaseStudy]:
    """The model of a kind of study: KindStudy of config/kind.py."""
    return getattr(import_module(f"silostudy.config.{kind}"), f"{kind.capitalize()}Study")
