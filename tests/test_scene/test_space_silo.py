"""The surfaces of a silo in space: where they stand, without leak or double push at joints, and silos that have none."""

from itertools import pairwise
from math import cos, hypot, pi, radians, sin, sqrt, tan

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from scipy.spatial import cKDTree

from silostudy.dem.space.felt import flat_frame, turned_frame
from silostudy.dem.space.surfaces import FLAT, NEXT, OUT_OF_REACH, TURNED, nearest, piece_of
from silostudy.dem.space.walls import FlatPiece, walls_of
from silostudy.errors import BadInput
from silostudy.scene.silo import Hopper, Silo
from silostudy.scene.space_silo import FLOOR, LID, Outlet, SpaceSilo
from tests.test_scene.sheet import Sheet

WIDE, DEEP, BALL, PRESSED = 0.2, 0.15, 0.01, 0.0098  # m: the silos, a sphere, and its distance from what it is pressed on
CONE = Hopper(half_angle=radians(30.0), outlet_width=0.08)


def silo(plan="circular", hopper=None, **changes) -> Silo:
    length, sides = (0.3 if plan == "rectangular" else 0.0), (6 if plan == "polygonal" else 0)
    return Silo(**({"plan": plan, "diameter": WIDE, "wall_depth": DEEP, "length": length, "sides": sides, "hopper": hopper}
                   | changes))  # fmt: skip


def space(plan="circular", hopper=None, outlet=None, wedge=False, **changes) -> SpaceSilo:
    outlets = (outlet,) if outlet else ()
    return SpaceSilo(silo=silo(plan, hopper, **changes), outlets=outlets, wedge=wedge, lid=True)


def floor_with(*outlets) -> SpaceSilo:
    """A round silo whose flat floor has outlets of a name, width, length and middle."""
    return SpaceSilo(silo=silo(), outlets=tuple(
        Outlet(name=name, width=width, length=length, middle=middle) for name, width, length, middle in outlets))  # fmt: skip


SPACES = {
    "closed": space(),
    "cone": space(hopper=CONE),
    "cone to its apex": space(hopper=Hopper(half_angle=0.5, outlet_width=0.0)),
    "hole": space(outlet=Outlet(width=0.08)),
    "eccentric hole": space(outlet=Outlet(width=0.06), outlet_eccentricity=0.05),
    "slot in a circle": space(outlet=Outlet(width=0.05, length=0.1), outlet_eccentricity=0.03),
    "square, hole": space("square", outlet=Outlet(width=0.07), outlet_eccentricity=0.04),
    "square, pyramid": space("square", CONE),
    "square, eccentric pyramid": space("square", CONE, outlet_eccentricity=0.05),
    "square, wedge": space("square", CONE, wedge=True, outlet_eccentricity=0.02),
    "rectangle, pyramid": space("rectangular", CONE),
    "rectangle, pyramid to its ridge": space("rectangular", Hopper(half_angle=0.9, outlet_width=0.0)),
    "rectangle, wedge": space("rectangular", CONE, wedge=True),
    "rectangle, slot from wall to wall": space("rectangular", outlet=Outlet(width=0.06, length=0.3)),
    "hexagon, pyramid": space("polygonal", CONE, outlet_eccentricity=0.03),
    "triangle, slot": space("polygonal", outlet=Outlet(width=0.06, length=0.04), sides=3),
    "octagon, hole": space("polygonal", outlet=Outlet(width=0.06), sides=8),
}
every_silo = pytest.mark.parametrize("of", SPACES.values(), ids=SPACES)


def shape_of(of: SpaceSilo, opened: bool) -> np.ndarray:
    """Rows of the surfaces that stand: at the start, or once the outlets are open; one row a sheet."""
    surfaces = [wall for wall in of.walls() if not (opened and of.opening and wall.name == FLOOR)]
    walls = walls_of(surfaces)
    for surface, row in zip(surfaces, walls.shape, strict=True):
        if opened and surface.name == FLOOR and of.outlets:
            surface.opened(row, tuple(of.openings), 0.0)
    return walls.shape


def opens(of: SpaceSilo) -> bool:
    return bool(of.openings)


def firsts(shape) -> np.ndarray:
    """Numbers of the surfaces that push: of a sheet the first piece, which stands for all."""
    return np.setdiff1d(np.arange(len(shape)), [row[NEXT] for row in shape if row[0] == FLAT and row[NEXT]])


def vectors(shape, point) -> list[np.ndarray]:
    """Vectors (m) from the nearest points of the surfaces that can be touched from a point."""
    found = [np.array(nearest(shape, q, *point)[:3]) for q in firsts(shape)]
    return [away for away in found if away[0] != OUT_OF_REACH]


def nearest_of_all(shape, point) -> np.ndarray:
    """Vector (m) from the nearest point of all surfaces; endless where there is none to touch."""
    return min(vectors(shape, point), key=np.linalg.norm, default=np.full(3, np.inf))


def distance(shape, point) -> float:
    return float(np.linalg.norm(nearest_of_all(shape, point)))


