"""Every limit that a buckling or seismic row states masks just beyond it and not just below; none stands in words alone."""

import re
from dataclasses import replace
from inspect import signature

import numpy as np
import pytest
from scipy.optimize import brentq

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.buckling.family import IN_SCOPE, PARAMETERS, evaluate
from silostudy.seismic.rules import MASS_RULES

ROWS = [*BUCKLING.values(), *RIVALS.values()]
LIMITS = [(row, limit) for row in ROWS for limit in row.limits]
USUAL = {name: value for name, (_, _, value) in PARAMETERS.items()}
# what a limit needs to be met at all, and the parameter that leads across it where it is not the first
OWN = {
    "whole length unknown": {"total_length": np.nan, "ring_area": 2e-3},
    "C of a long shell": {"fabricated": 0.0},
}
DIRECT = {"p_s": "lower_internal_pressure", "A_r": "ring_area"}  # measures that are a parameter
BY = {"whole length unknown": "ring_area", "omega t/r": "bay_length"}


def matching(table, limit, default):
    return next((own for words, own in table.items() if words in limit.measure.symbol), default)


def shell_at(limit, value):
    """A usual shell, one parameter of which brings the measure to a value."""
    scene = USUAL | matching(OWN, limit, {})
    name = matching(BY, limit, next(iter(signature(limit.measure.of).parameters)))
    if limit.measure.symbol in DIRECT:
        return scene | {DIRECT[limit.measure.symbol]: value}

    def miss(exponent):
        return float(limit.measure.value(None, scene | {name: scene[name] * 10**exponent})) - value

    return scene | {name: scene[name] * 10 ** brentq(miss, -3, 3, xtol=1e-15, rtol=1e-14)}


def scope(row, scene):
    return int(evaluate(row, {name: np.asarray(value) for name, value in scene.items()})["buckling_stress_scope"])


@pytest.mark.parametrize(("row", "limit"), LIMITS, ids=[f"{row.key}-{limit.words()[:30]}" for row, limit in LIMITS])
def test_a_limit_masks_beyond_it_and_not_below(row, limit):
    ends = [(limit.least, -1), (limit.above, -1), (limit.most, 1), (limit.below, 1)]
    alone, checked = replace(row, limits=(limit,)), 0
    for end, outward in ends:
        if np.isfinite(end):
            step = max(1e-5, 10 * limit.tolerance) * max(abs(end), 1e-3)
            beyond = shell_at(limit, end + outward * step)
            assert scope(alone, beyond) == limit.reason
            assert scope(row, beyond) != IN_SCOPE
            assert np.isnan(evaluate(row, {k: np.asarray(v) for k, v in beyond.items()})["buckling_stress"])
            inside = end if limit.measure.symbol == "A_r" else end - outward * step
            assert scope(alone, shell_at(limit, inside)) == IN_SCOPE
            checked += 1
    assert checked


@pytest.mark.parametrize("row", ROWS, ids=lambda row: row.key)
def test_the_usual_shell_is_within_every_limit(row):
    if row.key not in ("miller1977_natural_log",):  # whose C is negative for any silo
        assert scope(row, USUAL) == IN_SCOPE
    assert all(limit.words() in row.range for limit in row.limits)


@pytest.mark.parametrize("row", [*ROWS, *MASS_RULES.values()], ids=lambda row: row.key)
def test_no_limit_stands_in_words_alone(row):
    """What compares a number belongs into `limits`; the seismic rows have no number to compare."""
    assert not re.search(r"<|>=? *\d|\b(below|above|up to|beyond) \d|masked", row.validity)
