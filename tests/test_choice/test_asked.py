"""A study that asks for an accuracy: what is chosen, recorded, refused, and whether it is met on scenes the front never saw."""

import copy
import json
from math import inf, pi, sqrt

import numpy as np
import pytest

from silostudy.choice.choose import choose
from silostudy.choice.dem import load, restlessness, scene_traits
from silostudy.choice.fronts import FRONTS, FrontPoint
from silostudy.choice.pressure import pressure_traits
from silostudy.compute.dem import scene_model
from silostudy.compute.pressure import pressure_cube
from silostudy.config.dem import DemScene
from silostudy.config.load import read_yaml, study_of, validated
from silostudy.dem.stability import chosen_step
from silostudy.errors import BadInput
from tests.conftest import ROOT, expanded
from tests.test_dem.small import SMALL as DEM_SCENE

SCENE = {name: value for name, value in DEM_SCENE.items() if name != "march"} | {"march": {"limit_s": 1.0}}
SCENE |= {body: DEM_SCENE[body] | {"tangential": "spring-slider-total"} for body in ("discs", "walls")}


@pytest.fixture
def asking(study):
    study.pop("depth_m")
    return study | {"methods": ["janssen"], "phases": ["filling"], "accuracy": {"wall_force": 0.01}}


def row(quantity, settings, error, cost, scaled_by="", **within):
    return FrontPoint("silo", quantity, json.dumps(settings), error, scaled_by, within, cost, "a machine", "today")


@pytest.fixture
def fronts(monkeypatch):
    """Two quantities of the same key, one of another; errors that go with a trait, or hang on a class of scenes."""
    found = [
        *(row("force", {"levels": n}, 1 / n**2, n, "bend", bend=(0, 4), heap=(0, 0)) for n in (2, 4, 8, 16)),
        *(row("peak", {"levels": n}, 1 / n, n, "bend", bend=(0, 4)) for n in (2, 4, 8, 16)),
        *(row("peak", {"levels": n}, 2 / n, n, "kink", kink=(0, 4)) for n in (2, 4, 8, 16)),
        *(row("drift", {"march.step": 1 / n}, 1 / n, n, order=(0, 0)) for n in (10, 20)),
        *(row("drift", {"march.step": 1 / n}, 2 / n, n, order=(1, 1)) for n in (10, 20)),
    ]
    monkeypatch.setattr("silostudy.choice.fronts.FRONTS", found)
    told = {name: f"what {name} is" for each in found for name in each.within}
    monkeypatch.setattr("silostudy.choice.choose.TRAITS", told)


SMOOTH = {"bend": 1.0, "kink": 0.0, "heap": 0.0, "order": 0.0}


@pytest.mark.parametrize(
    ("asked", "scenes", "settings", "expected"),
    [
        ({"force": 0.02}, [SMOOTH], {"levels": 8}, {"force": 1 / 64}),
        ({"force": 0.02}, [SMOOTH | {"bend": 0.2}], {"levels": 4}, {"force": 0.2 / 16}),
        ({"force": 0.02}, [SMOOTH | {"bend": 0.2}, SMOOTH], {"levels": 8}, {"force": 1 / 64}),  # the worst scene decides
        ({"peak": 0.3}, [SMOOTH], {"levels": 4}, {"peak": 0.25}),
        ({"peak": 0.3}, [SMOOTH | {"kink": 1.0}], {"levels": 8}, {"peak": 0.25}),  # and the worst of the rows that hold
        ({"force": 0.1, "peak": 0.07}, [SMOOTH], {"levels": 16}, {"force": 1 / 256, "peak": 1 / 16}),
        ({"drift": 0.1}, [SMOOTH], {"march.step": 0.1}, {"drift": 0.1}),
        ({"drift": 0.1}, [SMOOTH | {"order": 1.0}], {"march.step": 0.05}, {"drift": 0.1}),
        ({"drift": 0.1, "force": 0.5}, [SMOOTH], {"march.step": 0.1, "levels": 2}, {"drift": 0.1, "force": 0.25}),
    ],
)  # fmt: skip
def test_the_cheapest_that_reaches_it_in_every_scene_is_chosen(fronts, asked, scenes, settings, expected):
    choice = choose(["silo"], asked, scenes)
    assert choice.settings == settings
    assert choice.expected == pytest.approx(expected)


