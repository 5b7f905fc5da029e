"""Materials of grains and walls as elastic bodies, and what pairs of them do to each other."""

from dataclasses import dataclass
from math import nan

from silostudy.catalogue import Family, Row
from silostudy.tables.read import HERE, rows


@dataclass(frozen=True, kw_only=True)
class Material(Row):
    """Young's modulus (Pa), Poisson's ratio, density (kg/m3; nan: of a wall)."""

    youngs_modulus: float
    poissons_ratio: float
    density: float = nan


@dataclass(frozen=True, kw_only=True)
class MaterialPair(Row):
    """Restitution, sliding and rolling friction (1) of two materials."""

    restitution: float
    sliding_friction: float
    rolling_friction: float


def _material(raw: dict) -> Material:
    numbers = {name: raw[name] for name in ("youngs_modulus", "poissons_ratio", "density") if name in raw}
    return Material(key=raw["material"], **{name: raw[name] for name in ("title", "source", "locator")}, **numbers)


def _pair(raw: dict) -> MaterialPair:
    names = " on ".join(sorted({raw["first"], raw["second"]}))
    numbers = {name: raw[name] for name in ("restitution", "sliding_friction", "rolling_friction")}
    return MaterialPair(key=names.replace(" ", "_"), title=names, source=raw["source"], locator=raw["locator"], **numbers)


MATERIALS: Family[Material] = Family("material", map(_material, rows(HERE / "materials.csv", text=("material",))))
PAIRS = {
    frozenset((raw["first"], raw["second"])): _pair(raw) for raw in rows(HERE / "material_pairs.csv", text=("first", "second"))
}
