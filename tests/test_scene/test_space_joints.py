"""Joints of a silo's surfaces: no jump of the push over them, no double push, one nearest point at the corner of a hole."""

from itertools import pairwise
from math import atan, cos, hypot, pi, sin, sqrt, tan

import numpy as np
import pytest

from silostudy.dem.space.rows import OUT_OF_REACH
from silostudy.dem.space.surfaces import nearest, square_apart
from silostudy.dem.space.walls import FlatPiece, walls_of
from tests.test_scene.sheet import Sheet
from tests.test_scene.spaces import (
    BALL,
    CONE,
    PRESSED,
    SPACES,
    WIDE,
    every_silo,
    firsts,
    opens,
    push,
    shape_of,
    space,
    vectors,
)


def line(*corners, step=1.03e-5) -> np.ndarray:
    """Points along straight lines from corner to corner."""
    parts = [np.linspace(a, b, int(hypot(*np.subtract(b, a)) / step) + 2) for a, b in pairwise(corners)]
    return np.concatenate(parts)


def arc(edge_x, first, last, step=1.03e-3) -> np.ndarray:
    """Points of a middle that a sphere turns about an edge at z = 0, from an angle to another."""
    turn = np.arange(first, last, step)
    return np.c_[edge_x + PRESSED * np.cos(turn), np.zeros_like(turn), PRESSED * np.sin(turn)]


BETA = CONE.half_angle
BOTTOM = 0.06 / tan(BETA)  # of the walls over CONE
INNER = WIDE / 2 - PRESSED
JOINT = (INNER + PRESSED / cos(BETA) - 0.04) / tan(BETA)  # height of a sphere that is pressed on wall and hopper
OVER_RIM = 0.04 - PRESSED * cos(BETA), 0.0, PRESSED * sin(BETA)
LOW_CORNER = 0.04 + PRESSED * (sin(BETA) * tan(BETA) - 1.0 / cos(BETA))  # of a pyramid, where faces end in rims


def down_a_cone(side: float, low: float) -> np.ndarray:
    """Down the wall, the cone and around its rim, whose edge is low (m) off the axis, on one side of the plane of y = 0."""
    beta = atan((WIDE / 2 - low) / BOTTOM)
    joint, rim = (INNER + PRESSED / cos(beta) - low) / tan(beta), (low - PRESSED * cos(beta), 0.0, PRESSED * sin(beta))
    way = line((INNER, 0.0, BOTTOM + 0.03), (INNER, 0.0, joint), rim)
    return np.concatenate([way, arc(low, pi - beta, 2.0 * pi - beta)]) * (side, 1.0, 1.0)


def corner_of(sides: int) -> tuple[float, float]:
    return INNER, INNER * tan(pi / sides)


def past_a_corner(sides: int, z: float) -> np.ndarray:
    """Along one wall into its corner, and out along the next."""
    turn = 2.0 * pi / sides
    return line((INNER, 0.0, z), (*corner_of(sides), z), (INNER * cos(turn), INNER * sin(turn), z))


