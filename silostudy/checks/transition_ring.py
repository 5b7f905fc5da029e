"""The ring where cylinder and hopper meet: the hopper pulls it inwards; parts of the shells help to carry it."""

from typing import Any

import numpy as np

from silostudy.checks.family import SUPPORT, SteelCheck

THIN_SHELL = 0.778  # (3 (1 - nu^2))^(-1/4): effective length over sqrt(r t)


def effective_lengths(radius, cylinder, hopper, half_angle):
    """Lengths (m) of cylinder and hopper that work with the ring.

    Source: derived from edge bending of two joined shells, which these forms meet within 1.1 %: the thinner 0.778 sqrt(r t),
    the thicker 0.389 (1 + 3 a^2 - 2 a^3) sqrt(r t), a thin over thick; of the hopper r / cos(beta) in place of r.
    """
    ratio = np.minimum(cylinder, hopper) / np.maximum(cylinder, hopper)
    thicker = THIN_SHELL / 2 * (1 + 3 * ratio**2 - 2 * ratio**3)
    of_cylinder = np.where(cylinder <= hopper, THIN_SHELL, thicker) * np.sqrt(radius * cylinder)
    return of_cylinder, np.where(hopper <= cylinder, THIN_SHELL, thicker) * np.sqrt(radius / np.cos(half_angle) * hopper)


def cylinder_length(*, inner_radius, thickness, hopper_thickness, hopper_half_angle):
    """Length l_c (m) of the cylinder that works with the ring. Source: derived, see above."""
    return effective_lengths(inner_radius, thickness, hopper_thickness, hopper_half_angle)[0]


def hopper_length(*, inner_radius, thickness, hopper_thickness, hopper_half_angle):
    """Length l_h (m) of the hopper that works with the ring. Source: derived, see above."""
    return effective_lengths(inner_radius, thickness, hopper_thickness, hopper_half_angle)[1]


def effective_area(*, ring_area, inner_radius, thickness, hopper_thickness, hopper_half_angle):
    """Effective area A_et (m2): ring, effective lengths of cylinder and hopper; a skirt is left out.

    Source: derived, see above.
    """
    lengths = effective_lengths(inner_radius, thickness, hopper_thickness, hopper_half_angle)
    return ring_area + lengths[0] * thickness + lengths[1] * hopper_thickness


def ring_force(*, hopper_meridional_force, inner_radius, hopper_half_angle):
    """Compression (N) of the ring: n_phi r sin(beta). Source: statics; pressure on the effective lengths would relieve it."""
    return hopper_meridional_force * inner_radius * np.sin(hopper_half_angle)


def stress(*, hopper_meridional_force, ring_area, inner_radius, thickness, hopper_thickness, hopper_half_angle):
    """Compression (Pa) of the ring: N / A_et. Source: statics, effective area derived from mechanics."""
    silo = {"inner_radius": inner_radius, "hopper_half_angle": hopper_half_angle}
    area = effective_area(ring_area=ring_area, thickness=thickness, hopper_thickness=hopper_thickness, **silo)
    return ring_force(hopper_meridional_force=hopper_meridional_force, **silo) / area


def yield_strength(*, yield_stress, partial_yield):
    """Stress (Pa) at which the ring yields: f_y / gamma_M0. Source: en1993_4_1, two programs for gamma_M0."""
    return yield_stress / partial_yield


def critical_stress(
    *, youngs_modulus, ring_area, ring_second_moment, inner_radius, thickness, hopper_thickness, hopper_half_angle,
    partial_buckling,
):  # fmt: skip
    """Compression (Pa) at which the ring buckles in its plane: 3 E I_z/(A_et r^2 gamma_M1). Source: classical_buckling."""
    plates = {"thickness": thickness, "hopper_thickness": hopper_thickness, "hopper_half_angle": hopper_half_angle}
    area = effective_area(ring_area=ring_area, inner_radius=inner_radius, **plates)
    return 3 * youngs_modulus * ring_second_moment / (area * inner_radius**2) / partial_buckling


LEFT_OUT = (
    "the ring's own section sits at the joint (no eccentricity), buckling out of its plane is not covered, a skirt is not "
    "counted as part of it; printed standard not seen"
)
SHARED: dict[str, Any] = {"part": SUPPORT, "effect": stress, "acts_in": frozenset({"solids"})}
ROWS = (
    SteelCheck(
        key="transition_ring",
        title="transition ring, yield",
        source="en1993_4_1",
        locator="transition junction, statics",
        resistance=yield_strength,
        formula="n_phi r sin(beta)/A_et <= f_y/gamma_M0, A_et = A_r + l_c t_c + l_h t_h; thinner plate l = 0.778 sqrt(r t), "
        "thicker 0.389 (1 + 3 a^2 - 2 a^3) sqrt(r t), a thin over thick, hopper r/cos(beta)",
        validity=f"effective lengths by edge bending of two joined shells; {LEFT_OUT}",
        **SHARED,
    ),
    SteelCheck(
        key="transition_ring_buckling",
        title="transition ring, buckling in its plane",
        source="classical_buckling",
        locator="ring under pressure, textbook result",
        resistance=critical_stress,
        formula="n_phi r sin(beta)/A_et <= 3 E I_z/(A_et r^2 gamma_M1)",
        validity=f"the classical value of a free ring, below the code's as it is remembered; {LEFT_OUT}",
        **SHARED,
    ),
)
