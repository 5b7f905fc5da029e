"""Miller's 45 tests: the statistics that settle how his section must be read."""

import numpy as np
import pytest

from silostudy.choice.expand import expand_file
from silostudy.compute.buckling import buckling_cube
from silostudy.figures.miller_statistics import statistics
from tests.conftest import ROOT


@pytest.fixture(scope="module")
def cube():
    return buckling_cube(expand_file(ROOT / "config/studies/miller-1977.yaml"))


def group(cube, rule: str, name: str):
    found = statistics(cube)
    return found[(found.rule == rule) & (found.group == name)].iloc[0]


@pytest.mark.parametrize(
    ("name", "tests", "mean", "cov", "least"),
    [
        ("small, all", 41, 1.102, 0.118, 0.879),
        ("small, no rings", 8, 1.260, 0.157, 1.082),
        ("small, rings", 33, 1.063, 0.066, 0.879),
    ],
)
def test_reference_statistics(cube, name, tests, mean, cov, least):
    found = group(cube, "miller1977", name)
    assert found.tests == tests
    assert found["mean"] == pytest.approx(mean, abs=0.002)
    assert found["cov"] == pytest.approx(cov, abs=0.0006)
    assert found["min"] == pytest.approx(least, abs=0.0006)


def test_weakest_test_is_12_and_large_tests_hold(cube):
    assert group(cube, "miller1977", "small, all").weakest_test == "12"
    large = group(cube, "miller1977", "large, rings")
    assert large.tests == 4
    assert 0.95 < large["min"] < large["max"] < 1.45


@pytest.mark.parametrize("rival", ["junction_3_5", "radius_15_in"])
def test_misprints_scatter_more(cube, rival):
    right, wrong = (group(cube, rule, "small, all") for rule in ("miller1977", f"miller1977_{rival}"))
    assert wrong["cov"] > 1.9 * right["cov"]


def test_half_radius_is_unsafe_and_natural_log_impossible(cube):
    """A diameter of 7.5 in. scatters little but is no lower bound; with the natural logarithm C would be negative."""
    assert group(cube, "miller1977_diameter_7_5_in", "small, all")["max"] < 1
    natural = group(cube, "miller1977_natural_log", "small, all")
    assert (natural.tests, natural.masked) == (0, 41)


@pytest.mark.parametrize("rival", ["eq_14b", "plain_6_2"])
def test_readings_that_the_tests_do_not_decide(cube, rival):
    right, other = (group(cube, rule, "small, all") for rule in ("miller1977", f"miller1977_{rival}"))
    assert other["mean"] == pytest.approx(right["mean"], abs=0.001)


def test_scope_of_the_other_rules(cube):
    for rule, covered in (("classical", 8), ("nasa_sp8007", 8), ("en1993_1_6_2007", 41), ("en1993_1_6_2025", 41)):
        strength = cube["buckling_stress"].sel({"rule": rule})
        assert int(strength.notnull().sum()) == covered
        meanings = str(cube["buckling_stress_scope"].attrs["flag_meanings"]).split()
        masked = cube["buckling_stress_scope"].sel({"rule": rule}).values[strength.isnull().values]
        assert {meanings[flag] for flag in masked} <= {
            "rings_not_covered",
            "rings_too_small_to_count",
        }  # the large tests' whole lengths are not known


def test_european_rules_are_safe_for_every_test(cube):
    """Characteristic strengths of class B: below every one of the 45 collapse stresses, and the classical stress above."""
    ratio = cube["test_lower_buckling_stress"] / cube["buckling_stress"]
    assert float(ratio.sel({"rule": ["en1993_1_6_2007", "en1993_1_6_2025"]}).min()) > 1.1
    assert float(ratio.sel({"rule": "classical"}).max()) < 0.7


def test_charts_agree_with_the_rule(cube):
    """The curves drawn and the strengths of the tests come from the same functions."""
    chart = cube["chart_local_coefficient"].sel(chart_making="manufactured")
    one = cube.sel(test="1.1", rule="miller1977")
    slender = float(one["shell_radius"] / one["thickness"])
    length = float(one["bay_length"] / np.sqrt(one["shell_radius"] * one["thickness"]))
    drawn = float(chart.interp(chart_slenderness=slender, chart_relative_length=length))
    assert drawn == pytest.approx(float(one["elastic_local_stress"] / one["youngs_modulus"]) * slender, rel=2e-3)
