"""The fronts of depth levels: what every quantity taken from even levels shares, and silos by all methods to measure it on."""

from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import dataclass, field
from functools import partial
from pathlib import Path
from typing import Any

import numpy as np
from scipy.integrate import quad

from silostudy.accuracy.trial import Trial, cpu_seconds, front_row
from silostudy.choice.expand import expand
from silostudy.choice.pressure import LEVELS
from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call
from silostudy.pressure.family import usual
from silostudy.scene.expand import Expansion
from silostudy.scene.scene import parameters_of_scenes
from silostudy.tables.solids import SOLIDS
from silostudy.tables.walls import WALLS

COUNTS = tuple(dict.fromkeys(round(2.0 ** (1 + k / 4)) + 1 for k in range(37)))  # 3 ... 1025, each 1.19 times the one before
TIMED = 5  # silos that are timed
NODES, WEIGHTS = np.polynomial.legendre.leggauss(10)
PANELS = 64  # of a curve's integral
FINE = 4097  # levels at which a method must give a pressure, to be looked at
ROUNDING = 1e-11  # relative difference of a panel and its halves beyond which it is integrated in steps that adapt
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

    @property
    def whole(self) -> bool:
        """Whether the method speaks at every depth."""
        with np.errstate(all="ignore"):
            return bool(np.isfinite(self.levels(FINE)).all())

    def integrals(self) -> np.ndarray:
        """The integral (N/m) from the surface to the ends of even panels: by Gauss and Legendre, adaptive in one that jumps."""
        ends = np.linspace(0.0, self.depth, 2 * PANELS + 1)
        whole = self._panels(ends[::2])
        halves = self._panels(ends).reshape(PANELS, 2).sum(axis=1)
        for k in np.flatnonzero(np.abs(whole - halves) > ROUNDING * np.abs(halves).sum()):
            halves[k] = quad(self, ends[2 * k], ends[2 * k + 2], epsrel=ROUNDING, limit=200)[0]
        return np.cumsum(halves)

    def _panels(self, ends: np.ndarray) -> np.ndarray:
        half = 0.5 * np.diff(ends)
        return self(ends[:-1, None] + half[:, None] * (1.0 + NODES)) @ WEIGHTS * half


@dataclass(frozen=True)
class LevelQuantity:
    """Quantity taken from levels: of which curves, its right value, what a number of levels gives, what its error goes with."""

    kind: str
    name: str
    curves: Callable[[Expansion], list[Any]]
    exact: Callable[[Any], float]
    taken: Callable[[Any, int], float]
    numbers: dict[str, Callable]  # trait -> the same of a curve; a scene's trait is the worst of its curves
    within: dict[str, tuple[float, float]] = field(default_factory=dict)
    asked: tuple[float, float] = (1e-5, 0.1)  # errors that trials ask for lie between


def studies(seed: int, count: int, methods: int | None = None) -> Iterator[dict]:
    """Contents of pressure studies of one silo each, with all methods or up to so many: other seeds give others.

    Those with all methods are slender and stubby beyond the others.
    """
    least, most = (0.5, 9.0) if methods else (0.2, 15.0)
    random = np.random.default_rng(seed)
    walls = [key for key, wall in WALLS.items() if wall.rule != "category"]
    for _ in range(count):
        width = random.uniform(1.0, 20.0)
        plan, named = (("circular", "diameter_m"), ("square", "width_m"), ("slot", "width_m"))[random.integers(3)]
        silo = {"plan": plan, named: width, "slenderness": float(np.exp(random.uniform(np.log(least), np.log(most))))}
        if random.random() < 0.5:
            silo["hopper"] = {"half_angle_deg": random.uniform(12.0, 40.0), "outlet_width_m": 0.1 * width}
        scene = {"silo": silo, "solid": str(random.choice(list(SOLIDS))), "wall": str(random.choice(walls)),
                 "properties": {"poisson_ratio": random.uniform(0.2, 0.4)}}  # fmt: skip
        keys = [str(key) for key in random.permutation(usual(PRESSURE))[: random.integers(1, methods + 1) if methods else None]]
        yield {
            "kind": "pressure",
            "title": "a silo at random",
            "scene": scene,
            "methods": keys,
            "phases": ["filling", "discharge"],
        }


