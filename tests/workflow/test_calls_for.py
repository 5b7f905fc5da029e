"""The pipeline makes only what studies call for: their cubes by their kind and sections, their figures by their outputs."""

import os
import re
import subprocess
import sys

import pytest
import yaml

from silostudy.stages import KINDS
from silostudy.tables.outputs import files_of
from tests.conftest import ROOT

# study -> the rules besides cases and drawing that its kind and sections call for
CALLED = {
    "pieper-flour": {"pressure"},
    "wheat-silo-today": {"pressure", "uncertainty"},
    "eccentric-silo": {"pressure", "loads"},
    "steel-wheat-strakes": {"pressure", "shell"},
    "steel-wheat-shaken": {"pressure", "shell", "checks"},
    "steel-wheat-earthquake": {"seismic"},
    "miller-1977": {"buckling"},
    "sasaki-1991": {"seismic"},
    "grains-record": {"grains"},
    "discharge-slit": {"part", "merge", "verdict"},
    "wheat-laboratory": {"part", "merge", "verdict"},
    "spheres-laboratory": {"part", "merge", "verdict"},
    "discs-laboratory": {"part", "merge", "verdict"},
    "wheat-laboratory-silo": {"pressure"},
    "silo-of-spheres-codes": {"pressure"},
    "silo-of-spheres": {"part", "merge", "verdict", "beside"},
    "wheat-bin-outlets": {"part", "merge", "verdict"},
    "hopper-of-discs-codes": {"pressure"},
    "hopper-of-discs": {"part", "merge", "verdict", "beside"},
    "published-cases": {"part", "merge", "verdict"},
    "kiyama-1983": {"packing", "motion"},
    "kiyama-1983-slit": {"packing"},
    "stability-map": {"stability", "profile"},
    "accuracy": {"accuracy"},
}


@pytest.fixture(scope="module")
def jobs(tmp_path_factory):
    """(rule, lines before its output, output files) of every job of a project of all these studies and one scene."""
    folder = tmp_path_factory.mktemp("results")
    project = folder / "config/project.yaml"
    project.parent.mkdir()
    project.write_text(yaml.safe_dump({"studies": list(CALLED), "scenes": ["kiyama-17-18"]}))
    for name in ("studies", "scenes"):
        (project.parent / name).symlink_to(ROOT / "config" / name)
    environment = {**os.environ, "PATH": f"{os.path.dirname(sys.executable)}:{os.environ['PATH']}"}
    command = [sys.executable, "-m", "snakemake", "-n", "--cores", "1", "--config"]
    command += [f"project={project}", f"results={folder}/results"]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    each = re.findall(
        r"^(?:local)?rule (\w+):\n((?:    (?!output)\w+: .*\n)*)    output: (.*)", done.stdout, flags=re.MULTILINE
    )
    assert len(each) > 2 * len(CALLED)
    return each


def test_every_kind_of_study_is_looked_at():
    kinds = {yaml.safe_load((ROOT / f"config/studies/{study}.yaml").read_text())["kind"] for study in CALLED}
    assert kinds == set(KINDS)


def test_a_shell_waits_for_its_earthquake_and_for_no_other(jobs):
    """Of all the seismic cubes only the study's own is an input, and the shell without an earthquake has none."""
    asked = {study: set(re.findall(r"/results/([\w-]+)/seismic\.nc", inputs)) for study, inputs in _shells(jobs)}
    assert asked == {"steel-wheat-strakes": set(), "steel-wheat-shaken": {"steel-wheat-earthquake"}}


def test_a_silo_waits_for_the_solid_of_the_laboratory_that_it_names(jobs):
    """Its cases and its pressures are made from the row, which nothing has made yet when the pipeline is planned."""
    waiting = [rule for rule, inputs, _ in jobs if "/wheat-laboratory/tables/laboratory_solid.csv" in inputs]
    assert sorted(waiting) == ["cases", "pressure"]
    (made,) = [rule for rule, _, output in jobs if "/wheat-laboratory/tables/laboratory_solid.csv" in output]
    assert made.startswith("draw")


def _shells(jobs):
    return [(re.search(r"/results/([\w-]+)/shell\.nc", output)[1], inputs) for rule, inputs, output in jobs if rule == "shell"]


@pytest.mark.parametrize("study", CALLED)
def test_stages_are_those_of_the_kind_and_its_sections(jobs, study):
    rules = {rule for rule, _, output in jobs if f"/results/{study}/" in output and not rule.startswith("draw_")}
    assert rules - {"cases"} == CALLED[study]


@pytest.mark.parametrize("study", CALLED)
def test_figures_and_tables_are_those_asked_for(jobs, study):
    asked = yaml.safe_load((ROOT / f"config/studies/{study}.yaml").read_text()).get("outputs", [])
    drawn = [file for rule, _, output in jobs if rule.startswith("draw_") for file in output.split(", ")]
    here = [file.split("/results/")[1] for file in drawn if f"/results/{study}/" in file]
    assert sorted(here) == sorted(file for key in asked for file in files_of(key, study))


def test_a_scene_asks_for_its_run_and_nothing_else(jobs):
    made = {rule: output for rule, _, output in jobs if "/results/dem/" in output}
    assert list(made) == ["dem", "draw_scene_kiyama_17_18"]
    asked = yaml.safe_load((ROOT / "config/scenes/kiyama-17-18.yaml").read_text())["outputs"]
    drawn = [file.split("/results/")[1] for file in made["draw_scene_kiyama_17_18"].split(", ")]
    assert sorted(drawn) == sorted(file for key in asked for file in files_of(key, "dem/kiyama-17-18"))
