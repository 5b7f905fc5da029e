"""A mistake in a study is one clear line, with file, key, value and what is allowed, before anything is computed."""

import json
import re

import jsonschema
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.choice.expand import expand_file
from silostudy.config.dem import DemScene
from silostudy.config.load import load_project, read_yaml, study_of, validated
from silostudy.config.schema import study_schema
from silostudy.errors import BadInput
from tests.conftest import ROOT, SMALL, expanded

SILO = SMALL["scene"]["silo"]


def scene(**changed):
    return {"scene": {**SMALL["scene"], **changed}}


def silo(**changed):
    return scene(silo={**SILO, **changed})


def sweep(*axes):
    return {"sweep": list(axes)}


DIAMETERS = {"axis": "diameter", "values": {"silo.diameter_m": [3.0, 5.0]}}
PLAN = {"count": 4, "ranges": {"silo.diameter_m": {"start": 3, "stop": 4}, "silo.cylinder_depth_m": {"start": 3, "stop": 9}}}
MISTAKES = {
    "negative diameter": (silo(diameter_m=-1.0), "scene.silo.diameter_m = -1.0: must be greater than 0"),
    "zero diameter": (silo(diameter_m=0), "scene.silo.diameter_m = 0: must be greater than 0"),
    "infinite diameter": (silo(diameter_m=float("inf")), "scene.silo.diameter_m = inf: must be a finite number"),
    "text for a number": (silo(diameter_m="wide"), "scene.silo.diameter_m = 'wide': must be a number"),
    "friction angle 0": (
        scene(properties={"internal_friction_angle_deg": 0}),
        "scene.properties.internal_friction_angle_deg = 0: must be greater than 0",
    ),
    "friction angle 90": (
        scene(properties={"internal_friction_angle_deg": 90}),
        "scene.properties.internal_friction_angle_deg = 90: must be less than 90",
    ),
    "Poisson 0.5": (
        scene(properties={"poisson_ratio": 0.5}),
        "scene.properties.poisson_ratio = 0.5: must be less than 0.5",
    ),
    "unknown solid": (scene(solid="sand"), "scene.solid = 'sand': unknown; known: cement, cement_clinker, maize, wheat"),
    "unknown wall": (scene(wall="glass"), "scene.wall = 'glass': must be 'grooved_concrete', 'as_cast_concrete'"),
    "unknown method": ({"methods": ["jansen"]}, "methods.0 = 'jansen': unknown; known: janssen, reimbert"),
    "unknown plan": (silo(plan="oval"), "scene.silo.plan = 'oval': unknown; known: circular, square"),
    "unknown key": ({"colour": "red"}, "colour = 'red': unknown key; known here: kind, title, description, scene, sweep"),
    "unknown key of a plan": (silo(colour=1), "scene.silo.colour = 1: unknown key; known here: cylinder_depth_m, slenderness"),
    "unknown key of a section": (
        silo(hopper={"half_angle_deg": 20.0, "outlet_m": 1.0}),
        "scene.silo.hopper.outlet_m = 1.0: unknown key; known here: half_angle_deg, outlet_width_m, wall",
    ),
    "key of an older version": (
        silo(eccentricity_m=0.5),
        "scene.silo.eccentricity_m = 0.5: is no key any more since version 1.0.0: write filling_eccentricity_m and outlet",
    ),
    "unknown key of a range": (
        {"depth_m": {"start": 0.0, "stop": 1.0, "count": 3, "step": 0.5}},
        "depth_m.step = 0.5: unknown key; known here: start, stop, count, spacing",
    ),
    "unknown kind": ({"kind": "presure"}, "kind = 'presure': unknown; known: accuracy, buckling, dem, grains"),
    "no text as kind": ({"kind": ["pressure"]}, "kind = ['pressure']: unknown; known: accuracy, buckling, dem, grains"),
    "unit missing": (
        scene(silo={"plan": "circular", "diameter": 5.0, "cylinder_depth_m": 18.0}),
        "write diameter_m in place of diameter",
    ),
    "both depths of the cylinder": (silo(slenderness=3.6), "give either cylinder_depth_m or slenderness"),
    "no wall friction": (scene(solid="cement"), "solid cement has no wall friction of its own: choose a wall kind"),
    "outlet wider than the silo": (
        silo(hopper={"half_angle_deg": 30.0, "outlet_width_m": 5.0}),
        "outlet_width_m = 5.0: must be smaller than the silo's width, 5 m",
    ),
    "duplicated depth": ({"depth_m": [1.0, 1.0, 2.0]}, "depth_m = [1.0, 1.0, 2.0]: depths must increase, none twice"),
    "negative depth": ({"depth_m": [-1.0, 2.0]}, "depths must not be negative"),
    "depth in the hopper": ({"depth_m": [1.0, 18.5]}, "depth_m = 18.5: the transition lies at 18 m"),
    "two depth axes": ({"relative_depth": [0.5]}, "give either depth_m or relative_depth"),
    "no method": ({"methods": []}, "methods = []: a study needs a method; known: janssen"),
    "a method twice": ({"methods": ["janssen", "janssen"]}, "holds a key twice: janssen"),
    "no misprint": ({"as_printed": ["janssen"]}, "janssen has no misprint in the source; known: caquot"),
    "axes of one name": (sweep(DIAMETERS, {**DIAMETERS, "values": {"solid": ["wheat"]}}), "axis name diameter is swept twice"),
    "a key on two axes": (sweep(DIAMETERS, {**DIAMETERS, "axis": "width"}), "key silo.diameter_m is swept twice"),
    "axis named like a keyword": (sweep({**DIAMETERS, "axis": "method"}), "this name is a keyword of xarray's"),
    "axis named like a dimension": (sweep({**DIAMETERS, "axis": "depth"}), "this name is the cube's own"),
    "empty axis": (sweep({"axis": "diameter", "values": {"silo.diameter_m": []}}), "need equally many values (one at least)"),
    "a value twice": (
        sweep({"axis": "diameter", "values": {"silo.diameter_m": [3, 3]}}),
        "silo.diameter_m holds a value twice",
    ),
    "a sample beside values": (
        sweep({"axis": "d", "values": {"silo.diameter_m": [3, 4]}, "sample": PLAN}),
        "values, points or a sample, and one of them alone",
    ),
    "a sample of one key": (
        sweep({"axis": "d", "sample": {"count": 4, "ranges": {"silo.diameter_m": {"start": 3, "stop": 4}}}}),
        "sample.ranges: must hold 2 or more",
    ),
    "a sampled range that falls": (
        sweep({"axis": "d", "sample": PLAN | {"ranges": {"silo.diameter_m": {"start": 4, "stop": 3}, "wall": ["a", "b"]}}}),
        "start = 4 must be below stop = 3",
    ),
    "an axis to and fro": (sweep({"axis": "d", "values": {"silo.diameter_m": [3, 5, 4]}}), "must all rise or all fall"),
    "paired axes of unequal length": (
        sweep({"axis": "size", "values": {"silo.diameter_m": [3, 5], "silo.cylinder_depth_m": [18]}}),
        "need equally many values",
    ),
    "swept key that does not exist": (
        sweep({"axis": "diameter", "values": {"silo.diametre_m": [3.0]}}),
        "silo.diametre_m = 3.0: unknown key",
    ),
    "swept value out of range": (
        sweep({"axis": "diameter", "values": {"silo.diameter_m": [3.0, -3.0]}}),
        "silo.diameter_m = -3.0: must be greater than 0",
    ),
    "unknown output": ({"outputs": ["fig_9"]}, "outputs.0 = 'fig_9': must be 'fig_4_2_11'"),
    "output without its axis": ({"outputs": ["governing_method"]}, "needs the axes diameter, slenderness"),
    "output without its method": (
        {"outputs": ["fig_4_2_11"], "methods": ["caquot"]},
        "output fig_4_2_11 needs the methods janssen",
    ),
    "output without its phase": (
        {"outputs": ["fig_4_2_11"], "phases": ["discharge"]},
        "output fig_4_2_11 needs the phases filling",
    ),
    "single-silo figure of a sweep": (
        {"outputs": ["fig_4_2_11"], **sweep(DIAMETERS)},
        "output fig_4_2_11 needs a study without sweep",
    ),
}


