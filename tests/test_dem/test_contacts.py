"""From a scene's fields to contacts: dashpots follow the discs' own radii, and what a scene calls for is told."""

from math import pi, sqrt

import numpy as np
import pytest

from silostudy.scene.dem import contacts_of, effects

from .small import scene_of

RATIO, STIFFNESS, DENSITY = 0.1, 9.46e6, 2650.0


def damped(**fields):
    """A scene whose damping is asked for otherwise than as a dashpot; radius_m is 10 mm."""
    return scene_of(discs__normal_damping_N_s_m2=None, walls__normal_damping_N_s_m2=None, **fields)


def ratios(contact, masses, stiffness):
    """The dashpot over the critical one of each reduced mass."""
    c = contact.coefficients
    return [(c["normal_damping"] + c["normal_damping_root"] * sqrt(m)) / (2 * sqrt(m * stiffness)) for m in masses]


@pytest.mark.parametrize("radii", [(0.005, 0.005), (0.02, 0.02), (0.005, 0.02)])
def test_a_damping_ratio_is_of_the_discs_own_radii(radii):
    """Every pair, whatever radius_m: of a disc's mass, and twice the reduced one; at a wall each disc's own."""
    between, wall = contacts_of(damped(discs__damping_ratio=RATIO, walls__damping_ratio=RATIO), np.array(radii))
    one, other = (DENSITY * pi * radius**2 for radius in radii)
    pairs = [one * other / (one + other)] + ([one / 2, other / 2] if one != other else [])
    assert ratios(between, pairs, STIFFNESS) == pytest.approx([sqrt(2) * RATIO] * len(pairs))
    assert ratios(wall, [one, other], 1.89e7) == pytest.approx([RATIO] * 2)


@pytest.mark.parametrize("radii", [(0.005, 0.005), (0.005, 0.02)])
def test_a_restitution_is_of_every_pair_and_wall(radii):
    between, wall = contacts_of(damped(discs__restitution=0.5, walls__restitution=0.5), np.array(radii))
    damping = ratios(between, [1e-3, 7.0], STIFFNESS) + ratios(wall, [1e-3, 7.0], 1.89e7)
    assert damping == pytest.approx([damping[0]] * 4)


def test_what_only_walls_have_is_told_and_a_friction_of_zero_is_left_out():
    walls = {"walls__rolling": "spring-slider", "walls__rolling_friction": 0.1, "walls__rolling_stiffness_N": 5.0}
    walls |= {"walls__cohesion": "constant-pull", "walls__pull_N_m": 0.5}
    on = {effect.name: effect for effect in effects(scene_of(**walls))}
    for name in ("rolling resistance", "cohesion"):
        assert on[name].on
        assert "discs" in on[name].why
        assert "none" in on[name].why
    smooth = {"discs__sliding_friction": 0.0, "walls__sliding_friction": 0.0}
    friction = {effect.name: effect for effect in effects(scene_of(**smooth))}["friction, rotation, history"]
    assert not friction.on
