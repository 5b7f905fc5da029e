"""The fronts of pressure studies: levels for an integral along the wall and for its largest pressure, samples for a quantile.

References: Gauss-Legendre panels for the integral, a bounded search for the peak; see fronts_samples for the quantile.
"""

from collections.abc import Callable

import numpy as np
from scipy.optimize import minimize_scalar

from silostudy.accuracy import fronts_samples
from silostudy.accuracy.fronts_levels import FINE, Curve, LevelQuantity, expansion_of, rows_of, spoken, studies, trials_of
from silostudy.accuracy.trial import Trial
from silostudy.choice.pressure import integral_number, kink_number, peak_number
from silostudy.scene.expand import Expansion

MEASURED = 60  # silos with every method
UNSEEN = 100  # studies of up to four methods


def curves(expansion: Expansion, name: str) -> list[Curve]:
    """Curves of a quantity of the methods: those that are given throughout the depth."""
    depth = expansion.cases[0].scene.silo.cylinder_depth
    curves = [Curve(functions[name], parameters, depth) for functions, parameters in spoken(expansion) if name in functions]
    return [curve for curve in curves if curve.whole]


def trapezoids(curve: Curve, count: int) -> float:
    """The integral (N/m) from even levels."""
    return float(np.trapezoid(curve.levels(count), dx=curve.depth / (count - 1)))


def largest(curve: Curve) -> float:
    """The largest pressure (Pa): between the neighbours of the largest of many."""
    z = np.linspace(0.0, curve.depth, FINE)
    k = int(np.argmax(curve(z)))
    near = (z[max(k - 1, 0)], z[min(k + 1, FINE - 1)])
    search = minimize_scalar(lambda z: -float(curve(z)), bounds=near, method="bounded", options={"xatol": 1e-12})
    return max(-search.fun, float(curve(z[k])))


QUANTITIES = (
    LevelQuantity("pressure", "wall_force", lambda expansion: curves(expansion, "wall_friction_traction"),
             lambda curve: float(curve.integrals()[-1]), trapezoids, {"integral_number": integral_number},
             within={"heap": (0.0, 0.0)}),  # above the wall's contact a traction begins with a step
    LevelQuantity("pressure", "peak_pressure", lambda expansion: curves(expansion, "wall_normal_pressure"),
             largest, lambda curve, count: float(curve.levels(count).max()),
             {"peak_number": peak_number, "kink_number": kink_number}),
)  # fmt: skip


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv."""
    silos = [expansion_of(content, relative_depth=[0.0, 1.0]) for content in studies(0, MEASURED)]
    levels = [row for quantity in QUANTITIES for row in rows_of(quantity, silos, tell)]
    return levels + fronts_samples.measured_fronts(tell)


def trials(tell: Callable[[str], None]) -> list[Trial]:
    """Trials of the shipped fronts' choices on studies that they were not measured on."""
    levels = [trial for quantity in QUANTITIES for trial in trials_of(quantity, studies(1, UNSEEN, 4), tell)]
    return levels + fronts_samples.trials(tell)
