"""Inserts of a silo of spheres: one push from their nearest point, on either side and round their rims and ridges."""

from dataclasses import replace
from itertools import pairwise
from math import cos, hypot, pi, radians, sin, sqrt

import numpy as np
import pytest
from scipy.spatial import cKDTree

from silostudy.dem.space.cells import areas, faces
from silostudy.dem.space.inserts import cone, cylinder, disc, polygon
from silostudy.dem.space.rows import OUT_OF_REACH
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import walls_of
from silostudy.errors import BadInput
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import LID, SpaceSilo

BALL, PRESSED = 0.01, 0.0098  # m: a sphere, and its distance from what it is pressed on
AXIS = (0.02, -0.01)
HAT = cone("hat", (0.03, 0.0), (0.1, 0.12), AXIS)
SKIRT = cylinder("skirt", 0.03, (0.08, 0.1), AXIS)
RIDGE, EAVES = ((-0.03, 0.0, 0.12), (0.03, 0.0, 0.12)), (((-0.03, -0.03, 0.1), (0.03, -0.03, 0.1)),
                                                         ((-0.03, 0.03, 0.1), (0.03, 0.03, 0.1)))  # fmt: skip
ROOF = tuple(polygon(name, (*eave, *RIDGE[::-1]), "both") for name, eave in zip(("right", "left"), EAVES, strict=True))


def silo(*inserts, **changes) -> SpaceSilo:
    return SpaceSilo(silo=Silo(**({"plan": "circular", "diameter": 0.2, "wall_depth": 0.3} | changes)), inserts=inserts)


def vectors(shape, point) -> list[np.ndarray]:
    found = [np.array(nearest(shape, q, *point)[:3]) for q in range(len(shape))]
    return [away for away in found if away[0] != OUT_OF_REACH]


def push(shape, point) -> np.ndarray:
    """Push on a sphere by springs of stiffness one (m)."""
    pushes = [away * (BALL / length - 1.0) for away in vectors(shape, point) if (length := np.linalg.norm(away)) < BALL]
    return np.sum(pushes, axis=0) if pushes else np.zeros(3)


def strewn(of, pitch=0.0008) -> np.ndarray:
    """Points all over inserts, by formulas of their own."""
    u, v = (axis.ravel() for axis in np.meshgrid(np.linspace(0.0, 1.0, 200), np.linspace(0.0, 1.0, 200)))
    if of is HAT or of is SKIRT:
        r, z = (0.03 * u, 0.12 - 0.02 * u) if of is HAT else (0.03 + 0.0 * u, 0.08 + 0.02 * u)
        return np.c_[AXIS[0] + r * np.cos(2 * pi * v), AXIS[1] + r * np.sin(2 * pi * v), z]
    sign = -1.0 if of.name == "right" else 1.0
    return np.c_[-0.03 + 0.06 * v, sign * 0.03 * (1.0 - u), 0.1 + 0.02 * u]


@pytest.mark.long
@pytest.mark.parametrize("inserts", [(HAT,), (HAT, SKIRT), ROOF], ids=["hat", "hat on a skirt", "roof"])
def test_distances_against_a_search(inserts):
    """On both sides and past every edge: the least distance is that of the nearest strewn point."""
    shape, cloud = walls_of(inserts).shape, np.concatenate([strewn(of) for of in inserts])
    tree, random = cKDTree(cloud), np.random.default_rng(2)
    points = cloud[random.integers(0, len(cloud), 600)] + random.uniform(-0.015, 0.015, (600, 3))
    for point, most in zip(points, tree.query(points)[0], strict=True):
        least = min(np.linalg.norm(away) for away in vectors(shape, point))
        assert least <= most + 1e-9
        assert most <= sqrt(least**2 + 2.0 * 0.0008**2)


def arc(middle, first, last, step=1.03e-3) -> np.ndarray:
    """Points (m) across and up that are pressed on an edge, over an angle."""
    turn = np.arange(first, last, step)
    return np.c_[middle[0] + PRESSED * np.cos(turn), middle[1] + PRESSED * np.sin(turn)]


