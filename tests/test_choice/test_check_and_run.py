"""One file, one study: the settings that `silostudy check` says are chosen for an accuracy are those that run."""

import json
from pathlib import Path

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.choice.expand import expand_file
from silostudy.choice.fronts import FRONTS
from silostudy.compute.dem import scene_model
from silostudy.compute.pressure import pressure_cube
from silostudy.config.asked import Asked
from silostudy.config.dem import DemScene
from silostudy.config.load import read_study, study_of, validated
from silostudy.cube.io import read
from silostudy.dem.stability import chosen_step
from silostudy.errors import BadInput
from silostudy.stages import FILE_KINDS
from tests.conftest import SMALL
from tests.own import THEORY
from tests.test_accuracy.test_fronts_packing import ONE
from tests.test_accuracy.test_fronts_seismic import identifying
from tests.test_buckling.test_shell import STUDY as SHELL
from tests.test_choice.test_asked import SCENE
from tests.test_sweep.sweeps import compute

SPREADS = {"a_phi": 1.2, "a_K": 1.11, "a_mu": 1.16, "unit_weight_lower_kN_m3": 7.5}


def without(content: dict, *keys: str) -> dict:
    return {key: value for key, value in content.items() if key not in keys}


# a small study or scene of every kind that may ask: something is asked of each of its quantities' settings
ASKING = {
    "dem": SCENE | {"accuracy": {"wall_force": 0.1}},
    "pressure": without(SMALL, "depth_m")
    | {"scene": SMALL["scene"] | {"properties": SPREADS}, "accuracy": {"wall_force": 0.01, "pressure_quantile": 0.05}},
    "shell": without(SHELL, "depth_m") | {"accuracy": {"axial_wall_force": 0.02, "peak_pressure": 0.02}},
    "seismic": without(identifying(0.7), "relative_depth")
    | {"accuracy": {"effective_mass_coefficient": 0.01, "wall_bending_moment": 0.02}},
    "packing": ONE | {"discharge_s": 0.6, "accuracy": {"rest_side_share": 0.2}},
    "scenes": {
        "kind": "scenes",
        "title": "a small sweep",
        "scene": SCENE,
        "sweep": [{"axis": "asked", "values": {"accuracy.wall_force": [0.05, 0.2]}}],
    },
}


def ran_pressure(path: Path, folder: Path):
    main(["pressure", str(path), str(folder / "pressure.nc")])
    main(["uncertainty", str(path), str(folder / "uncertainty.nc")])
    cube, sampled = read(folder / "pressure.nc"), read(folder / "uncertainty.nc")
    assert all(sampled.attrs[name] == text for name, text in cube.attrs.items() if name.startswith("accuracy_"))
    power = json.loads(sampled.attrs["study"])["uncertainty"]["log2_samples"]
    return cube, [{"uncertainty.log2_samples": power, "relative_depth": levels(cube)}]


def ran_shell(path: Path, folder: Path):
    main(["pressure", str(path), str(folder / "pressure.nc")])
    main(["shell", str(path), str(folder / "pressure.nc"), str(folder / "shell.nc")])
    cube = read(folder / "shell.nc")
    return cube, [{"relative_depth": levels(cube)}]


def ran_seismic(path: Path, folder: Path):
    main(["seismic", str(path), str(folder / "seismic.nc")])
    cube = read(folder / "seismic.nc")
    steps = read_study(path).identification.coefficients.count - 1
    refinement = (cube.sizes["coefficient"] - 1) // steps
    return cube, [{"identification.refinement": refinement, "relative_depth": levels(cube)}]


def ran_packing(path: Path, folder: Path):
    main(["packing", str(path), str(folder / "packing.nc")])
    cube = read(folder / "packing.nc")
    return cube, [{"runs": cube.sizes["run"] - 1}]


def ran_dem(path: Path, folder: Path):
    main(["dem", str(path), str(folder / "dem.nc")])
    cube = read(folder / "dem.nc")
    return cube, [marched(json.loads(cube.attrs["study"])["march"], cube.attrs["time_step_s"])]


def ran_scenes(path: Path, folder: Path):
    compute(path, folder / "parts")
    main(["merge", str(path), str(folder / "parts"), str(folder / "scenes.nc")])
    cube, cases = read(folder / "scenes.nc"), expand_file(path).cases
    assert [case.id for case in cases] == cube["case"].values.tolist()
    marches = [json.loads(case.scene.config.model_dump_json())["march"] for case in cases]
    first = [scene_model(case.scene.config, Path()).step for case in cases]
    assert (cube["time_step"].values >= first).all()  # the mean: at rest they may be longer
    return cube, [marched(march, step) for march, step in zip(marches, first, strict=True)]


RUN = {"dem": ran_dem, "pressure": ran_pressure, "shell": ran_shell, "seismic": ran_seismic, "packing": ran_packing,
       "scenes": ran_scenes}  # fmt: skip


def levels(cube) -> dict:
    """The even levels of a cube as a study says them."""
    first, *_, last = cube["relative_depth"].values.tolist()
    return {"start": first, "stop": last, "count": cube.sizes["relative_depth"]}


def marched(march: dict, step: float) -> dict:
    """The integrator, and the step (s) over the one that the engine would have chosen with it."""
    integrator = march.get("integrator", "17-18")
    plain = scene_model(validated(DemScene, SCENE | {"march": SCENE["march"] | {"integrator": integrator}}, "plain"), Path())
    factor = float(f"{step / chosen_step(plain):.4g}")
    return {"march.integrator": integrator, "march.step_factor": factor, "march.step": march.get("step", "fixed")}


