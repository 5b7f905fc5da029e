"""A study that asks for an accuracy: what is chosen, recorded, refused, and whether it is met on scenes the front never saw."""

import copy
import json

import numpy as np
import pytest

from silostudy.compute.dem import model_of
from silostudy.compute.pressure import pressure_cube
from silostudy.config.dem import DemScene
from silostudy.config.load import validated
from silostudy.dem.stability import chosen_step
from silostudy.errors import BadInput
from silostudy.pressure import janssen
from silostudy.pressure.family import call
from silostudy.tables.fronts import FRONTS, choose, quantities
from tests.conftest import expanded
from tests.test_dem.test_scene import SMALL as DEM_SCENE

ASKED = (0.1, 0.03, 0.01, 1e-3, 1e-4)
SCENE = {name: value for name, value in DEM_SCENE.items() if name != "march"} | {"march": {"limit_s": 1.0}}


@pytest.fixture
def asking(study):
    study.pop("depth_m")
    return study | {"methods": ["janssen"], "phases": ["filling"], "accuracy": {"wall_force": 0.01}}


def test_the_cheapest_that_reaches_it_is_chosen():
    for kind in ("dem", "pressure"):
        for quantity in quantities(kind):
            each = [row for row in FRONTS if row.kind == kind and row.quantity == quantity]
            for asked in (row.error for row in each):
                choice = choose(kind, {quantity: asked})
                reached = [row for row in each if row.error <= asked]
                assert choice.settings == json.loads(min(reached, key=lambda row: row.cost).settings)
                assert choice.expected[quantity] <= asked


def test_one_choice_meets_two_quantities_of_the_same_key():
    choice = choose("pressure", {"wall_force": 0.01, "peak_pressure": 1e-3, "pressure_quantile": 0.01})
    assert set(choice.settings) == {"relative_depth", "uncertainty.log2_samples"}
    alone = choose("pressure", {"wall_force": 0.01})
    assert choice.settings["relative_depth"]["count"] > alone.settings["relative_depth"]["count"]
    assert choice.expected["peak_pressure"] <= 1e-3


def test_pressure_cube_records_what_was_chosen(asking):
    cube = pressure_cube(expanded(asking))
    count = choose("pressure", asking["accuracy"]).settings["relative_depth"]["count"]
    assert cube.sizes["relative_depth"] == count
    assert cube.attrs["accuracy_asked"] == "wall_force 0.01"
    assert f"'count': {count}" in cube.attrs["accuracy_settings"]
    assert float(cube.attrs["accuracy_expected"].split()[-1]) <= 0.01
    assert cube.attrs["accuracy_measured"]
    asking.pop("accuracy")
    assert "accuracy_asked" not in pressure_cube(expanded(asking | {"relative_depth": [0.5, 1.0]})).attrs


def test_depth_levels_meet_what_was_asked_on_other_silos():
    """95 of 100 silos at the least, at most 1.5 times the levels that would have met it; both counted, none was measured on."""
    random, met, dear = np.random.default_rng(11), [], []
    counts = sorted(json.loads(row.settings)["relative_depth"]["count"] for row in FRONTS if row.quantity == "wall_force"
                    and row.kind == "pressure")  # fmt: skip
    for _ in range(100):
        depth, radius = random.uniform(5, 40), random.uniform(0.5, 5)
        radius = max(radius, depth / 36)  # within the H/D that the front was measured on
        silo = {"unit_weight": 9e3, "hydraulic_radius": radius, "wall_friction": random.uniform(0.2, 0.4),
                "lateral_pressure_ratio": random.uniform(0.35, 0.45), "cylinder_depth": depth}  # fmt: skip
        exact = (9e3 * depth - call(janssen.vertical_pressure, depth, silo)) * radius

        def wrong(count, silo=silo, depth=depth, exact=exact):
            z = np.linspace(0, depth, count)
            return abs(np.trapezoid(call(janssen.friction_traction, z, silo), z) / exact - 1)

        for asked in ASKED:
            chosen = choose("pressure", {"wall_force": asked}).settings["relative_depth"]["count"]
            met.append(wrong(chosen) <= asked)
            dear.append(chosen / next(count for count in counts if wrong(count) <= asked))
    assert np.mean(met) >= 0.95
    assert np.median(dear) < 4.5  # worst silos decide: the others pay for them


def test_a_scene_gets_integrator_and_step(tmp_path):
    content = copy.deepcopy(SCENE) | {"accuracy": {"wall_force": 0.1}}
    scene = validated(DemScene, content, "asked.yaml")
    settings = choose("dem", {"wall_force": 0.1}).settings
    assert scene.march.integrator == settings["march.integrator"]
    assert scene.march.step_factor == settings["march.step_factor"]
    model = model_of(scene, tmp_path)
    assert model.dt == pytest.approx(settings["march.step_factor"] * chosen_step(model))
    assert scene.promise["accuracy_asked"] == "wall_force 0.1"
    assert "accuracy" not in SCENE


@pytest.mark.parametrize(
    ("changes", "message"),
    [
        ({"accuracy": {"wall_forces": 0.1}}, "unknown; known: wall_force"),
        ({"accuracy": {"wall_force": 1e-9}}, "no measured setting reaches it; the least errors are"),
        ({"accuracy": {"wall_force": 0}}, "must be above 0"),
        ({"accuracy": {"wall_force": "high"}}, "accuracy.wall_force"),
        (
            {"accuracy": {"wall_force": 0.1}, "march": {"limit_s": 1.0, "step_factor": 0.77}},
            "either accuracy or march.step_factor",
        ),
        ({"accuracy": {"wall_force": 0.1}, "march": {"limit_s": 1.0, "step_s": 1e-6}}, "either accuracy or march.step_s"),
    ],
)
def test_refusals(changes, message):
    with pytest.raises(BadInput, match=message):
        validated(DemScene, copy.deepcopy(SCENE) | changes, "asked.yaml")


def test_depths_of_one_s_own_and_accuracy_exclude_each_other(asking):
    with pytest.raises(BadInput, match="either accuracy or relative_depth"):
        expanded(asking | {"relative_depth": [0.5, 1.0]})
    with pytest.raises(BadInput, match="either depth_m or relative_depth"):
        expanded(asking | {"depth_m": [1.0, 2.0]})
