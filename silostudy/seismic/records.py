"""Earthquake records: what one is, and the few things done to it before it shakes a model."""

from dataclasses import dataclass, replace

import numpy as np
from scipy.signal import butter, sosfiltfilt

from silostudy.errors import BadInput

BASELINES = ("none", "mean", "linear")
NOTHING = 1e-10  # share of a record's peak below which what is left of it is rounding
STEPS = (1e-7, 1e3)  # s: beyond, no record
LIMIT = 1e6  # m s-2: beyond, no acceleration
# above, a record is likely to be in other units than said
LIKELY_STEP = 0.1  # s
LIKELY_PEAK = 100.0  # m s-2


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


def plausible(record: Record, where: str) -> Record:
    """The record, whose origin tells where its numbers are unlikely; BadInput where they can be no shaking."""
    samples, (least, most) = record.acceleration, STEPS
    if len(samples) < 2 or not np.isfinite(samples).all():
        raise BadInput("record", where, "must hold two finite accelerations at least, and no other")
    if not least <= record.dt <= most:
        raise BadInput("step", record.dt, f"must be {least:g} to {most:g} s", where)
    if record.peak > LIMIT:
        raise BadInput("acceleration", record.peak, f"must be at most {LIMIT:g} m/s2", where)
    if np.ptp(samples) <= NOTHING * record.peak:
        raise BadInput("record", where, f"holds no motion: all its accelerations are {samples[0]:g} m/s2")
    unlikely = [f"steps of {record.dt:g} s"] if record.dt > LIKELY_STEP else []
    unlikely += [f"a peak of {record.peak:.4g} m/s2"] if record.peak > LIKELY_PEAK else []
    return replace(record, origin=f"{record.origin} (unlikely: {' and '.join(unlikely)})") if unlikely else record


def without_baseline(record: Record, baseline: str) -> Record:
    """The record less its mean, or less the straight line that fits it best; BadInput where that leaves nothing."""
    if baseline == "none":
        return record
    time = np.linspace(-1, 1, len(record.acceleration))
    degree = {"mean": 0, "linear": 1}[baseline]
    line = np.polynomial.Polynomial.fit(time, record.acceleration, degree)(time)
    left = replace(record, acceleration=record.acceleration - line, origin=f"{record.origin}; less its {baseline} baseline")
    return _moving(left, record)


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
    return _moving(replace(record, acceleration=filtered, origin=f"{record.origin}; {low:g} to {high:g} Hz"), record)


def scaled(record: Record, peak: float) -> Record:
    """The record with its largest sample brought to `peak` (m s-2)."""
    if record.peak == 0:
        raise BadInput("record", record.origin, "holds no motion: it cannot be scaled to a peak")
    factor = peak / record.peak
    origin = f"{record.origin}; accelerations x {factor:.4g} to a peak of {peak:.4g} m/s2"
    return replace(record, acceleration=record.acceleration * factor, origin=origin)


def _moving(record: Record, before: Record) -> Record:
    """The record; BadInput where nothing is left of the one before but rounding."""
    if record.peak <= NOTHING * before.peak:
        raise BadInput("record", record.origin, "holds no motion any more")
    return record
