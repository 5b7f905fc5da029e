"""Commands that compute and write, as a user types them."""

import csv
import os
from pathlib import Path

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.cube.io import read
from silostudy.pressure import PRESSURE
from tests.conftest import ROOT
from tests.test_commands.said import WHEAT, said


def test_stages_by_hand(capsys, tmp_path, study):
    path = tmp_path / "small.yaml"
    study["sweep"] = [{"axis": "solid", "values": {"solid": ["wheat_benchmark", "mine"]}}]
    study["materials"] = "mine.csv"
    (tmp_path / "mine.csv").write_text(
        "solid,grain,unit_weight_kN_m3,internal_friction_angle_deg,wall_friction,source,locator\n"
        "mine,fine_grain,7.0,28,0.4,silo_handbook,an example\n"
    )
    path.write_text(yaml.safe_dump(study))
    said(capsys, "cases", path, tmp_path / "cases.csv")
    said(capsys, "pressure", path, tmp_path / "pressure.nc")
    cases = list(csv.DictReader((tmp_path / "cases.csv").open()))
    cube = read(tmp_path / "pressure.nc")
    assert [case["solid"] for case in cases] == ["wheat_benchmark", "mine"]
    assert [case["case"] for case in cases] == list(cube["case"].values)
    assert float(cube["unit_weight"].sel(pressure_method="janssen", solid="mine")) == 7000
    assert "handbook" in said(capsys, "cite", tmp_path / "pressure.nc")
    assert "unknown; known: fig_4_2_11" in said(capsys, "draw", "fig_0", tmp_path / "pressure.nc", tmp_path / "f", status=2)
    told = said(capsys, "draw", "seismic_demand", tmp_path / "pressure.nc", tmp_path / "f", status=2)
    assert "pressure.nc': is of the stage pressure; seismic_demand is drawn from a seismic cube" in told
    two = ("draw", "fig_4_2_11", tmp_path / "pressure.nc", tmp_path / "pressure.nc", tmp_path / "f")
    assert "is of the stage pressure; fig_4_2_11 is drawn from" in said(capsys, *two, status=2)
    told = said(capsys, "draw", "fig_4_2_11", tmp_path / "pressure.nc", tmp_path / "f.one", status=2)
    assert "f.one': must hold no dot in its name" in told
    told = said(capsys, "draw", "governing_load_case", tmp_path / "pressure.nc", tmp_path / "f", status=2)
    assert "holds no " in told
    assert "governing_load_case shows" in told


def test_bench_pressure_writes_its_table(capsys, tmp_path, monkeypatch):
    monkeypatch.setattr("silostudy.commands.bench.CASES", 50)
    monkeypatch.setattr("silostudy.commands.bench.PEER_CASES", 2)
    out = said(capsys, "bench", "pressure", "--output", tmp_path / "bench.csv")
    assert "pressures_per_s" in out
    table = list(csv.DictReader((tmp_path / "bench.csv").open()))
    assert [row["method"] for row in table] == list(PRESSURE)
    assert all(float(row["ratio"]) > 0 for row in table)


def test_a_stage_that_a_study_does_not_have_is_refused(tmp_path, capsys):
    study = str(ROOT / "config/studies/wheat-silo.yaml")
    assert main(["packing", study, str(tmp_path / "packing.nc")]) == 2
    assert "kind = 'pressure': has no stage packing; its stages: pressure" in capsys.readouterr().err
    assert not (tmp_path / "packing.nc").exists()


@pytest.mark.parametrize("threads", [0, 1 + (os.cpu_count() or 1)])
def test_no_more_threads_than_cores(capsys, tmp_path, threads):
    told = said(capsys, "dem", ROOT / "config/scenes/kiyama-17-18.yaml", tmp_path / "o.nc", "--threads", threads, status=2)
    assert f"--threads = {threads}: must be 1 to" in told


def test_no_device_or_pipe_is_replaced(capsys, tmp_path):
    os.mkfifo(tmp_path / "pipe")
    for arguments in (("cases", WHEAT), ("dem", ROOT / "config/scenes/kiyama-17-18.yaml")):
        assert "is a device or a pipe" in said(capsys, *arguments, tmp_path / "pipe", status=2)
    assert (tmp_path / "pipe").is_fifo()


def test_own_solids_cite_their_own_source(capsys, tmp_path, study):
    """In words, or from a .bib beside the file; a lone word that is no key is refused before anything is computed."""
    path = tmp_path / "small.yaml"
    path.write_text(yaml.safe_dump(study | {"materials": "mine.csv", "scene": study["scene"] | {"solid": "mine"}}))
    head = "solid,grain,unit_weight_kN_m3,internal_friction_angle_deg,wall_friction,source,locator\n"
    for source, printed in (("own shear tests 2025", "own shear tests 2025"), ("doe", "Smooth silos. 2026.")):
        (tmp_path / "mine.csv").write_text(f"{head}mine,fine_grain,7.0,28,0.4,{source},page 1\n")
        (tmp_path / "mine.bib").write_text("@book{doe, author={J. Doe}, title={Smooth silos}, year=2026}")
        said(capsys, "check", path)
        said(capsys, "pressure", path, tmp_path / "pressure.nc")
        assert printed in said(capsys, "cite", tmp_path / "pressure.nc")
    (tmp_path / "mine.csv").write_text(f"{head}mine,fine_grain,7.0,28,0.4,doe2025,page 1\n")
    assert "mine.csv, mine: source = 'doe2025': no key of references.bib or of mine.bib" in said(
        capsys, "check", path, status=2
    )


def test_benches_of_accuracy_write_files_of_their_own(monkeypatch):
    written = []
    for module in ("bench_accuracy", "bench_means"):
        monkeypatch.setattr(f"silostudy.commands.{module}.run", lambda chosen: written.append(chosen.output))
    for more in ([], ["--grains", "spheres"], ["--grains", "spheres", "--output", "own.csv"]):
        assert main(["bench", "accuracy", *more]) == 0
    assert written == [Path("results/bench/accuracy.csv"), Path("results/bench/accuracy_of_spheres.csv"), Path("own.csv")]
