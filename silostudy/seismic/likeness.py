"""Likeness of two responses: weighted relative errors of Fourier amplitudes and phases, in a stated band."""

import numpy as np

from silostudy.seismic.family import MassRule


def spectrum(acceleration, dt: float, band: tuple[float, float]) -> tuple[np.ndarray, np.ndarray]:
    """Frequency (Hz) and Fourier transform (m s-1, complex) of histories along the last axis, inside a band (Hz)."""
    frequency = np.fft.rfftfreq(np.shape(acceleration)[-1], dt)
    inside = (frequency >= band[0]) & (frequency <= band[1])
    return frequency[inside], np.fft.rfft(acceleration, axis=-1)[..., inside] * dt


def amplitude_error(computed, measured):
    """Amplitude error E_A (1): mean relative error of Fourier amplitudes along the last axis, weighted with the measured ones.

    Source: sasaki_yoshimura_effective_mass, equations (3) and (5); the weight cancels the quotient, so that a measured
    amplitude of 0 does no harm.
    """
    wanted = np.abs(measured)
    return np.abs(np.abs(computed) - wanted).sum(axis=-1) / (wanted.shape[-1] * wanted.sum(axis=-1))


def phase_error(computed, measured):
    """Phase error E_P (1): mean wrapped phase difference over pi along the last axis, weighted with the measured amplitudes.

    Source: sasaki_yoshimura_effective_mass, equations (4) and (5), but for the divisor: the source divides by the
    measured phase, which depends on where time begins.  The difference is wrapped to at most pi.
    """
    weight = np.abs(measured)
    difference = np.abs(np.angle(computed * np.conj(measured)))
    return (difference * weight).sum(axis=-1) / (np.pi * weight.shape[-1] * weight.sum(axis=-1))


def phase_error_as_printed(computed, measured):
    """Phase error E_P (1) with the source's own divisor, the measured phase; it changes when the origin of time is moved.

    Source: sasaki_yoshimura_effective_mass, equations (4) and (5), phases between -pi and pi.
    """
    phase, weight = np.angle(measured), np.abs(measured)
    known = (phase != 0) & (weight > 0)
    relative = np.where(known, np.abs(np.angle(computed) - phase) / np.where(known, np.abs(phase), 1), 0)
    return (relative * weight).sum(axis=-1) / (weight.shape[-1] * weight.sum(axis=-1))


ROWS = (
    MassRule(
        key="amplitude_error",
        rank=20,
        title="Least error of Fourier amplitudes, E_A",
        source="sasaki_yoshimura_effective_mass",
        locator="equations (3) and (5)",
        function=amplitude_error,
        formula="E_A = sum |X' - X| / (n sum X): measured X, computed X', n bins of the band",
        needs=("measured top acceleration (m s-2)", "base acceleration (m s-2)", "damping ratio (1)", "band (Hz)"),
        validity="while contents and wall move as one; the deciding index here; an answer at an end of "
        "the candidates is flagged, its interval open",
    ),
    MassRule(
        key="phase_error",
        rank=30,
        title="Least error of wrapped Fourier phases, E_P",
        source="sasaki_yoshimura_effective_mass",
        locator="equations (4) and (5), without their division by the phase",
        function=phase_error,
        formula="E_P = sum |wrap(Phi' - Phi)| X / (pi n sum X)",
        needs=("measured top acceleration (m s-2)", "base acceleration (m s-2)", "damping ratio (1)", "band (Hz)"),
        validity="a second opinion: a disagreement with E_A is reported, not resolved; an answer at an end "
        "of the candidates is flagged",
    ),
)
