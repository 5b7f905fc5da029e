"""Limits of what can be: the impossible is refused while a scene is built, the unusual told, also where it takes two values."""

from math import atan, degrees, isnan, nan, pi, radians, tan

from silostudy.errors import BadInput
from silostudy.pressure.en1991_4 import classes
from silostudy.scene.scene import Scene, solid_parameters
from silostudy.scene.silo import Silo
from silostudy.tables.ranges import BY_QUANTITY
from silostudy.tables.units import split_unit

STEEPEST = radians(75.0)  # no heap stands steeper


def require_possible(scene: Scene, where: str) -> None:
    """BadInput for a heap, an eccentricity, or properties that cannot be."""
    silo, values = scene.silo, solid_parameters(scene, "")
    for name in ("filling_eccentricity", "outlet_eccentricity"):
        if getattr(silo, name) > silo.diameter / 2:
            allowed = f"must not be above half the silo's width, {silo.diameter / 2:g} m"
            raise BadInput(f"scene.silo.{name}_m", getattr(silo, name), allowed, where)
    highest = silo.diameter / 2 * tan(STEEPEST)
    if silo.top_cone_height > highest:
        allowed = f"must not be above {highest:.4g} m: no heap stands steeper than {degrees(STEEPEST):g} degrees"
        raise BadInput("scene.silo.top_cone_height_m", silo.top_cone_height, allowed, where)
    phi, spread = values["internal_friction_angle"], values["a_phi"]
    if phi * spread >= pi / 2:
        allowed = (
            f"must be below {pi / 2 / phi:.4g}: the upper friction angle, {degrees(phi):g} times it, would reach 90 degrees"
        )
        raise BadInput("scene.properties.a_phi", spread, allowed, where)
    if values["unit_weight_lower"] > values["unit_weight"]:
        allowed = f"must not be above the unit weight, {values['unit_weight'] / 1e3:g} kN m-3"
        raise BadInput("scene.properties.unit_weight_lower_kN_m3", values["unit_weight_lower"] / 1e3, allowed, where)


def unusual(scene: Scene) -> list[str]:
    """Unusual values of a scene: quantity, value, and what is usual."""
    silo = scene.silo
    sizes = {"diameter": silo.diameter, "cylinder_depth": silo.cylinder_depth, "slenderness": silo.wall_depth / silo.diameter}
    sizes["half_angle"] = silo.hopper.half_angle if silo.hopper else nan
    known = [*sizes.items(), *_properties(scene).items(), *(("thickness", thickness) for thickness in scene.plates)]
    notes = [text for name, value in known if (text := _unusual(name, value))]
    slope, repose = atan(silo.top_cone_height / (silo.diameter / 2)), solid_parameters(scene, "")["repose_angle"]
    if slope > repose * (1 + 1e-9):
        notes.append(
            f"top_cone_height_m = {silo.top_cone_height:g}: a slope of {degrees(slope):.1f} degrees, the solid's angle of "
            f"repose is {degrees(repose):.1f}"
        )
    least = float(classes.least_class(unit_weight=solid_parameters(scene, "")["unit_weight"], **_sizes(silo)))
    if 0 < silo.assessment_class < least:
        notes.append(f"action_assessment_class = {silo.assessment_class}: by capacity and outlet it is {least:.0f} or higher")
    return notes


def _sizes(silo: Silo) -> dict[str, float]:
    return {name: getattr(silo, name) for name in ("volume", "outlet_eccentricity", "diameter")}


def _properties(scene: Scene) -> dict[str, float]:
    return {name: value for name, value in solid_parameters(scene, "").items() if name in BY_QUANTITY}


def _unusual(name: str, value: float) -> str:
    written, known = BY_QUANTITY[name]
    shown = value / split_unit(written)[2]
    if isnan(shown) or not known.unusual(float(f"{shown:.12g}")):
        return ""
    low, high = known.usual
    return f"{written} = {shown:.4g} is unusual: mostly {low:g} to {high:g}"
