"""The energy balance of a step: contacts first, then bodies, after the step's forces and before its moves."""

from numba.extending import register_jitable

from silostudy.contact.family import Touch
from silostudy.contact.vector import less, product, same
from silostudy.dem import history
from silostudy.dem.cache import piece
from silostudy.dem.force import gather_pass, response, touch_pass
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.ledger import (
    BASE,
    BEGUN,
    BRAKING,
    CREATED,
    DASHPOT,
    DRIVING,
    ELASTIC,
    KINETIC,
    POTENTIAL,
    RUBBING,
    SHAKING,
    SLIDING,
    TURNOVER,
    WALLS,
    WORK,
    of_slip,
    of_spring,
)  # fmt: skip
from silostudy.dem.varied import coefficients_pass

NO_LIMIT = 1e200  # N/m: a normal force under which nothing slips


@register_jitable
def of_pairs(ledger):
    """Histories of pairs before the step: of sliding, rolling, twisting, being in touch."""
    return ledger.pair_stored, ledger.pair_rolled, ledger.pair_twisted, ledger.pair_touched


@register_jitable
def of_walls(ledger):
    """Histories of contacts with walls before the step."""
    return ledger.wall_stored, ledger.wall_rolled, ledger.wall_twisted, ledger.wall_touched


@register_jitable
def keep_histories(contacts, count, old):
    """Copy the histories before the forces change them."""
    for k in range(count):
        history.enter(old[0], k, history.entry(contacts.stored, k))
        history.enter(old[1], k, history.entry(contacts.rolled, k))
        history.enter(old[2], k, history.entry(contacts.twisted, k))
        history.enter(old[3], k, history.entry(contacts.touched, k))


def springs_pass(laws):
    """Functions of the springs along and about a contact: what they hold, and what slip takes from them."""
    slide_stiffness, roll_stiffness, twist_stiffness = (
        laws.tangential.stiffness,
        laws.rolling.stiffness,
        laws.twisting.stiffness,
    )
    slides, rolls, winds = laws.slides, laws.rolls, laws.winds

    @piece(laws)
    def held_by(held, rolled, wound, overlap, touch, c):
        energy = 0.0
        if slides:
            energy += of_spring(held, slide_stiffness(overlap, touch, c[1]))
        if rolls:
            energy += of_spring(rolled, roll_stiffness(overlap, touch, c[2]))
        if winds:
            energy += of_spring(wound, twist_stiffness(overlap, touch, c[4]))
        return energy

    @piece(laws)
    def slid_by(old, new, rates, touch, dt, c):
        slid, overlap = 0.0, touch.overlap
        if slides:
            stiffness = slide_stiffness(overlap, touch, c[1])
            slid += of_slip(old[0], less(old[0], stiffness * dt, rates[0]), new[0], stiffness)
        if rolls:
            stiffness = roll_stiffness(overlap, touch, c[2])
            slid += of_slip(old[1], less(old[1], stiffness * dt, rates[1]), new[1], stiffness)
        if winds:
            stiffness = twist_stiffness(overlap, touch, c[4])
            slid += of_slip(old[2], less(old[2], stiffness * dt, rates[2]), new[2], stiffness)
        return slid

    return held_by, slid_by


def parting_pass(laws):
    """Functions of a contact: energy that it presses with, and what it still held when it opened, which is lost."""
    (held_by, _), clings = springs_pass(laws), laws.clings
    energy, attraction, gap_of, pressed_of = laws.normal.energy, laws.cohesion.energy, laws.cohesion.gap, laws.cohesion.pressed

    @piece(laws)
    def pressed_energy(overlap, touch, c):
        deep = Touch(touch.mass, touch.radius, touch.dt, overlap)
        return energy(overlap, deep, c[0]) + attraction(deep, c[3])

    @piece(laws)
    def parted(raw, closing, stored, turned, twisted, was, touch, c):
        then = pressed_of(max(raw - closing * touch.dt, -gap_of(touch.radius, c[3])), touch.radius, c[3])
        lost = held_by(stored, turned, twisted, then, touch, c)
        return lost + pressed_energy(then, touch, c) if clings and was > 0.0 else lost

    return pressed_energy, parted


