"""A part of a study that is too long to be looked at whole: fewer values on its axes, with their ends."""

from math import prod
from typing import Any

import numpy as np

from silostudy.config.study import Axis, BaseStudy


def thinned(study: BaseStudy, content: dict[str, Any], most: int) -> dict[str, Any]:
    """The content of a study of `most` cases at most: of each axis values from end to end, of a sampled plan a smaller one.

    What is drawn of it is left out: figures may ask for more values than are left.
    """
    lengths = shortened([len(axis.settings()) for axis in study.sweep], most)
    axes = [_shorter(said, axis, length) for said, axis, length in zip(content["sweep"], study.sweep, lengths, strict=True)]
    return {key: value for key, value in content.items() if key != "outputs"} | {"sweep": axes}


def shortened(lengths: list[int], most: int) -> list[int]:
    """Lengths of axes of `most` cases at most: the longest one gives first."""
    shorter = list(lengths)
    while prod(shorter) > most:
        longest = int(np.argmax(shorter))
        shorter[longest] -= max(1, shorter[longest] // 20)
    return shorter


def _shorter(said: dict[str, Any], axis: Axis, length: int) -> dict[str, Any]:
    if axis.sample:
        return said | {"sample": said["sample"] | {"count": max(2, length)}}
    settings = axis.settings()
    places = np.linspace(0, len(settings) - 1, length).round().astype(int)
    return {"axis": axis.axis, "points": [settings[place] for place in places]}
