"""The silo, the discs and the packings of Kiyama and Fujimura (1983) in SI: what the table holds, and what follows from it."""

from silostudy.tables.constants import ROUNDED_GRAVITY, STANDARD_GRAVITY
from silostudy.tables.read import HERE, number, rows

SI = {"1": 1.0, "cm": 1e-2, "cm s": 1e-2, "g/cm3": 1e3, "kgf/cm2": 1e4 * STANDARD_GRAVITY, "N/m": 1.0}  # factors of its units


def _printed() -> dict[tuple[str, int | None], float]:
    """Values in SI by quantity and packing, None where a row holds for every packing."""
    numbers = {}
    for row in rows(HERE / "kiyama_1983.csv", text=("quantity", "value", "unit")):
        across = int(row["across"]) if "across" in row else None
        numbers[row["quantity"], across] = number(row["value"], row["quantity"], row["where"]) * SI[row["unit"]]
    return numbers


_PRINTED = _printed()
_ALWAYS = {quantity: value for (quantity, across), value in _PRINTED.items() if across is None}

# s of the packings 11/12 and 17/18, whose states at rest the source's conclusion 1 calls so
PASSIVE = 12
ACTIVE = 18
SILO_WIDTH = _ALWAYS["silo_width"]  # m
SILO_HEIGHT = _ALWAYS["silo_height"]  # m
SLIT_WIDTH = _ALWAYS["slit_width"]  # m
DISC_COUNT = int(_ALWAYS["disc_count"])
RADIUS = _ALWAYS["radius"]  # m
DENSITY = _ALWAYS["density"]  # kg m-3
YOUNGS_MODULUS = _ALWAYS["youngs_modulus"]  # Pa
POISSONS_RATIO = _ALWAYS["poissons_ratio"]  # 1
CONTACT_LOAD = _ALWAYS["contact_load"]  # N m-1
NORMAL_STIFFNESS = _ALWAYS["normal_stiffness_over_weight"] * (DENSITY * ROUNDED_GRAVITY)  # N m-2
NORMAL_DAMPING = _ALWAYS["normal_damping_over_weight"] * (DENSITY * ROUNDED_GRAVITY)  # N s m-2
DAMPING_RATIO = _ALWAYS["damping_ratio"]  # dashpots over 2 sqrt(m K)
STIFFNESS_RATIO = _ALWAYS["stiffness_ratio"]  # tangential over normal
DISC_FRICTION = _ALWAYS["disc_friction"]  # 1
WALL_FRICTION = _ALWAYS["wall_friction"]  # 1
WALL_STIFFNESS_RATIO = _ALWAYS["wall_stiffness_ratio"]
GAPS = {across: value for (quantity, across), value in _PRINTED.items() if quantity == "gap" and across}  # m, by s


def pitch(across: int) -> float:
    """Distance (1), over the radius, of neighbours in a row of `across` discs that touch both walls of the source's silo."""
    return (SILO_WIDTH / RADIUS - 2.0) / (across - 1)


def width_as_steep(across: int, packing: int = ACTIVE) -> float:
    """Inner width (m) of a silo in which `across` discs stand as far apart as those of one of the source's packings in its."""
    return (2.0 + (across - 1) * (SILO_WIDTH / RADIUS - 2.0) / (packing - 1)) * RADIUS
