"""The walls of a plane silo: closed, with the solid on their left, and found by name wherever they stand in the list."""

from dataclasses import replace
from math import radians

import numpy as np
import pytest

from silostudy.accuracy.silo import silo_of_rows, wall_force
from silostudy.compute.arch import find_arch
from silostudy.compute.grains import record
from silostudy.compute.packing_measure import cells_of
from silostudy.config.grains import GrainsScene
from silostudy.dem.change import swap_walls
from silostudy.dem.engine import Engine
from silostudy.dem.walls import nearest, square_apart, sums_by_wall, wall_cells, walls_of
from silostudy.errors import BadInput
from silostudy.scene.plane_silo import FLOOR, HALVES, HOPPER, LID, SIDES, PlaneSilo, inner_width

SILOS = {
    "closed box": PlaneSilo(0.4, 0.6, lid=True),
    "open box with a slit": PlaneSilo(0.4, 0.6, 0.08),
    "hopper": PlaneSilo(0.4, 0.6, 0.08, radians(30.0), lid=True),
}


@pytest.mark.parametrize("silo", SILOS.values(), ids=SILOS)
def test_walls_enclose_the_solid_on_their_left(silo):
    """Shoelace formula over the walls that are there at the start, the open top closed by a straight line."""
    ends = [wall for wall in silo.walls() if wall.live]
    if not silo.lid:
        (x0, y0), (x1, y1) = ends[-1].end, ends[-2].start
        ends = [*ends, replace(ends[0], start=(x0, y0), end=(x1, y1))]
    area = 0.5 * sum(wall.start[0] * wall.end[1] - wall.end[0] * wall.start[1] for wall in ends)
    wedge = silo.bottom * 0.5 * (silo.width + silo.slit)
    assert area == pytest.approx(silo.width * silo.height + wedge, rel=1e-12)
    assert sorted(wall.start for wall in ends) == sorted(wall.end for wall in ends)  # one closed line


@pytest.mark.parametrize("silo", SILOS.values(), ids=SILOS)
def test_what_comes_over_a_joint_was_listed_before(silo):
    """Lists go by a distance that is a push's where there is one, and shrinks by no more than a point moves."""
    shape, random = walls_of(silo.walls()).shape, np.random.default_rng(3)
    points = random.uniform((-0.25, 0.0), (0.25, 0.8), (40, 2))
    steps = random.normal(0.0, 0.02, (40, 2))
    for point, step in zip(points, steps, strict=True):
        for q in range(len(shape)):
            here, there = (np.sqrt(square_apart(shape, q, *place)) for place in (point, point + step))
            assert here <= there + np.linalg.norm(step) + 1e-12
            away = nearest(shape, q, *point)[:2]
            assert away[0] > 1e29 or here == pytest.approx(np.hypot(*away), rel=1e-12)


def test_the_slit_is_in_the_middle_of_the_bottom():
    flat, hopper = ({wall.name: wall for wall in SILOS[name].walls()} for name in ("open box with a slit", "hopper"))
    for left, right in (tuple(flat[name] for name in HALVES), tuple(hopper[name] for name in HOPPER)):
        assert (left.end[0], right.start[0]) == pytest.approx((0.16, 0.24), rel=1e-12)
        assert left.end[1] == right.start[1] == 0.0
    assert [flat[name].live for name in (FLOOR, *HALVES)] == [True, False, False]
    assert SILOS["hopper"].bottom == pytest.approx(0.16 * 3**0.5, rel=1e-12)
    assert LID in hopper


def test_cells_of_the_halves_may_be_others():
    cells = {wall.name: wall.cells for wall in SILOS["open box with a slit"].walls(40, 16)}
    assert cells == {FLOOR: 40} | dict.fromkeys(HALVES, 16) | dict.fromkeys(SIDES, 40)


@pytest.fixture(scope="module")
def pair():
    """A small silo that begins to flow, and the same one with its walls listed the other way round."""
    model, slit = silo_of_rows(6, 6)
    walls = PlaneSilo(inner_width(model), 0.3, slit).walls(5, 2)
    return [replace(model, walls=listed, watched=True) for listed in (walls, walls[::-1])]


def test_walls_are_found_wherever_they_stand(pair):
    engines = [Engine(model) for model in pair]
    found = []
    for engine in engines:
        forces, _, normal = record(GrainsScene.model_construct(), engine, np.array([0, 2000, 4000]))
        swap_walls(engine, FLOOR, HALVES)
        engine.step_to(4001)
        arch = find_arch(engine)
        assert arch is not None
        found.append([*forces.ravel(), normal, *wall_force(engine, 3).ravel(), arch.span, inner_width(engine.model)])
    assert found[0][6] > 0.0  # the walls carry something
    assert found[0] == found[1]


def test_cells_are_found_wherever_their_walls_stand(pair):
    cells = [[wall.name for wall in model.walls for _ in range(wall.cells + 2)] for model in pair]
    for model, names in zip(pair, cells, strict=True):
        for name in (FLOOR, *HALVES, *SIDES):
            assert {names[cell] for cell in wall_cells(model, name)} == {name}
        sums = sums_by_wall(model, np.ones((len(names), 2)))
        assert {name: sums[name].tolist() for name in sums} == {wall.name: [wall.cells + 2.0] * 2 for wall in model.walls}


def test_side_cells_run_from_the_floor_up(pair):
    class Rested:
        model = pair[1]

    height = np.concatenate([np.linspace(w.start[1], w.end[1], w.cells + 2) for w in Rested.model.walls])
    assert (np.diff(height[cells_of(Rested).sides], axis=1) > 0.0).all()


def test_an_unknown_wall_names_the_known(pair):
    with pytest.raises(BadInput, match=r"wall = 'ceiling': unknown; known: floor, floor_left, floor_right, left, right"):
        pair[0].wall_named("ceiling")
