"""The walk through a stretch of a list of contacts of spheres: the loop that the compiler vectorises."""

from collections.abc import Callable

from silostudy.dem.cache import piece
from silostudy.dem.pieces import Laws
from silostudy.dem.space.lanes import NEW, OLD, STRETCH, bring, take
from silostudy.dem.space.motion import NEW_TOUCHED, NEW_TWISTED, TOUCHED, TWISTED, held_of, turned_of


def walk(gathered: Callable, contact: Callable, unequal: bool, laws: Laws, key: tuple):
    """Function that takes a stretch of a list contact by contact: the loop that the compiler vectorises.

    It reads and writes two arrays only: with a history each the compiler finds too many that may overlap.
    """
    slid, turned, new_slid, new_turned = OLD * STRETCH, (OLD + 3) * STRETCH, NEW * STRETCH, (NEW + 3) * STRETCH
    slides, rolls, winds, clings = laws.slides, laws.rolls, laws.winds, laws.clings

    @piece("space", unequal, *key)
    def forces(rows, contacts, shape, start, count, lanes, out, stored, rolled, dt, c):
        gathered(rows, contacts, shape, start, count, lanes)
        if slides:
            bring(stored, start, count, lanes, slid)
        if rolls:
            bring(rolled, start, count, lanes, turned)
        if winds:
            bring(contacts.twisted, start, count, lanes, TWISTED)
        if clings:
            bring(contacts.touched, start, count, lanes, TOUCHED)
        arm = contacts.arm[start:] if unequal else contacts.arm
        other = contacts.other[start:] if unequal else contacts.other
        mass = contacts.mass[start:] if unequal else contacts.mass
        a, b, m = arm[0], other[0], mass[0]
        for k in range(count):
            if unequal:
                a, b, m = arm[k], other[k], mass[k]
            old = held_of(lanes, k) if slides else (0.0, 0.0, 0.0)
            rolled_before = turned_of(lanes, k) if rolls else (0.0, 0.0, 0.0)
            twisted = lanes[0, TWISTED + k] if winds else 0.0
            touched = lanes[0, TOUCHED + k] if clings else 0.0
            held, moment, wound, touching = contact(lanes, out, k, a, b, m, old, rolled_before, twisted, touched, dt, c)
            if slides:
                out[0, NEW * STRETCH + k] = held[0]
                out[0, (NEW + 1) * STRETCH + k] = held[1]
                out[0, (NEW + 2) * STRETCH + k] = held[2]
            if rolls:
                out[0, (NEW + 3) * STRETCH + k] = moment[0]
                out[0, (NEW + 4) * STRETCH + k] = moment[1]
                out[0, (NEW + 5) * STRETCH + k] = moment[2]
            if winds:
                out[0, NEW_TWISTED + k] = wound
            if clings:
                out[0, NEW_TOUCHED + k] = touching
        if slides:
            take(out, new_slid, stored, start, count)
        if rolls:
            take(out, new_turned, rolled, start, count)
        if winds:
            take(out, NEW_TWISTED, contacts.twisted, start, count)
        if clings:
            take(out, NEW_TOUCHED, contacts.touched, start, count)

    return forces
