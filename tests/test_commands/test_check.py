"""`silostudy check` as a user types it: of a study, a scene, a project."""

import re
import shutil
from pathlib import Path

import pytest
import yaml

from silostudy.__main__ import main
from tests.conftest import ROOT
from tests.test_commands.said import WHEAT, said


def test_check_counts(capsys):
    out = said(capsys, "check", ROOT / "config/studies/wheat-family.yaml")
    assert "1584 case(s): diameter 6 x slenderness 11 x solid 8 x wall 3" in out
    assert "1900800 values a quantity" in out
    assert "flour on painted_concrete: no wall_friction in the tables" in out


def test_check_refuses_a_price_where_there_is_none(capsys):
    for file, kind in ((WHEAT, "pressure"), (ROOT / "config/scenes/kiyama-17-18.yaml", "dem")):
        assert f"--price = True: kind {kind} has none to tell" in said(capsys, "check", file, "--price", status=2)


def test_a_study_goes_by_its_name_whatever_stands_in_it(capsys, tmp_path, monkeypatch):
    (tmp_path / "config/studies").mkdir(parents=True)
    (tmp_path / "config/studies/wheat.v2.yaml").write_bytes(Path(WHEAT).read_bytes())
    (tmp_path / "wheat.v2").mkdir()
    monkeypatch.chdir(tmp_path)
    assert "1 case(s)" in said(capsys, "check", "wheat.v2")
    said(capsys, "cases", "wheat.v2", "cases.csv")
    assert Path("cases.csv").read_text().startswith("case")


def test_check_tells_the_price_of_a_sweep(capsys):
    out = said(capsys, "check", ROOT / "config/studies/discharge-thousand.yaml")
    assert "1000 case(s): slit_width 10 x wall_friction 10 x filling 10" in out
    assert re.search(r"about [0-9.]+ min of one core", out)


def test_check_looks_at_some_cases_of_a_long_sweep(capsys, monkeypatch):
    """The price is that of all."""
    study = ROOT / "config/studies/discharge-thousand.yaml"
    told = []
    for looked in (1000, 100):
        monkeypatch.setattr("silostudy.commands.check.LOOKED", looked)
        told.append(said(capsys, "check", study))
    whole, part = told
    assert "1000 case(s)" in part
    assert "note: 100 of them, drawn at random, are looked at here" in part
    assert "drawn at random" not in whole
    minutes = [float(re.search(r"about ([0-9.]+) min of one core", out)[1]) for out in told]
    assert minutes[1] == pytest.approx(minutes[0], rel=0.05)


def test_a_study_of_too_many_cases_is_refused_at_once(capsys, tmp_path):
    content = yaml.safe_load((ROOT / "config/studies/discharge-slit.yaml").read_text()) | {"outputs": []}
    values = {"start": 0.0, "stop": 0.5, "count": 1001}
    content["sweep"] = [{"axis": axis, "values": {f"{axis}.sliding_friction": values}} for axis in ("walls", "discs")]
    (tmp_path / "study.yaml").write_text(yaml.safe_dump(content))
    told = said(capsys, "check", tmp_path / "study.yaml", status=2)
    assert "sweep = 1002001: makes more cases than a study may have, 1,000,000" in told


def test_check_builds_a_scene(capsys, tmp_path):
    """Its step is told or refused, and the files that it names are read."""
    scene = yaml.safe_load((ROOT / "config/scenes/kiyama-17-18.yaml").read_text())
    path = tmp_path / "scene.yaml"
    path.write_text(yaml.safe_dump(scene))
    assert re.search(
        r"^  \d+ discs, at most [\d,]+ steps of \S+ s: about [0-9.]+ s of one core$", said(capsys, "check", path), re.MULTILINE
    )
    path.write_text(yaml.safe_dump(scene | {"quake": {"file": "nowhere.csv"}}))
    assert "nowhere.csv" in said(capsys, "check", path, status=2)
    undamped = scene["discs"] | {"normal_damping_N_s_m2": 0.0}
    path.write_text(yaml.safe_dump(scene | {"discs": undamped, "march": scene["march"] | {"integrator": "17-19"}}))
    assert "feeds energy into springs without a dashpot" in said(capsys, "check", path, status=2)


def project(folder: Path, content: dict, **studies: dict) -> Path:
    """A project file in a folder, with its studies beside it."""
    (folder / "studies").mkdir()
    for name, study in studies.items():
        (folder / "studies" / f"{name}.yaml").write_text(yaml.safe_dump(study))
    (folder / "project.yaml").write_text(yaml.safe_dump(content))
    return folder / "project.yaml"


def shipped(folder: Path, *studies: str) -> Path:
    """A project of shipped studies in a folder where nothing was computed yet."""
    shutil.copytree(ROOT / "config/studies", folder / "config/studies")
    (folder / "config/project.yaml").write_text(yaml.safe_dump({"studies": list(studies)}))
    return folder / "config/project.yaml"


