"""The eight impacts of Chung & Ooi (2011), done with discs.

Their spheres follow Hertz and Mindlin, our discs linear laws.  What carries over is the list of impacts with its radii,
densities, speeds, frictions and restitutions, as read in the examples of other programs (1-4 in Yade's, 5-8 in PySPH's).
The answers come from the contact alone: one body of reduced mass, the closed half-wave of the normal force, a slider in
one dimension; where a contact slips or sticks throughout, also from its closed form.
"""

from dataclasses import dataclass
from math import atan2, cos, exp, log, pi, sin, sqrt

import numpy as np
import pytest
from scipy.optimize import brentq

from silostudy.dem.engine import Engine
from silostudy.dem.lanes import U, V, W
from silostudy.dem.model import Contact, Model, Wall
from silostudy.dem.pieces import Laws

from .scenes import rows

SHALLOW = 1e-5  # of a radius: the deepest overlap, so that arms are radii and the normal does not turn
LAWS = Laws.of(tangential="spring-slider-total")
STEPS = 4000  # of a contact
SPINS = np.array([0.175, 0.3, 0.7, 1.3, 2.0, 3.0, 4.0, 5.0, 7.0, 9.0, 12.0, 22.0])  # 1/s


def restitution(zeta):
    """Of a spring and dashpot that never pulls (Schwager & Poeschel 2007), zeta below one."""
    root = sqrt(1.0 - zeta**2)
    return exp(-zeta / root * atan2(2.0 * zeta * root, 2.0 * zeta**2 - 1.0)) if zeta else 1.0


def damping_ratio(e):
    return 0.0 if e == 1.0 else brentq(lambda zeta: log(restitution(zeta)) - log(e), 1e-9, 0.999)


@dataclass(frozen=True)
class Touch:
    """A contact: reduced mass (kg/m), deepest overlap (m), stiffness ratio, restitution, friction, closing speed (m/s)."""

    mass: float
    deep: float
    ratio: float
    e: float
    friction: float
    closing: float

    @property
    def stiffness(self):
        return self.mass * (self.closing / self.deep) ** 2

    @property
    def damping(self):
        return 2.0 * damping_ratio(self.e) * sqrt(self.mass * self.stiffness)

    @property
    def duration(self):
        wave, zeta = self.closing / self.deep, damping_ratio(self.e)
        root = sqrt(1.0 - zeta**2)
        return atan2(2.0 * zeta * root, 2.0 * zeta**2 - 1.0) / (wave * root) if zeta else pi / wave

    @property
    def law(self):
        stiffness, damping = self.stiffness, self.damping
        normal = {"normal_stiffness": stiffness, "normal_damping": damping, "normal_damping_root": 0.0}
        along = {"tangential_stiffness": self.ratio * stiffness, "tangential_damping": 0.0, "tangential_damping_root": 0.0}
        return Contact(LAWS, {**normal, **along, "sliding_friction": self.friction})

    def force(self, t):
        """Normal force (N/m) after t (s)."""
        wave, zeta = self.closing / self.deep, damping_ratio(self.e)
        turn = wave * sqrt(1.0 - zeta**2)
        overlap = self.closing / turn * exp(-zeta * wave * t) * sin(turn * t)
        speed = self.closing * exp(-zeta * wave * t) * cos(turn * t) - zeta * wave * overlap
        return self.stiffness * overlap + self.damping * speed

    def impulse(self, slip, steps=20000):
        """Tangential impulse (N s/m) against each slip (m/s): a spring behind a slider, marched in one dimension."""
        dt, mass = self.duration / steps, self.mass / 3.0  # each disc's 1/m + r2/I is 3/m
        slip, held, total = slip.copy(), np.zeros_like(slip), np.zeros_like(slip)
        for k in range(steps):
            cap = self.friction * self.force((k + 0.5) * dt)
            held = np.clip(held + self.ratio * self.stiffness * dt * slip, -cap, cap)
            slip -= held / mass * dt
            total += held * dt
        return total


def disc(radius, density):
    """Mass (kg/m) and moment of inertia (kg m2/m)."""
    mass = density * pi * radius**2
    return mass, 0.5 * mass * radius**2


def on_plane(touch, radius, density, u, v, w):
    """Motions after discs (far apart) struck a floor."""
    x = 4.0 * radius * np.arange(len(u))
    floor = Wall("floor", (-radius, 0.0), (x[-1] + radius, 0.0))
    dt = touch.duration / STEPS
    model = Model(
        x, np.full(len(u), radius), np.full(len(u), radius), density, (floor,), touch.law, touch.law, dt,
        gravity=(0.0, 0.0), u=u, v=v, w=w,
    )  # fmt: skip
    engine = Engine(model)
    engine.step_to(round(1.2 * STEPS))
    return rows(engine)[:, [U, V, W]].T


