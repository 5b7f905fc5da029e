"""From the user's units to a frozen scene in SI, with the checks that need a table or two values at once."""

import json
from collections.abc import Callable
from math import isnan, nan, radians, tan
from pathlib import Path
from typing import Any

from silostudy.catalogue import Family
from silostudy.config.pressure import PressureStudy
from silostudy.config.scene import AnySilo, FlexibleWall, SceneConfig
from silostudy.errors import BadInput
from silostudy.scene.possible import require_possible
from silostudy.scene.scene import Scene, solid_parameters
from silostudy.scene.silo import Hopper, Silo
from silostudy.tables.solids import SOLIDS, SolidRow, own_solids
from silostudy.tables.units import split_unit
from silostudy.tables.walls import WALLS

# what a sampled study needs to know of the solid's scatter, and how a user writes it
SPREADS = {"a_phi": "a_phi", "a_K": "a_K", "a_mu": "a_mu", "unit_weight_lower": "unit_weight_lower_kN_m3"}


def pressure_builder(study: PressureStudy, folder: Path, where: str) -> Callable[[SceneConfig, dict], Scene]:
    """Builds the scenes of a pressure study: with the user's materials, and no depth below the transition."""
    solids = own_solids(folder / study.materials) if study.materials else SOLIDS

    def build_one(config: SceneConfig, settings: dict[str, Any]) -> Scene:
        scene = build(config, solids, where)
        if study.depth_m is not None and study.depths[-1] > scene.silo.cylinder_depth * (1 + 1e-12):
            allowed = f"the transition lies at {scene.silo.cylinder_depth:g} m"
            if settings:
                allowed += f" in the case {json.dumps(settings)}; use relative_depth where heights differ"
            raise BadInput("depth_m", study.depths[-1], allowed, where)
        if study.uncertainty is not None:
            _require_spreads(scene, where)
        return scene

    return build_one


def _require_spreads(scene: Scene, where: str) -> None:
    """BadInput unless the solid's scatter is known, and that of its friction on the wall."""
    if scene.contact_share < 1:
        allowed = "how the friction of a corrugated wall scatters is not known: uncertainty needs a flat wall"
        raise BadInput("scene.wall_contact_share", scene.contact_share, allowed, where)
    values = solid_parameters(scene, "")
    for name, written in SPREADS.items():
        if isnan(values[name]):
            allowed = f"solid {scene.solid.key} has none of its own: uncertainty needs it"
            raise BadInput(f"scene.properties.{written}", None, allowed, where)


def build(config: SceneConfig, solids: Family[SolidRow], where: str = "") -> Scene:
    """The scene that a configuration describes; BadInput for an unknown solid, no wall friction or an impossible shape."""
    if config.solid not in solids:
        raise BadInput("scene.solid", config.solid, f"unknown; known: {', '.join(solids)}", where)
    own = {}
    for name, value in config.properties.model_dump(exclude_none=True).items():
        quantity, _, factor = split_unit(name)
        own[quantity] = value * factor
    scene = Scene(
        silo=_silo(config.silo, own.get("repose_angle", solids[config.solid].repose_angle), where),
        solid=solids[config.solid],
        wall=WALLS[config.wall] if config.wall else None,
        lateral_pressure_ratio_rule=config.lateral_pressure_ratio_rule,
        wall_friction_end=config.wall_friction_end,
        characteristic_friction=config.characteristic_friction,
        contact_share=1.0 if config.wall_contact_share is None else config.wall_contact_share,
        own=own,
        hopper_wall=WALLS[config.silo.hopper.wall] if config.silo.hopper and config.silo.hopper.wall else None,
    )
    if scene.wall is None and "wall_friction" not in own and isnan(scene.solid.wall_friction):
        allowed = f"solid {config.solid} has no wall friction of its own: choose a wall kind ({', '.join(WALLS)})"
        raise BadInput("scene.wall", None, f"{allowed} or give scene.properties.wall_friction", where)
    require_possible(scene, where)
    _require_end(scene, where)
    return scene


def _require_end(scene: Scene, where: str) -> None:
    """BadInput where the end of the wall friction that is asked for is not known."""
    end = scene.wall_friction_end
    if end == "lower" and scene.on_roughness_group:
        allowed = "Pieper's roughness groups have no lower end: give scene.properties.wall_friction, a_mu and a_K"
        raise BadInput("scene.wall_friction_end", end, allowed, where)
    if end != "mean" and not scene.on_roughness_group and not _spreads_known(scene):
        allowed = "needs one of Pieper's roughness groups as wall, or scene.properties.a_mu and a_K"
        raise BadInput("scene.wall_friction_end", end, allowed, where)


def _spreads_known(scene: Scene) -> bool:
    """Whether wall friction and lateral pressure ratio have ends."""
    values = solid_parameters(scene, "")
    return not (isnan(values["wall_friction"]) or isnan(values["lateral_pressure_ratio"]))


def _flexibility(wall: FlexibleWall | None) -> dict[str, float]:
    """How a silo's wall gives way; nothing of a rigid one."""
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


def _silo(config: AnySilo, repose_angle: float, where: str) -> Silo:
    sizes = config.model_dump()
    diameter = next(sizes[name] for name in ("diameter_m", "width_m", "inscribed_diameter_m") if name in sizes)
    depth = config.cylinder_depth_m or (config.slenderness or 0.0) * diameter
    hopper = None
    if config.hopper:
        if config.hopper.outlet_width_m >= diameter:
            allowed = f"must be smaller than the silo's width, {diameter:g} m"
            raise BadInput("scene.silo.hopper.outlet_width_m", config.hopper.outlet_width_m, allowed, where)
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
