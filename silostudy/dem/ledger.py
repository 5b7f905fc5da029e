"""The energy ledger: where the energy of a scene is, and where it went, booked contact by contact at every step.

Kinetic + potential + elastic + dashpots + sliding + carried out = start + worked in by the base + created by the step.
`created` is what the finite step itself adds or takes (work of the elastic forces over a step less the energy they
lose); it is booked from its own definition, so the balance is a check of every force, torque and move.
"""

from math import sqrt
from typing import NamedTuple

import numpy as np
from numba.extending import register_jitable

from silostudy.contact.family import Touch
from silostudy.dem.arrays import LANES, aligned
from silostudy.dem.cache import piece
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.lanes import FX, FY, TORQUE, U, V, W, X, Y, gather
from silostudy.dem.walls import gather_walls

ENTRIES = ("kinetic", "potential", "elastic", "dashpot", "sliding", "carried_out", "base", "created")
KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT, BASE, CREATED, WORK, BRAKING, SHAKING, BEGUN, TURNOVER = range(13)


class Ledger(NamedTuple):
    """account: the entries (J/m), then what the next step needs; mean: the discs with their mean velocity of the step."""

    account: np.ndarray
    mean: np.ndarray
    lanes: np.ndarray
    pair_stored: np.ndarray
    pair_rolled: np.ndarray
    wall_stored: np.ndarray
    wall_rolled: np.ndarray


def empty(rows: np.ndarray, room: int, wall_room: int) -> Ledger:
    """A ledger for this many contacts, nothing booked; no room at all where the scene asks for none."""
    asked = room > 0
    return Ledger(
        account=np.zeros(13),
        mean=aligned(*(rows.shape if asked else (0, 8))),
        lanes=aligned(6, LANES if asked else 0),
        pair_stored=np.zeros(room),
        pair_rolled=np.zeros(room),
        wall_stored=np.zeros(wall_room),
        wall_rolled=np.zeros(wall_room),
    )


def balance(account: np.ndarray) -> float:
    """Sum (J/m) that stays what it was at the start."""
    held = account[[KINETIC, POTENTIAL, ELASTIC, DASHPOT, SLIDING, CARRIED_OUT]].sum()
    return float(held - account[BASE] - account[CREATED])


def carry_out(engine, gone: np.ndarray) -> None:
    """Book the kinetic and potential energy that discs take with them; `gone` marks them among those left."""
    account, rows, mass = engine.ledger.account, engine.discs.rows[: engine.n][gone], engine.mass[gone]
    speed = engine.discs.held[: engine.n][gone, :3] if len(engine.discs.held) else rows[:, [U, V, W]]
    inertia = 0.5 * mass * engine.radius[gone] ** 2
    kinetic = float((0.5 * mass * (speed[:, 0] ** 2 + speed[:, 1] ** 2) + 0.5 * inertia * speed[:, 2] ** 2).sum())
    potential = -float((mass * (rows[:, [X, Y]] @ np.asarray(engine.gravity))).sum())
    account[CARRIED_OUT] += kinetic + potential
    account[POTENTIAL] -= potential
    account[KINETIC] -= kinetic


@register_jitable
def keep_histories(contacts, count, stored, rolled):
    """Copy the histories before the forces change them."""
    for k in range(count):
        stored[k] = contacts.stored[k] if contacts.stored.size else 0.0
        rolled[k] = contacts.rolled[k] if contacts.rolled.size else 0.0


