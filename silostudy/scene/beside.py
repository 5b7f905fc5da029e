"""A sweep of scenes and the study of pressures that is to stand beside it: of the same silos, or refused before any work."""

from collections.abc import Iterator
from itertools import product
from math import isclose
from pathlib import Path
from typing import Any

from silostudy.config.load import read_study
from silostudy.config.scenes import ScenesStudy
from silostudy.errors import BadInput
from silostudy.stages import KINDS

PHASES = ("filling", "discharge")
SAME = 0.01  # share by which lengths and angles of the same silo may differ
HOPPER = "silo.hopper.half_angle_deg"
# by grains: key of a silo in a study of pressures -> key there
KEYS = {
    "discs": {
        "silo.width_m": "silo.width_m",
        HOPPER: "silo.hopper_half_angle_deg",
        "silo.hopper.outlet_width_m": "silo.slit_width_m",
    },
    "spheres": {key: key for key in ("silo.diameter_m", HOPPER, "silo.hopper.outlet_width_m")},
}


def check_codes(study: ScenesStudy, folder: Path, where: str) -> None:
    """BadInput where the study that `codes` names is none of pressures of the same silos; the solid's depth is known later.

    Axes of one name belong together position by position.
    """
    if study.codes is None:
        return
    name, path = study.codes.study, folder / f"{study.codes.study}.yaml"
    codes: Any = read_study(path)
    taken = {stage.borrows["codes"] for stage in KINDS[study.kind].stages if "codes" in stage.borrows}
    if not taken <= {stage.key for stage in KINDS[codes.kind].stages}:
        raise BadInput("codes.study", name, f"must be a study of pressures, not of kind {codes.kind}", where)
    if lacking := [phase for phase in PHASES if phase not in codes.phases]:
        raise BadInput("codes.study", name, f"must have the phases {', '.join(PHASES)}; lacks {', '.join(lacking)}", where)
    lengths = _axes_checked(study, codes, where)
    keys, shared = KEYS[study.scene.grains], {axis.axis for axis in codes.sweep}
    axes = {name: count for name, count in lengths.items() if name in shared or _sets_silo(study, name)}
    for own, other in zip(_silos(study, axes), _silos(codes, axes), strict=True):
        if own.get(keys[HOPPER]) and codes.hopper_position is None:
            raise BadInput("codes.study", name, "must have hopper_position: the scenes' silo has a hopper", where)
        _check_silo(own, other, study.scene.grains, name, where)


def _axes_checked(study: ScenesStudy, codes: Any, where: str) -> dict[str, int]:
    """Lengths of the axes of the scenes; BadInput where the study of pressures has another or a longer one."""
    name, lengths = study.codes.study if study.codes else "", {axis.axis: len(axis.settings()) for axis in study.sweep}
    for axis in codes.sweep:
        count = len(axis.settings())
        if axis.axis not in lengths:
            raise BadInput("codes.study", name, f"has the axis {axis.axis}, which the scenes have not", where)
        if lengths[axis.axis] != count:
            told = f"has {count} position(s) on the axis {axis.axis}, where the scenes have {lengths[axis.axis]}"
            raise BadInput("codes.study", name, told, where)
    return lengths


def _sets_silo(study: ScenesStudy, name: str) -> bool:
    """Whether an axis of a study sets a key of its silo."""
    return any(key.startswith("silo.") for axis in study.sweep if axis.axis == name for key in axis.settings()[0])


def _silos(study: Any, axes: dict[str, int]) -> Iterator[dict[str, Any]]:
    """Keys and values of the silo of a study at every position of some axes, the last fastest; some may not be its own."""
    base = _flat({"silo": study.scene.silo.model_dump()})
    own = {axis.axis: axis.settings() for axis in study.sweep}
    for positions in product(*(own.get(name, [{}] * count) for name, count in axes.items())):
        yield base | {key: value for settings in positions for key, value in settings.items()}


def _flat(content: dict[str, Any], start: str = "") -> dict[str, Any]:
    """Values of nested keys by dotted ones."""
    flat: dict[str, Any] = {}
    for key, value in content.items():
        flat |= _flat(value, f"{start}{key}.") if isinstance(value, dict) else {f"{start}{key}": value}
    return flat


def _check_silo(own: dict[str, Any], other: dict[str, Any], grains: str, name: str, where: str) -> None:
    """BadInput where a length or an angle of a silo of scenes is another in the study of pressures."""
    plan = {"discs": "slot", "spheres": "circular"}[grains]
    if other["silo.plan"] != plan:
        raise BadInput(f"codes, scene.silo.plan of {name}", other["silo.plan"], f"must be {plan}, as of the scenes", where)
    for its, key in KEYS[grains].items():
        expected, given = own.get(key), other.get(its)
        if (expected or given) and not (expected and given and isclose(expected, given, rel_tol=SAME)):
            raise BadInput(f"codes, scene.{its} of {name}", given, f"must be as scene.{key} = {expected}", where)
