"""Load cases that a silo calls for, which of them a study computes, and why it does not compute the others."""

from collections.abc import Callable, Mapping
from dataclasses import dataclass
from functools import reduce

import numpy as np

from silostudy.compute.evaluate import masked
from silostudy.pressure import PRESSURE, hopper_shape
from silostudy.pressure.calls import call
from silostudy.pressure.en1991_4 import classes, cylinder, limits, patch
from silostudy.pressure.family import CHANNEL_SIZES, IN_SCOPE, OUT_OF_RANGE, REASONS, PressureMethod
from silostudy.scene.scene import Scene, parameters_of_scenes
from silostudy.tables.load_cases import LOAD_CASES, STATES, LoadCase

COMPUTED, NOT_COMPUTED = STATES
NOT_ASKED = "not asked for"  # by the study
NOT_CALLED_FOR = "not called for"  # by the code for this silo
LISTED_STATES = (COMPUTED, NOT_ASKED, NOT_CALLED_FOR, NOT_COMPUTED)
VERY_SLENDER = 4.0  # h_c / d_c, from memory


@dataclass(frozen=True)
class Listed:
    """A load case of one silo: one of LISTED_STATES, and why where it is not computed."""

    row: LoadCase
    state: str
    why: str = ""


def load_cases(study, scene: Scene) -> list[Listed]:
    """Every load case of the table for one silo of a study."""
    given = parameters_of_scenes([scene], PRESSURE[next(iter(LOAD_CASES.values())).methods[0]])
    return [_listed(row, study, scene, given) for row in LOAD_CASES.values()]


def _listed(row: LoadCase, study, scene: Scene, given: Mapping) -> Listed:
    if why := QUESTIONS[row.called_for](given):
        return Listed(row, NOT_CALLED_FOR, why)
    if row.state == NOT_COMPUTED:
        return Listed(row, NOT_COMPUTED, "; ".join(text for text in (row.evidence, row.remark) if text))
    absent = [key for key in row.needs if reduce(lambda held, name: getattr(held, name, None), key.split("."), study) is None]
    if absent:
        return Listed(row, NOT_ASKED, f"needs {' and '.join(absent)}")
    if row.phase and row.phase not in study.phases:
        return Listed(row, NOT_ASKED, f"needs the phase {row.phase}")
    return _by_methods(row, study, scene)


def _by_methods(row: LoadCase, study, scene: Scene) -> Listed:
    """The state of a case whose silo calls for it: computed where a method that covers the silo is asked for."""
    masks = {key: _mask(row, study.family(PRESSURE)[key], scene) for key in row.methods}
    covering = [key for key, why in masks.items() if not why]
    if not covering:
        return Listed(row, NOT_COMPUTED, masks[row.methods[0]])
    if not set(covering) & set(study.method_keys):
        return Listed(row, NOT_ASKED, f"needs the method {covering[0]}")
    return Listed(row, COMPUTED)


def _mask(row: LoadCase, method: PressureMethod, scene: Scene) -> str:
    """Reason why a method masks the case's first quantity for a silo; nothing where it gives it, or where no method does."""
    given = parameters_of_scenes([scene], method) | {"channel_size": np.full((1, 1), CHANNEL_SIZES[0])}
    name, phase = row.names[0], row.phase
    places = {
        "phases": given["cylinder_depth"],
        "channel": given["cylinder_depth"],
        "hopper": hopper_shape.apex_height(given["diameter"], given["hopper_half_angle"]),
        "totals": None,
    }
    for part, place in places.items():
        function = getattr(method, part).get(phase, {}).get(name)
        if function is not None:
            scope = int(masked(method, name, phase, function, place, given)[1].ravel()[0])
            return "" if scope == IN_SCOPE else _words(method, name, phase, scope, given)
    return ""


def _words(method: PressureMethod, name: str, phase: str, scope: int, given: Mapping) -> str:
    """Reason why a quantity is masked, in words: the limits that are broken, or the flag's."""
    holding = [limit for limit in method.limits if limit.holds_for(name, phase) and not limit.measure.of_depth]
    broken = [limit.words() for limit in holding if scope == OUT_OF_RANGE and limit.broken(None, given).any()]
    return f"outside {'; '.join(broken)}" if broken else REASONS[scope].replace("_", " ")


