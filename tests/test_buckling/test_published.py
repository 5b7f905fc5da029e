"""Every rule brings the proof that it may be shipped: printed numbers, or a plain word that it is second-hand."""

import inspect
from pathlib import Path

import numpy as np
import pytest

from silostudy.buckling import BUCKLING, MEMBERS, RIVALS, miller1977
from silostudy.buckling.family import PARAMETERS, classical_stress
from silostudy.tables.miller1977 import TESTS
from silostudy.tables.read import HERE, rows
from silostudy.tables.references import cite

PUBLISHED = Path(__file__).parents[1] / "published/buckling"
PRINTED = ("miller1977", "classical")
MILLER = {
    "long": lambda p: miller1977.long_coefficient(p["slender"], p["fabricated"], p["safe"]),
    "short": lambda p: miller1977.short_coefficient(p["slender"], p["fabricated"], p["safe"]),
    "ring": lambda p: miller1977.ring_coefficient(
        p["argument"], miller1977.long_coefficient(p["slender"], p["fabricated"], p["safe"])
    ),
    "plastic": lambda p: miller1977.inelastic_ratio(np.array(p["argument"])),
}


@pytest.mark.parametrize("point", rows(PUBLISHED / "miller1977.csv", text=("quantity",)), ids=lambda p: p["where"])
def test_miller_prints(point):
    rounding = 0.5 * 10 ** -point["digits"] / point["value"]
    assert float(MILLER[point["quantity"]](point)) == pytest.approx(point["value"], rel=rounding, abs=0)


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


def test_classical_coefficient():
    for point in rows(PUBLISHED / "classical.csv"):
        computed = classical_stress(
            youngs_modulus=1.0, shell_poisson_ratio=point["shell_poisson_ratio"], shell_radius=1.0, thickness=1.0
        )
        assert computed == pytest.approx(point["coefficient"], abs=5e-4)


def test_radius_of_the_small_tests_follows_from_the_printed_slenderness():
    printed = rows(HERE / "miller1977_small_scale.csv", text=("test", "material", "collapse", "shape"))
    assert len(printed) == 41
    slender = [TESTS[raw["test"]].shell_radius / TESTS[raw["test"]].thickness for raw in printed]
    assert np.abs(np.array(slender) - [raw["radius_over_thickness"] for raw in printed]).max() < 0.75


@pytest.mark.parametrize("row", [*BUCKLING.values(), *RIVALS.values()], ids=[*BUCKLING, *RIVALS])
def test_row_is_complete(row):
    assert cite(row.source)
    assert row.needs <= set(PARAMETERS)
    assert row.colour.startswith("#")
    proven = row.key in PRINTED and (PUBLISHED / f"{row.key}.csv").is_file()
    assert proven or "second-hand" in row.validity or "for comparison only" in row.validity


def test_rules_can_be_told_apart_without_colour():
    assert len({row.marker for row in BUCKLING.values()}) == len(BUCKLING)
    assert len({(row.colour, row.line) for row in BUCKLING.values()}) == len(BUCKLING)


@pytest.mark.parametrize("member", MEMBERS, ids=lambda member: member.__name__.split(".")[-1])
def test_every_equation_names_its_unit_and_source(member):
    functions = [f for f in vars(member).values() if inspect.isfunction(f) and f.__module__ == member.__name__]
    equations = [f for f in functions if "Source:" in (f.__doc__ or "")]
    assert equations or member.__name__.endswith("classical")
    for function in equations:
        assert (
            "(1)" in function.__doc__ or "(Pa)" in function.__doc__ or "(m)" in function.__doc__ or "True" in function.__doc__
        )