@pytest.mark.parametrize(
    ("asked", "scene", "message"),
    [
        ({"force": 0.02}, {"heap": 1.0}, r"measured on no such scene: heap 1 \(measured 0 to 0; what heap is\)"),
        ({"force": 0.02}, {"bend": 9.0}, "measured on no such scene"),
        ({"force": 1e-3}, {}, r"no measured setting reaches it; the least errors are \{'force': 0.00391\}"),
        ({"drift": 0.1}, {"order": 0.5}, r"no such scene: order 0.5 \(measured 0 to 0 or 1 to 1;"),
    ],
)
def test_scenes_and_errors_beyond_what_was_measured_are_refused(fronts, asked, scene, message):
    with pytest.raises(BadInput, match=message):
        choose(["silo"], asked, [SMOOTH | scene])


def test_shipped_rows_are_sound():
    for each in FRONTS:
        assert np.isfinite([each.error, each.cost]).all()
        assert not each.scaled_by or each.scaled_by in each.within


def test_pressure_cube_records_what_was_chosen(asking):
    expansion = expanded(asking)
    cube = pressure_cube(expansion)
    traits = pressure_traits(expansion.study, [case.scene for case in expansion.cases])
    count = choose(["pressure"], asking["accuracy"], traits).settings["relative_depth"]["count"]
    assert cube.sizes["relative_depth"] == count
    assert cube.attrs["accuracy_asked"] == "wall_force 0.01"
    assert f"'count': {count}" in cube.attrs["accuracy_settings"]
    assert float(cube.attrs["accuracy_expected"].split()[-1]) <= 0.01
    assert cube.attrs["accuracy_measured"]
    asking.pop("accuracy")
    assert "accuracy_asked" not in pressure_cube(expanded(asking | {"relative_depth": [0.5, 1.0]})).attrs


def test_the_fall_of_a_scene():
    """Gap over the overlap under one disc's weight, times the root of ten layers."""
    overlap = 2650 * pi * 0.01**2 * 9.81 / SCENE["discs"]["normal_stiffness_N_m2"]
    traits = scene_traits(validated(DemScene, copy.deepcopy(SCENE), "asked.yaml"))
    assert traits["fall"] == pytest.approx(4e-5 / overlap * sqrt(10), rel=1e-12)
    assert traits["restlessness"] == restlessness(traits["fall"], traits["damping_ratio"], traits["wall_friction"])
    assert traits["restlessness_root"] == pytest.approx(traits["restlessness"] ** 0.5, rel=1e-12)
    assert restlessness(16.0, 0.5, 0.2) / restlessness(1.0, 1.0, 0.2) == pytest.approx(2.0 ** (4 * 0.87 + 0.7), rel=1e-12)
    assert restlessness(16.0, 0.0, 0.2) == inf
    assert traits["damping_ratio"] == pytest.approx(3977 / (2 * sqrt(2650 * pi * 0.01**2 * 9.46e6)), rel=1e-12)


def saved(folder, **changes):
    """A scene file."""
    path = folder / "asked.yaml"
    path.write_text(json.dumps(SCENE | changes))
    return path


