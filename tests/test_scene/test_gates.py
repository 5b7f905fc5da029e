"""Gates of hoppers: what is left of them as they open, how wide they are, and that one edge pushes at their rims."""

from dataclasses import replace

import numpy as np
import pytest
from scipy.spatial import cKDTree

from silostudy.dem.space.gate import widen
from silostudy.dem.space.level import Outline
from silostudy.dem.space.rows import MORE, OUT_OF_REACH, RIM
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import walls_of
from silostudy.scene.space_silo import FLOOR, OUTLET, SpaceSilo
from tests.test_scene.sheet import Sheet
from tests.test_scene.spaces import BALL, CONE, SPACES, space, vectors

GATES = {name: replace(of, gated=True) for name, of in SPACES.items() if of.silo.hopper and of.openings} | {
    f"{sides} sides, pyramid": replace(space("polygonal", CONE, sides=sides), gated=True) for sides in (3, 5, 24)
}
every_gate = pytest.mark.parametrize("of", GATES.values(), ids=GATES)
SPEED, STEP = 0.1, 0.01  # m/s, s
PITCH, OFF = 0.0011, 0.00031  # m: of points, and of the first from a corner: none lies on a rim


def begun(of: SpaceSilo) -> np.ndarray:
    """Rows of the surfaces, the gate first, which has begun to open."""
    gate, *_ = walls = of.walls()
    shape = walls_of(walls).shape
    assert gate.name == FLOOR
    gate.opened(shape[0], (OUTLET,), SPEED)
    return shape


def hole_of(of: SpaceSilo, half: float) -> Outline:
    """The hole of a gate that is opened by a half width (m): a rectangle along x, others all around."""
    (outline,) = of.openings.values()
    return replace(outline, half=(half, outline.half[1] if outline.sides == 4 else half))


def rim_of(hole: Outline) -> np.ndarray:
    """Points (n, 2; m) all along the rim that moves."""
    ring = Sheet.ring(hole.sides, *hole.half, hole.middle[0], 0.0, PITCH)[:, :2]
    return ring[abs(abs(ring[:, 0] - hole.middle[0]) - hole.half[0]) < 1e-9] if hole.sides == 4 else ring


@every_gate
def test_its_hole_is_as_large_as_the_time_says(of):
    """Points of the outlet are on what is left, or in the hole, whose nearest rim is as near as a search says."""
    shape, (outlet,) = begun(of), of.openings.values()
    (low, left), (high, right) = outlet.box
    x, y = (of.ravel() for of in np.meshgrid(np.arange(low + OFF, high, PITCH), np.arange(left + OFF, right, PITCH)))
    x, y = x[(inside := outlet.inset(x, y) > 0.0)], y[inside]
    steps = 0
    while not widen(shape, 0, STEP):
        steps += 1
        half = 0.5 * SPEED * STEP * steps
        assert shape[0, MORE + RIM + 3] == pytest.approx(half, rel=1e-12)
        hole = hole_of(of, half)
        away = np.array([nearest(shape, 0, *point, 0.0)[:3] for point in zip(x, y, strict=True)])
        off = np.linalg.norm(away, axis=1)
        assert ((off > 0.0) == (hole.inset(x, y) > 0.0)).all()
        assert PITCH**2 * np.count_nonzero(off) == pytest.approx(
            hole.area, abs=1.5 * PITCH * sum(2.0 * side for side in hole.half)
        )
        searched = cKDTree(rim_of(hole)).query(np.column_stack([x, y])[off > 0.0])[0]
        assert searched == pytest.approx(off[off > 0.0], abs=PITCH)
    assert steps == round(outlet.half[0] / (0.5 * SPEED * STEP)) - 1


@every_gate
def test_one_edge_pushes_until_the_hopper_s_own_does(of):
    """Beside the middle of a side a ball meets the gate's rim alone, and where that has gone the hopper's edge, as near."""
    shape, (outlet,) = begun(of), of.openings.values()
    ways = [(np.cos(turn), np.sin(turn)) for turn in (0.3, 2.0)] if outlet.sides == 0 else outlet.normals
    ways = [way for way in ways if outlet.sides != 4 or abs(way[0]) > 0.5]
    before = shape.copy()
    for left in (0.5 * outlet.half[0], 1e-4, 1e-6):  # m, to the hopper's edges
        shape[0, MORE + RIM + 3] = 0.0
        assert not widen(shape, 0, 2.0 * (outlet.half[0] - left) / SPEED)
        for way in ways:
            point = outlet.middle + np.multiply(way, outlet.half[0] - left - 0.6 * BALL)
            met = [away for away in vectors(shape, (*point, -0.3 * BALL)) if np.linalg.norm(away) < BALL]
            assert np.array(met) == pytest.approx(np.array([(*np.multiply(way, -0.6 * BALL), -0.3 * BALL)]))
    assert not np.array_equal(shape[1:], before[1:])
    assert widen(shape, 0, 1.0)
    assert np.array_equal(shape[1:], before[1:])
    for way in ways:
        point = outlet.middle + np.multiply(way, outlet.half[0] - 0.6 * BALL)
        met = [away for away in vectors(shape[1:], (*point, -0.3 * BALL)) if np.linalg.norm(away) < BALL]
        assert np.array(met) == pytest.approx(np.array([(*np.multiply(way, -0.6 * BALL), -0.3 * BALL)]))


def test_a_gate_that_is_opened_again_goes_on_from_its_width():
    of = GATES["hexagon, pyramid"]
    shape, gate = begun(of), of.walls()[0]
    widen(shape, 0, STEP)
    gate.opened(shape[0], (OUTLET,), 3.0 * SPEED)
    widen(shape, 0, STEP)
    assert shape[0, MORE + RIM + 3] == pytest.approx(0.5 * SPEED * STEP * 4.0)
    gate.opened(shape[0], (OUTLET,), 0.0)
    assert shape[0, MORE + RIM + 3] == 0.04
    assert nearest(shape, 0, of.openings[OUTLET].middle[0], 0.0, 0.0)[0] not in (0.0, OUT_OF_REACH)
