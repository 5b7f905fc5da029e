"""Axial compression, hoop compression and shear together, by the edition of EN 1993-1-6."""

from collections.abc import Callable
from inspect import Parameter, Signature
from types import ModuleType

import numpy as np

from silostudy.buckling import en1993_1_6_2007, en1993_1_6_2025, en1993_4_1
from silostudy.checks import external_pressure, shear_buckling
from silostudy.checks.capacity import KNOWN_CLASSES
from silostudy.checks.family import SteelCheck, call
from silostudy.limits import Limit, Measure

ASKED = (
    "yield_stress", "youngs_modulus", "fabrication_quality", "partial_buckling", "inner_radius", "thickness", "wall_height",
    "lower_internal_pressure", "upper_internal_pressure", "axial_wall_force", "wall_above", "shear_wall_force",
)  # fmt: skip
OUTSIDE = ("wind_pressure", "suction", "edge_factor", "critical_external_pressure", "thinnest")


def exponents_2007(chi_x, chi_th, chi_tau):
    """Exponents k_x, k_th, k_tau (1): 1.25 + 0.75 chi; shear 1.75 + 0.25 chi. Source: en1993_1_6_2007, two public programs."""
    return 1.25 + 0.75 * chi_x, 1.25 + 0.75 * chi_th, 1.75 + 0.25 * chi_tau


def exponents_2025(chi_x, chi_th, chi_tau):
    """Exponents k_x, k_th, k_tau (1): 1 + chi^2, and 1.5 + 0.5 chi^2 for shear. Source: en1993_1_6_2025, one public program."""
    return 1 + chi_x**2, 1 + chi_th**2, 1.5 + 0.5 * chi_tau**2


def together(shares, chis, exponents):
    """Sum U (1): s_x^k_x - k_i s_x s_th + s_th^k_th + s_tau^k_tau, k_i = (chi_x chi_th)^2, s stress over strength, tension 0.

    Source: en1993_1_6_2007, two public programs; en1993_1_6_2025 with its own exponents, one.
    """
    x, th, tau = (np.maximum(share, 0.0) for share in shares)
    k_x, k_th, k_tau = exponents(*chis)
    return x**k_x - (chis[0] * chis[1]) ** 2 * x * th + th**k_th + tau**k_tau


def _axial(edition: ModuleType, given) -> tuple:
    """Stress over strength and chi_x (1) of axial compression with what the solid's pressure does to it."""
    own = {**given, "shell_radius": given["inner_radius"] + given["thickness"] / 2}
    chi = call(en1993_4_1.strength(edition), own).strength / given["yield_stress"]
    stress = given["axial_wall_force"] / given["thickness"] + given["wall_above"]
    return stress / (chi * given["yield_stress"] / given["partial_buckling"]), chi


def _shear(alpha: Callable, given) -> tuple:
    share = call(shear_buckling.stress, given) / call(shear_buckling.strength(alpha), given)
    return share, call(shear_buckling.reduction(alpha), given)


def _hoop(given) -> tuple:
    """Stress over strength and chi_th (1) of hoop compression; 0 and 1 where nothing presses from outside."""
    if "wind_pressure" not in given:
        return 0.0, 1.0
    with np.errstate(invalid="ignore", divide="ignore"):
        share = call(external_pressure.hoop_compression, given) / call(external_pressure.strength, given)
        acts = given["wind_pressure"] + given["suction"] > 0
        return np.where(acts, share, 0.0), np.where(acts, call(external_pressure.reduction, given), 1.0)


