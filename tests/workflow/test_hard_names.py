"""Names full of signs of shells, patterns and regular expressions run the whole pipeline or are refused in one line."""

import re
import string
import subprocess
from contextlib import suppress
from pathlib import Path

import pytest
import yaml
from snakemake.target_jobs import parse_target_jobs_cli_args
from snakemake_interface_executor_plugins.utils import TargetSpec, encode_target_jobs_cli_args, format_cli_arg

from silostudy.cube.io import read
from silostudy.errors import BadInput
from silostudy.files import check_sent
from tests.workflow.projects import RESULTS, SCENE, STUDIES, SWEEP, make, snakemake, tree

SHOWN = ["figures/fig_4_2_11.csv", "figures/fig_4_2_11.png", "figures/fig_4_2_11.svg"]


def files(folder: Path) -> set[str]:
    """What a reader sees: nothing hidden, and neither logs nor the parts of sweeps."""
    paths = [path.relative_to(folder) for path in folder.rglob("*") if path.is_file()]
    return {str(path) for path in paths if not {"logs", "parts"} & {*path.parts} and path.name[0] != "."}


@pytest.mark.long
def test_everything_is_made_and_no_stray_file(run):
    folder, _ = run
    assert {path.name for path in folder.iterdir()} == {"config", ".snakemake", RESULTS}
    assert {path.name for path in folder.parent.iterdir()} == {folder.name}
    results = folder / RESULTS
    assert {path.name for path in results.iterdir()} == {*STUDIES, SWEEP, "dem", "captions", ".lock"}
    for name in STUDIES:
        assert files(results / name) == {"cases.csv", "pressure.nc", "cost/pressure.tsv", *SHOWN}
    assert files(results / SWEEP) == {"cases.csv", "scenes.nc", "scenes-failed.csv"}
    assert files(results / "dem") == {f"{SCENE}.nc"}
    assert read(results / SWEEP / "scenes.nc")["case_outcome"].values.tolist() == [[0], [0]]


@pytest.mark.long
def test_rules_of_studies_have_names_of_their_own(run):
    drawn = re.findall(r"^(?:local)?rule (draw_\w+):", run[1], flags=re.MULTILINE)
    assert len(drawn) == len(STUDIES)
    assert {"draw_a_b_pressure", "draw_a_b_pressure_2"} < set(drawn)


@pytest.mark.long
def test_the_report_has_every_caption(finished):
    done = snakemake(finished, "--report", "report.html")
    assert done.returncode == 0, done.stdout[-3000:]
    text = (finished / "report.html").read_text()
    assert len(re.findall(r"Drawn from <tt (?:(?!</tt>).)*/pressure\.nc(?:</span>)?</tt>", text)) == len(STUDIES)
    assert "system-message" not in text  # of docutils


@pytest.mark.long
def test_a_job_elsewhere_takes_its_study_by_name(finished):
    """As an executor for other machines starts it: the plan is the one that was written."""
    cube = finished / RESULTS / SWEEP / "scenes.nc"
    before = cube.read_bytes()
    cube.unlink()
    elsewhere = ["--mode", "remote", "--force", "--no-hooks", "--nolock", "--ignore-incomplete", "--allowed-rules", "merge"]
    done = snakemake(finished, *elsewhere, "--target-jobs", f"merge:study={SWEEP},sweep=scenes")
    assert done.returncode == 0, done.stdout[-3000:]
    assert cube.read_bytes() == before


def test_names_that_are_spoilt_on_the_way_to_other_machines_are_refused():
    """Every sign, through Snakemake's own writing and reading and a shell between them."""
    names = [name for sign in string.printable + "ü" for name in (f"a{sign}b", f"{sign}b", f"a{sign}")]
    specs = [encode_target_jobs_cli_args([TargetSpec("part", {"study": name, "part": "1"})]) for name in names]
    script = "\n".join(f"printf '%s\\0' {format_cli_arg('', spec)}; echo" for spec in specs)
    said = subprocess.run(["bash", "-c", script], capture_output=True, text=True, check=True).stdout
    for name, entry in zip(names, said.split("\0\n"), strict=False):
        came = None
        with suppress(ValueError):
            came = parse_target_jobs_cli_args([entry])[0].wildcards_dict["study"]
        if came != name:
            with pytest.raises(BadInput, match="jobs elsewhere can be sent no"):
                check_sent([name], [])
    check_sent([STUDIES[1], "wei zen;$HOME+([|]ü&*?#~^=`x`é{ 1-2 }"], [Path("r es;$HOME+([|ü&*,?#{-}")])


@pytest.mark.parametrize(("what", "name", "told"), [
    ("results", "r{x}", "results = 'r{x}': {word} in braces"),
    ("studies", "a\nb", r"studies = 'a\nb': a line break"),
    ("scenes", "a\\b", r"scenes = 'a\\b': a backslash"),
    ("results", "2024", "results = 2024: Snakemake reads this as no text"),
])  # fmt: skip
def test_what_cannot_be_carried_is_refused_in_one_line(tmp_path, what, name, told):
    make(tmp_path)
    if what != "results":
        folder = tmp_path / "config" / what
        known = STUDIES[1] if what == "studies" else SCENE
        (folder / f"{known}.yaml").rename(folder / f"{name}.yaml")
        asked = {"studies": [STUDIES[2]], what: [name]}
        (tmp_path / "config/config.yaml").write_text(yaml.safe_dump(asked))
    before = tree(tmp_path)
    done = snakemake(tmp_path, results=name if what == "results" else RESULTS)
    assert done.returncode != 0
    assert sum(told in line for line in done.stdout.splitlines()) == 1
    assert tree(tmp_path) == before
