"""Laws of twisting resistance, about the normal of a contact of two spheres: one file a law, with its row."""

from silostudy.catalogue import Family, members
from silostudy.contact.family import TwistingLaw

TWISTING: Family[TwistingLaw] = Family(
    "twisting law", members(__name__, TwistingLaw), takes=lambda row: isinstance(row, TwistingLaw)
)
