"""The worst of a wall over its depth, and over the ends of the wall friction where a study has several: which end governs."""

import numpy as np

from silostudy.buckling.family import IN_SCOPE, NO_LOAD
from silostudy.choice.expand import Resolved
from silostudy.cube.variables import flags

KEY = "wall_friction_end"
ENDS = ("none", "mean", "lower", "upper", "alike")


def worst_of_ends(expansion: Resolved, data: dict) -> dict:
    """Largest required thickness and utilisation by rule and method, over the ends too, with the end that governs each.

    NaN where any loaded part of the wall is beyond the rule: the largest of the rest would speak for a wall not judged.
    """
    arrays = _over_ends(expansion, "required_thickness", _most(data, "required_thickness", 1))
    if "utilisation" not in data:
        return arrays
    used = np.fmax(_most(data, "utilisation", 1), _most(data, "strake_utilisation", 2))
    return arrays | _over_ends(expansion, "utilisation", np.fmax.reduce(used, axis=2))


def _most(data: dict, name: str, last: int) -> np.ndarray:
    """The largest over the last axes; infinite where a part with a load is masked."""
    values, (scope, _) = data[name], data[f"{name}_scope"]
    unjudged = np.isnan(values) & (scope != IN_SCOPE) & (scope != NO_LOAD)
    return np.fmax.reduce(np.where(unjudged, np.inf, values), axis=tuple(range(values.ndim - last, values.ndim)))


def _over_ends(expansion: Resolved, name: str, values: np.ndarray) -> dict:
    """The largest (rule, method, axes...) along the axis of the ends, the same for all, and the end it is of; infinite: NaN."""
    ends = np.reshape([ENDS.index(case.scene.wall_friction_end) for case in expansion.cases], expansion.shape)
    ends = np.broadcast_to(ends, values.shape)
    for number, axis in enumerate(expansion.study.sweep):
        if set(axis.settings()[0]) == {KEY}:
            place = np.argmax(np.nan_to_num(values, nan=-np.inf), axis=number + 2, keepdims=True)
            alike = np.max(values, axis=number + 2, keepdims=True) <= np.min(values, axis=number + 2, keepdims=True)
            ends = np.where(alike, ENDS.index("alike"), ends)
            values, ends = (
                np.broadcast_to(np.take_along_axis(array, place, axis=number + 2), values.shape) for array in (values, ends)
            )
    values = np.where(np.isinf(values), np.nan, values)
    governing = np.where(np.isnan(values), 0, ends).astype(np.int8)
    told = flags("end of the wall friction that governs", ENDS)
    return {f"largest_{name}": values, f"largest_{name}_friction_end": (governing, told)}
