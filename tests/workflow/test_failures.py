"""A pipeline that failed ends with what failed, why, and the command to go on."""

import os
import subprocess
import sys

import pytest
import yaml

from silostudy.commands.failures import again, ending
from tests.conftest import ROOT, SMALL
from tests.own import THEORY

SAID = """\
[Thu Nov 26 16:47:21 2026]
Error in rule draw_a:
    message: None
    jobid: 3
    input: results/a/pressure.nc
    output: results/a/figures/f.png, results/a/figures/f.svg
    log: {folder}/draw.log (check log file(s) for error details)
    shell:
        python -m silostudy redraw
Error in rule verdict:
    jobid: 4
    output: results/a/parts/verdict
Error in rule draw_a:
    jobid: 3
    output: results/a/figures/f.png, results/a/figures/f.svg
    log: {folder}/draw.log (check log file(s) for error details)
"""


def test_each_failed_job_is_told_once_with_the_last_line_of_its_log(tmp_path, monkeypatch):
    (tmp_path / "draw.log").write_text("Traceback\nValueError: no such thing\n\n")
    monkeypatch.setenv("UV", "/usr/bin/uv")
    assert ending(SAID.format(folder=tmp_path), ["/bin/snakemake", "--cores", "2", "--config", "project=my file.yaml"]) == [
        "silostudy: 2 jobs failed",
        "  draw_a (results/a/figures/f.png)",
        "    ValueError: no such thing",
        f"    all of it: {tmp_path}/draw.log",
        "  verdict (results/a/parts/verdict)",
        "    said above",
        "  once that is mended, go on with: uv run snakemake --cores 2 --config 'project=my file.yaml'",
    ]


def test_without_uv_the_command_is_as_it_was_given(monkeypatch):
    monkeypatch.delenv("UV", raising=False)
    assert again(["/venv/lib/snakemake/__main__.py", "-c2"]) == "snakemake -c2"


@pytest.mark.long
def test_the_pipeline_ends_with_it(tmp_path):
    (tmp_path / "config/studies").mkdir(parents=True)
    broken = THEORY.replace(
        "    return", '    if z.max() == 18.0:  # of the study alone\n        raise RuntimeError("on purpose")\n    return'
    )
    (tmp_path / "config/studies/mine.py").write_text(broken)
    study = SMALL | {"methods": ["frictionless"], "methods_from": "mine.py"}
    (tmp_path / "config/studies/small.yaml").write_text(yaml.safe_dump(study))
    (tmp_path / "config/config.yaml").write_text("studies: [small]\n")
    command = [sys.executable, "-m", "snakemake", "--snakefile", str(ROOT / "Snakefile"), "--cores", "1"]
    environment = {**os.environ, "PYTHONPATH": str(ROOT)}
    done = subprocess.run(command, cwd=tmp_path, env=environment, capture_output=True, text=True)
    assert done.returncode != 0
    *_, job, why, log, go_on = done.stderr.rstrip().splitlines()
    assert job == "  pressure (results/small/pressure.nc)"
    assert why.endswith("on purpose")
    assert log == "    all of it: results/small/logs/pressure.log"
    assert go_on.endswith(f"snakemake --snakefile {ROOT / 'Snakefile'} --cores 1")
