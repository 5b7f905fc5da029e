"""Readers of earthquake records.  A file that does not say its unit is refused unless the user says it."""

import re
from collections.abc import Callable
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np

from silostudy.errors import BadInput
from silostudy.seismic.records import Record
from silostudy.tables.constants import STANDARD_GRAVITY
from silostudy.tables.records import RECORDS

UNITS = {"g": STANDARD_GRAVITY, "gal": 0.01, "m_s2": 1.0}  # accelerations a user may name, in m s-2


def read_known(key: str) -> Record:
    """A record that a package this one depends on brings along (tables/records.csv)."""
    row = RECORDS[key]
    with as_file(files(row.package).joinpath(row.file)) as path:
        return Record(*_of_obspy(path, None), row.title)


def read_record(path: Path, form: str, unit: str | None) -> Record:
    """A user's file; BadInput where it cannot be read, holds no equal steps, or nobody says its unit."""
    try:
        acceleration, dt = READERS[form](path, unit)
    except (OSError, UnicodeDecodeError) as error:
        raise BadInput("record", str(path), f"must be a readable file ({error})") from None
    if len(acceleration) < 2 or not np.isfinite(acceleration).all():
        raise BadInput("record", str(path), "must hold two finite accelerations at least")
    return Record(acceleration, dt, path.name)


def _two_columns(path: Path, unit: str | None) -> tuple[np.ndarray, float]:
    """Time (s) and acceleration, a line each; # starts a remark."""
    factor = _stated(path, unit)
    try:
        table = np.loadtxt(path, ndmin=2, delimiter="," if "," in path.read_text() else None)
    except ValueError as error:
        raise BadInput("record", str(path), f"must hold two columns of numbers, time (s) and acceleration ({error})") from None
    if table.shape[1:] != (2,) or len(table) < 2:
        raise BadInput("record", str(path), f"must hold two columns, time (s) and acceleration, not {table.shape}")
    steps = np.diff(table[:, 0])
    dt = float((table[-1, 0] - table[0, 0]) / len(steps))
    if not dt > 0 or np.abs(steps - dt).max() > 0.01 * dt:
        raise BadInput("record", str(path), f"must have equal time steps; they run from {steps.min():g} to {steps.max():g} s")
    return table[:, 1] * factor, dt


def _peer_at2(path: Path, unit: str | None) -> tuple[np.ndarray, float]:
    """PEER's AT2: three lines of text, of which the last says the unit, a line with NPTS and DT, then the values."""
    lines = path.read_text(encoding="utf-8", errors="replace").splitlines()
    head = " ".join(lines[:4])
    count = re.search(r"NPTS\s*=\s*(\d+)", head, re.IGNORECASE)
    step = re.search(r"DT\s*=\s*(\d*\.?\d+(?:[eE][-+]?\d+)?)", head, re.IGNORECASE)
    if len(lines) < 5 or not count or not step:
        raise BadInput("record", str(path), "must be PEER AT2: NPTS= and DT= in the fourth line")
    if not unit and not re.search(r"UNITS OF G\b", lines[2], re.IGNORECASE):
        raise BadInput("record", str(path), "must say UNITS OF G in its third line, or the study its unit")
    try:
        values = np.array(" ".join(lines[4:]).split(), dtype=float)
    except ValueError as error:
        raise BadInput("record", str(path), f"must hold numbers from the fifth line on ({error})") from None
    if len(values) != int(count[1]):
        raise BadInput("record", str(path), f"says NPTS = {count[1]} and holds {len(values)} values")
    return values * UNITS[unit or "g"], float(step[1])


def _of_obspy(path: Path, unit: str | None) -> tuple[np.ndarray, float]:
    """K-NET and KiK-net, which say their unit, and all else that obspy reads, whose unit the user must say."""
    import obspy

    try:
        stream = obspy.read(str(path))
    except Exception as error:  # obspy has no common error
        raise BadInput("record", str(path), f"obspy cannot read it ({type(error).__name__}: {error})") from None
    if len(stream) != 1:
        raise BadInput("record", str(path), f"must hold one gapless trace, not {len(stream)}")
    trace = stream[0]
    if trace.stats["_format"] == "KNET" and unit is None:
        return trace.data * trace.stats.calib, trace.stats.delta  # obspy's calib turns counts into m s-2
    return np.asarray(trace.data, dtype=float) * _stated(path, unit), trace.stats.delta


def _stated(path: Path, unit: str | None) -> float:
    if unit is None:
        raise BadInput("acceleration_unit", None, f"the file does not say it; one of {', '.join(UNITS)}", path.name)
    return UNITS[unit]


READERS: dict[str, Callable[[Path, str | None], tuple[np.ndarray, float]]] = {
    "two_columns": _two_columns,
    "peer_at2": _peer_at2,
    "obspy": _of_obspy,
}
