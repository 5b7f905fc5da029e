"""The cube: provenance, atomic writing, and a contract that refuses what it does not know."""

import os
import re
from pathlib import Path
from types import SimpleNamespace

import netCDF4
import numpy as np
import pytest
import xarray as xr

from silostudy.compute.pressure import pressure_cube
from silostudy.cube.contract import IN_SPACE, VARIABLES, check, variable
from silostudy.cube.fingerprint import damaged, fingerprint
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
from silostudy.files import as_written, check_output, seal, set_aside
from silostudy.tables.handbook import table_4_2_5
from tests.conftest import ROOT, expanded

SWEPT = {
    "sweep": [
        {"axis": "slenderness", "values": {"silo.slenderness": [1.0, 2.0]}},
        {"axis": "size", "values": {"silo.diameter_m": [3.0, 5.0], "silo.top_cone_height_m": [0.0, 1.0]}},
        {"axis": "solid", "values": {"solid": ["wheat", "cement"]}},
    ],
    "relative_depth": [0.25, 1.0],
}


@pytest.fixture
def swept(study):
    study.pop("depth_m")
    study["scene"]["wall"] = "as_cast_concrete"
    return pressure_cube(expanded(study | SWEPT))


def test_dimensions_and_coordinates(wheat, swept):
    assert wheat["wall_normal_pressure"].dims == ("pressure_method", "phase", "depth")
    assert {table.depth for table in table_4_2_5()} <= set(wheat["depth"].values)
    assert swept["wall_normal_pressure"].dims == ("pressure_method", "phase", "slenderness", "size", "solid", "relative_depth")
    assert swept["depth"].dims == ("slenderness", "size", "solid", "relative_depth")
    assert float(swept["depth"].sel(slenderness=2.0, size=1, solid="wheat", relative_depth=1.0)) == pytest.approx(10 + 1 / 3)
    assert list(swept["size_diameter"].values) == [3.0, 5.0]
    assert swept["slenderness"].attrs["units"] == "1"


def test_a_sweep_gives_what_its_cases_give_alone(study, swept):  # swept has dropped depth_m and set the wall
    study |= {"relative_depth": [0.25, 1.0]}
    study["scene"]["solid"] = "cement"
    study["scene"]["silo"] = {"plan": "circular", "diameter_m": 5.0, "slenderness": 2.0, "top_cone_height_m": 1.0,
                              "hopper": {"half_angle_deg": 45.0}}  # fmt: skip
    alone = pressure_cube(expanded(study))
    here = {"slenderness": 2.0, "size": 1, "solid": "cement"}
    for name in ("wall_normal_pressure", "axial_wall_force", "overpressure_factor"):
        np.testing.assert_array_equal(alone[name].values, swept[name].sel(here).values)
    assert str(alone["case"].values) == str(swept["case"].sel(here).values)


def test_round_trip_and_provenance(wheat, tmp_path):
    path = tmp_path / "deep/er/pressure.nc"
    write(wheat, path)
    back = read(path)
    xr.testing.assert_identical(back, wheat)
    for name in ("study", "study_hash", "source_stamp", "package_versions", "references", "Conventions"):
        assert back.attrs[name]
    assert "handbook" in back.attrs["references"]


def test_equal_inputs_give_equal_files(study, tmp_path):
    for name in ("one.nc", "two.nc"):
        write(pressure_cube(expanded(study)), tmp_path / name)
    assert (tmp_path / "one.nc").read_bytes() == (tmp_path / "two.nc").read_bytes()


def test_half_written_file_never_looks_like_a_result(wheat, tmp_path, monkeypatch):
    path = tmp_path / "pressure.nc"
    write(wheat, path)
    before = path.read_bytes()

    def breaks(self, target, **_):
        target.write_bytes(b"half a file")
        raise OSError("disk full")

    monkeypatch.setattr(xr.Dataset, "to_netcdf", breaks)
    with pytest.raises(BadInput, match=r"cannot be written \(disk full\)"):
        write(wheat, path)
    assert path.read_bytes() == before
    assert {file.name for file in tmp_path.iterdir()} == {"pressure.nc", ".pressure.nc.sha256"}
    assert as_written(path)


