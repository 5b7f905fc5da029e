"""Tests of one cell of a laboratory: a filling, pressed from stress to stress, sheared at each of them."""

from collections.abc import Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

import numpy as np

from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.laboratory_discs import DISCS
from silostudy.compute.laboratory_readings import SPHERES, Reader, Readings
from silostudy.config.grain_scenes import AnyScene
from silostudy.config.laboratory import LaboratoryStudy
from silostudy.config.laboratory_scenes import DiscLaboratory
from silostudy.dem.branch import end_of
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.run import Run
from silostudy.errors import BadInput
from silostudy.scene.laboratory import TESTS
from silostudy.scene.laboratory_cell import KPA
from silostudy.scene.laboratory_scenes import BORNE, SHEAR_WINDOWS
from silostudy.tables.constants import ROUNDED_GRAVITY

PATH = 100  # points of the compression path
SMOOTHED = 3  # windows in the running mean that the peak is taken of: 1/20 of the way
OFF = 0.02  # of a force: by which balances and stresses may be missed
SOURCES = ("en1991_4_2006",)
Numbers = dict[str, np.ndarray]
READERS: dict[str, Reader] = {"discs": DISCS, "spheres": SPHERES}


def coordinates(study: LaboratoryStudy) -> dict[str, Any]:
    """The dimensions that a cell's numbers have of their own, and at which stresses (Pa) they enter the row of the solid."""
    step, stresses = study.shear_strain / SHEAR_WINDOWS, KPA * np.array(study.stresses_kPa)
    return {
        "normal_stress": stresses,
        "path_stress": np.linspace(0.0, stresses[-1], PATH + 1)[1:],
        "shear_strain": (np.arange(SHEAR_WINDOWS) + 0.5) * step,
        "row_vertical_stress": np.array(KPA * study.vertical),
        "row_horizontal_stress": np.array(KPA * study.horizontal),
        "row_solid": np.array(study.solid.key),
        "row_grain": np.array(study.solid.grain),
        "row_remark": np.array(READERS[study.scene.grains].remark),
    }


def sources(study: LaboratoryStudy) -> list[str]:
    """References of the tests, and of the laws that the base scene names."""
    between = study.scene.discs if isinstance(study.scene, DiscLaboratory) else study.scene.spheres
    laws = [law for touch in (between, study.scene.walls) for law in touch.laws.values()]
    plain = next(row.source for row in INTEGRATORS.values())
    return sorted({*SOURCES, plain, *(law.source for law in laws if law.acts)})


def measure(study: LaboratoryStudy, case: Any) -> Numbers:
    """The numbers of one cell, by the names of the contract; BadInput where a test does not come to its end, or balance."""
    tests, reader = TESTS[case.config.grains], READERS[case.config.grains]
    run = _carried(tests.filling(case), None, "filling")
    lists: dict[str, list] = {}
    loose = _unit_weight(case, run, float(np.quantile(run.engine.places[:, -1], 0.95)))
    repose, drawn = reader.slopes(case, _carried)
    back = reader.rebound(case, _carried)
    pressed: list[Readings] = []
    for stress in case.stresses:
        scene = tests.pressing(case, stress, run.engine.time)
        run = _carried(scene, end_of(run), f"pressing to {stress / KPA:g} kPa")
        pressed.append(reader.readings(run, scene, case))
        weight = -scene.gravity_m_s2[-1] * float(run.engine.mass.sum())
        numbers = _pressed(case, run, pressed, stress, weight) | _sheared(case, run, stress)
        for name, value in numbers.items():
            lists.setdefault(name, []).append(value)
    return {
        "tested_grains": np.array(case.count),
        "tested_grain_diameter": np.array(case.grain),
        "loose_unit_weight": np.array(loose),
        "tested_repose_angle": np.array(repose),
        "tested_drawn_angle": np.array(drawn),
        "tested_restitution": np.array(back),
        "asked_restitution": np.array(case.restitution),
        "path_horizontal_stress": _path(pressed, PATH),
        **{name: np.moveaxis(np.array(values), 0, -1) for name, values in lists.items()},  # the stresses come last
    }


