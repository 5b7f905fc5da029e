"""The pipeline makes only what studies call for: their cubes by their kind and sections, their figures by their outputs."""

import os
import re
import subprocess
import sys

import pytest
import yaml

from tests.conftest import ROOT

# study -> the rules besides cases and drawing that its kind and sections call for
CALLED = {
    "pieper-flour": {"pressure"},
    "wheat-silo-today": {"pressure", "uncertainty"},
    "steel-wheat-strakes": {"pressure", "shell"},
    "miller-1977": {"buckling"},
    "sasaki-1991": {"seismic"},
    "grains-record": {"grains"},
    "stability-map": {"stability", "profile"},
    "accuracy": {"accuracy"},
}


@pytest.fixture(scope="module")
def jobs(tmp_path_factory):
    """(rule, output files) of every job that a project of all these studies would run, and of one with a scene alone."""
    folder = tmp_path_factory.mktemp("results")
    project = folder / "project.yaml"
    project.write_text(yaml.safe_dump({"studies": list(CALLED), "scenes": ["kiyama-17-18"]}))
    (folder / "config").symlink_to(ROOT / "config")
    for name in ("studies", "scenes"):
        (folder / name).symlink_to(ROOT / "config" / name)
    environment = {**os.environ, "PATH": f"{os.path.dirname(sys.executable)}:{os.environ['PATH']}"}
    command = [sys.executable, "-m", "snakemake", "-n", "--cores", "1", "--config"]
    command += [f"project={project}", f"results={folder}/results"]
    done = subprocess.run(command, cwd=ROOT, env=environment, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    return re.findall(r"^(?:local)?rule (\w+):\n(?:    (?!output)\w+: .*\n)*    output: (.*)", done.stdout, flags=re.MULTILINE)


@pytest.mark.parametrize("study", CALLED)
def test_stages_are_those_of_the_kind_and_its_sections(jobs, study):
    rules = {rule for rule, output in jobs if f"/results/{study}/" in output and not rule.startswith("draw_")}
    assert rules - {"cases"} == CALLED[study]


@pytest.mark.parametrize("study", CALLED)
def test_figures_and_tables_are_those_asked_for(jobs, study):
    asked = yaml.safe_load((ROOT / f"config/studies/{study}.yaml").read_text()).get("outputs", [])
    places = (re.findall(rf"/results/{study}/(?:figures|tables)/(\w+)\.", output) for _, output in jobs)
    drawn = {key for keys in places for key in keys}
    assert drawn == set(asked)


def test_a_scene_asks_for_its_run_and_nothing_else(jobs):
    assert [rule for rule, output in jobs if "/results/dem/" in output] == ["dem"]
