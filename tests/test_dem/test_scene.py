"""From a scene file to a cube: the command, restart, effects, ensembles, what is written where."""

import re
from dataclasses import replace
from pathlib import Path
from xml.etree import ElementTree

import meshio
import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.choice.dem import load
from silostudy.compute.checkpoints import save
from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.paraview import export
from silostudy.cube.io import read, write
from silostudy.dem.stability import longest_step
from silostudy.scene.dem import effects
from tests.conftest import ROOT
from tests.test_dem.small import SMALL, carried, scene_of


@pytest.fixture(scope="module")
def small():
    scene = scene_of()
    return scene, carried(scene)


def test_the_cube_holds_what_was_asked(small, tmp_path):
    scene, run = small
    write(cube_of(run, scene), tmp_path / "small.nc")
    cube = read(tmp_path / "small.nc")
    assert cube["window_time"].size == 20
    assert cube["outflow_mass"].to_numpy()[-1] > 0.0
    assert cube["event_action"].to_numpy().tolist() == ["time: open_slit", "after: stop"]
    shear = cube["wall_shear_force_min"].where(cube["wall_name"].isin(["left", "right"]))
    assert float(shear.min()) < 0.0  # negative wall friction stays visible
    left = cube["wall_normal_force_mean"].where(cube["wall_name"] == "left").sum("wall_cell")
    whole = cube[[f"surface_normal_force_{what}" for what in ("mean", "min", "max")]].sel(surface="left")
    assert np.allclose(whole.surface_normal_force_mean, left, rtol=1e-12)
    assert (whole.surface_normal_force_min <= whole.surface_normal_force_mean * (1.0 + 1e-12)).all()
    assert float((whole.surface_normal_force_max - whole.surface_normal_force_mean).max()) > 0.0
    lost = np.isnan(cube["disc_x"].to_numpy()).sum(axis=1)
    assert lost[0] == 0
    assert lost[1] == round(float(cube["outflow_mass"][-1]) / float(cube["disc_mass"][0]))
    assert cube["field_contact_stress"].sizes["field_time"] == 4
    assert "Strack" not in cube.attrs["references"]
    assert "Kiyama" in cube.attrs["references"]


def test_the_walls_carry_the_weight():
    stop = {"events": [{"when": "rest", "do": "stop"}], "rest": {"criterion": "displacement"}}
    scene = scene_of(**stop, march__limit_s=3.0, record__snapshots_s=[1.2])
    run = carried(scene)
    (snapshot,) = run.recording.snapshots
    floor = snapshot["walls"][snapshot["walls"][:, 1] == 0][:, 5].sum()
    weight = run.engine.mass.sum() * 9.81
    up = snapshot["walls"][:, 5].sum()
    assert up == pytest.approx(weight, rel=1e-6)
    assert 0.5 * weight < floor < 1.05 * weight


def test_restart_goes_on_with_the_same_bits(small, tmp_path):
    scene = scene_of(record__checkpoint_every_s=0.03)
    checkpoint = tmp_path / "small.checkpoint"
    begun = run_of(scene, scene_model(scene, Path()))
    begun.go(until=4800)
    save(begun, scene, checkpoint)
    heard: list[int] = []
    resumed = run_of(scene, scene_model(scene, Path()))
    carry_through(resumed, scene, checkpoint, heard.append)
    assert min(heard) > 4800
    assert checkpoint.exists()  # until the result is written
    whole, cut = cube_of(small[1], scene), cube_of(resumed, scene)
    for name in ("wall_normal_force_max", "disc_x", "outflow_mass", "contact_force_x"):
        assert np.array_equal(whole[name], cut[name], equal_nan=True), name


def test_the_command(tmp_path, capsys):
    path = tmp_path / "tiny.yaml"
    path.write_text(yaml.safe_dump(SMALL | {"events": [{"when": "time", "value": 0.01, "do": "stop"}]}))
    assert main(["dem", str(path), str(tmp_path / "tiny.nc")]) == 0
    assert "400 steps" in capsys.readouterr().out
    assert read(tmp_path / "tiny.nc").attrs["steps"] == 400


def test_snapshots_every_so_often_fall_on_the_nearest_steps_to_the_last():
    """0.007 s is no whole number of steps, and 0.028 s the stop: intervals of rounded steps would leave the last one out."""
    record = {"snapshots_every_s": 0.007}
    run = carried(scene_of(events=[{"when": "time", "value": 0.028, "do": "stop"}], record=record, march__step_s=2.3e-5))
    times = [float(snapshot["time"]) for snapshot in run.recording.snapshots]
    assert [round(time / 2.3e-5) for time in times] == [0, 304, 609, 913, 1217]


