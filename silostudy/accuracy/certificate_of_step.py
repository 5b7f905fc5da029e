"""Whether a run of discs should find out the error of its own step: three ways to one accuracy of wall forces at rest.

A certificate holds a run against a cheaper one of the same filling, by Richardson's estimate from settings of a few times the
error that the front expects; where that is beyond what was asked, finer settings are taken.
"""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from silostudy.accuracy import fronts_dem
from silostudy.accuracy.certificates import WAYS, asked_at_random
from silostudy.accuracy.trial import Trial
from silostudy.choice.dem import scene_traits
from silostudy.choice.fronts import rows_for
from silostudy.config.dem import DemScene

LEVER = 8.0  # expected error of the run that another is held against, over that one's
MARGIN = {"certificate": 2.0, "front then certificate": 0.9}  # times Richardson's estimate: where 95 % keep what was asked
START = 3  # rung at which a certificate begins that knows nothing beforehand
ASKED = 8  # errors asked of each filling
LEAST = min(fronts_dem.STEPS)  # factor of the step: shorter ones cost more than all others together
ROWS = sorted(
    (row for row in rows_for(["dem"], ["wall_force"]) if row.given["march.step_factor"] >= LEAST), key=lambda row: -row.error
)


@dataclass(frozen=True)
class FillingTrial:
    """Forces, errors and the silo's CPU time (s) of a filling by rung, from coarse to fine; errors that the front expects."""

    force: list[np.ndarray]
    error: np.ndarray
    cost: np.ndarray
    expected: np.ndarray

    def by(self, way: str, asked: float) -> tuple[float, float]:
        """Error of the rung that a way ends with, and the CPU time (s) of all that it ran."""
        if way == "front":
            rung = self._of_front(asked)
            return self._done({rung}, rung)
        rung = self._of_front(asked) if way != "certificate" else START
        ran = {rung, *self._coarser(rung)[:1]}
        while rung + 1 < len(ROWS) and (likely := MARGIN[way] * self._estimate(rung, ran)) > asked:
            wanted = self.expected[rung] * asked / likely
            rung = next((k for k in range(rung + 1, len(ROWS)) if self.expected[k] <= wanted), len(ROWS) - 1)
            ran.add(rung)
        return self._done(ran, rung)

    def _done(self, ran: set[int], rung: int) -> tuple[float, float]:
        return float(self.error[rung]), float(self.cost[list(ran)].sum())

    def _of_front(self, asked: float) -> int:
        enough = [k for k in range(len(ROWS)) if self.expected[k] <= asked]
        return min(enough, key=lambda k: ROWS[k].cost) if enough else len(ROWS) - 1

    def _coarser(self, rung: int) -> list[int]:
        """Coarser rungs, the one that is best to hold a rung against first."""
        far = [k for k in range(rung) if self.expected[k] >= LEVER * self.expected[rung]]
        return [*reversed(far), *range(len(far), rung)]

    def _estimate(self, rung: int, ran: set[int]) -> float:
        """Richardson's estimate of a rung's error from the best of the coarser runs there are; the front's without any."""
        other = next((k for k in self._coarser(rung) if k in ran), None)
        if other is None:
            return float(self.expected[rung])
        ratio = self.expected[rung] / self.expected[other]
        apart = np.abs(self.force[rung] - self.force[other]).max() / self.force[rung].max()
        return float(apart * ratio / (1.0 - ratio))


def fillings_of(content: dict, fillings: int) -> list[FillingTrial]:
    """Some fillings of a silo, each with every rung."""
    expected = np.array([row.expected(scene_traits(DemScene.model_validate(content))) for row in ROWS])
    settings = [(row.given["march.integrator"], row.given["march.step_factor"]) for row in ROWS]
    forces, errors, costs = [], [], []
    for seed in range(fillings):
        right, _ = fronts_dem.forces(content, (fronts_dem.VERLET.key, fronts_dem.FINEST["trial"]), seed)
        ran = [fronts_dem.forces(content, setting, seed) for setting in settings]
        forces.append([force for force, _ in ran])
        errors.append(np.array([np.abs(force - right).max() / right.max() for force, _ in ran]))
        costs.append([seconds for _, seconds in ran])
    cost = np.median(costs, axis=0)
    return [FillingTrial(force, error, cost, expected) for force, error in zip(forces, errors, strict=True)]


def trials_of_step(tell: Callable[[str], None], silos: int, fillings: int) -> list[tuple[str, Trial]]:
    """Trials of each way on silos that the front was not measured on.

    The cheapest is the rung that 95 % of a silo's fillings ask for.
    """
    tried, random = [], np.random.default_rng(5)
    for number, content in enumerate(fronts_dem.silos(1, silos), 1):
        group = fillings_of(content, fillings)
        lasting = np.quantile([filling.error for filling in group], fronts_dem.SHARE, axis=0)
        for filling in group:
            for asked in asked_at_random(random, fronts_dem.ASKED, ASKED):
                least = min(filling.cost[lasting <= asked], default=np.nan)
                tried += [(way, Trial("dem", "wall_force", asked, *filling.by(way, asked), least)) for way in WAYS]
        tell(f"discs: silo {number} of {silos}")
    return tried
