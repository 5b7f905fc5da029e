"""Studies of shells: one clear line for a mistake, results for what is asked, figures with labels and units."""

import copy
import re
import subprocess
import sys
from pathlib import Path

import pytest

from silostudy.__main__ import main
from silostudy.choice.expand import expand_file
from silostudy.compute.buckling import buckling_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
from silostudy.figures import required_thickness, shell_over_depth, test_over_prediction
from tests.conftest import ROOT, expanded
from tests.test_buckling.test_shell import STUDY as SILO

CYLINDER = {
    "kind": "buckling",
    "title": "a small shell study",
    "scene": {
        "radius_m": 5.0,
        "thickness_mm": 10.0,
        "bay_length_m": 4.0,
        "yield_stress_MPa": 235.0,
        "quality": "B",
        "manufacture": "fabricated",
    },
    "rules": "all",
}


def cylinder(**changes):
    return {**CYLINDER, "scene": {**CYLINDER["scene"], **changes}}


def silo(**changes):
    content = copy.deepcopy(SILO)
    content["scene"]["shell"] |= changes
    return content


ENDS = {"axis": "wall_friction_end", "values": {"wall_friction_end": ["mean", "upper"]}}
DIAMETERS = {"axis": "diameter", "values": {"silo.diameter_m": [5.0, 8.0]}}
MISTAKES = {
    "zero thickness": (cylinder(thickness_mm=0.0), "scene.thickness_mm = 0.0: must be greater than 0"),
    "zero bay": (cylinder(bay_length_m=0.0), "scene.bay_length_m = 0.0: must be greater than 0"),
    "ring without area": (cylinder(ring_area_cm2=0.0), "scene.ring_area_cm2 = 0.0: must be greater than 0"),
    "two thicknesses": (cylinder(radius_over_thickness=500.0), "give either thickness_mm or radius_over_thickness"),
    "two ring areas": (cylinder(ring_area_cm2=1.0, ring_area_ratio=0.1), "give either ring_area_cm2 or ring_area_ratio"),
    "crossed pressures": (
        cylinder(lower_internal_pressure_kPa=2.0, upper_internal_pressure_kPa=1.0),
        "upper_internal_pressure_kPa must not be below",
    ),
    "unknown quality": (cylinder(quality="D"), "scene.quality = 'D': must be 'A', 'B' or 'C'"),
    "unknown end factor": (cylinder(end_factor=2), "scene.end_factor = 2: must be 6, 3 or 1"),
    "unknown rule": ({**CYLINDER, "rules": ["miler"]}, "rules.0 = 'miler': unknown; known: miller1977, classical"),
    "no rule": ({**CYLINDER, "rules": []}, "a study needs a rule; known: miller1977"),
    "unknown test": ({**CYLINDER, "scene": {"test": "99", "quality": "B"}}, "scene.test = '99': must be '1', '1.1'"),
    "sizes beside a test": (
        {**CYLINDER, "scene": {"test": "1", "quality": "B", "thickness_mm": 1.0}},
        "scene.thickness_mm = 1.0: unknown key",
    ),
    "rings of a silo without area": (
        silo(rings={"spacing_m": 1.0}),
        "scene.shell.rings.area_cm2: is missing",
    ),
    "strakes that end early": (
        silo(strakes=[{"down_to": 0.5, "thickness_mm": 6.0}]),
        "the strakes' down_to must increase and end at 1",
    ),
    "strakes out of order": (
        silo(strakes=[{"down_to": 0.9, "thickness_mm": 6.0}, {"down_to": 0.5, "thickness_mm": 6.0}]),
        "the strakes' down_to must increase and end at 1",
    ),
    "figure of strakes without strakes": (
        {**silo(strakes=[]), "sweep": [ENDS], "outputs": ["shell_over_depth"]},
        "output shell_over_depth needs scene.shell.strakes",
    ),
    "axis that a figure cannot show": (
        {**silo(), "sweep": [ENDS, DIAMETERS], "outputs": ["shell_over_depth"]},
        "output shell_over_depth can show no axes but wall_friction_end",
    ),
}


@pytest.mark.parametrize("case", MISTAKES)
def test_mistake_is_one_clear_line(case):
    content, message = MISTAKES[case]
    with pytest.raises(BadInput, match=re.escape(message)) as caught:
        expanded(content)
    assert all(line.startswith("small.yaml") for line in str(caught.value).splitlines())


def test_upper_friction_needs_to_know_how_far():
    content = copy.deepcopy(SILO)
    content["scene"] |= {"wall_friction_end": "upper", "properties": {}}
    with pytest.raises(
        BadInput, match=r"wall_friction_end = 'upper': needs one of Pieper's roughness groups as wall, or .*a_mu and a_K"
    ):
        expanded(content)


def test_square_silo_has_no_shell():
    content = copy.deepcopy(SILO)
    content["scene"]["silo"] = {"plan": "square", "width_m": 4.0, "cylinder_depth_m": 20.0}
    with pytest.raises(BadInput, match=re.escape("scene.silo.plan = 'square': must be 'circular'")):
        expanded(content)


