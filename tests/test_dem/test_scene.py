"""From a scene file to a cube: the command, restart, refusals, events, effects."""

import copy
import re
from dataclasses import replace
from pathlib import Path

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
from silostudy.config.dem import DemScene, QuakeConfig
from silostudy.config.load import validated
from silostudy.cube.io import read, write
from silostudy.dem.engine import Engine
from silostudy.dem.events import Event
from silostudy.dem.run import Run
from silostudy.dem.stability import longest_step
from silostudy.errors import BadInput
from silostudy.scene.dem import effects
from tests.conftest import ROOT

from .scenes import silo

SMALL = {
    "kind": "dem",
    "title": "a small silo",
    "silo": {"width_m": 0.17, "height_m": 0.4, "slit_width_m": 0.06, "wall_cells": 5},
    "packing": {"kind": "rows", "across": 8, "fill_height_m": 0.2, "gap_m": 4e-5},
    "radius_m": 0.01,
    "density_kg_m3": 2650,
    "discs": {"normal_stiffness_N_m2": 9.46e6, "normal_damping_N_s_m2": 3977, "sliding_friction": 0.577},
    "walls": {"normal_stiffness_N_m2": 1.89e7, "normal_damping_N_s_m2": 7955, "sliding_friction": 0.176},
    "march": {"step_s": 2.5e-5, "limit_s": 1.0},
    "events": [{"when": "time", "value": 0.05, "do": "open_slit"}, {"when": "after", "value": 0.15, "do": "stop"}],
    "record": {"wall_force_window_s": 0.01, "snapshots_s": [0.05, 0.2], "stress_cells": [3, 5]},
}


def scene_of(**changes) -> DemScene:
    content = copy.deepcopy(SMALL)
    for path, value in changes.items():
        node = content
        *parents, last = path.split("__")
        for key in parents:
            node = node.setdefault(key, {})
        node[last] = value
    return validated(DemScene, content, "small.yaml")


def carried(scene, checkpoint=None):
    run = run_of(scene, scene_model(scene, Path()))
    carry_through(run, scene, checkpoint, lambda step: None)
    return run


@pytest.fixture(scope="module")
def small():
    scene = scene_of()
    return scene, carried(scene)


def test_the_cube_holds_what_was_asked(small, tmp_path):
    scene, run = small
    write(cube_of(run, scene), tmp_path / "small.nc")
    cube = read(tmp_path / "small.nc")
    assert cube["window_time"].size == 20
    assert cube["discharged_mass"].to_numpy()[-1] > 0.0
    assert cube["event_action"].to_numpy().tolist() == ["time: open", "after: stop"]
    shear = cube["wall_shear_force_min"].where(cube["wall_name"].isin(["left", "right"]))
    assert float(shear.min()) < 0.0  # negative wall friction stays visible
    lost = np.isnan(cube["disc_x"].to_numpy()).sum(axis=1)
    assert lost[0] == 0
    assert lost[1] == round(float(cube["discharged_mass"][-1]) / float(cube["disc_mass"][0]))
    assert cube["stress"].shape == (2, 5, 3, 2, 2)
    assert "Strack" not in cube.attrs["references"]
    assert "Kiyama" in cube.attrs["references"]


def test_the_stress_carries_the_weight():
    """At rest the vertical stress at the floor, times its area, is near the floor's force."""
    stop = {"events": [{"when": "rest", "do": "stop"}], "rest": {"criterion": "displacement"}}
    scene = scene_of(**stop, march__limit_s=3.0, record__snapshots_s=[1.2])
    run = carried(scene)
    (snapshot,) = run.recording.snapshots
    floor = snapshot["walls"][snapshot["walls"][:, 1] == 0][:, 5].sum()
    weight = run.engine.mass.sum() * 9.81
    up = snapshot["walls"][:, 5].sum()
    assert up == pytest.approx(weight, rel=1e-6)
    assert 0.5 * weight < floor < 1.05 * weight
    mean = snapshot["stress"][:, :, 1, 1]
    assert mean[0].mean() > mean[1].mean() > 0.0


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
    for name in ("wall_normal_force_max", "disc_x", "discharged_mass", "contact_force_x"):
        assert np.array_equal(whole[name], cut[name], equal_nan=True), name


