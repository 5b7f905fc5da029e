"""The cells of a laboratory study, and about what their tests cost."""

from collections.abc import Callable
from dataclasses import dataclass
from math import isnan
from pathlib import Path
from typing import Any

from silostudy.config.laboratory import LaboratoryStudy
from silostudy.errors import BadInput
from silostudy.scene import laboratory_discs, laboratory_scenes
from silostudy.scene.costs import COSTS, START
from silostudy.scene.laboratory_cell import KPA, Cell, LaboratoryCase
from silostudy.scene.laboratory_cell_discs import DiscCase
from silostudy.scene.spheres import MPA

FILLED = 0.6  # s: about what a filling takes to come to rest
SOFT = 0.02  # stress over the grains' modulus beyond which they are pressed in by a tenth of their radius or so
PRESSED = 0.05  # strain that a stress presses a cell by, about


@dataclass(frozen=True)
class Tests:
    """The tests of one sort of grains: the class of its cells, and the scenes of the tests.

    plates: what floor and lid are in the shear inside the solid, and on the wall's plate, as `shearing` takes it.
    apart(case) -> grains times seconds of the tests that are not done in the cell; check(case, where): BadInput for contacts
    that nothing tells of.
    """

    case: Callable[..., Any]
    filling: Callable[..., Any]
    pressing: Callable[..., Any]
    shearing: Callable[..., Any]
    plates: dict[str, Any]
    apart: Callable[[Any], float]
    check: Callable[[Any, str], None]


def _tray_of_spheres(case: LaboratoryCase) -> float:
    tray = laboratory_scenes.draining(case)
    return FILLED * case.heap_count + (FILLED + tray.events[-1].value) * tray.filling.count


def _tray_of_discs(case: DiscCase) -> float:
    return (FILLED + laboratory_discs.FLOWS) * case.heap_count


TESTS: dict[str, Tests] = {
    "spheres": Tests(
        LaboratoryCase, laboratory_scenes.filling, laboratory_scenes.pressing, laboratory_scenes.shearing,
        {"internal": laboratory_scenes.SHEARING, "wall": laboratory_scenes.SLIDING}, _tray_of_spheres, laboratory_scenes.check,
    ),
    "discs": Tests(
        DiscCase, laboratory_discs.filling, laboratory_discs.pressing, laboratory_discs.shearing,
        {"internal": laboratory_discs.SHEARING, "wall": laboratory_discs.SLIDING}, _tray_of_discs, laboratory_discs.check,
    ),
}  # fmt: skip


def laboratory_builder(study: LaboratoryStudy, folder: Path, where: str) -> Callable[[Any, dict], Cell]:
    """Builds the cells of a laboratory; BadInput for grains without a density, or a contact that nothing tells of."""
    stresses = tuple(KPA * stress for stress in study.stresses_kPa)

    def build_one(config: Any, settings: dict[str, Any]) -> Cell:
        tests = TESTS[config.grains]
        case = tests.case(config, folder, stresses, study.shear_strain)
        if isnan(case.density):
            raise BadInput("scene.grain.density_kg_m3", None, "must be given: the material has none", where)
        if stresses[-1] > SOFT * case.modulus:
            told = f"kPa: more than {SOFT:.0%} of the grains' modulus, {case.modulus / MPA:g} MPa, presses them in too far"
            raise BadInput("stresses_kPa", study.stresses_kPa[-1], told, where)
        tests.check(case, where)
        return case

    return build_one


def cost(case: Any) -> float:
    """About how long (s) the tests of a cell compute: grains times steps of filling, pressing and two shears a stress."""
    tests, costs = TESTS[case.config.grains], COSTS[case.config.grains]
    shears = sum(2.0 * case.shear_strain * case.height / case.speed(stress) for stress in case.stresses)
    pressed = sum(PRESSED * case.height / case.speed(stress) for stress in case.stresses)
    step = costs.step(tests.filling(case))
    steps = (FILLED + pressed + shears) / step
    return START + steps * (costs.look + case.count * costs.body) + tests.apart(case) / step * costs.body
