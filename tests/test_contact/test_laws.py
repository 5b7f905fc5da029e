"""The contact laws as plain functions of floats, and the stiffness that Kiyama & Fujimura print."""

import csv
from math import log, pi, sqrt

import numpy as np
import pytest

from silostudy.contact import COHESION, FAMILIES, NORMAL, ROLLING, TANGENTIAL, curve
from silostudy.contact.family import Touch
from silostudy.errors import BadInput
from silostudy.tables import kiyama_1983 as kiyama
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.references import cite
from tests.conftest import ROOT

KGF_CM2, GF_CM = 1e4 * STANDARD_GRAVITY, 0.1 * STANDARD_GRAVITY  # Pa, N/m
WEIGHT = kiyama.DENSITY * STANDARD_GRAVITY  # N/m3
CUT, LINE = NORMAL["spring-dashpot"], NORMAL["line-contact"]
PRINTED = list(csv.DictReader((ROOT / "tests/published/contact/kiyama_fujimura_1983.csv").open()))


def touch(mass, dt) -> Touch:
    """A contact of this reduced mass, of discs of 2 cm."""
    return Touch(mass, 0.01, dt)


@pytest.mark.parametrize("row", PRINTED, ids=lambda row: row["youngs_modulus_kgf_cm2"])
@pytest.mark.parametrize(("constant", "load"), [("1.5", 69.0), ("2/3", 30.0)])
def test_table_1(row, constant, load):
    """K_n / rho g of Table 1: with 1.5 as eq. (23) prints it the load is 69 gf/cm, with 2/3 of eq. (22a) 30 gf/cm."""
    youngs = float(row["youngs_modulus_kgf_cm2"]) * KGF_CM2
    constant = curve.PRINTED_CONSTANTS[constant]
    found = curve.secant(0.01, load=load * GF_CM, youngs_modulus=youngs, poissons_ratio=0.3, constant=constant)
    assert found / WEIGHT * 100.0 == pytest.approx(float(row["stiffness_over_weight_cm"]), rel=5e-3)


def test_the_curve_is_inverted_to_rounding():
    a, b = curve.curve(0.01, youngs_modulus=7.35e7, poissons_ratio=0.3)
    for load in np.geomspace(1e-3, 1e4, 15):
        overlap = a * load * (b - log(load))
        assert curve.load_of(overlap, a, b) == pytest.approx(load, rel=1e-13)
    assert curve.load_of(0.0, a, b) == 0.0


def test_the_secant_of_the_curve_is_the_stiffness():
    a, b = curve.curve(0.01, youngs_modulus=7.35e7, poissons_ratio=0.3)
    stiffness = curve.secant(0.01, load=67.7, youngs_modulus=7.35e7, poissons_ratio=0.3)
    assert 67.7 / (a * 67.7 * (b - log(67.7))) == pytest.approx(stiffness, rel=1e-12)


@pytest.mark.parametrize(("energy", "law", "c"), [
    (CUT.energy, CUT.law, (2e6, 0.0, 0.0)),
    (LINE.energy, LINE.law, (*curve.curve(0.01, youngs_modulus=7.35e7, poissons_ratio=0.3), 0.0, 0.0)),
])  # fmt: skip
def test_the_energy_is_the_integral_of_the_force(energy, law, c):
    overlaps = np.linspace(0.0, 2e-4, 20001)
    force = np.array([law(overlap, 0.0, touch(1.0, 1e-5), c)[0] for overlap in overlaps])
    work = float(((force[1:] + force[:-1]) / 2.0 * np.diff(overlaps)).sum())
    assert energy(overlaps[-1], touch(1.0, 1e-5), c) == pytest.approx(work, rel=1e-6)


def test_what_becomes_of_the_dashpots_pull():
    c = (1e6, 500.0, 0.0)
    for key, expected in (("", 0.0), ("-tension", 10.0 - 500.0), ("-implicit", 0.0)):
        elastic, total = NORMAL[f"spring-dashpot{key}"].law(1e-5, -1.0, touch(1.0, 1e-6), c)
        assert (elastic, total) == (pytest.approx(10.0), pytest.approx(expected))
    assert CUT.law(1e-5, 1.0, touch(1.0, 1e-6), c)[1] == pytest.approx(510.0)


def test_a_dashpot_by_the_root_of_the_mass():
    assert CUT.law(0.0, 2.0, touch(9.0, 1e-6), (1.0, 0.0, 5.0))[1] == pytest.approx(30.0)


def test_the_implicit_dashpot_acts_on_the_speed_it_leaves():
    c, mass, dt, closing = (1e6, 500.0, 0.0), 2.0, 1e-3, 0.5
    implicit = NORMAL["spring-dashpot-implicit"].law
    elastic, total = implicit(1e-5, closing, touch(mass, dt), c)
    dashpot = total - elastic
    assert dashpot == pytest.approx(500.0 * (closing - dt * dashpot / mass), rel=1e-13)
    assert implicit(1e-5, 0.0, touch(mass, dt), c) == (elastic, elastic)  # at rest the spring alone carries


def test_the_implicit_slider_acts_on_the_speed_it_leaves():
    """A rim moved by a tangential force gains three times the speed of a point of the disc's mass."""
    c, mass, dt, speed = (0.0, 30.0, 0.0, 0.5), 2.0, 1e-2, 1e-3
    law = TANGENTIAL["spring-slider-implicit"].law
    stored, total = law(7.0, speed, touch(mass, dt), 100.0, 100.0, c)
    assert stored == 7.0
    assert total - stored == pytest.approx(-30.0 * (speed + 3.0 * dt * (total - stored) / mass), rel=1e-13)
    assert law(60.0, speed, touch(mass, dt), 100.0, 100.0, c) == (50.0, 50.0)


