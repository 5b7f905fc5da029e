"""Measures the fronts behind `accuracy:`: worst errors over silos of many kinds, and how the choice does on others.

Discrete elements: the static force on each sixth of the walls against velocity Verlet at a quarter of the finest step.
"""

import json
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass, replace

import numpy as np

from silostudy.accuracy.front import on_front
from silostudy.accuracy.measure import machine, measure
from silostudy.accuracy.silo import contact, scene, wall_force
from silostudy.dem.engine import Engine, Explosion
from silostudy.dem.model import Model
from silostudy.dem.stability import chosen_step
from silostudy.tables.fronts import COLUMNS

INTEGRATORS = ("17-18", "17-19", "velocity-verlet")
FACTORS = (1.0, 0.5, 0.25, 0.12, 0.06, 0.03)  # of the step that the engine chooses
FINEST, REST, PARTS = 0.0075, 0.5, 6  # factor of the reference; s to rest; parts of a wall
MEASURED, UNSEEN = 8, 12  # silos that the front is measured on, and silos that the choice is tried on
ASKED = (0.2, 0.1, 0.05, 0.02)
LEVELS = {"wall_force", "peak_pressure"}


@dataclass(frozen=True)
class Trial:
    """One error asked for on one silo: what the choice gave, its cost, and the cheapest cost that would have met it."""

    asked: float
    error: float
    cost: float
    cheapest: float

    @property
    def met(self) -> bool:
        return self.error <= self.asked


def silos(seed: int, count: int) -> Iterable[Model]:
    """Silos that differ in width, height, frictions and order; other seeds give others."""
    random = np.random.default_rng(seed)
    for number in range(count):
        across, levels = int(random.integers(5, 10)), int(random.integers(6, 13))
        disordered = number % 2 == 1
        seed = int(random.integers(1000))
        gap, offset = (6e-5, 2e-5) if disordered else (4e-5, 0.0)
        model, _ = scene(across, levels, gap=gap, offset=offset, seed=seed)
        friction = random.uniform(0.3, 0.6), random.uniform(0.1, 0.4)
        yield replace(model, pair=contact(1.0, friction[0]), wall=contact(2.0, friction[1]))


def errors_and_costs(model: Model) -> dict[tuple[str, float], tuple[float, float]]:
    """Error of the wall forces and CPU seconds of every integrator and step on one silo."""
    exact, _ = _forces(model, "velocity-verlet", FINEST)
    found = {}
    for integrator in INTEGRATORS:
        for factor in FACTORS:
            force, spent = _forces(model, integrator, factor)
            found[integrator, factor] = float(np.abs(force - exact).max() / exact.max()), spent
    return found


def _forces(model: Model, integrator: str, factor: float) -> tuple[np.ndarray, float]:
    model = replace(model, integrator=integrator)
    engine = Engine(replace(model, dt=factor * chosen_step(model)))
    start = time.process_time()
    try:
        engine.step_to(round(REST / engine.model.dt))
    except Explosion:
        return np.array(np.inf), np.inf
    spent = time.process_time() - start
    return wall_force(engine, PARTS), spent


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv, measured here and now."""
    found = []
    for model in silos(0, MEASURED):
        found.append(errors_and_costs(model))
        tell(f"silo {len(found)} of {MEASURED}: {len(model.x)} discs")
    rows = []
    for integrator, factor in found[0]:
        worst = max(one[integrator, factor][0] for one in found)
        cost = float(np.median([one[integrator, factor][1] for one in found]))
        settings = {"march.integrator": integrator, "march.step_factor": factor}
        rows.append(_row("dem", "wall_force", settings, worst, cost, MEASURED))
    rows = _kept(rows) + _levels() + _samples()
    about = {name: machine()[name] for name in ("machine", "measured_on")}
    return [{name: (row | about)[name] for name in COLUMNS} for row in rows]


def _row(kind, quantity, settings, error, cost, scenes) -> dict:
    source = {"source": "kiyama_fujimura_1983" if kind == "dem" else "silo_handbook", "locator": "measured on its model"}
    values = {"kind": kind, "quantity": quantity, "settings": json.dumps(settings), "scenes": scenes}
    return values | {"error": float(f"{error:.3g}"), "cost_s": float(f"{cost:.3g}")} | source


def _kept(rows: list[dict]) -> list[dict]:
    """The rows on the front."""
    kept = on_front([row["cost_s"] for row in rows], [row["error"] for row in rows])
    return [row for row, on in zip(rows, kept, strict=True) if on]


def _levels() -> list[dict]:
    """Depth levels: worst over the problem's 200 silos."""
    rows = []
    for rung in measure("depth_levels", repeats=5, members=3):
        settings = {"relative_depth": {"start": 0.0, "stop": 1.0, "count": int(rung.setting)}}
        rows += [_row("pressure", name, settings, rung.error[name], rung.cost, 200) for name in sorted(LEVELS)]
    return rows


def _samples() -> list[dict]:
    """Samples of a solid's scatter: worst of the problem's 16 seeds."""
    rows = []
    for rung in measure("quantile", repeats=5, members=3, ladders=1):
        power = round(np.log2(rung.setting))
        if power >= 6:  # fewer the configuration does not take
            settings = {"uncertainty.log2_samples": power}
            rows.append(_row("pressure", "pressure_quantile", settings, rung.error["wall_pressure"], rung.cost, 16))
    return rows


def trials(tell: Callable[[str], None], count: int = UNSEEN) -> list[Trial]:
    """How the shipped front's choice does on silos that it was not measured on."""
    from silostudy.tables.fronts import choose

    chosen = {asked: choose("dem", {"wall_force": asked}).settings for asked in ASKED}
    found = []
    for number, model in enumerate(silos(1, count)):
        each = errors_and_costs(model)
        for asked, settings in chosen.items():
            error, cost = each[settings["march.integrator"], settings["march.step_factor"]]
            cheapest = min((spent for wrong, spent in each.values() if wrong <= asked), default=np.nan)
            found.append(Trial(asked, error, cost, cheapest))
        tell(f"silo {number + 1} of {count}: {len(model.x)} discs, {sum(one.met for one in found)} of {len(found)} met")
    return found
