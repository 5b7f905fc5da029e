"""Any cube opens with one line and prints sensibly; a cube larger than the memory at hand is merged all the same."""

import os
import shutil
import subprocess
import sys
from pathlib import Path

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.choice.expand import expand_file
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.pressure import pressure_cube
from silostudy.cube.io import write
from silostudy.sweep.journal import line
from silostudy.sweep.merge import merge
from tests.conftest import ROOT
from tests.guides import blocks
from tests.test_dem.small import carried, scene_of
from tests.test_sweep.sweeps import compute, make_plan, save, stand_in


@pytest.fixture(params=["pressure", "scenes"])
def cube(request, tmp_path, monkeypatch) -> Path:
    path = tmp_path / f"{request.param}.nc"
    if request.param == "pressure":
        write(pressure_cube(expand_file(ROOT / "config/studies/mass-flow-bin.yaml")), path)
    else:
        monkeypatch.setattr("silostudy.compute.scenes.measure", stand_in([]))
        compute(save(tmp_path), tmp_path / "parts")
        merge(save(tmp_path), tmp_path / "parts", path)
    return path


def test_opens_with_one_line(cube):
    with xr.open_dataset(cube) as opened:
        assert opened.attrs["references"]
        for name, variable in opened.variables.items():
            assert variable.attrs.get("long_name") or variable.attrs.get("standard_name"), name
        floats = [name for name in opened.data_vars if opened[name].dtype.kind == "f"]
        assert all("units" in opened[name].attrs for name in floats)
        assert max(len(opened[name].to_dataframe()) for name in floats if opened[name].ndim) > 3


def test_ncdump_prints_it(cube):
    if shutil.which("ncdump") is None:
        pytest.skip("no ncdump: Debian's package netcdf-bin")
    head = subprocess.run(["ncdump", "-h", cube], capture_output=True, text=True, check=True).stdout
    assert ':Conventions = "CF-1.11"' in head
    assert ':units = "' in head
    assert "_FillValue = NaN" in head
    whole = subprocess.run(["ncdump", cube], capture_output=True, text=True, check=True).stdout
    assert whole.rstrip().endswith("}")


@pytest.mark.long
def test_the_guide_to_results_runs_as_it_stands(tmp_path):
    (guide,) = (block.text for block in blocks("results/README.md", "python"))
    write(pressure_cube(expand_file(ROOT / "config/studies/wheat-family.yaml")), tmp_path / "results/wheat-family/pressure.nc")
    scene = scene_of()
    write(cube_of(carried(scene), scene), tmp_path / "results/dem/kiyama-17-18.nc")
    environment = {**os.environ, "MPLBACKEND": "Agg"}
    subprocess.run([sys.executable, "-c", guide], cwd=tmp_path, env=environment, check=True)
    load = pd.read_csv(tmp_path / "load.csv")
    assert list(load) == ["depth", "wall_normal_pressure", "wall_friction_traction"]
    assert load["depth"].is_monotonic_increasing
    assert load["wall_normal_pressure"].gt(0).all()


LIMITED = """
import resource, sys
from pathlib import Path
import netCDF4, xarray, silostudy.sweep.merge, silostudy.compute.scenes
room, across = int(sys.argv[4]), int(sys.argv[5])
silostudy.compute.scenes.coordinates = lambda study: {"body": [str(k) for k in range(across)]}
now = int(Path("/proc/self/statm").read_text().split()[0]) * resource.getpagesize()
resource.setrlimit(resource.RLIMIT_AS, (now + room, now + room))
path, folder, output = map(Path, sys.argv[1:4])
print(silostudy.sweep.merge.merge(path, folder, output, memory=room / 8))
"""


@pytest.mark.long
def test_a_cube_larger_than_the_memory_is_merged(tmp_path):
    """A cube of 64 MB from journals of 155 MB, with 40 MB to spare."""
    count, across, room = 10_000, 800, 40_000_000
    frictions = [round(1e-5 * k, 5) for k in range(count)]
    path, folder = save(tmp_path, slits=[0.06], frictions=frictions, case_s=1.0, part_s=1000.0), tmp_path / "parts"
    for part, rows in make_plan(path, folder)[0].items():
        with (folder / f"{part}.jsonl").open("wb") as stream:
            for position, key in rows:
                numbers = {"resting_normal_force": [position / 3] * across}
                stream.write(line(key, {"case": key, "seconds": 1.0, "numbers": numbers}))
    command = [sys.executable, "-c", LIMITED, path, folder, tmp_path / "scenes.nc", room, across]
    done = subprocess.run(list(map(str, command)), cwd=ROOT, capture_output=True, text=True)
    assert done.stdout.strip() == f"({count}, 0)", done.stderr[-2000:]
    with xr.open_dataset(tmp_path / "scenes.nc") as merged:
        force = merged["resting_normal_force"]
        assert force.size * 8 > 1.5 * room
        np.testing.assert_array_equal(force.isel(slit_width=0, body=across - 1), np.arange(count) / 3)
