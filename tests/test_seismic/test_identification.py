"""Likeness indices against the source's own formulas, and a known coefficient found again."""

from dataclasses import replace

import numpy as np
import pytest

from silostudy.errors import BadInput
from silostudy.seismic import identify
from silostudy.seismic.added_mass import coefficient_from_shift, stiffness_reduction
from silostudy.seismic.beam import modes
from silostudy.seismic.likeness import amplitude_error, phase_error, phase_error_as_printed, spectrum
from silostudy.seismic.readers import read_known
from silostudy.seismic.records import Record, compressed, scaled, without_baseline
from silostudy.tables.sasaki_1991 import printed_tests
from tests.test_seismic.test_beam import MODEL


@pytest.fixture(scope="module")
def bank():
    """Candidates 0.50 ... 1.00 by 0.01 on the assumed model under the K-NET record; damping within 25 %, 34.3 Hz as printed."""
    base = scaled(compressed(without_baseline(read_known("akt013_1996_ew"), "mean"), 8.0), 2.28)
    question = identify.Question(
        tube=MODEL,
        stiffness_reduction=stiffness_reduction(34.3, identify.emptied(MODEL)),
        damping_ratio=0.045,
        base=Record(base.acceleration[:2500], base.dt, base.origin),
        band=(5.0, 60.0),
        coefficients=np.linspace(0.5, 1.0, 51),
        damping_mismatch=0.25,
        frequency_mismatch=0.05 / 34.3,
    )
    return identify.bank(question)


def answered(bank, true, truth, noise_ratio, random) -> identify.Estimate:
    """What the bank says of an imitation made with the values of `true`."""
    return identify.estimate(bank, identify.transform(true, identify.imitation(true, truth, noise_ratio, random)), random)


@pytest.fixture
def spectra():
    random = np.random.default_rng(7)
    return [random.standard_normal(40) + 1j * random.standard_normal(40) for _ in range(2)]


def test_amplitude_error_is_the_sources(spectra):
    computed, measured = spectra
    x, other = np.abs(measured), np.abs(computed)
    printed = np.sum(np.abs((other - x) / x) * x / x.sum()) / len(x)  # equations (3) and (5), word for word
    assert amplitude_error(computed, measured) == pytest.approx(printed, rel=1e-12)
    measured[3] = 0
    assert np.isfinite(amplitude_error(computed, measured))


def test_phase_error_is_wrapped_and_does_not_mind_the_origin_of_time(spectra):
    computed, measured = spectra
    turned = np.exp(1j * 2.9 * np.arange(40))  # both histories seen from another origin of time
    assert phase_error(computed * turned, measured * turned) == pytest.approx(phase_error(computed, measured), rel=1e-9)
    before, after = (phase_error_as_printed(computed * turn, measured * turn) for turn in (1, turned))
    assert abs(after / before - 1) > 0.05  # the source's own index does mind
    assert phase_error(-measured, measured) == pytest.approx(1 / 40, rel=1e-12)  # the worst there is: pi everywhere
    assert phase_error(measured * np.exp(0.01j), measured) == pytest.approx(0.01 / np.pi / 40, rel=1e-9)


def test_printed_phase_error_is_the_sources(spectra):
    computed, measured = spectra
    phi, other, x = np.angle(measured), np.angle(computed), np.abs(measured)
    printed = np.sum(np.abs((other - phi) / phi) * x / x.sum()) / len(x)
    assert phase_error_as_printed(computed, measured) == pytest.approx(printed, rel=1e-12)


def test_spectrum_keeps_to_its_band():
    frequency, values = spectrum(np.ones((3, 200)), 0.01, (5.0, 20.0))
    assert (frequency[0], frequency[-1]) == (5.0, 20.0)
    assert values.shape == (3, 31)