def contact_book(laws, *, unequal, flat):
    """Function that gives elastic energy, sliding loss, power of elastic and of all forces of the contacts of a list."""
    normal_law, tangential_law, rolling_law, cohesion_law = (row.law for row in laws.rows)
    slide_stiffness, roll_stiffness = (row.stiffness for row in laws.rows[1:3])
    energy, slides, rolls = laws.rows[0].energy, laws.slides, laws.rolls

    @piece(laws, unequal, flat)
    def of_spring(force, stiffness):
        return 0.5 * force * force / stiffness if stiffness > 0.0 else 0.0

    @piece(laws, unequal, flat)
    def of_slip(trial, held, stiffness):
        if not stiffness > 0.0:
            return 0.0
        if held * trial >= 0.0 and abs(held) <= abs(trial):
            return held * (trial - held) / stiffness  # the force that is left, over the slip
        return 0.5 * (trial * trial - held * held) / stiffness  # a spring that a cap on the sum has loaded at a stroke

    @piece(laws, unequal, flat)
    def book(rows, ledger, contacts, shape, count, old_stored, old_rolled, dt, c, lanes):
        elastic_energy = slid = elastic_power = power = 0.0
        a, b, m = contacts.arm[0], contacts.other[0], contacts.mass[0]
        for start in range(0, count, LANES):
            many = min(LANES, count - start)
            if flat:
                gather_walls(rows, shape, contacts.first, contacts.second, start, many, lanes)
                gather_walls(ledger.mean, shape, contacts.first, contacts.second, start, many, ledger.lanes)
            else:
                gather(rows, contacts.first, contacts.second, start, many, lanes)
                gather(ledger.mean, contacts.first, contacts.second, start, many, ledger.lanes)
            mean = ledger.lanes
            for k in range(many):
                at = start + k
                if unequal:
                    a, b, m = contacts.arm[at], contacts.other[at], contacts.mass[at]
                distance = sqrt(lanes[0, k] ** 2 + lanes[1, k] ** 2)
                overlap = a + b - distance
                nx, ny = lanes[0, k] / distance, lanes[1, k] / distance
                spin = 0.5 * (lanes[4, k] * (a + b) + lanes[5, k] * (a - b)) if unequal else lanes[4, k] * a
                turn = 0.5 * (mean[4, k] * (a + b) + mean[5, k] * (a - b)) if unequal else mean[4, k] * a
                rate = lanes[3, k] * nx - lanes[2, k] * ny - spin
                along_spring, rolling_spring = slide_stiffness(overlap, c[1]), roll_stiffness(overlap, c[2])
                trial = old_stored[at] - along_spring * dt * rate if slides else 0.0
                leaning = old_rolled[at] - rolling_spring * dt * lanes[5, k] if rolls else 0.0
                if overlap <= 0.0:  # what springs held when the contact opened is lost
                    slid += of_spring(old_stored[at], along_spring) if slides else 0.0
                    slid += of_spring(old_rolled[at], rolling_spring) if rolls else 0.0
                    continue
                touch = Touch(m, a if flat else a * b / (a + b), dt)
                elastic, push = normal_law(overlap, -(lanes[2, k] * nx + lanes[3, k] * ny), touch, c[0])
                held, drag = tangential_law(old_stored[at], rate, touch, elastic, push, c[1])
                moment = rolling_law(old_rolled[at], lanes[5, k], touch, elastic, c[2])
                pull = cohesion_law(c[3])
                elastic_energy += energy(overlap, c[0]) - pull * overlap
                if slides:
                    elastic_energy += of_spring(held, along_spring)
                    slid += of_slip(trial, held, along_spring)
                if rolls:
                    elastic_energy += of_spring(moment, rolling_spring)
                    slid += of_slip(leaning, moment, rolling_spring)
                apart = mean[2, k] * nx + mean[3, k] * ny
                along = mean[3, k] * nx - mean[2, k] * ny - turn
                elastic_power += (elastic - pull) * apart + held * along + moment * mean[5, k]
                power += (push - pull) * apart + drag * along + moment * mean[5, k]
        return elastic_energy, slid, elastic_power, power

    return book


def book_pass(pieces):
    """Function that books a step, after its forces and before its moves."""
    of_pairs = contact_book(pieces.pair_laws, unequal=pieces.unequal, flat=False)
    of_walls = contact_book(pieces.wall_laws, unequal=pieces.unequal, flat=True)
    holds, unequal = INTEGRATORS[pieces.integrator].holds, pieces.unequal

    @piece(pieces)
    def discs_book(discs, mean, n, gx, gy, gravity, kick):
        rows = discs.rows
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
    def book(discs, pairs, near, walls, scratch, ledger, laws, n, last, gx, gy, gravity, kick, dt):
        account, lanes = ledger.account, scratch.lanes
        kinetic, potential, falling, shaking = discs_book(discs, ledger.mean, n, gx, gy, gravity, kick)
        pair = of_pairs(
            discs.rows, ledger, pairs, walls.shape, pairs.begin[last],
            ledger.pair_stored, ledger.pair_rolled, dt, laws[0], lanes,
        )  # fmt: skip
        wall = of_walls(
            discs.rows, ledger, near, walls.shape, near.begin[0],
            ledger.wall_stored, ledger.wall_rolled, dt, laws[1], lanes,
        )  # fmt: skip
        elastic, slid = pair[0] + wall[0], pair[1] + wall[1]
        if account[BEGUN] > 0.0:
            account[CREATED] += account[WORK] + potential - account[POTENTIAL] + elastic - account[ELASTIC] + slid
            account[SLIDING] += slid
            account[DASHPOT] += account[BRAKING]
            account[BASE] += account[SHAKING]
            account[TURNOVER] += abs(kinetic - account[KINETIC]) + abs(potential - account[POTENTIAL])
        account[KINETIC], account[POTENTIAL], account[ELASTIC] = kinetic, potential, elastic
        account[WORK] = falling + (pair[2] + wall[2]) * kick  # what the forces will do while the discs move
        account[BRAKING] = (pair[2] + wall[2] - pair[3] - wall[3]) * kick
        account[SHAKING] = shaking
        account[BEGUN] = 1.0

    return book
