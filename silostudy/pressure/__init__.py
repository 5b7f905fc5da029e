"""Wall pressure theories and design codes: one file a member, with its row."""

from silostudy.catalogue import Family, members
from silostudy.pressure.family import PressureMethod

PRESSURE: Family[PressureMethod] = Family(
    "pressure method", members(__name__, PressureMethod), takes=lambda row: isinstance(row, PressureMethod)
)
