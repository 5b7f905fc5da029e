"""The rules themselves: twins in plain floats, continuity, limits, masks, bad input."""

import math

import numpy as np
import pytest

from silostudy.buckling import BUCKLING, en1993_1_6_2007, en1993_1_6_2025, en1993_4_1, miller1977, nasa_sp8007
from silostudy.buckling.family import MODES, POSITIVE, REASONS, evaluate
from silostudy.buckling.miller1977_rivals import inelastic_ratio_14b
from silostudy.errors import BadInput
from tests.test_buckling.shells import shell


def strength(rule: str, **changes) -> np.ndarray:
    return evaluate(BUCKLING[rule], shell(**changes))["buckling_stress"]


def reason(rule: str, **changes) -> str:
    return REASONS[int(evaluate(BUCKLING[rule], shell(**changes))["buckling_stress_scope"])]


def mode(rule: str, **changes) -> str:
    return MODES[int(evaluate(BUCKLING[rule], shell(**changes))["buckling_mode"])]


def plain_2025(slender: float, quality: float, yield_stress: float, pressure: float | None = None) -> float:
    """EN 1993-1-6:2025 of a medium-long shell in plain floats, with EN 1993-4-1's helpful pressure on request."""
    critical, delta = 0.605 * 210e9 / slender, math.sqrt(slender) / quality
    alpha = 0.83 / (1 + 2.2 * delta**0.75)
    lam = math.sqrt(yield_stress / critical)
    if pressure is not None:
        p, s = pressure * slender / critical, slender / 400
        helped = alpha + (1 - alpha) * p / (p + 0.3 / math.sqrt(alpha))
        foot = (1 - (p / lam**2) ** 2) * (1 - 1 / (1.12 + s**1.5)) * (s * s + 1.21 * lam**2) / (s * (s + 1))
        alpha = min(helped, foot)
    beta = 1 - 0.75 / (1 + 1.1 * delta)
    limit = math.sqrt(alpha / (1 - beta))
    if lam >= limit:
        return alpha / lam**2 * yield_stress
    if lam <= 0.1:
        return (1.1 - lam / 0.1 * 0.1) * yield_stress
    share = (lam - 0.1) / (limit - 0.1)
    start, stop = 1.35 - 0.10 * delta, 1 / (0.45 + 0.72 * delta)
    return (1 - beta * share ** (start + (stop - start) * share)) * yield_stress


def plain_2007(slender: float, quality: float, yield_stress: float) -> float:
    critical, delta = 0.605 * 210e9 / slender, math.sqrt(slender) / quality
    alpha, lam = 0.62 / (1 + 1.91 * delta**1.44), math.sqrt(yield_stress / critical)
    limit = math.sqrt(alpha / 0.4)
    if lam <= 0.2:
        return yield_stress
    return (alpha / lam**2 if lam >= limit else 1 - 0.6 * (lam - 0.2) / (limit - 0.2)) * yield_stress


SLENDER = np.geomspace(25, 3000, 40)


@pytest.mark.parametrize("quality", [40.0, 25.0, 16.0])
def test_european_rules_against_plain_floats(quality):
    size = {"shell_radius": SLENDER, "thickness": 1.0, "bay_length": 5 * np.sqrt(SLENDER), "fabrication_quality": quality}
    for rule, plain in (("en1993_1_6_2007", plain_2007), ("en1993_1_6_2025", plain_2025)):
        expected = [plain(s, quality, 235e6) for s in SLENDER]
        np.testing.assert_allclose(strength(rule, **size), expected, rtol=1e-12)
    pressed = {"lower_internal_pressure": 20e3, "upper_internal_pressure": 20e3}
    expected = [plain_2025(s, quality, 235e6, 20e3) for s in SLENDER]
    np.testing.assert_allclose(strength("en1993_4_1_2025", **size, **pressed), expected, rtol=1e-12)


