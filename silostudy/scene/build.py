"""Builds a frozen scene in SI from the user's units, with the checks that need a table or two values at once."""

import json
from collections.abc import Callable
from math import isnan
from pathlib import Path
from typing import Any

from silostudy.catalogue import Family
from silostudy.config.load import read_study
from silostudy.config.pressure import PressureStudy
from silostudy.config.scene import SceneConfig
from silostudy.errors import BadInput, NotYet
from silostudy.scene.possible import require_possible
from silostudy.scene.scene import Scene, solid_parameters
from silostudy.scene.silo_from import silo_of
from silostudy.tables.solids import SOLIDS, SolidRow, own_solids
from silostudy.tables.units import split_unit
from silostudy.tables.walls import WALLS

# what a sampled study needs to know of the solid's scatter, and how a user writes it
SPREADS = {"a_phi": "a_phi", "a_K": "a_K", "a_mu": "a_mu", "unit_weight_lower": "unit_weight_lower_kN_m3"}


def pressure_builder(study: PressureStudy, folder: Path, where: str) -> Callable[[SceneConfig, dict], Scene]:
    """Builds the scenes of a pressure study: with the user's materials, and no depth below the transition."""
    solids = _own_solids(study.materials, folder, where) if study.materials else SOLIDS

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


def _own_solids(named: str, folder: Path, where: str) -> Family[SolidRow]:
    """The solids of the user's file; BadInput names the study that makes it where that has not run yet."""
    path = folder / named
    maker = folder / f"{path.parent.parent.name}.yaml"
    if not path.exists() and maker.is_file() and path.stem in read_study(maker).outputs:
        told = f"is not there yet: the study {maker.stem} makes it, run that first"
        raise NotYet("materials", named, told, where, maker=maker.stem)
    return own_solids(path)


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
        silo=silo_of(config.silo, own.get("repose_angle", solids[config.solid].repose_angle), where),
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
