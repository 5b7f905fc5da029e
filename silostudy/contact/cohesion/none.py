"""No cohesion."""

from numba.extending import register_jitable

from silostudy.contact.family import CohesionLaw
from silostudy.contact.sources import KIYAMA


@register_jitable
def law(touch, c):
    """Attraction (N/m) of a contact without cohesion: zero."""
    return 0.0


ROW = CohesionLaw(key="none", rank=1, title="No cohesion", source=KIYAMA, locator="eq. (8)", law=law, acts=False, measured=True)