@pytest.mark.parametrize("name", MISTAKES)
def test_mistake_is_one_clear_line(name, tmp_path, capsys):
    changed, expected = MISTAKES[name]
    path = tmp_path / "study.yaml"
    path.write_text(yaml.safe_dump({**SMALL, **changed}, sort_keys=False))
    with pytest.raises(BadInput) as caught:
        expand_file(path)
    lines = [line for line in str(caught.value).split("\n") if expected in line]
    assert len(lines) == 1, str(caught.value)
    assert lines[0].startswith(str(path))
    assert main(["check", str(path)]) == 2
    assert expected in capsys.readouterr().err


def test_all_mistakes_are_told_at_once(study):
    study["scene"]["silo"]["diameter_m"] = -1
    study["methods"] = []
    with pytest.raises(BadInput) as caught:
        expanded(study)
    assert len(str(caught.value).split("\n")) == 2


@pytest.mark.parametrize(
    ("study", "change", "told"),
    [
        ("wheat-silo", {"depth_m": 3}, "depth_m = 3: must hold `key: value` lines or be a list"),
        ("wheat-silo", {"depth_m": [1, "b"]}, "depth_m.1 = 'b': must be a number"),
        ("wheat-silo", {"methods": {"a": 1}}, "methods: must be a list"),
        ("wheat-silo", {"scene": [1]}, "scene = [1]: must hold `key: value` lines"),
        ("wheat-silo", {"title": 3}, "title = 3: must be text"),
        ("discs-laboratory", {"scene": {"grains": "cubes"}}, "scene.grains = 'cubes': unknown; known: spheres, discs"),
        ("discs-laboratory", {"scene": {}}, "scene.grains: is missing"),
        ("discs-laboratory", {"scene": 3}, "scene = 3: must hold `key: value` lines"),
        ("grains-frequency", {"scene": {"grains": "cubes"}}, "scene.grains = 'cubes': unknown; known: spheres, a section"),
    ],
)
def test_a_wrong_choice_or_sort_of_value_is_one_plain_line(study, change, told):
    """Whatever it may be instead: no line a branch, and no word that only programmers know."""
    path = ROOT / f"config/studies/{study}.yaml"
    with pytest.raises(BadInput) as caught:
        study_of(read_yaml(path) | change, "s.yaml", path.parent)
    assert str(caught.value).startswith(f"s.yaml: {told}")
    assert "\n" not in str(caught.value)


