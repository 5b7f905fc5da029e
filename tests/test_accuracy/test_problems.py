"""Ladders, references and costs: errors fall as they should, and references come from elsewhere."""

from importlib import import_module

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.front import cheapest, on_front
from silostudy.accuracy.measure import COMPARE, machine, measure
from silostudy.accuracy.problems import beam_frequency, dem_impact, dem_static, history, spheres_static, strain_energy
from silostudy.accuracy.silo import silo_of_rows
from silostudy.accuracy.single_precision import step_rounded
from silostudy.dem.engine import Engine
from silostudy.tables.problems import GROUPS, PROBLEMS

# problem, ladder, quantity: factor by which the error falls between its last two rungs, each with half the step
FALLS = {
    ("depth_levels", "even levels", "wall_force"): 4.0,
    ("radial_field", "steps", "flow_slope"): 8.0,
    ("hopper_force", "even places, trapezoidal rule", "discharge_force"): 4.0,
    ("shell_levels", "even levels", "axial_wall_force"): 4.0,
    ("beam_frequency", "elements of degree 1", "fifth_frequency"): 4.0,
    ("beam_frequency", "elements of degree 2", "fifth_frequency"): 16.0,
    ("history", "exact recursion", "displacement"): 4.0,
    ("history", "Newmark, mean acceleration", "displacement"): 4.0,
    ("dem_impact", "17-18", "restitution"): 2.0,
    ("dem_impact", "17-19", "restitution"): 2.0,
    ("dem_impact", "velocity-verlet", "restitution"): 2.0,
    ("dem_impact", "17-18, dashpot implicit", "restitution"): 2.0,
}


def errors(key, ladder, quantity, last):
    module = import_module(f"silostudy.accuracy.problems.{key}")
    expected = module.reference()[quantity]
    return [
        COMPARE[PROBLEMS[key].compare](np.asarray(module.prepare(ladder, setting)()[quantity]), np.asarray(expected))[0]
        for setting in module.LADDERS[ladder][-last:]
    ]


@pytest.mark.parametrize("row", PROBLEMS.values(), ids=lambda row: row.key)
def test_every_problem_has_ladders_from_coarse_to_fine(row):
    module = import_module(f"silostudy.accuracy.problems.{row.key}")
    assert row.group in GROUPS
    assert row.compare in COMPARE
    for settings in module.LADDERS.values():
        steps = np.diff(settings)
        assert (steps > 0).all() or (steps < 0).all()


@pytest.mark.parametrize(
    ("rung", "factor"),
    [pytest.param(*each, marks=pytest.mark.long if each[0][0] == "dem_impact" else ()) for each in FALLS.items()],
    ids=map("-".join, FALLS),
)
def test_errors_fall_with_the_order_of_the_method(rung, factor):
    coarse, fine = errors(*rung, last=2)
    assert coarse / fine == pytest.approx(factor, rel=0.12)


@pytest.mark.long
def test_a_finer_step_drowns_in_single_precision():
    """Below some step a disc at rest no longer moves by a digit; doubles go on getting better."""
    rounded = errors("dem_static", dem_static.SINGLE, "wall_force", last=3)
    double = errors("dem_static", "17-18", "wall_force", last=4)[:3]
    assert dem_static.LADDERS[dem_static.SINGLE][-3:] == dem_static.LADDERS["17-18"][-4:-1]
    assert rounded[-1] > 1.5 * rounded[0]
    assert double[-1] < 0.5 * double[0]
    assert rounded[-1] > 10.0 * double[-1]


GRAINS = {"discs": silo_of_rows(4, 4)[0], "spheres": bin_of_spheres(Bin(count=60, wide=0.014, outlet=0.02))}


@pytest.mark.parametrize("model", GRAINS.values(), ids=GRAINS)
def test_rounding_is_all_that_sets_the_single_ladder_apart(model, monkeypatch):
    whole, stepped, rounded = Engine(model), Engine(model), Engine(model)
    whole.step_to(3000)
    assert whole.parts[0].pairs.stored.any()
    assert whole.parts[0].near.stored.any()
    step_rounded(rounded, 3000)
    monkeypatch.setattr(np, "float32", np.float64)
    step_rounded(stepped, 3000)
    assert np.array_equal(whole.bodies.rows, stepped.bodies.rows)
    apart = np.abs(rounded.places - whole.places).max()
    assert 1e-10 < apart < 1e-5


@pytest.mark.long
def test_spheres_in_single_precision_lie_elsewhere_and_as_high():
    soft, single = (ladder for ladder in spheres_static.LADDERS if "10 MPa" in ladder)
    double, rounded = (spheres_static.prepare(ladder, spheres_static.LADDERS[ladder][0], 2)() for ladder in (soft, single))
    assert (rounded["wall_push"] != double["wall_push"]).all()
    assert rounded["centre_height"] == pytest.approx(double["centre_height"], rel=0.03)


@pytest.mark.parametrize(("problem", "quantity"), [("strain_energy", "wall_pressure"), ("shell_strength", "strength")])
def test_double_precision_has_sixteen_digits_of_fifty_and_single_seven(problem, quantity):
    single, double = errors(problem, "float", quantity, last=2)
    assert 1e-8 < single < 1e-6
    assert 0 < double < 1e-14