def test_a_scene_gets_integrator_and_step(tmp_path):
    scene, choice = load(saved(tmp_path, accuracy={"wall_force": 0.1}))
    settings = choose(["dem"], {"wall_force": 0.1}, [scene_traits(scene)]).settings
    assert choice.settings == settings
    assert scene.march.integrator == settings["march.integrator"]
    assert scene.march.step_factor == settings["march.step_factor"]
    model = scene_model(scene, tmp_path)
    assert scene.march.step == model.pace.kind == settings["march.step"]
    assert model.step == pytest.approx(settings["march.step_factor"] * chosen_step(model))
    assert choice.asked == {"wall_force": 0.1}
    assert 0.01 < choice.expected["wall_force"] <= 0.1


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"accuracy": {"wall_forces": 0.1}}, "unknown; known: wall_force"),
        ({"accuracy": {"wall_force": 1e-9}}, "no measured setting reaches it; the least errors are"),
        ({"accuracy": {"wall_force": 0}}, "accuracy.wall_force = 0: must be greater than 0"),
        ({"accuracy": {"wall_force": "high"}}, "accuracy.wall_force"),
        (
            {"accuracy": {"wall_force": 0.1}, "march": {"limit_s": 1.0, "step_factor": 0.77}},
            "march.step_factor = .*: give either accuracy or this",
        ),
        (
            {"accuracy": {"wall_force": 0.1}, "march": {"limit_s": 1.0, "step_s": 1e-6}},
            "march.step_s = .*: give either accuracy or this, and not both",
        ),
        *(
            ({"accuracy": {"wall_force": 0.1}, **change}, message)
            for change, message in (
                ({"packing": {"kind": "loose", "count": 40}}, "packing.kind rows alone, not loose"),
                ({"walls": DEM_SCENE["walls"]}, "walls.tangential spring-slider-total alone, not spring-slider"),
                ({"gravity_m_s2": (1.0, -9.81)}, "gravity straight down"),
                (
                    {"packing": SCENE["packing"] | {"gap_m": 4e-4}},
                    "measured on no such scene: fall .* times the root of the layers",
                ),
                (
                    {"discs": SCENE["discs"] | {"sliding_friction": 0.7}},
                    r"measured on no such scene: disc_friction 0.7 \(measured 0.3 to 0.6",
                ),
            )
        ),
    ],
)
def test_refusals(changes, message, tmp_path):
    with pytest.raises(BadInput, match=message) as refused:
        load(saved(tmp_path, **changes))
    assert str(refused.value).startswith(f"{tmp_path}/asked.yaml: ")
    assert "\n" not in str(refused.value)


def test_the_worst_silo_of_a_sweep_decides(asking):
    def count(*widths):
        axis = {"axis": "width", "values": {"silo.diameter_m": list(widths)}}
        return len(expanded(asking | {"sweep": [axis]}).study.depths)

    assert count(1.0) > count(10.0)
    assert count(1.0, 10.0) == count(1.0)


def test_a_heap_has_no_measured_front(asking):
    asking["scene"]["silo"]["top_cone_height_m"] = 1.0
    with pytest.raises(BadInput, match="measured on no such scene"):
        expanded(asking)


def test_depths_of_one_s_own_and_accuracy_exclude_each_other(asking):
    with pytest.raises(BadInput, match=r"relative_depth = .*: give either accuracy or this"):
        expanded(asking | {"relative_depth": [0.5, 1.0]})
    with pytest.raises(BadInput, match="either depth_m or an accuracy that decides relative_depth"):
        expanded(asking | {"depth_m": [1.0, 2.0]})


@pytest.mark.parametrize(
    ("name", "why"),
    [
        ("buckling-map", "none of its settings decides a numerical error"),
        ("stability-map", "it looks for the largest step itself"),
        ("accuracy", "it measures what accuracy costs"),
        ("discharge-slit", "its scenes do: write scene.accuracy"),
        ("grains-record", "no front is measured"),
    ],
)
def test_kinds_that_may_not_ask_say_why(name, why):
    content = read_yaml(ROOT / f"config/studies/{name}.yaml") | {"accuracy": {"wall_force": 0.01}}
    with pytest.raises(BadInput, match=f"a study of kind {content['kind']} cannot ask for an accuracy: {why}") as refused:
        study_of(content, "study.yaml")
    assert "unknown key" not in str(refused.value)
