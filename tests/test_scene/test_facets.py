"""Meshes as inserts: a curved sheet pushes as the surface that it stands for, once, and its corners as corners do."""

from contextlib import nullcontext
from math import cos, pi, sin

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.dem.space.flat import apart_from, piece_of
from silostudy.dem.space.inserts import polygon
from silostudy.dem.space.rows import FLAT, LAST
from silostudy.dem.space.surfaces import square_apart
from silostudy.dem.space.walls import TurnedLine, walls_of
from silostudy.errors import BadInput
from silostudy.scene.facets import MOST, facets_of, require_whole
from tests.test_scene.spaces import BALL, PRESSED, push, vectors

WIDE, HIGH, SIDES = 0.05, 0.1, 48
SAG = WIDE * (1.0 - cos(pi / SIDES))  # how far the facets cut into the cylinder


def cylinder(sides=SIDES) -> np.ndarray:
    """Corners of the triangles of a cylinder, two a side and level, two levels."""
    found = []
    for k in range(sides):
        (a, b), (c, d) = ((WIDE * cos(2 * pi * n / sides), WIDE * sin(2 * pi * n / sides)) for n in (k, (k + 1) % sides))
        for low, high in ((0.0, 0.3 * HIGH), (0.3 * HIGH, HIGH)):
            found += [[(a, b, low), (c, d, low), (c, d, high)], [(a, b, low), (c, d, high), (a, b, high)]]
    return np.array(found)


def shape_of(triangles, **how) -> np.ndarray:
    entries = facets_of(triangles, "mesh", "m", **how)
    return walls_of([polygon(of["name"], tuple(map(tuple, of["corners_m"])), "both", of["sheet"]) for of in entries]).shape


def test_a_fine_cylinder_pushes_as_the_exact_one():
    """Over facets, their edges and their corners: one push, off by the facets' sag in size and by half a turn in direction."""
    mesh = shape_of(cylinder())
    exact = walls_of([TurnedLine(name="exact", start=(WIDE, 0.0), end=(WIDE, HIGH))]).shape
    random, r = np.random.default_rng(4), WIDE - PRESSED
    edge = [(2 * pi * k / SIDES, z) for k in (0, 7, 30) for z in (0.01, 0.3 * HIGH, 0.5 * HIGH)]
    for turn, z in [*random.uniform((0.0, 0.0), (2 * pi, HIGH), (25, 2)), *edge]:
        point = r * cos(turn), r * sin(turn), z
        (away,) = (one for one in vectors(mesh, point) if np.linalg.norm(one) < BALL)
        assert PRESSED - SAG - 1e-9 < np.linalg.norm(away) < PRESSED + 1e-9
        wanted, found = push(exact, point), push(mesh, point)
        assert np.linalg.norm(found - wanted) < 1.01 * SAG + pi / SIDES * np.linalg.norm(found)


def test_a_push_has_no_jump_along_the_mesh():
    mesh = shape_of(cylinder())
    turns = np.arange(0.0, 4.0 * 2 * pi / SIDES, 4e-4)
    pushes = np.array([push(mesh, ((WIDE - PRESSED) * cos(t), (WIDE - PRESSED) * sin(t), 0.04)) for t in turns])
    most = np.linalg.norm(pushes, axis=1).max()
    assert np.linalg.norm(np.diff(pushes, axis=0), axis=1).max() < 1.1 * 2 * pi / SIDES * most


@pytest.mark.parametrize("sides", [48, 100])
def test_groups_of_a_sheet_pass_over_no_nearest_piece(sides):
    """At the wall, over edges and corners, on the axis, beyond the ends: the piece that one finds who looks at all.

    Lists hold the first piece, which stands for all, and none of the others.
    """
    grouped = shape_of(cylinder(sides))
    plain = grouped.copy()
    plain[:, LAST] = 0.0
    random = np.random.default_rng(7)
    places = [*random.uniform((0.9, 0.0, -0.02), (1.05, 2 * pi, HIGH + 0.02), (300, 3)), (0.0, 0.0, 0.05)]
    places += [(r, 2 * pi * k / sides, z) for r in (0.9, 1.0) for k in range(sides) for z in (0.0, 0.3 * HIGH)]
    assert [square_apart(grouped, k, WIDE, 0.0, 0.05) < np.inf for k in range(len(grouped))] == [True] + [False] * (
        4 * sides - 1
    )
    for r, turn, z in places:
        point = WIDE * r * cos(turn), WIDE * r * sin(turn), z
        found = piece_of(grouped, 0, *point)
        apart = [apart_from(grouped, k, *point)[0] for k in range(len(grouped))]
        assert found == piece_of(plain, 0, *point)
        assert apart[found] == min(apart)


