"""The front of discrete-element scenes: worst errors of the wall forces over silos of many kinds, and trials on others.

Error: of the static force on each sixth of the walls, against velocity Verlet at a quarter of the finest step.
"""

import time
from collections.abc import Callable, Iterable
from dataclasses import replace

import numpy as np

from silostudy.accuracy.silo import contact, scene, wall_force
from silostudy.accuracy.trial import Trial, front_row, kept
from silostudy.dem.engine import Engine, Explosion
from silostudy.dem.model import Model
from silostudy.dem.stability import chosen_step
from silostudy.tables.fronts import choose

INTEGRATORS = ("17-18", "17-19", "velocity-verlet")
FACTORS = (1.0, 0.5, 0.25, 0.12, 0.06, 0.03)  # of the step that the engine chooses
FINEST, REST, PARTS = 0.0075, 0.5, 6  # factor of the reference; s to rest; parts of a wall
MEASURED, UNSEEN = 8, 12  # silos that the front is measured on, and silos that the choice is tried on
ASKED = (0.2, 0.1, 0.05, 0.02)
SOURCE = "kiyama_fujimura_1983"


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
    """Rows of tables/fronts.csv."""
    found = []
    for model in silos(0, MEASURED):
        found.append(errors_and_costs(model))
        tell(f"silo {len(found)} of {MEASURED}: {len(model.x)} discs")
    rows = []
    for integrator, factor in found[0]:
        worst = max(one[integrator, factor][0] for one in found)
        cost = float(np.median([one[integrator, factor][1] for one in found]))
        settings = {"march.integrator": integrator, "march.step_factor": factor}
        rows.append(front_row("dem", "wall_force", settings, worst, cost, MEASURED, SOURCE))
    return kept(rows)


def trials(tell: Callable[[str], None], count: int = UNSEEN) -> list[Trial]:
    """How the shipped front's choice does on silos that it was not measured on."""
    chosen = {asked: choose("dem", {"wall_force": asked}).settings for asked in ASKED}
    found = []
    for number, model in enumerate(silos(1, count)):
        each = errors_and_costs(model)
        for asked, settings in chosen.items():
            error, cost = each[settings["march.integrator"], settings["march.step_factor"]]
            cheapest = min((spent for wrong, spent in each.values() if wrong <= asked), default=np.nan)
            found.append(Trial("dem", "wall_force", asked, error, cost, cheapest))
        tell(f"silo {number + 1} of {count}: {len(model.x)} discs, {sum(one.met for one in found)} of {len(found)} met")
    return found
