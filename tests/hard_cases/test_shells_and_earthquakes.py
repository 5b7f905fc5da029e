"""Hard cases of shell buckling, and of tubes and records in earthquakes."""

from dataclasses import replace
from math import inf, nan, pi

import mpmath
import numpy as np
import pytest

from silostudy.buckling import BUCKLING
from silostudy.buckling.family import HOOP_YIELD, IN_SCOPE, OUT_OF_RANGE, SUCTION, evaluate
from silostudy.config.load import study_of
from silostudy.errors import BadInput
from silostudy.seismic.added_mass import volume_ratio
from silostudy.seismic.beam import modes, second_moment, section_area
from silostudy.seismic.identify import coefficient_of_frequency
from silostudy.seismic.readers import read_record
from silostudy.seismic.records import Record, in_band, scaled, without_baseline
from silostudy.seismic.response import oscillators, refined, transfer
from tests.test_seismic.test_beam import MODEL

SHELL = {
    "youngs_modulus": 2.1e11, "shell_poisson_ratio": 0.3, "yield_stress": 2.35e8, "shell_radius": 5.0, "thickness": 0.01,
    "bay_length": 10.0, "total_length": 20.0, "ring_area": 0.0, "fabricated": 1.0, "safe_constants": 0.0,
    "fabrication_quality": 25.0, "end_factor": 1.0, "lower_internal_pressure": 0.0, "upper_internal_pressure": 0.0,
}  # fmt: skip


@pytest.mark.parametrize("rule", BUCKLING)
@pytest.mark.parametrize("slender", [10.0, 100.0, 1e3, 1e4, 1e5, 1e6])
def test_radius_over_thickness_from_ten_to_a_million(rule, slender):
    """A strength between nothing and the hardened yield stress, elastic at most the perfect shell's, or masked and why."""
    found = evaluate(BUCKLING[rule], SHELL | {"thickness": 5.0 / slender})
    if found["buckling_stress_scope"] != IN_SCOPE:
        assert found["buckling_stress_scope"] == OUT_OF_RANGE
        assert np.isnan(found["buckling_stress"])
        assert slender < 20 or slender >= 1500
        return
    assert 0.0 < found["buckling_stress"] <= 1.1 * SHELL["yield_stress"]
    assert found["elastic_knockdown_factor"] <= 1.05  # Miller's short bays stand a little above the perfect long shell


@pytest.mark.parametrize("rule", BUCKLING)
def test_thinner_shells_are_never_stronger(rule):
    """Over five decades of R/t, with no jump up where a formula changes its branch; Miller's own branches meet to 0.2 %."""
    slender = np.geomspace(10.0, 1e6, 11_500)
    found = evaluate(BUCKLING[rule], SHELL | {"thickness": 5.0 / slender})
    stress = found["buckling_stress"][found["buckling_stress_scope"] == IN_SCOPE]
    assert np.all(np.diff(stress) <= (2e-3 if rule == "miller1977" else 1e-9) * stress[:-1])


@pytest.mark.parametrize(("name", "value"), [
    ("bay_length", 0.0), ("bay_length", -1.0), ("thickness", 0.0), ("shell_radius", nan), ("yield_stress", 0.0),
    ("ring_area", -1e-6),
])  # fmt: skip
def test_shell_that_cannot_be(name, value):
    with pytest.raises(BadInput, match=rf"{name} = .*(above 0|not be negative)"):
        evaluate(BUCKLING["miller1977"], SHELL | {name: value})


def test_bay_of_no_length_in_a_study():
    scene = {"radius_m": 5.0, "thickness_mm": 10.0, "bay_length_m": 0.0, "quality": "B", "yield_stress_MPa": 235.0,
             "manufacture": "fabricated"}  # fmt: skip
    with pytest.raises(BadInput, match=r"bay_length_m = 0\.0: must be greater than 0"):
        study_of({"kind": "buckling", "title": "t", "rules": "all", "scene": scene}, "study.yaml")


@pytest.mark.parametrize("length", [1e-6, 1e-3, 0.1])
def test_bay_next_to_no_length(length):
    """A very short bay does not buckle: it yields, by every rule that counts the length, or the rule is blind to it."""
    for rule in ("miller1977", "en1993_1_6_2007", "en1993_1_6_2025"):
        short = evaluate(BUCKLING[rule], SHELL | {"bay_length": length * np.sqrt(5.0 * 0.01)})
        assert float(short["buckling_stress"]) >= float(evaluate(BUCKLING[rule], SHELL)["buckling_stress"])
    assert float(evaluate(BUCKLING["en1993_1_6_2007"], SHELL | {"bay_length": 1e-6})["buckling_stress"]) == 2.35e8