def _number(function: Callable, given: Mapping, **more) -> float:
    return float(np.ravel(call(function, None, {**given, **more}))[0])


def _slenderness(given: Mapping) -> float:
    return float(given["cylinder_depth"][0, 0] / given["diameter"][0, 0])


def _share(name: str, given: Mapping) -> float:
    """Eccentricity of filling or outlet over the diameter (1)."""
    return float(given[f"{name}_eccentricity"][0, 0] / given["diameter"][0, 0])


def _class(given: Mapping) -> int:
    return int(_number(classes.class_taken, given))


def _flat(given: Mapping) -> bool:
    return bool(np.isnan(given["hopper_half_angle"]).all())


def _always(given: Mapping) -> str:
    return ""


def _patch_in_filling(given: Mapping) -> str:
    factor = _number(patch.patch_factor_filling, given, eccentricity=given["filling_eccentricity"])
    return "" if factor != 0 else f"C_pf = 0 where h_c/d_c <= 1: {_slenderness(given):.2f}"


def _patch_in_discharge(given: Mapping) -> str:
    largest = np.maximum(given["filling_eccentricity"], given["outlet_eccentricity"])
    factor = _number(patch.patch_factor_discharge, given, eccentricity=largest)
    return "" if factor != 0 else f"C_pe = 0 in so low a silo: h_c/d_c {_slenderness(given):.2f}"


def _channel(given: Mapping) -> str:
    if given["plan"][0, 0] != "circular":
        return "for circular silos"
    if _class(given) < limits.EVERY_CASE:
        return f"for action assessment class 3; this silo is of class {_class(given)}"
    share = _share("outlet", given)
    return "" if share > limits.LARGE_ECCENTRICITY else f"e_o/d_c {share:.2f}, not above {limits.LARGE_ECCENTRICITY}"


def _off_axis_filling(given: Mapping, slenderness_fits: bool, bound: str) -> str:
    if _class(given) < limits.EVERY_CASE:
        return f"for action assessment class 3; this silo is of class {_class(given)}"
    share = _share("filling", given)
    if share <= limits.LARGE_ECCENTRICITY:
        return f"e_f/d_c {share:.2f}, not above {limits.LARGE_ECCENTRICITY}"
    return "" if slenderness_fits else f"h_c/d_c {_slenderness(given):.2f}, not {bound}"


def _low_class_3(given: Mapping) -> str:
    return _off_axis_filling(given, _slenderness(given) < cylinder.SLENDER, f"below {cylinder.SLENDER:g}")


def _very_slender_class_3(given: Mapping) -> str:
    return _off_axis_filling(given, _slenderness(given) > VERY_SLENDER, f"above {VERY_SLENDER:g}")


def _class_2_circular(given: Mapping) -> str:
    if given["plan"][0, 0] != "circular":
        return "for circular silos"
    return "" if _class(given) == 2 else f"for action assessment class 2; this silo is of class {_class(given)}"


def _retaining(given: Mapping) -> str:
    if _slenderness(given) > limits.RETAINING:
        return f"for h_c/d_c <= {limits.RETAINING}; this silo has {_slenderness(given):.2f}"
    return "" if _flat(given) else "for flat bottoms"


def _powder(given: Mapping) -> str:
    return "" if given["powder"].any() else "for powders"


def _hopper(given: Mapping) -> str:
    return "flat bottom" if _flat(given) else ""


QUESTIONS: dict[str, Callable[[Mapping], str]] = {
    "always": _always,
    "patch_in_filling": _patch_in_filling,
    "patch_in_discharge": _patch_in_discharge,
    "channel": _channel,
    "low_class_3": _low_class_3,
    "very_slender_class_3": _very_slender_class_3,
    "class_2_circular": _class_2_circular,
    "retaining": _retaining,
    "powder": _powder,
    "hopper": _hopper,
}
