"""Every method reproduces its published values, and every row brings the proof that it may be shipped."""

import inspect
from itertools import groupby

import pytest

from silostudy.compute.pressure import pressure_cube
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import PHASES
from silostudy.tables.handbook import TONNE_PER_M2
from silostudy.tables.references import cite
from tests.conftest import expanded
from tests.proof import PUBLISHED, points, printed, scene_of

FOLDER = PUBLISHED / "pressure"
ABOUT = ("reading", "phase", "depth_m", "precision", "source", "locator")
PROVEN = sorted(path.stem for path in FOLDER.glob("*.csv"))


def cube_of(method: str, points: list[dict], scene: dict):
    """The pressures of a method in a scene at the depths of some points."""
    depths = sorted({float(point["depth_m"]) for point in points})
    content = {"kind": "pressure", "title": method, "scene": scene, "phases": list(PHASES), "depth_m": depths}
    twin = {"as_printed": [method]} if PRESSURE[method].has_misprint else {}
    return pressure_cube(expanded(content | {"methods": [method]} | twin))


@pytest.mark.parametrize("method", PROVEN)
def test_published_values(method):
    found = points(FOLDER / f"{method}.csv")
    keys = [column for column in found[0] if "." in column or column in ("solid", "wall")]
    (column,) = set(found[0]) - {*keys, *ABOUT}
    for scene, group in groupby(found, key=lambda point: scene_of(point, keys)):
        same = list(group)
        cube = cube_of(method, same, scene)
        for point in same:
            quantity, value, precision = printed(point, column)
            label = method + ("_as_printed" if point["reading"] == "as_printed" else "")
            here = {"pressure_method": label, "phase": point["phase"], "depth": float(point["depth_m"])}
            assert float(cube[quantity].sel(here)) == pytest.approx(value, rel=precision, abs=0), point


def test_the_handbooks_table_is_reproduced():
    """167 of its 182 values: all but a misprint and the column of a plane slot."""
    table = [point for method in PROVEN for point in points(FOLDER / f"{method}.csv") if "4.2.5" in point["locator"]]
    assert len(table) == 167 + 14  # as printed, the plane slot comes back too


def test_jenike_corrected_peaks_at_4_357(wheat):
    column = wheat["wall_normal_pressure"].sel(pressure_method="jenike_mass_flow", phase="discharge") / TONNE_PER_M2
    recomputed = {3.5: 2.563, 5.5: 3.272, 12.5: 4.357, 18.0: 3.172}  # independently recomputed with R = D/4
    for depth, value in recomputed.items():
        assert float(column.sel(depth=depth)) == pytest.approx(value, abs=5e-4)


def test_caquot_misprint_is_the_only_value_off(wheat):
    here = {"pressure_method": "caquot", "phase": "discharge", "depth": 3.5}
    assert float(wheat["wall_normal_pressure"].sel(here)) / TONNE_PER_M2 == pytest.approx(2.353, rel=1e-3, abs=0)


@pytest.mark.parametrize("row", PRESSURE.values(), ids=list(PRESSURE))
def test_row_is_complete(row):
    assert cite(row.source)
    assert not list(row.faults())
    assert row.key in PROVEN or "no published numbers" in row.validity
    for quantities in (*row.hopper.values(), *row.totals.values()):
        for function in quantities.values():
            assert "Source: " in inspect.getdoc(function)


def test_every_file_of_published_values_is_of_a_method():
    assert set(PROVEN) <= set(PRESSURE)


def test_rows_can_be_told_apart_without_colour():
    assert len({row.marker for row in PRESSURE.values()}) == len(PRESSURE)
    assert len({row.colour for row in PRESSURE.values()}) == len(PRESSURE)
