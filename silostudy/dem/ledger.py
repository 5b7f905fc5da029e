"""The energy balance: where the energy of a scene is, and where it went, booked contact by contact at every step.

Kinetic + potential + elastic + dashpots + sliding + carried out
= start + worked in by the base + by changes of gravity + by walls that move + created by the step.
Sliding is the work of friction at contacts that slip, what springs held when their contact opened, and what a spring gives or
takes whose stiffness changes under its force (Mindlin's follows the overlap); a dashpot of a
contact that slips is part of that friction, and only where the contact sticks is its loss the dashpots'.
Carried out is what discs that are gone had, and the springs of contacts with a disc or a wall that was taken away.
`created` is what the finite step itself adds or takes (work of the elastic forces over a step less the energy they
lose); it is booked from its own definition, so the balance is a check of every force, torque and move.
"""

import numpy as np
from numba.extending import register_jitable

from silostudy.contact.vector import less, product
from silostudy.dem import history
from silostudy.dem.arrays import Ledger, aligned

ENTRIES = ("kinetic", "potential", "elastic", "dashpot", "sliding", "carried_out", "base", "gravity", "created", "walls")
KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT, BASE, GRAVITY, CREATED, WALLS = range(len(ENTRIES))
WORK, BRAKING, RUBBING, SHAKING, DRIVING, BEGUN, TURNOVER = range(len(ENTRIES), len(ENTRIES) + 7)


def empty(space, rows: int, room: int, wall_room: int) -> Ledger:
    """An energy balance for this many rows and contacts, all zero; no room at all where the scene asks for none."""
    asked = room > 0
    return Ledger(
        account=np.zeros(TURNOVER + 1),
        mean=aligned(rows, space.row),
        lanes=aligned(space.lanes[0], space.lanes[1] * asked),
        pair_stored=history.histories(room, space.components),
        pair_rolled=history.histories(room, space.components),
        pair_twisted=np.zeros(room),
        pair_touched=np.zeros(room),
        wall_stored=history.histories(wall_room, space.components),
        wall_rolled=history.histories(wall_room, space.components),
        wall_twisted=np.zeros(wall_room),
        wall_touched=np.zeros(wall_room),
    )


def balance(account: np.ndarray) -> float:
    """Sum (J/m) that stays what it was at the start."""
    held = account[[KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT]].sum()
    return float(held - account[[BASE, GRAVITY, CREATED, WALLS]].sum())


def carry_in(engine, come: np.ndarray) -> None:
    """Book the kinetic and potential energy that bodies bring with them; `come` marks them among those that are there."""
    carry_out(engine, come, -1.0)


def carry_out(engine, gone: np.ndarray, sign: float = 1.0) -> None:
    """Book the kinetic and potential energy that bodies take with them; `gone` marks them among those left."""
    account, rows, mass, space = engine.ledger.account, engine.bodies.rows[: engine.n][gone], engine.mass[gone], engine.space
    lanes = (*space.velocity, *space.spin)
    speed = engine.bodies.held[: engine.n][gone, : len(lanes)] if len(engine.bodies.held) else rows[:, lanes]
    moving, turning = (sum(part.T**2) for part in np.split(speed, [space.ways], axis=1))
    inertia = mass * engine.radius[gone] ** 2 / space.inverse_inertia
    kinetic = float((0.5 * mass * moving + 0.5 * inertia * turning).sum())
    potential = -float((mass * (rows[:, space.place] @ np.asarray(engine.gravity))).sum())
    account[CARRIED_OUT] += sign * (kinetic + potential)
    account[POTENTIAL] -= sign * potential
    account[KINETIC] -= sign * kinetic


def take_springs(engine, energy: float) -> None:
    """Book the elastic energy (J/m) of contacts with a body that is taken away."""
    engine.ledger.account[CARRIED_OUT] += energy
    engine.ledger.account[ELASTIC] -= energy


def change_gravity(engine, gravity: tuple[float, ...]) -> None:
    """Book what another gravity (m/s2) adds to the potential energy of bodies where they are."""
    change = np.subtract(gravity, engine.gravity)
    work = -float((engine.mass * (engine.bodies.rows[: engine.n, engine.space.place] @ change)).sum())
    engine.ledger.account[[POTENTIAL, GRAVITY]] += work


@register_jitable
def of_spring(force, stiffness):
    """Energy (J/m) of a spring that holds a force."""
    return 0.5 * product(force, force) / stiffness if stiffness > 0.0 else 0.0


@register_jitable
def of_slip(old, trial, held, stiffness):
    """Energy (J/m) that slip takes from a spring that held `old`, would have held `trial` and holds `held`.

    It is the mean force over the slip: where a dashpot under the same cap loads or frees the spring at a stroke, as at Hertz's
    first and last touch, that is what the spring gains and loses, however short the step.
    """
    if not stiffness > 0.0:
        return 0.0
    return 0.5 * product(less(old, -1.0, held), less(trial, 1.0, held)) / stiffness