def push(shape, point) -> np.ndarray:
    """Push on a sphere by springs of stiffness one (m)."""
    pushes = [away * (BALL / length - 1.0) for away in vectors(shape, point) if (length := np.linalg.norm(away)) < BALL]
    return np.sum(pushes, axis=0) if pushes else np.zeros(3)


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
        off = 0.0 if plan == "circular" else off
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
        assert "leave the floor" in str(refused) or "off the wall above it" in str(refused)  # noqa: PT017
        return
    for opened in (False, True):
        check_distances(of, opened, 3, pitch=0.006, count=40)
    check_no_leak(of, 4, count=20)


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


def corner_of(sides: int) -> tuple[float, float]:
    return INNER, INNER * tan(pi / sides)


def past_a_corner(sides: int, z: float) -> np.ndarray:
    """Along one wall into its corner, and out along the next."""
    turn = 2.0 * pi / sides
    return line((INNER, 0.0, z), (*corner_of(sides), z), (INNER * cos(turn), INNER * sin(turn), z))


WAYS = {
    "cylinder, cone, rim": (SPACES["cone"], np.concatenate([
        line((INNER, 0.0, BOTTOM + 0.03), (INNER, 0.0, JOINT), OVER_RIM), arc(0.04, pi - BETA, 2.0 * pi - BETA)])),
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
        ("octagon, hole", False, (0.0, 0.0, PRESSED), 1),
        ("hexagon, pyramid", True, (*corner_of(6), BOTTOM + 0.05), 2),
    ],
)
def test_as_many_surfaces_push_as_a_sphere_touches(name, opened, point, count):
    shape = shape_of(SPACES[name], opened)
    assert sum(np.linalg.norm(away) < BALL for away in vectors(shape, point)) == count


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
                frame = turned_frame if shape[q, 0] == TURNED else flat_frame
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
         "silo.hopper.outlet_width = 0.21: .* the width of the hopper's top, 0.2 m"),
        (lambda: space(hopper=Hopper(half_angle=0.5, outlet_width=0.2)), "silo.hopper = .* must have a height"),
        (lambda: space(hopper=Hopper(half_angle=pi / 2, outlet_width=0.1)), "silo.hopper = .* must have a height"),
        (lambda: space(hopper=Hopper(half_angle=0.0, outlet_width=0.1)), "silo.hopper = .* must have a height"),
        (lambda: space(hopper=CONE, outlet_eccentricity=0.01), "silo.outlet_eccentricity = 0.01: .* wall of an eccentric cone"),
        (lambda: space("square", CONE, outlet_eccentricity=0.061), "eccentricity = 0.061: must not be above 0.06 m"),
        (lambda: space("square", CONE, wedge=True, outlet_eccentricity=0.061), "must not be above 0.06 m"),
        (lambda: space(hopper=Hopper(half_angle=radians(4.0), outlet_width=0.1)), "silo.hopper = .* 4 degrees off the wall"),
        (lambda: space("square", CONE, outlet_eccentricity=0.058), "silo.hopper = .* 1.1 degrees off the wall above it"),
        (lambda: space(hopper=CONE, wedge=True), "wedge = True: stands below a square or rectangular plan, not a circular one"),
        (lambda: space(wedge=True), "wedge = True: is a hopper's"),
        (lambda: space(hopper=CONE, outlet=Outlet(width=0.05)), "outlets = .* the hopper has its own"),
        (lambda: space(outlet=Outlet(width=0.2)), "outlets.0.width_m = 0.2: must be above 0 and below .* 0.2 m"),
        (lambda: space(outlet=Outlet(width=0.0)), "outlets.0.width_m = 0.0: must be above 0"),
        (lambda: space("square", outlet=Outlet(width=0.1, length=0.21)), "outlets.0.length_m = 0.21: .* below .* 0.2 m"),
        (lambda: space(outlet=Outlet(width=0.1), outlet_eccentricity=0.05), "eccentricity = 0.05: .* leave the floor"),
        (lambda: space(outlet=Outlet(width=0.15, length=0.15)), "the outlet must not leave the floor"),
        (lambda: space("square", outlet=Outlet(width=0.1, length=0.2), outlet_eccentricity=0.06), "must not leave the floor"),
        (lambda: floor_with(("a", 0.04, None, (0.07, 0.05))),
         "outlets.0.middle_m = .0.07, 0.05.: the outlet must not leave the floor, .* 0.006"),
        (lambda: floor_with(("a", 0.04, None, (0.0, 0.0)), ("b", 0.04, None, (0.03, 0.0))),
         "outlets = 'a, b': must not overlap or touch, and do by 0.01 m"),
        (lambda: floor_with(("a", 0.04, None, (0.0, 0.0)), ("b", 0.04, 0.02, (0.03, 0.02))),
         "outlets = 'a, b': must not overlap or touch, and do by 0.005858 m"),
        (lambda: floor_with(("a", 0.04, None, (0.0, 0.0)), ("a", 0.02, None, (0.05, 0.0))),
         "each outlet needs a name of its own"),
        (lambda: space(wall_depth=0.0), "silo.wall_depth = 0.0: the vertical walls must have a height"),
    ],
)  # fmt: skip
def test_silos_without_surfaces(make, message):
    with pytest.raises(BadInput, match=message):
        make()