def test_suction_and_a_hoop_at_yield():
    for rule in BUCKLING:
        found = evaluate(BUCKLING[rule], SHELL | {"lower_internal_pressure": -1.0})
        assert found["buckling_stress_scope"] == SUCTION
    at_yield = 2.35e8 * 0.01 / 5.0
    for year in ("2007", "2025"):
        rule = BUCKLING[f"en1993_4_1_{year}"]
        below, at = (evaluate(rule, SHELL | {"upper_internal_pressure": at_yield * share}) for share in (1.0 - 1e-12, 1.0))
        assert below["buckling_stress_scope"] == IN_SCOPE
        assert float(below["buckling_stress"]) < 1e-6 * 2.35e8
        assert at["buckling_stress_scope"] == HOOP_YIELD


def test_pressures_in_the_wrong_order():
    with pytest.raises(BadInput, match=r"lower_internal_pressure.*must not exceed"):
        evaluate(BUCKLING["classical"], SHELL | {"lower_internal_pressure": 2.0, "upper_internal_pressure": 1.0})


def test_record_with_a_spike():
    """One huge sample among none: the answer is the triangle's impulse response, to nine digits."""
    dt, at, frequency, damping = 0.01, 50, 2.0, 0.05
    acceleration = np.zeros(400)
    acceleration[at] = 1e6
    (found,), _ = oscillators(acceleration, dt, [frequency], damping)
    natural = 2.0 * pi * frequency
    damped = natural * np.sqrt(1.0 - damping**2)
    assert np.all(found[:at] == 0.0)
    with mpmath.workdps(30):
        for t in (10, 100, 300):

            def kernel(tau, t=t):
                share = 1 - abs(tau) / mpmath.mpf(dt)
                late = t * mpmath.mpf(dt) - tau
                return -1e6 * share * mpmath.exp(-damping * natural * late) * mpmath.sin(damped * late) / damped

            exact = float(mpmath.quad(kernel, [-dt, 0, dt]))
            assert found[at + t] == pytest.approx(exact, rel=1e-9, abs=0)


@pytest.mark.parametrize("text", ["0,0\n0.01,1\n0.03,2\n0.04,3\n", "0,0\n0.01,nan\n0.02,1\n", "0,0\n0,1\n0,2\n", "0,0\n"])
def test_record_with_a_gap(tmp_path, text):
    file = tmp_path / "record.csv"
    file.write_text(text)
    with pytest.raises(BadInput, match=r"equal time steps|equal steps|must be finite|must be two or more|must rise"):
        read_record(file, "two_columns", "g")


def test_record_with_a_trend():
    """A straight line on top of a record, a thousand times its size, goes without a trace of it."""
    random = np.random.default_rng(4)
    clean = Record(random.standard_normal(5000), 0.01, "noise")
    leaning = replace(clean, acceleration=clean.acceleration + 1e3 * (0.3 + np.linspace(-1.0, 1.0, 5000)))
    kept, freed = (without_baseline(record, "linear").acceleration for record in (clean, leaning))
    assert np.abs(kept - freed).max() < 1e-10
    assert abs(without_baseline(leaning, "mean").acceleration.mean()) < 1e-10


def test_record_of_a_million_samples():
    """A million samples of a sine: the last second is the steady answer of the transfer function."""
    dt, count, frequency, damping, shaken = 0.005, 1_000_000, 3.0, 0.02, 2.5
    time = dt * np.arange(count)
    (found,), _ = oscillators(np.sin(2.0 * pi * shaken * time), dt, [frequency], damping)
    fine, step = refined(np.sin(2.0 * pi * shaken * time[-400:]), dt, 20.0)
    assert step <= dt
    assert len(fine) == 399 * round(dt / step) + 1
    natural, turning = 2.0 * pi * frequency, 2.0 * pi * shaken
    answer = -1.0 / (natural**2 - turning**2 + 2j * damping * natural * turning)
    share = np.sinc(shaken * dt) ** 2  # what straight lines between samples leave of a sine
    exact = share * np.imag(answer * np.exp(1j * turning * time[-400:]))
    assert found[-400:] == pytest.approx(exact, rel=0, abs=2e-5 * np.abs(exact).max())


