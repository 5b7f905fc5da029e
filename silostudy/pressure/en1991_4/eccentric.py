"""Large eccentric discharge of EN 1991-4:2006: a flow channel along the wall of a circular silo.

Printed standard not seen; agrees in two or more public programs.  Three sizes of channel are looked at, r_c = k_c r.
"""

import numpy as np

from silostudy.errors import BadInput
from silostudy.pressure import janssen
from silostudy.pressure.en1991_4.characteristic import PROPERTIES, characteristic
from silostudy.pressure.family import CIRCULAR, PressureMethod, asking

CHANNEL_SIZES = (0.25, 0.40, 0.60)  # k_c
GIVEN = ("unit_weight", "hydraulic_radius", "diameter", *PROPERTIES)


def channel(radius, size, mu, phi):
    """(theta, psi (rad), e_c (m)): wall contact angle, contact angle seen from the channel, eccentricity.

    Source: en1991_4_2006: eta = mu/tan(phi), e_c/r = eta (1 - k_c) + (1 - eta) sqrt(1 - k_c),
    cos theta = (r^2 + e_c^2 - r_c^2)/(2 r e_c), sin psi = (r/r_c) sin theta.
    """
    eta = mu / np.tan(phi)
    eccentricity = eta * (1 - size) + (1 - eta) * np.sqrt(1 - size)  # over r
    cosine = (1 + eccentricity**2 - size**2) / (2 * eccentricity)
    if np.any(np.abs(cosine) > 1 + 1e-12):
        raise BadInput(
            "wall_friction", float(np.max(mu)), "must not exceed tan(phi): no real flow channel", "eccentric discharge"
        )
    theta = np.arccos(np.minimum(cosine, 1.0))
    return theta, np.arcsin(np.minimum(np.sin(theta) / size, 1.0)), eccentricity * radius


def channel_pressure(z, *, unit_weight, radius, size, mu, k, phi):
    """p_hce (Pa) on the wall of the flow channel at depth z (m).

    Source: en1991_4_2006: Janssen in the channel, rubbing on the wall over U_wc = 2 theta r with mu and on the resting
    solid over U_sc = 2 r_c (pi - psi) with tan(phi); A_c = (pi - psi) r_c^2 + theta r^2 - r r_c sin(psi - theta).
    """
    theta, psi, _ = channel(radius, size, mu, phi)
    inner = size * radius
    area = (np.pi - psi) * inner**2 + theta * radius**2 - radius * inner * np.sin(psi - theta)
    resistance = 2 * theta * radius * mu + 2 * inner * (np.pi - psi) * np.tan(phi)
    return janssen.normal_pressure(
        z, unit_weight=unit_weight, hydraulic_radius=area / resistance, wall_friction=1.0, lateral_pressure_ratio=k
    )


def edge_pressure(z, *, static, moving):
    """p_hae (Pa) beside the channel, from theta to 2 theta: 2 p_hse - p_hce. Source: en1991_4_2006."""
    return 2 * static - moving


def _largest_edge_pressure(z, **given):
    mu, k, phi = characteristic("wall_normal", **{name: given[name] for name in PROPERTIES})
    weight = {"unit_weight": given["unit_weight"]}
    static = janssen.normal_pressure(
        z, **weight, hydraulic_radius=given["hydraulic_radius"], wall_friction=mu, lateral_pressure_ratio=k
    )
    moving = [
        channel_pressure(z, **weight, radius=given["diameter"] / 2, size=size, mu=mu, k=k, phi=phi) for size in CHANNEL_SIZES
    ]
    return edge_pressure(z, static=static, moving=np.min(moving, axis=0))


ROW = PressureMethod(
    key="en1991_4_eccentric",
    rank=160,
    title="EN 1991-4:2006, large eccentric discharge",
    source="en1991_4_2006",
    locator="as public programs carry it (printed standard not seen)",
    phases={
        "discharge": {
            "wall_normal_pressure": asking(
                _largest_edge_pressure,
                GIVEN,
                "Wall normal pressure (Pa) beside the flow channel at depth z (m), the largest of three channel sizes. "
                "Source: en1991_4_2006.",
            )
        }
    },
    static=janssen.normal_pressure,
    plans=CIRCULAR,
    values={"wall_normal_pressure": "mu lower, K upper, phi lower, unit weight upper"},
    not_computed=("when this load case is asked for (eccentricity, action assessment class): the user chooses",),
    formula="p_hae = 2 p_hse - p_hce beside a channel r_c = k_c r, k_c in 0.25, 0.40, 0.60; p_hse Janssen of the whole silo, "
    "p_hce Janssen of the channel",
    validity="circular silos; local pressure on the stretch of wall from theta to 2 theta; which characteristic values the "
    "standard takes here was not verified (those for the wall pressure are used); printed standard not seen; no published "
    "numbers: checked against geometry",
    colour="#D6604D",
    marker="+",
    table_key="en1991_4",
)
