"""The cube of spheres tells of inserts: the curved sheet of each facet, and the insert of each line of the slice."""

import numpy as np

from silostudy.compute.dem_cube import cube_of
from tests.test_spheres.small import run, scene_of

CORNERS = (
    [[0.02, -0.01, 0.09], [0.02, 0.01, 0.09], [0.02, 0.01, 0.1]],
    [[0.02, -0.01, 0.09], [0.02, 0.01, 0.1], [0.02, -0.01, 0.1]],
)


def cube(**own):
    """The cube of a bin with two triangles whose run is made up: no kernel is compiled."""
    inserts = [{"kind": "polygon", "name": f"tube_{k + 1}", "corners_m": corners} | own for k, corners in enumerate(CORNERS)]
    scene = scene_of(inserts=inserts, record__fields=None, record__contact_statistics=None)
    task = run(scene)
    task.recording.window.append(np.ones((len(task.engine.record.window), 3, 3)))
    task.recording.whole.append(np.ones((sum(wall.faces for wall in task.engine.model.walls), 3, 2)))
    task.recording.window_time.append(0.02)
    return cube_of(task, scene)


def test_facets_of_a_curved_sheet_are_told_by_its_name():
    found = cube(sheet="tube")
    sheets = dict(zip(found["surface"].values, found["surface_sheet"].values, strict=True))
    assert {name: sheets[name] for name in ("tube_1", "tube_2", "tube_1_back", "tube_2_back", "floor")} == {
        "tube_1": "tube", "tube_2": "tube", "tube_1_back": "tube_back", "tube_2_back": "tube_back", "floor": "floor"
    }  # fmt: skip
    assert "surface_sheet" not in cube()


def test_lines_of_the_slice_name_their_insert():
    found = cube()
    assert found["insert_name"].values.tolist() == ["tube_1"] * 3 + ["tube_2"] * 3
    assert np.isnan(found["insert_x"].values[2::3]).all()