def test_an_ensemble_gives_the_bits_of_its_members(tmp_path, capsys):
    """Scenes that run at once give what each gives alone, and differ by their seed."""
    content = SMALL | {"events": [{"when": "time", "value": 0.02, "do": "stop"}], "record": {"snapshots_s": [0.02]}}
    content["packing"] = SMALL["packing"] | {"gap_m": 3e-4, "offset_m": 1e-4, "across": 7}
    for seed in (0, 1, 2):
        (tmp_path / f"alone-{seed}.yaml").write_text(yaml.safe_dump(content | {"seed": seed}))
        assert main(["dem", str(tmp_path / f"alone-{seed}.yaml"), str(tmp_path / f"alone-{seed}.nc")]) == 0
    assert main(["dem", str(tmp_path / "alone-0.yaml"), str(tmp_path / "many.nc"), "--seeds", "3"]) == 0
    places = [read(tmp_path / f"many-{seed}.nc")["disc_x"] for seed in (0, 1, 2)]
    for seed, place in enumerate(places):
        assert np.array_equal(place, read(tmp_path / f"alone-{seed}.nc")["disc_x"])
    assert not np.array_equal(places[0], places[1])


def test_the_example_scene_is_valid_and_its_effects_are_listed():
    scene, _ = load(ROOT / "config/scenes/kiyama-17-18.yaml")
    on = {effect.name: effect.on for effect in effects(scene)}
    assert on["friction, rotation, history"]
    assert on["slit"]
    assert not on["rolling resistance"]
    model = scene_model(scene, ROOT)
    assert model.dt < 0.5 * longest_step(model)


def test_the_stability_bound_of_the_paper_s_scene():
    """The paper's step 1e-4 s is beyond the bound of (17), (18) and within that of (17), (19), as it found."""
    scene, _ = load(ROOT / "config/scenes/kiyama-17-18.yaml")
    model = scene_model(scene, ROOT)
    assert 5e-5 < longest_step(model) < 7e-5
    assert 1e-4 < longest_step(replace(model, integrator="17-19")) < 2e-4


def test_a_cube_is_a_packing(tmp_path):
    """The last snapshot of a run starts another, in the same places."""
    stop = [{"when": "time", "value": 0.04, "do": "stop"}]
    scene = scene_of(events=stop, record={"snapshots_s": [0.04]})
    write(cube_of(carried(scene), scene), tmp_path / "small.nc")
    again = scene_of(packing={"kind": "given", "file": str(tmp_path / "small.nc")}, events=stop, record={})
    assert np.array_equal(scene_model(again, Path()).x, read(tmp_path / "small.nc")["disc_x"].to_numpy()[-1])


def test_paraview(small, tmp_path):
    _, run = small
    files = export(run, tmp_path)
    assert [file.name for file in files] == ["000-discs.vtu", "000-forces.vtu", "001-discs.vtu", "001-forces.vtu"]
    discs, forces = meshio.read(files[0]), meshio.read(files[1])
    assert len(discs.points) == len(run.engine.model.x)
    assert np.all(discs.point_data["radius"] == 0.01)
    assert len(forces.cells_dict["line"]) == len(run.recording.snapshots[0]["pairs"])
    series = ElementTree.parse(tmp_path / "discs.pvd").iter("DataSet")
    listed = [(float(entry.get("timestep")), entry.get("file")) for entry in series]
    assert listed == [(pytest.approx(0.05), "000-discs.vtu"), (pytest.approx(0.2), "001-discs.vtu")]


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("run.checkpoint", "is where the checkpoints go"),
        ("run", "is the folder of the files for ParaView"),
        ("taken.nc", "taken.*is a file"),
    ],
)
def test_what_a_run_writes_has_places_of_its_own(name, told, tmp_path, capsys):
    """Else the last checkpoint would go with the result, or ParaView's folder fail when the run has ended."""
    record = SMALL["record"] | {"checkpoint_every_s": 0.01, "paraview": True}
    (tmp_path / "scene.yaml").write_text(yaml.safe_dump(SMALL | {"record": record}))
    (tmp_path / "taken").touch()
    assert main(["dem", str(tmp_path / "scene.yaml"), str(tmp_path / name)]) == 2
    (line,) = capsys.readouterr().err.splitlines()
    assert re.search(told, line)
    assert sorted(path.name for path in tmp_path.iterdir()) == ["scene.yaml", "taken"]
