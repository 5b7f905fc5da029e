"""The surfaces of a silo in space: where they stand, without leak, and silos that have none."""

from math import hypot, pi, radians, sqrt

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from silostudy.dem.space.eccentric import eccentric_frame
from silostudy.dem.space.felt import flat_frame, turned_frame
from silostudy.dem.space.flat import piece_of
from silostudy.dem.space.rows import ECCENTRIC, FLAT, OUT_OF_REACH, TURNED
from silostudy.dem.space.surfaces import nearest
from silostudy.dem.space.walls import walls_of
from silostudy.errors import BadInput
from silostudy.scene.silo import Hopper
from silostudy.scene.space_silo import FLOOR, LID, Outlet, SpaceSilo
from tests.test_scene.sheet import Sheet
from tests.test_scene.spaces import (
    CONE,
    SPACES,
    WIDE,
    distance,
    every_silo,
    firsts,
    floor_with,
    nearest_of_all,
    opens,
    shape_of,
    space,
)


def check_distances(of: SpaceSilo, opened: bool, seed: int, pitch=0.004, count=150):
    """Points are as far from the surfaces as a search over strewn points says.

    Outside beside a joint there may be nothing to touch.
    """
    random, sheet, shape = np.random.default_rng(seed), Sheet(of, opened), shape_of(of, opened)
    cloud = sheet.strewn(pitch)
    tree, joints = cKDTree(cloud), cKDTree(sheet.joints(pitch))
    points = cloud[random.integers(0, len(cloud), count)] + random.uniform(-0.02, 0.02, (count, 3))
    searched, which = tree.query(points)
    beside = joints.query(cloud[which])[0] < 2.0 * pitch
    for point, most, spared in zip(points, searched, beside & ~sheet.within(points), strict=True):
        away = nearest_of_all(shape, point)
        least = float(np.linalg.norm(away))
        assert least == np.inf or tree.query(point - away)[0] < pitch, point  # the nearest point lies on the surface
        assert spared or least <= most + 1e-9, point
        assert spared or most <= sqrt(least**2 + 2.0 * pitch**2), point


def check_no_leak(of: SpaceSilo, seed: int, count=60):
    """Straight ways out cross the surface where a sphere inside would have touched it."""
    random, sheet, shape = np.random.default_rng(seed), Sheet(of, False), shape_of(of, False)
    low, high = np.array([(-0.2, -0.2, -0.05), (0.2, 0.2, sheet.top + 0.05)])
    points = random.uniform(low, high, (40 * count, 3))
    within = sheet.within(points)
    inside, outside = points[within][:count], points[~within][:count]
    assert len(inside) == count
    for _ in range(45):
        middle = 0.5 * (inside + outside)
        stays = sheet.within(middle)[:, None]
        inside, outside = np.where(stays, middle, inside), np.where(stays, outside, middle)
    assert max(distance(shape, point) for point in inside) < 1e-9


@every_silo
def test_distances_against_a_search(of):
    for opened in (False, True)[: 2 if opens(of) else 1]:
        check_distances(of, opened, 1)


@every_silo
def test_no_way_out_of_a_closed_silo(of):
    check_no_leak(of, 2)


@st.composite
def spaces(draw) -> SpaceSilo:
    plan, share = draw(st.sampled_from(["circular", "square", "rectangular", "polygonal"])), st.floats(0.1, 0.8)
    width, off, sides = draw(share), draw(st.floats(0.0, 0.95)), draw(st.integers(3, 24))
    hopper = outlet = None
    if draw(st.booleans()):
        hopper = Hopper(half_angle=radians(draw(st.floats(15.0, 75.0))), outlet_width=width * WIDE)
    else:
        outlet = Outlet(width=width * WIDE, length=draw(st.none() | st.floats(0.02, 0.05)))
    wedge = hopper is not None and plan in ("square", "rectangular") and draw(st.booleans())
    aside = 0.5 * off * (1.0 - width) * WIDE * (0.7 if outlet and outlet.length else 1.0)
    return space(plan, hopper, outlet, wedge, outlet_eccentricity=aside, sides=sides)