@pytest.mark.parametrize("break_it", [
    pytest.param(lambda path: flip(path, 10), id="its head"),
    pytest.param(lambda path: os.truncate(path, 1000), id="cut off"),
    pytest.param(lambda path: edit(path, lambda file: file["depth"].__setitem__(2, 0.126)), id="a number"),
    pytest.param(lambda path: edit(path, lambda file: file["pressure_method_title"].__setitem__(0, "mine")), id="a name"),
])  # fmt: skip
def test_a_damaged_cube_is_known(wheat, tmp_path, break_it, capsys):
    path = tmp_path / "pressure.nc"
    write(wheat, path)
    assert damaged([path]) == []
    assert capsys.readouterr().err == ""
    break_it(path)
    assert damaged([path]) == [path]
    assert "pressure.nc is damaged: a run moves it to pressure.nc.damaged and makes it again" in capsys.readouterr().err


def flip(path, place):
    content = bytearray(path.read_bytes())
    content[place] ^= 1
    path.write_bytes(content)


def edit(path, change):
    with netCDF4.Dataset(path, "a") as file:
        change(file)


def test_a_cube_whose_attributes_were_edited_is_kept(wheat, tmp_path, capsys):
    path = tmp_path / "pressure.nc"
    write(wheat, path)
    edit(path, lambda file: (file.setncattr("title", "mine"), file["depth"].setncattr("long_name", "below the top")))
    assert damaged([path]) == []
    assert "pressure.nc was edited, and its data are what was written: kept" in capsys.readouterr().err


def test_pieces_of_a_large_variable_make_the_same_fingerprint(wheat, tmp_path, monkeypatch):
    write(wheat, tmp_path / "pressure.nc")
    whole = fingerprint(tmp_path / "pressure.nc")
    monkeypatch.setattr("silostudy.cube.fingerprint.PIECE", 300)
    assert fingerprint(tmp_path / "pressure.nc") == whole


def test_setting_aside_loses_nothing(tmp_path):
    for number in range(3):
        (tmp_path / "a.nc").write_text(str(number))
        set_aside(tmp_path / "a.nc")
    texts = {path.name: path.read_text() for path in tmp_path.iterdir()}
    assert texts == {"a.nc.damaged": "0", "a.nc.damaged-2": "1", "a.nc.damaged-3": "2"}


def test_folder_that_cannot_be_written(wheat, tmp_path):
    (tmp_path / "results").write_text("a file where the folder should be")
    with pytest.raises(BadInput, match=r"results folder = .*cannot be written"):
        write(wheat, tmp_path / "results" / "pressure.nc")


@pytest.mark.parametrize("error", [OSError(28, "No space left on device"), RuntimeError("NetCDF: HDF error")])
def test_a_disk_that_is_full_is_one_line_and_leaves_the_older_file(wheat, tmp_path, monkeypatch, error):
    write(wheat, path := tmp_path / "pressure.nc")

    def full(*_, **__):
        raise error

    for name in ("xarray.Dataset.to_netcdf", "silostudy.files._write_seal"):
        with monkeypatch.context() as patch:
            patch.setattr(name, full)
            with pytest.raises(BadInput, match=r"output = '.*pressure\.nc': cannot be written .*(No space|disk full)"):
                write(wheat, path)
    assert as_written(path)
    assert sorted(one.name for one in tmp_path.iterdir()) == [".pressure.nc.sha256", "pressure.nc"]


def test_a_seal_that_finds_no_room_leaves_the_older_one(tmp_path, monkeypatch):
    (path := tmp_path / "a.nc").write_text("older")
    seal(path)

    def full(*_, **__):
        raise OSError(28, "No space left on device")

    monkeypatch.setattr(Path, "write_text", full)
    with pytest.raises(OSError, match="No space"):
        seal(path)
    assert as_written(path)
    assert len(list(tmp_path.iterdir())) == 2


def test_places_that_cannot_be_looked_into_are_told_before_a_run(tmp_path, monkeypatch):
    with pytest.raises(BadInput, match="has too long a name: 200 bytes at most"):
        check_output(tmp_path / f"{'x' * 201}.nc")
    with pytest.raises(BadInput, match=r"cannot be written \(File name too long\)"):
        check_output(tmp_path / ("x" * 300) / "a.nc")
    monkeypatch.setattr("shutil.disk_usage", lambda place: SimpleNamespace(free=0))
    with pytest.raises(BadInput, match="its disk is full"):
        check_output(tmp_path / "a.nc")


