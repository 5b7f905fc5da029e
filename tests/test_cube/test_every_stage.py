"""Cubes of all stages as xarray's users expect them: labels of dimensions are coordinates; selecting and plotting work."""

import copy
import subprocess
import sys
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pytest
import xarray as xr

from silostudy.accuracy import cube as accuracy
from silostudy.accuracy.cube import accuracy_cube
from silostudy.accuracy.profile import profile_cube
from silostudy.accuracy.stability import stability_cube
from silostudy.choice.expand import expand_file
from silostudy.compute.beside import beside_cube
from silostudy.compute.buckling import buckling_cube
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.grains import grains_cube
from silostudy.compute.loads import loads_cube
from silostudy.compute.motion import motion_cube
from silostudy.compute.packing import packing_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.seismic import seismic_cube
from silostudy.compute.uncertainty import uncertainty_cube
from silostudy.cube.contract import VARIABLES
from silostudy.cube.io import write
from silostudy.stages import STAGES
from silostudy.sweep.merge import merge
from tests.conftest import ROOT, expanded
from tests.test_accuracy.test_silo_step import SILO
from tests.test_accuracy.test_stability_map import RESTING
from tests.test_buckling.test_shell_earthquake import SHAKEN, STUDY, shell_cube, together
from tests.test_checks.studies import cube_of as checks_of
from tests.test_checks.studies import study as checks_study
from tests.test_compute.test_beside import swept
from tests.test_dem.small import carried, scene_of
from tests.test_figures.made_scenes import published_cube
from tests.test_figures.test_hopper_figures import BIN
from tests.test_laboratory.made_up import cube_of as made_up
from tests.test_laboratory.made_up import expansion as laboratory
from tests.test_packing.test_study import CONTENT as PACKING
from tests.test_seismic.conftest import quick
from tests.test_seismic.test_grains import CONTENT as GRAINS
from tests.test_sweep.sweeps import compute, save, stand_in

SIZES = {"axis": "size", "values": {"silo.diameter_m": [4.0, 6.0], "silo.cylinder_depth_m": [10.0, 15.0]}}
LEVELS = {"depth_m": None, "relative_depth": [0.5, 1.0]}
ONE_NETWORK = {"sweep": RESTING["sweep"][:1], "trial_steps": 1000}
FEW = {"scene": {"across": 18, "disc_count": 87}, "sweep": [], "runs": 1, "detailed": [{"across": 18, "run": 1}]}
SHORT = {"problems": ["beam_frequency"], "repeats": 1, "rungs": 2, "prices": True}


def _swept_scenes(folder: Path) -> xr.Dataset:
    path = save(folder)
    compute(path, folder / "parts")
    merge(path, folder / "parts", folder / "swept.nc")
    return xr.load_dataset(folder / "swept.nc")


def _shaken_shell(folder: Path) -> xr.Dataset:
    return shell_cube(*together(copy.deepcopy(STUDY) | {"earthquake": {"study": "shaken"}}, copy.deepcopy(SHAKEN), folder))


def _energetic_scene(folder: Path) -> xr.Dataset:
    scene = scene_of(record__energy=True)
    return cube_of(carried(scene), scene)


CUBES = {
    "pressure": lambda folder: pressure_cube(expanded(BIN | LEVELS | {"sweep": [SIZES]})),
    "uncertainty": lambda folder: uncertainty_cube(expanded(BIN | LEVELS | {"uncertainty": {"log2_samples": 6, "seed": 5}})),
    "loads": lambda folder: loads_cube(expanded(BIN | LEVELS | {"sweep": [SIZES], "loads": {"levels": 11}})),
    "buckling": lambda folder: buckling_cube(expand_file(ROOT / "config/studies/miller-1977.yaml")),
    "shell": _shaken_shell,
    "checks": lambda folder: checks_of(checks_study()),
    "seismic": lambda folder: seismic_cube(expanded(quick())),
    "dem": _energetic_scene,
    "grains": lambda folder: grains_cube(expanded(GRAINS | {"cycles": 1, "waited_cycles": 0})),
    "laboratory": lambda folder: made_up(laboratory()),
    "packing": lambda folder: packing_cube(expanded(PACKING | FEW)),
    "motion": lambda folder: motion_cube(expanded(PACKING | FEW)),
    "profile": lambda folder: profile_cube(expanded(copy.deepcopy(RESTING) | ONE_NETWORK | {"silo": SILO})),
    "stability": lambda folder: stability_cube(expanded(copy.deepcopy(RESTING) | ONE_NETWORK)),
    "accuracy": lambda folder: accuracy_cube(expanded({"kind": "accuracy", "title": "a little accuracy", "scene": SHORT})),
    "scenes": _swept_scenes,
    "published": lambda folder: published_cube("published-cases"),
    "beside": lambda folder: beside_cube(*swept(folder)),
}


