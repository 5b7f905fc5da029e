"""The force pass: the contact laws of a scene on lanes of contacts, a loop that the compiler vectorises."""

from silostudy.contact.family import Touch
from silostudy.dem.cache import piece
from silostudy.dem.pieces import Laws
from silostudy.dem.plane import Dimension


def gather_pass(space: Dimension, *, flat: bool):
    """Function that turns a stretch of a list into lanes of relative motion, of pairs or of bodies near walls."""
    gather, gather_walls = space.gather, space.gather_walls

    @piece(space, flat)
    def gathered(rows, contacts, shape, start, count, lanes):
        if flat:
            gather_walls(rows, shape, contacts.first, contacts.second, start, count, lanes)
        else:
            gather(rows, contacts.first, contacts.second, start, count, lanes)

    return gathered


def response(laws: Laws):
    """Function that gives a contact's elastic and whole normal force, new history and tangential force, and moment."""
    normal_law, tangential_law, rolling_law = laws.normal.law, laws.tangential.law, laws.rolling.law

    @piece(laws)
    def answer(depth, closing, sliding, rolling, stored, turned, touch, c):
        elastic, push = normal_law(depth, closing, touch, c[0])
        held, drag = tangential_law(stored, sliding, touch, elastic, push, c[1])
        return elastic, push, held, drag, rolling_law(turned, rolling, touch, elastic, c[2])

    return answer


def force_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool):
    """Function that computes a stretch of a list into lanes of force, of bodies of one size or of many, or at a wall.

    A contact's force depends on nothing but its own numbers: the same bits wherever it stands in the list.
    """
    gathered, facing, rates, put = gather_pass(space, flat=flat), space.facing, space.rates(unequal), space.put(laws.drags)
    answer, cohesion_law, slides, rolls = response(laws), laws.cohesion.law, laws.slides, laws.rolls

    @piece(space, laws, unequal, flat)
    def forces(rows, contacts, shape, start, count, lanes, out, stored, rolled, dt, c):
        gathered(rows, contacts, shape, start, count, lanes)
        stored = stored[start:] if slides else stored
        rolled = rolled[start:] if rolls else rolled
        arm = contacts.arm[start:] if unequal else contacts.arm
        other = contacts.other[start:] if unequal else contacts.other
        mass = contacts.mass[start:] if unequal else contacts.mass
        a, b, m = arm[0], other[0], mass[0]
        for k in range(count):
            if unequal:
                a, b, m = arm[k], other[k], mass[k]
            normal, distance = facing(lanes, k)
            closing, sliding, rolling = rates(lanes, k, normal, a, b)
            overlap = a + b - distance
            touching = overlap > 0.0
            touch = Touch(m, a if flat else a * b / (a + b), dt)
            old, turned = stored[k] if slides else 0.0, rolled[k] if rolls else 0.0
            depth = overlap if touching else 0.0
            _, push, held, drag, moment = answer(depth, closing, sliding, rolling, old, turned, touch, c)
            push = push - cohesion_law(c[3]) if touching else 0.0
            drag = drag if touching else 0.0
            moment = moment if touching else 0.0
            if slides:
                stored[k] = held if touching else 0.0
            if rolls:
                rolled[k] = moment
            put(out, k, normal, push, drag, moment, a, b)

    return forces
