"""A silo with its contents as a user writes it, in the user's units."""

from typing import Annotated, Any, Literal, Self, TypeAlias

from pydantic import Field, model_validator

from silostudy.config.fields import Strict, described
from silostudy.tables.ranges import WRITTEN
from silostudy.tables.walls import WALLS


def possible(written: str) -> dict[str, Any]:
    """The ends of a quantity's physical range, as the models take them."""
    return WRITTEN[written].constraints


WallKey: TypeAlias = Literal[tuple(WALLS)]  # type: ignore[valid-type]


class HopperConfig(Strict):
    """A hopper below the cylinder."""

    half_angle_deg: float = described(
        "hopper half angle from the vertical: of a cone, a pyramid or a wedge; below a rectangle that of the long walls, which "
        "the end walls meet in one apex",
        "deg",
        **possible("half_angle_deg"),
    )
    outlet_width_m: float = described(
        "inner width (diameter) of the outlet, below a rectangle its shorter side; 0: the apex", "m", ge=0, default=0.0
    )
    wall: WallKey | None = described("wall kind of the hopper; null: as the cylinder's", "", default=None)


class FlexibleWall(Strict):
    """Flexibility of a circular wall, for AS 3774's squat containers; it is not read off a shell's wall."""

    thickness_mm: float = described("thickness of the wall", "mm", gt=0)
    youngs_modulus_GPa: float = described("Young's modulus of the wall", "GPa", **possible("youngs_modulus_GPa"))
    solid_modulus_factor: float = described(
        "modulus of the stored solid over its vertical pressure: 70 for dry grain, 100 for small and 150 for large hard "
        "mineral particles (one source)",
        gt=0,
    )


class Cooling(Strict):
    """A wall that cools on its contents (AS 3774, one source)."""

    temperature_drop_K: float = described("how far the wall cools against the solid", "K", gt=0)
    expansion_per_K: float = described("thermal expansion of the wall: 1.2e-5 of steel", "K-1", gt=0, le=1e-3)


class RapidFilling(Strict):
    """A powder filled in faster than its air leaves (AS 3774, one source)."""

    rise_m_h: float = described("how fast the surface rises", "m h-1", gt=0)
    air_time_h: float = described(
        "c_F, how long the air stays: flour and ground phosphate 0.14, pulverised coal 0.15, cement 0.19, lime powder 0.36",
        "h",
        gt=0,
    )


class AnySilo(Strict):
    """Base of silos of every plan."""

    cylinder_depth_m: float | None = described(
        "depth of the vertical part, from the highest contact of solid and wall to the transition",
        "m",
        default=None,
        **possible("cylinder_depth_m"),
    )
    slenderness: float | None = described(
        "cylinder depth over the diameter of the circle inscribed in the plan, in place of cylinder_depth_m",
        default=None,
        **possible("slenderness"),
    )
    top_cone_height_m: float = described(
        "height of the heap above the highest wall contact; 0: a level surface. The equivalent flat surface lies a third of "
        "it up, over a slot half of it, over a rectangle between",
        "m",
        ge=0,
        default=0.0,
    )
    heap_at_repose: bool = described(
        "whether the heap stands at the solid's angle of repose, in place of top_cone_height_m", "", default=False
    )
    hopper: HopperConfig | None = described("the hopper; null: a flat bottom", "", default=None)
    filling_eccentricity_m: float = described("distance of the heap's top from the axis", "m", ge=0, default=0.0)
    outlet_eccentricity_m: float = described("distance of the outlet's middle from the axis", "m", ge=0, default=0.0)
    channel_half_angle_deg: float | None = described(
        "half angle of the flow channel from the vertical, for funnel flow; null: not known", "deg", gt=0, lt=90, default=None
    )

    flexible_wall: FlexibleWall | None = described(
        "the wall's stiffness, where it may lower the pressure (AS 3774, squat circular containers); null: a rigid wall",
        "",
        default=None,
    )
    cooling: Cooling | None = described("a cooling of the wall; null: none", "", default=None)
    rapid_filling: RapidFilling | None = described("a rapid filling; null: none", "", default=None)
    action_assessment_class: Literal[1, 2, 3] | None = described(
        "action assessment class of EN 1991-4: 1 the simplified rules may serve, 3 large eccentric discharge is a load case; "
        "null: not declared, the least one by capacity and outlet counts (`least_assessment_class`)",
        "",
        default=None,
    )
    dynamic_bottom_load: bool = described(
        "whether the solid may act dynamically on hopper or floor, as in slender silos with solids of more than low cohesion "
        "or of interlocking grains; EN 1991-4 then has C_b = 1.2 in place of 1.0 (one source)",
        "",
        default=False,
    )
    patch_of_low_silo: bool = described(
        "whether EN 1991-4's patch load of discharge in silos of h_c/d_c <= 1.2 is computed: one program has it, 0.272 C_op "
        "(h_c/d_c - 1 + 2 e/d_c), which jumps by two at 1.2",
        "",
        default=False,
    )

    @model_validator(mode="after")
    def _one_depth(self) -> Self:
        if (self.cylinder_depth_m is None) == (self.slenderness is None):
            raise ValueError("give either cylinder_depth_m or slenderness, and not both")
        return self

    @model_validator(mode="after")
    def _one_heap(self) -> Self:
        if self.heap_at_repose and self.top_cone_height_m:
            raise ValueError("give either top_cone_height_m or heap_at_repose, and not both")
        return self


class CircularSilo(AnySilo):
    """A circular cylinder."""

    plan: Literal["circular"] = described("shape of the plan", "")
    diameter_m: float = described("inner diameter", "m", **possible("diameter_m"))


