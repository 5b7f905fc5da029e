"""The `silostudy` command as a user types it."""

import csv
import os
import re
from pathlib import Path

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.choice.fronts import FRONTS
from silostudy.commands.explain_keys import key_explanation
from silostudy.commands.explain_scene import PARTS
from silostudy.cube.io import read
from silostudy.pressure import PRESSURE
from silostudy.stages import FILE_KINDS
from silostudy.tables.asked import quantities
from tests.conftest import ROOT
from tests.own import BOTH, LAW

WHEAT = str(ROOT / "config/studies/wheat-silo.yaml")


def said(capsys, *arguments, status=0):
    assert main(list(map(str, arguments))) == status
    captured = capsys.readouterr()
    return captured.out if status == 0 else captured.err


@pytest.mark.parametrize(
    ("what", "expected"),
    [
        ("methods", PRESSURE),
        ("solids", ["cement", "wheat_benchmark"]),
        ("walls", ["roughness_5"]),
        ("outputs", ["fig_4_2_11"]),
        ("measurements", ["thompson_12_8", "jarrett_corner"]),
    ],
)
def test_list(capsys, what, expected):
    out = said(capsys, "list", what)
    for key in expected:
        assert re.search(rf"^{key} ", out, re.MULTILINE)


def test_compare_says_what_was_measured_in_a_silo_of_its_size(capsys):
    flags = ("--solid", "maize_e1", "--wall", "d3", "--methods", "caquot", "as3774_1996")
    told = said(capsys, "compare", "--diameter", 11, "--depth", 14, *flags)
    assert "26.9 kPa at 11.9 m, filling, maize: next below as3774_1996 (-5%); next above caquot (+2%)" in told
    assert "measured" not in said(capsys, "compare", "--diameter", 11.5, "--depth", 14, *flags)


def test_list_studies(capsys):
    assert "wheat-family" in said(capsys, "list", "studies", "--studies", ROOT / "config/studies")
    assert "holds no study files" in said(capsys, "list", "studies", "--studies", ROOT / "tests", status=2)


@pytest.mark.parametrize("method", PRESSURE)
def test_explain_every_method(capsys, method):
    out = said(capsys, "explain", method)
    for part in ("formula", "range", "plans", "gives wall_normal_pressure", "symbols", f"source    {PRESSURE[method].source}"):
        assert part in out


def test_explain_names_its_symbols(capsys):
    out = said(capsys, "explain", "jenike_mass_flow")
    assert "nu: poisson_ratio (1)" in out
    assert "R = A/U: hydraulic_radius (m)" in out


def test_explain_accuracy_names_every_kind(capsys):
    out = said(capsys, "explain", "accuracy")
    assert "seismic, effective_mass_coefficient: coefficient found" in out
    assert "sets identification.refinement" in out
    assert "shell, wall_force: friction force of the whole wall" in out  # a shell study is a pressure study too
    assert "buckling: may not ask: none of its settings decides a numerical error" in out
    for row in FRONTS:
        assert f"{row.kind}, {row.quantity}: {quantities([row.kind])[row.quantity].title}" in out
        assert f"error goes with {row.scaled_by or 'no trait'}; measured within" in out


def test_explain_tells_the_sources_errors(capsys):
    assert "printed 0.584; right: 0.548" in said(capsys, "explain", "caquot")
    assert "unknown; known: janssen" in said(capsys, "explain", "jansen", status=2)


def test_compare_by_flags(capsys, tmp_path):
    stem = tmp_path / "picture"
    out = said(capsys, "compare", "--diameter", 5, "--depth", 18, "--solid", "wheat_benchmark", "--hopper-half-angle", 45,
               "--figure", stem)  # fmt: skip
    janssen = next(line for line in out.splitlines() if line.startswith("janssen, filling"))
    assert janssen.split()[2:6] == ["11.36", "16.93", "19.66", "21.00"]
    assert "67.0%" in janssen  # 1 - exp-type share of the weight on the wall
    assert stem.with_suffix(".png").is_file()


