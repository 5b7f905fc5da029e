"""Checks of the steel beside axial buckling: one file a member, with its row."""

from silostudy.catalogue import Family, members
from silostudy.checks.family import PARAMETERS, WALL, SteelCheck

CHECKS: Family[SteelCheck] = Family("steel check", members(__name__, SteelCheck))
BUCKLING = "buckling"  # by the rule at hand: what stands before the checks of the family
# what the stored solid, roof and snow give by themselves, with one safety factor on everything
OF_THE_SOLID = frozenset(
    {"yield_stress", "joint_efficiency", "partial_yield", "inner_radius", "thickness", "upper_internal_pressure"}
    | {"axial_wall_force", "wall_above", "shear_wall_force"}
)
# the checks that need no more than that: the shell stage makes these, the stage of the checks makes all
SOLID_CHECKS: Family[SteelCheck] = Family(
    "steel check", [row for row in CHECKS.values() if row.part == WALL and row.needs <= OF_THE_SOLID]
)
NAMES = (BUCKLING, *SOLID_CHECKS)
assert set(PARAMETERS) >= OF_THE_SOLID
