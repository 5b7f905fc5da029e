"""Responses against exact ones: ramps and steps in closed form, steady sines, and an integrator that knows nothing of modes."""

import os
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from scipy.integrate import solve_ivp

from silostudy.seismic.beam import modes
from silostudy.seismic.response import absolute_acceleration, internal_forces, oscillators, refined, transfer
from tests.test_seismic.test_beam import MODEL

EL_CENTRO = Path(os.environ.get("SILOSTUDY_EL_CENTRO", ""))  # a record of two columns, s and g, that is not shipped
FREQUENCIES = np.array([0.001, 0.2, 1.0, 7.0, 300.0])  # Hz, far below to far above the sampling


def ramp_response(t, natural: float, damping: float, slope: float):
    """Displacement (m) under a base acceleration slope * t, from rest: the textbook's closed form."""
    damped = natural * np.sqrt(1 - damping**2)
    decay = np.exp(-damping * natural * t)
    turning = 2 * damping / natural * np.cos(damped * t) + (2 * damping**2 - 1) / damped * np.sin(damped * t)
    return -slope / natural**2 * (t - 2 * damping / natural + decay * turning)


@pytest.mark.parametrize("damping", [0.0, 0.02, 0.3])
def test_ramp_is_exact_at_any_step(damping):
    for dt, count in ((0.5, 21), (0.01, 1001)):
        t = dt * np.arange(count)
        found, _ = oscillators(3.0 * t, dt, FREQUENCIES[1:], damping)
        for row, frequency in zip(found, FREQUENCIES[1:], strict=True):
            exact = ramp_response(t, 2 * np.pi * frequency, damping, 3.0)
            assert row == pytest.approx(exact, rel=1e-9, abs=1e-9 * np.abs(exact).max())


@pytest.mark.parametrize("frequency", FREQUENCIES)
def test_piecewise_linear_motion_is_exact_against_segments(frequency):
    """Displacement and velocity against a Runge-Kutta solution at 1e-11, segment by segment."""
    random = np.random.default_rng(3)
    acceleration, dt, damping = random.standard_normal(12), 0.02, 0.05
    natural = 2 * np.pi * frequency
    state, exact = np.zeros(2), [np.zeros(2)]
    for start, end in pairwise(acceleration):

        def rates(t, y, start=start, end=end):
            return [y[1], -(start + (end - start) * t / dt) - 2 * damping * natural * y[1] - natural**2 * y[0]]

        state = solve_ivp(rates, (0, dt), state, method="DOP853", rtol=1e-11, atol=1e-18).y[:, -1]
        exact.append(state)
    displacement, velocity = oscillators(acceleration, dt, [frequency], damping)
    for found, wanted in ((displacement[0], np.array(exact)[:, 0]), (velocity[0], np.array(exact)[:, 1])):
        assert found == pytest.approx(wanted, abs=1e-8 * np.abs(wanted).max())


def test_response_does_not_depend_on_the_step():
    """At the record's own instants the refined motion gives the same response, so the step only chooses where to look."""
    random = np.random.default_rng(4)
    base, dt = random.standard_normal(300), 0.002
    shapes = modes(MODEL, 0.7, 0.026)
    coarse = absolute_acceleration(base, dt, shapes, 0.02)[0]
    fine_base, fine_dt = refined(base, dt, 500.0)
    assert dt / fine_dt == pytest.approx(40)
    fine = absolute_acceleration(fine_base, fine_dt, shapes, 0.02)[0]
    assert fine[::40] == pytest.approx(coarse, abs=1e-9 * np.abs(coarse).max())
    assert np.abs(fine).max() >= np.abs(coarse).max()  # the true peak is no lower than the sampled one


