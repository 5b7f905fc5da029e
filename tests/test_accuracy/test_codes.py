"""The engine beside LAMMPS: how places are read, that both start alike, and that the shipped table is of the shipped study."""

import numpy as np
import pytest

from silostudy.accuracy import codes
from silostudy.accuracy.laws_in_lammps import SAME_LAW, CannotSay, told_where_cut, words
from silostudy.accuracy.peers import available
from silostudy.accuracy.walls_in_lammps import holed
from silostudy.choice.expand import expand_file
from silostudy.commands.bench_codes import FILLINGS, differences
from silostudy.compute.dem import scene_model
from silostudy.contact import elastic
from silostudy.dem.space.level import Hole, LevelPiece, Outline
from silostudy.dem.space.rows import CIRCLE
from silostudy.scene.spheres import space_silo_of
from silostudy.tables.code_differences import CODE_DIFFERENCES
from tests.conftest import ROOT

STUDY = ROOT / "config/studies/spheres-ladders.yaml"
OF_CONTRACT = {codes.AT_REST, codes.LARGEST, "unit_weight_at_rest", "mean_mass_flow"}


@pytest.fixture(scope="module")
def first():
    return expand_file(STUDY, [0])


@pytest.fixture(scope="module")
def scene(first):
    return first.cases[0].scene.config


def test_the_table_is_of_the_shipped_study(first):
    assert {told.study for told in CODE_DIFFERENCES} == {first.study.title}
    assert {told.fillings for told in CODE_DIFFERENCES} == {FILLINGS}
    assert {told.quantity for told in CODE_DIFFERENCES} >= OF_CONTRACT


def test_differences_are_those_of_the_means():
    fillings = [{"silostudy": {"force": 2.0 + k}, "LAMMPS": {"force": 2.2 + k}} for k in (-0.1, 0.0, 0.1)]
    (row,) = differences(fillings)
    assert row["change"] == pytest.approx(0.1)
    assert row["half_interval"] == pytest.approx(2.7764 * 0.1 * np.sqrt(2.0 / 3.0) / 2.0, rel=1e-4)
    assert row["silostudy_scatter"] == pytest.approx(0.05)


def test_wall_forces_are_hertz_forces_in_their_cells(scene):
    model, space = scene_model(scene, STUDY.parent), space_silo_of(scene)
    places, depth = np.c_[model.x, model.y, model.z], 1e-5
    assert not codes.wall_forces(model, space, scene, places).any()
    radius, wide = float(model.radius[0]), 0.05
    places[7] = 0.0, wide - radius + depth, 0.1
    places[8] = np.nan
    force = codes.wall_forces(model, space, scene, places)
    modulus = elastic.contact_modulus(1e7, 0.3, 2e11, 0.3)
    reduced = 1.0 / (1.0 / radius - 0.5 / wide)
    assert force[int(0.1 / (space.top / 20)), 6] == pytest.approx(4.0 / 3.0 * modulus * np.sqrt(reduced) * depth**1.5, rel=1e-9)
    assert np.count_nonzero(force) == 1


def test_spheres_pass_when_they_are_seen_below(scene):
    model = scene_model(scene, STUDY.parent)
    places = np.full((4, len(model.x), 3), 0.1)
    places[2:, 5, 2] = -0.001
    places[1:, 9] = np.nan
    times, mass = codes.passages(model, np.arange(4.0), places)
    assert times.tolist() == [1.0, 2.0]
    assert mass == pytest.approx([model.mass[0]] * 2)


def test_looks_share_each_window_out_evenly():
    steps = codes.looked_at(window=606, opening=2000, stop=5000)
    assert len(steps) == (5000 - 1212) * codes.LOOKS // 606
    assert steps[codes.LOOKS - 1 :: codes.LOOKS].tolist() == [1818, 2424, 3030, 3636, 4242, 4848]
    assert set(np.diff(steps).tolist()) == {15, 16}


def test_rest_and_flow_are_of_whole_windows(scene):
    """All spheres press the wall alike, twice as hard in the window of the opening, three times in the first of flow."""
    model, space = scene_model(scene, STUDY.parent), space_silo_of(scene)
    steps = codes.looked_at(window=80, opening=200, stop=400)
    times = (steps - 200) * model.dt
    depth = 1e-5 * np.select([steps <= 160, steps <= 240, steps <= 320], [1.0, 2.0, 3.0], 1.0) ** (2.0 / 3.0)
    turn = np.linspace(0.0, 2.0 * np.pi, len(model.x))
    out = 0.05 - model.radius + depth[:, None]
    places = np.stack([out * np.cos(turn), out * np.sin(turn), np.broadcast_to(model.z, out.shape)], axis=-1)
    read = codes.readings(model, space, scene, times, places)
    assert read[codes.LARGEST] == pytest.approx(3.0 * read[codes.AT_REST])
    assert read[codes.AT_REST] == pytest.approx(codes.wall_forces(model, space, scene, places[0]).sum())
    ring = codes.wall_forces(model, space, scene, places[0]).sum(axis=1).max()
    assert read["largest_pressure_ring"] == pytest.approx(3.0 * ring / (0.1 * np.pi * 0.3 / 20))


def test_windows_are_whole():
    assert codes.in_windows(np.arange(7.0)[:, None, None], 3).ravel().tolist() == [1.0, 4.0]


def test_the_dashpot_that_is_cut_is_told_by_another_restitution(scene):
    told = told_where_cut(0.5)
    assert elastic.damping_where_pulled(told) == pytest.approx(elastic.damping_where_cut(0.5), rel=1e-12)
    pair, wall = words(scene, SAME_LAW, 0.004)
    assert pair.endswith("limit_damping")
    assert float(wall.split()[2]) == pytest.approx(told)
    with pytest.raises(CannotSay, match="so strong"):
        told_where_cut(0.001)


def test_a_floor_around_its_outlet_is_a_cone_that_hardly_rises():
    def outline(half):
        return Outline(sides=int(CIRCLE), half=(half, half))

    floor = LevelPiece(name="floor", height=0.0, outline=outline(0.05), holes=(Hole(name="outlet", outline=outline(0.02)),))
    kind, axis, *numbers = holed(floor, ("outlet",)).split()[:8]
    assert (kind, axis) == ("cone", "z")
    assert [float(number) for number in numbers] == pytest.approx([0.0, 0.0, 0.02, 0.05, -5e-11, 0.0], abs=1e-15)
    with pytest.raises(CannotSay, match="outlet of a flat floor"):
        holed(floor, ())


@pytest.mark.long
@pytest.mark.skipif(bool(available()), reason=available() or "installed")
def test_both_codes_fill_and_flow_alike(scene):
    found = codes.of_codes(scene, STUDY.parent)
    for quantity, most in (
        (codes.AT_REST, 0.25),
        ("unit_weight_at_rest", 0.04),
        ("mean_mass_flow", 0.2),
        (codes.LARGEST, 0.25),
    ):
        assert found["LAMMPS"][quantity] == pytest.approx(found["silostudy"][quantity], rel=most)
        assert found["LAMMPS"][quantity] != found["silostudy"][quantity]  # each settles by its own rounding
