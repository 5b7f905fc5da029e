"""The front of packing studies: how many runs the mean share of the weight on a side wall needs.

Discs of the source's 17/18 packing, laid with the offsets of a packing study and brought to rest.  A mean has no other error
than what its runs scatter: that is measured, and means of so many runs are drawn from it.  Trials draw runs of other silos,
as many as a study would add, and hold their mean against that of many more.
"""

import time
from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from silostudy.accuracy.certificates import WAYS, Scattered, asked_at_random, trials_of_means
from silostudy.accuracy.silo import contact_of_discs, contact_with_walls, silo_of_rows, wall_force
from silostudy.accuracy.trial import Trial, front_row
from silostudy.choice.choose import choose
from silostudy.choice.packing import friction_scatter
from silostudy.compute.packing import FIRST, PRIOR, scatter_of
from silostudy.compute.packing import SHARE as SHARE_ASKED
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.stability import chosen_step
from silostudy.tables.constants import ROUNDED_GRAVITY
from silostudy.tables.kiyama_1983 import ACTIVE, GAPS, PASSIVE, RADIUS, pitch

RUNS = tuple(dict.fromkeys(round(2.0 ** (k / 4)) for k in range(4, 37)))  # 2 ... 512, each 1.19 times the one before
GAP = GAPS[PASSIVE]  # m, between discs at the start, as in a packing study
OFFSET = 1e-4  # m, by which places are moved at random at the start
REST = 1.0  # s to rest
PITCH = pitch(ACTIVE)
MEASURED = 20  # silos that the front is measured on
SPREAD = 48  # runs of each
DRAWN = 4000  # means drawn of them
UNSEEN = 8  # other silos
POOL = 320  # runs of each that means are drawn from
DRAWS = 25  # means of each
SHARE = 0.95  # of means that must meet an error
ASKED = (0.012, 0.06)  # errors asked for lie between
SOURCE = "kiyama_fujimura_1983"


@dataclass(frozen=True)
class PackedSilo:
    """Discs across, rows, friction of discs and walls."""

    across: int
    rows: int
    discs: float
    walls: float

    @property
    def number(self) -> float:
        """The trait that the spread of the runs goes with."""
        return friction_scatter(self.discs, self.walls, len(self.model(0).x))

    @property
    def traits(self) -> dict[str, float]:
        """All that are measured."""
        return {"friction_scatter": self.number, "offset": OFFSET / RADIUS, "offset_gap": GAP / RADIUS, "pitch": PITCH}

    def model(self, seed: int) -> Model:
        """One start."""
        model, _ = silo_of_rows(self.across, self.rows, gap=GAP, offset=OFFSET, seed=seed)
        model = replace(model, pair_contact=contact_of_discs(self.discs), wall_contact=contact_with_walls(self.walls))
        return replace(model, dt=chosen_step(model))


def silos(seed: int, count: int, across: tuple[int, int]) -> Iterator[PackedSilo]:
    """Silos that differ in width, height and frictions; other seeds give others.  across: discs in the lowest row."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        width = int(random.integers(*across))
        rows = int(width * random.uniform(0.9, 2.2))
        yield PackedSilo(width, rows, random.uniform(0.3, 0.6), random.uniform(0.1, 0.4))


def shares(silo: PackedSilo, seeds) -> tuple[np.ndarray, float]:
    """Mean normal force of a side wall over the weight (1) of every run at rest, and CPU seconds of one."""
    parts, start = [], time.process_time()
    for seed in seeds:
        engine = Engine(silo.model(seed))
        engine.step_to(round(REST / engine.model.dt))
        parts.append(0.5 * wall_force(engine, 1).sum() / (engine.mass.sum() * ROUNDED_GRAVITY))
    return np.array(parts), (time.process_time() - start) / len(parts)


def drawn(runs: np.ndarray, random: np.random.Generator) -> np.ndarray:
    """Relative errors of means of so many runs, drawn from those at hand: (number of runs, mean)."""
    wrong = runs / runs.mean() - 1.0
    return np.abs([random.choice(wrong, (DRAWN, count)).mean(axis=1) for count in RUNS])


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv: the error over the silo's number that 19 of 20 means keep, over all silos."""
    random, errors, spent, laid = np.random.default_rng(0), [], [], list(silos(0, MEASURED, (5, 19)))
    for silo in laid:
        runs, cost = shares(silo, range(SPREAD))
        errors.append(drawn(runs, random) / silo.number)
        spent.append(cost)
        tell(f"rest_side_share: silo {len(spent)} of {MEASURED}, runs scatter by {runs.std(ddof=1) / runs.mean():.1%}")
    lasting, cost = np.quantile(np.hstack(errors), SHARE, axis=1), float(np.median(spent))
    numbers = [silo.number for silo in laid]
    within = {"friction_scatter": (0.95 * min(numbers), 1.05 * max(numbers)), "offset": _about(OFFSET / RADIUS),
              "offset_gap": _about(GAP / RADIUS), "pitch": _about(PITCH)}  # fmt: skip
    return [
        front_row("packing", "rest_side_share", {"runs": count}, float(lasting[k]), count * cost, MEASURED * SPREAD, SOURCE,
                  scaled_by="friction_scatter", within={name: _rounded(span) for name, span in within.items()})
        for k, count in enumerate(RUNS)
    ]  # fmt: skip


def _about(value: float) -> tuple[float, float]:
    return 0.99 * value, 1.01 * value


def _rounded(span: tuple[float, float]) -> tuple[float, float]:
    return float(f"{span[0]:.3g}"), float(f"{span[1]:.3g}")


def trials(tell: Callable[[str], None], count: int = UNSEEN, runs: int = POOL) -> list[Trial]:
    """Runs of other silos, added until they show that their mean keeps what was asked, as a study adds them."""
    return [trial for way, trial in trials_of_means(packings(tell, count, runs)) if way == WAYS[-1]]


def packings(tell: Callable[[str], None], count: int, runs: int) -> Iterator[tuple[Scattered, float]]:
    """Silos that the front was not measured on, with runs of theirs to draw from; several errors asked of each."""
    random = np.random.default_rng(2)
    for silo in silos(1, count, (7, 13)):
        pool, _ = shares(silo, range(runs))
        scatter = float(pool.std(ddof=1) / pool.mean())
        tell(f"{SHARE_ASKED}: {runs} runs scatter by {scatter:.1%}")
        for asked in asked_at_random(random, ASKED, DRAWS):
            choice = choose(["packing"], {SHARE_ASKED: asked}, [silo.traits])
            expected = scatter_of(choice.expected[SHARE_ASKED], choice.settings["runs"])
            draw = partial(_picked, random, pool)
            yield Scattered("packing", SHARE_ASKED, draw, float(pool.mean()), expected, scatter, PRIOR, FIRST), asked


def _picked(random: np.random.Generator, values: np.ndarray, count: int) -> np.ndarray:
    return np.asarray(random.choice(values, count))