def expansion_of(content: dict, **more) -> Expansion:
    """The study with its one silo."""
    return expand({**content, **more}, "trial", "trial", Path("."))


def spoken(expansion: Expansion) -> Iterator[tuple[Mapping[str, Callable], dict[str, Any]]]:
    """Functions by quantity, and parameters, of every method of a study in every phase that it covers."""
    scene = expansion.cases[0].scene
    for key in expansion.study.method_keys:
        row = PRESSURE[key]
        parameters = {name: value[0, 0] for name, value in parameters_of_scenes([scene], row).items()}
        for phase in expansion.study.phases:
            if phase in row.phases and scene.silo.plan in row.plans:
                yield row.bounded(phase), parameters


def errors(curves: list, quantity: LevelQuantity) -> np.ndarray:
    """Relative error of every curve with every number of levels: (curve, count)."""
    right = np.array([quantity.exact(curve) for curve in curves])
    return np.abs(np.array([[quantity.taken(curve, count) for count in COUNTS] for curve in curves]) / right[:, None] - 1.0)


def costs(curves: list, quantity: LevelQuantity) -> np.ndarray:
    """CPU seconds of all curves with every number of levels; more levels never cost less, what says otherwise is noise."""
    return np.maximum.accumulate([cpu_seconds(partial(_all, curves, quantity, count)) for count in COUNTS])


def _all(curves: list, quantity: LevelQuantity, count: int) -> None:
    for curve in curves:
        quantity.taken(curve, count)


def rows_of(quantity: LevelQuantity, expansions: Iterable[Expansion], tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv: error over each of the curve's numbers that it goes with, worst of all curves of all silos."""
    rows = []
    silos = [curves for expansion in expansions if (curves := quantity.curves(expansion))]
    cost = np.median([costs(curves, quantity) / len(curves) for curves in silos[:TIMED]], axis=0)
    for trait, number_of in quantity.numbers.items():
        of = {curve: float(number_of(curve.levels(LEVELS))) for curves in silos for curve in curves}
        counted = [curve for curve, number in of.items() if number > 0]
        worst = (errors(counted, quantity) / np.array([[of[curve]] for curve in counted])).max(axis=0)
        tell(f"{quantity.kind}, {quantity.name}: {len(counted)} curves with a {trait}, of {len(silos)} silos")
        within = {trait: (0.0, float(f"{1.05 * max(of.values()):.2g}")), **quantity.within}
        for k, levels in enumerate(COUNTS):
            settings = {"relative_depth": {"start": 0.0, "stop": 1.0, "count": levels}}
            row = front_row(quantity.kind, quantity.name, settings, float(worst[k]), cost[k], len(counted), SOURCE,
                            scaled_by=trait, within=within)  # fmt: skip
            rows.append(row)
    return rows


def trials_of(quantity: LevelQuantity, contents: Iterable[dict], tell: Callable[[str], None]) -> list[Trial]:
    """Studies of several methods at once that ask for errors at random: the worst of their curves counts."""
    tried, random = [], np.random.default_rng(2)
    for content in contents:
        asked = float(np.exp(random.uniform(*np.log(quantity.asked))))
        if quantity.curves(expansion_of(content, relative_depth=[0.0, 1.0])):
            expansion = expansion_of(content, accuracy={quantity.name: asked})
            tried.append(trial(quantity, asked, len(expansion.study.depths), quantity.curves(expansion)))
    tell(f"{quantity.kind}, {quantity.name}: {sum(result.met for result in tried)} of {len(tried)} met")
    return tried


def trial(quantity: LevelQuantity, asked: float, chosen: int, curves: list) -> Trial:
    """Trial of a number of levels: what it gave, and the least that would have met what was asked."""
    error, cost = errors(curves, quantity).max(axis=0), costs(curves, quantity)
    enough = int(np.argmax(error <= asked)) if (error <= asked).any() else -1
    k = COUNTS.index(chosen)
    return Trial(quantity.kind, quantity.name, asked, error[k], cost[k], cost[enough], chosen, COUNTS[enough])
