"""The front of pressure studies: depth levels for what is integrated or sought along a wall, samples for a quantile."""

from collections.abc import Callable

import numpy as np

from silostudy.accuracy.measure import measure
from silostudy.accuracy.trial import Trial, front_row

LEVELS = ("peak_pressure", "wall_force")
SOURCE = "silo_handbook"


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv."""
    return _levels() + _samples()


def _levels() -> list[dict]:
    """Depth levels: worst over the problem's 200 silos."""
    rows = []
    for rung in measure("depth_levels", repeats=5, members=3):
        settings = {"relative_depth": {"start": 0.0, "stop": 1.0, "count": int(rung.setting)}}
        rows += [front_row("pressure", name, settings, rung.error[name], rung.cost, 200, SOURCE) for name in LEVELS]
    return rows


def _samples() -> list[dict]:
    """Samples of a solid's scatter: worst of the problem's 16 seeds."""
    rows = []
    for rung in measure("quantile", repeats=5, members=3, ladders=1):
        power = round(np.log2(rung.setting))
        if power >= 6:  # fewer the configuration does not take
            settings = {"uncertainty.log2_samples": power}
            error = rung.error["wall_pressure"]
            rows.append(front_row("pressure", "pressure_quantile", settings, error, rung.cost, 16, SOURCE))
    return rows


def trials(tell: Callable[[str], None]) -> list[Trial]:
    """How the shipped front's choice does on silos that it was not measured on."""
    return []
