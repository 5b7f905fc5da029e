"""What a laboratory may be asked, and what is refused in one line."""

import pytest

from silostudy.config.laboratory import CELL
from silostudy.config.study import FILLING
from silostudy.errors import BadInput
from silostudy.scene.laboratory_scenes import SHEARING, SLIDING, filling, pressing, shearing
from silostudy.scene.spheres import contacts_of
from silostudy.sweep.plan import case_keys
from tests.test_laboratory.made_up import CONTENT, expansion

LIGHTLESS = {"youngs_modulus_MPa": 10, "poissons_ratio": 0.3}
WITHOUT_WALL = {key: value for key, value in CONTENT["scene"].items() if key != "wall"}


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"stresses_kPa": [0, 20]}, "stresses_kPa.0 = 0: must be greater than 0"),
        ({"stresses_kPa": [20, 10]}, r"stresses_kPa = \[20, 10\]: must rise, none twice"),
        ({"stresses_kPa": []}, "stresses_kPa = .*must hold 1 or more"),
        ({"vertical_kPa": 15}, "vertical_kPa = 15 must be one of stresses_kPa"),
        ({"cells": [4.5, 8]}, "cells.0 = 4.5: must be greater than or equal to 5"),
        ({"stresses_kPa": [10, 300]}, "stresses_kPa = 300.0: kPa: more than 2% of the grains' modulus, 10 MPa"),
        ({"cells": [8, 6]}, r": cells = \[8, 6\]: must rise, none twice$"),
        ({"cells": [8, 8]}, r": cells = \[8, 8\]: must rise, none twice$"),
        ({"fillings": 1}, "fillings = 1: must be greater than or equal to 2"),
        ({"scene": WITHOUT_WALL}, "scene.wall: is missing"),
        ({"scene__grains": "cubes"}, "scene.grains = 'cubes': unknown; known: spheres, discs"),
        ({"scene__height_grains": 3}, "scene.height_grains = 3: must be greater than or equal to 5"),
        (
            {"scene__grain": {"youngs_modulus_MPa": 10, "poissons_ratio": 0.3}},
            "scene.grain.density_kg_m3 = None: must be given",
        ),
        ({"scene__walls": {"restitution": 0.3}}, "walls.sliding_friction = None: must be given"),
        ({"sweep": [{"axis": CELL, "values": {"cell_grains": [6, 8]}}]}, "the axes cell and filling are the laboratory's own"),
    ],
)
def test_mistakes_are_told_before_anything_is_computed(changes, told):
    with pytest.raises(BadInput, match=told):
        expansion(**changes)


def test_cells_and_fillings_are_the_last_axes():
    """Further axes may stand before them: of friction, say."""
    friction = {"axis": "friction", "values": {"spheres.sliding_friction": [0.2, 0.4]}}
    found = expansion(sweep=[friction])
    assert found.shape == (2, 2, 3)
    assert [axis.axis for axis in found.study.sweep] == ["friction", CELL, FILLING]
    assert {case.scene.config.seed for case in found.cases} == {0, 1, 2}


def test_a_further_filling_leaves_the_computed_ones_alone():
    few, many = (expansion(fillings=count, cells=[6]) for count in (2, 3))
    assert case_keys(many)[:2] == case_keys(few)
    assert case_keys(expansion(fillings=2, cells=[6], stresses_kPa=[10, 30])) != case_keys(few)


def test_every_test_takes_the_step_factor():
    case = expansion(scene__step_factor=0.5).cases[0].scene
    scenes = filling(case), pressing(case, 1e4, 1.0), shearing(case, 1e4, 1.0, SHEARING)
    assert [scene.march.step_factor for scene in scenes] == [0.5] * 3


def test_stresses_of_the_row_are_the_largest_and_about_its_half():
    study = expansion(stresses_kPa=[10, 40, 100]).study
    assert (study.vertical, study.horizontal) == (100.0, 40.0)


def test_ends_hold_grains_fast_in_shear_and_let_them_slide_under_pressure():
    """The plate is the wall's own friction; the wall of the cell is smooth throughout."""
    case = expansion().cases[0].scene
    for scene, lid, floor in (
        (pressing(case, 1e4, 0.0), 0.0, 0.0),
        (shearing(case, 1e4, 0.0, SHEARING), 5.0, 5.0),
        (shearing(case, 1e4, 0.0, SLIDING), 5.0, 0.2),
    ):
        walls = contacts_of(scene)[1]
        found = {name: walls.numbered(k).coefficients["sliding_friction"] for k, name in enumerate(("floor", "wall", "lid"))}
        assert found == {"floor": floor, "wall": 0.0, "lid": lid}


def test_a_slower_test_takes_longer_and_goes_as_far():
    slow, quick = (expansion(scene__inertial_number=value).cases[0].scene for value in (1e-4, 1e-3))
    ways = [
        (event.value, event.value * scene.events[1].spin_rad_s)
        for scene in (shearing(case, 1e4, 0.0, SHEARING) for case in (slow, quick))
        for event in scene.events[-1:]
    ]
    assert ways[0][0] == pytest.approx(10.0 * ways[1][0])
    assert ways[0][1] == pytest.approx(ways[1][1])


def test_a_wall_that_cannot_hold_grains_gets_a_rolling_law_that_can():
    kept = {"restitution": 0.3, "sliding_friction": 0.2, "rolling_friction": 0.05}
    for rolling in ("constant-torque", "spring-slider", "spring-dashpot-slider"):
        walls = filling(expansion(scene__walls=kept | {"rolling": rolling}).cases[0].scene).walls
        assert walls.laws["rolling"].stores
        assert walls.model_dump()["rolling_friction"] == 0.05
        assert walls.model_dump()["rolling_stiffness_N_m"] > 0.0
