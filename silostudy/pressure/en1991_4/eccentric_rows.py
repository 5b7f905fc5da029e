"""Large eccentric discharge of EN 1991-4:2006 as methods: the pressures of three zones of wall for three sizes of channel."""

from collections.abc import Callable

import numpy as np

from silostudy.pressure import janssen
from silostudy.pressure.calls import asking
from silostudy.pressure.en1991_4 import cylinder, eccentric, limits
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, VARIED, characteristic, described, used
from silostudy.pressure.en1991_4.on_wall import CYLINDER, STATE, take
from silostudy.pressure.family import CHANNEL_SIZES, CIRCULAR, PressureMethod
from silostudy.pressure.quadrature import double_exponential

MOVING = "channel"  # set of characteristic values in the channel
ZONES = ("channel", "static", "adjacent")
SLIDING = "Source: Coulomb's law of a solid that slides, with the mu of the zone's set; the pressures from en1991_4_2006."
SEEN = "Source: en1991_4_2006 (printed standard not seen; two public accounts agree)."
STATICS = "Source: equilibrium, from the zones' pressures."


def zones(z, static_set, given):
    """Pressures p_hce, p_hse, p_hae (Pa) at depth z (m) for one size of channel; static_set: of the solid at rest."""
    mu, k, phi = characteristic(MOVING, **take(given, PROPERTIES))
    moving = eccentric.channel_pressure(
        z, unit_weight=given["unit_weight"], radius=given["diameter"] / 2, size=given["channel_size"], mu=mu, k=k, phi=phi
    )
    mu, k, _ = characteristic(static_set, **take(given, PROPERTIES))
    static = cylinder.pressures(z, mu=mu, k=k, **take(given, STATE))[0]
    return moving, static, eccentric.adjacent_pressure(static=static, moving=moving)


def _in_zone(static_set, number, friction):
    sets = (MOVING, static_set, static_set)

    def function(z, **given):
        mu = characteristic(sets[number], **take(given, PROPERTIES))[0] if friction else 1.0
        return mu * zones(z, static_set, given)[number]

    what = f"Wall {'friction traction' if friction else 'normal pressure'} (Pa) in the {ZONES[number]} zone"
    return asking(function, (*CYLINDER, "channel_size"), f"{what} at depth z (m). {SLIDING if friction else SEEN}")


def _shape(given):
    """Angles theta_c, psi (rad) and eccentricity e_c (m) of the channel."""
    mu, _, phi = characteristic(MOVING, **take(given, PROPERTIES))
    return eccentric.channel(given["diameter"] / 2, given["channel_size"], mu, phi)


def _of_channel(number, doc):
    def function(**given):
        return _shape(given)[number]

    return asking(function, ("diameter", "channel_size", *PROPERTIES), f"{doc} {SEEN}", None)


def _radius(*, diameter, channel_size):
    """Radius r_c (m) of the channel: k_c r. Source: en1991_4_2006."""
    return channel_size * diameter / 2


def _resultant(static_set):
    def function(z, **given):
        moving, static, _ = zones(z, static_set, given)
        own = {"radius": given["diameter"] / 2, "half_width": _shape(given)[0]}
        return eccentric.resultant(**own, static=static, moving=moving)

    doc = f"Resultant of the pressures per metre of depth (N/m), away from the channel, at depth z (m). {STATICS}"
    return asking(function, (*CYLINDER, "channel_size"), doc)


def _summed(static_set, doc, lever: Callable):
    """The resultant times a lever, integrated from the highest wall contact to the transition."""
    level = _resultant(static_set)

    def function(**given):
        places, weights = double_exponential()
        depth = given["cylinder_depth"] - given["contact_depth"]
        z = given["contact_depth"] + depth * places
        return np.sum(level(z, **given) * lever(depth * (1 - places)) * weights, axis=-1, keepdims=True) * depth

    return asking(function, (*CYLINDER, "channel_size"), f"{doc} {STATICS}", None)


