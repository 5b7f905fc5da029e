"""No rolling resistance."""

from numba.extending import register_jitable

from silostudy.contact.family import RollingLaw
from silostudy.contact.sources import KIYAMA


@register_jitable
def law(stored, rolling, touch, elastic, c):
    """Stored and total moment (N m/m) of a contact without rolling resistance: zero."""
    return stored, stored


ROW = RollingLaw(
    key="none", rank=1, title="No rolling resistance", source=KIYAMA, locator="eq. (15c)", law=law, acts=False, measured=True
)
