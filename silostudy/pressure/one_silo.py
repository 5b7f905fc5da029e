"""Limits of the methods that the source gives for one silo only: its proportions and, for charts, its friction."""

from silostudy.pressure.limits import LATERAL_PRESSURE_RATIO, SLENDERNESS, WALL_FRICTION, Limit

WHY = "the source's one silo"
TOLERANCE = 1e-6  # of a proportion, for numbers that were divided
# 18 m of cylinder over 5 m of diameter: inferred from Table 4.2.5, the source prints no size
PROPORTIONS = Limit(measure=SLENDERNESS, least=3.6, most=3.6, tolerance=TOLERANCE, phases=("discharge",), why=WHY)
# silo_handbook, Table 4.2.4
FRICTION = (
    Limit(measure=WALL_FRICTION, least=0.44, most=0.44, tolerance=TOLERANCE, phases=("discharge",), why=WHY),
    Limit(measure=LATERAL_PRESSURE_RATIO, least=0.45, most=0.45, tolerance=TOLERANCE, phases=("discharge",), why=WHY),
)
