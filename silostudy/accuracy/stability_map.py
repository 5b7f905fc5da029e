"""The largest stable time step of discs at rest, found by bisection; of this engine and of LAMMPS on the same discs.

A step is stable where discs at rest calm down, and a small kick does not grow.
"""

from collections.abc import Callable
from dataclasses import dataclass, replace
from math import sqrt
from typing import Protocol

import numpy as np

from silostudy.accuracy.peers import Lammps
from silostudy.dem.arrays import Memory
from silostudy.dem.engine import Engine
from silostudy.dem.explosion import Explosion
from silostudy.dem.integrate import PLAIN
from silostudy.dem.lanes import U, V, W
from silostudy.dem.model import Contact, Model
from silostudy.dem.stability import SAFETY, longest_step
from silostudy.scene.plane_silo import inner_width

SETTLING = 100_000  # steps in which discs that all but rest come to rest
KICK = 1e-5  # m/s: far below what opens a contact
GROWTH = 100.0  # of the kick's energy: beyond it the step counts as unstable
LOOKS = 10
FARTHEST = 64.0  # of the engine's bound: where the search gives up


class Body(Protocol):
    """Discs in motion, of either code; `motion` (n, 3) are u, v (m/s) and spin times radius (m/s)."""

    def step(self, steps: int) -> None: ...

    @property
    def motion(self) -> np.ndarray: ...

    def kick(self, by: np.ndarray) -> None: ...

    def close(self) -> None: ...


class Ours:
    """The engine, started from rest."""

    def __init__(self, model: Model, rest: "DiscsAtRest"):
        self.engine = Engine(model)
        self.engine.bodies.rows[: self.engine.n] = rest.rows
        self.engine.bodies.held[:, :3] = rest.rows[: len(self.engine.bodies.held), [U, V, W]]
        self.engine.give_memories(*rest.memories)

    def step(self, steps: int) -> None:
        self.engine.step_to(self.engine.step + steps)

    @property
    def motion(self) -> np.ndarray:
        return self.engine.bodies.rows[: self.engine.n, [U, V, W]] * [1.0, 1.0, self.engine.radius[0]]

    def kick(self, by: np.ndarray) -> None:
        change = by / [1.0, 1.0, self.engine.radius[0]]
        self.engine.bodies.rows[: self.engine.n, [U, V, W]] += change
        self.engine.bodies.held[:, :3] += change[: len(self.engine.bodies.held)]

    def close(self) -> None:
        """Nothing to free."""


class Peer:
    """LAMMPS on the discs where they rest; what histories they had builds up again at a short step."""

    def __init__(self, model: Model, rest: "DiscsAtRest", short: float, settling: int):
        self.count, self.radius = len(rest.places), float(model.radius[0])
        self.code = Lammps(replace(model, dt=short), rest.places, 0.0)
        self.code.step(settling)
        self.code.lammps.command(f"timestep {model.dt}")

    def step(self, steps: int) -> None:
        self.code.step(steps)
        if self.code.grains < self.count:
            raise Explosion(0, steps, 1.0, "LAMMPS lost a disc")

    def _columns(self) -> tuple[np.ndarray, np.ndarray]:
        of = self.code.lammps.numpy.extract_atom
        order = np.argsort(of("id")[: self.count])
        return of("v")[order], of("omega")[order]

    @property
    def motion(self) -> np.ndarray:
        speed, spin = self._columns()
        return np.c_[speed[:, :2], spin[:, 2] * self.radius]

    def kick(self, by: np.ndarray) -> None:
        ids = self.code.lammps.numpy.extract_atom("id")[: self.count] - 1
        self.code.lammps.numpy.extract_atom("v")[: self.count, :2] += by[ids, :2]
        self.code.lammps.numpy.extract_atom("omega")[: self.count, 2] += by[ids, 2] / self.radius

    def close(self) -> None:
        self.code.close()