def test_the_slider_of_the_paper():
    c = (1e5, 30.0, 0.0, 0.5)
    law = TANGENTIAL["spring-slider"].law
    stored, total = law(0.0, 1e-3, touch(1.0, 1e-3), 100.0, 100.0, c)
    assert stored == pytest.approx(-0.1)
    assert total == pytest.approx(-0.1 - 0.03)  # sticks: spring and dashpot
    stored, total = law(-49.99, 1.0, touch(1.0, 1e-3), 100.0, 100.0, c)
    assert stored == total == pytest.approx(-50.0)  # slips: mu times the elastic part, no dashpot


def test_the_slider_on_the_sum():
    law = TANGENTIAL["spring-slider-total"].law
    stored, total = law(-49.99, 1.0, touch(1.0, 1e-3), 100.0, 80.0, (1e5, 30.0, 0.0, 0.5))
    assert total == pytest.approx(-40.0)
    assert stored == pytest.approx(-40.0 + 30.0)


def test_viscous_coulomb():
    law = TANGENTIAL["viscous-coulomb"].law
    assert law(0.0, 1e-3, touch(1.0, 1e-3), 100.0, 80.0, (30.0, 0.0, 0.5)) == (0.0, pytest.approx(-0.03))
    assert law(0.0, 1e3, touch(1.0, 1e-3), 100.0, 80.0, (30.0, 0.0, 0.5)) == (0.0, pytest.approx(-40.0))


def test_rolling_and_cohesion():
    roll = ROLLING["spring-slider"].law
    assert roll(0.0, 2.0, touch(1.0, 1e-3), 100.0, (5.0, 0.1)) == (pytest.approx(-0.01), pytest.approx(-0.01))
    assert roll(0.0, 2e3, touch(1.0, 1e-3), 100.0, (5.0, 0.1)) == (pytest.approx(-0.1), pytest.approx(-0.1))
    assert COHESION["constant-pull"].law(touch(1.0, 1e-3), (3.0,)) == 3.0


def test_impossible_loads():
    with pytest.raises(BadInput, match="load"):
        curve.secant(0.01, load=0.0, youngs_modulus=1e8, poissons_ratio=0.3)
    with pytest.raises(BadInput, match="narrower"):
        curve.secant(0.01, load=1e9, youngs_modulus=1e8, poissons_ratio=0.3)


@pytest.mark.parametrize("family", FAMILIES.values(), ids=lambda family: family.name)
def test_every_row_has_source_and_units(family):
    for row in family.values():
        assert cite(row.source)
        units = ("N/m", "N m/m") if "discs" in row.grains else ("(N)", "(N m)", "N m/m")
        assert any(unit in row.law.__doc__ for unit in units)


def test_the_paper_s_dashpot_follows_from_its_stiffness():
    """Table 2: eta_n / rho g = 15.3 cm s is 2 sqrt(m K) / sqrt 2."""
    mass = kiyama.DENSITY * pi * kiyama.RADIUS**2
    critical = 2.0 * sqrt(mass * kiyama.NORMAL_STIFFNESS)
    assert kiyama.DAMPING_RATIO * critical == pytest.approx(kiyama.NORMAL_DAMPING, rel=5e-3)


@pytest.mark.parametrize("key", [row.key for row in TANGENTIAL.values() if row.acts])
@pytest.mark.parametrize("speed", [1e-4, 10.0])
def test_a_motion_in_space_is_one_in_the_plane_along_its_direction(key, speed):
    """Where it sticks and where it slips: three numbers along a direction are the plane's one times that direction."""
    law, along = TANGENTIAL[key].law, np.array([2.0, -1.0, 2.0]) / 3.0
    c = tuple(np.array([1e6, 30.0, 1.0, 0.5])[-len(TANGENTIAL[key].coefficients) :])
    at = touch(2.0, 1e-5), 100.0, 100.0, c
    plane = law(7.0, speed, *at)
    space = law(tuple(7.0 * along), tuple(speed * along), *at)
    assert np.array(space[1]) == pytest.approx(plane[1] * along, rel=1e-12)
    if TANGENTIAL[key].stores:
        assert np.array(space[0]) == pytest.approx(plane[0] * along, rel=1e-12)


@pytest.mark.parametrize("tangential", [row.key for row in TANGENTIAL.values() if row.acts])
@pytest.mark.parametrize("normal", NORMAL)
@pytest.mark.parametrize("closing", [-1.0, 1.0])
def test_friction_has_no_direction_of_its_own(normal, tangential, closing):
    """Every product of laws, where the dashpot pulls and where it presses: no sliding, no force; else never along with it."""
    normal_c = tuple(curve.curve(0.01, youngs_modulus=7e7, poissons_ratio=0.3)) if "line" in normal else (1e6,)
    elastic, total = NORMAL[normal].law(1e-5, closing, touch(2.0, 1e-5), (*normal_c, 500.0, 0.0))
    c = tuple(np.array([1e6, 30.0, 1.0, 0.5])[-len(TANGENTIAL[tangential].coefficients) :])
    law = TANGENTIAL[tangential].law
    stored, still = law(0.0, 0.0, touch(2.0, 1e-5), elastic, total, c)
    assert (stored, still) == (0.0, 0.0)
    one, other = (law(0.0, speed, touch(2.0, 1e-5), elastic, total, c)[1] for speed in (3.0, -3.0))
    assert one == -other
    assert one <= 0.0
