"""Runs that end otherwise: checkpoints of another run are set aside, an explosion keeps what was recorded."""

import copy
from pathlib import Path

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.compute.checkpoints import save
from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.config.run import QuakeConfig
from silostudy.cube.io import read
from tests.test_dem.small import SMALL, given


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
        assert said == f"silostudy: goes on from {checkpoint} at {begun.engine.time:g} s\n"
        return
    why = {"packing": "other grains", "quake": "other acceleration of the box", "cut short": "cannot be read"}[changed]
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


def test_an_explosion_keeps_what_was_recorded(tmp_path, capsys):
    path = tmp_path / "wild.yaml"
    wild = copy.deepcopy(SMALL)
    wild["march"] |= {"step_s": 2.5e-4, "beyond_stability": True}
    path.write_text(yaml.safe_dump(wild))
    assert main(["dem", str(path), str(tmp_path / "wild.nc")]) == 2
    assert "ran away at t =" in capsys.readouterr().err
    cube = read(tmp_path / "wild.nc")
    assert "ran away" in cube.attrs["stopped"]