def contact_book(space, laws, *, unequal, flat, varied, moving=False):
    """Function that gives, of the contacts of a list: elastic energy, loss of springs that slid, power of the elastic
    forces, power that dashpots take where contacts stick and where they slip, and power of walls that move.

    What an attraction gives as bodies come in touch, and what it holds as they are torn off, is lost too.
    """
    gathered = gather_pass(space, laws, unequal=unequal, flat=flat, moving=moving)
    (seen, touch_of), (held_by, slid_by) = touch_pass(space, laws, flat=flat), springs_pass(laws)
    facing, carry, rates, twisting_of, answer = space.facing, space.carry, space.rates(unequal), space.twisting, response(laws)
    (pressed_energy, parted), stretch = parting_pass(laws), space.stretch
    twists, clings, tangential_law, wall_power = laws.twists, laws.clings, laws.tangential.law, space.wall_power
    (bring, own), about, whole = coefficients_pass(space, laws, varied=varied), space.about, space.whole

    @piece(space, laws, unequal, flat, varied, moving)
    def book(rows, ledger, old, contacts, shape, count, dt, table, lanes):
        elastic_energy = slid = elastic_power = braking = rubbing = driving = 0.0
        a, b, m = contacts.arm[0], contacts.other[0], contacts.mass[0]
        for start in range(0, count, stretch):
            many = min(stretch, count - start)
            bring(table, contacts.which, start, many)
            gathered(rows, contacts, shape, start, many, lanes)
            gathered(ledger.mean, contacts, shape, start, many, ledger.lanes)
            for k in range(many):
                slot, c = start + k, own(table, k)
                if unequal:
                    a, b, m = contacts.arm[slot], contacts.other[slot], contacts.mass[slot]
                normal, distance = facing(lanes, k)
                raw, was, twisted = a + b - distance, old[3][slot], old[2][slot]
                stored, turned = carry(history.entry(old[0], slot), normal), carry(history.entry(old[1], slot), normal)
                touching, depth, radius = seen(lanes, k, raw, a, b, m, was, dt, c)
                closing, sliding, rolling = rates(lanes, k, normal, a, b, depth, flat)
                twisting = twisting_of(lanes, k, normal) if twists else 0.0
                touch = touch_of(touching, depth, closing, radius, m, dt, c)
                if not touching:  # what springs held when the contact opened is lost
                    slid += parted(raw, closing, stored, turned, twisted, was, touch, c)
                    continue
                elastic, push, pull, (held, drag), (rolled, moment), (wound, twist) = answer(
                    sliding, rolling, twisting, stored, turned, twisted, touch, c
                )
                pressed = pressed_energy(touch.overlap, touch, c)
                elastic_energy += pressed
                if clings and not was > 0.0:
                    slid -= pressed
                elastic_energy += held_by(held, rolled, wound, touch.overlap, touch, c)
                slid += slid_by((stored, turned, twisted), (held, rolled, wound), (sliding, rolling, twisting), touch, dt, c)
                then = held_by(stored, turned, twisted, max(touch.before, 0.0), touch, c)
                slid += then - held_by(stored, turned, twisted, touch.overlap, touch, c)  # stiffness changes under a force
                nearing, along, turning = rates(ledger.lanes, k, normal, a, b, depth, flat)  # on average over the step
                winding = twisting_of(ledger.lanes, k, normal) if twists else 0.0
                elastic_power += (pull - elastic) * nearing + product(held, along)
                elastic_power += product(rolled, turning) + wound * winding
                braking += (push - elastic) * nearing
                braking -= product(less(moment, 1.0, rolled), turning) + (twist - wound) * winding
                if moving:
                    force, couple = whole(push - pull, drag, normal), about(moment, twist, normal)
                    driving += wall_power(rows, shape, contacts.first[slot], contacts.second[slot], force, couple)
                lost = product(less(held, 1.0, drag), along)
                _, unlimited = tangential_law(stored, sliding, touch, NO_LIMIT, NO_LIMIT, c[1])
                if not same(drag, unlimited) or (history.holds(held) and not history.holds(drag)):
                    rubbing += lost  # a coefficient of zero slips at any force
                else:
                    braking += lost
        return elastic_energy, slid, elastic_power, braking, rubbing, driving

    return book


