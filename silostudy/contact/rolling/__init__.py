"""Laws of rolling resistance: one file a law, with its row."""

from silostudy.catalogue import Family, members
from silostudy.contact.family import RollingLaw

ROLLING: Family[RollingLaw] = Family(
    "rolling law", members(__name__, RollingLaw), takes=lambda row: isinstance(row, RollingLaw)
)
