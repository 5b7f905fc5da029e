"""What a release is: one version everywhere, a project laid anywhere, and a wheel that works outside the repository."""

import os
import re
import shutil
import subprocess
import sys
import tomllib
import zipfile

import pytest
import yaml

from silostudy import PACKAGE, __version__
from silostudy.__main__ import main
from silostudy.config.load import load_project
from silostudy.config.retired import RETIRED_KEYS
from silostudy.config.schema import study_schema
from silostudy.cube.provenance import CONTRACT
from tests.conftest import ROOT


def test_one_version_stands_everywhere():
    changes = (PACKAGE / "CHANGELOG.md").read_text()
    assert tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]["version"] == __version__
    cited = yaml.safe_load((ROOT / "CITATION.cff").read_text())
    assert cited["version"] == __version__
    newest, day = re.findall(r"^## (\S+) \((\S+)\)$", changes, re.MULTILINE)[0]
    assert (newest, day) == (__version__, str(cited["date-released"]))
    assert f"contract {CONTRACT}" in changes
    assert all(f"`{key}`" in changes or f".{key}`" in changes for key in RETIRED_KEYS)


def test_a_project_is_laid_once(tmp_path, capsys):
    folder = tmp_path / "mine"
    assert main(["new", str(folder)]) == 0
    studies, scenes = load_project(folder / "config/config.yaml")
    assert (list(studies), list(scenes)) == (["my-silo"], [])
    assert main(["check", str(studies["my-silo"])]) == 0
    assert "gives nothing" not in capsys.readouterr().out
    assert main(["check", str(folder / "config/scenes/my-discs.yaml")]) == 0
    assert (folder / "config/study.schema.json").read_text() == study_schema()
    for profile in ("slurm", "workstation"):
        laid = folder / f"config/profiles/{profile}/config.yaml"
        assert laid.read_bytes() == (ROOT / f"config/profiles/{profile}/config.yaml").read_bytes()
        assert not laid.is_symlink()
    assert main(["new", str(folder)]) == 2
    assert "is there already" in capsys.readouterr().err


@pytest.mark.long
def test_the_wheel_lays_and_runs_a_project_elsewhere(tmp_path):
    """The wheel's own files alone, without the repository, from an empty folder to a figure."""
    if shutil.which("uv") is None:
        pytest.skip("no uv to build with")
    subprocess.run(["uv", "build", "--quiet", "--out-dir", tmp_path / "dist", ROOT], check=True)  # sdist, and from it the wheel
    (wheel,) = (tmp_path / "dist").glob(f"silostudy-{__version__}-*.whl")
    zipfile.ZipFile(wheel).extractall(tmp_path / "site")
    environment = {**os.environ, "PYTHONPATH": str(tmp_path / "site")}

    def run(folder, *words) -> str:
        command = [sys.executable, "-P", "-m", *map(str, words)]
        return subprocess.run(command, cwd=folder, env=environment, check=True, capture_output=True, text=True).stdout

    assert str(tmp_path / "site") in run(tmp_path, "silostudy", "doctor")
    run(tmp_path, "silostudy", "new", "mine")
    run(tmp_path / "mine", "snakemake", "--cores", "2")
    assert (tmp_path / "mine/results/my-silo/figures/comparison_today.png").stat().st_size > 10_000