@settings(max_examples=20, deadline=None)
@given(st.data())
def test_any_silo(data):
    try:
        of = data.draw(spaces())
    except BadInput as refused:  # a corner of a slot outside a circle or a triangle; a face of a hopper almost upright
        assert any(told in str(refused) for told in ("leave the floor", "touches the wall", "off the wall above it"))  # noqa: PT017
        return
    for opened in (False, True):
        check_distances(of, opened, 3, pitch=0.006, count=40)
    check_no_leak(of, 4, count=20)


def test_a_floor_of_several_outlets():
    """Each opens alone; a point over the floor is as far from it as from the nearest point that is left."""
    of = floor_with(("round", 0.05, None, (-0.05, 0.0)), ("slot", 0.03, 0.08, (0.02, 0.01)), ("small", 0.02, None, (0.07, 0.0)))
    surface, rows, points = of.walls()[0], walls_of(of.walls()).shape, np.random.default_rng(5).uniform(-0.07, 0.07, (300, 3))
    holes = {"round": lambda x, y: hypot(x + 0.05, y) < 0.025,
             "slot": lambda x, y: abs(x - 0.02) < 0.015 and abs(y - 0.01) < 0.04,
             "small": lambda x, y: hypot(x - 0.07, y) < 0.01}  # fmt: skip
    grid = np.array([(x, y) for x in np.arange(-0.1, 0.1, 0.0013) for y in np.arange(-0.1, 0.1, 0.0013) if hypot(x, y) < 0.1])
    for opened in ((), ("slot",), ("slot", "round", "small")):
        surface.opened(rows[0], opened, 0.0)
        left = np.array([not any(holes[name](*point) for name in opened) for point in grid])
        tree = cKDTree(np.c_[grid[left], np.zeros(left.sum())])
        for point in points:
            away = np.array(nearest(rows, 0, *point)[:3])
            assert tree.query(point)[0] == pytest.approx(np.linalg.norm(away), abs=0.0015)
            x, y, z = point - away
            assert z == 0.0
            assert not any(holes[name](x * (1.0 - 1e-9), y) and holes[name](x * (1.0 + 1e-9), y) for name in opened)


def test_names_of_the_surfaces():
    names = {name: [wall.name for wall in of.walls()] for name, of in SPACES.items()}
    assert names["cone"] == [FLOOR, "hopper", "wall", LID]
    assert names["cone to its apex"] == ["hopper", "wall", LID]
    assert names["square, hole"] == [FLOOR, *(f"wall_{k}" for k in range(1, 5)), LID]
    assert {wall.cells for wall in SPACES["square, pyramid"].walls((3, 5))} == {(3, 5)}


@every_silo
def test_cells_cover_the_surfaces(of):
    """Nearest points of spheres inside lie within the two extents that a surface's cells divide."""
    walls = of.walls()
    shape, random = walls_of(walls).shape, np.random.default_rng(7)
    for point in random.uniform((-0.1, -0.1, 0.0), (0.1, 0.1, of.top), (40, 3)):
        for q in firsts(shape):
            away = np.array(nearest(shape, q, *point)[:3])
            if away[0] != OUT_OF_REACH:
                frame = {TURNED: turned_frame, ECCENTRIC: eccentric_frame}.get(shape[q, 0], flat_frame)
                piece = piece_of(shape, q, *point) if shape[q, 0] == FLAT else q
                first, second, up = frame(shape, piece, *(point - away))
                assert min(first, second) >= -1e-9
                assert max(first, second) <= 1.0 + 1e-9
                assert np.linalg.norm(up) == pytest.approx(1.0)


