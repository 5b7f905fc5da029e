"""What is said of a merged sweep whose means were to be as accurate as asked."""

import xarray as xr

from silostudy.commands.sweeps import certificate_lines

OF_CASES = {"fillings_computed": [8, 12], "cpu_time": [2.0, 3.0], "cpu_time_on_step": [0.25, 0.25]}
OF_MEANS = {
    "error_asked": [[0.05, 0.1], [0.05, 0.1]],
    "error_bound": [[0.04, 0.09], [0.06, 0.08]],
    "error_met": [[1.0, 1.0], [0.0, 1.0]],
    "step_change": [[0.01, 0.01], [0.01, 0.01]],
    "step_change_deviation": [[0.01, 0.01], [0.03, 0.01]],
}


def test_each_quantity_has_its_line(tmp_path):
    cube = xr.Dataset(
        {name: ("wide", values) for name, values in OF_CASES.items()}
        | {name: (("wide", "asked_quantity"), values) for name, values in OF_MEANS.items()},
        coords={"asked_quantity": ["mean_wall_force", "mean_outflow"]},
    )
    cube.to_netcdf(tmp_path / "scenes.nc")
    spent = "20 fillings, 5 CPU s, of which 0.5 on the step"
    unsure = "whose error is not known to that in 1"
    assert list(certificate_lines(tmp_path / "scenes.nc")) == [
        f"mean_wall_force: asked 5 % and more, met in 1 of 2 case(s), the worst 6 %; {spent}, {unsure}",
        f"mean_outflow: asked 10 % and more, met in 2 of 2 case(s), the worst 9 %; {spent}",
    ]


def test_a_sweep_that_asks_for_nothing_has_none(tmp_path):
    xr.Dataset({"cpu_time": ("wide", [1.0])}).to_netcdf(tmp_path / "scenes.nc")
    assert list(certificate_lines(tmp_path / "scenes.nc")) == []
