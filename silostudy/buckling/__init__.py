"""Buckling strength of cylindrical shells under axial compression: one file a member, all of them listed here."""

from silostudy.buckling import (
    classical,
    en1993_1_6_2007,
    en1993_1_6_2025,
    en1993_4_1,
    miller1977,
    miller1977_rivals,
    nasa_sp8007,
)
from silostudy.buckling.family import BucklingRule
from silostudy.catalogue import Family

MEMBERS = (miller1977, classical, nasa_sp8007, en1993_1_6_2007, en1993_1_6_2025, en1993_4_1)

BUCKLING: Family[BucklingRule] = Family("buckling rule", [row for member in MEMBERS for row in member.ROWS])
# readings of a source that its own tests speak against, computed on request beside the rules
RIVALS: Family[BucklingRule] = Family("rival reading", miller1977_rivals.ROWS)
