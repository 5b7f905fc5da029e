"""The problems on which accuracy is set against its cost, by key."""

from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.tables.read import HERE, rows

GROUPS = ("grains", "formulas", "shells", "earthquake")


@dataclass(frozen=True, kw_only=True)
class ProblemRow(Row):
    """One problem: its quantities in words, what its ladders vary, and the reference that its error is counted from."""

    group: str
    setting: str
    quantities: dict[str, str]
    reference_kind: str
    reference: str
    compare: str  # error over the largest reference value, over each, or between means of ensembles


def _problem(raw: dict) -> ProblemRow:
    names = ("title", "group", "setting", "reference_kind", "reference", "compare", "source", "locator")
    quantities = dict(part.split("=", 1) for part in raw["quantities"].split(";"))
    return ProblemRow(key=raw["problem"], quantities=quantities, **{name: raw[name] for name in names})


_TEXT = ("problem", "group", "setting", "quantities", "reference_kind", "reference", "compare")
PROBLEMS = Family("problem", map(_problem, rows(HERE / "problems.csv", text=_TEXT)))
