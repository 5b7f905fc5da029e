"""The energy ledger: where the energy of a scene is, and where it went, booked contact by contact at every step.

Kinetic + potential + elastic + dashpots + sliding + carried out
= start + worked in by the base + by changes of gravity + created by the step.
Sliding is the work of friction at contacts that slip, what springs held when their contact opened, and what a spring gives or
takes whose stiffness changes under its force (Mindlin's follows the overlap); a dashpot of a
contact that slips is part of that friction, and only where the contact sticks is its loss the dashpots'.
Carried out is what discs that are gone had, and the springs of contacts with a disc or a wall that was taken away.
`created` is what the finite step itself adds or takes (work of the elastic forces over a step less the energy they
lose); it is booked from its own definition, so the balance is a check of every force, torque and move.
"""

import numpy as np
from numba.extending import register_jitable

from silostudy.contact.family import Touch
from silostudy.contact.vector import less
from silostudy.dem import history
from silostudy.dem.arrays import Ledger, aligned
from silostudy.dem.cache import piece
from silostudy.dem.dimension import Dimension
from silostudy.dem.force import gather_pass, response
from silostudy.dem.history import differs, dot, histories, size
from silostudy.dem.integrate import INTEGRATORS

ENTRIES = ("kinetic", "potential", "elastic", "dashpot", "sliding", "carried_out", "base", "gravity", "created")
KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT, BASE, GRAVITY, CREATED = range(len(ENTRIES))
WORK, BRAKING, RUBBING, SHAKING, BEGUN, TURNOVER = range(len(ENTRIES), len(ENTRIES) + 6)
NO_LIMIT = 1e200  # N/m: a normal force under which nothing slips


def empty(space: Dimension, rows: np.ndarray, room: int, wall_room: int) -> Ledger:
    """A ledger for this many contacts, nothing booked; no room at all where the scene asks for none."""
    asked = room > 0
    return Ledger(
        account=np.zeros(TURNOVER + 1),
        mean=aligned(len(rows) if asked else 0, space.row),
        lanes=aligned(space.lanes[0], space.lanes[1] if asked else 0),
        pair_stored=histories(room, space.components),
        pair_rolled=histories(room, space.components),
        wall_stored=histories(wall_room, space.components),
        wall_rolled=histories(wall_room, space.components),
    )


def balance(account: np.ndarray) -> float:
    """Sum (J/m) that stays what it was at the start."""
    held = account[[KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT]].sum()
    return float(held - account[[BASE, GRAVITY, CREATED]].sum())


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
def keep_histories(contacts, count, stored, rolled):
    """Copy the histories before the forces change them."""
    for k in range(count):
        history.enter(stored, k, history.entry(contacts.stored, k))
        history.enter(rolled, k, history.entry(contacts.rolled, k))


@register_jitable
def of_spring(force, stiffness):
    """Energy (J/m) of a spring that holds a force."""
    return 0.5 * dot(force, force) / stiffness if stiffness > 0.0 else 0.0


@register_jitable
def of_slip(trial, held, stiffness):
    """Energy (J/m) that slip takes from a spring that would have held `trial` and holds `held`."""
    if not stiffness > 0.0:
        return 0.0
    if dot(held, trial) >= 0.0 and size(held) <= size(trial):
        return dot(held, less(trial, 1.0, held)) / stiffness  # the force that is left, over the slip
    return 0.5 * (dot(trial, trial) - dot(held, held)) / stiffness  # a spring that a cap on the sum has loaded at a stroke


