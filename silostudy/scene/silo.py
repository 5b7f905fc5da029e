"""Shape and size of a silo in SI units."""

from dataclasses import dataclass
from math import nan, pi, tan


@dataclass(frozen=True, kw_only=True)
class Hopper:
    """A hopper: half angle from the vertical (rad) and inner width of its outlet (m)."""

    half_angle: float
    outlet_width: float


@dataclass(frozen=True, kw_only=True)
class Silo:
    """Inner dimensions (m) of a vertical cylinder of any plan, with the heap on top and the hopper below.

    diameter is that of the circle inscribed in the plan; length the longer side of a rectangle, or the stretch of a slot that
    forces are counted over; sides a polygon's.  A circle has a cone below it, a slot a wedge.
    """

    plan: str
    diameter: float
    wall_depth: float  # from the highest contact of solid and wall to the transition
    length: float = 0.0
    sides: int = 0
    top_cone_height: float = 0.0
    hopper: Hopper | None = None
    filling_eccentricity: float = 0.0  # of the heap
    outlet_eccentricity: float = 0.0
    channel_half_angle: float = nan  # of the flow channel in funnel flow (rad)
    wall_flexibility: float = 0.0  # 1/(E_w t) of the wall (m N-1); 0: rigid
    solid_modulus_factor: float = 0.0  # chi: modulus of the solid over its vertical pressure
    cooling_strain: float = 0.0  # alpha dT of a cooling wall
    fluid_depth: float = 0.0  # c_F v_F (m) in rapid filling
    assessment_class: int = 0  # declared action assessment class of EN 1991-4; 0: none
    dynamic_bottom: bool = False  # the solid may act dynamically on the bottom
    low_patch: bool = False  # the discharge patch of h_c/d_c <= 1.2, of one source, is asked for

    @property
    def area(self) -> float:
        """Area of the plan (m2)."""
        return self.hydraulic_radius * self.perimeter

    @property
    def perimeter(self) -> float:
        """Perimeter of the plan (m)."""
        if self.plan == "circular":
            return pi * self.diameter
        if self.plan == "slot":
            return 2 * self.length
        if self.plan == "polygonal":
            return self.sides * self.diameter * tan(pi / self.sides)
        return 2 * (self.diameter + (self.length or self.diameter))

    @property
    def hydraulic_radius(self) -> float:
        """Area over perimeter (m): a quarter of the inscribed diameter where the plan has one, half a slot's width."""
        if self.plan == "rectangular":
            return self.diameter * self.length / self.perimeter
        return self.diameter / (2 if self.plan == "slot" else 4)

    @property
    def volume(self) -> float:
        """Volume (m3) of the contents, down to the outlet."""
        if self.hopper is None:
            return self.area * self.cylinder_depth
        power, left = 2 if self.plan == "slot" else 3, self.hopper.outlet_width / self.diameter
        apex_height = self.diameter / 2 / tan(self.hopper.half_angle)
        return self.area * (self.cylinder_depth + apex_height * (1 - left**power) / power)

    @property
    def contact_depth(self) -> float:
        """Depth (m) of the highest wall contact below the equivalent flat surface, to which the heap levels out.

        A third of a cone's or pyramid's height, half of a ridge's; a rectangle's hip roof of one slope lies between.
        """
        if self.plan == "slot":
            return self.top_cone_height / 2
        ends = self.diameter / self.length if self.plan == "rectangular" else 1.0
        return self.top_cone_height * (3 - ends) / 6

    @property
    def cylinder_depth(self) -> float:
        """Depth (m) of the transition below the equivalent flat surface."""
        return self.wall_depth + self.contact_depth

    @property
    def hopper_height(self) -> float:
        """Height (m) of the transition above the outlet; 0 over a flat bottom."""
        if self.hopper is None:
            return 0.0
        return (self.diameter - self.hopper.outlet_width) / 2 / tan(self.hopper.half_angle)

    @property
    def outlet_depth(self) -> float:
        """Depth (m) of the outlet below the equivalent flat surface."""
        return self.cylinder_depth + self.hopper_height