def bodies_pass(pieces):
    """Function that books the bodies: kinetic and potential energy, what gravity and the base will do in the step.

    It writes their places and mean velocities of the step into rows of their own.
    """
    space, holds, unequal = pieces.space, INTEGRATORS[pieces.integrator].holds, pieces.unequal
    place, rates, pushes = space.place, (*space.velocity, *space.spin), (*space.force, *space.torque)
    ways, turns = len(space.velocity), len(space.spin)

    @piece(pieces)
    def bodies_book(bodies, mean, n, pull, gravity, kick):
        rows = bodies.rows
        kinetic = potential = falling = shaking = 0.0
        m, im, ii = bodies.mass[0], bodies.inverse_mass[0], bodies.inverse_inertia[0]
        for i in range(n):
            if unequal:
                m, im, ii = bodies.mass[i], bodies.inverse_mass[i], bodies.inverse_inertia[i]
            moving = turning = lifted = fallen = shaken = 0.0
            for way in range(ways):
                speed = bodies.held[i, way] if holds else rows[i, rates[way]]
                mean[i, place[way]] = rows[i, place[way]]
                mean[i, rates[way]] = speed + 0.5 * kick * (rows[i, pushes[way]] * im + pull[way])
                moving += speed * speed
                lifted += gravity[way] * rows[i, place[way]]
                fallen += gravity[way] * mean[i, rates[way]]
                shaken += (pull[way] - gravity[way]) * mean[i, rates[way]]
            for way in range(ways, ways + turns):
                speed = bodies.held[i, way] if holds else rows[i, rates[way]]
                mean[i, rates[way]] = speed + 0.5 * kick * rows[i, pushes[way]] * ii
                turning += speed * speed
            kinetic += 0.5 * m * moving + 0.5 * turning / ii
            potential -= m * lifted
            falling += m * fallen * kick
            shaking += m * shaken * kick
        return kinetic, potential, falling, shaking

    return bodies_book


def book_pass(pieces):
    """Function that books a step, after its forces and before its moves."""
    space, unequal, (pairs_vary, walls_vary) = pieces.space, pieces.unequal, pieces.varied
    pairs_book = contact_book(space, pieces.pair_laws, unequal=unequal, flat=False, varied=pairs_vary)
    walls_book = contact_book(space, pieces.wall_laws, unequal=unequal, flat=True, varied=walls_vary, moving=pieces.moving)
    bodies_book = bodies_pass(pieces)

    @piece(pieces)
    def book(shared, share, march, last, pull, kick):
        ledger, shape, lanes = shared.ledger, shared.walls.shape, share.scratch.lanes
        account, rows, pairs, near, dt = ledger.account, shared.bodies.rows, share.pairs, share.near, march.past
        kinetic, potential, falling, shaking = bodies_book(shared.bodies, ledger.mean, share.hi, pull, march.gravity, kick)
        pair = pairs_book(rows, ledger, of_pairs(ledger), pairs, shape, pairs.begin[last], dt, march.pair_coefficients, lanes)
        wall = walls_book(rows, ledger, of_walls(ledger), near, shape, near.begin[0], dt, march.wall_coefficients, lanes)
        elastic, slid = pair[0] + wall[0], pair[1] + wall[1]
        if account[BEGUN] > 0.0:
            account[CREATED] += account[WORK] + potential - account[POTENTIAL] + elastic - account[ELASTIC] + slid
            account[SLIDING] += slid
            account[DASHPOT] += account[BRAKING]
            account[SLIDING] += account[RUBBING]
            account[BASE] += account[SHAKING]
            account[WALLS] += account[DRIVING]
            account[TURNOVER] += abs(kinetic - account[KINETIC]) + abs(potential - account[POTENTIAL])
        account[KINETIC], account[POTENTIAL], account[ELASTIC] = kinetic, potential, elastic
        account[WORK] = falling + (pair[2] + wall[2]) * kick  # what the forces will do while the discs move
        account[BRAKING] = (pair[3] + wall[3]) * kick
        account[RUBBING] = (pair[4] + wall[4]) * kick
        account[SHAKING] = shaking
        account[DRIVING] = wall[5] * kick
        account[BEGUN] = 1.0

    return book