def test_a_mistake_in_a_list_is_one_line():
    """The list is not called empty beside it, and a section without its kind is told so."""
    scene = read_yaml(ROOT / "config/scenes/kiyama-17-18.yaml")
    wrong = scene | {"events": [{"when": "never", "do": "stop"}], "packing": {"across": 18}}
    with pytest.raises(BadInput) as caught:
        validated(DemScene, wrong, "s.yaml")
    told = str(caught.value).split("\n")
    assert told[0] == "s.yaml: packing.kind: is missing"
    assert told[1].startswith("s.yaml: events.0.when = 'never': must be 'time'")
    assert len(told) == 2


def test_wall_friction_above_tan_phi_is_capped_and_said(study, tmp_path, capsys):
    study["scene"]["properties"] = {"wall_friction": 0.9}
    path = tmp_path / "study.yaml"
    path.write_text(yaml.safe_dump(study))
    assert main(["check", str(path)]) == 0
    assert "wall friction 0.9 capped at tan(phi) = 0.577" in capsys.readouterr().out


def test_key_written_twice_is_refused(tmp_path):
    path = tmp_path / "study.yaml"
    path.write_text("kind: pressure\nscene:\n  solid: wheat\n  wall: steel\n  solid: maize\n")
    with pytest.raises(BadInput, match=r"'solid' is written twice in .*study\.yaml\", line 5, column 3"):
        read_yaml(path)


@pytest.mark.parametrize("text", ["- a\n", "a: [1\n", ""])
def test_unreadable_yaml_names_the_file(tmp_path, text):
    path = tmp_path / "study.yaml"
    path.write_text(text)
    with pytest.raises(BadInput, match=re.escape(str(path))):
        read_yaml(path)


@pytest.mark.parametrize(
    ("others", "told"),
    [
        (["a", "b"], "holds a, b"),
        ([], "holds no YAML files"),
        ([f"wheat-{k}" for k in range(20)], "holds 20 YAML files, wheat-3, "),
        ([f"silo-{k}" for k in range(20)], r"holds 20 YAML files$"),
    ],
)
def test_a_file_that_is_not_there_is_told_with_the_likest_of_many(others, told, tmp_path):
    for name in others:
        (tmp_path / f"{name}.yaml").touch()
    with pytest.raises(BadInput, match=told):
        read_yaml(tmp_path / "wheat3.yaml")


def test_project_names_only_studies_that_are_there(tmp_path):
    (tmp_path / "studies").mkdir()
    (tmp_path / "config.yaml").write_text("studies: [nowhere]\n")
    with pytest.raises(BadInput, match="studies = 'nowhere': unknown"):
        load_project(tmp_path / "config.yaml")
    (tmp_path / "config.yaml").write_text("studies: []\n")
    with pytest.raises(BadInput, match="neither studies nor scenes are named"):
        load_project(tmp_path / "config.yaml")
    studies, scenes = load_project(ROOT / "config/config.yaml")
    assert "wheat-silo" in studies
    assert "kiyama-17-18" in scenes


def test_schema_file_is_in_step_and_accepts_every_study():
    text = (ROOT / "config/study.schema.json").read_text()
    assert text == study_schema(), "run: silostudy schema config/study.schema.json"
    schema = json.loads(text)
    for path in sorted((ROOT / "config/studies").glob("*.yaml")):
        jsonschema.validate(read_yaml(path), schema)
    with pytest.raises(jsonschema.ValidationError):
        jsonschema.validate({**SMALL, "colour": "red"}, schema)


def test_every_key_of_the_schema_is_described():
    """Also that numbers carry a unit: an editor shows both."""
    schema = json.loads(study_schema())
    for model in (schema, *schema["$defs"].values()):
        for key, field in model.get("properties", {}).items():
            assert field.get("description"), key
