"""When a scene counts as at rest: a family of measures that fall as it calms down, and the value each must come below."""

from collections.abc import Callable
from dataclasses import dataclass

import numpy as np

from silostudy.catalogue import Family, Row
from silostudy.dem.snapshot import length, pair_contacts, wall_contacts


@dataclass(frozen=True, kw_only=True)
class Criterion(Row):
    """measure(engine) -> a ratio (1); below: what it must come below unless a scene says otherwise."""

    measure: Callable
    below: float


def unbalanced_force(engine) -> float:
    """Mean force that is left over on a body, its weight included, over the mean contact force (1)."""
    pairs, walls = pair_contacts(engine), wall_contacts(engine)
    number = np.empty(engine.most, int)
    number[engine.labels] = np.arange(engine.n)
    left = engine.mass[:, None] * np.asarray(engine.gravity)
    for bodies, sign, contacts in ((pairs.first, 1.0, pairs), (pairs.second, -1.0, pairs), (walls.first, 1.0, walls)):
        np.add.at(left, number[bodies], sign * contacts.force)
    strength = length(np.vstack([pairs.force, walls.force]))
    return float(length(left).mean() / strength.mean()) if strength.size else np.inf


def kinetic_over_potential(engine) -> float:
    """Kinetic energy of all bodies over the energy that lifts each by its radius (1)."""
    mass, radius, space = engine.mass, engine.radius, engine.space
    moving = sum(engine.column(lane) ** 2 for lane in space.velocity)
    turning = sum((radius * engine.column(lane)) ** 2 for lane in space.spin) / space.inverse_inertia
    kinetic = 0.5 * mass * (moving + turning)
    lifted = np.hypot.reduce(engine.gravity) * (mass * radius).sum()
    return float(kinetic.sum() / lifted) if lifted > 0.0 else np.inf


def displacement(engine) -> float:
    """Mean displacement in a step, the largest of all directions, over dt^2 g (1).

    Kiyama & Fujimura (1983), note 3.
    """
    ways = max(np.abs(engine.column(lane)).mean() for lane in engine.space.velocity)
    scale = engine.model.dt * float(np.hypot.reduce(engine.gravity))
    return float(ways / scale) if scale > 0.0 else np.inf


REST: Family[Criterion] = Family(
    "criterion of rest",
    [
        Criterion(
            key="unbalanced-force",
            title="Mean force left over on a body over mean contact force",
            measure=unbalanced_force,
            below=1e-4,
            source="cundall_strack_1979",
            locator="none: a ratio in general use",
        ),
        Criterion(
            key="kinetic-over-potential",
            title="Kinetic energy over the energy that lifts every body by its radius",
            measure=kinetic_over_potential,
            below=1e-8,
            source="cundall_strack_1979",
            locator="none: a ratio in general use",
        ),
        Criterion(
            key="displacement",
            title="Mean displacement of a step over dt^2 g; bodies that lie loose keep it up",
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
        """Whether the engine's bodies are at rest; none are where none is left."""
        return engine.n > 0 and self.criterion.measure(engine) < self.below

    def __str__(self) -> str:
        return f"{self.criterion.key} below {self.below:g}"


PAPER = Rest()  # Kiyama & Fujimura's own
