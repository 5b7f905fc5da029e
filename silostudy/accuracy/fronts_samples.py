"""The front of a study's samples: the 95 % quantile of Janssen's wall pressure of solids that scatter more or less.

Reference: the distribution function by Gauss quadrature over friction and lateral ratio, exact in the unit weight.
"""

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

import numpy as np
from scipy.optimize import brentq

from silostudy.accuracy.certificates import asked_at_random
from silostudy.accuracy.trial import Trial, cpu_seconds, front_row
from silostudy.choice.choose import choose
from silostudy.choice.pressure import spread_number
from silostudy.compute.uncertainty import sequence
from silostudy.pressure import janssen
from silostudy.pressure.calls import call

POWERS = tuple(power / 2 for power in range(12, 33))  # each sample 1.41 times the one before
COUNTS = tuple(round(2**power) for power in POWERS)
MEASURED = 30  # solids
UNSEEN = 40  # other solids
SEEDS = 20  # sequences for each
SHARE = 0.95  # of sequences that must meet an error
KEPT = 0.9  # share of all errors measured, over solids and sequences, that a row keeps; a larger sample is chosen
ASKS = 10  # errors asked of each of the others
LEVELS = 25  # depths of the wall whose quantiles count, the worst of them
ABOVE = 0.1  # first of these depths over the last
ASKED = (1e-3, 0.05)
NODES, WEIGHTS = np.polynomial.legendre.leggauss(100)
SOURCE = "silo_handbook"


@dataclass(frozen=True)
class Solid:
    """A solid in a silo: its means, their spreads (upper over mean), and the least over the mean unit weight."""

    means: dict[str, float]
    depth: float  # m, of the wall's foot
    a_mu: float
    a_K: float
    lightest: float

    @property
    def scatter(self) -> float:
        """The trait that the error goes with."""
        return spread_number(1.0, self.a_K, self.a_mu, self.lightest)

    @property
    def depths(self) -> np.ndarray:
        """Depths (m) of the quantiles."""
        return np.linspace(ABOVE, 1.0, LEVELS) * self.depth

    def pressure(self, depth, friction, ratio, weight):
        """Janssen's wall pressure (Pa) where properties are so many times their means."""
        times = {"wall_friction": friction, "lateral_pressure_ratio": ratio, "unit_weight": weight}
        return call(janssen.normal_pressure, depth, self.means | {name: self.means[name] * by for name, by in times.items()})


def solids(seed: int, count: int, widest: float) -> Iterator[Solid]:
    """Solids with spreads up to the widest, in silos of many sizes; other seeds give others."""
    random = np.random.default_rng(seed)
    for _ in range(count):
        means = {"unit_weight": random.uniform(6e3, 16e3), "hydraulic_radius": random.uniform(0.5, 5.0),
                 "wall_friction": random.uniform(0.2, 0.6), "lateral_pressure_ratio": random.uniform(0.35, 0.6)}  # fmt: skip
        spreads = *random.uniform(1.05, widest, 2), random.uniform(1.0 / widest, 0.95)
        yield Solid(means, random.uniform(2.0, 40.0), *spreads)


def sampled(solid: Solid, count: int, seed: int) -> np.ndarray:
    """Pressures (Pa) as the uncertainty stage samples them: friction and ratio log-uniform, unit weight uniform."""
    points = sequence(3, count, seed)
    friction, ratio = (spread ** (2.0 * points[:, k] - 1.0) for k, spread in enumerate((solid.a_mu, solid.a_K)))
    weight = solid.lightest + (1.0 - solid.lightest) * points[:, 2]
    return solid.pressure(solid.depths[:, None], friction, ratio, weight)


def quantiles(pressures: np.ndarray, counts: Sequence[int]) -> np.ndarray:
    """Their quantiles (Pa) by so many of the samples: (count, depth)."""
    return np.array([np.quantile(pressures[:, :count], SHARE, axis=1) for count in counts])


def exact(solid: Solid) -> np.ndarray:
    """The quantiles (Pa): where the distribution function is the share asked for; the pressure is linear in the unit weight."""
    return np.array([_quantile(solid.pressure(z, *_nodes(solid), 1.0), solid.lightest) for z in solid.depths])


def _nodes(solid: Solid) -> tuple[np.ndarray, np.ndarray]:
    return (solid.a_mu**NODES)[:, None], (solid.a_K**NODES)[None, :]


def _quantile(heaviest: np.ndarray, lightest: float) -> float:
    """Quantile of the pressures (Pa) at the nodes with the largest unit weight."""
    weights = 0.5 * WEIGHTS

    def below(pressure):
        part = np.clip((pressure / heaviest - lightest) / (1.0 - lightest), 0.0, 1.0)
        return float(weights @ part @ weights)

    return brentq(lambda p: below(p) - SHARE, heaviest.min() * lightest, heaviest.max())


def errors(solid: Solid, first: int) -> np.ndarray:
    """Largest relative error over the depths with every sample size and sequence: (power, sequence)."""
    right = exact(solid)
    by_sequence = [quantiles(sampled(solid, COUNTS[-1], first + seed), COUNTS) for seed in range(SEEDS)]
    return np.abs(np.array(by_sequence) / right - 1.0).max(axis=-1).T


def costs(solid: Solid) -> np.ndarray:
    """CPU seconds of every sample size; a larger one never costs less, what says otherwise is noise."""
    spent = [cpu_seconds(lambda count=count: quantiles(sampled(solid, count, 1), [count])) for count in COUNTS]  # type: ignore[misc]
    return np.maximum.accumulate(spent)


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv: the error over the solid's scatter that all but a few sequences of all solids keep."""
    scattering = list(solids(0, MEASURED, 1.5))
    over = np.hstack([errors(solid, 1000) / solid.scatter for solid in scattering])
    lasting, cost = np.quantile(over, KEPT, axis=1), costs(scattering[0])
    tell(f"pressure_quantile: {MEASURED} solids, {SEEDS} sequences each")
    within = {"scatter": (0.0, float(f"{1.05 * max(solid.scatter for solid in scattering):.2g}"))}
    return [
        front_row("pressure", "pressure_quantile", {"uncertainty.log2_samples": power}, lasting[k], cost[k], MEASURED * SEEDS,
                  SOURCE, scaled_by="scatter", within=within)
        for k, power in enumerate(POWERS)
    ]  # fmt: skip


def trials(tell: Callable[[str], None], count: int = UNSEEN) -> list[Trial]:
    """Other solids and sequences; the cheapest is the smallest sample with which 19 of 20 sequences meet it."""
    tried, random = [], np.random.default_rng(2)
    spent = costs(next(iter(solids(0, 1, 1.5))))
    for solid in solids(1, count, 1.4):
        wrong = errors(solid, 2000)
        lasting = np.quantile(wrong, SHARE, axis=1)
        for asked in asked_at_random(random, ASKED, ASKS):
            chosen = choose(["pressure"], {"pressure_quantile": asked}, [{"scatter": solid.scatter}]).settings
            k, enough = POWERS.index(chosen["uncertainty.log2_samples"]), int(np.argmax(lasting <= asked))
            tried += [
                Trial("pressure", "pressure_quantile", asked, result, spent[k], spent[enough], COUNTS[k], COUNTS[enough])
                for result in wrong[k]
            ]
    tell(f"pressure_quantile: {sum(result.met for result in tried)} of {len(tried)} met")
    return tried
