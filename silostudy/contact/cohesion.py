"""Cohesion: attraction of two bodies in touch."""

from numba.extending import register_jitable


@register_jitable
def constant_pull(c):
    """Attraction (N/m) of two bodies while they touch: the same at every overlap; c = (pull,).

    Luding (2008), the simplest of the cohesive laws.
    """
    return c[0]
