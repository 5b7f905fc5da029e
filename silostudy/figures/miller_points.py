"""Miller's tests as points in his own coordinates: C, M, C_3, M_e."""

from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes

from silostudy.figures.rules import GROUPS, group
from silostudy.figures.style import VERMILION


def points(cube: xr.Dataset) -> pd.DataFrame:
    """One row a test: coefficients from the measured collapse stress (the lower where two are given)."""
    stress, radius, thickness = (cube[name].values for name in ("test_lower_buckling_stress", "shell_radius", "thickness"))
    length, total = cube["bay_length"].values, cube["test_total_length"].values
    coefficient = stress * radius / (cube["youngs_modulus"].values * thickness)
    ratio = cube["ring_area"].values / (length * thickness)
    m2, effective = length**2 / (radius * thickness), np.sqrt(1 + ratio)
    me2 = total**2 / (radius * thickness) * effective
    return pd.DataFrame(
        {
            "test": [str(test) for test in cube["test"].values],
            "group": group(cube),
            "collapse": [str(collapse) for collapse in cube["test_collapse"].values],
            "elastic": stress <= 0.55 * cube["yield_stress"].values,
            "R_over_t": radius / thickness,
            "M2": m2,
            "C": coefficient,
            "CM2": coefficient * m2,
            "J": coefficient * m2**0.3,
            "ring_area_ratio": ratio,
            "C3": coefficient / effective,
            "Me2": me2,
            "C3Me2": coefficient / effective * me2,
            "strength_ratio": stress / cube["yield_stress"].values,
        }
    )


def reached(measured: Any, designed: Any) -> str:
    """Number of measured values that come up to the designed ones, where there are both: "3 of 4"."""
    margin = np.asarray(measured) / np.asarray(designed)
    return f"{np.sum(margin >= 1.0)} of {np.isfinite(margin).sum()}"


def scatter(panel: Axes, tests: pd.DataFrame, x: str, y: str) -> None:
    """Draws tests by group: filled where they collapsed below 0.55 of the yield stress, open beyond."""
    for kind, (marker, label) in GROUPS.items():
        here = tests[tests.group == kind]
        for elastic, fill in ((True, VERMILION), (False, "none")):
            part = here[here.elastic == elastic]
            if len(part):
                text = f"{label}, {'elastic' if elastic else 'inelastic'}"
                style: dict[str, Any] = {
                    "linestyle": "none",
                    "marker": marker,
                    "markersize": 6,
                    "color": VERMILION,
                    "markerfacecolor": fill,
                }
                panel.plot(part[x], part[y], label=text, **style)