def test_compare_by_file_and_its_refusals(capsys):
    assert "deutsch, discharge" in said(capsys, "compare", WHEAT)
    assert "without sweep" in said(capsys, "compare", ROOT / "config/studies/wheat-family.yaml", status=2)
    for flag, value, told in (("--diameter", 3, "3.0"), ("--methods", "janssen", "['janssen']"), ("--wall", "d1", "'d1'")):
        wrong = said(capsys, "compare", WHEAT, flag, value, status=2)
        assert f"{flag} = {told}: write it into {WHEAT}" in wrong
    assert "--solid = None: is missing" in said(capsys, "compare", "--diameter", 5, "--depth", 18, status=2)
    wrong = said(capsys, "compare", "--diameter", -5, "--depth", 18, "--solid", "wheat_benchmark", status=2)
    assert "scene.silo.diameter_m = -5.0: must be greater than 0" in wrong


def test_compare_says_that_friction_was_capped(capsys):
    flags = ["--diameter", 5, "--depth", 18, "--solid", "maize", "--methods", "janssen"]
    assert "capped" not in said(capsys, "compare", *flags, "--wall", "grooved_concrete")
    assert "note: maize on its own wall friction: wall friction 2 capped" in said(
        capsys, "compare", *flags, "--wall-friction", 2
    )


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
        monkeypatch.setattr("silostudy.commands.studies.LOOKED", looked)
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


def test_a_users_own_file_is_listed_explained_and_compared(capsys, tmp_path):
    (tmp_path / "mine.py").write_text(BOTH)
    (tmp_path / "law.py").write_text(LAW)
    mine, law = ("--methods-from", tmp_path / "mine.py"), ("--methods-from", tmp_path / "law.py")
    assert "frictionless " in said(capsys, "list", "methods", *mine)
    assert "a_fifth " in said(capsys, "list", "buckling", *mine)
    assert re.search(r"^normal +stiffer +A stiffer spring", said(capsys, "list", "laws", *law), re.MULTILINE)
    told = said(capsys, "explain", "frictionless", *mine)
    assert "  formula   p_h = K gamma z" in told
    assert told.count("J. Doe, Notes on a smooth silo, 2026, page 3") == 1
    assert "takes     stiffening (1), positive: from stiffening" in said(capsys, "explain", "stiffer", *law)
    silo = ("--diameter", 5, "--depth", 18, "--solid", "wheat_benchmark")
    table = said(capsys, "compare", *silo, "--methods", "frictionless", *mine)
    own = next(line for line in table.splitlines() if line.startswith("frictionless, filling"))
    assert "63.55" in own  # K gamma z at 18 m
    assert said(capsys, "compare", *silo, "--methods", "frictionles", *mine, status=2).count("\n") == 1
    assert "unknown; known: janssen" in said(capsys, "explain", "frictionless", status=2)
    assert "--methods-from = " in said(capsys, "compare", WHEAT, *mine, status=2)
    scene = ROOT / "config/scenes/kiyama-17-18.yaml"
    assert f"write `methods_from` into {scene}" in said(capsys, "explain", scene, *mine, status=2)


def test_a_law_is_explained_in_every_family_that_has_its_key(capsys):
    told = said(capsys, "explain", "spring-slider")
    assert "rolling_stiffness (N), zero or more: from rolling_stiffness_N" in told
    assert "tangential_stiffness (N m-2)" in told


@pytest.mark.parametrize("part", PARTS)
def test_every_part_of_a_scene_is_listed_and_explained(capsys, part):
    listed = said(capsys, "list", part)
    for key, row in PARTS[part].items():
        assert re.search(rf"^{key} +{re.escape(row.title)}$", listed, re.MULTILINE)
        assert f"{row.title} ({key}, of {part})" in said(capsys, "explain", key)


def test_kinds_are_listed_with_their_cubes_under_them(capsys):
    told = said(capsys, "list", "kinds").split("\n")
    assert told[0].startswith("What a file says as `kind`")
    place = next(number for number, line in enumerate(told) if line.startswith("scenes "))
    assert told[place + 1].split()[0] == "scenes.nc"
    assert told[place + 2].split()[0] == "beside.nc"
    assert told[place + 2].endswith("(where the study has a section codes)")


