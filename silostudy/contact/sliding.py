"""Tangential forces: a spring and dashpot behind a slider, and the viscous force capped by Coulomb's law.

Each takes the stored force (N/m), the sliding speed (m/s) of the first body's surface over the second's, the reduced
mass (kg/m), the time step (s), the elastic and total normal force (N/m), and gives the new stored and the total force.
"""

from math import sqrt

from numba.extending import register_jitable


@register_jitable
def clamp(value, cap):
    """value held between -cap and +cap."""
    low = value if value > -cap else -cap
    return low if low < cap else cap


@register_jitable
def elastic_cap(stored, sliding, mass, dt, elastic, normal, c):
    """Stored and total tangential force (N/m); the slider caps the elastic part and then drops the dashpot.

    Kiyama & Fujimura (1983), eqs. (10)-(14); c = (stiffness, damping, damping by root of mass, friction).
    """
    trial = stored - c[0] * dt * sliding
    held = clamp(trial, c[3] * elastic)
    return held, held - (c[1] + c[2] * sqrt(mass)) * sliding * (1.0 if held == trial else 0.0)


@register_jitable
def total_cap(stored, sliding, mass, dt, elastic, normal, c):
    """Stored and total tangential force (N/m); spring and dashpot together stay below friction times normal force.

    Cundall & Strack (1979), slip check of the law FORD; c = (stiffness, damping, damping by root of mass, friction).
    """
    dashpot = -(c[1] + c[2] * sqrt(mass)) * sliding
    total = clamp(stored - c[0] * dt * sliding + dashpot, c[3] * normal)
    return total - dashpot, total


@register_jitable
def implicit_cap(stored, sliding, mass, dt, elastic, normal, c):
    """Stored and total tangential force (N/m) as elastic_cap's, the dashpot on the speed that its own force leaves.

    Kiyama & Fujimura (1983), eqs. (10)-(14), with sliding' = sliding + 3 dt dashpot / mass in (11): a tangential force on
    a disc's rim moves the rim by its translation, and twice as much by its rotation (inertia m r^2 / 2).
    """
    damping = c[1] + c[2] * sqrt(mass)
    softer = damping / (1.0 + 3.0 * damping * dt / mass)
    trial = stored - c[0] * dt * sliding
    held = clamp(trial, c[3] * elastic)
    return held, held - softer * sliding * (1.0 if held == trial else 0.0)


@register_jitable
def viscous(stored, sliding, mass, dt, elastic, normal, c):
    """Tangential force (N/m) of a dashpot capped by friction times the normal force; nothing is stored.

    Haff & Werner (1986); c = (damping, damping by root of mass, friction).
    """
    return 0.0, clamp(-(c[0] + c[1] * sqrt(mass)) * sliding, c[2] * normal)
