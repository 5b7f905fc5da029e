"""The mean over as many fillings of a scene as the accuracy needs that is asked of it, with what the runs tell of its error.

One filling is computed, then one or a tenth more at a time until the scatter, by what is known of it, allows what was asked.
A few are computed at half the time step too: where the mean changes there by more than was asked, and by more than chance,
half the step is taken.
"""

import time
from collections.abc import Callable
from dataclasses import dataclass, field

import numpy as np

from silostudy.choice.means import enough, mean_bound
from silostudy.compute.scenes_windows import Numbers, Swept
from silostudy.config.grain_scenes import AnyScene
from silostudy.cube.certificates import SURE
from silostudy.errors import BadInput

PAIRED = 8  # fillings for one that is computed at half the step too
HALVINGS = 4  # of the step, at most

Compute = Callable[[AnyScene], Numbers]


@dataclass
class Fillings:
    """Numbers of the fillings of a scene, seed by seed, and the CPU time (s) they took."""

    scene: AnyScene
    compute: Compute
    numbers: list[Numbers] = field(default_factory=list)
    seconds: float = 0.0

    def take(self, count: int) -> None:
        """Computes fillings until there are so many."""
        began = time.thread_time()
        for filling in range(len(self.numbers), count):
            seeded = self.scene.model_copy(update={"seed": self.scene.seed + filling})
            self.numbers.append(self.compute(seeded))
        self.seconds += time.thread_time() - began

    def values(self, read: Callable[[Numbers], float]) -> np.ndarray:
        """A quantity of every filling."""
        return np.array([read(numbers) for numbers in self.numbers])


def mean_numbers(scene: AnyScene, compute: Compute, swept: Swept) -> Numbers:
    """Means of a case's numbers over its fillings, and the certificate of the accuracy that its scene asks for."""
    spent, halved = 0.0, Fillings(_halved(scene), compute)
    fillings = Fillings(scene, compute)
    for halving in range(HALVINGS + 1):
        _take_enough(fillings, swept)
        halved.take(round(len(fillings.numbers) / PAIRED))
        certificate = _certificate(fillings, halved, swept)
        if halving == HALVINGS or not _step_matters(certificate):
            break
        spent += fillings.seconds
        fillings, halved = halved, Fillings(_halved(halved.scene), compute)
    means = {name: np.mean([numbers[name] for numbers in fillings.numbers], axis=0) for name in fillings.numbers[0]}
    times = {
        "cpu_time": np.array(spent + fillings.seconds + halved.seconds),
        "cpu_time_on_step": np.array(spent + halved.seconds),
    }
    return means | certificate | times | {"fillings_computed": np.array(len(fillings.numbers))}


def _take_enough(fillings: Fillings, swept: Swept) -> None:
    """Computes fillings until each quantity's mean keeps what is asked of it, or there are too many."""
    fillings.take(1)
    while (count := max(enough(*asked) for asked in _asked(fillings, swept).values())) > len(fillings.numbers):
        fillings.take(count)


def _asked(fillings: Fillings, swept: Swept) -> dict[str, tuple[np.ndarray, float, float]]:
    """Values, error asked for and scatter expected of each quantity; BadInput where a run does not show it."""
    grains = int(fillings.numbers[0][swept.grains])
    asked = {}
    for name, error in fillings.scene.of_fillings.items():
        values = fillings.values(swept.asked[name].read)
        if not np.isfinite(values).all() or not values.mean():
            raise BadInput("accuracy", name, "is not seen in a filling: no event, window or flow of which it is")
        asked[name] = values, error, swept.asked[name].scatter / grains**0.5
    return asked


def _certificate(fillings: Fillings, halved: Fillings, swept: Swept) -> Numbers:
    """Error asked for and kept of each quantity's mean, and its change at half the step."""
    rows = []
    for name, (values, error, scatter) in _asked(fillings, swept).items():
        bound, mean, paired = mean_bound(values, scatter), values.mean(), halved.values(swept.asked[name].read)
        change = (paired - values[: len(paired)]).mean() / mean if len(paired) else np.nan
        deviation = np.sqrt(2.0 / len(paired)) * values.std(ddof=1) / abs(mean) if len(paired) else np.nan
        rows.append((error, bound, float(bound <= error), change, deviation))
    names = ("error_asked", "error_bound", "error_met", "step_change", "step_change_deviation")
    return dict(zip(names, np.array(rows).T, strict=True))


def _step_matters(certificate: Numbers) -> bool:
    """Whether a mean changes at half the step by more than was asked and by more than chance; it may change as much again."""
    beyond = 2.0 * (np.abs(certificate["step_change"]) - SURE * certificate["step_change_deviation"])
    return bool((beyond > certificate["error_asked"]).any())


def _halved(scene: AnyScene) -> AnyScene:
    """The scene at half its time step."""
    key = "step_factor" if scene.march.step_s is None else "step_s"
    march = scene.march.model_copy(update={key: 0.5 * getattr(scene.march, key)})
    return scene.model_copy(update={"march": march})