def contact_book(space, laws, *, unequal, flat):
    """Function that gives, of the contacts of a list: elastic energy, loss of springs that slid, power of the elastic
    forces, and power that dashpots take where contacts stick and where they slip."""
    gathered = gather_pass(space, laws, unequal=unequal, flat=flat)
    facing, rates, answer = space.facing, space.rates(unequal), response(laws)
    reduced, carry = space.reduced(flat), space.carry
    slide_stiffness, roll_stiffness, attraction = laws.tangential.stiffness, laws.rolling.stiffness, laws.cohesion.energy
    stretch = space.stretch
    energy, slides, rolls, tangential_law = laws.normal.energy, laws.slides, laws.rolls, laws.tangential.law

    @piece(space, laws, unequal, flat)
    def book(rows, ledger, contacts, shape, count, old_stored, old_rolled, dt, c, lanes):
        elastic_energy = slid = elastic_power = braking = rubbing = 0.0
        a, b, m = contacts.arm[0], contacts.other[0], contacts.mass[0]
        for start in range(0, count, stretch):
            many = min(stretch, count - start)
            gathered(rows, contacts, shape, start, many, lanes)
            gathered(ledger.mean, contacts, shape, start, many, ledger.lanes)
            for k in range(many):
                at = start + k
                if unequal:
                    a, b, m = contacts.arm[at], contacts.other[at], contacts.mass[at]
                normal, distance = facing(lanes, k)
                overlap = a + b - distance
                depth = overlap if overlap > 0.0 else 0.0
                stored, turned = carry(history.entry(old_stored, at), normal), carry(history.entry(old_rolled, at), normal)
                closing, sliding, rolling = rates(lanes, k, normal, a, b, depth, flat)
                radius, before = reduced(lanes, k, a, b), overlap - closing * dt
                touch = Touch(m, radius, dt, depth, closing, before)
                before = max(before, 0.0)
                last = Touch(m, radius, dt, before, closing, before)
                slide_last, roll_last = slide_stiffness(before, last, c[1]), roll_stiffness(before, last, c[2])
                if overlap <= 0.0:  # what springs held when the contact opened is lost
                    slid += of_spring(stored, slide_last) if slides else 0.0
                    slid += of_spring(turned, roll_last) if rolls else 0.0
                    continue
                slide_spring, roll_spring = slide_stiffness(depth, touch, c[1]), roll_stiffness(depth, touch, c[2])
                elastic, push, pull, (held, drag), (rolled, moment), _ = answer(
                    sliding, rolling, 0.0, stored, turned, 0.0, touch, c
                )
                elastic_energy += energy(overlap, touch, c[0]) + attraction(touch, c[3])
                if slides:
                    elastic_energy += of_spring(held, slide_spring)
                    slid += of_slip(less(stored, slide_spring * dt, sliding), held, slide_spring)
                    slid += of_spring(stored, slide_last) - of_spring(stored, slide_spring)
                if rolls:
                    elastic_energy += of_spring(rolled, roll_spring)
                    slid += of_slip(less(turned, roll_spring * dt, rolling), rolled, roll_spring)
                    slid += of_spring(turned, roll_last) - of_spring(turned, roll_spring)
                nearing, along, turning = rates(ledger.lanes, k, normal, a, b, depth, flat)  # on average over the step
                elastic_power += (pull - elastic) * nearing + dot(held, along)
                braking += (push - elastic) * nearing
                elastic_power += dot(rolled, turning)
                braking -= dot(less(moment, 1.0, rolled), turning)
                lost = dot(less(held, 1.0, drag), along)
                _, unlimited = tangential_law(stored, sliding, touch, NO_LIMIT, NO_LIMIT, c[1])
                if differs(drag, unlimited) or (
                    history.holds(held) and not history.holds(drag)
                ):  # a coefficient of zero slips at any force
                    rubbing += lost
                else:
                    braking += lost
        return elastic_energy, slid, elastic_power, braking, rubbing

    return book


def book_pass(pieces):
    """Function that books a step, after its forces and before its moves."""
    of_pairs = contact_book(pieces.space, pieces.pair_laws, unequal=pieces.unequal, flat=False)
    of_walls = contact_book(pieces.space, pieces.wall_laws, unequal=pieces.unequal, flat=True)
    bodies_book = pieces.space.book_bodies(INTEGRATORS[pieces.integrator].holds, pieces.unequal, pieces.integrator)

    @piece(pieces)
    def book(shared, share, march, last, pull, kick):
        ledger, shape, lanes = shared.ledger, shared.walls.shape, share.scratch.lanes
        account, rows, pairs, near = ledger.account, shared.bodies.rows, share.pairs, share.near
        kinetic, potential, falling, shaking = bodies_book(shared.bodies, ledger.mean, share.hi, pull, march.gravity, kick)
        pair = of_pairs(
            rows, ledger, pairs, shape, pairs.begin[last], ledger.pair_stored, ledger.pair_rolled,
            march.dt, march.pair_coefficients, lanes,
        )  # fmt: skip
        wall = of_walls(
            rows, ledger, near, shape, near.begin[0], ledger.wall_stored, ledger.wall_rolled,
            march.dt, march.wall_coefficients, lanes,
        )  # fmt: skip
        elastic, slid = pair[0] + wall[0], pair[1] + wall[1]
        if account[BEGUN] > 0.0:
            account[CREATED] += account[WORK] + potential - account[POTENTIAL] + elastic - account[ELASTIC] + slid
            account[SLIDING] += slid
            account[DASHPOT] += account[BRAKING]
            account[SLIDING] += account[RUBBING]
            account[BASE] += account[SHAKING]
            account[TURNOVER] += abs(kinetic - account[KINETIC]) + abs(potential - account[POTENTIAL])
        account[KINETIC], account[POTENTIAL], account[ELASTIC] = kinetic, potential, elastic
        account[WORK] = falling + (pair[2] + wall[2]) * kick  # what the forces will do while the discs move
        account[BRAKING] = (pair[3] + wall[3]) * kick
        account[RUBBING] = (pair[4] + wall[4]) * kick
        account[SHAKING] = shaking
        account[BEGUN] = 1.0

    return book