def may_ask(kind) -> bool:
    scene = kind.study.scene_model({}, "") if kind.builder else None
    return issubclass(kind.study, Asked) or "accuracy" in getattr(scene, "model_fields", {})


def test_every_kind_that_may_ask_is_here():
    found = {key for key, kind in FILE_KINDS.items() if may_ask(kind)}
    assert found == set(ASKING) == set(RUN) == {key for key, kind in FILE_KINDS.items() if kind.traits}


@pytest.fixture
def saved(tmp_path, request):
    path = tmp_path / "asking.yaml"
    path.write_text(yaml.safe_dump(json.loads(json.dumps(ASKING[request.param]))))
    return path


@pytest.mark.parametrize(
    ("saved", "run"),
    [pytest.param(key, run, marks=pytest.mark.long if key == "scenes" else (), id=key) for key, run in RUN.items()],
    indirect=["saved"],
)
def test_check_says_what_runs_and_the_cube_says_the_same(saved, run, tmp_path, capsys):
    assert main(["check", str(saved)]) == 0
    told = dict(line.strip().split(": ", 1) for line in capsys.readouterr().out.splitlines() if "accuracy " in line)
    cube, marks = run(saved, tmp_path)
    attributes = {name.replace("_", " "): text for name, text in cube.attrs.items() if name.startswith("accuracy_")}
    assert attributes == told
    assert set(told) == {"accuracy asked", "accuracy settings", "accuracy expected", "accuracy measured"}
    each = [", ".join(f"{key} = {value}" for key, value in settings.items()) for settings in marks]
    assert told["accuracy settings"] == "; ".join(dict.fromkeys(each))


@pytest.mark.parametrize("saved", sorted(set(ASKING) - {"dem", "scenes"}), indirect=True)
def test_a_study_as_asked_has_no_chosen_settings(saved):
    study, resolved = read_study(saved), expand_file(saved)
    for key in resolved.choices[0].settings:
        asked, chosen = study, resolved.study
        for name in key.split("."):
            asked, chosen = getattr(asked, name), getattr(chosen, name)
        assert asked is None
        assert chosen is not None


def test_levels_as_asked_cannot_be_read(tmp_path):
    study = study_of(ASKING["shell"], "asking.yaml")
    with pytest.raises(AssertionError, match="relative_depth is not chosen yet"):
        study.depths  # noqa: B018


def test_a_scene_as_asked_does_not_march():
    scene = validated(DemScene, ASKING["dem"], "asked.yaml")
    assert (scene.march.integrator, scene.march.step_factor) == (None, None)
    with pytest.raises(AssertionError, match=r"march\.integrator is not chosen yet"):
        scene_model(scene, Path())


@pytest.mark.parametrize(
    ("content", "message"),
    [
        (ONE | {"runs": None}, "runs = None: must be given: no accuracy that decides it is asked for"),
        (SMALL | {"uncertainty": {"log2_samples": None}}, "uncertainty.log2_samples = None: must be given"),
        (identifying(0.7) | {"relative_depth": None}, "relative_depth = None: must be given"),
        (identifying(0.7, refinement=None) | {"accuracy": {"effective_mass_coefficient": 0.01}, "relative_depth": None},
         "relative_depth = None: must be given"),
    ],
)  # fmt: skip
def test_null_stands_for_a_setting_that_an_accuracy_decides_and_for_no_other(content, message):
    with pytest.raises(BadInput, match=message):
        study_of(content, "study.yaml")


def test_a_section_that_is_switched_off_cannot_be_asked_of():
    with pytest.raises(
        BadInput, match=r"uncertainty = None: is null, but the accuracy asked for decides uncertainty\.log2_samples"
    ):
        study_of(SMALL | {"uncertainty": None, "accuracy": {"pressure_quantile": 0.05}}, "study.yaml")


def test_levels_that_a_shell_study_reads_of_an_earthquake_run_over_the_whole_height():
    levels = [json.loads(row.settings)["relative_depth"] for row in FRONTS if "relative_depth" in row.keys]
    assert {(one["start"], one["stop"]) for one in levels} == {(0.0, 1.0)}


def test_a_sweep_whose_base_scene_does_not_ask_tells_of_the_cases_that_do(tmp_path):
    path = tmp_path / "some.yaml"
    path.write_text(
        json.dumps(
            ASKING["scenes"] | {"sweep": [{"axis": "a", "points": [{"accuracy": None}, {"accuracy": {"wall_force": 0.2}}]}]}
        )
    )
    expansion = expand_file(path)
    assert [choice.asked for choice in expansion.choices] == [{"wall_force": 0.2}]
    assert expansion.cases[0].scene.config.march.step_factor == 1.0


def test_a_study_keeps_the_user_s_own_methods_when_its_settings_are_chosen(tmp_path):
    (tmp_path / "mine.py").write_text(THEORY)
    own = {"methods_from": "mine.py", "methods": ["janssen", "frictionless"], "accuracy": {"wall_force": 0.01}}
    path = tmp_path / "asking.yaml"
    path.write_text(yaml.safe_dump(without(SMALL, "depth_m") | own))
    cube = pressure_cube(expand_file(path))
    assert cube["pressure_method"].values.tolist() == own["methods"]
    assert f"'count': {cube.sizes['relative_depth']}" in cube.attrs["accuracy_settings"]