class SquareSilo(AnySilo):
    """A square cell."""

    plan: Literal["square"] = described("shape of the plan", "")
    width_m: float = described("inner side", "m", **possible("diameter_m"))


class RectangularSilo(AnySilo):
    """A rectangular cell."""

    plan: Literal["rectangular"] = described("shape of the plan", "")
    width_m: float = described("shorter inner side", "m", **possible("diameter_m"))
    length_m: float = described("longer inner side", "m", **possible("diameter_m"))

    @model_validator(mode="after")
    def _ordered(self) -> Self:
        if self.length_m < self.width_m:
            raise ValueError("length_m must not be smaller than width_m")
        return self


class PolygonalSilo(AnySilo):
    """A regular polygon."""

    plan: Literal["polygonal"] = described("shape of the plan", "")
    sides: int = described("number of sides", ge=3, le=1000)
    inscribed_diameter_m: float = described(
        "diameter of the inscribed circle (across the flats)", "m", **possible("diameter_m")
    )


class SlotSilo(AnySilo):
    """A long slot between two parallel walls, end walls left out: plane flow, with a wedge below."""

    plan: Literal["slot"] = described("shape of the plan", "")
    width_m: float = described("inner width between the walls", "m", **possible("diameter_m"))
    length_m: float = described("stretch of the slot that forces are counted over", "m", gt=0, default=1.0)


Silo = Annotated[CircularSilo | SquareSilo | RectangularSilo | PolygonalSilo | SlotSilo, Field(discriminator="plan")]


def replacing(written: str, text: str, unit: str) -> Any:
    """A property that may replace the table's, within its physical range."""
    return described(text, unit, default=None, **possible(written))


class SolidProperties(Strict):
    """Values that replace the table's for the solid of this study."""

    unit_weight_kN_m3: float | None = replacing("unit_weight_kN_m3", "unit weight", "kN m-3")
    internal_friction_angle_deg: float | None = replacing("internal_friction_angle_deg", "internal friction angle", "deg")
    wall_friction: float | None = replacing("wall_friction", "wall friction coefficient; replaces the wall kind's", "1")
    lateral_pressure_ratio: float | None = replacing("lateral_pressure_ratio", "lateral pressure ratio K = p_h / p_v", "1")
    poisson_ratio: float | None = replacing("poisson_ratio", "Poisson's ratio of the solid", "1")
    hopper_wall_friction: float | None = replacing("hopper_wall_friction", "wall friction coefficient of the hopper", "1")
    unit_weight_lower_kN_m3: float | None = replacing("unit_weight_lower_kN_m3", "lower unit weight", "kN m-3")
    effective_friction_angle_deg: float | None = replacing(
        "effective_friction_angle_deg", "effective angle of friction in flow (Jenike's delta)", "deg"
    )
    repose_angle_deg: float | None = replacing("repose_angle_deg", "angle of repose", "deg")
    largest_particle_mm: float | None = replacing(
        "largest_particle_mm", "size of the largest particle; EN 1991-4 covers up to 0.03 of the silo's width", "mm"
    )
    a_phi: float | None = replacing("a_phi", "spread of the friction angle: upper over mean", "1")
    a_K: float | None = replacing("a_K", "spread of the lateral pressure ratio: upper over mean", "1")
    a_mu: float | None = replacing("a_mu", "spread of the wall friction: upper over mean", "1")
    patch_factor: float | None = replacing("patch_factor", "patch load factor C_op of EN 1991-4", "1")


FRICTION_ENDS = ("mean", "lower", "upper")
END_WORDS = (
    "upper: wall friction and lateral pressure ratio times their spreads a_mu and a_K, or on Pieper's roughness groups the "
    "roughness factor + 0.05: the largest axial force of a steel wall. lower: friction over a_mu, lateral pressure ratio times "
    "a_K: the largest pressure, which governs where hoop tension or the elephant's foot does"
)


class SceneConfig(Strict):
    """One silo, its wall and its contents."""

    silo: Silo = described("shape and size", "")
    solid: str = described("key of the stored solid (`silostudy list solids`, or of the study's materials file)", "")
    wall: WallKey | None = described(
        "wall kind, from which the wall friction follows; null: the solid's own tabulated wall friction",
        "",
        default=None,
    )
    lateral_pressure_ratio_rule: Literal["rankine", "one_minus_sine"] | None = described(
        "K from the internal friction angle: rankine (1 - sin)/(1 + sin), one_minus_sine 1 - sin; "
        "null: the table's K, and rankine where it has none",
        "",
        default=None,
    )
    wall_friction_end: Literal[FRICTION_ENDS] = described(  # type: ignore[valid-type]
        f"{END_WORDS}. Methods that vary them themselves (EN 1991-4's sets, Pieper for buckling) keep their own",
        "",
        default="mean",
    )
    characteristic_friction: Literal["capped", "uncapped"] = described(
        "capped: in EN 1991-4's sets of characteristic values mu is at most tan(phi) of the set; uncapped: it is not (public "
        "programs disagree)",
        "",
        default="capped",
    )
    wall_contact_share: float | None = described(
        "a_w, share of the surface of a corrugated wall on which the solid slides (EN 1991-4 wall category D4; AS 3774: crest "
        "over crest and trough, one source); on the rest it slides on itself; wall and properties.wall_friction are then "
        "those of the flat sheet; null: a flat wall",
        gt=0,
        le=1,
        default=None,
    )
    properties: SolidProperties = described("values that replace the table's", "", default=SolidProperties())
