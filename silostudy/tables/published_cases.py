"""Published numbers that scenes of grains are held against."""

from dataclasses import dataclass
from functools import cache

from silostudy.tables.read import HERE, rows

TEXT = ("case", "quantity", "unit")


@dataclass(frozen=True, kw_only=True)
class PublishedNumber:
    """Published number of a quantity of a case, and how far a run may be off; both in the unit that the table names."""

    case: str
    title: str
    quantity: str
    value: float
    tolerance: float
    unit: str
    source: str
    locator: str
    remark: str


@cache
def published_numbers() -> tuple[PublishedNumber, ...]:
    """Every number, in the order of the table."""
    raw = rows(HERE / "published_cases.csv", text=TEXT)
    return tuple(PublishedNumber(**{name: row[name] for name in PublishedNumber.__dataclass_fields__}) for row in raw)


def published_of(case: str) -> tuple[PublishedNumber, ...]:
    """The numbers of a case, in the order of the table; none of a case that it does not hold."""
    return tuple(number for number in published_numbers() if number.case == case)
