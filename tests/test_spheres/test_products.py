"""Every product of normal, tangential and rolling laws: an oblique impact against an integration written apart from them."""

from itertools import product
from math import pi, sqrt

import numpy as np
import pytest

from silostudy.contact import SPHERE_LAWS
from silostudy.dem.engine import Engine
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from tests.test_spheres.scenes import DENSITY, RADIUS, rows, spheres

pytestmark = pytest.mark.long
RADII = np.array([RADIUS, 1.7 * RADIUS])
MASSES = DENSITY * 4.0 / 3.0 * pi * RADII**3
M = MASSES.prod() / MASSES.sum()
R = RADII.prod() / RADII.sum()
C = {
    "normal_stiffness": 4e3, "normal_damping": 0.02, "normal_damping_root": 3.0, "tangential_stiffness": 3e3,
    "tangential_damping": 0.01, "tangential_damping_root": 1.0, "sliding_friction": 0.35, "hertz_stiffness": 8e6,
    "hertz_damping": 8e2, "mindlin_stiffness": 1.1e7, "rolling_stiffness": 2e-4, "rolling_friction": 0.15, "pull": 2e-3,
}  # fmt: skip
START = np.array([[0.0, 0.0, 0.5], [0.0, 0.0, 0.5]])
START[1, :2] = np.array([0.8, 0.6]) * (RADII.sum() + 1e-9)
VELOCITY = np.array([[0.3, 0.05, 0.1], [-0.2, -0.1, -0.25]])
SPIN = np.array([[40.0, -60.0, 30.0], [20.0, 90.0, -50.0]])


def normal_force(key, depth, closing):
    """Elastic and total force (N)."""
    if "hertz" in key:
        contact = sqrt(R * depth)
        force, dashpot = C["hertz_stiffness"] * contact * depth, C["hertz_damping"] * sqrt(M * contact) * closing
    else:
        force = C["normal_stiffness"] * depth
        dashpot = (C["normal_damping"] + C["normal_damping_root"] * sqrt(M)) * closing
    total = force + dashpot
    return force, total if "tension" in key else max(total, 0.0)


def tangential_force(key, held, sliding, depth, before, elastic, push, dt):
    """Held and total force (N)."""
    if "mindlin" in key:
        stiffness = C["mindlin_stiffness"] * sqrt(R * depth)
        dashpot = -C["hertz_damping"] * sqrt(M * sqrt(R * depth)) * sliding
    else:
        stiffness = C["tangential_stiffness"]
        dashpot = -(C["tangential_damping"] + C["tangential_damping_root"] * sqrt(M)) * sliding
    if key == "none":
        return held, 0.0 * held
    cap = C["sliding_friction"] * max(push, 0.0)
    if key == "viscous-coulomb":
        size = np.linalg.norm(dashpot)
        return held, dashpot * min(1.0, cap / size if size else 1.0)
    if key == "mindlin-rescaled" and before > depth:
        held = held * sqrt(depth / before)
    held = held - stiffness * dt * sliding
    if key == "spring-slider":
        size, cap = np.linalg.norm(held), C["sliding_friction"] * elastic
        return (held * cap / size,) * 2 if size > cap else (held, held + dashpot)
    total = held + dashpot
    size = np.linalg.norm(total)
    if size > cap:
        total = total * cap / size
        held = total - dashpot
    return held, total


def rolling_moment(key, held, rolling, elastic, dt):
    """Moment (N m) on the first."""
    cap = C["rolling_friction"] * R * elastic
    if key == "none":
        return 0.0 * held
    if key == "constant-torque":
        size = np.linalg.norm(rolling)
        return -cap * rolling / size if size else 0.0 * held
    held = held - C["rolling_stiffness"] * dt * rolling
    size = np.linalg.norm(held)
    return held * cap / size if size > cap else held


def apart(keys, end, dt, pull):
    """Velocities and spins after the time `end` (s), stepped here in steps of dt (s)."""
    place, velocity, spin = START.copy(), VELOCITY.copy(), SPIN.copy()
    held, turned, before = np.zeros(3), np.zeros(3), 0.0
    for _ in range(round(end / dt)):
        gap = place[0] - place[1]
        distance = np.linalg.norm(gap)
        normal, depth = gap / distance, RADII.sum() - distance
        force, moments = np.zeros(3), np.zeros((2, 3))
        if depth > 0.0:
            arms = RADII - 0.5 * depth * np.array([1.0, 1.0])
            relative = velocity[0] - velocity[1]
            closing = -relative @ normal
            mean = 0.5 * (RADII.sum() - depth) * (spin[0] + spin[1]) + 0.5 * (RADII[0] - RADII[1]) * (spin[0] - spin[1])
            sliding = relative + closing * normal - np.cross(mean, normal)
            across = spin[0] - spin[1]
            across = across - (across @ normal) * normal
            held, turned = (self_ - (self_ @ normal) * normal for self_ in (held, turned))
            elastic, push = normal_force(keys[0], depth, closing)
            held, drag = tangential_force(keys[1], held, sliding, depth, before, elastic, push, dt)
            turned = rolling_moment(keys[2], turned, across, elastic, dt)
            force = (push - pull) * normal + drag
            moments = np.array([np.cross(-arms[0] * normal, drag) + turned, np.cross(-arms[1] * normal, drag) - turned])
        else:
            held, turned = np.zeros(3), np.zeros(3)
        before = max(depth, 0.0)
        velocity += np.array([force, -force]) / MASSES[:, None] * dt
        spin += moments / (0.4 * MASSES * RADII**2)[:, None] * dt
        place += velocity * dt
    return np.hstack([velocity, spin * RADII[:, None]])


def engine_of(keys, dt, integrator="17-18", cohesion="none"):
    laws = Laws.of(normal=keys[0], tangential=keys[1], rolling=keys[2], cohesion=cohesion)
    touch = Contact.taking(laws, C)
    engine = Engine(spheres(START, VELOCITY, SPIN, radius=RADII, pair_contact=touch, wall_contact=touch, dt=dt,
                            integrator=integrator, watched=False), sort=False)  # fmt: skip
    engine._kernel = engine._kernel.py_func  # in Python: a product of laws is not worth a kernel
    return engine


def compare(engine, keys, pull=0.0):
    end = 3.0 * pi * sqrt(M / C["normal_stiffness"])
    engine.step_to(round(end / engine.model.dt))
    found = rows(engine)[:, 3:]
    found = np.hstack([found[:, :3], found[:, 3:] * RADII[:, None]])
    expected = apart(keys, end, engine.model.dt / 4.0, pull)
    changed = np.abs(expected - np.hstack([VELOCITY, SPIN * RADII[:, None]])).max()
    assert changed > 0.02
    assert found == pytest.approx(expected, abs=0.01 * changed)


PRODUCTS = list(product(*(SPHERE_LAWS[family] for family in ("normal", "tangential", "rolling"))))


@pytest.mark.parametrize("keys", PRODUCTS, ids=", ".join)
def test_an_oblique_impact(keys):
    compare(engine_of(keys, 2e-6), keys)


@pytest.mark.parametrize("integrator", INTEGRATORS)
def test_an_oblique_impact_by_every_march(integrator):
    keys = ("hertz", "mindlin-rescaled", "spring-slider")
    compare(engine_of(keys, 1e-6, integrator), keys)


def test_an_oblique_impact_with_a_pull():
    keys = ("hertz", "mindlin", "none")
    compare(engine_of(keys, 1e-6, cohesion="constant-pull"), keys, C["pull"])