@pytest.mark.parametrize(
    ("make", "message"),
    [
        (lambda: space("slot"), r"silo.plan = 'slot': has no end walls.*; known: circular, square, rectangular, polygonal"),
        (lambda: space("polygonal", sides=25), "silo.sides = 25: must be from 3 to 24"),
        (lambda: space(hopper=Hopper(half_angle=0.5, outlet_width=0.21)),
         "silo.hopper.outlet_width_m = 0.21: .* the width of the hopper's top, 0.2 m"),
        (lambda: space(hopper=Hopper(half_angle=0.5, outlet_width=0.2)), "hopper.outlet_width_m = 0.2: .* must have a height"),
        (lambda: space(hopper=Hopper(half_angle=pi / 2, outlet_width=0.1)), "silo.hopper.half_angle_deg = 90.0: .* a height"),
        (lambda: space(hopper=Hopper(half_angle=0.0, outlet_width=0.1)), "silo.hopper.half_angle_deg = 0.0: .* a height"),
        (lambda: space(hopper=CONE, outlet_eccentricity=0.061), "eccentricity_m = 0.061: must not be above 0.06 m"),
        (lambda: space(hopper=CONE, outlet_eccentricity=0.058), "eccentricity_m = 0.058: .* 1.1 degrees off .* around a cone"),
        (lambda: space(hopper=CONE, outlet_eccentricity=0.06), "eccentricity_m = 0.06: .* 0 degrees off the wall above it"),
        (lambda: space("square", CONE, outlet_eccentricity=0.061), "eccentricity_m = 0.061: must not be above 0.06 m"),
        (lambda: space("square", CONE, wedge=True, outlet_eccentricity=0.061), "must not be above 0.06 m"),
        (lambda: space(hopper=Hopper(half_angle=radians(4.0), outlet_width=0.1)), "half_angle_deg = 4.0: .* 4 degrees off"),
        (lambda: space("square", CONE, outlet_eccentricity=0.058), "silo.outlet_eccentricity_m = 0.058: .* 1.1 degrees off"),
        (lambda: space(hopper=CONE, wedge=True), "wedge = True: stands below a square or rectangular plan, not a circular one"),
        (lambda: space(wedge=True), "wedge = True: is a hopper's"),
        (lambda: space(hopper=CONE, outlet=Outlet(width=0.05)), "outlets = .* the hopper has its own"),
        (lambda: space(outlet=Outlet(width=0.2)), "outlets.0.width_m = 0.2: must be above 0 and below .* 0.2 m"),
        (lambda: space(outlet=Outlet(width=0.0)), "outlets.0.width_m = 0.0: must be above 0"),
        (lambda: space("square", outlet=Outlet(width=0.1, length=0.21)), "outlets.0.length_m = 0.21: .* below .* 0.2 m"),
        (lambda: space(outlet=Outlet(width=0.1), outlet_eccentricity=0.05), "eccentricity_m = 0.05: .* touches the wall"),
        (lambda: space(outlet=Outlet(width=0.15, length=0.15)), "the outlet must not leave the floor"),
        (lambda: space("square", outlet=Outlet(width=0.1, length=0.2), outlet_eccentricity=0.06), "must not leave the floor"),
        (lambda: space("square", outlet=Outlet(width=0.2, length=0.2)), "outlets.0.width_m = 0.2: .* that one way"),
        (lambda: space("square", outlet=Outlet(width=0.21, length=0.1)), "outlets.0.width_m = 0.21: must be above 0 and below"),
        (lambda: space("rectangular", outlet=Outlet(width=0.2)), "outlets.0.width_m = 0.2: must be above 0 and below"),
        (lambda: space("square", outlet=Outlet(width=0.2, length=0.1), outlet_eccentricity=0.01), "stands out by 0.01 m"),
        (lambda: space("square", outlet=Outlet(width=0.2, length=0.1, middle=(0.0, 0.06))), "stands out by 0.01 m"),
        (lambda: floor_with(("a", 0.04, None, (0.07, 0.05))),
         "outlets.0.middle_m = .0.07, 0.05.: the outlet must not leave the floor, .* 0.006"),
        (lambda: floor_with(("a", 0.04, None, (0.0, 0.0)), ("b", 0.04, None, (0.03, 0.0))),
         "outlets = 'a, b': must not overlap or touch, and do by 0.01 m"),
        (lambda: floor_with(("a", 0.04, None, (0.0, 0.0)), ("b", 0.04, 0.02, (0.03, 0.02))),
         "outlets = 'a, b': must not overlap or touch, and do by 0.005858 m"),
        (lambda: floor_with(("a", 0.04, None, (0.0, 0.0)), ("a", 0.02, None, (0.05, 0.0))),
         "each outlet needs a name of its own"),
        (lambda: space(wall_depth=0.0), "silo.cylinder_depth_m = 0.0: the vertical walls must have a height"),
    ],
)  # fmt: skip
def test_silos_without_surfaces(make, message):
    with pytest.raises(BadInput, match=message):
        make()