def lines(*corners, step=1.03e-5) -> np.ndarray:
    return np.concatenate([np.linspace(a, b, int(hypot(*np.subtract(b, a)) / step) + 2) for a, b in pairwise(corners)])


SLOPE = np.arctan2(0.02, 0.03)
OVER = np.array([sin(SLOPE), cos(SLOPE)]) * PRESSED  # across and up from a slope that falls outward


def over(*corners) -> list[tuple[float, float]]:
    return [tuple(np.add(corner, OVER)) for corner in corners]


WAYS = {
    "over a ridge and round the eaves": (ROOF, np.concatenate([
        lines((-0.03 - OVER[0], 0.1 + OVER[1]), (-OVER[0], 0.12 + OVER[1])),
        arc((0.0, 0.12), pi / 2 + SLOPE, pi / 2 - SLOPE, -1.03e-3),
        lines(*over((0.0, 0.12), (0.03, 0.1))), arc((0.03, 0.1), pi / 2 - SLOPE, -pi / 2 - SLOPE, -1.03e-3)])),
    "over an apex and round the brim": ((HAT,), np.concatenate([
        arc((0.0, 0.12), pi / 2, pi / 2 - SLOPE, -1.03e-3),
        lines(*over((0.0, 0.12), (0.03, 0.1))), arc((0.03, 0.1), pi / 2 - SLOPE, -pi / 2 - SLOPE, -1.03e-3)])),
    "from the hat down its skirt and round it": ((HAT, SKIRT), np.concatenate([
        lines(*over((0.0, 0.12), (0.03, 0.1))), arc((0.03, 0.1), pi / 2 - SLOPE, 0.0, -1.03e-3),
        lines((0.03 + PRESSED, 0.1), (0.03 + PRESSED, 0.08)), arc((0.03, 0.08), 0.0, -pi, -1.03e-3)])),
}  # fmt: skip


@pytest.mark.parametrize(("inserts", "way"), WAYS.values(), ids=WAYS)
def test_one_push_without_a_jump_over_ridges_and_rims(inserts, way):
    shape = walls_of(inserts).shape
    points = np.c_[AXIS[0] + way[:, 0], np.full(len(way), AXIS[1]), way[:, 1]]
    points = np.c_[np.full(len(way), 0.007), way[:, 0], way[:, 1]] if inserts is ROOF else points
    pushes = np.array([push(shape, point) for point in points])
    assert np.linalg.norm(pushes, axis=1) == pytest.approx(BALL - PRESSED, rel=1e-6)
    assert np.linalg.norm(np.diff(pushes, axis=0), axis=1).max() < 0.01 * (BALL - PRESSED)


def test_a_valley_pushes_from_both_plates():
    shape = walls_of(ROOF).shape
    below = 0.12 - PRESSED / cos(SLOPE)
    assert push(shape, (0.0, 0.0, below)) == pytest.approx((0.0, 0.0, -2.0 * cos(SLOPE) * (BALL - PRESSED)), rel=1e-9)


def test_a_front_alone_lets_pass_what_comes_from_behind():
    corners = ((0.0, 0.0, 0.1), (0.04, 0.0, 0.1), (0.04, 0.04, 0.1), (0.0, 0.04, 0.1))
    for side, behind in (("front", 0), ("both", 1)):
        shape = walls_of([polygon("plate", corners, side)]).shape
        assert [len(vectors(shape, (0.02, 0.02, z))) for z in (0.105, 0.095)] == [1, behind]