def test_nasa_and_miller_by_hand():
    """R/t = 400: gamma = 1 - 0.901 (1 - exp(-1.25)) = 0.35714; Miller's C = 0.919 - 0.286 * 2.60206 = 0.174811."""
    assert nasa_sp8007.correlation_factor(400.0) == pytest.approx(1 - 0.901 * (1 - math.exp(-1.25)), rel=1e-12)
    found = strength("miller1977", shell_radius=4.0, bay_length=10.0)
    assert found == pytest.approx((0.919 - 0.286 * math.log10(400)) * 210e9 / 400, rel=1e-12)


@pytest.mark.parametrize("rule", BUCKLING)
def test_strength_has_no_jumps(rule):
    """Over R/t and over length the strength moves in small steps where the argument does (NASA and EN by their cap too)."""
    slender = np.geomspace(50, 1400, 4000)
    over_slender = strength(rule, thickness=5.0 / slender)
    over_length = strength(rule, bay_length=np.geomspace(0.1, 100, 4000))
    for values in (over_slender, over_length * np.ones(4000)):
        steps = np.abs(np.diff(np.log(values)))
        assert steps.max() < (0.01 if rule.startswith(("miller", "classical", "nasa")) else 0.02)


@pytest.mark.parametrize("edition", [en1993_1_6_2007, en1993_1_6_2025])
@pytest.mark.parametrize("delta", [0.3, 1.0, 2.5])
def test_capacity_meets_at_its_limits(edition, delta):
    alpha = edition.imperfection_factor(delta)
    beta = en1993_1_6_2007.PLASTIC_RANGE if edition is en1993_1_6_2007 else edition.plastic_range(delta)
    for limit in (edition.SQUASH_LIMIT, np.sqrt(alpha / (1 - beta))):
        below, above = (edition.capacity(np.array(limit * (1 + shift)), alpha, delta) for shift in (-1e-9, 1e-9))
        assert below == pytest.approx(above, rel=1e-6)
    assert edition.capacity(np.array(limit), alpha, delta) == pytest.approx(1 - beta, rel=1e-9)


def test_miller_meets_at_his_limits():
    for limit in (0.55, 1.6, 6.2):
        below, above = miller1977.inelastic_ratio(np.array([limit * (1 - 1e-9), limit * (1 + 1e-9)]))
        assert below == pytest.approx(above, rel=2e-3)
    x = np.linspace(0.3, 7, 200)
    np.testing.assert_allclose(inelastic_ratio_14b(x), miller1977.inelastic_ratio(x), rtol=0.05)
    eta = inelastic_ratio_14b(x) / x
    inside = (x > 0.56) & (x < 6)
    np.testing.assert_allclose(eta[inside], 1 - 1.25 * np.sqrt(inelastic_ratio_14b(x)[inside] - 0.55), rtol=1e-9)


def test_rings_lift_general_buckling_to_the_bays():
    """Larger rings help until the bay between them buckles first."""
    found = evaluate(BUCKLING["miller1977"], shell(bay_length=0.5, ring_area=np.linspace(0.06, 0.4, 50) * 0.5 * 0.01))
    assert np.all(np.diff(found["buckling_stress"]) >= 0)
    assert {MODES[m] for m in found["buckling_mode"]} == {"general_elastic", "local_inelastic", "general_inelastic"} or (
        MODES[found["buckling_mode"][0]].startswith("general") and MODES[found["buckling_mode"][-1]].startswith("local")
    )


@pytest.mark.parametrize("rule", ["en1993_4_1_2007", "en1993_4_1_2025"])
def test_pressure_first_helps_then_hurts(rule):
    pressure = np.linspace(0, 4.6e5, 400)  # hoop stress up to 98 % of yield
    found = strength(rule, lower_internal_pressure=pressure, upper_internal_pressure=pressure)
    peak = int(found.argmax())
    assert 5 < peak < 395
    assert np.all(np.diff(found[: peak + 1]) > 0)
    assert np.all(np.diff(found[peak:]) < 0)
    assert mode(rule, upper_internal_pressure=4.5e5) == "elephants_foot"