def test_frequency_that_rises_when_filled():
    """f_full > f_empty: contents cannot make a tube faster; the answer is a refusal that names both."""
    empty = float(modes(MODEL, 0.0).frequency[0])
    with pytest.raises(BadInput, match=r"full_frequency_Hz = .*below the empty tube's frequency"):
        coefficient_of_frequency(MODEL, 1.0, empty * (1.0 + 1e-9))
    with pytest.raises(BadInput, match="lower than any added mass explains"):
        coefficient_of_frequency(MODEL, 1.0, empty * 1e-3)
    assert coefficient_of_frequency(MODEL, 1.0, empty) == pytest.approx(0.0, abs=1e-9)


def test_record_without_motion():
    with pytest.raises(BadInput, match="holds no motion"):
        scaled(Record(np.zeros(100), 0.01, "calm"), 1.0)


@pytest.mark.parametrize("band", [(0.0, 5.0), (5.0, 5.0), (1.0, 50.0), (nan, 2.0)])
def test_band_beyond_the_sampling(band):
    with pytest.raises(BadInput, match=r"band_Hz.*0 < low < high < 50 Hz"):
        in_band(Record(np.ones(100), 0.01, "steps"), *band)


@pytest.mark.parametrize("cycles", [1e-7, 1e-3, 1e4, 1e8])
def test_oscillator_far_softer_and_far_stiffer_than_the_step(cycles):
    """Periods from ten million steps to a hundred-millionth of one, under a constant push: 1 - cos in high precision."""
    dt = 0.01
    natural = 2.0 * pi * cycles / dt
    (found,), _ = oscillators(np.ones(5), dt, [cycles / dt], 0.0)
    with mpmath.workdps(50):
        exact = [float(-(1 - mpmath.cos(mpmath.mpf(natural) * dt * k)) / mpmath.mpf(natural) ** 2) for k in range(5)]
    assert found == pytest.approx(exact, rel=1e-9, abs=3e-7 / natural**2 if cycles > 1 else 0.0)


def test_damping_of_nothing_and_next_to_critical():
    for damping in (0.0, 1.0 - 1e-6):
        found, velocity = oscillators(np.ones(50), 0.01, [2.0], damping)
        assert np.isfinite(found).all()
        assert np.isfinite(velocity).all()
    natural, t = 4.0 * pi, 0.01 * np.arange(50)
    critical = -(1.0 - np.exp(-natural * t) * (1.0 + natural * t)) / natural**2
    assert found[0] == pytest.approx(critical, rel=1e-4, abs=1e-9)


@pytest.mark.parametrize("slender", [200.0, 1000.0, 2000.0])
def test_mast_as_slender_as_a_wire(slender):
    """Timoshenko's tube tends to Euler's: 1.8751^2 / 2 pi sqrt(EI / rho A L^4)."""
    tube = replace(MODEL, height=slender * 0.5, fill_height=slender * 0.5)
    area, inertia = (part(radius=0.25, thickness=0.015) for part in (section_area, second_moment))
    root = float(mpmath.findroot(lambda x: mpmath.cos(x) * mpmath.cosh(x) + 1, 1.875))
    euler = root**2 / (2.0 * pi * tube.height**2) * np.sqrt(25e9 * inertia / (2350.0 * area))
    assert modes(tube, 0.0).frequency[0] == pytest.approx(euler, rel=2.0 / slender**2 + 1e-7)


@pytest.mark.parametrize("share", [1e-9, 1e-4, 1.0 - 1e-6])
def test_contents_of_next_to_no_height(share):
    """A surface all but at the base or all but at the top: the frequencies of the empty and of the full tube."""
    tube = replace(MODEL, fill_height=share * MODEL.height)
    limit = modes(MODEL, 0.0 if share < 0.5 else 0.8).frequency[:3]
    assert modes(tube, 0.8).frequency[:3] == pytest.approx(limit, rel=1e-12 if share == 1e-9 else 2e-5)


def test_wall_of_next_to_no_thickness():
    """r -> R / (2 t) as t -> 0, without losing a digit."""
    for thickness in (1e-12, 1e-6, 1e-2):
        with mpmath.workdps(40):
            p = mpmath.mpf(thickness) / 2
            exact = float((1 - p) ** 2 / (4 * p))
        assert volume_ratio(radius=1.0, thickness=thickness) == pytest.approx(exact, rel=4e-16)


def test_transfer_at_no_and_at_endless_frequency():
    """A slow shift carries the tube along; a shaking far above every mode passes it by."""
    shapes = modes(MODEL, 0.5)
    assert transfer([0.0], shapes, 0.05)[0, 0] == pytest.approx(1.0, rel=1e-12)
    fast = transfer([1e12], shapes, 0.05)[0, 0]
    rest = 1.0 - float((shapes.displacement * shapes.participation).sum())
    assert abs(fast - rest) < 1e-3
    assert inf > abs(fast)
