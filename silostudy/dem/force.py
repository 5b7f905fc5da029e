"""The force pass: the contact laws of a scene on lanes of contacts, a loop that the compiler vectorises."""

from silostudy.contact.family import Touch
from silostudy.dem.cache import piece
from silostudy.dem.dimension import Dimension
from silostudy.dem.pieces import Laws
from silostudy.dem.varied import coefficients_pass


def gather_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool, moving: bool):
    """Function that turns a stretch of a list into lanes of relative motion, of pairs or of bodies near walls."""
    gather, gather_walls = space.gather(unequal or laws.brakes), space.gather_walls(moving)

    @piece(space, laws.brakes, unequal, flat, moving)
    def gathered(rows, contacts, shape, start, count, lanes):
        if flat:
            gather_walls(rows, shape, contacts.first, contacts.second, start, count, lanes)
        else:
            gather(rows, contacts.first, contacts.second, start, count, lanes)

    return gathered


def touch_pass(space: Dimension, laws: Laws, *, flat: bool):
    """Function that gives whether bodies are in touch, their own overlap (m) and what the laws see of the contact.

    Where they are not, overlaps are zero; where an attraction holds on, the bodies' own may be negative.
    """
    reduced, clings, cohesion = space.reduced(flat), laws.clings, laws.cohesion
    gap_of, pressed_of = cohesion.gap, cohesion.pressed

    @piece(space, laws, flat)
    def seen(lanes, k, overlap, a, b, m, touched, dt, c):
        radius, touching = reduced(lanes, k, a, b), overlap > 0.0
        if not clings:
            return touching, overlap if touching else 0.0, radius
        holds = touching or (touched > 0.0 and overlap > -gap_of(radius, c[3]))
        return holds, overlap if holds else 0.0, radius

    @piece(space, laws, flat)
    def touch_of(touching, depth, closing, radius, m, dt, c):
        if not clings:
            return Touch(m, radius, dt, depth, closing, depth - closing * dt)
        before = max(depth - closing * dt, -gap_of(radius, c[3]))
        now, then = pressed_of(depth, radius, c[3]), pressed_of(before, radius, c[3])
        return Touch(m, radius, dt, now if touching else 0.0, closing, then)

    return seen, touch_of


def response(laws: Laws):
    """Function that gives a contact's elastic and whole normal force, attraction, and the new history and the whole of
    tangential force, rolling and twisting moment."""
    normal_law, tangential_law, rolling_law = laws.normal.law, laws.tangential.law, laws.rolling.law
    cohesion_law, rubbed, twisting_law = laws.cohesion.law, laws.cohesion.rubbed, laws.twisting.law

    @piece(laws)
    def answer(sliding, rolling, twisting, stored, turned, twisted, touch, c):
        elastic, push = normal_law(touch.overlap, touch.closing, touch, c[0])
        pull = cohesion_law(touch, c[3])
        borne, rubbing = rubbed(elastic, pull, touch, c[3]), rubbed(push, pull, touch, c[3])
        drag = tangential_law(stored, sliding, touch, borne, rubbing, c[1])
        moment = rolling_law(turned, rolling, touch, borne, c[2])
        return elastic, push, pull, drag, moment, twisting_law(twisted, twisting, touch, borne, c[4])

    return answer


def contact_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool, varied: bool = False):
    """Function that writes a contact's forces into lanes and gives its new histories."""
    facing, rates, put = space.facing, space.rates(unequal), space.put(laws.drags, laws.brakes, unequal or laws.brakes)
    carry, where, twists, twisting_of, about = space.carry, space.where, laws.twists, space.twisting, space.about
    (seen, touch_of), answer = touch_pass(space, laws, flat=flat), response(laws)
    _, own = coefficients_pass(space, laws, varied=varied)

    @piece(space, laws, unequal, flat, varied)
    def contact(lanes, out, k, a, b, m, stored, turned, twisted, touched, dt, table):
        c = own(table, k)
        normal, distance = facing(lanes, k)
        touching, depth, radius = seen(lanes, k, a + b - distance, a, b, m, touched, dt, c)
        closing, sliding, rolling = rates(lanes, k, normal, a, b, depth, flat)
        twisting = twisting_of(lanes, k, normal) if twists else 0.0
        touch = touch_of(touching, depth, closing, radius, m, dt, c)
        old, rolled = carry(stored, normal), carry(turned, normal)
        _, push, pull, (held, drag), (rolled, moment), (wound, twist) = answer(
            sliding, rolling, twisting, old, rolled, twisted, touch, c
        )
        moment = about(moment, twist, normal) if twists else moment
        drag, moment = where(touching, drag), where(touching, moment)
        put(out, k, normal, push - pull if touching else 0.0, drag, moment, a, b, depth, flat)
        return where(touching, held), where(touching, rolled), wound if touching else 0.0, 1.0 if touching else 0.0

    return contact


def force_pass(space: Dimension, laws: Laws, *, unequal: bool, flat: bool, varied: bool = False, moving: bool = False):
    """Function that computes a stretch of a list into lanes of force, of bodies of one size or of many, or at a wall.

    A contact's force depends on nothing but its own numbers: the same bits wherever it stands in the list.
    """
    gathered = gather_pass(space, laws, unequal=unequal, flat=flat, moving=moving)
    contact = contact_pass(space, laws, unequal=unequal, flat=flat, varied=varied)
    walked = space.walk(gathered, contact, unequal, laws, (laws, flat, varied, moving))
    bring, _ = coefficients_pass(space, laws, varied=varied)

    @piece(space, laws, unequal, flat, varied, moving)
    def forces(rows, contacts, shape, start, count, lanes, out, stored, rolled, dt, c):
        bring(c, contacts.which, start, count)
        walked(rows, contacts, shape, start, count, lanes, out, stored, rolled, dt, c)

    return forces
