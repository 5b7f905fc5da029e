"""A small sweep through a real Slurm of one node gives the bits of the workstation; asked for by -m long."""

import importlib.util
import os
import shutil
import subprocess
from pathlib import Path

import pytest

from tests.conftest import ROOT
from tests.test_sweep.faults import CUBE, Breaker, computed, project

SCRIPT = Path(__file__).with_name("slurm.sh")
NEEDED = ("slurmctld", "slurmd", "munge")


@pytest.fixture
def slurm(tmp_path):
    """A Slurm of one node, started for this test."""
    if os.geteuid() or not all(map(shutil.which, NEEDED)) or Path("/etc/slurm/slurm.conf").exists():
        pytest.skip("no Slurm to start: needs root, Debian's slurm-wlm and munge, and no Slurm of the machine's own")
    if importlib.util.find_spec("snakemake_executor_plugin_slurm") is None:
        pytest.skip("no Slurm executor: uv sync --group slurm")
    folder = tmp_path / "slurm"
    subprocess.run([SCRIPT, "start", folder], check=True)
    yield
    subprocess.run([SCRIPT, "stop", folder], check=True)


@pytest.mark.long
def test_slurm_gives_the_bits_of_the_workstation(slurm, tmp_path):
    changes = {"slits": [0.04, 0.08, 0.1], "case_s": 10.0}
    folder = project(tmp_path / "project", **changes)
    assert Breaker(folder, tmp_path / "here", 0, tmpfs=False).run() == 0
    command = ["snakemake", "--snakefile", ROOT / "Snakefile", "--workflow-profile", ROOT / "config/profiles/slurm"]
    command += ["--slurm-status-command", "squeue", "--slurm-no-account", "--config", f"results={tmp_path / 'there'}"]
    done = subprocess.run(command, cwd=folder, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr[-3000:]
    assert done.stderr.count("has been submitted with SLURM jobid") == 3  # two parts and the merge
    assert (tmp_path / "there" / CUBE).read_bytes() == (tmp_path / "here" / CUBE).read_bytes()
    assert computed(tmp_path / "there").total() == 6
