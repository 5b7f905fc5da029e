"""Checks of a steel wall beside its buckling: one file a member, with its row."""

from silostudy.catalogue import Family, members
from silostudy.checks.family import SteelCheck

CHECKS: Family[SteelCheck] = Family("steel check", members(__name__, SteelCheck))
BUCKLING = "buckling"  # by the rule at hand: what stands before the checks of the family
NAMES = (BUCKLING, *CHECKS)
