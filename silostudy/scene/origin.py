"""Origin of a property that a method is handed: the order of precedence of `scene.solid_parameters` in words."""

from math import isnan, nan

from silostudy.scene.scene import Scene

ORIGINS = (
    "not_known",
    "solid_table",
    "own_table_of_the_method",
    "study",
    "kind_of_wall",
    "kind_of_hopper_wall",
    "rule_from_the_friction_angle",
    "end_of_the_scatter",
)
PROPERTIES = (
    "unit_weight",
    "internal_friction_angle",
    "wall_friction",
    "lateral_pressure_ratio",
    "hopper_wall_friction",
    "repose_angle",
    "a_phi",
    "a_K",
    "a_mu",
    "patch_factor",
)


def origins(scene: Scene, method: str, varies) -> list[int]:
    """Position in ORIGINS of every one of PROPERTIES; method: whose own values of the tables count; varies: see the method."""
    return [ORIGINS.index(_origin(scene, method, name, varies)) for name in PROPERTIES]


def _origin(scene: Scene, method: str, name: str, varies) -> str:
    if name == "hopper_wall_friction" and name not in scene.own:
        if scene.hopper_wall is not None:
            return "kind_of_hopper_wall"
        return _origin(scene, method, "wall_friction", varies)
    moved = scene.wall_friction_end != "mean" and "wall_friction" not in varies
    if moved and name in ("wall_friction", "lateral_pressure_ratio"):
        return "end_of_the_scatter"
    if name in scene.own:
        return "study"
    if name == "wall_friction" and scene.wall is not None:
        return "kind_of_wall"
    mine = scene.solid.by_method.get(method, {}).get(name, nan)
    value = getattr(scene.solid, name, nan) if isnan(mine) else mine
    if name == "lateral_pressure_ratio" and (scene.lateral_pressure_ratio_rule or isnan(value)):
        return "rule_from_the_friction_angle"
    if isnan(value):
        return "not_known"
    return "solid_table" if isnan(mine) else "own_table_of_the_method"