@pytest.mark.parametrize("changed", ["packing", "quake", "none", "cut short"])
def test_a_checkpoint_of_other_files_is_set_aside(changed, tmp_path, capsys):
    """The scene is the same text; a changed packing or record makes it another run, which starts anew and says so."""
    record = tmp_path / "base.csv"
    record.write_text("time_s,x_m_s2,y_m_s2\n0,2.0,0\n10,2.0,0\n")
    scene = given(tmp_path, [0.05, 0.12], [0.05, 0.05]).model_copy(update={"quake": QuakeConfig(file=str(record))})
    begun = run_of(scene, scene_model(scene, Path()))
    begun.go(until=100)
    checkpoint = tmp_path / "of.checkpoint"
    save(begun, scene, checkpoint)
    if changed == "packing":
        (tmp_path / "given.nc").unlink()
        given(tmp_path, [0.05, 0.13], [0.05, 0.05])
    elif changed == "quake":
        record.write_text("time_s,x_m_s2,y_m_s2\n0,1.0,0\n10,2.0,0\n")
    elif changed == "cut short":
        checkpoint.write_bytes(checkpoint.read_bytes()[:200])
    heard: list[int] = []
    carry_through(run_of(scene, scene_model(scene, Path())), scene, checkpoint, heard.append)
    said = capsys.readouterr().err
    if changed == "none":
        assert min(heard) > 100
        assert not said
        return
    why = {"packing": "another discs", "quake": "another acceleration of the box", "cut short": "cannot be read"}[changed]
    assert why in said
    assert "starts anew" in said
    assert (tmp_path / "of.checkpoint.old").exists()
    assert run_fresh(scene, heard)


def run_fresh(scene, heard) -> bool:
    """Whether the first look of a run came where that of a run from the start comes."""
    first: list[int] = []
    run = run_of(scene, scene_model(scene, Path()))
    run.go(until=500, tell=first.append)
    return heard[0] == first[0]


def test_the_command(tmp_path, capsys):
    path = tmp_path / "tiny.yaml"
    path.write_text(yaml.safe_dump(SMALL | {"events": [{"when": "time", "value": 0.01, "do": "stop"}]}))
    assert main(["dem", str(path), str(tmp_path / "tiny.nc")]) == 0
    assert "400 steps" in capsys.readouterr().out
    assert read(tmp_path / "tiny.nc").attrs["steps"] == 400


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


REFUSED = {
    "step beyond the bound": ({"march__step_s": 1e-4}, "stability bound"),
    "slit wider than the floor": ({"silo__slit_width_m": 0.2}, "smaller than the floor"),
    "zero radius": ({"radius_m": 0.0}, "radius_m"),
    "negative stiffness": ({"discs__normal_stiffness_N_m2": -1.0}, "normal_stiffness_N_m2"),
    "NaN": ({"density_kg_m3": float("nan")}, "density_kg_m3"),
    "unknown law": ({"discs__tangential": "glue"}, "unknown; known: none, spring-slider"),
    "unknown key": ({"record__colour": "red"}, "unknown key"),
    "no stop": ({"events": [{"when": "rest", "do": "open_slit"}]}, "stop"),
    "two dampings": ({"discs__damping_ratio": 0.5}, "not more than one"),
    "too many across": ({"packing__across": 9}, "do not fit"),
    "no such file": ({"packing": {"kind": "given", "file": "none.nc"}}, "none.nc"),
    "no stress cells": ({"record": {"stress_cells": [0, 3]}}, "must be greater than or equal to 1"),
    "too many stress cells": ({"record": {"stress_cells": [3, 100_000]}}, "must be less than or equal to 1000"),
    "rest has no value": (
        {"events": [{"when": "rest", "value": 3.0, "do": "stop"}]},
        "value must be left out where when is rest",
    ),
    "a disc removed twice": (
        {"events": [*[{"when": "after", "do": "remove_disc", "disc": 1}] * 2, {"when": "after", "do": "stop"}]},
        "events remove a disc twice",
    ),
    "no such record": ({"quake": {"file": "none.csv"}}, "none.csv"),
}


@pytest.mark.parametrize("case", REFUSED)
def test_refusals(case):
    changes, message = REFUSED[case]
    with pytest.raises(BadInput, match=message):
        scene_model(scene_of(**changes), Path(), "small.yaml")


def given(tmp_path, x, y):
    import xarray as xr

    file = tmp_path / "given.nc"
    xr.Dataset({"disc_x": ("disc", x), "disc_y": ("disc", y), "disc_radius": ("disc", np.full(len(x), 0.01))}).to_netcdf(file)
    return scene_of(packing={"kind": "given", "file": str(file)})


def test_starts_that_cannot_be(tmp_path):
    with pytest.raises(BadInput, match=r"discs 0, 1.*overlap"):
        scene_model(given(tmp_path, [0.05, 0.06], [0.05, 0.05]), Path())
    with pytest.raises(BadInput, match=r"disc 1.*wall left"):
        scene_model(given(tmp_path, [0.05, -0.06], [0.05, 0.05]), Path())


def test_a_cube_is_a_packing(tmp_path):
    """The last snapshot of a run starts another, in the same places."""
    stop = [{"when": "time", "value": 0.04, "do": "stop"}]
    scene = scene_of(events=stop, record={"snapshots_s": [0.04]})
    write(cube_of(carried(scene), scene), tmp_path / "small.nc")
    again = scene_of(packing={"kind": "given", "file": str(tmp_path / "small.nc")}, events=stop, record={})
    assert np.array_equal(scene_model(again, Path()).x, read(tmp_path / "small.nc")["disc_x"].to_numpy()[-1])


