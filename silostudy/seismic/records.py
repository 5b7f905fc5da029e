"""Earthquake records: what one is, and the few things done to it before it shakes a model."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import butter, sosfiltfilt

from silostudy.errors import BadInput

BASELINES = ("none", "mean", "linear")


@dataclass(frozen=True)
class Record:
    """Acceleration (m s-2) at equal steps dt (s); origin says which record it is and what was done to it."""

    acceleration: np.ndarray
    dt: float
    origin: str

    @property
    def peak(self) -> float:
        """Largest sampled acceleration (m s-2)."""
        return float(np.abs(self.acceleration).max())

    @property
    def duration(self) -> float:
        """Time between the first and the last sample (s)."""
        return self.dt * (len(self.acceleration) - 1)


def without_baseline(record: Record, baseline: str) -> Record:
    """The record less its mean, or less the straight line that fits it best."""
    if baseline == "none":
        return record
    time = np.linspace(-1, 1, len(record.acceleration))
    degree = {"mean": 0, "linear": 1}[baseline]
    line = np.polynomial.Polynomial.fit(time, record.acceleration, degree)(time)
    return replace(record, acceleration=record.acceleration - line, origin=f"{record.origin}; less its {baseline} baseline")


def compressed(record: Record, factor: float) -> Record:
    """The record run `factor` times as fast: a model of scale 1/factor keeps its strains if accelerations stay."""
    return record if factor == 1 else replace(record, dt=record.dt / factor, origin=f"{record.origin}; time / {factor:g}")


def in_band(record: Record, low: float, high: float) -> Record:
    """The record between two frequencies (Hz): Butterworth of order 4 run both ways, so that phases stay."""
    nyquist = 0.5 / record.dt
    if not 0 < low < high < nyquist:
        allowed = f"must be 0 < low < high < {nyquist:g} Hz, half the record's sampling rate after time compression"
        raise BadInput("motion.band_Hz", [low, high], allowed, record.origin)
    filtered = sosfiltfilt(butter(4, [low, high], btype="bandpass", fs=1 / record.dt, output="sos"), record.acceleration)
    return replace(record, acceleration=filtered, origin=f"{record.origin}; {low:g} to {high:g} Hz")


def scaled(record: Record, peak: float) -> Record:
    """The record with its largest sample brought to `peak` (m s-2)."""
    if record.peak == 0:
        raise BadInput("record", record.origin, "holds no motion: it cannot be scaled to a peak")
    factor = peak / record.peak
    origin = f"{record.origin}; accelerations x {factor:.4g} to a peak of {peak:.4g} m/s2"
    return replace(record, acceleration=record.acceleration * factor, origin=origin)
