"""Large eccentric discharge of EN 1991-4:2006: a flow channel along the wall of a circular silo.

Printed standard not seen; agrees in two or more public programs.  Three sizes of channel are looked at, r_c = k_c r: each is a
load case.  theta counts from the channel's axis: the channel within theta_c, the adjacent zone to 2 theta_c, beyond it the
static zone.  Neither theta_c nor e_c hangs on the outlet's actual eccentricity.
"""

import numpy as np

from silostudy.errors import BadInput
from silostudy.pressure import janssen


def channel(radius, size, mu, phi):
    """Wall contact angle theta, contact angle psi seen from the channel (rad), and eccentricity e_c (m) of the flow channel.

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


def section(radius, size, mu, phi):
    """Area A_c (m2) of the channel, and its contact with the wall U_wc and with the solid at rest U_sc (m).

    Source: en1991_4_2006: A_c = (pi - psi) r_c^2 + theta r^2 - r r_c sin(psi - theta), U_wc = 2 theta r,
    U_sc = 2 r_c (pi - psi).
    """
    theta, psi, _ = channel(radius, size, mu, phi)
    inner = size * radius
    area = (np.pi - psi) * inner**2 + theta * radius**2 - radius * inner * np.sin(psi - theta)
    return area, 2 * theta * radius, 2 * inner * (np.pi - psi)


def channel_pressure(z, *, unit_weight, radius, size, mu, k, phi):
    """Pressure p_hce (Pa) on the wall of the flow channel at depth z (m).

    Source: en1991_4_2006: Janssen in the channel, rubbing on the wall over U_wc with mu and on the resting solid over U_sc
    with tan(phi).
    """
    area, wall, inner = section(radius, size, mu, phi)
    resistance = wall * mu + inner * np.tan(phi)
    return janssen.normal_pressure(
        z, unit_weight=unit_weight, hydraulic_radius=area / resistance, wall_friction=1.0, lateral_pressure_ratio=k
    )


def resultant(*, radius, half_width, static, moving):
    """Resultant (N/m) of the pressures round a ring, away from the channel: 4 r (p_hse - p_hce) sin theta (1 - cos theta).

    Source: equilibrium: the integral of p cos(angle) r over the three zones; en1991_4_2006 gives the zones alone.
    """
    return 4 * radius * (static - moving) * np.sin(half_width) * (1 - np.cos(half_width))


def adjacent_pressure(*, static, moving):
    """Pressure p_hae (Pa) beside the channel, from theta_c to 2 theta_c: 2 p_hse - p_hce. Source: en1991_4_2006.

    With it the mean round the ring is the static pressure.
    """
    return 2 * static - moving
