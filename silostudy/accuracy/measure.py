"""Measures a problem: error and CPU time of every rung of its ladders, in turn, so that a busy machine hurts all alike."""

import os
import platform
import time
from collections.abc import Callable, Iterable
from dataclasses import dataclass
from importlib import import_module
from importlib.metadata import version
from pathlib import Path

import numpy as np
from scipy.stats import t as student
from threadpoolctl import threadpool_limits

from silostudy.tables.problems import PROBLEMS, ProblemRow

LEAST = 1e-2  # s of CPU time that a reading lasts at least: quicker runs are repeated within it
CONFIDENCE = 0.95


@dataclass(frozen=True)
class Rung:
    """One setting of one ladder: relative error of each quantity with its interval, and CPU seconds of every reading."""

    problem: str
    ladder: str
    setting: float
    error: dict[str, float]
    low: dict[str, float]  # ends of the confidence interval; equal to the error where nothing is random
    high: dict[str, float]
    floor: dict[str, float]  # half-width of the interval over the reference: what the ensemble's size allows to see
    seconds: tuple[float, ...]

    @property
    def cost(self) -> float:
        """Median CPU time (s)."""
        return float(np.median(self.seconds))


def machine() -> dict[str, str]:
    """Machine that the costs were measured on."""
    lines = Path("/proc/cpuinfo").read_text().splitlines() if Path("/proc/cpuinfo").exists() else []
    names = [line.split(":", 1)[1].strip() for line in lines if line.startswith("model name")]
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "scipy", "numba"))
    return {
        "machine": f"{names[0] if names else platform.processor() or platform.machine()}, {os.cpu_count()} cores",
        "measured_with": f"Python {platform.python_version()}, {packages}",
        "measured_on": time.strftime("%Y-%m-%d"),
    }


@threadpool_limits.wrap(limits=1)  # threads of the linear algebra that wait for each other spend CPU time
def measure(
    key: str,
    *,
    repeats: int,
    members: int,
    rungs: int | None = None,
    ladders: int | None = None,
    tell: Callable[[str], None] = lambda text: None,
) -> list[Rung]:
    """Every rung of a problem (the coarsest `rungs` of the first `ladders` only, where given).

    repeats: readings of the cost of each rung; members: of each ensemble.
    """
    row, module = PROBLEMS[key], import_module(f"silostudy.accuracy.problems.{key}")
    extra = (members,) if row.compare == "means" else ()
    chosen = [(name, setting) for name in list(module.LADDERS)[:ladders] for setting in module.LADDERS[name][:rungs]]
    runs = {rung: module.prepare(*rung, *extra) for rung in chosen}
    for name in {name: None for name, _ in chosen}:  # kernels are compiled before anything is timed
        next(run for (ladder, _), run in runs.items() if ladder == name)()
    expected = module.reference(*extra)
    tell(f"{key}: reference found")
    seconds: dict[tuple, list[float]] = {rung: [] for rung in runs}
    values = {}
    for turn in range(repeats):
        for rung, run in runs.items():
            spent, values[rung] = _timed(run)
            seconds[rung].append(spent / getattr(module, "RUNS", 1))
        tell(f"{key}: turn {turn + 1} of {repeats}, {sum(map(np.sum, seconds.values())):.1f} s of CPU time")
    return [_rung(row, rung, values[rung], expected, seconds[rung]) for rung in runs]


def _timed(run: Callable) -> tuple[float, dict]:
    """CPU seconds of one run, averaged over as many as make a reading, and what it gave."""
    calls, start = 0, time.process_time()
    while True:
        values = run()
        calls += 1
        spent = time.process_time() - start
        if spent >= LEAST:
            return spent / calls, values


def _rung(row: ProblemRow, rung: tuple[str, float], values: dict, expected: dict, seconds: Iterable[float]) -> Rung:
    compared = {name: COMPARE[row.compare](np.asarray(values[name]), np.asarray(expected[name])) for name in row.quantities}
    error, low, high, floor = ({name: ends[k] for name, ends in compared.items()} for k in range(4))
    return Rung(row.key, *rung, error=error, low=low, high=high, floor=floor, seconds=tuple(seconds))


def _over_largest(value: np.ndarray, expected: np.ndarray) -> tuple[float, float, float, float]:
    """Largest error over the largest reference value; no interval."""
    error = float(np.abs(value - expected).max() / np.abs(expected).max()) if np.isfinite(value).all() else np.nan
    return error, error, error, 0.0


def _over_each(value: np.ndarray, expected: np.ndarray) -> tuple[float, float, float, float]:
    """Largest error over its own reference value; no interval."""
    error = float(np.abs(value / expected - 1.0).max()) if np.isfinite(value).all() else np.nan
    return error, error, error, 0.0


def _means_apart(value: np.ndarray, expected: np.ndarray) -> tuple[float, float, float, float]:
    """Distance of two means over the reference's, its confidence interval (Welch), and the interval's half-width."""
    if not np.isfinite(value).all():
        return np.nan, np.nan, np.nan, np.nan
    parts = [values.var(ddof=1) / values.size for values in (value, expected)]
    freedom = sum(parts) ** 2 / sum(part**2 / (values.size - 1) for part, values in zip(parts, (value, expected), strict=True))
    half = float(student.ppf(0.5 + CONFIDENCE / 2, freedom) * np.sqrt(sum(parts)) / abs(expected.mean()))
    error = float(abs(value.mean() - expected.mean()) / abs(expected.mean()))
    return error, max(0.0, error - half), error + half, half


COMPARE = {"largest": _over_largest, "each": _over_each, "means": _means_apart}