def test_inner_consistency_of_the_source():
    """With equal stiffness the earthquake rows imply 2.62 and 2.65 wall masses, with which 33 -> 19 Hz means 0.765."""
    tests = printed_tests()
    ratios = [tests[name].implied_mass_ratio for name in ("earthquake_010g", "earthquake_023g")]
    assert ratios == pytest.approx([2.615, 2.655], abs=6e-4)
    found = coefficient_from_shift(33.0, 19.0, mass_ratio=float(np.mean(ratios)))
    assert found == pytest.approx(0.765, abs=5e-4)
    assert found > tests["sine"].effective_mass_coefficient + 0.05
    lowest, highest = (coefficient_from_shift(33 - e, 19 + e, mass_ratio=float(np.mean(ratios))) for e in (0.5, -0.5))
    assert lowest < tests["sine"].effective_mass_coefficient < highest


def test_assumed_model_reproduces_the_printed_frequencies_and_stiffness_reductions():
    whole = identify.emptied(MODEL)
    for name, test in printed_tests().items():
        alpha = stiffness_reduction(test.empty_frequency, whole)
        assert alpha == pytest.approx(test.stiffness_reduction, rel=0.006), name
        if name != "sine":
            full = modes(MODEL, test.effective_mass_coefficient, alpha).frequency[0]
            assert full == pytest.approx(test.full_frequency, rel=0.003), name


@pytest.mark.parametrize("filled", [1.0, 0.7])
def test_coefficient_of_a_frequency(filled):
    tube = replace(MODEL, fill_height=filled * MODEL.height)
    frequency = modes(tube, 0.63, 0.026).frequency[0]
    assert identify.coefficient_of_frequency(tube, 0.026, frequency) == pytest.approx(0.63, rel=1e-8)


def test_frequency_that_no_mass_explains():
    empty = modes(MODEL, 0.0, 0.026).frequency[0]
    with pytest.raises(BadInput, match="must be below the empty tube's"):
        identify.coefficient_of_frequency(MODEL, 0.026, empty * 1.01)
    with pytest.raises(BadInput, match="lower than any added mass"):
        identify.coefficient_of_frequency(MODEL, 0.026, empty / 1000)


@pytest.mark.long
def test_both_indices_find_a_clean_truth_at_once(bank):
    coefficients = bank.question.coefficients
    for truth in (0.6, 0.8):
        measured = identify.top_acceleration(bank.question, truth)
        wanted = identify.transform(bank.question, measured)
        amplitude, phase = amplitude_error(bank.known, wanted), phase_error(bank.known, wanted)
        assert identify.least(amplitude, coefficients) == pytest.approx(truth)
        assert identify.least(phase, coefficients) == pytest.approx(truth)
        assert amplitude.min() < 1e-9 < amplitude[-1]


def test_vertex_of_a_v():
    grid = np.linspace(0.5, 1.0, 11)
    assert identify.vertex(np.abs(grid - 0.713), grid) == pytest.approx(0.713, rel=1e-9)
    assert identify.vertex(2 + 3 * np.abs(grid - 0.5), grid) == 0.5
    assert identify.vertex(np.ones(11), grid) == 0.5


def test_amplitudes_between_candidates_find_a_coefficient_that_the_v_alone_misses():
    """Two bins whose amplitudes bend with the coefficient, as around a resonance, by a polynomial of degree 4."""
    grid = np.linspace(0.5, 1.0, 6)

    def amplitudes(coefficient):
        x = np.asarray(coefficient)[..., None] - 0.7
        return 2.0 + np.array([3.0, -4.0]) * x + np.array([9.0, 14.0]) * x**2 + np.array([20.0, -10.0]) * x**4

    for truth in (0.63, 0.74, 0.86):
        wanted = amplitudes(truth)
        answer = identify.between(amplitudes(grid), wanted, grid)
        v_alone = identify.vertex(amplitude_error(amplitudes(grid), wanted), grid)
        assert abs(answer - truth) < 0.1 * abs(v_alone - truth)
        assert abs(v_alone - truth) > 1e-3
    for end in (0.5, 1.0):
        assert identify.between(amplitudes(grid), amplitudes(end), grid) == end
    three = identify.between(amplitudes(grid[:3]), amplitudes(0.61), grid[:3])
    assert three == pytest.approx(0.61, abs=1e-2)


