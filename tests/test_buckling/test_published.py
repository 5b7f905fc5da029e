"""Every rule brings the proof that it may be shipped: printed numbers, or a plain word that it is second-hand."""

import inspect
from importlib import import_module
from pkgutil import iter_modules

import numpy as np
import pytest

from silostudy import buckling
from silostudy.buckling import BUCKLING, RIVALS, miller1977
from silostudy.buckling.family import QUANTITIES
from silostudy.compute.buckling import buckling_cube
from silostudy.tables.miller1977 import TESTS
from silostudy.tables.read import HERE, rows
from silostudy.tables.references import cite
from silostudy.tables.units import split_unit
from tests.conftest import expanded
from tests.proof import PUBLISHED, points, printed, scene_of

FOLDER = PUBLISHED / "buckling"
PROVEN = sorted(path.stem for path in FOLDER.glob("*.csv"))


@pytest.mark.parametrize("rule", PROVEN)
def test_published_values(rule):
    found = points(FOLDER / f"{rule}.csv")
    given = [column for column in found[0] if split_unit(column)[0] in QUANTITIES]
    keys = [column for column in found[0] if column not in (*given, "precision", "source", "locator")]
    for point in found:
        content = {"kind": "buckling", "title": rule, "scene": scene_of(point, keys), "rules": [rule]}
        cube = buckling_cube(expanded(content)).squeeze()
        for column in given:
            if point[column]:
                quantity, value, precision = printed(point, column)
                assert float(cube[quantity]) == pytest.approx(value, rel=precision, abs=0), point


@pytest.mark.parametrize("slender", [200, 500, 580, 1000])
def test_miller_eqs_4_and_5_follow_from_eq_3(slender):
    """C = -0.025 - 0.286 log(U R/t) with the printed U of 0.00035 and 0.00050."""
    for fabricated, imperfection in ((False, 0.00035), (True, 0.00050)):
        printed = -0.025 - 0.286 * np.log10(imperfection * slender)
        if 0.125 < printed < 0.34:
            assert miller1977.long_coefficient(slender, fabricated, False) == pytest.approx(printed, abs=1e-3)


def test_junction_is_about_ten():
    """The text: long and short shells meet at M of about 10; for the nominal R/t of the tests 9.8 to 14.2."""
    slender = np.array([250.0, 375.0, 500.0])
    short, long = (f(slender, False, False) for f in (miller1977.short_coefficient, miller1977.long_coefficient))
    np.testing.assert_allclose((short / long) ** (5 / 3), [9.8, 11.9, 14.2], atol=0.06)


def test_radius_of_the_small_tests_follows_from_the_printed_slenderness():
    printed = rows(HERE / "miller1977_small_scale.csv", text=("test", "material", "collapse", "shape"))
    assert len(printed) == 41
    slender = [TESTS[raw["test"]].shell_radius / TESTS[raw["test"]].thickness for raw in printed]
    assert np.abs(np.array(slender) - [raw["radius_over_thickness"] for raw in printed]).max() < 0.75


@pytest.mark.parametrize("row", [*BUCKLING.values(), *RIVALS.values()], ids=[*BUCKLING, *RIVALS])
def test_row_is_complete(row):
    assert cite(row.source)
    assert not list(row.faults())
    assert row.key in PROVEN or "second-hand" in row.validity or "for comparison only" in row.validity


def test_every_file_of_published_values_is_of_a_rule():
    assert set(PROVEN) <= set(BUCKLING)


def test_rules_can_be_told_apart_without_colour():
    assert len({row.marker for row in BUCKLING.values()}) == len(BUCKLING)
    assert len({(row.colour, row.line) for row in BUCKLING.values()}) == len(BUCKLING)


@pytest.mark.parametrize("name", sorted(module.name for module in iter_modules(buckling.__path__)))
def test_every_equation_names_its_unit_and_source(name):
    member = import_module(f"silostudy.buckling.{name}")
    functions = [f for f in vars(member).values() if inspect.isfunction(f) and f.__module__ == member.__name__]
    equations = [f for f in functions if "Source:" in (f.__doc__ or "")]
    assert equations or name in ("classical", "thickness")
    for function in equations:
        assert (
            "(1)" in function.__doc__ or "(Pa)" in function.__doc__ or "(m)" in function.__doc__ or "True" in function.__doc__
        )