def test_smallest_pressure_helps_and_largest_harms():
    rule = "en1993_4_1_2007"
    base = strength(rule, lower_internal_pressure=5e4, upper_internal_pressure=5e4)
    assert strength(rule, lower_internal_pressure=2e4, upper_internal_pressure=5e4) < base
    assert strength(rule, lower_internal_pressure=5e4, upper_internal_pressure=4e5) < base
    assert en1993_4_1.pressurised_elastic_factor(0.3, 0.0) == 0.3
    assert en1993_4_1.pressurised_elastic_factor(0.3, 1e9) == pytest.approx(1.0)


def test_without_pressure_the_helpful_factor_is_that_of_1_6():
    for year in ("2007", "2025"):
        assert strength(f"en1993_4_1_{year}") == pytest.approx(strength(f"en1993_1_6_{year}"), rel=1e-12)


@pytest.mark.parametrize("rule", BUCKLING)
def test_any_axes(rule):
    """A cube in one call gives what single calls give, and each value its own mask."""
    slender = np.array([60.0, 500.0, 2000.0])[:, None, None]
    quality, pressure = np.array([16.0, 40.0])[None, :, None], np.array([0.0, 1e4, -1.0, 3e5])
    cube = shell(
        thickness=5.0 / slender, fabrication_quality=quality, lower_internal_pressure=pressure, upper_internal_pressure=pressure
    )
    found = evaluate(BUCKLING[rule], cube)
    for place in np.ndindex(3, 2, 4):
        one = {name: np.broadcast_to(value, (3, 2, 4))[place] for name, value in cube.items()}
        for name, value in evaluate(BUCKLING[rule], one).items():
            np.testing.assert_array_equal(found[name][place], value)


def test_masks_say_why():
    assert reason("miller1977", thickness=5.0 / 2328, fabricated=False) == "in_scope"
    assert reason("miller1977", thickness=5.0 / 2340, fabricated=False) == "radius_over_thickness_out_of_range"
    assert reason("miller1977", thickness=5.0 / 2340) == "in_scope"
    assert reason("nasa_sp8007", thickness=5.0 / 1500) == "radius_over_thickness_out_of_range"
    assert reason("nasa_sp8007", ring_area=1e-3) == "rings_not_covered"
    assert reason("miller1977", ring_area=0.05 * 4.0 * 0.01) == "rings_too_small_to_count"
    assert reason("miller1977", ring_area=0.06 * 4.0 * 0.01) == "in_scope"
    assert reason("en1993_4_1_2025", upper_internal_pressure=4.8e5) == "hoop_stress_at_yield"
    for rule in BUCKLING:
        assert reason(rule, lower_internal_pressure=-1.0) == "suction_not_covered"
        assert np.isnan(strength(rule, lower_internal_pressure=-1.0))


@pytest.mark.parametrize("name", POSITIVE)
def test_what_no_shell_can_have_is_an_error(name):
    for value in (0.0, -1.0, math.nan):
        with pytest.raises(BadInput, match=f"{name} = .*must be above 0"):
            evaluate(BUCKLING["miller1977"], shell(**{name: value}))


def test_negative_rings_and_crossed_pressures_are_errors():
    with pytest.raises(BadInput, match=r"ring_area = -1\.0: must not be negative"):
        evaluate(BUCKLING["miller1977"], shell(ring_area=-1.0))
    with pytest.raises(BadInput, match="lower_internal_pressure"):
        evaluate(BUCKLING["miller1977"], shell(lower_internal_pressure=2.0, upper_internal_pressure=1.0))


@pytest.mark.parametrize("rule", BUCKLING)
def test_extremes_stay_finite_or_masked(rule):
    """R/t from 10 to a million, bays from a hair to a kilometre: no infinity, no negative strength, at most 1.1 yield."""
    slender = np.geomspace(10, 1e6, 60)[:, None]
    found = strength(rule, thickness=5.0 / slender, bay_length=np.geomspace(1e-3, 1e3, 30))
    known = found[np.isfinite(found)]
    assert known.size
    assert np.all(known > 0)
    assert known.max() <= 1.1 * 235e6
    assert not np.isinf(found).any()
