"""What sweeps keep of round walls: cells in their places, the window at rest and those in flow."""

import numpy as np
import pytest

from silostudy.compute.scenes_walls import contents_now, keeps_walls, wall_coordinates, wall_numbers, windows_in_flow
from silostudy.dem.space.cells import areas, faces
from silostudy.scene.space_silo import LID
from silostudy.scene.spheres import space_silo_of
from tests.test_spheres.small import run, scene_of

OPENING = 0.05  # s, within the third window of 0.02 s


@pytest.fixture(scope="module")
def made():
    """(scene, run of six windows whose cells feel what their numbers say: 1000 times the window, plus the cell)."""
    scene = scene_of(filling={"kind": "loose", "count": 120}, record__pressure_cells=[4, 6], record__wall_force_window_s=0.02)
    task = run(scene)
    record, cells = task.recording, len(task.engine.record.window)
    for number in range(6):
        felt = 1000.0 * (number + 1) + np.arange(cells)
        record.window.append(felt[:, None, None] * np.array([1.0, 0.5, 0.0])[:, None] * [1.0, 0.5, 2.0])
        record.window_time.append(period(task) * (number + 1))
    return scene, task


def period(task) -> float:
    """Length (s) of a window: whole steps, about 0.02 s."""
    return task.window * task.engine.model.dt


def force_of(task, stem: str, number: int) -> np.ndarray:
    """Normal force (levels, turns) that was made up for a surface in a window."""
    seen = faces(task.engine.model.walls, LID)
    start = sum(face.count for face in seen[: [face.name for face in seen].index(stem)])
    return 1000.0 * (number + 1) + start + np.arange(24).reshape(4, 6)


@pytest.mark.parametrize("stem", ["wall", "hopper"])
def test_windows_and_cells_are_in_their_places(made, stem):
    """At rest: the second window, which ends before the opening; in flow: from the fourth on, which begins after it."""
    scene, task = made
    found = wall_numbers(task, scene, OPENING)
    wall = next(wall for wall in task.engine.model.walls if wall.name == stem)
    area = areas(wall).reshape(4, 6)
    assert found[f"{stem}_pressure_at_rest"] == pytest.approx(force_of(task, stem, 1) / area)
    assert found[f"{stem}_shear_at_rest"] == pytest.approx(0.5 * force_of(task, stem, 1) / area)
    whole = min(3, windows_in_flow(scene))
    for k in range(whole):
        assert found[f"{stem}_pressure_in_flow"][k] == pytest.approx(force_of(task, stem, 3 + k) / area)
    assert np.isnan(found[f"{stem}_pressure_in_flow"][whole:]).all()
    assert found[f"{stem}_largest_pressure"] == pytest.approx(2.0 * force_of(task, stem, 5) / area)
    assert found["flow_window_end"][:whole] == pytest.approx(period(task) * np.arange(4, 4 + whole) - OPENING)


def test_levels_rise_from_below(made):
    scene, task = made
    space, found = space_silo_of(scene), wall_numbers(task, scene, OPENING)
    step = (space.top - space.bottom) / 4
    assert found["wall_level_height"] == pytest.approx(space.bottom + step * (np.arange(4) + 0.5))
    assert found["hopper_level_height"] == pytest.approx(space.bottom * (np.arange(4) + 0.5) / 4)


def test_dimensions_are_those_of_the_numbers(made):
    scene, task = made
    sizes = {name: len(values) for name, values in wall_coordinates(scene).items()}
    found = wall_numbers(task, scene, OPENING)
    assert found["wall_pressure_in_flow"].shape == (sizes["flow_window"], sizes["wall_level"], sizes["wall_turn"])


def test_the_contents_weigh_what_the_spheres_do(made):
    scene, task = made
    space, found = space_silo_of(scene), contents_now(task, scene)
    above = task.engine.places[:, 2] > space.bottom
    weight = (task.engine.mass[above] * 9.80665).sum()
    assert found["filled_height_at_rest"] * found["unit_weight_at_rest"] * space.silo.area == pytest.approx(weight, rel=1e-3)


def test_only_round_silos_of_spheres_whose_walls_are_felt():
    assert keeps_walls(scene_of(record__wall_force_window_s=0.02))
    assert not keeps_walls(scene_of(record__wall_force_window_s=None))
