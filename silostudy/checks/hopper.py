"""The wall of a conical hopper under its contents: membrane forces, yield, and the joint at the transition."""

from typing import Any

import numpy as np

from silostudy.checks.family import HOPPER, SteelCheck
from silostudy.checks.membrane import equivalent_stress


def hoop_force(normal, *, height, half_angle):
    """Hoop force n_th (N/m), tension positive, at heights (m) above the apex: p_n r / cos(beta).

    Source: en1993_4_1, a program; theory.
    """
    return normal * height * np.tan(half_angle) / np.cos(half_angle)


def meridional_force(normal, traction, *, height, half_angle, wall_weight=0.0):
    """Meridional force n_phi (N/m), tension positive, at heights (m) above the apex, from the transition down to a free edge.

    Source: statics: 1/(x cos beta) int x' (p_n tan beta + p_t) dx', the pressures straight between the heights; wall_weight
    (Pa): of the plate, per area of it.
    """
    down = normal * np.tan(half_angle) + traction + wall_weight / np.cos(half_angle)
    upper, lower = height[..., :-1], height[..., 1:]
    above, below = down[..., :-1], down[..., 1:]
    parts = (upper - lower) / 6 * (upper * above + (upper + lower) * (above + below) + lower * below)
    carried = np.flip(np.cumsum(np.flip(parts, axis=-1), axis=-1), axis=-1)
    carried = np.concatenate([carried, 0 * lower[..., -1:] * below[..., -1:]], axis=-1)
    with np.errstate(invalid="ignore", divide="ignore"):
        return carried / (height * np.cos(half_angle))


def acting(*, hopper_meridional_force, hopper_hoop_force, hopper_thickness):
    """Equivalent membrane stress (Pa), tension in both directions. Source: en1993_4_1, membrane strength, two programs."""
    return equivalent_stress(-hopper_meridional_force / hopper_thickness, hopper_hoop_force / hopper_thickness)


def yield_strength(*, yield_stress, partial_yield):
    """Stress (Pa) at which the plate yields: f_y / gamma_M0. Source: en1993_4_1, two programs."""
    return yield_stress / partial_yield


def hoop(*, hopper_hoop_force, hopper_thickness):
    """Hoop stress (Pa): n_th / t. Source: en1993_4_1, one program; shell theory."""
    return hopper_hoop_force / hopper_thickness


def hoop_strength(*, yield_stress, hopper_joint_efficiency, partial_yield):
    """Hoop stress (Pa) that the plate with its welds bears: j f_y / gamma_M0. Source: en1993_4_1, two programs."""
    return hopper_joint_efficiency * yield_stress / partial_yield


def meridional(*, hopper_meridional_force, hopper_thickness):
    """Meridional stress (Pa): n_phi / t. Source: statics."""
    return hopper_meridional_force / hopper_thickness


def joint_strength(*, ultimate_stress, hopper_joint_efficiency, partial_joint):
    """Stress (Pa) that a joint across the meridian bears: j f_u / gamma_M2. Source: en1993_4_1, two programs for gamma_M2."""
    return hopper_joint_efficiency * ultimate_stress / partial_joint


LEFT_OUT = "no bending at the edges, no kick pressure at the transition, no plastic limit; printed standard not seen"
SHARED: dict[str, Any] = {"part": HOPPER, "source": "en1993_4_1", "acts_in": frozenset({"solids"})}
FORCES = (
    "n_th = p_n r/cos(beta), n_phi = 1/(x cos(beta)) int x' (p_n tan(beta) + p_t) dx' from the outlet up, own weight included"
)
ROWS = (
    SteelCheck(
        key="hopper_hoop",
        title="hopper, hoop tension",
        locator="hopper, second-hand",
        effect=hoop,
        resistance=hoop_strength,
        formula=f"n_th <= j t f_y/gamma_M0; {FORCES}",
        validity=f"n_th by a public program and shell theory; {LEFT_OUT}",
        **SHARED,
    ),
    SteelCheck(
        key="hopper_yield",
        title="hopper, membrane yield",
        locator="hopper, second-hand",
        effect=acting,
        resistance=yield_strength,
        formula=f"sqrt(n_phi^2 + n_th^2 - n_phi n_th) <= t f_y/gamma_M0; {FORCES}",
        validity=f"n_phi by vertical equilibrium (a public program breaks it); {LEFT_OUT}",
        **SHARED,
    ),
    SteelCheck(
        key="hopper_joint",
        title="hopper, joint across the meridian",
        locator="hopper, second-hand",
        effect=meridional,
        resistance=joint_strength,
        formula=f"n_phi <= j t f_u/gamma_M2; {FORCES}",
        validity="the plain joint, at every height as at the transition; a factor for asymmetry and a reduced strength there "
        f"are remembered only; {LEFT_OUT}",
        **SHARED,
    ),
)
