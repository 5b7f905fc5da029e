"""Earthquake records at hand: real ones that come with another package, by key."""

from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.tables.read import HERE, rows


@dataclass(frozen=True, kw_only=True)
class RecordRow(Row):
    """One record: the package that brings it and its file there."""

    package: str
    file: str
    remark: str


def _record(raw: dict) -> RecordRow:
    names = ("title", "package", "file", "source", "locator", "remark")
    return RecordRow(key=raw["record"], **{name: raw[name] for name in names})


RECORDS = Family("record", [_record(raw) for raw in rows(HERE / "records.csv", text=("record", "package", "file"))])
