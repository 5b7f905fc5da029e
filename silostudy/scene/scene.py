"""One silo with its wall and contents, and the parameters that a pressure method is handed."""

from collections.abc import Collection, Sequence
from dataclasses import dataclass, field
from math import cos, isnan, nan, sin, tan

import numpy as np

from silostudy.pressure.corrugated import corrugated_friction
from silostudy.pressure.family import PressureMethod
from silostudy.scene.silo import Silo
from silostudy.tables.solids import CATEGORIES, PROPERTIES, SolidRow
from silostudy.tables.walls import WallRow

PIEPER_BUCKLING = 0.05  # added to the roughness factor where the shell may buckle
K_RULES = {
    "rankine": lambda phi: (cos(phi) / (1 + sin(phi))) ** 2,
    "one_minus_sine": lambda phi: cos(phi) ** 2 / (1 + sin(phi)),
}


@dataclass(frozen=True, kw_only=True)
class Scene:
    """A silo, its contents and what loads it, in SI units; `own` holds the user's values in place of the table's."""

    silo: Silo
    solid: SolidRow
    wall: WallRow | None = None
    hopper_wall: WallRow | None = None
    lateral_pressure_ratio_rule: str | None = None
    wall_friction_end: str = "mean"
    characteristic_friction: str = "capped"
    contact_share: float = 1.0  # of the wall surface on which the solid slides; below 1 on a corrugated wall
    own: dict[str, float] = field(default_factory=dict)

    @property
    def plates(self) -> tuple[float, ...]:
        """Thicknesses (m) of a steel wall's strakes; none where the silo has no such wall."""
        return ()

    @property
    def on_roughness_group(self) -> bool:
        """Whether the wall friction follows from one of Pieper's roughness groups."""
        return self.wall is not None and self.wall.rule == "angle_ratio" and "wall_friction" not in self.own


def solid_parameters(scene: Scene, method: str, as_printed: bool = False, varies: Collection[str] = ()) -> dict[str, float]:
    """Properties (SI) of the solid and its wall as a method takes them; NaN for what is not known.

    Order: the table, then the method's own values, then its misprints (on request), then the user's.  What the method itself
    varies, the scene's end of the wall friction leaves as it is.
    """
    row = scene.solid
    printed = row.as_printed.get(method, {}) if as_printed else {}
    values = {**_table_values(row), **row.by_method.get(method, {}), **printed, **scene.own}
    phi = values["internal_friction_angle"]
    if scene.wall is not None and "wall_friction" not in scene.own:
        values["wall_friction"] = wall_friction(scene.wall, row, phi)
    rule = scene.lateral_pressure_ratio_rule
    if "lateral_pressure_ratio" not in scene.own and (rule or isnan(values["lateral_pressure_ratio"])):
        values["lateral_pressure_ratio"] = K_RULES[rule or "rankine"](phi)
    if scene.wall_friction_end != "mean" and "wall_friction" not in varies:
        values |= friction_at_end(scene, values)
    values["hopper_wall_friction_uncapped"] = _hopper_friction(scene, values)
    values["hopper_wall_friction"] = capped(values["hopper_wall_friction_uncapped"], phi)
    values["wall_friction_uncapped"] = values["wall_friction"]
    values["wall_friction"] = capped(values["wall_friction"], phi)
    if scene.contact_share < 1 and "contact_share" not in varies:
        values["wall_friction"] = float(corrugated_friction(values["wall_friction"], phi, scene.contact_share))
    return values


def friction_at_end(scene: Scene, values: dict[str, float]) -> dict[str, float]:
    """Wall friction and lateral pressure ratio (1) at an end of their scatter.

    Upper: the largest axial force of a wall.  Lower friction with the upper lateral pressure ratio: the largest pressure, under
    which the foot of a wall yields.  Source: silo_handbook, section 4.5.1 (Pieper: roughness factor + 0.05, upper end only);
    else the mean values by their spreads, as EN 1991-4 does (second-hand); NaN where a spread is not known.  The spreads are
    then counted, and 1 for whatever method asks for them.
    """
    if scene.wall is not None and scene.on_roughness_group:
        rough = scene.wall.factors.get(scene.solid.grain, nan) + PIEPER_BUCKLING
        return {"wall_friction": tan(rough * values["internal_friction_angle"])}
    a_mu, a_K = (values.get(spread, nan) for spread in ("a_mu", "a_K"))
    return {
        "wall_friction": values["wall_friction"] * (a_mu if scene.wall_friction_end == "upper" else 1 / a_mu),
        "lateral_pressure_ratio": values["lateral_pressure_ratio"] * a_K,
        "a_mu": 1.0,
        "a_K": 1.0,
    }