@pytest.fixture(scope="module")
def paths(tmp_path_factory):
    """A small cube of every stage, as a file."""
    folder = tmp_path_factory.mktemp("cubes")
    prices = {name: np.zeros(1) for name in VARIABLES if name.startswith("effect_")}
    prices |= {name: np.array(["a part"]) for name in ("effect", "effect_room", "effect_uncounted")}
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr("silostudy.compute.scenes.measure", stand_in([]))
        patch.setattr(accuracy, "price_variables", lambda repeats, tell: prices)
        for stage, cube in CUBES.items():
            write(cube(folder), folder / f"{stage}.nc")
    return {stage: folder / f"{stage}.nc" for stage in CUBES}


def test_no_stage_is_left_out():
    assert set(CUBES) == set(STAGES)


@pytest.mark.long
@pytest.mark.parametrize("stage", CUBES)
def test_what_labels_a_dimension_is_a_coordinate(paths, stage):
    """Read without this package: every dimension has a label, and what the table calls a coordinate is one, nothing else."""
    with xr.open_dataset(paths[stage]) as cube:
        axes = set(cube.attrs["sweep_axes"].split())
        for dim in map(str, cube.dims):
            labels = [name for name, one in cube.coords.items() if one.dims == (dim,) or set(one.dims) - axes == {dim}]
            assert labels, dim
        labels = {name for name, row in VARIABLES.items() if row.role == "coordinate"}
        assert not labels & set(cube.data_vars)
        assert {str(name) for name in cube.coords if name in VARIABLES} <= labels | axes


@pytest.mark.long
@pytest.mark.parametrize("stage", CUBES)
def test_labels_select_and_numbers_plot(paths, stage):
    """sel at the last label of every dimension gives what isel gives at its place; every curve draws over its labels."""
    with xr.open_dataset(paths[stage]) as cube:
        for name, one in cube.data_vars.items():
            own = [str(dim) for dim in one.dims if dim in cube.indexes]
            last = one.sel({dim: cube[dim].values[-1] for dim in own})
            assert last.identical(one.isel(dict.fromkeys(own, -1))), name
        curves = [one for one in cube.data_vars.values() if one.ndim and one.dtype.kind == "f"]
        (line,) = curves[0].isel(dict.fromkeys(curves[0].dims[:-1], 0)).plot.line()
        assert len(line.get_xdata()) == curves[0].shape[-1]
    plt.close("all")


@pytest.mark.long
def test_wall_forces_are_selected_by_time_and_wall(paths):
    with xr.open_dataset(paths["dem"]) as cube:
        left = cube.wall_normal_force_mean.sel(wall_cell=cube.wall_name == "left")
        assert left.sizes == {"window_time": 20, "wall_cell": 7}
        early = left.sel(window_time=0.0312, method="nearest")
        assert float(early.window_time) == pytest.approx(0.03)
        (line,) = early.plot.line(y="wall_cell_y")
        assert line.get_ydata().tolist() == cube.wall_cell_y.values[cube.wall_name == "left"].tolist()
        assert line.axes.get_ylabel().split() == ["middle", "of", "the", "wall", "cell", "upward", "[m]"]
        assert cube.wall_shear_force_max.plot() is not None
        at_slit = cube.where((cube.contact_on_wall == 0) & (cube.contact_snapshot == 1), drop=True)
        assert 0 < at_slit.sizes["contact"] < cube.sizes["contact"]
        upright = cube.field_contact_stress.sel(field_way="y", field_of="y")
        assert upright.set_index(field_cell=["field_x", "field_y"]).unstack().sizes["field_time"] == 4
    plt.close("all")


@pytest.mark.long
def test_every_cube_keeps_cf_1_11(paths):
    checker = Path(sys.executable).parent / "compliance-checker"
    done = subprocess.run([checker, "-t", "cf:1.11", "-c", "strict", *paths.values()], capture_output=True, text=True)
    assert done.stdout.count("All tests passed!") == len(paths), done.stdout + done.stderr
