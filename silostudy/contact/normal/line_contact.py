"""Elastic line contact of two cylinders on its own curve, with a dashpot."""

from math import log, sqrt

import numpy as np
from numba.extending import register_jitable

from silostudy.contact import curve, spring
from silostudy.contact.coefficient import Coefficient, Given
from silostudy.contact.family import NormalLaw
from silostudy.contact.sources import KIYAMA


def coefficients_of(given: Given) -> tuple[float, float]:
    """Coefficients (A, B) of the curve from a scene's line contact."""
    line = given["line_contact"]
    return curve.curve(
        given.radius,
        youngs_modulus=line["youngs_modulus_Pa"],
        poissons_ratio=line["poissons_ratio"],
        constant=curve.PRINTED_CONSTANTS[line["constant"]],
    )


def compliance(given: Given) -> float:
    """A (m2/N) of the curve."""
    return coefficients_of(given)[0]


def bracket(given: Given) -> float:
    """Bracket B (1) of the curve, the load in N/m."""
    return coefficients_of(given)[1]


@register_jitable
def law(overlap, closing, touch, c):
    """Elastic and total normal force (N/m) on the elastic line-contact curve with a dashpot that never pulls.

    Kiyama & Fujimura (1983), eqs. (22a), (22b); c = (A, B, damping, damping by root of mass).
    """
    elastic = curve.load_of(overlap, c[0], c[1])
    total = elastic + (c[2] + c[3] * sqrt(touch.mass)) * closing
    return elastic, (total if total > 0.0 else 0.0)


@register_jitable
def energy(overlap, touch, c):
    """Energy (J/m) of the line contact at an overlap (m): the integral of q over A q (B - ln q); c = (A, B, ...)."""
    q = curve.load_of(overlap, c[0], c[1])
    return 0.0 if q == 0.0 else 0.5 * c[0] * q * q * (c[1] - 0.5 - log(q))


@register_jitable
def stiffness(overlap, touch, c):
    """Slope (N/m per m) of the curve just below an overlap (m); c = (A, B, ...)."""
    high, low = curve.load_of(overlap, c[0], c[1]), curve.load_of(0.999 * overlap, c[0], c[1])
    return (high - low) / (0.001 * overlap)


def damping(touch, c):
    """Damping (N s/m per m) of the dashpot."""
    return c[2] + c[3] * np.sqrt(touch.mass)


ROW = NormalLaw(
    key="line-contact", rank=4,
    title="Elastic line contact on its own curve, dashpot, no tension",
    source=KIYAMA,
    locator="eqs. (22a), (22b)",
    law=law,
    energy=energy,
    stiffness=stiffness,
    damping=damping,
    coefficients=(
        Coefficient(name="line_compliance", unit="m2 N-1", fields=(("line_contact",),), prepare=compliance, positive=True,
                    stiffness_power=-1.0),
        Coefficient(name="line_bracket", unit="1", fields=(("line_contact",),), prepare=bracket, positive=True),
        *spring.DASHPOT,
    ),
    one_size=True,
    grains=("discs",),
    dissipates=("dashpot",),
)  # fmt: skip
