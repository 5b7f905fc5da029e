"""Caquot: active state in filling, passive state in discharge, with the wall inclined to the principal stresses.

The source prints p_v and p_h exchanged and lambda = tan(phi_i); only mu = tan(phi_o) in p_h gives its own Table 4.2.5.
Both states are Janssen's formula with K = cos^2(phi_o) times the ratio of principal stresses (that is R / (mu b) with
the printed b), which is also the K that keeps p_v in vertical equilibrium with the printed wall pressure.
"""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.family import CIRCULAR, PressureMethod


def principal_ratio(internal_friction_angle, wall_friction):
    """Ratio i (1) of the smaller to the larger stress: (1 - sin phi_i sqrt(1 - m^2)) / (1 + ...), m = tan phi_o / tan phi_i.

    Source: silo_handbook, section 4.2.2 (c); its j is 1/i.
    """
    m = np.minimum(wall_friction / np.tan(internal_friction_angle), 1.0)
    sin, cos = np.sin(internal_friction_angle), np.cos(internal_friction_angle)
    root = sin * np.sqrt((1 - m) * (1 + m))
    return (cos**2 + (m * sin) ** 2) / (1 + root) ** 2  # 1 - root times 1 + root, without the difference near 90 degrees


def filling_ratio(internal_friction_angle, wall_friction):
    """Lateral pressure ratio K (1) of the active state: cos^2(phi_o) i."""
    return principal_ratio(internal_friction_angle, wall_friction) / (1 + wall_friction**2)


def discharge_ratio(internal_friction_angle, wall_friction):
    """Lateral pressure ratio K (1) of the passive state: cos^2(phi_o) / i."""
    return 1 / (principal_ratio(internal_friction_angle, wall_friction) * (1 + wall_friction**2))


def _state(ratio, janssen_quantity):
    def quantity(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle):
        return janssen_quantity(
            z,
            unit_weight=unit_weight,
            hydraulic_radius=hydraulic_radius,
            wall_friction=wall_friction,
            lateral_pressure_ratio=ratio(internal_friction_angle, wall_friction),
        )

    quantity.__doc__ = f"{janssen_quantity.__doc__.splitlines()[0]} Source: silo_handbook, section 4.2.2 (c)."
    return quantity


FILLING = {name: _state(filling_ratio, function) for name, function in janssen.STATE.items()}
DISCHARGE = {name: _state(discharge_ratio, function) for name, function in janssen.STATE.items()}


def _depth_constant(hydraulic_radius, wall_friction, stress_ratio):
    """Depth constant b (m): (D/2) times j or i over sin(2 phi_o)."""
    return 2 * hydraulic_radius * stress_ratio / np.sin(2 * np.arctan(wall_friction))


def printed_filling_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle):
    """Horizontal wall pressure (Pa) as section 4.2.2 (c) prints it: gamma D / (4 lambda mu) (1 - exp(-z/b))."""
    j = 1 / principal_ratio(internal_friction_angle, wall_friction)
    b = _depth_constant(hydraulic_radius, wall_friction, j)
    swapped = np.tan(internal_friction_angle) * wall_friction
    return -unit_weight * hydraulic_radius / swapped * np.expm1(-z / b)


def printed_discharge_pressure(z, *, unit_weight, hydraulic_radius, wall_friction, internal_friction_angle, i_phi):
    """Horizontal wall pressure (Pa) as printed, with the i of Table 4.2.4 (two digits exchanged)."""
    b = _depth_constant(hydraulic_radius, wall_friction, i_phi)
    swapped = np.tan(internal_friction_angle) * wall_friction
    return -unit_weight * hydraulic_radius / swapped * np.expm1(-z / b)


USED = {
    phase: janssen.for_state({"lateral_pressure_ratio": ratio})
    for phase, ratio in (("filling", filling_ratio), ("discharge", discharge_ratio))
}
ROW = PressureMethod(
    key="caquot",
    rank=30,
    title="Caquot",
    source="silo_handbook",
    locator="section 4.2.2 (c)",
    phases={"filling": FILLING, "discharge": DISCHARGE},
    static=FILLING["wall_normal_pressure"],
    plans=CIRCULAR,
    formula="p_h = gamma D / (4 tan phi_o) (1 - exp(-z/b)), b = (D/2) j / sin(2 phi_o) in filling, i in place of j in "
    "discharge, i = 1/j = (1 - sin phi_i sqrt(1 - m^2)) / (1 + sin phi_i sqrt(1 - m^2)), m = tan phi_o / tan phi_i",
    used=USED,
    validity="circular plan; p_v with K = R / (mu b), the ratio that equilibrium asks for (the source's is misprinted)",
    colour="#E69F00",
    marker="s",
    number="7",
    drawn="handbook",
    as_printed={
        "filling": {"wall_normal_pressure": printed_filling_pressure},
        "discharge": {"wall_normal_pressure": printed_discharge_pressure},
    },
    equilibrium=("filling", "discharge"),
)
