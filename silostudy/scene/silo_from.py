"""Builds the silo in SI from the user's units, the same for the codes, the shell and the grains."""

from math import isnan, nan, radians, tan

from silostudy.config.scene import AnySilo, FlexibleWall
from silostudy.errors import BadInput
from silostudy.scene.silo import Hopper, Silo


def _flexibility(wall: FlexibleWall | None) -> dict[str, float]:
    """Flexibility of a silo's wall; none of a rigid one."""
    if wall is None:
        return {}
    stiffness = wall.youngs_modulus_GPa * 1e9 * wall.thickness_mm / 1e3
    return {"wall_flexibility": 1 / stiffness, "solid_modulus_factor": wall.solid_modulus_factor}


def _heap(config: AnySilo, diameter: float, repose_angle: float, where: str) -> float:
    """Height (m) of the heap above the highest wall contact."""
    if not config.heap_at_repose:
        return config.top_cone_height_m
    if isnan(repose_angle):
        allowed = "the solid has no angle of repose: give scene.properties.repose_angle_deg"
        raise BadInput("scene.silo.heap_at_repose", True, allowed, where)
    return diameter / 2 * tan(repose_angle)


def silo_of(config: AnySilo, repose_angle: float, where: str, section: str = "scene.") -> Silo:
    """The silo in SI; repose_angle (rad): of the solid, nan where it has none; section: in which its keys stand."""
    sizes = config.model_dump()
    diameter = next(sizes[name] for name in ("diameter_m", "width_m", "inscribed_diameter_m") if name in sizes)
    depth = config.cylinder_depth_m or (config.slenderness or 0.0) * diameter
    hopper = None
    if config.hopper:
        if config.hopper.outlet_width_m >= diameter:
            allowed = f"must be smaller than the silo's width, {diameter:g} m"
            raise BadInput(f"{section}silo.hopper.outlet_width_m", config.hopper.outlet_width_m, allowed, where)
        hopper = Hopper(half_angle=radians(config.hopper.half_angle_deg), outlet_width=config.hopper.outlet_width_m)
    return Silo(
        plan=sizes["plan"],
        diameter=diameter,
        length=sizes.get("length_m", 0.0),
        sides=sizes.get("sides", 0),
        wall_depth=depth,
        top_cone_height=_heap(config, diameter, repose_angle, where),
        hopper=hopper,
        filling_eccentricity=config.filling_eccentricity_m,
        outlet_eccentricity=config.outlet_eccentricity_m,
        channel_half_angle=radians(config.channel_half_angle_deg or nan),
        **_flexibility(config.flexible_wall),
        cooling_strain=config.cooling.temperature_drop_K * config.cooling.expansion_per_K if config.cooling else 0.0,
        fluid_depth=config.rapid_filling.rise_m_h * config.rapid_filling.air_time_h if config.rapid_filling else 0.0,
        assessment_class=config.action_assessment_class or 0,
        dynamic_bottom=config.dynamic_bottom_load,
        low_patch=config.patch_of_low_silo,
    )
