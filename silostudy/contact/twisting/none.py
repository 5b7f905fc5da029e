"""No twisting resistance."""

from silostudy.contact.family import TwistingLaw
from silostudy.contact.rolling import none

ROW = TwistingLaw(
    key="none",
    rank=1,
    title="No twisting resistance",
    source=none.ROW.source,
    locator=none.ROW.locator,
    law=none.law,
    acts=False,
)