@pytest.mark.parametrize("kind", FILE_KINDS)
def test_every_kind_explains_its_keys(capsys, kind):
    told = said(capsys, "explain", kind)
    assert f"(kind: {kind})" in told
    for name, field in FILE_KINDS[kind].study.model_fields.items():
        assert re.search(rf"^  {name}( \(.*?\))?: {re.escape(field.description)}", told, re.MULTILINE)


def test_every_key_that_a_shipped_file_says_is_explained():
    contents = [
        yaml.safe_load(path.read_text()) for part in ("studies", "scenes") for path in (ROOT / "config" / part).glob("*.yaml")
    ]
    said_there = {key for content in contents for key in content}
    assert {"codes", "fillings", "events"} < said_there
    assert [key for key in sorted(said_there) if not key_explanation(key)] == []


def test_a_key_is_explained_with_its_places_and_its_own_keys(capsys):
    told = said(capsys, "explain", "sample")
    assert "key sweep.sample of kind accuracy, buckling, grains" in told
    assert "      count: cases [must be given]" in told
    assert "key checks of kind shell" in said(capsys, "explain", "checks")  # beside the topic of that name


def test_explain_names_a_sections_keys_units_and_choices(capsys):
    told = said(capsys, "explain", "dem")
    assert "      gap_m (m): gap between neighbours at the start [must be given]" in told
    assert "tangential: law of the tangential force [spring-slider] {none, spring-slider," in told
    assert "[17-18] {17-18, 17-19, velocity-verlet}" in told


def test_check_builds_a_scene(capsys, tmp_path):
    """Its step is told or refused, and the files that it names are read."""
    scene = yaml.safe_load((ROOT / "config/scenes/kiyama-17-18.yaml").read_text())
    path = tmp_path / "scene.yaml"
    path.write_text(yaml.safe_dump(scene))
    assert re.search(r"^  \d+ discs, at most [\d,]+ steps of \S+ s$", said(capsys, "check", path), re.MULTILINE)
    path.write_text(yaml.safe_dump(scene | {"quake": {"file": "nowhere.csv"}}))
    assert "nowhere.csv" in said(capsys, "check", path, status=2)
    undamped = scene["discs"] | {"normal_damping_N_s_m2": 0.0}
    path.write_text(yaml.safe_dump(scene | {"discs": undamped, "march": scene["march"] | {"integrator": "17-19"}}))
    assert "feeds energy into springs without a dashpot" in said(capsys, "check", path, status=2)


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


def test_compare_tells_the_load_cases_beside_the_symmetric_ones(capsys, tmp_path):
    silo = {"plan": "circular", "diameter_m": 6.0, "cylinder_depth_m": 18.0, "outlet_eccentricity_m": 2.0}
    study = {
        "kind": "pressure",
        "title": "eccentric",
        "scene": {"silo": silo, "solid": "wheat_e1", "wall": "d2"},
        "methods": ["en1991_4", "en1991_4_eccentric", "as3774_1996"],
        "relative_depth": [0.5, 1.0],
    }
    (tmp_path / "study.yaml").write_text(yaml.safe_dump(study))
    out = said(capsys, "compare", tmp_path / "study.yaml")
    for part in ("patch load", "C_b 1.00", "k_c 0.60, within", "far side up to +23.3%", "near side -35.0% within 55 deg"):
        assert part in out
    assert "action assessment class of EN 1991-4: 2 or higher" in out
    study["scene"]["silo"] = {"plan": "square", "width_m": 5.0, "cylinder_depth_m": 18.0}
    (tmp_path / "study.yaml").write_text(yaml.safe_dump(study | {"phases": ["filling"]}))
    assert "band of pressure all round" in said(capsys, "compare", tmp_path / "study.yaml")


def test_benches_of_accuracy_write_files_of_their_own(monkeypatch):
    written = []
    for module in ("bench_accuracy", "bench_means"):
        monkeypatch.setattr(f"silostudy.commands.{module}.run", lambda chosen: written.append(chosen.output))
    for more in ([], ["--grains", "spheres"], ["--grains", "spheres", "--output", "own.csv"]):
        assert main(["bench", "accuracy", *more]) == 0
    assert written == [Path("results/bench/accuracy.csv"), Path("results/bench/accuracy_of_spheres.csv"), Path("own.csv")]
