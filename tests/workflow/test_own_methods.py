"""A theory and a rule are added by one declaration each: in a file of the user's own, or by lying in their room."""

import os
import shutil
import subprocess
import sys

import pytest
import yaml

from silostudy.cube.io import read
from tests.conftest import ROOT, SMALL
from tests.own import BOTH, RULE, THEORY
from tests.workflow.test_snakemake import planned, snakemake

SHELLS = {
    "kind": "buckling",
    "title": "shells",
    "scene": {"radius_m": 5.0, "radius_over_thickness": 500.0, "relative_bay_length": 20.0, "yield_stress_MPa": 235.0,
              "quality": "B", "manufacture": "fabricated"},
    "sweep": [
        {"axis": "radius_over_thickness", "values": {"radius_over_thickness": [250.0, 500.0]}},
        {"axis": "internal_pressure",
         "values": {"lower_internal_pressure_kPa": [1.0, 9.0], "upper_internal_pressure_kPa": [1.0, 9.0]}},
    ],
    "rules": ["classical", "a_fifth"],
    "methods_from": "mine.py",
    "outputs": ["strength_over_pressure"],
}  # fmt: skip
PUBLISHED = (
    """\
reading,phase,silo.plan,silo.diameter_m,silo.cylinder_depth_m,solid,properties.unit_weight_kN_m3,properties.lateral_pressure_ratio,\
depth_m,wall_normal_pressure_kPa,source,locator
corrected,filling,circular,5.0,18.0,wheat_benchmark,10,0.5,4,20.0,own,by hand
corrected,filling,square,,9.0,wheat_benchmark,10,0.4,9,36.0,own,by hand
""".replace("silo.diameter_m,", "silo.diameter_m,silo.width_m,")
    .replace("5.0,18.0", "5.0,,18.0")
    .replace("square,,", "square,,3.0,")
)


def silostudy(folder, *arguments) -> subprocess.CompletedProcess:
    """The command line with the package that lies in a folder."""
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    command = [sys.executable, "-m", "silostudy", *map(str, arguments)]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)


@pytest.fixture
def project(tmp_path):
    """A folder with the pipeline, the user's own file, two studies that name it and one that does not."""
    for name in ("Snakefile", "silostudy"):
        (shutil.copytree if (ROOT / name).is_dir() else shutil.copy)(ROOT / name, tmp_path / name)
    studies = tmp_path / "config/studies"
    studies.mkdir(parents=True)
    (studies / "mine.py").write_text(BOTH)
    theory = SMALL | {"methods": ["janssen", "frictionless"], "methods_from": "mine.py", "outputs": ["fig_4_2_11"]}
    for name, content in {"theory": theory, "shells": SHELLS, "plain": SMALL}.items():
        (studies / f"{name}.yaml").write_text(yaml.safe_dump(content, sort_keys=False))
    (tmp_path / "config/config.yaml").write_text("studies: [theory, shells, plain]\n")
    return tmp_path


@pytest.mark.long
def test_a_users_theory_and_rule_run_from_file_to_figure(project):
    done = snakemake(project)
    assert done.returncode == 0, done.stderr
    results = project / "results"
    pressure = read(results / "theory/pressure.nc")["wall_normal_pressure"].sel(phase="filling", depth=2.0)
    own = read(results / "theory/pressure.nc").sel(pressure_method="frictionless")
    assert float(pressure.sel(pressure_method="frictionless")) == pytest.approx(
        float(own["lateral_pressure_ratio"] * own["unit_weight"]) * 2.0, rel=1e-12
    )
    shells = read(results / "shells/buckling.nc")["elastic_buckling_stress"]
    assert float((shells.sel(rule="a_fifth") / shells.sel(rule="classical")).max()) == pytest.approx(0.2, rel=1e-12)
    assert "No wall friction" in (results / "theory/figures/fig_4_2_11.svg").read_text()
    assert "frictionless" in (results / "theory/figures/fig_4_2_11.csv").read_text()
    assert (results / "shells/figures/strength_over_pressure.png").stat().st_size > 1000
    assert "J. Doe, Notes on a smooth silo, 2026" in silostudy(project, "cite", results / "theory/pressure.nc").stdout
    assert "J. Doe, Notes on tin cans, 2026" in silostudy(project, "cite", results / "shells/buckling.nc").stdout
    assert read(results / "theory/pressure.nc").attrs["own_methods"].startswith("mine.py ")

    assert planned(project) == {}
    mine = project / "config/studies/mine.py"
    mine.write_text(mine.read_text() + "# changed\n")
    os.utime(mine, (1e9, 1e9))  # older than the cubes, as a file that was put in its place
    jobs = planned(project)
    assert {"pressure", "buckling", "draw_theory_pressure", "draw_shells_buckling"} <= set(jobs)
    assert jobs["pressure"] == 1  # and not that of the study that does not name the file