def behind(edition: ModuleType, alpha: Callable, exponents: Callable, names: tuple[str, ...]) -> Callable:
    """Function that gives the numbers behind the check: of each kind of stress its share of the strength, chi and exponent."""

    def numbers(**given):
        parts = {"axial": _axial(edition, given), "hoop": _hoop(given), "shear": _shear(alpha, given)}
        powers = dict(zip(parts, exponents(*(chi for _, chi in parts.values())), strict=True))
        numbers_of_sum = {f"{kind}_share": share for kind, (share, _) in parts.items()}
        numbers_of_sum |= {f"{kind}_reduction": chi for kind, (_, chi) in parts.items()}
        return numbers_of_sum | {f"{kind}_exponent": power for kind, power in powers.items()}

    numbers.__signature__ = Signature([Parameter(name, Parameter.KEYWORD_ONLY) for name in names])  # type: ignore[attr-defined]
    return numbers


def interaction(edition: ModuleType, alpha: Callable, exponents: Callable, names: tuple[str, ...]) -> Callable:
    """The function of an edition, which asks for the parameters named."""

    def effect(**given):
        parts = _axial(edition, given), _hoop(given), _shear(alpha, given)
        shares, chis = zip(*parts, strict=True)
        return together(shares, chis, exponents)

    effect.__signature__ = Signature([Parameter(name, Parameter.KEYWORD_ONLY) for name in names])  # type: ignore[attr-defined]
    effect.__doc__ = f"U (1), at most 1, of axial and hoop compression and shear together. Source: {edition.ROW.source}."
    return effect


def resistance():
    """Limit of the sum (1)."""
    return 1.0


def _row(edition: ModuleType, year: str, effect: Callable, formula: str, sources: str, **more) -> SteelCheck:
    return SteelCheck(
        key=f"interaction_{year}",
        rank=3,
        title=f"interaction, {year}",
        source=edition.ROW.source,
        locator="interaction of axial compression, hoop compression and shear, second-hand",
        effect=effect,
        resistance=resistance,
        unit="1",
        formula=f"U = s_x^k_x - k_i s_x s_th + s_th^k_th + s_tau^k_tau <= 1, s stress over design strength, {formula}, "
        "k_i = (chi_x chi_th)^2; tension counts as 0; axial strength with the solid's pressure (EN 1993-4-1)",
        validity=f"membrane stresses of one load case at one level; {sources}, printed standard not seen",
        **more,
    )


def _yielding(*, upper_internal_pressure, inner_radius, thickness, yield_stress):
    """Hoop stress over yield stress p r / (t f_y) (1)."""
    return upper_internal_pressure * (inner_radius / thickness + 0.5) / yield_stress


BELOW_HOOP_YIELD = Limit(
    measure=Measure("p r/(t f_y)", "1", _yielding), below=1.0, why="beyond it the pressure yields the wall"
)
ROWS = (
    _row(
        en1993_1_6_2007,
        "2007",
        interaction(en1993_1_6_2007, shear_buckling.alpha_2007, exponents_2007, (*ASKED, *OUTSIDE)),
        behind=behind(en1993_1_6_2007, shear_buckling.alpha_2007, exponents_2007, (*ASKED, *OUTSIDE)),
        formula="k_x = 1.25 + 0.75 chi_x, k_th likewise, k_tau = 1.75 + 0.25 chi_tau",
        sources="two public programs (a third has 1.25 + 0.25 chi_tau for k_tau, which is safe)",
        limits=(BELOW_HOOP_YIELD, KNOWN_CLASSES, external_pressure.MEDIUM),
    ),
    _row(
        en1993_1_6_2025,
        "2025",
        interaction(en1993_1_6_2025, shear_buckling.alpha_2025, exponents_2025, ASKED),
        behind=behind(en1993_1_6_2025, shear_buckling.alpha_2025, exponents_2025, ASKED),
        formula="k_x = 1 + chi_x^2, k_tau = 1.5 + 0.5 chi_tau^2",
        sources="one public program; hoop strengths of this edition are not known, so only where nothing presses from outside; "
        "a mix of editions where the solid's pressure is counted",
        limits=(BELOW_HOOP_YIELD,),
        idle_with=frozenset({"suction"}),
        one_source=True,
    ),
)
