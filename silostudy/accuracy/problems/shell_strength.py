"""The strength of pressurised shells in single and double precision, against 50 digits."""

from decimal import Decimal, localcontext

import numpy as np

from silostudy.buckling import en1993_4_1
from silostudy.buckling.family import call

BITS = {32: np.float32, 64: np.float64}
LADDERS = {"float": tuple(BITS)}
RULE = en1993_4_1.ROWS[0]  # the first edition
SHELLS = 400  # that are compared
MANY = 50  # times that they stand in the call that is timed
DIGITS = 50
STEEL = {"youngs_modulus": 210e9, "yield_stress": 235e6, "fabrication_quality": 25.0}
HOOP = (0.01, 0.2, 0.8)  # shares of the yield stress between which lower and upper pressure load the hoop


def shells() -> dict[str, np.ndarray]:
    """Shells of R/t from 100 to 2000 under hoop stresses of 1 to 80 % of yield, as numbers that 32 bits hold exactly."""
    random = np.random.default_rng(0)
    slender = np.geomspace(100.0, 2000.0, SHELLS)
    radius = random.uniform(1.0, 10.0, SHELLS)
    low, middle, high = HOOP
    given = {
        **{name: np.full(SHELLS, value) for name, value in STEEL.items()},
        "shell_radius": radius,
        "thickness": radius / slender,
        "lower_internal_pressure": STEEL["yield_stress"] / slender * random.uniform(low, middle, SHELLS),
        "upper_internal_pressure": STEEL["yield_stress"] / slender * random.uniform(middle, high, SHELLS),
    }
    return {name: values.astype(np.float32) for name, values in given.items()}


def prepare(ladder: str, setting: float):
    """All shells in one call."""
    given = {name: np.tile(values, MANY).astype(BITS[int(setting)]) for name, values in shells().items()}
    return lambda: {"strength": np.asarray(call(RULE.strength, given).strength[:SHELLS], float)}


def reference():
    """The same formulas by decimals of 50 digits."""
    given = shells()
    columns = {name: [Decimal(float(value)) for value in values] for name, values in given.items()}
    with localcontext() as context:
        context.prec = DIGITS
        rows = (dict(zip(columns, row, strict=True)) for row in zip(*columns.values(), strict=True))
        return {"strength": np.array([float(exact(**row)) for row in rows])}


def exact(*, youngs_modulus, yield_stress, fabrication_quality, shell_radius, thickness,
          lower_internal_pressure, upper_internal_pressure):  # fmt: skip
    """Strength (Pa) by EN 1993-4-1 on EN 1993-1-6:2007, written out anew: en1993_4_1 and en1993_1_6_2007, second-hand."""
    d, slender = Decimal, shell_radius / thickness
    critical = d("0.605") * youngs_modulus / slender
    squared = yield_stress / critical
    smooth = d("0.62") / (1 + d("1.91") * (slender.sqrt() / fabrication_quality) ** d("1.44"))
    s, hoop = slender / 400, slender / critical
    helping, harming = lower_internal_pressure * hoop, upper_internal_pressure * hoop
    helped = smooth + (1 - smooth) * helping / (helping + d("0.3") / smooth.sqrt())
    foot = (1 - (harming / squared) ** 2) * (1 - 1 / (d("1.12") + s * s.sqrt())) * (s * s + d("1.21") * squared) / (s * (s + 1))
    alpha, slenderness = min(helped, foot), squared.sqrt()
    plastic = (alpha / d("0.4")).sqrt()
    if slenderness >= plastic:
        return alpha * critical
    straight = 1 - d("0.6") * (slenderness - d("0.2")) / (plastic - d("0.2"))
    return yield_stress * (straight if slenderness > d("0.2") else d(1))
