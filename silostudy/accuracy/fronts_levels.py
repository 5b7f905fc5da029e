"""The front of depth levels, over all methods: an integral along the wall by trapezoids, and the largest pressure on it.

References: Gauss-Legendre panels for the integral, a bounded search for the peak.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from pathlib import Path
from typing import Any

import numpy as np
from scipy.optimize import minimize_scalar

from silostudy.accuracy.trial import Trial, cpu_seconds, front_row
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import call
from silostudy.scene.expand import Expansion, expand
from silostudy.scene.traits import LEVELS, integral_number, kink_number, parameters_of_scenes, peak_number
from silostudy.tables.solids import SOLIDS
from silostudy.tables.walls import WALLS

COUNTS = tuple(dict.fromkeys(round(2.0 ** (1 + k / 4)) + 1 for k in range(37)))  # 3 ... 1025, each 1.19 times the one before
MEASURED, UNSEEN, TIMED = 60, 100, 5  # silos with every method; studies of up to four methods; silos that are timed
NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
PANELS, FINE = 64, 4097
ASKED = {"wall_force": (1e-5, 0.1), "peak_pressure": (1e-5, 0.1)}  # errors asked for lie between
# traits that the errors of a quantity go with, each the worst of a scene's curves
NUMBERS: dict[str, dict[str, Callable]] = {
    "wall_force": {"integral_number": integral_number},
    "peak_pressure": {"peak_number": peak_number, "kink_number": kink_number},
}
CURVE = {"wall_force": "wall_friction_traction", "peak_pressure": "wall_normal_pressure"}
HEAP = {"wall_force": {"heap": (0.0, 0.0)}, "peak_pressure": {}}  # above it a traction begins with a step
SOURCE = "silo_handbook"


@dataclass(frozen=True, eq=False)
class Curve:
    """A pressure (Pa) over the depth (m) of one silo by one method in one phase."""

    function: Callable
    parameters: dict[str, Any]
    depth: float

    def __call__(self, z):
        return np.broadcast_to(call(self.function, np.asarray(z, float), self.parameters), np.shape(z))

    def levels(self, count: int) -> np.ndarray:
        """Values at even levels from the surface to the foot."""
        return self(np.linspace(0.0, self.depth, count))


def studies(seed: int, count: int, methods: int | None = None) -> Iterator[dict]:
    """Contents of pressure studies of one silo each, with all methods or up to so many: other seeds give others.

    Those with all methods are slender and stubby beyond the others.
    """
    least, most = (0.5, 9.0) if methods else (0.2, 15.0)
    random = np.random.default_rng(seed)
    walls = [key for key, wall in WALLS.items() if wall.rule != "category"]
    while count:
        width = random.uniform(1.0, 20.0)
        plan, named = (("circular", "diameter_m"), ("square", "width_m"), ("slot", "width_m"))[random.integers(3)]
        silo = {"plan": plan, named: width, "slenderness": float(np.exp(random.uniform(np.log(least), np.log(most))))}
        if random.random() < 0.5:
            silo["hopper"] = {"half_angle_deg": random.uniform(12.0, 40.0), "outlet_width_m": 0.1 * width}
        scene = {"silo": silo, "solid": str(random.choice(list(SOLIDS))), "wall": str(random.choice(walls)),
                 "properties": {"poisson_ratio": random.uniform(0.2, 0.4)}}  # fmt: skip
        keys = [str(key) for key in random.permutation(list(PRESSURE))[: random.integers(1, methods + 1) if methods else None]]
        yield {
            "kind": "pressure",
            "title": "a silo at random",
            "scene": scene,
            "methods": keys,
            "phases": ["filling", "discharge"],
        }
        count -= 1


def expansion_of(content: dict, **more) -> Expansion:
    """The study with its one silo."""
    return expand({**content, **more}, "trial", "trial", Path("."))


def curves(expansion: Expansion, quantity: str) -> list[Curve]:
    """The curves of a study that the quantity is taken from: those that its methods give throughout the depth."""
    scene, found = expansion.cases[0].scene, []
    for key in expansion.study.method_keys:
        row = PRESSURE[key]
        parameters = {name: value[0, 0] for name, value in parameters_of_scenes([scene], row.table_key or key).items()}
        for phase in expansion.study.phases:
            function = row.phases.get(phase, {}).get(CURVE[quantity])
            if function is None or scene.silo.plan not in row.plans:
                continue
            curve = Curve(function, parameters, scene.silo.cylinder_depth)
            with np.errstate(all="ignore"):
                if np.isfinite(curve.levels(FINE)).all():
                    found.append(curve)
    return found


def exact(curve: Curve, quantity: str) -> float:
    """The integral (N/m) by Gauss-Legendre panels, or the largest pressure (Pa) by a bounded search."""
    if quantity == "wall_force":
        edges = np.linspace(0.0, curve.depth, PANELS + 1)
        half = 0.5 * (edges[1] - edges[0])
        z = (edges[:-1, None] + half) + half * NODES
        return float((curve(z) @ WEIGHTS).sum() * half)
    z = np.linspace(0.0, curve.depth, FINE)
    k = int(np.argmax(curve(z)))
    near = (z[max(k - 1, 0)], z[min(k + 1, FINE - 1)])
    search = minimize_scalar(lambda at: -float(curve(at)), bounds=near, method="bounded", options={"xatol": 1e-12})
    return max(-search.fun, float(curve(z[k])))


def found_with(curve: Curve, quantity: str, count: int) -> float:
    """What even levels give of it."""
    values = curve.levels(count)
    return float(np.trapezoid(values, dx=curve.depth / (count - 1)) if quantity == "wall_force" else values.max())


def errors(each: list[Curve], quantity: str) -> np.ndarray:
    """Relative error of every curve with every number of levels: (curve, count)."""
    right = np.array([exact(curve, quantity) for curve in each])
    return np.abs(np.array([[found_with(curve, quantity, count) for count in COUNTS] for curve in each]) / right[:, None] - 1)


def costs(each: list[Curve], quantity: str) -> np.ndarray:
    """CPU seconds of all curves with every number of levels; more levels never cost less, what says otherwise is noise."""
    spent = [cpu_seconds(lambda count=count: [found_with(curve, quantity, count) for curve in each]) for count in COUNTS]  # type: ignore[misc]
    return np.maximum.accumulate(spent)


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv: error over each of the curve's numbers that it goes with, worst of all curves of all silos."""
    rows = []
    for quantity, numbers in NUMBERS.items():
        silos = [curves(expansion_of(content, relative_depth=[0.0, 1.0]), quantity) for content in studies(0, MEASURED)]
        cost = np.median([costs(each, quantity) / len(each) for each in [one for one in silos if one][:TIMED]], axis=0)
        for trait, number_of in numbers.items():
            of = {curve: float(number_of(curve.levels(LEVELS))) for each in silos for curve in each}
            counted = [curve for curve, number in of.items() if number > 0]
            over = errors(counted, quantity) / np.array([[of[curve]] for curve in counted])
            tell(f"{quantity}: {len(counted)} curves with a {trait}, of {MEASURED} silos")
            within = {trait: (0.0, float(f"{1.05 * max(of.values()):.2g}")), **HEAP[quantity]}
            for k, levels in enumerate(COUNTS):
                settings = {"relative_depth": {"start": 0.0, "stop": 1.0, "count": levels}}
                row = front_row("pressure", quantity, settings, float(over[:, k].max()), cost[k], len(counted), SOURCE,
                                scaled_by=trait, within=within)  # fmt: skip
                rows.append(row)
    return rows


def trials(tell: Callable[[str], None], count: int = UNSEEN) -> list[Trial]:
    """Studies of several methods at once that ask for errors at random: the worst of their curves counts."""
    found, random = [], np.random.default_rng(2)
    for quantity, (low, high) in ASKED.items():
        for content in studies(1, count, 4):
            asked = float(np.exp(random.uniform(np.log(low), np.log(high))))
            expansion = expansion_of(content, accuracy={quantity: asked})
            each = curves(expansion, quantity)
            if each:
                found.append(trial(quantity, asked, len(expansion.study.depths), each))
        tell(f"{quantity}: {sum(one.met for one in found)} of {len(found)} met")
    return found


def trial(quantity: str, asked: float, chosen: int, each: list[Curve]) -> Trial:
    """What a number of levels gave, and the least that would have met what was asked."""
    error, cost = errors(each, quantity).max(axis=0), costs(each, quantity)
    enough = int(np.argmax(error <= asked)) if (error <= asked).any() else -1
    k = COUNTS.index(chosen)
    return Trial("pressure", quantity, asked, error[k], cost[k], cost[enough], chosen, COUNTS[enough])