def _carried(scene: AnyScene, end: Mapping[str, Any] | None, test: str, *, spills: bool = False) -> Run:
    """The finished run of a test, which goes on from an end; BadInput where it does not come to its stop, or loses grains.

    spills: whether grains are to leave.
    """
    model = scene_model(scene, Path())
    run = run_of(scene, model if end is None else replace(model, end=end))
    run.go()
    if run.recording.explosion is not None:
        raise run.recording.explosion
    if run.trouble:
        raise BadInput("test", test, run.trouble)
    if (lost := len(model.radius) - run.engine.n) and not spills:
        raise BadInput("test", test, f"{lost} grain(s) left the cell")
    return run


def _unit_weight(case: Any, run: Run, top: float) -> float:
    """Unit weight (N/m3) of the inner part of the cell, below a top (m)."""
    return ROUNDED_GRAVITY * case.density * READERS[case.config.grains].solid_fraction(run, case, top)


def _pressed(case: Any, run: Run, pressed: list[Readings], stress: float, weight: float) -> Numbers:
    """Unit weight and lateral pressure ratio at a stress (Pa), and how far forces and a weight (N) are from balance."""
    last, late, (vertical, horizontal) = pressed[-1], slice(-BORNE, None), _loading(pressed)
    part = (vertical >= 0.5 * stress) & (vertical <= (1.0 + OFF) * stress)
    return {
        "tested_unit_weight": np.array(_unit_weight(case, run, last.height[-1])),
        "tested_lateral_pressure_ratio": np.array(np.polyfit(vertical[part], horizontal[part], 1)[0]),
        "secant_lateral_pressure_ratio": np.array(horizontal[-1] / vertical[-1]),
        "force_imbalance": _small("floor + wall - lid - weight", last.imbalance(weight, late), "of the load on the floor"),
        "pressing_stress_error": _small("lid stress", last.vertical[late].mean() / stress - 1.0, "of the stress"),
    }


def _sheared(case: Any, run: Run, stress: float) -> Numbers:
    """Shear over normal stress of the solid in itself and on the plate of the wall, at a stress (Pa)."""
    end, measured = end_of(run), Numbers()
    tests, reader = TESTS[case.config.grains], READERS[case.config.grains]
    for name, plates in tests.plates.items():
        test = f"{name} shear at {stress / KPA:g} kPa"
        scene = tests.shearing(case, stress, run.engine.time, plates)
        read = reader.readings(_carried(scene, end, test), scene, case)
        ratio, late = read.inside if name == "internal" else read.along, slice(-(SHEAR_WINDOWS // 3), None)
        smooth = np.convolve(ratio, np.full(SMOOTHED, 1.0 / SMOOTHED), "valid")
        measured |= {
            f"{name}_shear_ratio": ratio[:SHEAR_WINDOWS],
            f"{name}_peak_shear_ratio": np.array(smooth.max()),
            f"{name}_steady_shear_ratio": np.array(ratio[late].mean()),
            f"{name}_torque_imbalance": _small("shear on lid + floor + walls", read.twist(late), f"of the floor's in {test}"),
            f"{name}_stress_error": _small("lid stress", read.vertical[late].mean() / stress - 1.0, f"of the stress of {test}"),
        }
    return measured


def _small(name: str, share: float, of: str) -> np.ndarray:
    """The share itself; BadInput where it is not small."""
    if not abs(share) <= OFF:
        raise BadInput(name, f"{share:.3%}", f"{of}: must be within {OFF:.0%}; the test is too fast: lower inertial_number")
    return np.array(share)


def _loading(pressed: list[Readings]) -> tuple[np.ndarray, np.ndarray]:
    """Vertical and horizontal stresses (Pa) at first loading: where the lid presses harder than ever before."""
    vertical = np.concatenate([history.vertical for history in pressed])
    horizontal = np.concatenate([history.horizontal for history in pressed])
    first = vertical >= np.maximum.accumulate(vertical)
    return vertical[first], horizontal[first]


def _path(pressed: list[Readings], points: int) -> np.ndarray:
    """Horizontal stress (Pa) at even vertical stresses up to the last one, at first loading."""
    even = np.linspace(0.0, pressed[-1].vertical[-1], points + 1)[1:]
    return np.interp(even, *_loading(pressed), left=np.nan)