def test_the_decimal_formula_is_not_the_package_s():
    """It must notice a changed friction: a reference that follows every mistake proves nothing."""
    exact = strain_energy.reference()["wall_pressure"]
    given = strain_energy.silos()
    z = given.pop("z")
    wrong = strain_energy.call(strain_energy.envelope_pressure, z, given | {"wall_friction": given["wall_friction"] * 1.001})
    assert np.abs(wrong / exact - 1).max() > 1e-4


def test_beam_converges_faster_than_any_power():
    found = errors("beam_frequency", "one element, its degree", "fifth_frequency", last=8)
    orders = np.diff(np.log(found[:5])) / np.diff(np.log(beam_frequency.DEGREES[-8:-3]))
    assert (orders < -8).all()
    assert (np.diff(orders) < 0).all()


def test_settings_of_the_package_reach_the_references():
    """The package's own settings: 40 halvings, 81 nodes in the hopper, all modes of a polynomial of degree 17."""
    assert errors("shell_thickness", "halvings of log R/t", "required_thickness", last=1)[0] < 1e-10
    assert errors("shell_thickness", "halvings of log R/t", "strength", last=1)[0] < 1e-10
    for phase in ("filling", "discharge"):
        assert errors("hopper_force", "double-exponential rule in two parts", f"{phase}_force", last=1)[0] < 1e-12
    for quantity in ("top_acceleration", "base_shear", "base_moment"):
        assert errors("beam_modes", "modes", quantity, last=1)[0] < 1e-6


def test_every_halving_halves_the_error_of_the_thickness():
    coarse, fine = errors("shell_thickness", "halvings of log R/t", "required_thickness", last=5)[::4]
    assert 0.2 < coarse / fine / 2.0 ** (40 - 18) < 5.0


def test_a_few_modes_give_the_top_and_not_the_base_shear():
    """The rest of the shape moves with the base as a rigid body does; no such term stands in for the shear left out."""
    top, shear = (errors("beam_modes", "modes", name, last=10)[4] for name in ("top_acceleration", "base_shear"))
    assert top < 1e-3
    assert shear > 0.03


def test_levels_that_miss_a_strake_s_edge_miss_the_utilisation_and_not_the_force():
    force, used = (errors("shell_levels", "even levels", name, last=7)[0] for name in ("axial_wall_force", "utilisation"))
    assert force < 0.004
    assert used > 0.1


def test_restitution_against_an_independent_integration():
    zeta = dem_impact.DAMPING_RATIO

    def ends(t, y):
        return y[0] + 2 * zeta * y[1]

    ends.terminal, ends.direction = True, -1
    done = solve_ivp(lambda t, y: [y[1], -y[0] - 2 * zeta * y[1]], (0, 10), [0.0, 1.0], events=ends, rtol=1e-11, atol=1e-13)
    assert float(dem_impact.reference()["restitution"]) == pytest.approx(-done.y[1, -1], rel=1e-8)


def test_shaken_oscillator_against_an_independent_integration():
    w, forced = 2 * np.pi * history.NATURAL, 2 * np.pi * history.SHAKING
    times = np.arange(101) * history.STEPS[0]
    done = solve_ivp(
        lambda t, y: [y[1], -np.sin(forced * t) - 2 * history.DAMPING * w * y[1] - w**2 * y[0]],
        (0, times[-1]), [0.0, 0.0], t_eval=times, method="DOP853", rtol=1e-11, atol=1e-15,
    )  # fmt: skip
    exact = history.reference()["displacement"]
    assert np.abs(done.y[0] - exact).max() < 1e-8 * np.abs(exact).max()


def test_front_against_brute_force():
    random = np.random.default_rng(3)
    cost, error = random.integers(1, 9, 40).astype(float), random.integers(1, 9, 40).astype(float)
    error[5] = np.nan
    kept = on_front(cost, error)
    for k in np.flatnonzero(kept):
        assert not ((cost <= cost[k]) & (error <= error[k]) & ((cost < cost[k]) | (error < error[k]))).any()
    for k in np.flatnonzero(~kept):
        better = (cost <= cost[k]) & (error <= error[k])
        better[k] = False
        assert np.isnan(error[k]) or better.any()


def test_cheapest_that_reaches():
    cost, error = [1.0, 2.0, 3.0, 4.0], [0.3, np.nan, 0.01, 0.001]
    assert cheapest(cost, error, 0.02) == 2
    assert cheapest(cost, error, 1e-9) is None


def test_interval_of_means_covers_equal_ones():
    random, covered = np.random.default_rng(4), 0
    for _ in range(400):
        _, low, _, floor = COMPARE["means"](random.normal(5.0, 1.0, 10), random.normal(5.0, 1.0, 40))
        covered += low == 0.0
        assert floor > 0.0
    assert 0.92 < covered / 400 < 0.98
    assert COMPARE["means"](random.normal(5.0, 0.1, 10), random.normal(6.0, 0.1, 40))[1] > 0.1


def test_measuring_repeats_short_runs_and_says_on_what():
    rungs = measure("beam_frequency", repeats=3, members=4, rungs=2, ladders=1)
    assert [rung.setting for rung in rungs] == [3, 4]
    assert all(len(rung.seconds) == 3 and rung.cost > 0 for rung in rungs)
    assert machine()["machine"].endswith("cores")
    assert set(machine()) == {"machine", "measured_with", "measured_on"}