def test_an_interval_that_reaches_an_end_of_the_candidates_is_open():
    grid = np.linspace(0.5, 1.0, 11)
    assert [identify.end_of(answer, grid) for answer in (0.5, 0.51, 0.99, 1.0)] == [-1, 0, 0, 1]
    assert identify.stated(0.7, 0.1, grid) == 0.1
    for answer, half_width in ((0.5, 0.0), (0.52, 0.03), (0.98, 0.03), (1.0, 0.0)):
        assert identify.stated(answer, half_width, grid) == np.inf
    assert identify.stated(0.02, 0.03, grid - 0.5) == 0.03  # no mass is less than none
    assert identify.stated(0.0, 0.03, grid - 0.5) == np.inf  # but a truth of none is an end all the same


def test_truth_lies_within_the_stated_uncertainty_in_95_of_100_trials(bank):
    truth, found, half_width = identify.recovery(bank, 100, 0.2, np.random.default_rng(11))
    assert np.sum(np.abs(found - truth) <= half_width) >= 95
    assert half_width.max() < 0.03  # and the uncertainty is not bought by stating too much
    assert np.std(truth) > 0.1
    assert np.corrcoef(truth, found)[0, 1] > 0.999


def test_the_recovery_test_can_fail(bank):
    """A judge whose stiffness is 5 % off states the same uncertainty and misses."""
    random = np.random.default_rng(12)
    wrong = replace(bank.question, stiffness_reduction=1.05 * bank.question.stiffness_reduction)
    misses = 0
    for truth in (0.6, 0.7, 0.8):
        answer = answered(bank, wrong, truth, 0.2, random)
        misses += abs(answer.coefficient - truth) > answer.uncertainty
    assert misses == 3


def test_contributions_answer_to_their_causes(bank):
    random = np.random.default_rng(13)
    question = bank.question
    quiet, loud = (answered(bank, question, 0.7, ratio, random).contributions for ratio in (0.05, 1.0))
    assert loud[0] > 3 * quiet[0]
    assert quiet[4] == pytest.approx(0.005)
    certain = replace(question, damping_mismatch=0.0)
    same = replace(bank, question=certain, lower=bank.known, higher=bank.known)
    assert answered(same, question, 0.7, 0.05, random).contributions[1] == 0


@pytest.mark.long
@pytest.mark.parametrize("rounding", [0.05, 0.5])
def test_scatter_of_the_empty_frequency_is_in_the_uncertainty(bank, rounding):
    """By hand from the shift at a fixed full frequency: C_eff = ((f_e/f_f)^2 - 1)/ratio moves by 2 (f_e/f_f)^2 df_e/f_e/ratio.

    The response decides by its whole shape and not by one frequency: within a fifth of that.
    """
    known = replace(bank.question, frequency_mismatch=rounding / 34.3)
    truth = 0.7
    measured = identify.transform(known, identify.top_acceleration(known, truth))
    found = identify.estimate(identify.bank(known), measured, np.random.default_rng(1)).contributions[2]
    full = modes(MODEL, truth, known.stiffness_reduction).frequency[0]
    ratio = ((34.3 / full) ** 2 - 1) / truth
    assert found == pytest.approx(2 * (34.3 / full) ** 2 * rounding / 34.3 / ratio, rel=0.2)


@pytest.mark.long
def test_recovery_with_a_badly_known_empty_frequency(bank):
    """Half a hertz of scatter: stated, the truth comes back; a judge who takes the frequency for exact misses most trials."""
    unsure = replace(bank.question, frequency_mismatch=0.5 / 34.3)
    truth, found, half_width = identify.recovery(identify.bank(unsure), 100, 0.2, np.random.default_rng(14))
    assert np.sum(np.abs(found - truth) <= half_width) >= 95
    assert np.sum(np.abs(found - truth) <= 0.01) < 60
