"""The effective mass coefficient that makes the beam answer like a measured response, and how sure it is."""

from dataclasses import dataclass, replace
from functools import cache

import numpy as np
from scipy.optimize import brentq

from silostudy.errors import BadInput
from silostudy.seismic.beam import Tube, modes
from silostudy.seismic.likeness import amplitude_error, spectrum
from silostudy.seismic.records import Record
from silostudy.seismic.response import absolute_acceleration

BAND_SHIFT = 0.2  # how far each end of the band is moved inward to see what the band does
REPLICATES = 40  # noisy copies behind the noise's share
THROUGH = 5  # candidates that an amplitude is interpolated through
PARTS = 16  # of a step between candidates: where it is interpolated
CONTRIBUTIONS = ("noise", "damping", "stiffness", "band", "step")


@dataclass(frozen=True, kw_only=True)
class Question:
    """Given of an identification: the tube, its stiffness and damping, the base motion, band and candidates."""

    tube: Tube
    stiffness_reduction: float
    damping_ratio: float
    base: Record
    band: tuple[float, float]  # Hz
    coefficients: np.ndarray
    damping_mismatch: float  # relative half-width within which the damping ratio is known
    frequency_mismatch: float  # the same of the empty tube's frequency, whose square the stiffness follows


@dataclass(frozen=True)
class Bank:
    """Fourier transforms (m s-1) of each candidate's top acceleration inside the band: (coefficient, frequency)."""

    question: Question
    first_frequency: np.ndarray  # Hz, of each candidate
    frequency: np.ndarray  # Hz, of each component
    known: np.ndarray  # with the damping as known
    lower: np.ndarray  # with the least damping that the mismatch admits
    higher: np.ndarray  # with the most
    softer: np.ndarray  # with the least stiffness that the empty frequency's mismatch admits
    stiffer: np.ndarray  # with the most


@dataclass(frozen=True)
class Estimate:
    """The coefficient by E_A, and what moves it (all dimensionless); contributions in the order of CONTRIBUTIONS."""

    coefficient: float
    contributions: np.ndarray

    @property
    def uncertainty(self) -> float:
        """Half-width U: root sum of squares of all but the step, and half a step on top (a step can always add up)."""
        return float(np.sqrt((self.contributions[:-1] ** 2).sum()) + self.contributions[-1])


def top_acceleration(question: Question, coefficient: float) -> np.ndarray:
    """Absolute acceleration (m s-2) of the top for one coefficient."""
    shapes = modes(question.tube, coefficient, question.stiffness_reduction)
    return absolute_acceleration(question.base.acceleration, question.base.dt, shapes, question.damping_ratio)[0]


def other(question: Question, damping: float = 0.0, frequency: float = 0.0) -> Question:
    """The question with damping ratio and empty frequency moved by shares (-1 ... 1) of their mismatch."""
    return replace(
        question,
        damping_ratio=question.damping_ratio * (1 + damping * question.damping_mismatch),
        stiffness_reduction=question.stiffness_reduction * (1 + frequency * question.frequency_mismatch) ** 2,
    )


def bank(question: Question) -> Bank:
    """The responses of all candidates."""
    judges = [question, other(question, -1), other(question, +1), other(question, 0, -1), other(question, 0, +1)]
    spectra, firsts = [], []
    for coefficient in question.coefficients:
        tops = [top_acceleration(judge, coefficient) for judge in judges]
        frequency, transforms = spectrum(tops, question.base.dt, question.band)
        spectra.append(transforms)
        firsts.append(modes(question.tube, coefficient, question.stiffness_reduction).frequency[0])
    return Bank(question, np.array(firsts), frequency, *np.swapaxes(np.array(spectra), 0, 1))


def transform(question: Question, measured: np.ndarray) -> np.ndarray:
    """Fourier transform (m s-1) of a measured top acceleration (m s-2) inside the question's band."""
    return spectrum(measured, question.base.dt, question.band)[1]


def least(values: np.ndarray, coefficients: np.ndarray) -> float:
    """The candidate of the least error (the first of several)."""
    return float(coefficients[np.argmin(values)])


def vertex(values: np.ndarray, coefficients: np.ndarray) -> float:
    """Place of the least error between equally spaced candidates: the indices are sums of moduli, so their valley is a V.

    The V has equal slopes through the least value and its neighbours; at either end of the candidates it is the end.
    """
    place = int(np.argmin(values))
    if place in (0, len(values) - 1):
        return float(coefficients[place])
    before, here, after = values[place - 1 : place + 2]
    slope = max(before, after) - here
    step = coefficients[place + 1] - coefficients[place]
    return float(coefficients[place] + (step * (before - after) / (2 * slope) if slope > 0 else 0.0))