def test_check_looks_at_all_that_a_project_names(capsys, tmp_path):
    """A study whose solid another one of the project makes is told as such."""
    out = said(capsys, "check", shipped(tmp_path, "spheres-laboratory", "silo-of-spheres-codes", "silo-of-spheres"))
    alone = said(capsys, "check", tmp_path / "config/studies/spheres-laboratory.yaml")
    assert alone in out
    assert "8 case(s), waits for a solid that spheres-laboratory makes first" in out
    minutes = [float(minutes) for minutes in re.findall(r"about ([0-9.]+) min of one core", out)]
    assert len(minutes) == 3
    assert minutes[-1] == pytest.approx(sum(minutes[:-1]), abs=0.1)
    assert "of silo-of-spheres-codes no time is known before" in out


def test_check_of_a_project_tells_the_time_of_its_scenes(capsys):
    out = said(capsys, "check", ROOT / "config/bin.yaml")
    first, last = re.findall(r"about ([0-9.]+ s) of one core", out)
    assert first == last
    assert "bin.yaml: 1 file(s), together about" in out


def test_check_of_a_project_tells_the_mistakes_of_all_its_studies(capsys, tmp_path, study):
    wrong = study | {"methods": ["jansen"]}
    path = project(tmp_path, {"studies": ["one", "two", "three"]}, one=wrong, two=study, three=wrong)
    assert main(["check", str(path)]) == 2
    told = capsys.readouterr()
    assert told.err.count("'jansen'") == 2
    assert "two.yaml: " in told.out
    assert "together" not in told.out
    assert "--price = True: is of one study" in said(capsys, "check", path, "--price", status=2)


@pytest.mark.parametrize(
    ("name", "told"),
    [
        ("silo-of-spheres", "codes.study = 'silo-of-spheres-codes': must be named in"),
        ("silo-of-spheres-codes", "the study spheres-laboratory makes it, run that first"),
    ],
)
def test_check_of_a_project_asks_for_the_studies_that_its_own_take_from(capsys, tmp_path, name, told):
    """Whose cube they take, as Snakemake asks too, and whose solid."""
    assert told in said(capsys, "check", shipped(tmp_path, name), status=2)


@pytest.mark.parametrize(
    ("command", "file", "told"),
    [
        ("explain", "config/spheres.yaml", "is a project, which names studies and scenes: `silostudy check"),
        ("compare", "config/spheres.yaml", "is a project"),
        ("explain", "config/studies/wheat-silo.yaml", "kind = 'pressure': is a study: `silostudy check"),
        ("compare", "config/scenes/wheat-bin.yaml", "kind = 'dem': is a scene: `silostudy explain"),
    ],
)
def test_a_file_of_another_sort_is_told_in_one_line(capsys, command, file, told):
    line = said(capsys, command, ROOT / file, status=2)
    assert told in line
    assert line.count("\n") == 1


def many(study: dict, *sweep: dict) -> dict:
    return {key: value for key, value in study.items() if key != "depth_m"} | {"relative_depth": [0.5, 1.0], "sweep": [*sweep]}


def test_check_of_a_study_of_formulas_looks_at_a_part_of_each_axis(capsys, tmp_path, monkeypatch, study):
    monkeypatch.setattr("silostudy.commands.check.LOOKED", 20)
    depths = {"axis": "depth_of_wall", "values": {"silo.cylinder_depth_m": {"start": 10.0, "stop": 500.0, "count": 30}}}
    sizes = {"axis": "diameter", "values": {"silo.diameter_m": [4.0, 5.0, 6.0]}}
    path = tmp_path / "study.yaml"
    path.write_text(yaml.safe_dump(many(study, depths, sizes)))
    out = said(capsys, "check", path)
    assert "90 case(s): depth_of_wall 30 x diameter 3" in out
    assert "note: 18 of them, evenly over the axes, are looked at here: what follows is of these" in out
    assert "cylinder_depth_m = 500 is unusual" in out  # the axis' end
    ranges = {"silo.diameter_m": {"start": 4.0, "stop": 6.0}, "silo.cylinder_depth_m": {"start": 10.0, "stop": 20.0}}
    path.write_text(yaml.safe_dump(many(study, {"axis": "sample", "sample": {"count": 90, "ranges": ranges}})))
    assert "note: 20 of them, evenly" in said(capsys, "check", path)


def test_notes_that_differ_by_numbers_alone_are_gathered(capsys, tmp_path, study):
    depths = {"axis": "depth_of_wall", "values": {"silo.cylinder_depth_m": {"start": 10.0, "stop": 500.0, "count": 50}}}
    path = tmp_path / "study.yaml"
    path.write_text(yaml.safe_dump(many(study, depths)))
    lines = [line for line in said(capsys, "check", path).split("\n") if "cylinder_depth_m =" in line]
    assert lines == [f"  note: cylinder_depth_m = {depth} is unusual: mostly 0.05 to 100" for depth in (110, 500)]
    assert "  38 more such lines" in said(capsys, "check", path)
