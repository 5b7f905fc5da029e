"""Miller's tests of axially compressed steel cylinders: 41 small ones (Table 2) and 4 large ones (Table 3), in SI units."""

from dataclasses import dataclass
from math import nan, sqrt

from silostudy.catalogue import Family, Row
from silostudy.tables.read import HERE, rows

INNER_RADIUS = 7.5 * 0.0254  # m, of every small cylinder


@dataclass(frozen=True, kw_only=True)
class MillerTest(Row):
    """One test; ring_area is 0 and bay_length the distance of the end plates where there are no rings.

    A large test's collapse stress lies between two values; a small one's are equal.  total_length is NaN where not printed.
    """

    scale: str  # "small" or "large"
    material: str
    thickness: float
    shell_radius: float  # of the middle surface
    bay_length: float
    ring_area: float
    youngs_modulus: float
    yield_stress: float
    lower_buckling_stress: float
    upper_buckling_stress: float
    collapse: str = ""  # "G" general, "L" local, empty where the source does not say
    total_length: float = nan


@dataclass(frozen=True)
class Sheet:
    """Steel of one material letter: stresses in Pa."""

    yield_stress: float
    youngs_modulus: float


def _sheets() -> dict[str, Sheet]:
    sheets = rows(HERE / "miller1977_materials.csv", text=("material", "steel"))
    return {row["material"]: Sheet(row["yield_stress"], row["youngs_modulus"]) for row in sheets}


def _row(raw: dict, sheet: Sheet, **values) -> MillerTest:
    return MillerTest(
        key=raw["test"],
        title=f"Miller's test {raw['test']}",
        source=raw["source"],
        locator=raw["locator"],
        material=raw["material"],
        thickness=raw["thickness"],
        youngs_modulus=sheet.youngs_modulus,
        yield_stress=sheet.yield_stress,
        **values,
    )


def _small(raw: dict, sheet: Sheet) -> MillerTest:
    radius = INNER_RADIUS + raw["thickness"] / 2
    bay, bar = raw["relative_bay_length"] * sqrt(radius * raw["thickness"]), raw.get("ring_bar", 0.0)
    return _row(
        raw,
        sheet,
        scale="small",
        shell_radius=radius,
        bay_length=bay,
        ring_area=bar**2,
        total_length=nan if bar else bay,
        lower_buckling_stress=raw["buckling_stress"],
        upper_buckling_stress=raw["buckling_stress"],
        collapse=raw["collapse"],
    )


def _large(raw: dict, sheet: Sheet) -> MillerTest:
    names = ("bay_length", "ring_area", "total_length", "lower_buckling_stress", "upper_buckling_stress")
    radius = raw["inner_radius"] + raw["thickness"] / 2
    return _row(raw, sheet, scale="large", shell_radius=radius, **{name: raw[name] for name in names})


def _tests() -> list[MillerTest]:
    sheets, text = _sheets(), ("test", "material", "collapse", "shape", "ring")
    small = rows(HERE / "miller1977_small_scale.csv", text=text)
    large = rows(HERE / "miller1977_large_scale.csv", text=text)
    return [
        *(_small(raw, sheets[raw["material"]]) for raw in small),
        *(_large(raw, sheets[raw["material"]]) for raw in large),
    ]


TESTS: Family[MillerTest] = Family("test", _tests())
