"""Steel shells in SI units: a single cylinder, and the wall of a silo."""

from collections.abc import Callable
from dataclasses import dataclass, fields
from math import nan, pi, sqrt
from pathlib import Path
from typing import Any

from silostudy.config.buckling import BucklingStudy, TestCylinder
from silostudy.config.shell import BOTH, ShellStudy, SteelSilo
from silostudy.config.steel import Cylinder, Making, SiloWall, Steel
from silostudy.errors import BadInput
from silostudy.scene.build import pressure_builder
from silostudy.scene.earthquake import check_same_silo, read_earthquake
from silostudy.scene.expand import Expansion
from silostudy.scene.scene import Scene
from silostudy.scene.steelwork import steelwork
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.miller1977 import TESTS, MillerTest

QUALITY = {"A": 40.0, "B": 25.0, "C": 16.0}  # EN 1993-1-6: Q of the fabrication quality classes, second-hand transcription


@dataclass(frozen=True, kw_only=True)
class Shell:
    """One cylinder under axial compression, by the names of the buckling rules' parameters."""

    youngs_modulus: float
    shell_poisson_ratio: float
    yield_stress: float
    shell_radius: float
    thickness: float
    bay_length: float
    total_length: float
    ring_area: float
    fabricated: bool
    safe_constants: bool
    fabrication_quality: float
    end_factor: float
    lower_internal_pressure: float = 0.0
    upper_internal_pressure: float = 0.0
    test: MillerTest | None = None


def buckling_builder(study: BucklingStudy, folder: Path, where: str) -> Callable[..., Shell]:
    """Builds the shells of a buckling study."""
    return lambda config, settings: tested(config) if isinstance(config, TestCylinder) else cylinder(config)


def making(config: Making) -> dict[str, Any]:
    """Parameters that say how well a shell is made and how its ends are held."""
    return {"fabrication_quality": QUALITY[config.quality], "end_factor": float(config.end_factor)}


def steel(config: Steel) -> dict[str, Any]:
    """Parameters of the steel and of its making."""
    return {
        "youngs_modulus": config.youngs_modulus_GPa * 1e9,
        "shell_poisson_ratio": config.shell_poisson_ratio,
        "yield_stress": config.yield_stress_MPa * 1e6,
        "fabricated": config.manufacture != "manufactured",
        "safe_constants": config.manufacture == "fabricated_safe",
        **making(config),
    }


def tested(config: TestCylinder) -> Shell:
    """A test cylinder: the small ones count as manufactured, the large ones as fabricated; steel with nu = 0.3."""
    test = TESTS[config.test]
    sizes = ("youngs_modulus", "yield_stress", "shell_radius", "thickness", "bay_length", "total_length", "ring_area")
    return Shell(
        **{name: getattr(test, name) for name in sizes},
        **making(config),
        shell_poisson_ratio=0.3,
        fabricated=test.scale == "large",
        safe_constants=config.safe_constants,
        test=test,
    )


def cylinder(config: Cylinder) -> Shell:
    """A cylinder from its sizes or its ratios."""
    thickness = config.thickness_mm / 1e3 if config.thickness_mm else config.radius_m / (config.radius_over_thickness or 1)
    bay = config.bay_length_m or (config.relative_bay_length or 1) * sqrt(config.radius_m * thickness)
    area = config.ring_area_cm2 * 1e-4 if config.ring_area_cm2 else config.ring_area_ratio * bay * thickness
    lower, upper = config.lower_internal_pressure_kPa, config.upper_internal_pressure_kPa
    return Shell(
        **steel(config),
        shell_radius=config.radius_m,
        thickness=thickness,
        bay_length=bay,
        total_length=nan if area else bay,
        ring_area=area,
        lower_internal_pressure=lower * 1e3,
        upper_internal_pressure=(lower if upper is None else upper) * 1e3,
    )