def between(computed: np.ndarray, measured: np.ndarray, coefficients: np.ndarray) -> float:
    """Coefficient (1) of the least E_A between equally spaced candidates; at either end of them it is the end.

    computed, measured: transforms, of every candidate and of the response.  An amplitude changes smoothly with the
    coefficient, the index does not: so the amplitudes are interpolated, by a polynomial through the candidates around.
    """
    place = int(np.argmin(amplitude_error(computed, measured)))
    if place in (0, len(coefficients) - 1):
        return float(coefficients[place])
    count = min(THROUGH, len(coefficients))
    first = min(max(place - count // 2, 0), len(coefficients) - count)
    amplitudes = _polynomial(count, place - first) @ np.abs(computed[first : first + count])
    near = np.linspace(coefficients[place - 1], coefficients[place + 1], 2 * PARTS + 1)
    return vertex(amplitude_error(amplitudes, measured), near)


@cache
def _polynomial(count: int, place: int) -> np.ndarray:
    """Weights (1) of values at 0, 1, ... in their polynomial, at the parts from one before a place to one after it."""
    near = np.linspace(place - 1.0, place + 1.0, 2 * PARTS + 1)
    return np.vander(near, count) @ np.linalg.inv(np.vander(np.arange(float(count))))


def end_of(answer: float, coefficients: np.ndarray) -> int:
    """Sign -1 or 1 of an answer that is the lowest or the highest of the candidates, beyond which the truth may lie; else 0."""
    return int(answer >= coefficients[-1]) - int(answer <= coefficients[0])


def stated(answer: float, half_width: float, coefficients: np.ndarray) -> float:
    """The half-width (1) of an answer; infinite where it reaches an end of the candidates: nothing was tried beyond.

    A lowest candidate of 0 bounds the answer as well as a mass does.
    """
    open_below = answer - half_width <= coefficients[0] and coefficients[0] > 0
    open_above = answer + half_width >= coefficients[-1]
    return np.inf if open_below or open_above or end_of(answer, coefficients) else half_width


def estimate(bank: Bank, measured: np.ndarray, random: np.random.Generator) -> Estimate:
    """The coefficient by E_A from the transform of a measured response, with what each of CONTRIBUTIONS does to it."""
    question = bank.question
    coefficient = _by_amplitude(bank, measured, bank.known)
    contributions = [
        _noise(bank, measured, coefficient, random),
        _half_range([_by_amplitude(bank, measured, judge) for judge in (bank.known, bank.lower, bank.higher)]),
        _half_range([_by_amplitude(bank, measured, judge) for judge in (bank.known, bank.softer, bank.stiffer)]),
        _half_range([_by_amplitude(bank, measured, bank.known, inside) for inside in _bands(bank)]),
        float(np.diff(question.coefficients).max()) / 2,
    ]
    return Estimate(coefficient, np.array(contributions))


def _by_amplitude(bank: Bank, measured: np.ndarray, computed: np.ndarray, inside: slice | np.ndarray = slice(None)) -> float:
    return between(computed[:, inside], measured[inside], bank.question.coefficients)


def _noise(bank: Bank, measured: np.ndarray, coefficient: float, random: np.random.Generator) -> float:
    """Twice the spread of the answer when what the best candidate leaves unexplained is thrown anew as white noise."""
    model = bank.known[int(np.argmin(np.abs(bank.question.coefficients - coefficient)))]
    spread = np.sqrt(np.mean(np.abs(measured - model) ** 2) / 2)  # of the real and of the imaginary part
    parts = random.standard_normal((2, REPLICATES, len(model)))
    copies = model + spread * (parts[0] + 1j * parts[1])
    return 2 * float(np.std([_by_amplitude(bank, copy, bank.known) for copy in copies], ddof=1))


def _half_range(answers: list[float]) -> float:
    return (max(answers) - min(answers)) / 2


def _bands(bank: Bank) -> list[np.ndarray]:
    """The components inside the band, and with its lower, its upper and both ends moved inward."""
    low, high = bank.question.band
    lows, highs = (low, low * (1 + BAND_SHIFT)), (high, high * (1 - BAND_SHIFT))
    return [(bank.frequency >= lower) & (bank.frequency <= upper) for lower in lows for upper in highs]


def imitation(question: Question, coefficient: float, noise_ratio: float, random: np.random.Generator) -> np.ndarray:
    """A synthetic response (m s-2): the question's model with a known coefficient, and white noise of a share of its rms."""
    clean = top_acceleration(question, coefficient)
    return clean + noise_ratio * np.sqrt(np.mean(clean**2)) * random.standard_normal(len(clean))


def recovery(bank: Bank, trials: int, noise_ratio: float, random: np.random.Generator) -> np.ndarray:
    """Truth, answer and its uncertainty (1) of trials whose truth and noise are thrown anew: shape (3, trials).

    Truth evenly over the candidates, damping and empty frequency evenly within the mismatch the question admits.
    """
    question = bank.question
    recovered = np.empty((3, trials))
    for trial in range(trials):
        truth = random.uniform(question.coefficients[0], question.coefficients[-1])
        real = other(question, random.uniform(-1, 1), random.uniform(-1, 1))
        answer = estimate(bank, transform(question, imitation(real, truth, noise_ratio, random)), random)
        recovered[:, trial] = truth, answer.coefficient, answer.uncertainty
    return recovered


def coefficient_of_frequency(tube: Tube, stiffness_reduction: float, frequency: float) -> float:
    """The coefficient (1) that brings the first frequency of a tube, wholly or partly filled, to `frequency` (Hz)."""

    def miss(coefficient: float) -> float:
        return modes(tube, coefficient, stiffness_reduction).frequency[0] - frequency

    if miss(0.0) < 0:
        raise BadInput("full_frequency_Hz", frequency, "must be below the empty tube's frequency")
    high = 1.0
    while miss(high) > 0:
        high *= 2
        if high > 1e3:
            raise BadInput("full_frequency_Hz", frequency, "is lower than any added mass explains")
    return float(brentq(miss, 0.0, high, xtol=1e-10))


def emptied(tube: Tube) -> float:
    """First natural frequency (Hz) of the tube without contents and with its whole stiffness."""
    return float(modes(replace(tube, fill_height=tube.height), 0.0).frequency[0])
