"""No tangential force: what a scene without friction compiles in."""

from numba.extending import register_jitable

from silostudy.contact.family import TangentialLaw
from silostudy.contact.sources import KIYAMA


@register_jitable
def law(stored, sliding, touch, elastic, normal, c):
    """Tangential force (N/m) of a frictionless contact: zero, as what it stores."""
    return stored, stored


ROW = TangentialLaw(key="none", rank=1, title="Frictionless", source=KIYAMA, locator="mu = 0", law=law, acts=False)
