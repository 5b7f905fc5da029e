"""When a scene counts as at rest: a family of measures that fall as it calms down, and the value each must come below."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from silostudy.catalogue import Family, Row
from silostudy.dem.lanes import U, V, W
from silostudy.dem.snapshot import pair_contacts, wall_contacts


@dataclass(frozen=True, kw_only=True)
class Criterion(Row):
    """measure(engine) -> a ratio (1); below: what it must come below unless a scene says otherwise."""

    measure: Callable
    below: float


def unbalanced_force(engine) -> float:
    """Mean force that is left over on a disc, its weight included, over the mean contact force (1)."""
    pairs, walls = pair_contacts(engine), wall_contacts(engine)
    number = np.empty(engine.most, int)
    number[engine.labels] = np.arange(engine.n)
    left = engine.mass[:, None] * np.asarray(engine.gravity)
    for bodies, sign, contacts in ((pairs.first, 1.0, pairs), (pairs.second, -1.0, pairs), (walls.first, 1.0, walls)):
        np.add.at(left, number[bodies], sign * np.c_[contacts.fx, contacts.fy])
    strength = np.hypot(np.r_[pairs.fx, walls.fx], np.r_[pairs.fy, walls.fy])
    return float(np.hypot(*left.T).mean() / strength.mean()) if strength.size else np.inf


def kinetic_over_potential(engine) -> float:
    """Kinetic energy of all discs over the energy that lifts each by its radius (1)."""
    mass, radius = engine.mass, engine.radius
    u, v, w = (engine.column(lane) for lane in (U, V, W))
    kinetic = 0.5 * mass * (u * u + v * v + 0.5 * (radius * w) ** 2)
    lifted = np.hypot(*engine.gravity) * (mass * radius).sum()
    return float(kinetic.sum() / lifted) if lifted > 0.0 else np.inf


def displacement(engine) -> float:
    """Mean displacement in a step, the larger of both directions, over dt^2 g (1).

    Kiyama & Fujimura (1983), note 3.
    """
    ways = max(np.abs(engine.column(lane)).mean() for lane in (U, V))
    scale = engine.model.dt * float(np.hypot(*engine.gravity))
    return float(ways / scale) if scale > 0.0 else np.inf


REST: Family[Criterion] = Family(
    "criterion of rest",
    [
        Criterion(
            key="unbalanced-force",
            title="Mean force left over on a disc over mean contact force",
            measure=unbalanced_force,
            below=1e-4,
            source="cundall_strack_1979",
            locator="none: a ratio in general use",
        ),
        Criterion(
            key="kinetic-over-potential",
            title="Kinetic energy over the energy that lifts every disc by its radius",
            measure=kinetic_over_potential,
            below=1e-8,
            source="cundall_strack_1979",
            locator="none: a ratio in general use",
        ),
        Criterion(
            key="displacement",
            title="Mean displacement of a step over dt^2 g; discs that lie loose keep it up",
            measure=displacement,
            below=1e-8,
            source="kiyama_fujimura_1983",
            locator="note 3",
        ),
    ],
)


@dataclass(frozen=True)
class Rest:
    """A criterion and the value that it must come below."""

    criterion: Criterion = REST["displacement"]
    below: float = REST["displacement"].below

    def holds(self, engine) -> bool:
        """Whether the engine's discs are at rest; none are where none is left."""
        return engine.n > 0 and self.criterion.measure(engine) < self.below

    def __str__(self) -> str:
        return f"{self.criterion.key} below {self.below:g}"


PAPER = Rest()  # Kiyama & Fujimura's own
