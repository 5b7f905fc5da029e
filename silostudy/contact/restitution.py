"""Restitution of a linear spring and dashpot, and the damping ratio that gives one asked for.

The damping ratio here is the dashpot over 2 sqrt(m K), m the reduced mass of the two bodies: the mass of a disc at a wall,
half of it between two equal discs.
"""

from math import acos, acosh, exp, log, pi, sqrt

from scipy.optimize import brentq

LEAST = 1e-6  # restitution below which no dashpot is sought


def of_cut(ratio: float) -> float:
    """Restitution (1) of a head-on impact whose contact ends when spring and dashpot together cease to press.

    The contact ends after the phase 2 acos(ratio): Schwager & Poschel (2007), eq. (21), in one expression.
    """
    if ratio == 1.0:
        return exp(-2.0)
    if ratio < 1.0:
        return exp(-2.0 * ratio * acos(ratio) / sqrt(1.0 - ratio * ratio))
    return exp(-2.0 * ratio * acosh(ratio) / sqrt(ratio * ratio - 1.0))


def ratio_where_cut(restitution: float) -> float:
    """Damping ratio (1) with which a contact that never pulls has this restitution."""
    return 0.0 if restitution >= 1.0 else float(brentq(lambda ratio: of_cut(ratio) - restitution, 0.0, 1.0 / LEAST))


def ratio_where_pulled(restitution: float) -> float:
    """Damping ratio (1) with which a contact that ends when the overlap does has this restitution: half a period long."""
    return -log(restitution) / sqrt(pi * pi + log(restitution) ** 2)
