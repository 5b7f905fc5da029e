"""Sweeps of scenes of spheres: the same study, the same parts, a cube of their own numbers."""

import copy

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.choice.expand import expand_file
from silostudy.compute.dem import scene_model
from silostudy.cube.io import read
from silostudy.errors import BadInput
from silostudy.scene.costs import COSTS, cost
from silostudy.sweep.merge import merge
from silostudy.tables.constants import ROUNDED_GRAVITY
from tests.conftest import ROOT
from tests.test_spheres.small import SMALL
from tests.test_sweep.sweeps import compute

OUTLETS = ROOT / "config/studies/wheat-bin-outlets.yaml"


def save(folder, outlets=(0.03, 0.05), seeds=(1, 2), **changes):
    """A sweep of the tests' small bin with a flat floor, over its outlet and the filling."""
    scene = copy.deepcopy(SMALL) | {"outlets": [{"width_m": 0.03}]} | changes
    scene["silo"] = {"plan": "circular", "diameter_m": 0.06, "cylinder_depth_m": 0.1}
    scene["record"] = {"wall_force_window_s": 0.02}
    axes = [{"axis": "outlet_width", "values": {"outlets.0.width_m": list(outlets)}},
            {"axis": "filling", "values": {"seed": list(seeds)}}]  # fmt: skip
    path = folder / "bins.yaml"
    path.write_text(yaml.safe_dump({"kind": "scenes", "title": "bins", "scene": scene, "sweep": axes}))
    return path


def test_mistakes_are_told_by_the_keys_of_the_scene(tmp_path):
    """The kinds of scene have names of their own: `spheres` is a section too."""
    with pytest.raises(BadInput) as caught:
        expand_file(
            save(tmp_path, sizes={"kind": "equal", "diameter": 8}, filling={"kind": "rain", "count": "x", "rate_1_s": 1})
        )
    told = str(caught.value)
    assert "scene.sizes.diameter_mm: is missing" in told
    assert "scene.filling.count = 'x': must be a whole number" in told
    with pytest.raises(BadInput, match="grains = 'cubes': unknown; known: discs, spheres"):
        expand_file(save(tmp_path, grains="cubes"))


def test_an_axis_may_be_any_key_of_the_scene():
    cases = expand_file(OUTLETS).cases
    assert [case.scene.config.outlets[0].width_m for case in cases[::3]] == [0.036, 0.042, 0.048, 0.054, 0.06]
    assert {case.scene.config.seed for case in cases} == {1, 2, 3}


def test_an_axis_may_lead_into_a_list(tmp_path):
    path = save(tmp_path)
    for key, said in (
        ("outlets.1.width_m", "1 is no group of keys"),
        ("outlets.0", "0 is no key of the scene: it stands in a list"),
    ):
        path.write_text(path.read_text().replace("outlets.0.width_m", key))
        with pytest.raises(BadInput, match=said):
            expand_file(path)
        save(tmp_path)


@pytest.mark.long
def test_the_step_that_a_cost_is_guessed_from_is_about_the_engine_s(tmp_path):
    for path in (OUTLETS, save(tmp_path)):
        (case, *_) = expand_file(path).cases
        scene = case.scene.config
        assert COSTS["spheres"].step(scene) == pytest.approx(scene_model(scene, tmp_path).dt, rel=0.4)
        assert 0.05 < cost(case.scene) < 10.0


@pytest.mark.long
def test_a_sweep_of_spheres_tells_flow_and_loads(tmp_path, capsys):
    """A kill between two cases costs nothing; each case is the run of its scene alone."""
    path = save(tmp_path)
    assert compute(path, tmp_path / "parts") == 4
    assert compute(save(tmp_path, outlets=(0.03, 0.04, 0.05)), tmp_path / "parts") == 2
    merge(save(tmp_path, outlets=(0.03, 0.04, 0.05)), tmp_path / "parts", tmp_path / "scenes.nc")
    cube = read(tmp_path / "scenes.nc")
    flow = cube["mean_mass_flow"]
    assert flow.dims == ("outlet_width", "filling")
    assert (flow.mean("filling").diff("outlet_width") > 0.0).all()
    assert (flow.std("filling") > 0.0).all()
    weight = ROUNDED_GRAVITY * 150 * 2500 * 4.0 / 3.0 * np.pi * 0.004**3
    assert cube["body_load_at_rest"].sum("body").values == pytest.approx(weight, rel=5e-3)
    assert (cube["body_normal_force_at_rest"].sel(body="hopper") == 0.0).all()
    assert (cube["largest_body_load"].sel(body="floor") < cube["body_load_at_rest"].sel(body="floor")).all()

    alone = expand_file(path).cases[-1].scene.config
    (tmp_path / "one.yaml").write_text(yaml.safe_dump(yaml.safe_load(alone.model_dump_json(exclude_unset=True))))
    assert main(["dem", str(tmp_path / "one.yaml"), str(tmp_path / "one.nc")]) == 0
    one = read(tmp_path / "one.nc")
    swept = cube.sel(outlet_width=0.05, filling=2)
    assert one.attrs["mean_outflow_kg_s"] == float(swept["mean_mass_flow"])
    assert float(one["outflow_mass"][-1]) == pytest.approx(float(swept["passed_mass"]), rel=1e-12)
    capsys.readouterr()


@pytest.mark.long
def test_an_ensemble_is_its_members(tmp_path, capsys):
    path = save(tmp_path)
    scene = yaml.safe_load(path.read_text())["scene"] | {"events": [{"when": "time", "value": 0.12, "do": "stop"}]}
    (tmp_path / "bin.yaml").write_text(yaml.safe_dump(scene))
    (tmp_path / "one.yaml").write_text(yaml.safe_dump(scene | {"seed": 1}))
    assert main(["dem", "--seeds", "2", str(tmp_path / "bin.yaml"), str(tmp_path / "bin.nc")]) == 0
    assert main(["dem", str(tmp_path / "one.yaml"), str(tmp_path / "one.nc")]) == 0
    both, one = [read(tmp_path / f"bin-{seed}.nc") for seed in (0, 1)], read(tmp_path / "one.nc")
    for name in ("surface_load", "wall_pressure_max"):
        assert np.array_equal(both[1][name], one[name], equal_nan=True)
        assert not np.array_equal(both[0][name], one[name], equal_nan=True)
    capsys.readouterr()
