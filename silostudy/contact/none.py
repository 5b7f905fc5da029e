"""The laws that do nothing: what a scene without friction, rolling resistance or cohesion compiles in."""

from numba.extending import register_jitable


@register_jitable
def sliding(stored, sliding, mass, dt, elastic, normal, c):
    """Tangential force (N/m) of a frictionless contact: zero."""
    return 0.0, 0.0


@register_jitable
def rolling(stored, rolling, dt, elastic, arm, c):
    """Moment (N m/m) of a contact without rolling resistance: zero."""
    return 0.0


@register_jitable
def cohesion(c):
    """Attraction (N/m) of a contact without cohesion: zero."""
    return 0.0