def test_an_explosion_keeps_what_was_recorded(tmp_path, capsys):
    path = tmp_path / "wild.yaml"
    wild = copy.deepcopy(SMALL)
    wild["march"] |= {"step_s": 2.5e-4, "beyond_stability": True}
    path.write_text(yaml.safe_dump(wild))
    assert main(["dem", str(path), str(tmp_path / "wild.nc")]) == 2
    assert "ran away at t =" in capsys.readouterr().err
    cube = read(tmp_path / "wild.nc")
    assert "ran away" in cube.attrs["stopped"]


def test_events_remove_and_change():
    events = [
        {"when": "time", "value": 0.01, "do": "remove_disc", "disc": 3},
        {"when": "after", "value": 0.0, "do": "remove_disc", "near_m": [0.16, 0.2]},
        {"when": "after", "value": 0.005, "do": "set_friction", "disc_friction": 0.1},
        {"when": "after", "value": 0.0, "do": "set_gravity", "gravity_m_s2": [0.0, 0.0]},
        {"when": "after", "value": 0.005, "do": "stop"},
    ]
    run = carried(scene_of(events=events))
    assert run.engine.n == len(run.engine.model.x) - 2
    assert 3 not in run.engine.labels
    assert run.engine.contacts[0].coefficients["sliding_friction"] == 0.1
    assert run.engine.contacts[1].coefficients["sliding_friction"] == 0.176
    assert run.engine.gravity == (0.0, 0.0)
    assert [what for _, _, what in run.recording.happened] == ["remove", "remove", "friction", "gravity", "stop"]


def test_an_event_due_at_the_start_acts_at_once():
    """Whatever windows are recorded: the first stop of a run must not decide when a slit opens."""
    open_slit = Event("time", 0.0, "open", ("floor", "floor_left", "floor_right"))
    places = []
    for window in (0, 40, 200):
        run = Run(Engine(silo()), (open_slit, Event("time", 0.05, "stop")), limit=1.0, window=window)
        assert run.go().happened[0] == (0.0, "time", "open")
        places.append(run.engine.places)
    assert np.array_equal(places[0], places[1])
    assert np.array_equal(places[0], places[2])


def test_discharge_stops_at_a_share():
    events = [{"when": "time", "value": 0.01, "do": "open_slit"}, {"when": "discharged", "value": 0.03, "do": "stop"}]
    run = carried(scene_of(events=events))
    assert 0.03 <= run.dropped / run.full < 0.2
    assert run.recording.happened[-1][1:] == ("discharged", "stop")


@pytest.mark.long
def test_a_hopper_empties_through_its_mouth():
    """Loose discs of many sizes rain into a hopper, rest on it, and leave when its mouth opens; none passes a wall."""
    scene = scene_of(
        silo={"width_m": 0.17, "height_m": 0.4, "slit_width_m": 0.08, "hopper_half_angle_deg": 20.0, "lid": True},
        packing={"kind": "loose", "count": 60, "radius_spread": 0.3},
        radius_m=0.006,
        march={"limit_s": 3.0},
        events=[{"when": "time", "value": 0.6, "do": "open_slit"}, {"when": "discharged", "value": 1.0, "do": "stop"}],
        record={"snapshots_s": [0.5]},
    )
    run = carried(scene)
    (full,) = run.recording.snapshots
    assert len(full["label"]) == 60
    assert full["motion"][:, 1].min() > 0.0
    assert set(full["walls"][:, 1]) >= {0.0, 1.0}
    assert run.recording.happened[-1][1:] == ("discharged", "stop")
    assert run.engine.n == 0


def test_shaking(tmp_path):
    record = tmp_path / "base.csv"
    record.write_text("time_s,x_m_s2,y_m_s2\n0,2.0,0\n10,2.0,0\n")
    scene = scene_of(
        quake={"file": str(record)}, events=[{"when": "time", "value": 0.001, "do": "stop"}], gravity_m_s2=[0.0, 0.0]
    )
    run = carried(scene)
    assert np.median(run.engine.column(2)) == pytest.approx(-2.0 * run.engine.time, rel=1e-9)


def test_shaking_after_the_end_is_refused(tmp_path):
    record = tmp_path / "late.csv"
    record.write_text("time_s,x_m_s2,y_m_s2\n1.0,5,0\n1.1,5,0\n")
    scene = scene_of(quake={"file": str(record)}, march={"limit_s": 0.5})
    with pytest.raises(BadInput, match=r"quake.file = 1.0: must begin before the run ends, at 0.5 s"):
        scene_model(scene, tmp_path)


def test_paraview(small, tmp_path):
    _, run = small
    files = export(run, tmp_path)
    assert [file.name for file in files] == ["000-discs.vtu", "000-forces.vtu", "001-discs.vtu", "001-forces.vtu"]
    discs, forces = meshio.read(files[0]), meshio.read(files[1])
    assert len(discs.points) == len(run.engine.model.x)
    assert np.all(discs.point_data["radius"] == 0.01)
    assert len(forces.cells_dict["line"]) == len(run.recording.snapshots[0]["pairs"])


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