def test_sizes_and_ratios_are_the_same_shell():
    ratios = cylinder(radius_over_thickness=500.0, relative_bay_length=4.0 / 0.05**0.5, ring_area_ratio=0.1)
    for name in ("thickness_mm", "bay_length_m"):
        ratios["scene"].pop(name)
    one, other = (expanded(content).cases[0].scene for content in (cylinder(ring_area_cm2=40.0), ratios))
    assert vars(one) == pytest.approx(vars(other), nan_ok=True)  # the whole length of a ringed cylinder is not known


def test_map_covers_what_it_says():
    cube = buckling_cube(expand_file(ROOT / "config/studies/buckling-map.yaml"))
    for axis, least, largest in (
        ("radius_over_thickness", 100, 3000),
        ("relative_bay_length", 0.5, 100),
        ("ring_area_ratio", 0, 0.4),
    ):
        assert float(cube[axis].min()) == pytest.approx(least)
        assert float(cube[axis].max()) == pytest.approx(largest)
    assert float(cube["buckling_stress"].sel({"rule": "miller1977"}).notnull().mean()) > 0.9


@pytest.mark.parametrize("name", ["miller-1977", "buckling-map", "buckling-pressure", "steel-wheat-silo"])
def test_cubes_keep_to_cf_1_11(name, tmp_path):
    path, expansion = tmp_path / "cube.nc", expand_file(ROOT / f"config/studies/{name}.yaml")
    write(drawn_shell(name) if expansion.study.kind == "shell" else buckling_cube(expansion), path)
    checker = Path(sys.executable).parent / "compliance-checker"
    done = subprocess.run([checker, "-t", "cf:1.11", "-c", "strict", path], capture_output=True, text=True)
    assert "All tests passed!" in done.stdout, done.stdout + done.stderr
    assert read(path).attrs["references"]


def test_commands(tmp_path, capsys):
    assert main(["explain", "en1993_4_1_2007"]) == 0
    assert "second-hand transcription" in capsys.readouterr().out
    assert main(["explain", "miller1977"]) == 0
    shown = capsys.readouterr().out
    assert "printed junction at M = (J/C)^(3/5); right: M = (J/C)^(5/3)" in shown
    assert main(["list", "buckling"]) == 0
    assert "nasa_sp8007" in capsys.readouterr().out
    study, cube = ROOT / "config/studies/miller-1977.yaml", tmp_path / "buckling.nc"
    assert main(["buckling", str(study), str(cube)]) == 0
    for table in ("miller_statistics", "miller_tests"):
        assert main(["draw", table, str(cube), str(tmp_path / table)]) == 0
    text = (tmp_path / "miller_tests.csv").read_text()
    assert "printed inner diameter 125 in., right inner radius 125 in." in text
    assert main(["shell", str(study), str(cube), str(tmp_path / "shell.nc")]) == 2
    assert "kind = 'buckling': has no stage shell; its stages: buckling" in capsys.readouterr().err


def drawn_shell(name):
    expansion = expand_file(ROOT / f"config/studies/{name}.yaml")
    return shell_cube(expansion, pressure_cube(expansion))


def test_shell_over_depth_is_labelled(tmp_path, kept):
    shell_over_depth.draw(drawn_shell("steel-wheat-strakes"), tmp_path / "figure")
    axes = kept[0].axes
    assert axes[0].yaxis_inverted()
    assert axes[0].get_ylabel() == "depth z (m)"
    labels = [" ".join(panel.get_xlabel().split()) for panel in axes]
    assert labels[0] == "axial wall force (kN/m)"
    assert labels[2] == "axial stress; buckling stress (MPa)"
    texts = {text.get_text() for text in axes[0].texts}
    assert texts == {"t = 4 mm", "t = 6 mm", "t = 8 mm", "t = 9 mm"}


def test_figure_says_which_end_of_the_friction_it_misses(tmp_path):
    content = silo()
    content["sweep"] = [{"axis": "wall_friction_end", "values": {"wall_friction_end": ["mean"]}}]
    expansion = expanded(content)
    with pytest.raises(BadInput, match=r"axis wall_friction_end = \['mean'\]: the figure also needs upper"):
        shell_over_depth.draw(shell_cube(expansion, pressure_cube(expansion)), tmp_path / "figure")


def test_required_thickness_shows_every_pair(tmp_path, kept):
    cube = drawn_shell("steel-wheat-silo")
    required_thickness.draw(cube, tmp_path / "figure")
    matrix = kept[0].axes[0]
    assert len(matrix.texts) == cube.sizes["rule"] * cube.sizes["pressure_method"]
    assert "thickness (mm)" in matrix.get_title()
    assert {panel.get_xlabel() for panel in kept[0].axes[2:]} == {"diameter D (m)", "H/D"}


def test_readings_are_told_apart(tmp_path, kept):
    cube = buckling_cube(expand_file(ROOT / "config/studies/miller-1977.yaml"))
    test_over_prediction.draw(cube, tmp_path / "figure")
    (panel,) = kept[0].axes
    labels = [label.get_text() for label in panel.get_yticklabels()]
    assert labels[-1] == "Miller (1977)"
    assert sum(label.startswith("reading: ") for label in labels) == 7
    assert "over predicted buckling stress" in panel.get_xlabel()


def test_a_study_computes_only_the_cubes_it_needs():
    assert expanded(CYLINDER).study.stages == ("buckling",)
    assert expanded(silo()).study.stages == ("pressure", "shell")
