"""Stored solids: the handbook's tables, and a user's own file in the same columns."""

from collections.abc import Iterable
from dataclasses import dataclass, field, fields, replace
from math import isnan, nan, tan
from pathlib import Path

from silostudy.catalogue import Family, Row
from silostudy.errors import BadInput
from silostudy.tables.ranges import BY_QUANTITY
from silostudy.tables.read import HERE, number, rows
from silostudy.tables.references import own_references, own_source
from silostudy.tables.units import split_unit

GRAINS = ("powder", "fine_grain", "coarse_grain")
CATEGORIES = ("d1", "d2", "d3")  # wall categories in which EN 1991-4 gives a solid its wall friction
REQUIRED = ("unit_weight", "internal_friction_angle")
PROPERTIES = (
    "unit_weight",
    "unit_weight_lower",
    "internal_friction_angle",
    "wall_friction_angle",
    "wall_friction",
    "lateral_pressure_ratio",
    "poisson_ratio",
    "i_phi",
    "effective_friction_angle",
    "repose_angle",
    "a_phi",
    "a_K",
    "a_mu",
    "patch_factor",
    *CATEGORIES,
)
UNITS = {name: split_unit(BY_QUANTITY[name][0])[1] for name in PROPERTIES}  # of the SI values


@dataclass(frozen=True, kw_only=True)
class SolidRow(Row):
    """One stored solid in SI units; what the table leaves empty is NaN.

    `by_method` holds the values that a method's own source uses instead, `as_printed` the ones printed in error.
    """

    grain: str
    unit_weight: float
    internal_friction_angle: float
    unit_weight_lower: float = nan
    wall_friction: float = nan
    lateral_pressure_ratio: float = nan
    poisson_ratio: float = nan
    effective_friction_angle: float = nan
    repose_angle: float = nan
    a_phi: float = nan  # conversion factors of EN 1991-4: characteristic value = mean times or over a
    a_K: float = nan
    a_mu: float = nan
    patch_factor: float = nan
    d1: float = nan
    d2: float = nan
    d3: float = nan
    remark: str = ""
    by_method: dict[str, dict[str, float]] = field(default_factory=dict)
    as_printed: dict[str, dict[str, float]] = field(default_factory=dict)


def check_property(name: str, value: float, where: str) -> None:
    """BadInput unless a property of a solid (SI) lies in its physical range."""
    written, known = BY_QUANTITY[name]
    shown, low, high = value / split_unit(written)[2], known.least, known.greatest
    if isnan(value) or not (low < shown < high if known.open else low <= shown <= high):
        ends = f"between {low:g} and {high:g} (ends excluded)" if known.open else f"from {low:g} to {high:g}"
        raise BadInput(written, shown, f"must lie {ends}", where)


def read_solids(path: Path, taken: Iterable[str] = ()) -> Family[SolidRow]:
    """Solids of a CSV file; BadInput, with file and line, for a key taken twice or a value out of range."""
    solids: dict[str, SolidRow] = {}
    for raw in rows(path, ("solid", "grain"), UNITS):
        where, row = raw["where"], _solid(raw)
        if row.key in solids or row.key in taken:
            raise BadInput("solid", row.key, "this key is already taken by another row", where)
        solids[row.key] = row
    return Family("solid", solids.values())


def _solid(raw: dict) -> SolidRow:
    where, values = raw.pop("where"), {key: value for key, value in raw.items() if key != "solid"}
    if not raw.get("solid"):
        raise BadInput("solid", raw.get("solid"), "is missing: the key of the row", where)
    if {"wall_friction", "wall_friction_angle"} <= values.keys():
        raise BadInput("wall_friction", values["wall_friction"], "stands beside wall_friction_angle: give one of them", where)
    if "wall_friction_angle" in values:
        values["wall_friction"] = tan(values.pop("wall_friction_angle"))
    unknown = set(values) - set(_own_fields())
    if unknown:
        raise BadInput("column", ", ".join(sorted(unknown)), f"unknown; known: {', '.join(known_columns())}", where)
    for name in REQUIRED:
        if name not in values:
            raise BadInput(name, None, f"is missing (write the unit into the column, e.g. {with_unit(name)})", where)
    if values.get("grain") not in GRAINS:
        raise BadInput("grain", values.get("grain"), f"must be one of {', '.join(GRAINS)}", where)
    for name in PROPERTIES & values.keys():
        check_property(name, values[name], where)
    return SolidRow(key=raw["solid"], **{"title": raw["solid"], **values})


def own_solids(path: Path) -> Family[SolidRow]:
    """The package's solids with those of a user's file, whose sources may be the user's own."""
    mine, references = read_solids(path, SOLIDS).values(), own_references(path)
    return SOLIDS.joined(
        replace(row, source=own_source(row.source, path, references, f"{path.name}, {row.key}")) for row in mine
    )


def with_unit(name: str) -> str:
    """A column name that carries a usual unit."""
    return BY_QUANTITY[name][0]


def known_columns() -> list[str]:
    properties = [name for name in PROPERTIES if name in _own_fields() or name == "wall_friction_angle"]
    return ["solid", "title", "grain", *map(with_unit, properties), "source", "locator", "remark"]


def _own_fields() -> list[str]:
    """Fields of a row that a column of its table fills."""
    return [field.name for field in fields(SolidRow) if field.name not in ("key", "by_method", "as_printed")]


def _with_method_values(family: Family[SolidRow], path: Path) -> Family[SolidRow]:
    for raw in rows(path, text=("solid", "method", "parameter", "value", "as_printed")):
        for column in ("value", "as_printed"):
            if raw[column]:
                name, value = _own_value(raw["parameter"], number(raw[column], column, raw["where"]))
                check_property(name, value, raw["where"])
                solid = family[raw["solid"]]
                values = solid.by_method if column == "value" else solid.as_printed
                values.setdefault(raw["method"], {})[name] = value
    return family


def _own_value(parameter: str, value: float) -> tuple[str, float]:
    name, _, factor = split_unit(parameter)
    return ("wall_friction", tan(value * factor)) if name == "wall_friction_angle" else (name, value * factor)


SOLIDS = _with_method_values(
    read_solids(HERE / "solids.csv").joined(read_solids(HERE / "en1991_4_table_e1.csv").values()), HERE / "solids_by_method.csv"
)