def test_cells_of_both_faces():
    walls = silo(HAT, polygon("plate", ((0.0, 0.05, 0.2), (0.05, 0.05, 0.2), (0.0, 0.08, 0.2)), "front")).walls((3, 4))
    seen = faces(walls, LID)
    assert [face.name for face in seen] == ["floor", "wall", "hat", "hat_back", "plate"]
    assert walls_of(walls).cells[:, 3].tolist() == [0, 0, 12, 0]
    up = 0.03 / hypot(0.03, 0.02)
    assert np.allclose([face.lean for face in seen[2:]], [(up, 0.02 / 0.03 * up), (-up, 0.02 / 0.03 * up), (1.0, 0.0)])
    assert areas(walls[2]).sum() == pytest.approx(pi * 0.03 * hypot(0.03, 0.02))


def test_pieces_of_one_plane_but_unlike_coefficients_are_no_sheet():
    corners = ((0.0, 0.0, 0.1), (0.04, 0.0, 0.1), (0.04, 0.04, 0.1), (0.0, 0.04, 0.1))
    one, other = (polygon(name, (*corners[k:], *corners[:k])[:3], "both") for name, k in (("one", 0), ("other", 2)))
    assert walls_of((one, other)).live.tolist() == [True, False]
    assert walls_of((one, replace(other, coat=1))).live.tolist() == [True, True]


SQUARE = ((0.0, 0.0, 0.1), (0.04, 0.0, 0.1), (0.04, 0.04, 0.1), (0.0, 0.04, 0.1))
CONE = {"plan": "circular", "diameter": 0.2, "wall_depth": 0.1, "hopper": Hopper(half_angle=radians(30.0), outlet_width=0.08)}


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: silo(disc("ring", 0.09, 0.01, 0.1, AXIS)), "inserts.0 = 'ring': leaves the silo at x 0.02, y -0.01, z 0.1 m"),
        (lambda: silo(cylinder("tube", 0.03, (0.1, 0.31), AXIS)), "inserts.0 = 'tube': leaves the silo at .* z 0.31 m"),
        (lambda: silo(HAT, polygon("plate", (*SQUARE[:3], (0.0, 0.04, -0.01)), "both")), "must lie in one plane"),
        (lambda: silo(HAT, polygon("plate", ((0.0, 0.0, 0.1), (0.0, 0.2, 0.1), (0.05, 0.0, 0.1)), "both")),
         "inserts.1 = 'plate': leaves the silo at x 0, y 0.2, z 0.1 m"),
        (lambda: silo(disc("ring", 0.05, 0.01, 0.0, (0.0, 0.0)), **CONE), "leaves the silo at x 0, y 0, z 0 m"),
        (lambda: silo(HAT, HAT), "inserts.1.name = 'hat': is taken; taken by then: floor, wall, hat"),
        (lambda: silo(HAT, replace(HAT, name="hat_back")), "inserts.1.name = 'hat_back': is taken"),
        (lambda: silo(replace(HAT, name="hat_back"), HAT), "1.name = 'hat': has a back recorded as hat_back"),
        (lambda: silo(cylinder("wall", 0.03, (0.1, 0.2), AXIS)), "inserts.0.name = 'wall': is taken"),
        (lambda: silo(cylinder("wall_2", 0.03, (0.1, 0.2), AXIS)), "inserts.0.name = 'wall_2': is taken"),
        (lambda: polygon("plate", (*SQUARE[:3], (0.03, 0.01, 0.1)), "both"), "plate = .* must be convex, its corners in order"),
        (lambda: polygon("plate", tuple(SQUARE[k] for k in (0, 2, 1, 3)), "both"), "must be convex, its corners in order"),
        (lambda: polygon("plate", SQUARE[:2], "both"), "three finite corners or more"),
        (lambda: polygon("plate", (*SQUARE[:2], (0.02, 0.0, 0.1)), "both"), "must have an extent"),
        (lambda: cylinder("tube", 0.03, (0.1, 0.1), AXIS), "tube = .* must have an extent"),
        (lambda: silo(*ROOF, polygon("fin", (*RIDGE, (0.0, 0.0, 0.2)), "both")), "meets more than one polygon along its side"),
    ],
)  # fmt: skip
def test_inserts_that_cannot_be(make, message):
    with pytest.raises(BadInput, match=message):
        make()
