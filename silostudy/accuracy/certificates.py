"""Three ways to keep an accuracy asked for, tried side by side on the same scenes: the front alone, a certificate, or both.

Front alone: settings by what was measured on other scenes.  Certificate: the runs find out their own error, from scratch.
Front then certificate: they begin with what the front expects.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass
from functools import partial

import numpy as np

from silostudy.accuracy.trial import Trial
from silostudy.choice.means import NORMAL, PRIOR, enough

WAYS = ("front", "certificate", "front then certificate")
START = 4  # fillings of a certificate that knows nothing beforehand
MADE = 4000  # scenes made up
SPREAD = 0.35  # standard deviation of the logarithm of their scatter over the expected one
SCATTER = (0.03, 0.2)  # relative scatter of a filling lies between
ASKED_OF_MADE = (0.01, 0.1)  # errors asked of made-up scenes lie between

Draw = Callable[[int], np.ndarray]  # count -> so many values


@dataclass(frozen=True)
class Scattered:
    """A mean that fillings scatter about: draws of them, its right value, the scatter expected and the one there is (1).

    prior: fillings that the one expected counts for; first: after which it is looked at for the first time.
    """

    kind: str
    quantity: str
    draw: Draw
    right: float
    expected: float
    scatter: float
    prior: int = PRIOR
    first: int = 1


def trials_of_means(scenes: Iterator[tuple[Scattered, float]]) -> list[tuple[str, Trial]]:
    """Trials of each way on scenes with the error asked of each; costs are numbers of fillings."""
    tried = []
    for scene, asked in scenes:
        least = max(1.0, np.ceil((NORMAL * scene.scatter / asked) ** 2))
        for way in WAYS:
            values = means_by(way, scene, asked)
            error = abs(values.mean() / scene.right - 1.0)
            tried.append((way, Trial(scene.kind, scene.quantity, asked, error, len(values), least, len(values), least)))
    return tried


def means_by(way: str, scene: Scattered, asked: float) -> np.ndarray:
    """The values that a way computes for an error asked for."""
    if way == "front":  # the scatter that 95 % of scenes keep
        widest = scene.expected * np.exp(1.645 * SPREAD)
        return scene.draw(max(1, int(np.ceil((NORMAL * widest / asked) ** 2))))
    start, prior = (START, 0) if way == "certificate" else (scene.first, scene.prior)
    values = scene.draw(start)
    while (count := enough(values, asked, scene.expected, prior)) > len(values):
        values = np.concatenate([values, scene.draw(count - len(values))])
    return values


def made_up(seed: int = 0, count: int = MADE) -> Iterator[tuple[Scattered, float]]:
    """Scenes whose fillings are normal about 1, each with the error asked of it."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        scatter, asked = (float(np.exp(random.uniform(*np.log(ends)))) for ends in (SCATTER, ASKED_OF_MADE))
        expected = scatter * float(np.exp(SPREAD * random.normal()))
        yield Scattered("made up", "mean", partial(_normal, random, scatter), 1.0, expected, scatter), asked


def asked_at_random(random: np.random.Generator, ends: tuple[float, float], count: int) -> list[float]:
    """Errors to ask for between two ends, even in their logarithms."""
    low, high = np.log(ends)
    return np.exp(random.uniform(low, high, count)).tolist()


def _normal(random: np.random.Generator, scatter: float, count: int) -> np.ndarray:
    return 1.0 + scatter * random.normal(size=count)
