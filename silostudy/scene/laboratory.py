"""The cells of a laboratory study, and about what their tests cost."""

from collections.abc import Callable
from math import isnan
from pathlib import Path
from typing import Any

from silostudy.config.laboratory import LaboratoryScene, LaboratoryStudy
from silostudy.errors import BadInput
from silostudy.scene.costs import COSTS, START
from silostudy.scene.laboratory_cell import KPA, LaboratoryCase
from silostudy.scene.laboratory_scenes import draining, filling
from silostudy.scene.spheres import MPA, contacts_of, material_of

FILLED = 0.6  # s: about what a filling takes to come to rest
SOFT = 0.02  # stress over the grains' modulus beyond which they are pressed in by a tenth of their radius or so
PRESSED = 0.05  # strain that a stress presses a cell by, about


def laboratory_builder(study: LaboratoryStudy, folder: Path, where: str) -> Callable[[LaboratoryScene, dict], LaboratoryCase]:
    """Builds the cells of a laboratory; BadInput for grains without a density, or a contact that nothing tells of."""
    stresses = tuple(KPA * stress for stress in study.stresses_kPa)

    def build_one(config: LaboratoryScene, settings: dict[str, Any]) -> LaboratoryCase:
        if isnan(material_of(config.grain).density):
            raise BadInput("scene.grain.density_kg_m3", None, "must be given: the material has none", where)
        case = LaboratoryCase(config, folder, stresses, study.shear_strain)
        if stresses[-1] > SOFT * case.modulus:
            told = f"kPa: more than {SOFT:.0%} of the grains' modulus, {case.modulus / MPA:g} MPa, presses them in too far"
            raise BadInput("stresses_kPa", study.stresses_kPa[-1], told, where)
        contacts_of(filling(case), where)  # tells what neither sections nor tables say
        return case

    return build_one


def cost(case: LaboratoryCase) -> float:
    """About how long (s) the tests of a cell compute: grains times steps of filling, pressing and two shears a stress."""
    shears = sum(2.0 * case.shear_strain * case.height / case.speed(stress) for stress in case.stresses)
    pressed = sum(PRESSED * case.height / case.speed(stress) for stress in case.stresses)
    spheres = COSTS[case.config.grains]
    steps = (FILLED + pressed + shears) / spheres.step(filling(case))
    step, tray = spheres.step(filling(case)), draining(case)
    apart = FILLED / step * case.heap_count + (FILLED + tray.events[-1].value) / step * tray.filling.count
    return START + steps * (spheres.look + case.count * spheres.body) + apart * spheres.body
