"""The wall of an eccentric cone, against a cone about the axis, differences, strewn triangles and statics."""

from dataclasses import replace
from math import pi

import numpy as np
import pytest

from silostudy.compute.dem_cube import cube_of
from silostudy.dem.space.cells import areas, middles
from silostudy.dem.space.cones import EccentricCone
from silostudy.dem.space.eccentric import eccentric_frame, eccentric_normal
from silostudy.dem.space.felt import turned_frame, turned_normal
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import TurnedLine, walls_of
from silostudy.errors import BadInput
from silostudy.tables.constants import ROUNDED_GRAVITY as GRAVITY
from tests.test_spheres.small import carried, scene_of

OPENS = [{"when": "rest", "do": "open_outlet"}]
START, END = (0.02, 0.01), (0.05, 0.07)  # radius and height, m
CONE = EccentricCone(name="hopper", start=START, end=END, foot=(0.012, -0.016), head=(0.003, 0.002))
TURNED = TurnedLine(name="hopper", start=START, end=END)
RANDOM = np.random.default_rng(4)


def row(surface):
    return walls_of((surface,)).shape


def places_on(cone, count):
    """Places on a cone by their own formula, and the directions in which they lie from the middles of their circles."""
    share, turn = RANDOM.uniform(0.05, 0.95, count), RANDOM.uniform(0.0, 2.0 * pi, count)
    out = np.column_stack([np.cos(turn), np.sin(turn)])
    level = cone.foot + np.outer(share, cone.lean) + (cone.start[0] + share * cone.rise[0])[:, None] * out
    return np.column_stack([level, cone.start[1] + share * cone.rise[1]]), out


def test_about_the_axis_it_is_a_cone():
    """Vectors and curvatures, normals and frames, middles and areas of cells."""
    alike = EccentricCone(name="hopper", start=START, end=END, foot=(0.0, 0.0))
    one, other = row(alike), row(TURNED)
    for place in RANDOM.uniform((-0.05, -0.05, -0.01), (0.05, 0.05, 0.09), (200, 3)):
        assert nearest(one, 0, *place) == pytest.approx(nearest(other, 0, *place), rel=1e-9, abs=1e-15)
    for place in places_on(alike, 50)[0]:
        assert eccentric_normal(one, 0, *place) == pytest.approx(turned_normal(other, 0, *place[:2]), abs=1e-12)
        (share, turn, up), (of, around, upward) = (of(shape, 0, *place) for of, shape in
                                                   ((eccentric_frame, one), (turned_frame, other)))  # fmt: skip
        assert (share, turn, *up) == pytest.approx((of, around, *upward), abs=1e-12)
    cells = [replace(surface, cells=(3, 4)) for surface in (alike, TURNED)]
    for of in (middles, areas):
        assert of(cells[0]) == pytest.approx(of(cells[1]), rel=1e-12, abs=1e-15)


def test_the_nearest_point_stands_on_the_cone_and_the_vector_across_it():
    """A place off the wall by a way along the normal has that point as its nearest, and that normal."""
    shape, (places, out) = row(CONE), places_on(CONE, 200)
    for place, (a, b) in zip(places, out, strict=True):
        tangents = np.array([(-b, a, 0.0), (CONE.lean[0] + CONE.rise[0] * a, CONE.lean[1] + CONE.rise[0] * b, CONE.rise[1])])
        normal = np.cross(tangents[1], tangents[0])
        normal /= np.linalg.norm(normal)
        assert eccentric_normal(shape, 0, *place) == pytest.approx(normal, abs=1e-9)
        away = RANDOM.uniform(-0.004, 0.004) * normal
        found = nearest(shape, 0, *(place + away))
        beyond = found[2] == 1e30 or not START[1] < (place + away - found[:3])[2] < END[1]
        assert beyond or found[:3] == pytest.approx(away, abs=1e-12)


def test_curvature_by_differences():
    """Half the sum of second differences of the distance, which has no bend along the normal."""
    shape, step = row(CONE), 2e-5
    for place in places_on(CONE, 40)[0]:
        at = place + 1e-3 * np.array(eccentric_normal(shape, 0, *place))
        near = [np.linalg.norm(nearest(shape, 0, *(at + way))[:3]) for way in np.vstack([np.eye(3), -np.eye(3)]) * step]
        bend = -(sum(near) - 6.0 * np.linalg.norm(nearest(shape, 0, *at)[:3])) / step**2  # of the circle in which it is off
        on_wall = 2.0 * nearest(shape, 0, *at)[3]
        assert bend == pytest.approx(on_wall / (1.0 - on_wall * 1e-3), rel=1e-3)


def test_cells_areas_are_those_of_triangles():
    along, around, fine = 3, 5, 200
    cone = replace(CONE, cells=(along, around))
    turn = np.linspace(0.0, 2.0 * pi, around * fine + 1)
    out = np.column_stack([np.cos(turn), np.sin(turn), 0.0 * turn])
    rings = [
        np.array([*cone.foot, cone.start[1]]) + share * np.array([*cone.lean, cone.rise[1]])
        + (cone.start[0] + share * cone.rise[0]) * out
        for share in np.linspace(0.0, 1.0, along + 1)
    ]  # fmt: skip
    for k in range(along):
        a, b, c, d = rings[k][:-1], rings[k][1:], rings[k + 1][1:], rings[k + 1][:-1]
        parts = sum(0.5 * np.linalg.norm(np.cross(q - p, r - p), axis=1) for p, q, r in ((a, b, c), (a, c, d)))
        assert areas(cone).reshape(along, around)[k] == pytest.approx(parts.reshape(around, fine).sum(axis=1), rel=1e-4)


@pytest.mark.parametrize(
    ("changes", "told"),
    [({"foot": (0.04, 0.0)}, "must not reach out over the upper one"), ({"start": (0.06, 0.01)}, "must widen upward")],
)
def test_what_is_no_hopper_is_refused(changes, told):
    with pytest.raises(BadInput, match=told):
        replace(CONE, **changes)


@pytest.mark.long  # a kernel of its own
def test_a_bin_with_an_eccentric_cone_carries_its_weight_and_empties():
    """Its loads at rest are the weight, and nothing leaves but through the outlet."""
    scene = scene_of(silo__outlet_eccentricity_m=0.006, events=[*OPENS, {"when": "after", "value": 0.4, "do": "stop"}])
    run = carried(scene)
    cube = cube_of(run, scene)
    opened = float(cube.event_time[0])
    rest = cube.sel(window_time=slice(opened - 0.06, opened))
    weight = GRAVITY * float(cube.grain_mass.sum())
    assert rest.window_time.size >= 2
    assert rest.surface_load.sum("surface").values == pytest.approx(weight, rel=2e-3)
    assert float(rest.surface_load.sel(surface="hopper").min()) > 0.2 * weight
    area = cube.wall_cell_area[cube.wall_name == "hopper"].sum()
    assert float(area) == pytest.approx(areas(run.engine.model.wall_named("hopper")).sum(), rel=1e-9)
    assert run.recording.left["discharged"] > 0.9 * len(cube.grain)
    assert run.recording.left["spilt"] == 0
