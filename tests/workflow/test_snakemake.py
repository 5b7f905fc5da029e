"""A tiny whole study through Snakemake: results, nothing twice, no stale result, mistakes before any job."""

import os
import shutil
import subprocess
import sys

import pytest
import yaml

from silostudy.cube.io import read
from silostudy.pressure import PRESSURE
from silostudy.pressure.family import usual
from tests.conftest import ROOT
from tests.test_sweep.sweeps import content


@pytest.fixture
def project(tmp_path, study):
    """A folder with the pipeline, a copy of the package, and one small study."""
    for name in ("Snakefile", "silostudy"):
        (shutil.copytree if (ROOT / name).is_dir() else shutil.copy)(ROOT / name, tmp_path / name)
    (tmp_path / "config/studies").mkdir(parents=True)
    study |= {"methods": "all", "as_printed": ["jenike_mass_flow"], "outputs": ["fig_4_2_11"]}
    save(tmp_path, study)
    (tmp_path / "config/config.yaml").write_text("studies: [small]\n")
    return tmp_path


def save(folder, study):
    (folder / "config/studies/small.yaml").write_text(yaml.safe_dump(study, sort_keys=False))


def snakemake(folder, *arguments):
    """Runs the pipeline in the folder, with the folder's own copy of the package."""
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    command = [sys.executable, "-m", "snakemake", "--cores", "2", *arguments]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)


@pytest.mark.long
def test_whole_study_and_its_reruns(project, study):
    done = snakemake(project)
    assert done.returncode == 0, done.stderr
    results = project / "results/small"
    files = (path for path in results.rglob("*") if path.is_file() and not path.name.startswith("."))
    made = {path.relative_to(results).as_posix() for path in files if "logs" not in path.parts}
    shown = {f"figures/fig_4_2_11.{ending}" for ending in ("png", "svg", "csv")}
    assert made == {"cases.csv", "pressure.nc", "cost/pressure.tsv", *shown}
    assert read(results / "pressure.nc").sizes["pressure_method"] == len(usual(PRESSURE)) + 1

    assert "Nothing to be done" in snakemake(project, "-n").stderr + snakemake(project, "-n").stdout

    law = project / "silostudy/pressure/janssen.py"  # a change in a room behind a rule is not overlooked
    law.write_text(law.read_text() + "\n# changed\n")
    planned = snakemake(project, "-n").stdout
    assert "pressure" in planned
    assert "Nothing to be done" not in planned


def test_only_what_the_study_calls_for(project, study):
    save(project, {**study, "outputs": []})
    planned = snakemake(project, "-n").stdout
    assert "rule pressure" in planned
    assert "rule figure" not in planned


@pytest.mark.long
def test_a_figure_waits_for_the_further_cubes_that_it_shows(project, study):
    """comparison_today shows the sampled scatter where the study samples it, and asks for nothing where it does not."""
    study["outputs"] = ["comparison_today"]
    save(project, study)
    assert "uncertainty.nc" not in snakemake(project, "-n").stdout
    study["scene"]["properties"] = {"a_phi": 1.1, "a_K": 1.1, "a_mu": 1.1, "unit_weight_lower_kN_m3": 6.5}
    save(project, study | {"uncertainty": {"log2_samples": 6}})
    planned = snakemake(project, "-n").stdout
    assert "input: results/small/pressure.nc, results/small/uncertainty.nc" in planned


@pytest.mark.long
def test_a_shell_waits_for_the_earthquake_that_it_names(project):
    """The seismic cube of another study goes into the shell stage of the study that names it, and into no other."""
    for name in ("steel-wheat-shaken", "steel-wheat-earthquake", "steel-wheat-strakes"):
        shutil.copy(ROOT / f"config/studies/{name}.yaml", project / "config/studies")
    config = project / "config/config.yaml"
    config.write_text("studies: [steel-wheat-shaken, steel-wheat-earthquake, steel-wheat-strakes]\n")
    planned = snakemake(project, "-n").stdout
    assert "pressure.nc, results/steel-wheat-earthquake/seismic.nc" in planned
    static = planned.split("output: results/steel-wheat-strakes/shell.nc")[0].splitlines()[-2]
    assert static.strip() == "input: config/studies/steel-wheat-strakes.yaml, results/steel-wheat-strakes/pressure.nc"
    config.write_text("studies: [steel-wheat-shaken]\n")
    told = snakemake(project, "-n").stdout
    assert "steel-wheat-shaken: earthquake.study = 'steel-wheat-earthquake': must be named in config/config.yaml too" in told


def test_a_mistake_stops_before_any_job(project, study):
    study["scene"]["solid"] = "sand"
    save(project, study)
    done = snakemake(project)
    assert done.returncode != 0
    assert "scene.solid = 'sand': unknown; known: cement" in done.stderr
    assert not (project / "results").exists()


def test_results_folder_that_cannot_be_written(project):
    (project / "results").write_text("a file where the folder should be")
    done = snakemake(project)
    assert done.returncode != 0
    assert "results folder = 'results': cannot be written" in done.stderr


def change(path):
    """Changes a source in a way that changes no number."""
    path.write_text(path.read_text() + "\n# changed\n")


def planned(project):
    """Rules that a dry run would carry out, with how often."""
    lines = snakemake(project, "-n", "--quiet", "rules").stdout.splitlines()
    return {words[0]: int(words[1]) for words in map(str.split, lines) if len(words) == 2 and words[1].isdigit()}


@pytest.mark.long
def test_a_change_reruns_what_depends_on_it_and_nothing_else(project, study):
    """Both ways: no stale result, no needless rerun."""
    sweep = content(
        slits=[0.1, 0.12], frictions=[0.1], scene=content()["scene"] | {"march": {"limit_s": 0.05, "step_s": 2.5e-5}}
    )
    (project / "config/studies/grains.yaml").write_text(yaml.safe_dump(sweep))
    (project / "config/config.yaml").write_text("studies: [small, grains]\n")
    assert snakemake(project).returncode == 0
    assert planned(project) == {}
    package = project / "silostudy"
    change(package / "pressure/reimbert.py")
    assert planned(project) == {"pressure": 1, "draw_small_pressure": 1, "all": 1, "total": 3}
    assert snakemake(project).returncode == 0
    change(package / "dem/run.py")
    assert planned(project) == {"part": 1, "merge": 1, "verdict": 1, "all": 1, "total": 4}
    assert snakemake(project).returncode == 0
    change(package / "figures/fig_4_2_11.py")
    assert planned(project) == {"draw_small_pressure": 1, "all": 1, "total": 2}
    assert snakemake(project).returncode == 0
    change(package / "figures/required_thickness.py")
    change(package / "buckling/miller1977.py")
    change(package / "commands/listing.py")
    assert planned(project) == {}
