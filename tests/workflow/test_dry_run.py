"""A dry run changes no byte; what is damaged is set aside and made again by a real run; every file of the user is watched."""

import os
import re
from pathlib import Path

import netCDF4
import pytest
import yaml

from silostudy.cube.io import read
from tests.workflow.projects import RESULTS, SCENE, SHAKE, SHORT, STUDIES, SWEEP, make, snakemake, tree

STUDY = STUDIES[0]


def dry(folder: Path) -> tuple[set[str], str]:
    """Rules that a dry run plans and what it says, after a look that it changed nothing at all."""
    before = tree(folder)
    done = snakemake(folder, "-n")
    assert done.returncode == 0, done.stdout[-3000:]
    assert tree(folder) == before
    return {*re.findall(r"^(?:local)?rule (\w+):", done.stdout, flags=re.MULTILINE)} - {"all"}, done.stdout


def test_of_a_fresh_folder(tmp_path):
    planned, _ = dry(make(tmp_path))
    assert {"cases", "pressure", "captions", "part", "merge", "verdict", "dem"} < planned
    assert {path.name for path in tmp_path.iterdir()} == {"config", ".snakemake"}


@pytest.mark.long
def test_of_a_finished_folder(finished):
    planned, said = dry(finished)
    assert planned == set()
    assert "Nothing to be done" in said


def break_files(results: Path) -> dict[Path, bytes]:
    """Cuts off a file of each sort; what they held before."""
    broken = [results / STUDY / name for name in ("cases.csv", "figures/fig_4_2_11.png", "figures/fig_4_2_11.csv")]
    broken += [results / SWEEP / "scenes.nc", results / SWEEP / "scenes-failed.csv", results / "dem" / f"{SCENE}.nc"]
    whole = {path: path.read_bytes() for path in broken}
    for path in broken:
        os.truncate(path, len(whole[path]) - 5)
    return whole


@pytest.mark.long
def test_damaged_files_are_told_then_set_aside_and_made_again(finished):
    results = finished / RESULTS
    whole = break_files(results)
    (journal,) = (results / SWEEP / "parts").glob("*.jsonl")
    journal.write_bytes(journal.read_bytes().replace(b'"case"', b'"ease"', 1))
    planned, said = dry(finished)
    (drawn,) = (rule for rule in planned if rule.startswith("draw_wei_zen_"))
    assert planned == {"cases", drawn, "part", "merge", "verdict", "dem"}
    for path in whole:
        assert f"{path.relative_to(finished)} is damaged: a run moves it to {path.name}.damaged and makes it again" in said
    done = snakemake(finished)
    assert done.returncode == 0, done.stdout[-3000:]
    for path, content in whole.items():
        assert path.with_name(f"{path.name}.damaged").read_bytes() == content[:-5]
        if path.suffix != ".nc":  # a cube carries times
            assert path.read_bytes() == content
    assert read(results / SWEEP / "scenes.nc")["case_outcome"].values.tolist() == [[0], [0]]
    assert dry(finished)[0] == set()


@pytest.mark.long
def test_a_cube_whose_attribute_was_edited_is_told_and_kept(finished):
    cube = finished / RESULTS / STUDY / "pressure.nc"
    with netCDF4.Dataset(cube, "a") as file:
        file.title = "mine"
    planned, said = dry(finished)
    assert "pressure.nc was edited, and its data are what was written: kept" in said
    assert {rule.split("_")[0] for rule in planned} == {"draw"}  # it is newer than its figure
    assert snakemake(finished).returncode == 0
    assert read(cube).attrs["title"] == "mine"


@pytest.mark.long
def test_a_changed_file_of_a_scene_reruns_it(finished):
    """The quake of a single scene, and that of a sweep's cases."""
    (finished / "config/scenes" / SHAKE).write_text("time_s,x_m_s2,y_m_s2\n0,2,0\n1,0,0\n")
    assert dry(finished)[0] == {"dem"}
    (finished / "config/studies" / SHAKE).write_text("time_s,x_m_s2,y_m_s2\n0,2,0\n1,0,0\n")
    assert dry(finished)[0] == {"dem", "cases", "part", "merge", "verdict"}


@pytest.mark.long
def test_a_start_from_a_file_is_watched_and_missed(tmp_path):
    make(tmp_path)
    given = SHORT | {"packing": {"kind": "given", "file": "start.nc"}}
    (tmp_path / f"config/scenes/{SCENE}.yaml").write_text(yaml.safe_dump(given))
    done = snakemake(tmp_path, "-n")
    assert done.returncode != 0
    assert "file = 'config/scenes/start.nc': is not there" in done.stdout
    (tmp_path / "config/scenes/start.nc").touch()
    inputs = re.search(r"rule dem:\n    input: (.*)", snakemake(tmp_path, "-n").stdout)[1].split(", ")
    assert {"config/scenes/start.nc", f"config/scenes/{SHAKE}"} < set(inputs)


def test_the_last_line_of_a_failed_log_is_shown(tmp_path):
    make(tmp_path)
    (tmp_path / "config/config.yaml").write_text(yaml.safe_dump({"studies": ["a-b"], "scenes": [SCENE]}))
    (tmp_path / "config/scenes" / SHAKE).write_text("time_s,x_m_s2,y_m_s2\nnothing of the kind\n")
    done = snakemake(tmp_path, f"{RESULTS}/dem/{SCENE}.nc")
    assert done.returncode != 0
    assert re.search(r"^silostudy: config/scenes/sha ke;.* line 2: row = ", done.stdout, flags=re.MULTILINE)
