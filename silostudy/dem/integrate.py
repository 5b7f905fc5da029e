"""The integrators: a family of functions that carry one component of the motion over a step."""

from collections.abc import Callable
from dataclasses import dataclass

from numba.extending import register_jitable

from silostudy.catalogue import Family, Row


@dataclass(frozen=True, kw_only=True)
class Integrator(Row):
    """Time integration: advance(rate, held, acceleration, kick, dt) -> rate, held, increment; forces see `rate`, not `held`."""

    advance: Callable
    holds: bool  # whether it keeps a velocity apart from the rate that the forces see
    order: int  # of the error on a smooth force without damping
    half_start: bool = False  # the first kick is half a step


@register_jitable
def plain(rate, held, acceleration, kick, dt):
    """New rate (m/s), held velocity and increment (m): the new velocity moves the disc.

    Kiyama & Fujimura (1983), eqs. (17) and (18).
    """
    new = rate + acceleration * dt
    return new, held, new * dt


@register_jitable
def smoothed(rate, held, acceleration, kick, dt):
    """New rate (m/s), held velocity and increment (m): the increment is the mean of the last one and velocity times dt.

    Kiyama & Fujimura (1983), eqs. (17) and (19); the forces see the increment over dt.
    """
    velocity = held + acceleration * dt
    new = 0.5 * (rate + velocity)
    return new, velocity, new * dt


@register_jitable
def verlet(rate, held, acceleration, kick, dt):
    """New rate (m/s), held velocity and increment (m): half-step velocities move the disc, forces see a predicted full step.

    Velocity Verlet, Allen & Tildesley (1987); kick (s) is dt, and half of it at the first step.
    """
    half = held + acceleration * kick
    return half + acceleration * (0.5 * dt), half, half * dt


PLAIN = Integrator(
    key="17-18",
    title="Velocity, then position with the new velocity",
    source="kiyama_fujimura_1983",
    locator="eqs. (17), (18)",
    advance=plain,
    holds=False,
    order=1,
)
SMOOTHED = Integrator(
    key="17-19",
    title="Velocity, then a smoothed increment",
    source="kiyama_fujimura_1983",
    locator="eqs. (17), (19)",
    advance=smoothed,
    holds=True,
    order=1,
)
VERLET = Integrator(
    key="velocity-verlet",
    title="Velocity Verlet with a predicted velocity for the dashpots",
    source="allen_tildesley_1987",
    locator="section 3.2",
    advance=verlet,
    holds=True,
    order=2,
    half_start=True,
)
INTEGRATORS: Family[Integrator] = Family("integrator", [PLAIN, SMOOTHED, VERLET])
