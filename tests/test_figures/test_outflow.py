"""Beverloo's law found again in flows that were made by it."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.errors import BadInput
from silostudy.figures.outflow_over_outlet import constant, draw, flows, line, power
from tests.test_figures.made_scenes import flow_cube

DIAMETER = 0.004  # m


def made(exponent=2.5, edge=1.5):
    """Flows of outlets of 6 to 11 diameters by the law."""
    width = np.linspace(0.024, 0.044, 6)
    flow = 2700.0 * (width - edge * DIAMETER) ** exponent
    return pd.DataFrame({"outlet_width_m": width, "mass_flow_kg_s": flow, "root_of_flow": flow**0.4})


def test_edge_and_power_are_those_of_the_law():
    slope, cut = line(made())
    assert (slope, cut) == pytest.approx((2700.0**0.4, 1.5 * DIAMETER), rel=1e-9)
    assert power(made(), 1.5 * DIAMETER) == pytest.approx((2.5, 0.0), rel=1e-12, abs=1e-9)
    assert power(made(exponent=2.0), 1.5 * DIAMETER) == pytest.approx((2.0, 0.0), rel=1e-12, abs=1e-9)


def test_interval_of_the_power_holds_the_law_s():
    """Flows that are 5 % too large and too small in turn: Student's interval by hand for four degrees of freedom."""
    table = made()
    table["mass_flow_kg_s"] *= 1.0 + 0.05 * (-1.0) ** np.arange(6)
    found, off = power(table, 1.5 * DIAMETER)
    x = np.log(table["outlet_width_m"] - 1.5 * DIAMETER)
    y = np.log(table["mass_flow_kg_s"])
    rest = y - y.mean() - found * (x - x.mean())
    assert off == pytest.approx(2.7764 * np.sqrt((rest**2).sum() / 4 / ((x - x.mean()) ** 2).sum()), rel=1e-4)
    assert abs(found - 2.5) < off


def test_constant_is_that_of_the_law():
    """W = 0.6 rho_b sqrt(g) (D - k d)^2.5 with rho_b = 1500 kg/m3."""
    slope = (0.6 * 1500.0 * 9.80665**0.5) ** 0.4
    cube = xr.Dataset({"unit_weight_at_rest": ("filling", [1500.0 * 9.80665])})
    assert constant(cube, slope) == pytest.approx(0.6, rel=1e-3)
    assert np.isnan(constant(xr.Dataset(), slope))


def test_a_wider_edge_asks_for_a_smaller_power():
    assert power(made(), 1.0 * DIAMETER)[0] > 2.5 > power(made(), 2.0 * DIAMETER)[0]


def test_no_line_through_one_outlet(tmp_path):
    with pytest.raises(BadInput, match="of fewer than two outlets"):
        draw(flow_cube("beverloo").isel(outlet_width=[0]), tmp_path / "flow")


def test_no_power_where_nothing_is_free():
    assert np.isnan(power(made(), 6.0 * DIAMETER)).all()


def test_every_filling_of_the_study_is_a_point():
    table = flows(flow_cube("beverloo"))
    assert len(table) == 15
    assert table["outlet_width_m"].nunique() == 5