def _table_values(row: SolidRow) -> dict[str, float]:
    names = [name for name in PROPERTIES if name not in ("wall_friction_angle", "i_phi", *CATEGORIES)]
    return {
        "i_phi": nan,
        "largest_particle": nan,
        "powder": float(row.grain == "powder"),
        **{name: getattr(row, name) for name in names},
    }


def _hopper_friction(scene: Scene, values: dict[str, float]) -> float:
    """Wall friction coefficient (1) of the hopper: the user's, its own wall kind's, or the cylinder's."""
    own, wall = scene.own.get("hopper_wall_friction"), scene.hopper_wall
    if own is not None or wall is None:
        return values["wall_friction"] if own is None else own
    return wall_friction(wall, scene.solid, values["internal_friction_angle"])


def wall_friction(wall: WallRow, solid: SolidRow, phi: float) -> float:
    """Wall friction coefficient (1) of a solid on a wall kind; NaN where the source's table has a dash.

    Source: silo_handbook, Table 4.2.2 (ratio of tangents) and section 4.5.1 Table 1 (ratio of angles); en1991_4_2006,
    Table E.1 (the solid's own value in a wall category).
    """
    if wall.rule == "category":
        return getattr(solid, wall.key)
    factor = wall.factors.get(solid.grain, nan)
    return factor * tan(phi) if wall.rule == "friction_ratio" else tan(factor * phi)


def capped(friction: float, phi: float) -> float:
    """Wall friction (1), at most tan(phi): beyond it the solid slides on itself. Source: silo_handbook, 4.2.2 (a)."""
    return friction if isnan(friction) else min(friction, tan(phi))


def geometry_parameters(scene: Scene) -> dict[str, float]:
    """Dimensions (m, rad) that a method may ask for; NaN where there is no hopper or no flow channel is given."""
    silo = scene.silo
    names = ("hydraulic_radius", "diameter", "cylinder_depth", "outlet_depth", "top_cone_height", "length", "perimeter")
    return {
        **{name: getattr(silo, name) for name in names},
        "circular": float(silo.plan == "circular"),
        "slot": float(silo.plan == "slot"),
        "end_ratio": silo.length / silo.diameter if silo.plan == "rectangular" else 1.0,
        "hopper_half_angle": silo.hopper.half_angle if silo.hopper else nan,
        "outlet_width": silo.hopper.outlet_width if silo.hopper else nan,
        "contact_depth": silo.contact_depth,
        "filling_eccentricity": silo.filling_eccentricity,
        "outlet_eccentricity": silo.outlet_eccentricity,
        "contact_share": scene.contact_share,
        "sets_capped": float(scene.characteristic_friction == "capped"),
        "channel_half_angle": silo.channel_half_angle,
        "wall_flexibility": silo.wall_flexibility,
        "solid_modulus_factor": silo.solid_modulus_factor,
        "cooling_strain": silo.cooling_strain,
        "fluid_depth": silo.fluid_depth,
        "volume": silo.volume,
        "assessment_class": float(silo.assessment_class),
        "dynamic_bottom": float(silo.dynamic_bottom),
        "low_patch": float(silo.low_patch),
    }


def parameters_of_scenes(scenes: Sequence[Scene], row: PressureMethod, as_printed: bool = False) -> dict[str, np.ndarray]:
    """Every parameter that a method may ask for, in SI, and the plan's shape under `plan`: arrays of shape (scene, 1)."""
    key = row.table_key or row.key
    rows = [
        {"plan": scene.silo.plan, **geometry_parameters(scene), **solid_parameters(scene, key, as_printed, row.varies)}
        for scene in scenes
    ]
    return {name: np.array([[numbers[name]] for numbers in rows]) for name in rows[0]}
