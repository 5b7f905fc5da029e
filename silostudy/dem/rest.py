"""Rest of a scene: a family of measures that fall as it calms down, and the value below which each must come."""

from collections.abc import Callable
from dataclasses import dataclass
from typing import NamedTuple

import numpy as np

from silostudy.catalogue import Family, Row
from silostudy.dem.snapshot import length, pair_contacts, wall_contacts


class Look(NamedTuple):
    """Tick and places (m, by label) of all bodies at an earlier time."""

    step: int
    places: np.ndarray


@dataclass(frozen=True, kw_only=True)
class Criterion(Row):
    """Measure of rest. measure(engine, earlier look or None) -> a ratio (1); below: its bound unless a scene says otherwise."""

    measure: Callable
    below: float
    looks_back: bool = False  # whether it asks for the earlier look


def unbalanced_force(engine, earlier: Look | None = None) -> float:
    """Mean force that is left over on a body, its weight included, over the mean contact force (1)."""
    pairs, walls = pair_contacts(engine), wall_contacts(engine)
    number = np.empty(engine.most, int)
    number[engine.labels] = np.arange(engine.n)
    left = engine.mass[:, None] * np.asarray(engine.gravity)
    for bodies, sign, contacts in ((pairs.first, 1.0, pairs), (pairs.second, -1.0, pairs), (walls.first, 1.0, walls)):
        np.add.at(left, number[bodies], sign * contacts.force)
    strength = length(np.vstack([pairs.force, walls.force]))
    return float(length(left).mean() / strength.mean()) if strength.size else np.inf


def kinetic_over_potential(engine, earlier: Look | None = None) -> float:
    """Kinetic energy of all bodies over the energy that lifts each by its radius (1)."""
    mass, radius, space = engine.mass, engine.radius, engine.space
    moving = sum(engine.column(lane) ** 2 for lane in space.velocity)
    turning = sum((radius * engine.column(lane)) ** 2 for lane in space.spin) / space.inverse_inertia
    kinetic = 0.5 * mass * (moving + turning)
    lifted = np.hypot.reduce(engine.gravity) * (mass * radius).sum()
    return float(kinetic.sum() / lifted) if lifted > 0.0 else np.inf


def displacement(engine, earlier: Look | None = None) -> float:
    """Mean displacement in a step, the largest of all directions, over dt^2 g (1).

    Kiyama & Fujimura (1983), note 3.
    """
    ways = max(np.abs(engine.column(lane)).mean() for lane in engine.space.velocity)
    scale = engine.past_dt * float(np.hypot.reduce(engine.gravity))
    return float(ways / scale) if scale > 0.0 else np.inf


def drift(engine, earlier: Look | None) -> float:
    """Mean way of a body since an earlier look, over that of a fall from rest in this time (1).

    What changes its sign from step to step, as a constant torque against rolling does, leads nowhere and does not count.
    """
    if earlier is None:
        return np.inf
    ways = length(engine.places - earlier.places)
    there = np.isfinite(ways)
    fall = 0.5 * float(np.hypot.reduce(engine.gravity)) * ((engine.step - earlier.step) * engine.model.dt) ** 2
    return float(ways[there].mean()) / fall if there.any() and fall > 0.0 else np.inf


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
        Criterion(
            key="drift",
            title="Mean way of a body since the last look, over that of a fall from rest in this time",
            measure=drift,
            below=1e-3,
            looks_back=True,
            source="cundall_strack_1979",
            locator="none: a ratio of this package's own",
        ),
    ],
)


@dataclass(frozen=True)
class Rest:
    """A criterion and the value that it must come below."""

    criterion: Criterion = REST["displacement"]
    below: float = REST["displacement"].below

    def holds(self, engine, earlier: Look | None) -> bool:
        """Whether the engine's bodies are at rest; none are where none is left."""
        return engine.n > 0 and self.criterion.measure(engine, earlier) < self.below

    def __str__(self) -> str:
        return f"{self.criterion.key} below {self.below:g}"


USUAL = REST["unbalanced-force"]
STEADY = REST["drift"]  # where forces never balance, since a law changes its sign from step to step
PAPER = Rest()  # Kiyama & Fujimura's own
