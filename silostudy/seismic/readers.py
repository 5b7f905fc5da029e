"""Readers of earthquake records.  A file that does not say its unit is refused unless the user says it."""

import re
from collections.abc import Callable
from importlib.resources import as_file, files
from pathlib import Path

import numpy as np

from silostudy.errors import BadInput
from silostudy.seismic.records import Record, plausible
from silostudy.seismic.traces import of_obspy
from silostudy.seismic.units import agreed, said_unit, unit_in
from silostudy.tables.columns import equal_steps, read_columns
from silostudy.tables.read import number, short, text_of
from silostudy.tables.records import RECORDS

COLUMNS = ("time (s)", "acceleration")


def read_known(key: str) -> Record:
    """A record that a package this one depends on brings along (tables/records.csv)."""
    row = RECORDS[key]
    with as_file(files(row.package).joinpath(row.file)) as path:
        return Record(*of_obspy(path, None), row.title)


def read_record(path: Path, form: str, unit: str | None, channel: str | None = None) -> Record:
    """A user's file; BadInput where it cannot be read, holds no motion at equal steps, or nobody says its unit.

    channel: which of several traces, for the form that may hold several.
    """
    chosen = (channel,) if form == "obspy" else ()
    return plausible(Record(*READERS[form](path, unit, *chosen), path.name), str(path))


def _two_columns(path: Path, unit: str | None) -> tuple[np.ndarray, float]:
    """Time (s) and acceleration, a line each; # starts a remark."""
    columns = read_columns(path, COLUMNS)
    words = (*columns.remarks[-1:], *columns.head)
    if re.search(r"[(\[_](ms|msec|min|us)(?!\w)", " ".join(words), re.IGNORECASE):
        raise BadInput("time", " ".join(words), "must be in seconds", str(path))
    factor = agreed(unit, unit_in(words), str(path))
    return factor * columns.column("acceleration", 1), equal_steps(columns)[1]


def _peer_at2(path: Path, unit: str | None) -> tuple[np.ndarray, float]:
    """PEER's AT2: three lines of text, of which the last says the unit, a line with NPTS and DT, then the values."""
    lines = text_of(path, errors="replace").splitlines()
    if len(lines) < 5:
        raise BadInput("record", str(path), "must be PEER AT2: four lines of header, then the values")
    factor = _at2_factor(lines[2], unit, f"{path} line 3")
    count, step = _at2_header(lines[3], f"{path} line 4")
    values = [
        number(cell, "acceleration", f"{path} line {place}") for place, line in enumerate(lines[4:], 5) for cell in line.split()
    ]
    if len(values) != count:
        raise BadInput("NPTS", count, f"differs from the {len(values)} values that follow", f"{path} line 4")
    return factor * np.array(values), step


def _at2_factor(line: str, unit: str | None, where: str) -> float:
    """Factor to m s-2 from the third line of an AT2 file and the unit told."""
    if re.search(r"VELOCITY|DISPLACEMENT", line, re.IGNORECASE):
        raise BadInput("record", short(line.strip()), "must be an acceleration", where)
    said = re.search(r"UNITS? OF\s+([^\s,;]+)", line, re.IGNORECASE)
    spelt = (said_unit(said[1]) or said[1]) if said else unit_in([line])
    if spelt is None and unit is None:
        raise BadInput("record", short(line.strip()), "must say UNITS OF G, or the study its acceleration_unit", where)
    return agreed(unit, spelt, where)


def _at2_header(line: str, where: str) -> tuple[int, float]:
    """Number of values and step (s) of an AT2 file."""
    count = re.search(r"NPTS\s*=\s*(\d{1,9})(?![.\w])", line, re.IGNORECASE | re.ASCII)
    step = re.search(r"DT\s*=\s*(\S+)", line, re.IGNORECASE)
    if not count or not step:
        raise BadInput("record", short(line.strip()), "must be PEER AT2: NPTS= and DT= in the fourth line", where)
    return int(count[1]), number(re.sub(r"(SEC\w*)?[,;]?$", "", step[1], flags=re.IGNORECASE), "DT", where)


READERS: dict[str, Callable[..., tuple[np.ndarray, float]]] = {
    "two_columns": _two_columns,
    "peer_at2": _peer_at2,
    "obspy": of_obspy,
}
