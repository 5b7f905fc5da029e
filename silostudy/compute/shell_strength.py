"""Thickness that a wall's loads ask for, and utilisation of a wall of given thickness: by buckling and every check."""

from collections.abc import Mapping

import numpy as np

from silostudy.buckling.family import IN_SCOPE, MODES, NO_LOAD, OUT_OF_RANGE, REASONS
from silostudy.buckling.thickness import required_thickness, with_thickness
from silostudy.checks import NAMES, SOLID_CHECKS
from silostudy.checks.family import THIN_WALL, call
from silostudy.cube.variables import flags


def designed(parameters: Mapping, safety) -> dict:
    """The parameters with the safety factor on the pressure that harms, as on the axial stress; what steadies stays.

    It stands for the partial factors of the strength too; no action here shears the wall.
    """
    harming = safety * parameters["upper_internal_pressure"]
    return {**parameters, "upper_internal_pressure": harming, "partial_yield": 1.0, "shear_wall_force": 0.0}


def required_thicknesses(rules, parameters: Mapping, force: np.ndarray, safety, own_weight) -> dict:
    """Thickness by rule, the larger of what buckling and the checks ask for, which of them governs, and the rule's scope.

    own_weight: axial force (N/m) per thickness (m) of the wall above.
    """
    design = designed(parameters, safety)
    results = [required_thickness(rule, design, force, safety, own_weight=own_weight) for rule in rules]
    acting = {**design, "axial_wall_force": safety * force, "wall_above": safety * np.asarray(own_weight)}
    needs = (call(row.needed, acting) for row in SOLID_CHECKS.values() if row.needed)
    checked = np.array([np.broadcast_to(need, force.shape) for need in needs])
    thick = THIN_WALL.broken(None, {**parameters, "thickness": checked})
    thinnest, scope = (np.array(part) for part in zip(*results, strict=True))
    scope = np.where(thick.any(axis=0) & ~np.isnan(thinnest), np.int8(OUT_OF_RANGE), scope)
    largest, governs = worst(np.where(thick.any(axis=0), np.nan, thinnest), checked[:, None])
    meaning = "why required_thickness is masked, or what but the strength keeps the wall from being thinner"
    return {
        "required_thickness": largest,
        "required_thickness_scope": (scope, flags(meaning, REASONS)),
        "required_thickness_check": (governs, flags("check that asks for the most", NAMES)),
        **_thin("check_required_thickness", checked, thick),
        "check": list(SOLID_CHECKS),
    }


def worst(buckling: np.ndarray, checked: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Largest of buckling's numbers and those of each check, and its position in NAMES; NaN where a rule is silent."""
    uses = np.stack([buckling, *(np.broadcast_to(use, buckling.shape) for use in checked)])
    silent = np.isnan(buckling)
    largest = np.where(silent, np.nan, np.fmax.reduce(uses, axis=0))
    return largest, np.where(silent, 0, np.argmax(np.nan_to_num(uses, nan=-np.inf), axis=0)).astype(np.int8)


def utilisations(rules, parameters: Mapping, force, safety, thickness, dead) -> dict:
    """Stress, strength, mode and utilisation of a wall of given thickness (m); dead: axial force (N/m) beside the solid's."""
    design = designed(parameters, safety)
    stress = (force + dead) / thickness
    shells = [with_thickness(rule, design, thickness) for rule in rules]
    shape = (len(rules), force.shape[0], *force.shape[2:])
    names = ("buckling_stress", "buckling_stress_scope", "buckling_mode", "supported_length")
    strength, scope, mode, length = (np.array([np.broadcast_to(shell[name], shape[1:]) for shell in shells]) for name in names)
    used = safety * stress / strength[:, :, None]
    masked = np.where(np.isnan(stress), NO_LOAD, np.broadcast_to(scope[:, :, None], used.shape)).astype(np.int8)
    acting = {
        **design,
        "thickness": thickness,
        "axial_wall_force": safety * np.fmax.reduce(force + dead, axis=1),
        "wall_above": 0.0,
    }
    checked = np.array([row.utilisation(acting) for row in SOLID_CHECKS.values()])
    largest, governs = worst(np.where(masked == IN_SCOPE, used, np.nan), checked[:, None, :, None])
    return {
        "axial_wall_stress": stress,
        "wall_buckling_stress": strength,
        "wall_buckling_stress_scope": (scope, flags("why it is masked", REASONS)),
        "wall_buckling_mode": (mode, flags("how the wall buckles (-1: masked)", MODES)),
        "wall_supported_length": length,
        "utilisation": largest,
        "utilisation_scope": (masked, flags("why utilisation is masked", REASONS)),
        "utilisation_check": (governs, flags("check by which the wall is used most", NAMES)),
        **_thin("check_utilisation", checked, THIN_WALL.broken(None, {**parameters, "thickness": thickness})),
    }


def _thin(name: str, values: np.ndarray, thick: np.ndarray) -> dict:
    """A number of the checks, masked where the wall is too thick for a shell, with its scope."""
    thick = np.broadcast_to(thick, values.shape)
    scope = np.select([np.isnan(values), thick], [NO_LOAD, OUT_OF_RANGE], IN_SCOPE).astype(np.int8)
    return {name: np.where(thick, np.nan, values), f"{name}_scope": (scope, flags("why it is masked", REASONS))}
