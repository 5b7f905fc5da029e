"""A laboratory of discs: what it may be asked, what its scenes say, and readings of discs that are put in place by hand."""

from types import SimpleNamespace

import numpy as np
import pandas as pd
import pytest

from silostudy.compute.laboratory_discs import _flanks, _middle, solid_fraction
from silostudy.errors import BadInput
from silostudy.figures import laboratory_solid
from silostudy.scene.dem import contacts_of, events_of, wall_names
from silostudy.scene.laboratory import cost
from silostudy.scene.laboratory_discs import SHEARING, SLIDING, draining, dropping, plate, pressing, shearing
from tests.test_laboratory.made_up import DISCS, cube_of, of_discs

HARD = {"restitution": 0.5, "sliding_friction": 0.25, "normal_stiffness_N_m2": 4e6}


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"stresses_kPa": [1, 60]}, "stresses_kPa = 60.0: kPa: more than 2% of the grains' modulus, 2 MPa"),
        ({"scene__radius_m": 0}, r"scene.*radius_m = 0: must be greater than 0"),
        ({"scene__discs": {"restitution": 0.5}}, "normal_stiffness_N_m2: must be given|give either"),
        ({"scene__walls": HARD | {"sliding_friction": 0.0}}, "scene.walls: sliding_friction must be above 0"),
        ({"cells": [4, 8]}, "cells.0 = 4: must be greater than or equal to 5"),
        ({"scene": {key: value for key, value in DISCS["scene"].items() if key != "walls"}}, "walls: is missing"),
    ],
)
def test_mistakes_are_told_before_anything_is_computed(changes, told):
    with pytest.raises(BadInput, match=told):
        of_discs(**changes)


def frictions(scene) -> dict[str, float]:
    """Sliding friction of every wall of a scene."""
    walls = contacts_of(scene, np.array([scene.radius_m]))[1]
    return {name: walls.numbered(number).coefficients["sliding_friction"] for number, name in enumerate(wall_names(scene))}


def test_floor_and_lid_run_against_each_other_inside_the_solid_and_the_plate_alone_on_the_wall():
    case = of_discs().cases[0].scene
    inside, along = (shearing(case, 1e3, 0.0, plates) for plates in (SHEARING, SLIDING))
    assert frictions(pressing(case, 1e3, 0.0)) == {"floor": 0.0, "left": 0.0, "right": 0.0, "lid": 0.0}
    assert frictions(inside) == {"floor": 5.0, "left": 0.0, "right": 0.0, "lid": 5.0}
    assert frictions(along) == {"floor": 0.25, "left": 0.0, "right": 0.0, "lid": 5.0}
    belts = [events_of(scene, 1.0)[1].what for scene in (inside, along)]
    assert belts[0] == (pytest.approx(0.5 * case.speed(1e3)), "floor", "lid")
    assert belts[1] == (pytest.approx(case.speed(1e3)), "floor")
    stop = inside.events[-1].value
    assert stop * case.speed(1e3) == pytest.approx(case.shear_strain * case.height)


def test_every_test_takes_the_step_factor_and_a_drop_a_tenth_of_it():
    case = of_discs(scene__step_factor=0.5).cases[0].scene
    scenes = pressing(case, 1e3, 0.0), shearing(case, 1e3, 0.0, SHEARING), draining(case), dropping(case)
    assert [scene.march.step_factor for scene in scenes] == [0.5, 0.5, 0.5, 0.05]


def test_pressed_and_sheared_discs_have_no_weight_and_a_tray_s_have():
    case = of_discs().cases[0].scene
    weightless = [pressing(case, 1e3, 0.0), shearing(case, 1e3, 0.0, SHEARING), dropping(case)]
    assert {scene.gravity_m_s2 for scene in weightless} == {(0.0, 0.0)}
    assert draining(case).gravity_m_s2[1] < 0.0


def test_a_wall_that_cannot_hold_discs_gets_a_spring_along_the_contact_with_the_radius_as_its_arm():
    walls = plate(of_discs().cases[0].scene)
    assert walls.rolling == "spring-slider"
    assert walls.model_dump()["rolling_stiffness_N"] == pytest.approx(0.25 * 4e6 * 0.004**2)
    own = HARD | {"rolling": "spring-dashpot-slider", "rolling_stiffness_N": 1.0, "rolling_friction": 0.05}
    kept = plate(of_discs(scene__walls=own).cases[0].scene)
    assert (kept.rolling, kept.model_dump()["rolling_stiffness_N"]) == ("spring-dashpot-slider", 1.0)


def test_a_wider_cell_costs_more_than_a_narrow_one():
    narrow, *_, wide = of_discs().cases
    assert 0.0 < cost(narrow.scene) < cost(wide.scene)


def run_of(places, radius) -> SimpleNamespace:
    """What readings look at of a run whose discs lie at places (n, 2; m)."""
    engine = SimpleNamespace(places=places, time=0.0, model=SimpleNamespace(radius=np.full(len(places), radius)))
    return SimpleNamespace(engine=engine)


def test_flanks_of_a_heap_of_twenty_degrees():
    across = np.arange(-0.3, 0.3, 0.002)
    places = np.column_stack([across, 0.1 - np.abs(across) * np.tan(np.radians(20.0))])
    slope = _flanks(run_of(places, 0.002), places, np.ones(len(places), bool), 0.05, 0.25)
    assert np.degrees(slope) == pytest.approx(20.0, abs=0.3)


def test_the_inside_of_discs_on_a_square_grid_is_filled_by_a_quarter_of_pi():
    case, radius = of_discs().cases[0].scene, 0.004
    x, y = np.meshgrid(np.arange(radius, case.width, 2.0 * radius), np.arange(radius, case.height, 2.0 * radius))
    found = solid_fraction(run_of(np.column_stack([x.ravel(), y.ravel()]), radius), case, case.height)
    assert found == pytest.approx(np.pi / 4.0, rel=0.01)


def test_the_middle_half_of_a_wall_leaves_its_ends_and_a_quarter_on_either_side():
    assert _middle(np.arange(100, 118)).tolist() == list(range(105, 113))


def test_the_row_says_that_its_unit_weight_is_of_a_plane(tmp_path):
    laboratory_solid.draw(cube_of(of_discs()), tmp_path / "solids")
    (remark,) = pd.read_csv(tmp_path / "solids.csv")["remark"]
    assert "discs a metre thick: unit weights are the plane's solid fraction times density" in remark