def test_a_mistake_in_the_file_stops_before_any_job(project):
    (project / "config/studies/mine.py").write_text(THEORY.replace("(Pa)", "") + "\n")
    done = snakemake(project)
    assert done.returncode != 0
    assert (
        "theory.yaml: methods_from = 'mine.py': row frictionless: static: its docstring must name its unit, (Pa)" in done.stderr
    )
    assert "Traceback" not in done.stderr
    assert not (project / "results").exists()


@pytest.fixture
def package(tmp_path):
    """A copy of package and tests, to be added to."""
    shutil.copytree(ROOT / "silostudy", tmp_path / "silostudy", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copytree(ROOT / "tests", tmp_path / "tests", ignore=shutil.ignore_patterns("__pycache__"))
    shutil.copy(ROOT / "pyproject.toml", tmp_path)
    return tmp_path


def proof(folder, room: str, key: str) -> subprocess.CompletedProcess:
    """What the copy's tests of published values say of a key."""
    environment = {**os.environ, "PYTHONPATH": str(folder)}
    command = [
        sys.executable,
        "-m",
        "pytest",
        "-p",
        "no:cacheprovider",
        f"tests/test_{room}/test_published.py",
        "-k",
        key,
    ]
    return subprocess.run(command, cwd=folder, env=environment, capture_output=True, text=True)


@pytest.mark.long
def test_lying_in_the_room_adds_a_theory_to_the_package(package):
    (package / "silostudy/pressure/own.py").write_text(
        THEORY.replace("; no published numbers", "").replace("J. Doe, Notes on a smooth silo, 2026", "silo_handbook")
    )
    listed = silostudy(package, "list", "methods").stdout.splitlines()
    assert listed[-1].startswith("frictionless ")
    assert [line.split()[0] for line in listed[:3]] == ["janssen", "reimbert", "caquot"]  # today's order stays
    assert proof(package, "pressure", "frictionless").returncode == 1  # a row without published values needs to say so
    published = package / "tests/published/pressure/frictionless.csv"
    published.write_text(PUBLISHED)
    done = proof(package, "pressure", "frictionless")
    assert done.returncode == 0, done.stdout
    assert "2 passed" in done.stdout  # its values, and its row
    published.write_text(PUBLISHED.replace("36.0", "36.3"))
    assert "1 failed, 1 passed" in proof(package, "pressure", "frictionless").stdout


@pytest.mark.long
def test_lying_in_the_room_adds_a_rule_to_the_package(package):
    (package / "silostudy/buckling/a_fifth.py").write_text(
        RULE.replace("J. Doe, Notes on tin cans, 2026", "classical_buckling")
    )
    assert any(line.startswith("a_fifth ") for line in silostudy(package, "list", "buckling").stdout.splitlines())
    done = proof(package, "buckling", "a_fifth")
    assert done.returncode == 0, done.stdout
    assert "2 passed" in done.stdout  # its row and its equations


def test_a_stamp_covers_what_lies_in_a_room(package):
    code = "from silostudy.stamp import stamp; print(stamp('compute/pressure'), stamp('compute/buckling'))"

    def stamps() -> list[str]:
        environment = {**os.environ, "PYTHONPATH": str(package)}
        done = subprocess.run(
            [sys.executable, "-c", code], cwd=package, env=environment, capture_output=True, text=True, check=True
        )
        return done.stdout.split()

    before = stamps()
    (package / "silostudy/pressure/own.py").write_text(THEORY)
    after = stamps()
    assert after[0] != before[0]
    assert after[1] == before[1]
