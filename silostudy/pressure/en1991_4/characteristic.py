"""Characteristic values: mean times or over a conversion factor, a set for each quantity that a wall is designed for."""

import numpy as np

PROPERTIES = ("internal_friction_angle", "wall_friction", "lateral_pressure_ratio", "a_phi", "a_K", "a_mu")
SIGNS = {1: "upper", 0: "mean", -1: "lower"}
# set -> which value of wall friction, lateral pressure ratio and internal friction angle it takes
SETS = {
    "mean": (0, 0, 0),
    "wall_normal": (-1, 1, -1),
    "wall_friction": (1, 1, -1),
    "vertical_load": (-1, -1, 1),
    "hopper_filling": (-1, -1, -1),
    "hopper_discharge": (-1, 1, 1),
}


def characteristic(name, *, internal_friction_angle, wall_friction, lateral_pressure_ratio, a_phi, a_K, a_mu):
    """(mu (1), K (1), phi (rad)) of a set, mu at most tan(phi).

    Source: en1991_4_2006 (printed standard not seen; agrees in two or more public programs).
    """
    mu_sign, k_sign, phi_sign = SETS[name]
    phi = internal_friction_angle * a_phi**phi_sign
    mu = np.minimum(wall_friction * a_mu**mu_sign, np.tan(phi))
    return mu, lateral_pressure_ratio * a_K**k_sign, phi


def described(name: str) -> str:
    """A set in words, for tables and figures."""
    return ", ".join(f"{what} {SIGNS[sign]}" for what, sign in zip(("mu", "K", "phi"), SETS[name], strict=True))
