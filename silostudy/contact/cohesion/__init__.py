"""Laws of cohesion: one file a law, with its row."""

from silostudy.catalogue import Family, members
from silostudy.contact.family import CohesionLaw

COHESION: Family[CohesionLaw] = Family(
    "cohesion law", members(__name__, CohesionLaw), takes=lambda row: isinstance(row, CohesionLaw)
)