WAYS = {
    "cylinder, cone, rim": (SPACES["cone"], np.concatenate([
        line((INNER, 0.0, BOTTOM + 0.03), (INNER, 0.0, JOINT), OVER_RIM), arc(0.04, pi - BETA, 2.0 * pi - BETA)])),
    "down the flat side of an eccentric cone": (SPACES["eccentric cone"], down_a_cone(-1.0, 0.005)),
    "down its steep side": (SPACES["eccentric cone"], down_a_cone(1.0, 0.075)),
    "rim of a hole": (SPACES["hole"], np.concatenate([line((0.07, 0.0, PRESSED), (0.04, 0.0, PRESSED)),
                                                      arc(0.04, pi / 2, 3 * pi / 2)])),
    "rim of an eccentric hole": (SPACES["eccentric hole"], arc(0.08, pi / 2, 3 * pi / 2)),
    "rim of a slot": (SPACES["slot in a circle"], np.concatenate([line((0.07, 0.0, PRESSED), (0.055, 0.0, PRESSED)),
                                                                 arc(0.055, pi / 2, 3 * pi / 2)])),
    "beside the corner of a slot": (SPACES["slot in a circle"], line(
        (0.07, 0.049, PRESSED), (0.0541, 0.049, PRESSED))),
    "edge of a pyramid": (SPACES["square, pyramid"], line(
        (INNER, INNER, BOTTOM + 0.02), (INNER, INNER, JOINT), (LOW_CORNER, LOW_CORNER, PRESSED * sin(BETA)),
        (LOW_CORNER, LOW_CORNER, -0.01))),
    "end of a wedge": (SPACES["square, wedge"], line((0.0, INNER, BOTTOM + 0.02), (0.0, INNER, BOTTOM - 0.02))),
    "end of a slot": (SPACES["rectangle, slot from wall to wall"], line(
        (0.0, 0.15 - PRESSED, 0.02), (0.0, 0.15 - PRESSED, -0.01))),
    "end of a slot across": (SPACES["rectangle, slot across"], line(
        (INNER, 0.05, 0.02), (INNER, 0.05, -0.01))),
    "rim of a slot across": (SPACES["rectangle, slot across"], line((INNER, 0.1, PRESSED), (INNER, 0.08, PRESSED))),
    "corner of a hexagon": (SPACES["hexagon, pyramid"], past_a_corner(6, BOTTOM + 0.05)),
    "corner of most sides": (space("polygonal", sides=24), past_a_corner(24, 0.1)),
}  # fmt: skip


