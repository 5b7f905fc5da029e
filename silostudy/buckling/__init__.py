"""Buckling strength of cylindrical shells under axial compression: one file a member, with its rows."""

from silostudy.buckling.family import BucklingRule
from silostudy.catalogue import Family, Row, members


def _is_rule(row: Row) -> bool:
    return isinstance(row, BucklingRule) and not row.rival_of


def _is_rival(row: Row) -> bool:
    return isinstance(row, BucklingRule) and bool(row.rival_of)


_ROWS = members(__name__, BucklingRule)

BUCKLING: Family[BucklingRule] = Family("buckling rule", filter(_is_rule, _ROWS), takes=_is_rule)
# readings of a source that its own tests speak against, computed on request beside the rules
RIVALS: Family[BucklingRule] = Family("rival reading", filter(_is_rival, _ROWS), takes=_is_rival)
