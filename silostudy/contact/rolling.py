"""Rolling resistance of discs."""

from numba.extending import register_jitable

from silostudy.contact.sliding import clamp


@register_jitable
def spring_slider(stored, rolling, dt, elastic, arm, c):
    """Moment (N m/m) that resists the difference of the spins (rad/s): a rotational spring behind a slider.

    Iwashita & Oda (1998) without the dashpot; arm (m) is the reduced radius;
    c = (rotational stiffness, rolling friction), the cap being friction times arm times the elastic normal force.
    """
    return clamp(stored - c[0] * dt * rolling, c[1] * arm * elastic)