def test_true_peak_is_within_its_stated_accuracy():
    """Steady response of one mode to a sine sampled coarsely: the peak between samples is found within 1 - cos(pi/40)."""
    frequency, base_frequency, dt = 10.0, 9.7, 0.0117
    t = np.arange(0, 30, dt)
    fine, step = refined(np.sin(2 * np.pi * base_frequency * t), dt, frequency)
    seen = np.abs(oscillators(fine, step, [frequency], 0.05)[0][0][len(fine) // 2 :]).max()
    finest = np.interp(np.arange(0, t[-1], dt / 200), t, np.sin(2 * np.pi * base_frequency * t))
    true = np.abs(oscillators(finest, dt / 200, [frequency], 0.05)[0][0][len(finest) // 2 :]).max()
    assert 1 - (1 - np.cos(np.pi / 40)) <= seen / true <= 1 + 1e-6


def test_steady_sine_comes_to_the_transfer_function():
    shapes = modes(MODEL, 0.7, 0.026)
    dt = 1e-4
    for frequency in (12.0, shapes.frequency[0], 40.0):
        t = np.arange(0, 4, dt)
        top = absolute_acceleration(np.sin(2 * np.pi * frequency * t), dt, shapes, 0.05)[0]
        gain = abs(transfer([frequency], shapes, 0.05)[0, 0])
        assert np.abs(top[len(t) // 2 :]).max() == pytest.approx(gain, rel=1e-3)


def test_transfer_at_the_ends():
    """A slow base carries the top along; at resonance one mode and its share decide; the base moves as the base."""
    shapes = modes(MODEL, 0.7, 0.026, heights=np.array([0.0, MODEL.height]))
    assert transfer([1e-3], shapes, 0.02)[0] == pytest.approx([1, 1], rel=1e-6)
    assert abs(transfer([20.0], shapes, 0.02)[0, 0]) == pytest.approx(1, rel=1e-9)
    share = float((shapes.displacement * shapes.participation)[1, 0])
    assert abs(transfer([shapes.frequency[0]], shapes, 0.001)[0, 1]) == pytest.approx(share / 0.002, rel=0.01)


def test_base_shear_is_what_the_masses_ask_for():
    """The wall's shear at the base against the inertia of the absolute accelerations, summed over the height."""
    random = np.random.default_rng(5)
    base, dt = np.convolve(random.standard_normal(400), np.ones(20) / 20, mode="same"), 0.005
    points, weights = np.polynomial.legendre.leggauss(40)
    height = MODEL.height * (points + 1) / 2
    shapes = modes(MODEL, 0.0, 0.026, heights=np.append(height, 0.0))
    shear, moment = internal_forces(base, dt, shapes, 0.0)
    inertia = absolute_acceleration(base, dt, shapes, 0.0)[:-1]
    per_length = MODEL.wall_density * 2 * np.pi * MODEL.radius * MODEL.thickness
    needed = (weights * MODEL.height / 2 * per_length) @ inertia
    assert -shear[-1] == pytest.approx(needed, abs=0.01 * np.abs(needed).max())
    assert np.abs(moment[-1]).max() > 0.4 * MODEL.height * np.abs(needed).max()


@pytest.mark.skipif(not EL_CENTRO.is_file(), reason="the record is not at hand")
def test_el_centro_spectrum_ordinate():
    """One oscillator on a long real record, against a Runge-Kutta solution."""
    t, a = np.loadtxt(EL_CENTRO).T
    a, dt, natural = a[:500] * 9.80665, 0.02, 2 * np.pi / 0.5

    def rates(time, y):
        return [y[1], -np.interp(time, t[:500], a) - 2 * 0.02 * natural * y[1] - natural**2 * y[0]]

    exact = solve_ivp(rates, (0, t[499]), [0, 0], t_eval=t[:500], max_step=dt / 2, rtol=1e-9, atol=1e-12).y[0]
    found = oscillators(a, dt, [2.0], 0.02)[0][0]
    assert found == pytest.approx(exact, abs=1e-5 * np.abs(exact).max())


def test_opensees_gives_the_same_beam_and_history():
    """An independent program: 60 Timoshenko elements (lumped mass) for the frequency, one oscillator for the history."""
    ops = pytest.importorskip("openseespy.opensees")
    area = 2 * np.pi * MODEL.radius * MODEL.thickness
    inertia = np.pi * MODEL.radius**3 * MODEL.thickness * (1 + MODEL.thickness**2 / (4 * MODEL.radius**2))
    count, density = 60, MODEL.wall_density
    ops.wipe()
    ops.model("basic", "-ndm", 2, "-ndf", 3)
    ops.geomTransf("Linear", 1)
    step, shear_modulus = MODEL.height / count, MODEL.youngs_modulus / (2 * (1 + MODEL.poisson_ratio))
    for node in range(count + 1):
        ops.node(node, 0.0, node * step)
        share = step * density * (0.5 if node == count else 1.0)
        ops.mass(node, share * area, 1e-9, share * inertia)
    ops.fix(0, 1, 1, 1)
    for element in range(count):
        ops.element("ElasticTimoshenkoBeam", element, element, element + 1, MODEL.youngs_modulus, shear_modulus, area, inertia,
                    MODEL.shear_factor * area, 1)  # fmt: skip
    theirs = np.sqrt(ops.eigen("-fullGenLapack", 2)) / (2 * np.pi)
    ops.wipe()
    assert theirs[1] > 2 * theirs[0]
    assert modes(MODEL, 0.0).frequency[:2] == pytest.approx(theirs, rel=2e-3)


def test_opensees_gives_the_same_history():
    """One oscillator under a random piecewise linear motion; their Newmark steps are a fortieth of ours."""
    ops = pytest.importorskip("openseespy.opensees")
    base, dt, frequency, damping = np.random.default_rng(6).standard_normal(200), 0.01, 4.0, 0.03
    natural = 2 * np.pi * frequency
    ops.wipe()
    ops.model("basic", "-ndm", 1, "-ndf", 1)
    ops.node(1, 0.0)
    ops.node(2, 0.0, "-mass", 1.0)
    ops.fix(1, 1)
    ops.uniaxialMaterial("Elastic", 1, natural**2, 2 * damping * natural)
    ops.element("zeroLength", 1, 1, 2, "-mat", 1, "-dir", 1)
    ops.timeSeries("Path", 1, "-dt", dt, "-values", *map(float, base), "-factor", 1.0)
    ops.pattern("UniformExcitation", 1, 1, "-accel", 1)
    ops.constraints("Plain")
    ops.numberer("Plain")
    ops.system("FullGeneral")
    ops.algorithm("Linear")
    ops.integrator("Newmark", 0.5, 0.25)
    ops.analysis("Transient")
    theirs = [0.0]
    for _ in range(len(base) - 1):
        assert ops.analyze(40, dt / 40) == 0
        theirs.append(ops.nodeDisp(2, 1))
    ops.wipe()
    ours = oscillators(base, dt, [frequency], damping)[0][0]
    assert ours == pytest.approx(np.array(theirs), abs=2e-3 * np.abs(ours).max())
