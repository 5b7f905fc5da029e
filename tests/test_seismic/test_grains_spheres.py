"""Shaken round silos of spheres: forces against momentum and against patterns by hand, shares, mistakes."""

import numpy as np
import pytest

from silostudy.commands.about_grains import runs
from silostudy.compute.grains import grains_cube
from silostudy.compute.grains_model import pushes, shaken_box_model
from silostudy.errors import BadInput
from silostudy.figures import grains_effective_mass
from silostudy.scene.grains_spheres import AROUND
from tests.conftest import expanded, with_changes

CONTENT = {
    "kind": "grains",
    "title": "a few spheres, shaken",
    "scene": {
        "grains": "spheres",
        "box": {"diameter_m": 0.03, "slenderness": 0.5},
        "grain": {"youngs_modulus_MPa": 5, "poissons_ratio": 0.3, "density_kg_m3": 1350},
        "wall": {"youngs_modulus_MPa": 200000, "poissons_ratio": 0.3},
        "spheres": {"restitution": 0.3, "sliding_friction": 0.45},
        "walls": {"restitution": 0.3, "sliding_friction": 0.25},
        "sizes": {"kind": "uniform", "least_mm": 4, "largest_mm": 5},
        "shaking": {"amplitude_gal": 200.0, "frequency_Hz": 20.0},
    },
    "sweep": [{"axis": "slenderness", "values": {"box.slenderness": [0.5, 1.5]}}],
    "fillings": 2,
    "cycles": 2,
    "waited_cycles": 1,
    "outputs": ["grains_effective_mass"],
}

HALF = {"scene__step_factor": 0.5}


def content(**changes):
    """The small study with other values; `scene__box` is the key `box` of its scene."""
    return with_changes(CONTENT, changes)


@pytest.fixture(scope="module")
def cube():
    return grains_cube(expanded(CONTENT))


def test_pushes_of_patterns_by_hand():
    """Around the wall a pressing p cos(turn) pulls by -p n/2 of n cells, a drag q sin(turn) by -q n/2; of the floor
    a shear t cos(turn) outward pulls by t n/2."""
    config = expanded(CONTENT).cases[0].scene.config
    model = shaken_box_model(config, 1)
    turn = 2 * np.pi * (np.arange(AROUND) + 0.5) / AROUND
    window = np.zeros((2 * AROUND, 3))
    of_wall = next(number for number, wall in enumerate(model.walls) if wall.name == "wall")
    wall, floor = (window[number * AROUND : (number + 1) * AROUND] for number in (of_wall, 1 - of_wall))
    wall[:, 0], wall[:, 2] = 7.0 + 3.0 * np.cos(turn), 2.0 * np.sin(turn)
    floor[:, 0], floor[:, 1], floor[:, 2] = 11.0, 5.0 * np.cos(turn), 1.0 * np.sin(turn)
    half = AROUND / 2
    assert pushes(config, model, window) == pytest.approx((-5.0 * half, 4.0 * half, 7.0 * AROUND), rel=1e-12)


def test_a_step_factor_shortens_the_step():
    whole, half = (shaken_box_model(expanded(content(**more)).cases[0].scene.config, 1) for more in ({}, HALF))
    assert half.dt == pytest.approx(0.5 * whole.dt, rel=1e-12)


def test_force_is_inertia_but_for_the_width_of_cells(cube):
    """A cell of two degrees turns a contact's force by a degree at most: with 100 contacts a few percent of 0.2 g."""
    assert 0 < float(cube["momentum_error"].max()) < 0.03


def test_slow_shaking_moves_the_contents_as_one_body(cube):
    shares = cube["carried_in_phase"]
    assert shares.sel(carrier="all").values == pytest.approx(1.0, abs=0.05)
    sums = shares.sel(carrier="walls") + shares.sel(carrier="floor")
    assert sums.values == pytest.approx(shares.sel(carrier="all").values, rel=1e-9)
    low, high = shares.sel(carrier="walls").mean("filling").values
    assert 0.3 < low < high < 1.05
    assert cube["came_to_rest"].values.all()


def test_fillings_differ_and_motions_share_them(cube):
    shares = cube["carried_in_phase"].sel(carrier="walls").values
    assert (shares[:, 0] != shares[:, 1]).all()
    twice = content(sweep=[{"axis": "amplitude", "values": {"shaking.amplitude_gal": [100.0, 200.0]}}])
    again = grains_cube(expanded(twice))
    assert again["settled_slenderness"].values[0].tolist() == cube["settled_slenderness"].values[0].tolist()
    assert again["carried_in_phase"].values[1].tolist() == cube["carried_in_phase"].values[0].tolist()
    assert again["ring_share"].values[0] == pytest.approx(again["ring_share"].values[1], rel=0.02)


def test_what_a_study_will_cost():
    lines = runs(expanded(CONTENT))
    assert lines[0].startswith("4 filling(s) of ")
    assert " spheres, settled" in lines[0]
    assert "shaking" in lines[2]


def test_figure_names_spheres(cube, tmp_path):
    grains_effective_mass.draw(cube, tmp_path / "spheres")
    assert "Spheres in a rigid round silo" in (tmp_path / "spheres.svg").read_text()


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"scene__grains": "sphere"}, "scene.grains"),
        ({"scene__grain__density_kg_m3": None}, "grain.density_kg_m3"),
        ({"scene__box__width_m": 0.03}, "scene.box.width_m"),
        ({"scene__sizes__largest_mm": 40.0}, "sizes.largest_mm = 40.0: a sphere of 38.2167 mm is wider than the silo, 30 mm"),
        ({"scene__shaking__frequency_Hz": None}, "either frequency_Hz or record"),
    ],
)
def test_mistakes_are_told_before_any_work(changes, told):
    with pytest.raises(BadInput) as caught:
        expanded(content(**changes))
    assert told in str(caught.value)