def test_contract_refuses_strangers(wheat):
    with pytest.raises(BadInput, match="variable = 'pressure'"):
        check(wheat.assign(pressure=wheat["wall_normal_pressure"]))
    with pytest.raises(BadInput, match="dimensions of unit_weight"):
        check(wheat.assign(unit_weight=wheat["unit_weight"].expand_dims(depth=wheat["depth"])))
    changed = wheat.copy()
    changed["vertical_pressure"].attrs["units"] = "kPa"
    with pytest.raises(BadInput, match=r"units of vertical_pressure = 'kPa'.*must be Pa"):
        check(changed)


def test_contract_keeps_labels_labels_and_numbers_numbers(wheat):
    with pytest.raises(BadInput, match="role of case = 'data': must be coordinate"):
        check(wheat.reset_coords("case"))
    with pytest.raises(BadInput, match="role of unit_weight = 'coordinate': must be data"):
        check(wheat.set_coords("unit_weight"))
    with pytest.raises(BadInput, match="dimension = 'phase': has no coordinate that labels it"):
        check(wheat.drop_vars("phase"))


def test_an_axis_named_like_a_variable_is_told(study):
    study["sweep"] = [{"axis": "wall_friction", "values": {"properties.wall_friction": [0.3, 0.4]}}]
    with pytest.raises(BadInput, match="axis = 'wall_friction': the pressure cube has a variable of this name"):
        pressure_cube(expanded(study))


def test_provenance_and_check_are_attached_in_one_place():
    """No other module of the package makes a cube of its own."""
    makers = {
        path.relative_to(ROOT).as_posix()
        for path in (ROOT / "silostudy").rglob("*.py")
        if re.search(r"\bprovenance\(|check\(xr\.Dataset\(", path.read_text())
    }
    assert makers == {"silostudy/cube/assemble.py", "silostudy/cube/provenance.py"}
    built = [path.name for path in (ROOT / "silostudy/compute").rglob("*.py") if "xr.Dataset(" in path.read_text()]
    assert built == []


def test_reading_what_is_no_cube(tmp_path):
    path = tmp_path / "broken.nc"
    path.write_bytes(b"CDF\x01 truncated")
    with pytest.raises(BadInput, match="must be a netCDF file"):
        read(path)


def test_a_cube_of_an_older_contract_is_told_so(wheat, tmp_path):
    path = tmp_path / "old.nc"
    names = {name: str(name).removeprefix("pressure_") for name in wheat.coords if str(name).startswith("pressure_method")}
    old = wheat.rename(names)
    del old.attrs["cube_contract"]
    old.to_netcdf(path)
    with pytest.raises(
        BadInput,
        match=r"contract 1, and not 3 \(since 2 the dimension .* is pressure_method, no longer method\): compute it again$",
    ):
        read(path)


def test_methods_are_selected_by_keyword(wheat):
    one = wheat.sel(pressure_method="janssen", phase="filling")
    assert one["wall_normal_pressure"].dims == ("depth",)
    assert str(one["pressure_method_title"].values) == "Janssen"


def test_a_contract_that_changed_cubes_of_scenes_alone_leaves_others_readable(wheat, tmp_path):
    wheat.assign_attrs(cube_contract=2).to_netcdf(tmp_path / "study.nc")
    assert read(tmp_path / "study.nc").attrs["cube_contract"] == 2
    wheat.assign_attrs(cube_contract=2, stage="dem").to_netcdf(tmp_path / "scene.nc")
    with pytest.raises(BadInput, match=r"contract 2, and not 3 .since 3 scenes of discs and of spheres .*: compute it again$"):
        read(tmp_path / "scene.nc")


def test_a_name_of_discs_is_of_spheres_too_in_the_unit_of_space():
    """A cube is of spheres where it has grains; a unit of the plane is refused there."""
    assert variable("energy").units == "J m-1"
    assert variable("energy", ["grain"]).units == "J"
    assert variable("energy", ["grain"]).long_name == variable("energy").long_name
    assert all(
        row.units != VARIABLES[name].units or row.long_name != VARIABLES[name].long_name for name, row in IN_SPACE.items()
    )
    scene = xr.Dataset({"outflow_mass": ("outflow_time", [0.0], {"units": "kg m-1"})}, {"outflow_time": [0.0], "grain": [0]})
    scene["outflow_time"].attrs["units"] = "s"
    assert check(scene.drop_vars("grain")) is not None
    with pytest.raises(BadInput, match=r"units of outflow_mass = 'kg m-1': must be kg"):
        check(scene)