def _largest(static_set, number):
    def function(z, **given):
        by_size = [zones(z, static_set, given | {"channel_size": np.float64(size)}) for size in CHANNEL_SIZES]
        mu = characteristic(static_set, **take(given, PROPERTIES))[0]
        return np.max([values[2] for values in by_size], axis=0) * (1.0, mu)[number]

    what = ("Wall normal pressure (Pa)", "Wall friction traction (Pa)")[number]
    doc = f"{what} beside the flow channel at depth z (m), the largest of three channel sizes. {(SEEN, SLIDING)[number]}"
    return asking(function, CYLINDER, doc)


def channels(static_set):
    """Everything that is known of each size of channel: pressures by zone, the channel's shape, and what they sum to."""
    return {
        f"{zone}_{quantity}": _in_zone(static_set, number, friction)
        for number, zone in enumerate(ZONES)
        for quantity, friction in (("normal_pressure", False), ("friction_traction", True))
    } | {
        "channel_half_width": _of_channel(0, "Angle theta_c (rad) from the channel's axis to its edge on the wall."),
        "channel_eccentricity": _of_channel(2, "Distance e_c (m) of the channel's axis from the silo's."),
        "channel_radius": _radius,
        "channel_resultant": _resultant(static_set),
        "channel_shear": _summed(static_set, "Horizontal force (N) on the whole wall, away from the channel.", np.ones_like),
        "channel_moment": _summed(static_set, "Moment (N m) of that force about the transition.", lambda lever: lever),
    }


def case(key: str, title: str, static_set: str, colour: str, marker: str, **more) -> PressureMethod:
    """The row of the load case with one set of characteristic values for the solid at rest."""
    quantities = ("wall_normal_pressure", "wall_friction_traction")
    return PressureMethod(
        key=key,
        rank=160,
        title=title,
        source="en1991_4_2006",
        locator="as public programs carry it (printed standard not seen)",
        phases={"discharge": {quantity: _largest(static_set, place) for place, quantity in enumerate(quantities)}},
        channel={"discharge": channels(static_set)},
        static=janssen.normal_pressure,
        plans=CIRCULAR,
        varies=VARIED,
        values={
            "static and adjacent zone": described(static_set),
            "channel": described(MOVING),
            "every quantity": "unit weight upper; no C_h, C_w",
        },
        used={"discharge": dict.fromkeys(quantities, used(static_set))},
        formula="p_hce Janssen of a channel r_c = k_c r, k_c in 0.25, 0.40, 0.60, within theta_c of its axis; p_hse as after "
        "filling beyond 2 theta_c; p_hae = 2 p_hse - p_hce between; p_w = mu p_h; shear and moment by integration",
        colour=colour,
        marker=marker,
        table_key="en1991_4",
        not_computed=NOT_COMPUTED,
        **more,
    )


NOT_COMPUTED = (
    "large eccentricity of filling in very slender silos (from memory only)",
    "the moment of the wall friction, which differs from zone to zone, and the bending of the wall: a shell's own analysis",
)
SAID = (
    "a separate load case beside symmetric discharge; its pressures are local: wall_normal_pressure is that of the adjacent "
    "zone, the largest of the three channels, which do not hang on how eccentric the outlet is; the solid slides in every "
    "zone, with the wall friction of the zone's own set; printed standard not seen; no published numbers: checked against "
    "geometry"
)
ROWS = (
    case(
        "en1991_4_eccentric",
        "EN 1991-4:2006, large eccentric discharge",
        "wall_normal",
        "#D6604D",
        "+",
        limits=(*limits.ECCENTRIC, limits.ECCENTRIC_SLENDER),
        validity=SAID,
    ),
    case(
        "en1991_4_eccentric_squat",
        "EN 1991-4:2006, large eccentric discharge of squat and intermediate silos (one source)",
        "wall_normal",
        "#9E0142",
        "$q$",
        limits=(*limits.ECCENTRIC, limits.ECCENTRIC_LOW),
        validity=f"as for slender silos, with the static pressures of a lower one, as one program has it; {SAID}",
        on_request=True,
    ),
    case(
        "en1991_4_eccentric_friction",
        "EN 1991-4:2006, large eccentric discharge, friction set (one source)",
        "wall_friction",
        "#762A83",
        "$e$",
        limits=limits.ECCENTRIC,
        validity=f"the solid at rest with the set for the wall friction, as one program has it: for the axial force; {SAID}",
        on_request=True,
    ),
)