@dataclass(frozen=True)
class DiscsAtRest:
    """Discs at rest: rows and histories in the engine's own order, places (m) by label."""

    rows: np.ndarray
    memories: tuple[Memory, Memory]
    places: np.ndarray


def settled(calm: Model) -> DiscsAtRest:
    """A model come to rest, at a safe step."""
    engine = Engine(replace(calm, dt=SAFETY * longest_step(calm)))
    engine.step_to(SETTLING)
    return DiscsAtRest(engine.bodies.rows[: engine.n].copy(), engine.take_memories(), engine.places)


def contact_number(places: np.ndarray, model: Model) -> float:
    """Mean number of contacts (1) of a disc: with discs and with walls."""
    away = np.hypot(*(places[:, None] - places[None]).transpose(2, 0, 1))
    with_discs = (away < 2.0 * model.radius[0]).sum() - len(places)
    x, y, radius, width = *places.T, model.radius[0], inner_width(model)
    return float((with_discs + (y < radius).sum() + (x < radius).sum() + (x > width - radius).sum()) / len(places))


def stays(make: Callable[[], Body], kick: np.ndarray, steps: int) -> bool:
    """Whether the energy of a kick (n, 3) in m/s does not grow, after time to calm down."""
    body = make()
    try:
        body.step(steps)
        body.kick(kick)
        for _ in range(LOOKS):
            body.step(steps // LOOKS)
            if not (body.motion**2).sum() < GROWTH * (kick**2).sum():
                return False
    except Explosion:
        return False
    finally:
        body.close()
    return True


def kick_of(count: int, upright: bool) -> np.ndarray:
    """A small random kick (n, 3) in m/s; of discs that nothing holds upright, up and down only."""
    random = KICK * np.random.default_rng(0).standard_normal((count, 3))
    return random * [0.0, 1.0, 0.0] if upright else random


def largest_step(stable: Callable[[float], bool], guess: float, resolution: float) -> float:
    """Largest step (s) that is stable, within a ratio of 1 + resolution; NaN where none is found near the guess."""
    factor = 2.0 if stable(guess) else 0.5
    edge = guess
    while 1.0 / FARTHEST < edge / guess < FARTHEST and stable(edge * factor) == (factor > 1.0):
        edge *= factor
    if not 1.0 / FARTHEST < edge / guess < FARTHEST:
        return float("nan")
    short, long = sorted((edge, edge * factor))
    while long > short * (1.0 + resolution):
        middle = sqrt(short * long)
        short, long = (middle, long) if stable(middle) else (short, middle)
    return short


def our_step(model: Model, rest: DiscsAtRest, kick: np.ndarray, steps: int, resolution: float) -> tuple[float, float]:
    """Largest stable step (s) of a model by bisection, and the engine's bound (s) for it where it rests."""
    x, y = rest.places.T
    bound = longest_step(replace(model, x=x, y=y))

    def stable(dt: float) -> bool:
        return stays(lambda: Ours(replace(model, dt=dt), rest), kick, steps)

    return largest_step(stable, bound, resolution), bound


def peer_step(calm: Model, model: Model, rest: DiscsAtRest, kick: np.ndarray, steps: int, resolution: float) -> float:
    """Largest stable step (s) of LAMMPS on the discs of a model, whose integrator and dashpots are its own."""
    explicit = replace(model, integrator=PLAIN.key, pair_contact=_with_laws(model, calm), wall_contact=_with_laws(model, calm))
    x, y = rest.places.T
    bound = longest_step(replace(explicit, x=x, y=y))

    def stable(dt: float) -> bool:
        return stays(lambda: Peer(replace(explicit, dt=dt), rest, SAFETY * bound, steps), kick, steps)

    return largest_step(stable, bound, resolution)


def _with_laws(model: Model, calm: Model) -> Contact:
    return replace(model.between(0, 0), laws=calm.pair_contact.laws)
