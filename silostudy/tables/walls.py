"""Wall kinds: how much of the solid's own friction acts on the wall."""

from dataclasses import dataclass

from silostudy.catalogue import Family, Row
from silostudy.tables.read import HERE, rows
from silostudy.tables.solids import GRAINS


@dataclass(frozen=True, kw_only=True)
class WallRow(Row):
    """A wall kind: `rule` says what the factor of a grain class multiplies, or that the solid has its own (see walls.csv)."""

    rule: str
    factors: dict[str, float]


def _wall(raw: dict) -> WallRow:
    factors = {grain: raw[grain] for grain in GRAINS if grain in raw}
    return WallRow(key=raw["wall"], factors=factors, **{name: raw[name] for name in ("title", "rule", "source", "locator")})


WALLS = Family("wall", [_wall(raw) for raw in rows(HERE / "walls.csv", text=("wall", "rule"))])
