"""The packings: a family of initial arrangements of discs in a box, one file a member."""

from silostudy.catalogue import Family, members
from silostudy.packing.family import Packing

PACKINGS: Family[Packing] = Family("packing", members(__name__, Packing))