def test_corners_of_a_mesh_stay_corners():
    """In the corner of a box each face pushes, however its triangles lie; a coarse cylinder has faces, too."""
    a = 0.05
    faces = [[(0, 0, 0), (a, 0, 0), (a, a, 0), (0, a, 0)], [(0, 0, 0), (0, a, 0), (0, a, a), (0, 0, a)],
             [(0, 0, 0), (0, 0, a), (a, 0, a), (a, 0, 0)]]  # fmt: skip
    box = shape_of(np.array([[f[0], *two] for f in faces for two in ((f[1], f[2]), (f[2], f[3]))]))
    near = [away for away in vectors(box, (PRESSED, PRESSED, PRESSED)) if np.linalg.norm(away) < BALL]
    assert len(near) == 3
    assert push(box, (PRESSED, PRESSED, PRESSED)) == pytest.approx([BALL - PRESSED] * 3, rel=1e-9)
    coarse = shape_of(cylinder(12))
    r = WIDE - PRESSED / cos(pi / 12)
    assert sum(np.linalg.norm(away) < BALL for away in vectors(coarse, (r, 0.0, 0.04))) == 2


def test_what_cannot_be_a_sheet():
    with pytest.raises(BadInput, match="--unit = 'inch': unknown; known: m, mm"):
        facets_of(cylinder(4), "mesh", "inch")
    with pytest.raises(BadInput, match=f"mesh = '2004 triangles': must be from 1 to {MOST}"):
        facets_of(cylinder(501), "mesh", "m")
    with pytest.raises(BadInput, match=r"a\.stl: mesh = '0 triangles': .*none in the file has an area"):
        facets_of(np.zeros((3, 3, 3)), "mesh", "m", "a.stl")

    lost = cylinder(4)
    lost[2, 0, 1] = np.nan
    with pytest.raises(BadInput, match=r"mesh = 'triangle 3': has a corner that is no finite number"):
        facets_of(lost, "mesh", "m")


@pytest.mark.parametrize(
    ("content", "told"),
    [
        (b"solid part\nfacet normal 0 0 1\nouter loop", "is cut off: an STL file in words ends with endsolid"),
        (b"no mesh", "is no STL file, or cut off"),
        (bytes(80) + (3).to_bytes(4, "little") + bytes(120), "is no STL file, or cut off"),
        (b"solid in a header".ljust(80) + (2).to_bytes(4, "little") + bytes(100), None),
        (b"solid part\nendsolid part\n", None),
    ],
)
def test_a_file_that_is_cut_off_is_told(content, told, tmp_path):
    (path := tmp_path / "part.stl").write_bytes(content)
    with pytest.raises(BadInput, match=told) if told else nullcontext():
        require_whole(path)


@pytest.mark.long
def test_a_file_becomes_inserts_of_a_scene(tmp_path, capsys):
    trimesh = pytest.importorskip("trimesh")
    corners = 1e3 * cylinder()
    mesh = trimesh.Trimesh(corners.reshape(-1, 3), np.arange(corners[..., 0].size).reshape(-1, 3))
    mesh.export(tmp_path / "part.stl")
    assert main(["facets", str(tmp_path / "part.stl"), str(tmp_path / "part.yaml"), "--name", "tube", "--unit", "mm"]) == 0
    inserts = yaml.safe_load((tmp_path / "part.yaml").read_text())["inserts"]
    assert len(inserts) == len(corners)
    surfaces = walls_of([polygon(of["name"], tuple(map(tuple, of["corners_m"])), "both", of["sheet"]) for of in inserts])
    assert (surfaces.shape[:, 0] == FLAT).all()
    assert surfaces.live.sum() == 1  # one sheet, whose corners met although the file repeats them in single precision
    (tmp_path / "bad.stl").write_text("no mesh")
    assert main(["facets", str(tmp_path / "bad.stl"), str(tmp_path / "bad.yaml")]) == 2
    assert main(["facets", str(tmp_path / "none.stl"), str(tmp_path / "bad.yaml")]) == 2
    assert "is not there" in capsys.readouterr().err
