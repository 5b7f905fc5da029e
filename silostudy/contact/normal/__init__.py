"""Laws of the normal force: one file a law, with its row."""

from silostudy.catalogue import Family, members
from silostudy.contact.family import NormalLaw

NORMAL: Family[NormalLaw] = Family("normal law", members(__name__, NormalLaw), takes=lambda row: isinstance(row, NormalLaw))