def pair(touch, radii, densities, closing, spins):
    """Motions of both discs after they met head on, spinning."""
    wall = Wall("far", (-1e3, -1e3), (1e3, -1e3))
    after = []
    for spin in spins:
        model = Model(
            np.array([-radii[0], radii[1]]), np.zeros(2), np.array(radii), densities, (wall,), touch.law, touch.law,
            touch.duration / STEPS, gravity=(0.0, 0.0), u=np.array(closing), w=np.array(spin),
        )  # fmt: skip
        engine = Engine(model)
        engine.step_to(round(1.2 * STEPS))
        after.append(rows(engine)[:, [U, V, W]])
    return np.array(after)


def assert_oblique(touch, radius, density, u, v, w):
    """Every motion after an oblique impact on a plane against that of the contact alone."""
    mass, inertia = disc(radius, density)
    after_u, after_v, after_w = on_plane(touch, radius, density, u, v, w)
    impulse = touch.impulse(u + radius * w)
    np.testing.assert_allclose(after_v, -touch.e * v, rtol=1e-3)
    largest = np.abs(u + radius * w).max()
    np.testing.assert_allclose(after_u, u - impulse / mass, rtol=2e-3, atol=5e-4 * largest)
    np.testing.assert_allclose(after_w, w - impulse * radius / inertia, rtol=2e-3, atol=5e-4 * largest / radius)
    assert (np.abs(u + radius * w) > 3.0 * touch.friction * (1.0 + touch.e) * np.abs(v)).any()  # slips throughout
    assert (np.abs(u + radius * w) < touch.friction * np.abs(v)).any()  # sticks


def test_1_two_discs_meet_without_loss():
    """Glass, radius 10 mm, 10 m/s each: they change their speeds; force and time of a half-wave."""
    mass, _ = disc(0.010, 2800.0)
    touch = Touch(mass / 2.0, 0.010 * SHALLOW, 0.25, 1.0, 0.35, 20.0)
    ((first, second),) = pair(touch, (0.010, 0.010), 2800.0, (10.0, -10.0), [(0.0, 0.0)])
    np.testing.assert_allclose([first[0], second[0]], [-10.0, 10.0], rtol=1e-3)
    assert not first[1:].any()
    assert not second[1:].any()
    assert touch.duration == pytest.approx(pi * sqrt(mass / 2.0 / touch.stiffness))


def test_2_a_disc_meets_a_plane_without_loss():
    """Aluminium alloy, radius 100 mm, 0.2 m/s."""
    touch = Touch(disc(0.10, 2699.0)[0], 0.10 * SHALLOW, 0.25, 1.0, 0.0, 0.2)
    u, v, w = on_plane(touch, 0.10, 2699.0, np.zeros(1), np.full(1, -0.2), np.zeros(1))
    np.testing.assert_allclose(v, 0.2, rtol=1e-3)
    assert not u.any()
    assert not w.any()


@pytest.mark.parametrize("e", [0.2, 0.4, 0.6, 0.8, 1.0])
def test_3_a_disc_meets_a_plane_at_a_restitution(e):
    """Aluminium oxide, radius 2.5 mm, 3.9 m/s."""
    touch = Touch(disc(0.0025, 4000.0)[0], 0.0025 * SHALLOW, 0.25, e, 0.0, 3.9)
    _, v, _ = on_plane(touch, 0.0025, 4000.0, np.zeros(1), np.full(1, -3.9), np.zeros(1))
    np.testing.assert_allclose(v, 3.9 * e, rtol=1e-3)


@pytest.mark.parametrize("ratio", [0.25, 1.0])
def test_4_oblique_impact_at_angles_from_5_to_85_degrees(ratio):
    """Aluminium oxide, radius 2.5 mm, 3.9 m/s along its way, friction 0.092, restitution 0.98; each angle closes at its own
    speed, which a linear contact meets with the same stiffness."""
    angle = np.radians([5.0, 10.0, 15.0, 20.0, 25.0, 30.0, 40.0, 50.0, 60.0, 70.0, 80.0, 85.0])
    mass, inertia = disc(0.0025, 4000.0)
    touch = Touch(mass, 0.0025 * SHALLOW, ratio, 0.98, 0.092, 3.9)
    u, v, w = on_plane(touch, 0.0025, 4000.0, 3.9 * np.sin(angle), -3.9 * np.cos(angle), np.zeros(len(angle)))
    impulse = np.cos(angle) * touch.impulse(3.9 * np.tan(angle))  # of an impact that closes at 3.9 m/s, scaled
    np.testing.assert_allclose(v, 0.98 * 3.9 * np.cos(angle), rtol=1e-3)
    np.testing.assert_allclose(u, 3.9 * np.sin(angle) - impulse / mass, rtol=2e-3)
    np.testing.assert_allclose(w, -impulse * 0.0025 / inertia, rtol=2e-3, atol=5e-4 * 3.9 / 0.0025)


