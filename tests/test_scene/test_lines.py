"""Lines in a scene of discs as a user writes them: names, coefficients, what starts, what the cube holds, bad input."""

import numpy as np
import pytest

from silostudy.compute.dem import scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.config.dem import DemScene
from silostudy.config.load import validated
from silostudy.dem.varied import Varied
from silostudy.errors import BadInput
from silostudy.scene.dem import check_start, contacts_of, wall_names
from tests.conftest import ROOT
from tests.test_dem.small import SMALL, carried, scene_of

POST = {"kind": "line", "name": "post", "ends_m": [[0.085, 0.05], [0.085, 0.12]]}
BASE = {"kind": "line", "name": "base", "ends_m": [[-0.1, -0.1], [0.3, -0.1]]}


def model_of(*inserts, **changes):
    return scene_model(scene_of(inserts=list(inserts), **changes), ROOT)


def test_lines_are_walls_by_their_names():
    assert wall_names(scene_of(inserts=[POST, BASE])) == ["floor", "floor_left", "floor_right", "left", "right", "post", "base"]
    model = model_of(POST, BASE)
    assert [wall.faces for wall in model.walls] == [1] * 5 + [2] * 2
    assert {wall.cells for wall in model.walls} == {5}


def test_a_line_has_coefficients_of_its_own():
    scene = scene_of(inserts=[POST, BASE], surfaces={"post": {"sliding_friction": 0.9}})
    _, walls = contacts_of(scene, np.array([0.01]))
    assert isinstance(walls, Varied)
    friction = [walls.numbered(n).coefficients["sliding_friction"] for n in range(7)]
    assert friction == [0.176] * 5 + [0.9, 0.176]


def test_discs_that_would_cut_a_line_are_left_out():
    without, model = model_of(), model_of(POST)
    gone = {tuple(place) for place in without.place} - {tuple(place) for place in model.place}
    assert len(gone) == len(without.x) - len(model.x) > 2
    for x, y in gone:
        assert np.hypot(x - 0.085, y - np.clip(y, 0.05, 0.12)) < 0.01
    check_start(model.walls, model.x, model.y, model.radius)


@pytest.mark.parametrize("aside", [-0.006, 0.006])
def test_a_disc_of_a_file_may_not_cut_a_line(aside):
    walls = model_of(POST).walls
    with pytest.raises(BadInput, match="disc 0': starts in or beyond the wall post"):
        check_start(walls, np.array([0.085 + aside]), np.array([0.125]), np.array([0.01]))
    check_start(walls, np.array([0.085 + 2.0 * aside]), np.array([0.125]), np.array([0.01]))


WRONG = {
    "no length": ([{**POST, "ends_m": [[0.1, 0.1], [0.1, 0.1]]}], "inserts.0 = 'post': a wall must have a length"),
    "one end": ([{**POST, "ends_m": [[0.1, 0.1]]}], "inserts.0.*ends_m"),
    "a silo's name": ([{**POST, "name": "left"}], "inserts.0.name = 'left': is taken; taken by then: floor"),
    "a part's name": ([{**POST, "name": "floor_2"}], "inserts.0.name = 'floor_2': is taken"),
    "a back's name": ([POST, {**BASE, "name": "post_back"}], "inserts.1.name = 'post_back': is taken"),
    "a back of that name": (
        [{**BASE, "name": "post_back"}, POST],
        "inserts.1.name = 'post': has a back recorded as post_back, which is taken",
    ),
    "one name twice": ([POST, {**BASE, "name": "post"}], "inserts.1.name = 'post': is taken"),
    "on the floor": ([{**POST, "ends_m": [[0.1, 0.0], [0.3, 0.0]]}], "inserts.0 = 'post': lies on floor along 0.07 m"),
    "on a line": ([BASE, {**POST, "ends_m": [[0.2, -0.1], [0.5, -0.1]]}], "inserts.1 = 'post': lies on base along 0.1 m"),
    "of spheres": ([{"kind": "disc", "name": "plate", "radius_m": 0.1, "height_m": 0.1}], "inserts.0.*line"),
    "no room": ([{**POST, "name": f"p {n}", "ends_m": [[0.0, 0.01 * n], [0.17, 0.01 * n]]} for n in range(1, 40)], "no room"),
}


@pytest.mark.parametrize("case", WRONG)
def test_bad_lines(case):
    inserts, told = WRONG[case]
    with pytest.raises(BadInput, match=told):
        scene_model(validated(DemScene, {**SMALL, "inserts": inserts}, "small.yaml"), ROOT)


def test_lines_that_meet_or_cross_walls_are_fine():
    chute, beam = [[0.055, 0.0], [0.03, -0.1]], [[-0.1, 0.2], [0.3, 0.2]]
    lines = {"post": POST["ends_m"], "base": BASE["ends_m"], "chute": chute, "beam": beam}
    model = model_of(*({**POST, "name": name, "ends_m": ends} for name, ends in lines.items()))
    assert {wall.name: [list(wall.start), list(wall.end)] for wall in model.walls[-4:]} == lines


@pytest.mark.long
def test_the_cube_holds_both_faces_of_a_line():
    scene = scene_of(inserts=[POST, BASE], events=[{"when": "time", "value": 0.3, "do": "stop"}], record__snapshots_s=[0.3])
    cube = cube_of(carried(scene), scene)
    assert cube["surface"].to_numpy().tolist()[-4:] == ["post", "post_back", "base", "base_back"]
    assert cube["wall_name"].to_numpy().tolist()[-28:] == [
        name for name in ("post", "post_back", "base", "base_back") for _ in range(7)
    ]
    last = cube["surface_normal_force_mean"].isel(window_time=-1)
    assert float(last.sel(surface="post")) > 0.0
    assert float(last.sel(surface="post_back")) > 0.0
    x = cube["wall_cell_x"].where(cube["wall_name"] == "post_back", drop=True)
    assert np.allclose(x, 0.085)
