"""Numbers of a silo for the checks of its steel beside its wall, in SI units, and the combinations that a study asks for."""

from math import nan
from typing import Any

from silostudy.checks import external_pressure
from silostudy.config.shell import ShellStudy, SteelSilo
from silostudy.config.steelwork import Anchors, ColumnSupport, HopperShell, TransitionRing, Wind
from silostudy.tables.combinations import COMBINATIONS, Combination


def steelwork(config: SteelSilo) -> dict[str, float]:
    """Parameters of the checks by name, NaN where nothing is given."""
    return {
        **wind(config.wind),
        **hopper_shell(config.hopper_shell),
        **transition_ring(config.transition_ring),
        **columns(config.columns),
        **anchors(config.anchors),
    }


def wind(config: Wind | None) -> dict[str, float]:
    """Pressures (Pa), force coefficient, factor of the edges (1), and whether the top is held round (1 or 0)."""
    if config is None:
        return dict.fromkeys(("wind_pressure", "suction", "force_coefficient", "edge_factor", "top_held"), nan)
    return {
        "wind_pressure": config.pressure_kPa * 1e3,
        "suction": config.suction_kPa * 1e3,
        "force_coefficient": config.force_coefficient,
        "edge_factor": external_pressure.EDGE_FACTORS[config.upper_edge, config.lower_edge],
        "top_held": float(config.upper_edge != "free"),
    }


def hopper_shell(config: HopperShell | None) -> dict[str, float]:
    """Thickness (m), joint efficiency (1) and tensile strength (Pa) of the hopper's wall."""
    if config is None:
        return dict.fromkeys(("hopper_thickness", "hopper_joint_efficiency", "ultimate_stress"), nan)
    strength = config.ultimate_stress_MPa
    return {
        "hopper_thickness": config.thickness_mm / 1e3,
        "hopper_joint_efficiency": config.joint_efficiency,
        "ultimate_stress": nan if strength is None else strength * 1e6,
    }


def transition_ring(config: TransitionRing | None) -> dict[str, float]:
    """Area (m2) and second moment of area (m4) of the transition ring."""
    if config is None:
        return dict.fromkeys(("ring_area", "ring_second_moment"), nan)
    moment = config.second_moment_cm4
    return {"ring_area": config.area_cm2 * 1e-4, "ring_second_moment": nan if moment is None else moment * 1e-8}


def columns(config: ColumnSupport | None) -> dict[str, float]:
    """Number of columns, and section modulus (m3) of the ring beam."""
    if config is None:
        return dict.fromkeys(("column_count", "section_modulus"), nan)
    return {"column_count": float(config.count), "section_modulus": config.section_modulus_cm3 * 1e-6}


def anchors(config: Anchors | None) -> dict[str, float]:
    """Number of anchors, diameter (m) of their circle, and tension (N) that one bears."""
    if config is None:
        return dict.fromkeys(("anchor_count", "circle_diameter", "anchor_resistance"), nan)
    return {
        "anchor_count": float(config.count),
        "circle_diameter": config.circle_diameter_m,
        "anchor_resistance": config.resistance_kN * 1e3,
    }


def combinations(study: ShellStudy) -> list[Combination]:
    """The combinations of a study: its own, or the package's."""
    assert study.checks is not None
    if study.checks.combinations is None:
        return list(COMBINATIONS.values())
    return [_own(combination.model_dump()) for combination in study.checks.combinations]


def _own(given: dict[str, Any]) -> Combination:
    return Combination(key=given["combination"], **{name: value for name, value in given.items() if name != "combination"})
