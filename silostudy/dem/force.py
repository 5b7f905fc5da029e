"""The force pass: the contact laws of a scene on lanes of contacts, a loop that the compiler vectorises."""

from silostudy.contact.family import Touch
from silostudy.dem.cache import piece
from silostudy.dem.dimension import Dimension
from silostudy.dem.pieces import Laws


def gather_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool):
    """Function that turns a stretch of a list into lanes of relative motion, of pairs or of bodies near walls."""
    gather, gather_walls = space.gather(unequal or laws.brakes), space.gather_walls

    @piece(space, laws.brakes, unequal, flat)
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


def contact_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool):
    """Function that writes a contact's forces into lanes and gives its new histories."""
    facing, rates, put = space.facing, space.rates(unequal), space.put(laws.drags, laws.brakes)
    reduced, carry, where = space.reduced(flat), space.carry, space.where
    answer, cohesion_law = response(laws), laws.cohesion.law

    @piece(space, laws, unequal, flat)
    def contact(lanes, out, k, a, b, m, stored, turned, dt, c):
        normal, distance = facing(lanes, k)
        overlap = a + b - distance
        touching = overlap > 0.0
        depth = overlap if touching else 0.0
        closing, sliding, rolling = rates(lanes, k, normal, a, b, depth, flat)
        touch = Touch(m, reduced(lanes, k, a, b), dt, depth, closing)
        old, rolled = carry(stored, normal), carry(turned, normal)
        _, push, held, drag, moment = answer(depth, closing, sliding, rolling, old, rolled, touch, c)
        push = push - cohesion_law(c[3]) if touching else 0.0
        drag, moment = where(touching, drag), where(touching, moment)
        put(out, k, normal, push, drag, moment, a, b, depth, flat)
        return where(touching, held), moment

    return contact


def force_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool):
    """Function that computes a stretch of a list into lanes of force, of bodies of one size or of many, or at a wall.

    A contact's force depends on nothing but its own numbers: the same bits wherever it stands in the list.
    """
    gathered = gather_pass(space, laws, unequal=unequal, flat=flat)
    contact = contact_pass(space, laws, unequal=unequal, flat=flat)
    return space.walk(gathered, contact, unequal, laws.slides, laws.rolls, (laws, flat))
