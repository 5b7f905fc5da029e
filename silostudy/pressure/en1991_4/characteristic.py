"""Characteristic values: mean times or over a conversion factor, a set for each quantity that a wall is designed for."""

import numpy as np

from silostudy.pressure.calls import asking
from silostudy.pressure.corrugated import corrugated_friction

PROPERTIES = (
    "internal_friction_angle",
    "wall_friction",
    "lateral_pressure_ratio",
    "a_phi",
    "a_K",
    "a_mu",
    "sets_capped",
    "contact_share",
)
VARIED = frozenset(
    {"internal_friction_angle", "wall_friction", "lateral_pressure_ratio", "hopper_wall_friction", "contact_share"}
)
SIGNS = {1: "upper", 0: "mean", -1: "lower"}
# set -> which value of wall friction, lateral pressure ratio and internal friction angle it takes
SETS = {
    "mean": (0, 0, 0),
    "wall_normal": (-1, 1, -1),
    "wall_friction": (1, 1, -1),
    "vertical_load": (-1, -1, 1),
    "hopper_filling": (-1, -1, -1),
    "hopper_discharge": (-1, 1, 1),
    "channel": (-1, 1, 1),
}


def characteristic(
    name,
    *,
    internal_friction_angle,
    wall_friction,
    lateral_pressure_ratio,
    a_phi,
    a_K,
    a_mu,
    sets_capped=1.0,
    contact_share=1.0,
):
    """Values mu (1), K (1), phi (rad) of a set; mu at most tan(phi) of the set, unless the sets are asked for uncapped.

    Source: en1991_4_2006 (printed standard not seen; agrees in two or more public programs, but for the cap: one of four
    programs has it).  On a corrugated wall mu is made of like values, all upper or all lower: a reading.
    """
    mu_sign, k_sign, phi_sign = SETS[name]
    phi = internal_friction_angle * a_phi**phi_sign
    flat = wall_friction * a_mu**mu_sign
    corrugated = corrugated_friction(flat, internal_friction_angle * a_phi**mu_sign, contact_share)
    mu = np.where(sets_capped == 1, np.minimum(flat, np.tan(phi)), flat)
    return np.where(contact_share == 1, mu, corrugated), lateral_pressure_ratio * a_K**k_sign, phi


def used(name, wall_friction="wall_friction"):
    """Parameter -> function(*, parameters) that gives a set's value; wall_friction: whose, the cylinder's or the hopper's."""

    def value(place, friction=wall_friction, cap=None):
        flat = {} if wall_friction == "wall_friction" else {"contact_share": 1.0}  # hoppers are of flat sheet

        def function(**given):
            given = given | flat | {"wall_friction": given[friction]} | ({} if cap is None else {"sets_capped": cap})
            return characteristic(name, **{asked: given[asked] for asked in PROPERTIES})[place]

        names = [friction if asked == "wall_friction" else asked for asked in PROPERTIES]
        return asking(function, names, f"A value of the set {name} (1).", None)

    return {
        "wall_friction": value(0),
        "wall_friction_uncapped": value(0, f"{wall_friction}_uncapped", cap=0.0),  # nor the mean cut to tan(phi)
        "lateral_pressure_ratio": value(1),
        "internal_friction_angle": value(2),
    }


def described(name: str) -> str:
    """A set in words, for tables and figures."""
    return ", ".join(f"{what} {SIGNS[sign]}" for what, sign in zip(("mu", "K", "phi"), SETS[name], strict=True))
