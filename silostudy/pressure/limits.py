"""The measures that several pressure methods set limits on."""

from silostudy.limits import Limit, Measure, broken

__all__ = ["DIAMETER", "LATERAL_PRESSURE_RATIO", "RELATIVE_DEPTH", "SLENDERNESS", "WALL_FRICTION", "Limit", "Measure", "broken"]


def _slenderness(*, cylinder_depth, diameter):
    return cylinder_depth / diameter


SLENDERNESS = Measure("h_c/d_c", "1", _slenderness)
WALL_FRICTION = Measure("mu", "1", lambda *, wall_friction: wall_friction)
LATERAL_PRESSURE_RATIO = Measure("K", "1", lambda *, lateral_pressure_ratio: lateral_pressure_ratio)
DIAMETER = Measure("d_c", "m", lambda *, diameter: diameter)
RELATIVE_DEPTH = Measure("z/D", "1", lambda z, *, diameter: z / diameter)