@pytest.mark.parametrize(("of", "way"), WAYS.values(), ids=WAYS)
def test_push_has_no_jump_over_joints(of, way):
    """A sphere that is pressed in by 2e-4 m: each surface's push changes by hardly more than the way."""
    shape = shape_of(of, opens(of))
    pushes = np.array([push(shape, point) for point in way])
    steps, changes = (np.linalg.norm(np.diff(of, axis=0), axis=1) for of in (way, pushes))
    assert steps.max() < 1.1e-5
    assert (changes < 3.5 * steps + 1e-12).all()
    assert np.linalg.norm(pushes, axis=1)[: len(pushes) // 2].min() > 0.9 * (BALL - PRESSED)


@pytest.mark.parametrize(
    ("name", "opened", "point", "count"),
    [
        ("cone", False, (INNER, 0.0, BOTTOM + 0.05), 1),
        ("cone", False, (INNER, 0.0, JOINT), 2),
        ("cone", False, (0.0, 0.0, PRESSED), 1),
        ("cone", True, OVER_RIM, 1),
        ("cone", True, (0.04 - PRESSED, 0.0, -0.001), 1),
        ("eccentric cone", False, (INNER, 0.0, BOTTOM + 0.05), 1),
        ("eccentric cone", True, (0.035, 0.04 - PRESSED, -0.001), 1),
        ("hole", False, (0.04, 0.0, PRESSED), 1),
        ("hole", True, (0.04, 0.0, PRESSED), 1),
        ("hole", True, (0.039, 0.0, PRESSED), 1),
        ("hole", False, (INNER, 0.0, PRESSED), 2),
        ("square, hole", True, (-INNER, INNER, PRESSED), 3),
        ("square, pyramid", False, (INNER, INNER, JOINT), 4),
        ("square, pyramid", True, (LOW_CORNER, LOW_CORNER, PRESSED * sin(BETA)), 2),
        ("square, wedge", True, (0.0, INNER, BOTTOM + 1e-9), 1),
        ("slot in a circle", True, (0.055 - 0.007, 0.05 - 0.007, -0.005), 1),
        ("slot in a circle", True, (0.055, 0.0, PRESSED), 1),
        ("slot in a circle", True, (0.055 - 1e-6, 0.05 - 1e-6, PRESSED), 1),
        ("square, pyramid", True, (0.042, 0.03, -0.004), 1),  # from below, outside the rim
        ("square, pyramid", True, (0.042, 0.043, -0.004), 0),  # and outside its corner
        ("rectangle, slot across", True, (INNER, 0.05, 0.001), 1),  # the wall alone: the hole has no rim there
        ("rectangle, slot from wall to wall", True, (0.0, 0.15 - PRESSED, 0.001), 1),
        ("octagon, hole", False, (0.0, 0.0, PRESSED), 1),
        ("hexagon, pyramid", True, (*corner_of(6), BOTTOM + 0.05), 2),
    ],
)
def test_as_many_surfaces_push_as_a_sphere_touches(name, opened, point, count):
    shape = shape_of(SPACES[name], opened)
    assert sum(np.linalg.norm(away) < BALL for away in vectors(shape, point)) == count


@every_silo
def test_what_comes_over_a_joint_was_listed_before(of):
    """Lists go by a distance that is a push's where there is one, and shrinks by no more than a point moves."""
    shape, random = shape_of(of, opens(of)), np.random.default_rng(11)
    points = random.uniform((-0.1, -0.15, 0.0), (0.1, 0.15, of.top), (60, 3))
    points[30:, 2] = of.bottom + random.uniform(-0.01, 0.01, 30)  # over the joint of hopper and walls, and back
    points = points[Sheet(of, True).within(points)]
    for point in points:
        step = random.normal(size=3)
        step *= random.uniform(0.001, 0.02) / np.linalg.norm(step)
        if not Sheet(of, True).within((point + step)[None])[0]:
            continue
        for q in firsts(shape):
            here, there = (sqrt(square_apart(shape, q, *place)) for place in (point, point + step))
            assert here <= there + np.linalg.norm(step) + 1e-12
            away = np.array(nearest(shape, q, *point)[:3])
            assert away[0] == OUT_OF_REACH or here == pytest.approx(np.linalg.norm(away), rel=1e-12)


@pytest.mark.parametrize("inward", [(0.0, 0.0), (1e-12, 1e-12), (1e-4, 3e-4), (3e-4, 1e-4), (-1e-4, 1e-4), (-1e-4, -1e-4)])
def test_the_corner_of_a_hole_pushes_from_one_nearest_point(inward):
    """A sphere beside the corner at (0.055, 0.05): from below itself over the floor, else from the nearer side."""
    shape = shape_of(SPACES["slot in a circle"], True)
    x, y = np.subtract((0.055, 0.05), inward)
    nearer = np.zeros(2) if min(inward) <= 0.0 else np.array([-inward[0], 0.0] if inward[0] <= inward[1] else [0.0, -inward[1]])
    found = push(shape, (x, y, PRESSED))
    away = np.array([*nearer, PRESSED])
    assert found == pytest.approx(away * (BALL / np.linalg.norm(away) - 1.0), rel=1e-9)


def slanted(*corners) -> tuple[float, ...]:
    """Corners on a plane that no axis lies in, no number of theirs round."""
    frame = np.linalg.qr(np.array([(0.3, 0.5, 0.7), (0.2, -0.6, 0.1), (0.9, 0.4, -0.3)]))[0]
    return [tuple(float(v) for v in frame @ (x, y, 0.02)) for x, y in corners]


A, B, C, D = slanted((0.0, 0.0), (0.1, 0.013), (0.11, 0.1), (0.004, 0.09))


def test_pieces_of_one_plane_push_once_along_their_joint():
    """Over the diagonal of a quadrangle of two triangles, where rounding would have it on both or on neither."""
    shape = walls_of([FlatPiece(name="one", corners=(A, B, C)), FlatPiece(name="two", corners=(A, C, D))]).shape
    whole = walls_of([FlatPiece(name="whole", corners=(A, B, C, D))]).shape
    normal = np.cross(np.subtract(B, A), np.subtract(D, A))
    normal /= np.linalg.norm(normal)
    for share in np.linspace(0.0, 1.0, 501):
        point = np.array(A) + share * np.subtract(C, A) + PRESSED * normal
        assert push(shape, point) == pytest.approx((BALL - PRESSED) * normal, rel=1e-9)
    for point in np.random.default_rng(3).uniform(-0.02, 0.13, (500, 3)):
        assert nearest(shape, 0, *point) == pytest.approx(nearest(whole, 0, *point), abs=1e-12)
