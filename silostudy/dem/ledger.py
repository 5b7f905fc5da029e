"""The energy ledger: where the energy of a scene is, and where it went, booked contact by contact at every step.

Kinetic + potential + elastic + dashpots + sliding + carried out
= start + worked in by the base + by changes of gravity + created by the step.
Sliding is the work of friction at contacts that slip, and what springs held when their contact opened; a dashpot of a
contact that slips is part of that friction, and only where the contact sticks is its loss the dashpots'.
Carried out is what discs that are gone had, and the springs of contacts with a disc or a wall that was taken away.
`created` is what the finite step itself adds or takes (work of the elastic forces over a step less the energy they
lose); it is booked from its own definition, so the balance is a check of every force, torque and move.
"""

import numpy as np
from numba.extending import register_jitable

from silostudy.contact.family import Touch
from silostudy.dem.arrays import Ledger, aligned
from silostudy.dem.cache import piece
from silostudy.dem.force import gather_pass, response
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.lanes import FX, FY, STRETCH, TORQUE, U, V, W, X, Y

ENTRIES = ("kinetic", "potential", "elastic", "dashpot", "sliding", "carried_out", "base", "gravity", "created")
KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT, BASE, GRAVITY, CREATED = range(len(ENTRIES))
WORK, BRAKING, RUBBING, SHAKING, BEGUN, TURNOVER = range(len(ENTRIES), len(ENTRIES) + 6)
NO_LIMIT = 1e200  # N/m: a normal force under which nothing slips


def empty(rows: np.ndarray, room: int, wall_room: int) -> Ledger:
    """A ledger for this many contacts, nothing booked; no room at all where the scene asks for none."""
    asked = room > 0
    return Ledger(
        account=np.zeros(TURNOVER + 1),
        mean=aligned(*(rows.shape if asked else (0, 8))),
        lanes=aligned(6, STRETCH if asked else 0),
        pair_stored=np.zeros(room),
        pair_rolled=np.zeros(room),
        wall_stored=np.zeros(wall_room),
        wall_rolled=np.zeros(wall_room),
    )


def balance(account: np.ndarray) -> float:
    """Sum (J/m) that stays what it was at the start."""
    held = account[[KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT]].sum()
    return float(held - account[[BASE, GRAVITY, CREATED]].sum())


def carry_out(engine, gone: np.ndarray) -> None:
    """Book the kinetic and potential energy that bodies take with them; `gone` marks them among those left."""
    account, rows, mass, space = engine.ledger.account, engine.bodies.rows[: engine.n][gone], engine.mass[gone], engine.space
    lanes = (*space.velocity, *space.spin)
    speed = engine.bodies.held[: engine.n][gone, : len(lanes)] if len(engine.bodies.held) else rows[:, lanes]
    moving, turning = (sum(part.T**2) for part in np.split(speed, [space.ways], axis=1))
    inertia = mass * engine.radius[gone] ** 2 / space.inverse_inertia
    kinetic = float((0.5 * mass * moving + 0.5 * inertia * turning).sum())
    potential = -float((mass * (rows[:, space.place] @ np.asarray(engine.gravity))).sum())
    account[CARRIED_OUT] += kinetic + potential
    account[POTENTIAL] -= potential
    account[KINETIC] -= kinetic


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
        stored[k] = contacts.stored[k] if contacts.stored.size else 0.0
        rolled[k] = contacts.rolled[k] if contacts.rolled.size else 0.0


@register_jitable
def of_spring(force, stiffness):
    """Energy (J/m) of a spring that holds a force."""
    return 0.5 * force * force / stiffness if stiffness > 0.0 else 0.0


@register_jitable
def of_slip(trial, held, stiffness):
    """Energy (J/m) that slip takes from a spring that would have held `trial` and holds `held`."""
    if not stiffness > 0.0:
        return 0.0
    if held * trial >= 0.0 and abs(held) <= abs(trial):
        return held * (trial - held) / stiffness  # the force that is left, over the slip
    return 0.5 * (trial * trial - held * held) / stiffness  # a spring that a cap on the sum has loaded at a stroke


