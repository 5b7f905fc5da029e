"""Shaken contents: the estimator against exact motions, and the engine's box against momentum and against a rigid body."""

import numpy as np
import pytest

from silostudy.accuracy.prices import Price
from silostudy.commands.about_grains import prices_of_effects, runs
from silostudy.compute.grains import grains_cube
from silostudy.compute.grains_model import shaken_box_model
from silostudy.seismic.grains import carried_share, equivalent_damping, wall_carried_ring
from tests.conftest import ROOT, expanded

CONTENT = {
    "kind": "grains",
    "title": "a few discs, shaken",
    "scene": {
        "box": {"slenderness": 0.5},
        "packing": "rows_17_18",
        "wall_friction": 0.176,
        "shaking": {"amplitude_gal": 100.0, "frequency_Hz": 4.0},
    },
    "sweep": [{"axis": "frequency", "values": {"shaking.frequency_Hz": [4.0, 200.0]}}],
    "fillings": 2,
}


@pytest.fixture(scope="module")
def cube():
    return grains_cube(expanded(CONTENT))


@pytest.mark.parametrize("cycles", [1, 7])
def test_share_of_a_sine(cycles):
    phase = 2 * np.pi * np.arange(64 * cycles) / 64
    base = 3.0 * np.sin(phase)
    assert carried_share(0.9 * 50 * base + 7.0, base, mass=50.0) == pytest.approx(0.9, rel=1e-12)
    velocity = -np.cos(phase)  # of the base, up to a factor: a quarter period behind its acceleration
    share = carried_share(50 * (0.9 * base + 0.3 * 3.0 * velocity), base, mass=50.0)
    assert share == pytest.approx(0.9 - 0.3j, rel=1e-12)
    assert equivalent_damping(share) == pytest.approx(0.3 / (2 * 0.9), rel=1e-12)
    assert np.isnan(equivalent_damping(0.4 - 0.3j))


def test_damping_is_energy_lost_over_four_pi_kinetic_energy():
    """From the work of the force in one cycle, summed up step by step."""
    omega, mass, amplitude, count = 2 * np.pi * 4.0, 50.0, 3.0, 4096
    t = np.arange(count) / count / 4.0
    base, velocity = amplitude * np.sin(omega * t), -amplitude / omega * np.cos(omega * t)
    force = mass * (0.9 * base + 0.2 * omega * velocity)
    lost = np.sum(force * velocity) * (t[1] - t[0])
    kinetic = 0.5 * 0.9 * mass * (amplitude / omega) ** 2
    assert equivalent_damping(carried_share(force, base, mass=mass)) == pytest.approx(lost / (4 * np.pi * kinetic), rel=1e-9)


def test_share_of_a_broadband_motion():
    base = np.random.default_rng(2).standard_normal(4000)
    noise = 0.1 * np.random.default_rng(3).standard_normal(4000)
    assert carried_share(20 * (0.8 * base + noise), base, mass=20.0).real == pytest.approx(0.8, abs=0.01)


def test_ring():
    assert wall_carried_ring(np.array([100.0, 1e4]), weight=200.0, wall_friction=0.3) == pytest.approx([0.15, 1.0])


def test_ring_of_a_hydrostatic_pressure_is_mu_k_h_over_r():
    """N = pi R K gamma H^2 and W = pi R^2 gamma H, by hand."""
    mu, k, height, radius, gamma = 0.4, 0.45, 6.0, 3.0, 8e3
    force, weight = np.pi * radius * k * gamma * height**2, np.pi * radius**2 * gamma * height
    assert wall_carried_ring(force, weight=weight, wall_friction=mu) == pytest.approx(mu * k * height / radius, rel=1e-12)


def test_force_is_inertia_to_rounding(cube):
    assert float(cube["momentum_error"].max()) < 1e-12


def test_slow_shaking_moves_the_contents_as_one_body(cube):
    slow = cube["carried_in_phase"].isel(frequency=0)
    assert slow.sel(carrier="all").values == pytest.approx(1.0, abs=0.06)
    assert np.all(slow.sel(carrier="walls") > 0.6)
    sums = slow.sel(carrier="walls") + slow.sel(carrier="floor")
    assert sums.values == pytest.approx(slow.sel(carrier="all").values, rel=1e-9)


def test_fast_shaking_leaves_them_behind(cube):
    assert np.all(np.abs(cube["carried_in_phase"].isel(frequency=1).sel(carrier="all")) < 0.5)


def test_fillings_differ_and_repeat(cube):
    shares = cube["carried_in_phase"].isel(frequency=0).sel(carrier="walls").values
    assert shares[0] != shares[1]
    assert grains_cube(expanded(CONTENT)).identical(cube)


def test_what_a_study_will_cost(monkeypatch):
    """Two fillings at rest within 2 s, each shaken twice: 8 cycles of 4 Hz and of 200 Hz at the model's own step."""
    expansion = expanded(CONTENT)
    model = shaken_box_model(expansion.cases[0].scene.config, 1)
    discs, longest = len(model.x), round(2.0 / model.dt)
    lines = runs(expansion)
    assert lines[0] == f"2 filling(s) of {discs} discs, settled in at most {longest:,} steps; equal fillings once"
    slow, fast = round(8 / 4 / model.dt), round(8 / 200 / model.dt)
    assert lines[1].startswith(f"4 shaken run(s) of {fast:,} to {slow:,} steps: ")
    work = 2 * discs * (longest + slow + fast)
    assert f"at most {work:.2g} particle-steps" in lines[1]
    monkeypatch.setattr("silostudy.compute.grains.settled_model", lambda *_: model)
    monkeypatch.setattr("silostudy.accuracy.prices.prices", lambda _: (discs * 5e-9, {"shaking": Price(0.25, 0.2, 0.3, 0.1)}))
    assert lines[2].endswith("no others: friction, rotation, history; shaking; wall forces every step")
    timed = prices_of_effects(expansion)
    assert timed[0] == f"5 ns a particle-step here and now: at most {5e-9 * work:,.0f} s on one core, and the compiling"
    assert "shaking" in timed[1]
    assert "25.0% of a step" in timed[1]


def test_studies_are_valid_and_figure_draws(cube, tmp_path):
    from silostudy.choice.expand import expand_file
    from silostudy.figures import grains_effective_mass

    for path in sorted((ROOT / "config/studies").glob("grains-*.yaml")):
        assert expand_file(path).study.outputs == ("grains_effective_mass",)
    grains_effective_mass.draw(cube, tmp_path / "grains")
    assert (tmp_path / "grains.png").stat().st_size > 10_000
    assert "walls_in_phase" in (tmp_path / "grains.csv").read_text().splitlines()[0]