@dataclass(frozen=True, kw_only=True)
class SteelWall:
    """The steel wall of a silo's cylinder.

    steel: parameters of the buckling rules and the checks by name; edges: depth of each strake's lower edge over the
    cylinder's height, with its thickness (m) beside it; bay_length: ring spacing (m), None without rings; unit_weight: of
    the steel (N m-3);
    roof_force, snow_force: axial force (N/m) of either.
    """

    steel: dict[str, float]
    edges: tuple[float, ...]
    thicknesses: tuple[float, ...]
    bay_length: float | None
    ring_area: float
    safety_factor: float
    unit_weight: float
    roof_force: float
    snow_force: float

    @property
    def imposed_force(self) -> float:
        """Axial force (N/m) of roof and snow."""
        return self.roof_force + self.snow_force


@dataclass(frozen=True, kw_only=True)
class ShellScene(Scene):
    """A silo with its contents and its steel wall; earthquake: the seismic study laid on it, as asked, or none.

    steelwork: parameters of the checks beside the wall's own, by name; NaN where nothing is given.
    edges: how the upper and the lower edge of the wall are held, where wind is given.
    """

    shell: SteelWall
    steelwork: dict[str, float]
    edges: tuple[str, str] | None = None
    earthquake: Expansion | None = None

    @property
    def plates(self) -> tuple[float, ...]:
        """Thicknesses (m) of the wall's strakes."""
        return self.shell.thicknesses


def shell_builder(study: ShellStudy, folder: Path, where: str) -> Callable[..., ShellScene]:
    """Builds the scenes of a shell study: those of a pressure study, each with its wall."""
    build = pressure_builder(study, folder, where)
    shaken = read_earthquake(study.earthquake, folder, where) if study.earthquake else None

    def build_one(config: SteelSilo, settings: dict) -> ShellScene:
        scene = build(config, settings)
        _require_wall(config, scene.silo.wall_depth, where)
        own = {item.name: getattr(scene, item.name) for item in fields(scene)}
        if shaken is not None:
            check_same_silo(scene, shaken.study.scene, where)
        steel_wall = wall(config.shell, scene.silo.diameter / 2)
        edges = (config.wind.upper_edge, config.wind.lower_edge) if config.wind else None
        return ShellScene(**own, shell=steel_wall, steelwork=steelwork(config), edges=edges, earthquake=shaken)

    return build_one


def _require_wall(config: SteelSilo, height: float, where: str) -> None:
    """BadInput for an end of the friction that is two, for a strake too thick for a shell, and for rings beyond the wall."""
    if config.wall_friction_end == BOTH:
        raise BadInput("wall_friction_end", BOTH, "is an axis of its own: sweep lower and upper", where)
    thickest = config.silo.diameter_m / 2 * 1e3
    for number, strake in enumerate(config.shell.strakes):
        if strake.thickness_mm >= thickest:
            allowed = f"must be below the silo's radius, {thickest:g} mm"
            raise BadInput(f"scene.shell.strakes.{number}.thickness_mm", strake.thickness_mm, allowed, where)
    rings = config.shell.rings
    if rings and rings.spacing_m > height:
        allowed = f"must not exceed the height of the wall, {height:g} m; leave out rings for none"
        raise BadInput("scene.shell.rings.spacing_m", rings.spacing_m, allowed, where)


def wall(config: SiloWall, inner_radius: float) -> SteelWall:
    """The wall that a configuration describes, of a cylinder of this radius (m); roof and snow rest on its top all round."""
    return SteelWall(
        steel={**steel(config), "joint_efficiency": config.joint_efficiency},
        edges=tuple(strake.down_to for strake in config.strakes),
        thicknesses=tuple(strake.thickness_mm / 1e3 for strake in config.strakes),
        bay_length=config.rings.spacing_m if config.rings else None,
        ring_area=config.rings.area_cm2 * 1e-4 if config.rings else 0.0,
        safety_factor=config.safety_factor,
        unit_weight=config.density_kg_m3 * STANDARD_GRAVITY,
        roof_force=config.roof_kN * 1e3 / (2 * pi * inner_radius),
        snow_force=config.snow_kPa * 1e3 * inner_radius / 2,
    )