def contact_book(space, laws, *, unequal, flat):
    """Function that gives, of the contacts of a list: elastic energy, loss of springs that slid, power of the elastic
    forces, and power that dashpots take where contacts stick and where they slip."""
    gathered = gather_pass(space, laws, unequal=unequal, flat=flat)
    facing, rates, answer = space.facing, space.rates(unequal), response(laws)
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
                overlap, stored, turned = a + b - distance, old_stored[at], old_rolled[at]
                closing, sliding, rolling = rates(lanes, k, normal, a, b, overlap, flat)
                touch = Touch(m, a if flat else a * b / (a + b), dt, overlap, closing, overlap - closing * dt)
                slide_spring, roll_spring = slide_stiffness(overlap, touch, c[1]), roll_stiffness(overlap, touch, c[2])
                if overlap <= 0.0:  # what springs held when the contact opened is lost
                    slid += of_spring(stored, slide_spring) if slides else 0.0
                    slid += of_spring(turned, roll_spring) if rolls else 0.0
                    continue
                elastic, push, pull, (held, drag), (rolled, moment), _ = answer(
                    sliding, rolling, 0.0, stored, turned, 0.0, touch, c
                )
                elastic_energy += energy(overlap, touch, c[0]) + attraction(touch, c[3])
                if slides:
                    elastic_energy += of_spring(held, slide_spring)
                    slid += of_slip(stored - slide_spring * dt * sliding, held, slide_spring)
                if rolls:
                    elastic_energy += of_spring(rolled, roll_spring)
                    slid += of_slip(turned - roll_spring * dt * rolling, rolled, roll_spring)
                nearing, along, turning = rates(ledger.lanes, k, normal, a, b, overlap, flat)  # on average over the step
                elastic_power += (pull - elastic) * nearing + held * along
                braking += (push - elastic) * nearing
                elastic_power += rolled * turning
                braking -= (moment - rolled) * turning
                lost = (held - drag) * along
                _, unlimited = tangential_law(stored, sliding, touch, NO_LIMIT, NO_LIMIT, c[1])
                if drag != unlimited or (drag == 0.0 and held != 0.0):  # a coefficient of zero slips at any force
                    rubbing += lost
                else:
                    braking += lost
        return elastic_energy, slid, elastic_power, braking, rubbing

    return book


def book_pass(pieces):
    """Function that books a step, after its forces and before its moves."""
    of_pairs = contact_book(pieces.space, pieces.pair_laws, unequal=pieces.unequal, flat=False)
    of_walls = contact_book(pieces.space, pieces.wall_laws, unequal=pieces.unequal, flat=True)
    holds, unequal = INTEGRATORS[pieces.integrator].holds, pieces.unequal

    @piece(pieces)
    def discs_book(discs, mean, n, pull, gravity, kick):
        rows, (gx, gy) = discs.rows, pull
        kinetic = potential = falling = shaking = 0.0
        m, im, ii = discs.mass[0], discs.inverse_mass[0], discs.inverse_inertia[0]
        for i in range(n):
            if unequal:
                m, im, ii = discs.mass[i], discs.inverse_mass[i], discs.inverse_inertia[i]
            u, v, w = rows[i, U], rows[i, V], rows[i, W]
            if holds:
                u, v, w = discs.held[i, 0], discs.held[i, 1], discs.held[i, 2]
            mean[i, X], mean[i, Y] = rows[i, X], rows[i, Y]
            mean[i, U] = u + 0.5 * kick * (rows[i, FX] * im + gx)
            mean[i, V] = v + 0.5 * kick * (rows[i, FY] * im + gy)
            mean[i, W] = w + 0.5 * kick * rows[i, TORQUE] * ii
            kinetic += 0.5 * m * (u * u + v * v) + 0.5 * w * w / ii
            potential -= m * (gravity[0] * rows[i, X] + gravity[1] * rows[i, Y])
            falling += m * (gravity[0] * mean[i, U] + gravity[1] * mean[i, V]) * kick
            shaking += m * ((gx - gravity[0]) * mean[i, U] + (gy - gravity[1]) * mean[i, V]) * kick
        return kinetic, potential, falling, shaking

    @piece(pieces)
    def book(shared, share, march, last, pull, kick):
        ledger, shape, lanes = shared.ledger, shared.walls.shape, share.scratch.lanes
        account, rows, pairs, near = ledger.account, shared.bodies.rows, share.pairs, share.near
        kinetic, potential, falling, shaking = discs_book(shared.bodies, ledger.mean, share.hi, pull, march.gravity, kick)
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
