"""Linear normal springs with a dashpot, by what becomes of the dashpot's pull: cut, left in, or taken semi-implicitly."""

from math import sqrt

from numba.extending import register_jitable


@register_jitable
def cut(overlap, closing, mass, dt, c):
    """Elastic and total normal force (N/m) of a spring and dashpot that never pull.

    Kiyama & Fujimura (1983), eqs. (6)-(9), with the sum of both held at zero or more as their text asks.
    overlap (m), closing speed (m/s), reduced mass (kg/m), time step (s), c = (stiffness, damping, damping by root of mass).
    """
    elastic = c[0] * overlap
    total = elastic + (c[1] + c[2] * sqrt(mass)) * closing
    return elastic, (total if total > 0.0 else 0.0)


@register_jitable
def pulling(overlap, closing, mass, dt, c):
    """Elastic and total normal force (N/m) of a spring and dashpot; the dashpot may pull until the discs part.

    Kiyama & Fujimura (1983), eqs. (6)-(9) by the letter: only a lost overlap cuts the force.
    """
    elastic = c[0] * overlap
    return elastic, elastic + (c[1] + c[2] * sqrt(mass)) * closing


@register_jitable
def implicit(overlap, closing, mass, dt, c):
    """Elastic and total normal force (N/m) with the dashpot on the speed that its own force leaves; it never pulls.

    From eqs. (6)-(9) of Kiyama & Fujimura (1983) with closing' = closing - dt dashpot / mass put into (6b).  The spring is
    left out of it: else a contact at rest would be softer by 1 + dt damping / mass.
    """
    elastic = c[0] * overlap
    damping = c[1] + c[2] * sqrt(mass)
    total = elastic + damping / (1.0 + damping * dt / mass) * closing
    return elastic, (total if total > 0.0 else 0.0)


@register_jitable
def energy(overlap, c):
    """Energy (J/m) that a linear spring holds at an overlap (m); c = (stiffness, ...)."""
    return 0.5 * c[0] * overlap * overlap
