"""Laws of the tangential force: one file a law, with its row."""

from silostudy.catalogue import Family, members
from silostudy.contact.family import TangentialLaw

TANGENTIAL: Family[TangentialLaw] = Family(
    "tangential law", members(__name__, TangentialLaw), takes=lambda row: isinstance(row, TangentialLaw)
)
