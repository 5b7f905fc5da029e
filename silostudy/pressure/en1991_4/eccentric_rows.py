"""Large eccentric discharge of EN 1991-4:2006 as a method: the pressures of three zones of wall for three sizes of channel."""

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4 import cylinder, eccentric, limits
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, VARIED, characteristic, described, used
from silostudy.pressure.en1991_4.on_wall import CYLINDER, STATE, take
from silostudy.pressure.family import CHANNEL_SIZES, CIRCULAR, PressureMethod

STATIC, MOVING = "wall_normal", "channel"  # sets of characteristic values: of the solid at rest, and in the channel
ONE_MU = "Source: en1991_4_2006, wall friction from one program."
SEEN = "Source: en1991_4_2006 (printed standard not seen; two public accounts agree)."


def zones(z, given):
    """(p_hce, p_hse, p_hae) (Pa) at depth z (m) for one size of channel."""
    mu, k, phi = characteristic(MOVING, **take(given, PROPERTIES))
    moving = eccentric.channel_pressure(
        z, unit_weight=given["unit_weight"], radius=given["diameter"] / 2, size=given["channel_size"], mu=mu, k=k, phi=phi
    )
    mu, k, _ = characteristic(STATIC, **take(given, PROPERTIES))
    static = cylinder.pressures(z, mu=mu, k=k, **take(given, STATE))[0]
    return moving, static, eccentric.adjacent_pressure(static=static, moving=moving)


ZONES = {"channel": MOVING, "static": STATIC, "adjacent": STATIC}  # zone -> set of its wall friction


def _in_zone(number, zone, friction):
    def function(z, **given):
        mu = characteristic(ZONES[zone], **take(given, PROPERTIES))[0] if friction else 1.0
        return mu * zones(z, given)[number]

    what = f"Wall friction traction (Pa) in the {zone} zone" if friction else f"Wall normal pressure (Pa) in the {zone} zone"
    return asking(function, (*CYLINDER, "channel_size"), f"{what} at depth z (m). {ONE_MU if friction else SEEN}")


def _of_channel(number, doc):
    def function(**given):
        mu, _, phi = characteristic(MOVING, **take(given, PROPERTIES))
        return eccentric.channel(given["diameter"] / 2, given["channel_size"], mu, phi)[number]

    return asking(function, ("diameter", "channel_size", *PROPERTIES), f"{doc} {SEEN}", None)


def _radius(*, diameter, channel_size):
    """Radius r_c (m) of the channel: k_c r. Source: en1991_4_2006."""
    return channel_size * diameter / 2


def _largest(number):
    def function(z, **given):
        each = [zones(z, given | {"channel_size": np.float64(size)}) for size in CHANNEL_SIZES]
        mu = characteristic(STATIC, **take(given, PROPERTIES))[0]
        return np.max([one[2] for one in each], axis=0) * (1.0, mu)[number]

    what = ("Wall normal pressure (Pa)", "Wall friction traction (Pa)")[number]
    doc = f"{what} beside the flow channel at depth z (m), the largest of three channel sizes. {(SEEN, ONE_MU)[number]}"
    return asking(function, CYLINDER, doc)


CHANNEL = {
    f"{zone}_{quantity}": _in_zone(number, zone, friction)
    for number, zone in enumerate(ZONES)
    for quantity, friction in (("normal_pressure", False), ("friction_traction", True))
} | {
    "channel_half_width": _of_channel(0, "Angle theta_c (rad) from the channel's axis to its edge on the wall."),
    "channel_eccentricity": _of_channel(2, "Distance e_c (m) of the channel's axis from the silo's."),
    "channel_radius": _radius,
}

ROW = PressureMethod(
    key="en1991_4_eccentric",
    rank=160,
    title="EN 1991-4:2006, large eccentric discharge",
    source="en1991_4_2006",
    locator="as public programs carry it (printed standard not seen)",
    phases={"discharge": {"wall_normal_pressure": _largest(0), "wall_friction_traction": _largest(1)}},
    channel={"discharge": CHANNEL},
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    limits=limits.ECCENTRIC,
    varies=VARIED,
    values={
        "static and adjacent zone": described(STATIC),
        "channel": described(MOVING),
        "every quantity": "unit weight upper; no C_h, C_w",
    },
    used={"discharge": dict.fromkeys(("wall_normal_pressure", "wall_friction_traction"), used(STATIC))},
    not_computed=(
        "whether the action assessment class asks for this load case; large eccentricity of filling in very slender silos",
        "a second static set with mu upper, which one program takes for the largest axial force",
        "the resultant and the bending of the silo, which follow from the zones by integration",
    ),
    formula="p_hce Janssen of a channel r_c = k_c r, k_c in 0.25, 0.40, 0.60, within theta_c of its axis; p_hse as after "
    "filling beyond 2 theta_c; p_hae = 2 p_hse - p_hce between; p_w = mu p_h",
    validity="a separate load case beside symmetric discharge; its pressures are local: wall_normal_pressure is that of the "
    "adjacent zone, the largest of the three channels, which do not hang on how eccentric the outlet is; friction from one "
    "program; static pressures of squat silos from one program; printed standard not seen; no published numbers: checked "
    "against geometry",
    colour="#D6604D",
    marker="+",
    table_key="en1991_4",
)
