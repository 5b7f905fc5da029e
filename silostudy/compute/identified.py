"""Variables that a measured response adds to a seismic cube: histories, indices, the estimated coefficient, recovery test."""

from dataclasses import replace

import numpy as np

from silostudy.config.seismic import Identification
from silostudy.scene.seismic import Shaken
from silostudy.seismic import identify
from silostudy.seismic.likeness import amplitude_error, phase_error, phase_error_as_printed, spectrum

IDENTIFICATIONS = ("amplitude_error", "amplitude_error_coarse", "phase_error", "phase_error_coarse")


def identified(asked: Identification, scene: Shaken, stiffness_reduction: float, random: np.random.Generator) -> dict:
    """Everything of one case that follows from its measured response, by the names of the contract."""
    assert scene.empty_frequency is not None  # the configuration asks for it
    question = identify.Question(
        tube=scene.tube,
        stiffness_reduction=stiffness_reduction,
        damping_ratio=scene.damping_ratio,
        base=scene.base,
        band=asked.band_Hz,
        coefficients=np.array(asked.fine_coefficients),
        damping_mismatch=asked.damping_mismatch,
        frequency_mismatch=asked.empty_frequency_rounding_Hz / scene.empty_frequency,
    )
    assert asked.refinement is not None, "identification.refinement is not chosen yet"
    bank, measured = identify.bank(question), _measured(scene, question)
    return {
        "measured_origin": _origin(scene),
        **_histories(asked, question, measured),
        **_answers(bank, measured, asked.refinement, random),
        **_recovered(asked, bank, random),
    }


def labels(asked: Identification) -> dict[str, list]:
    """Coordinates of the axes that an identification adds."""
    return {
        "coefficient": asked.fine_coefficients,
        "shown_coefficient": list(asked.shown_coefficients),
        "identification": list(IDENTIFICATIONS),
        "contribution": list(identify.CONTRIBUTIONS),
    }


def _origin(scene: Shaken) -> str:
    """Origin of the measured response."""
    true = scene.imitation
    if true is None:
        return scene.measured.origin if scene.measured else ""
    said = f"synthetic: model with C_eff = {true.effective_mass_coefficient:g} and damping ratio {true.damping_ratio:g}, "
    return said + f"and white noise of {true.noise_ratio:.0%} of its rms"


def _measured(scene: Shaken, question: identify.Question) -> np.ndarray:
    """The measured top acceleration (m s-2), from the user's file or imitated."""
    if scene.measured:
        return scene.measured.acceleration
    true = scene.imitation
    assert true is not None  # the configuration asks for one of the two
    real = replace(question, damping_ratio=true.damping_ratio)
    return identify.imitation(real, true.effective_mass_coefficient, true.noise_ratio, np.random.default_rng(true.seed))


def _histories(asked: Identification, question: identify.Question, measured: np.ndarray) -> dict:
    """Histories of the top, and their Fourier amplitudes in the stated band."""
    tops = np.array([identify.top_acceleration(question, coefficient) for coefficient in asked.shown_coefficients])
    frequency, transform = spectrum(np.vstack([measured, tops]), question.base.dt, question.band)
    return {
        "measured_acceleration": measured,
        "top_acceleration": tops,
        "spectrum_frequency": frequency,
        "measured_spectrum": np.abs(transform[0]),
        "top_spectrum": np.abs(transform[1:]),
    }


def _answers(bank: identify.Bank, measured: np.ndarray, refinement: int, random: np.random.Generator) -> dict:
    """Indices over the coefficients, the coefficients of least error at fine and coarse step, and how sure they are."""
    question = bank.question
    wanted = identify.transform(question, measured)
    amplitude, phase = amplitude_error(bank.known, wanted), phase_error(bank.known, wanted)
    fine, coarse = question.coefficients, question.coefficients[::refinement]
    answers = [
        *(identify.between(bank.known, wanted, fine), identify.least(amplitude[::refinement], coarse)),
        *(identify.vertex(phase, fine), identify.least(phase[::refinement], coarse)),
    ]
    estimate = identify.estimate(bank, wanted, random)
    wider = estimate.uncertainty + (refinement - 1) * estimate.contributions[-1]
    return {
        "candidate_frequency": bank.first_frequency,
        "amplitude_error": amplitude,
        "phase_error": phase,
        "phase_error_as_printed": phase_error_as_printed(bank.known, wanted),
        "effective_mass_coefficient": np.array(answers),
        "candidate_end": np.array([identify.end_of(coefficient, fine) for coefficient in answers]),
        "uncertainty": identify.stated(answers[0], estimate.uncertainty, fine),
        "coarse_uncertainty": identify.stated(answers[1], wider, fine),
        "uncertainty_contribution": estimate.contributions,
    }


def _recovered(asked: Identification, bank: identify.Bank, random: np.random.Generator) -> dict:
    truth, answer, half_width = identify.recovery(bank, asked.recovery_trials, asked.recovery_noise_ratio, random)
    return {
        "recovery_truth": truth,
        "recovery_answer": answer,
        "recovery_uncertainty": half_width,
        "recovery_coverage": np.mean(np.abs(answer - truth) <= half_width),
    }