@pytest.mark.parametrize("ratio", [0.25, 1.0])
def test_5_oblique_impact_at_one_normal_and_many_tangential_speeds(ratio):
    touch = Touch(disc(0.01, 2500.0)[0], 0.01 * SHALLOW, ratio, 0.8, 0.3, 5.0)
    u = 5.0 * np.array([0.05, 0.1, 0.3, 0.6, 0.9, 1.2, 1.5, 2.0, 2.5, 4.0, 7.0])
    assert_oblique(touch, 0.01, 2500.0, u, np.full(len(u), -5.0), np.zeros(len(u)))


@pytest.mark.parametrize("ratio", [0.25, 1.0])
def test_6_a_spinning_disc_meets_a_plane(ratio):
    """Radius 100 mm, 0.2 m/s, restitution 0.5, friction 0.4."""
    touch = Touch(disc(0.1, 2700.0)[0], 0.1 * SHALLOW, ratio, 0.5, 0.4, 0.2)
    assert_oblique(touch, 0.1, 2700.0, np.zeros(len(SPINS)), np.full(len(SPINS), -0.2), SPINS)


def test_7_two_equal_discs_meet_with_opposite_spins():
    """Radius 100 mm, 0.2 m/s each, restitution 0.5, friction 0.4: surfaces that run the same way do not rub, others do."""
    mass, inertia = disc(0.1, 2700.0)
    touch = Touch(mass / 2.0, 0.1 * SHALLOW, 0.25, 0.5, 0.4, 0.4)
    against = pair(touch, (0.1, 0.1), 2700.0, (0.2, -0.2), [(spin, -spin) for spin in SPINS])
    np.testing.assert_array_equal(against[:, :, 1], 0.0)
    np.testing.assert_array_equal(against[:, 0, 2], SPINS)
    alike = pair(touch, (0.1, 0.1), 2700.0, (0.2, -0.2), [(spin, spin) for spin in SPINS])
    impulse = touch.impulse(2.0 * 0.1 * SPINS)
    for k, way in ((0, 1.0), (1, -1.0)):
        np.testing.assert_allclose(np.abs(alike[:, k, 1]), impulse / mass, rtol=3e-3, atol=2e-3 * 0.1 * SPINS.max())
        np.testing.assert_allclose(alike[:, k, 2], SPINS - impulse * 0.1 / inertia, rtol=3e-3, atol=2e-3 * SPINS.max())
        np.testing.assert_allclose(alike[:, k, 0], -way * 0.1, rtol=1e-3)


def test_8_two_discs_of_different_size_meet():
    """Radii 100 and 500 mm, the larger at rest: momentum passes over, and the spin of both changes with their arms."""
    (mass, inertia), (heavy, slow) = disc(0.1, 2700.0), disc(0.5, 2700.0)
    reduced = mass * heavy / (mass + heavy)
    touch = Touch(reduced, 0.1 * SHALLOW, 0.25, 0.5, 0.4, 0.2)
    after = pair(touch, (0.1, 0.5), 2700.0, (0.2, 0.0), [(spin, 0.0) for spin in SPINS])
    impulse, push = touch.impulse(0.1 * SPINS), 1.5 * 0.2 * reduced
    np.testing.assert_allclose(after[:, 0, 0], 0.2 - push / mass, rtol=2e-3)
    np.testing.assert_allclose(after[:, 1, 0], push / heavy, rtol=2e-3)
    np.testing.assert_allclose(np.abs(after[:, 0, 1]), impulse / mass, rtol=3e-3, atol=2e-3 * 0.1 * SPINS.max())
    np.testing.assert_allclose(np.abs(after[:, 1, 1]), impulse / heavy, rtol=3e-3, atol=2e-3 * 0.1 * SPINS.max())
    np.testing.assert_allclose(after[:, 0, 2], SPINS - impulse * 0.1 / inertia, rtol=3e-3, atol=2e-3 * SPINS.max())
    np.testing.assert_allclose(np.abs(after[:, 1, 2]), impulse * 0.5 / slow, rtol=3e-3, atol=1e-3)


def test_a_contact_that_sticks_throughout_swings_back_as_an_oscillator():
    """The reference itself: with friction that never yields the slip ends as slip * cos(turns of the tangential spring)."""
    touch = Touch(1.0, 1e-7, 0.25, 1.0, 1e3, 1.0)
    slip = np.array([1e-3])
    left = slip - touch.impulse(slip) * 3.0
    assert left[0] == pytest.approx(slip[0] * cos(pi * sqrt(3.0 * 0.25)), rel=1e-3)
