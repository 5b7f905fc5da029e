"""Every limit that a method states masks beyond it and not below, and no limit stands in words alone."""

import re
from dataclasses import replace

import numpy as np
import pytest
from scipy.optimize import brentq

from silostudy.__main__ import main
from silostudy.compute.evaluate import masked
from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import parameters_of
from silostudy.pressure.family import IN_SCOPE, OUT_OF_RANGE
from silostudy.pressure.parameters import PARAMETERS

# a silo that lies within every limit of every method but those of single ones below
USUAL = {name: value for name, (_, _, value) in PARAMETERS.items()} | {
    "diameter": 5.0, "cylinder_depth": 18.0, "outlet_depth": 20.0, "hydraulic_radius": 1.25, "wall_friction": 0.44,
    "wall_friction_uncapped": 0.44, "lateral_pressure_ratio": 0.45, "internal_friction_angle": np.radians(30.0),
    "top_cone_height": 0.5, "contact_depth": 0.5 / 3, "hopper_half_angle": np.radians(30.0), "hopper_wall_friction": 0.5,
}  # fmt: skip
OWN = {
    **{key: {"outlet_eccentricity": 1.5, "filling_eccentricity": 1.5} for key, row in PRESSURE.items() if row.channel},
    "en1991_4_eccentric_squat": {"outlet_eccentricity": 1.5, "cylinder_depth": 9.0, "outlet_depth": 11.0},
    "en1991_4_class_1": {"assessment_class": 1.0, "volume": 50.0},
    "jenike_funnel_1973": {"cylinder_depth": 30.0, "outlet_depth": 30.0, "channel_half_angle": np.radians(8.0)},
}
# limits on what has steps: a scene within, and one beyond
STEPS = {
    "strain of the cooling": ({"cooling_strain": 1e-6}, {"cooling_strain": 0.0}),
    "chi": ({"solid_modulus_factor": 1.0}, {"solid_modulus_factor": 0.0}),
    "c_F v_F": ({"fluid_depth": 0.1}, {"fluid_depth": 0.0}),
    "action assessment class, declared": ({"assessment_class": 1.0}, {"assessment_class": 2.0}),
    "least action assessment class": ({"volume": 120.0}, {"volume": 125.0}),
    "action assessment class, where": ({"assessment_class": 3.0}, {"assessment_class": 2.0}),
    "declared dynamic load": ({"dynamic_bottom": 0.0}, {"dynamic_bottom": 1.0}),
    "heap of a flat-bottomed silo": (
        {"cylinder_depth": 9.9, "hopper_half_angle": np.nan, "top_cone_height": 0.0},
        {"cylinder_depth": 9.9, "hopper_half_angle": np.nan, "top_cone_height": 0.01},
    ),
}
SQUAT = {"h_o/z_o": {"cylinder_depth": 5.0}}  # limits that hold for some silos only
DEPTH = 3.9
LIMITS = [(row, limit) for row in PRESSURE.values() for limit in row.limits]


def concerned(row, limit):
    """(phase, quantity, function) that a limit holds for, the first of each phase."""
    for phase in row.phases:
        of_cylinder, of_hopper = row.phases[phase], {**row.hopper.get(phase, {}), **row.totals.get(phase, {})}
        for name, function in (*of_cylinder.items(), *of_hopper.items()):
            if limit.holds_for(name, phase):
                yield phase, name, function
                break


def scope(row, phase, name, function, scene, z):
    place = None if name in row.totals.get(phase, {}) else np.array([[z]])
    parameters = {key: np.array([[value]]) for key, value in scene.items()} | {"plan": np.array([["circular"]])}
    return int(masked(row, name, phase, function, place, parameters)[1].ravel()[0])


def varied(limit, scene, z, end):
    """(scene, depth) at which the measure comes to a value: by the depth, or by the first parameter that it asks for."""
    name = "" if limit.measure.of_depth else parameters_of(limit.measure.of)[0]

    def at(exponent):
        changed = scene | ({name: scene[name] * 10**exponent} if name else {})
        return changed, z * (1 if name else 10**exponent)

    def miss(exponent):
        changed, depth = at(exponent)
        return float(limit.measure.value(np.float64(depth), changed)) - end

    return at(brentq(miss, -4, 4, xtol=1e-15, rtol=1e-15))


@pytest.mark.parametrize(("row", "limit"), LIMITS, ids=[f"{row.key}-{limit.words()[:40]}" for row, limit in LIMITS])
def test_a_limit_masks_beyond_it_and_not_below(row, limit):
    scene = USUAL | OWN.get(row.key, {}) | next((own for key, own in SQUAT.items() if key in limit.measure.symbol), {})
    if steps := next((both for words, both in STEPS.items() if limit.measure.symbol.startswith(words)), None):
        phase, name, function = next(concerned(row, limit))
        for own, expected in zip(steps, (IN_SCOPE, OUT_OF_RANGE), strict=True):
            alone = replace(row, limits=(limit,))
            assert scope(alone, phase, name, function, scene | own, DEPTH) == expected
        return
    step = max(1e-5, 10 * limit.tolerance)
    ends = [(end, sign) for end, sign in ((limit.least, -1), (limit.above, -1), (limit.most, 1), (limit.below, 1))]
    ends += [(limit.gap[0], 1), (limit.gap[1], -1)]
    checked = 0
    for phase, name, function in concerned(row, limit):
        for end, outward in ends:
            if np.isfinite(end):
                size = step * max(abs(end), 1e-3)
                inward = 0.1 * limit.tolerance * abs(end) if limit.least == limit.most else size
                alone = replace(row, limits=(limit,))
                for value, expected in ((end + outward * size, OUT_OF_RANGE), (end - outward * inward, IN_SCOPE)):
                    changed, z = varied(limit, scene, DEPTH, value)
                    assert scope(alone, phase, name, function, changed, z) == expected, (phase, name, value)
                    if expected == OUT_OF_RANGE:
                        assert scope(row, phase, name, function, changed, z) == OUT_OF_RANGE
                checked += 1
    assert checked


def test_the_usual_silo_is_within_every_limit():
    for row in PRESSURE.values():
        scene = USUAL | OWN.get(row.key, {})
        for phase, functions in row.phases.items():
            for name, function in functions.items():
                assert scope(row, phase, name, function, scene, DEPTH) == IN_SCOPE, (row.key, phase, name)


@pytest.mark.parametrize("key", PRESSURE)
def test_no_limit_stands_in_words_alone(key):
    """What compares a number belongs into `limits`; what is said of the range says so too."""
    row = PRESSURE[key]
    assert not re.search(r"[<>]|\bonly H|h_[bc]/d_c|H/D", row.validity)
    assert all(limit.words() in row.range for limit in row.limits)


def test_limits_are_told_by_explain(capsys):
    assert main(["explain", "en1991_4"]) == 0
    said = capsys.readouterr().out
    for words in ("h_c/d_c > 0.4", "h_b/d_c < 10", "h_b < 100 m", "d_c < 60 m"):
        assert words in said
