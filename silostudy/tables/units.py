"""Units live in names: `diameter_m`, `unit_weight_kN_m3`.  One place turns them into SI, once."""

from math import pi

from silostudy.tables.constants import STANDARD_GRAVITY

# suffix -> (unit in the cube, factor).  Tonne-force units follow the source: 1 t = 9.80665 kN.
SUFFIXES: dict[str, tuple[str, float]] = {
    "_t_m3": ("N m-3", 1e3 * STANDARD_GRAVITY),
    "_t_m2": ("Pa", 1e3 * STANDARD_GRAVITY),
    "_kN_m3": ("N m-3", 1e3),
    "_N_m3": ("N m-3", 1.0),
    "_kg_m3": ("kg m-3", 1.0),
    "_kPa_m": ("Pa m-1", 1e3),
    "_kPa": ("Pa", 1e3),
    "_MPa": ("Pa", 1e6),
    "_GPa": ("Pa", 1e9),
    "_Mpsi": ("Pa", 6894.757293e6),
    "_ksi": ("Pa", 6894.757293e3),
    "_psi": ("Pa", 6894.757293),
    "_deg": ("rad", pi / 180),
    "_cm2": ("m2", 1e-4),
    "_in2": ("m2", 0.0254**2),
    "_in": ("m", 0.0254),
    "_gal": ("m s-2", 1e-2),
    "_Hz": ("Hz", 1.0),
    "_mm": ("m", 1e-3),
    "_m": ("m", 1.0),
}


def split_unit(name: str) -> tuple[str, str, float]:
    """Quantity, SI unit and factor of a name that may end in a unit; '1' and 1.0 where it carries none."""
    for suffix, (unit, factor) in SUFFIXES.items():
        if name.endswith(suffix):
            return name.removesuffix(suffix), unit, factor
    return name, "1", 1.0
