"""Beverloo's law found again in flows that were made by it."""

import numpy as np
import pandas as pd
import pytest

from silostudy.errors import BadInput
from silostudy.figures.outflow_over_outlet import draw, flows, line, power
from tests.test_figures.small_cubes import flow_cube

DIAMETER = 0.004  # m


def made(exponent=2.5, edge=1.5):
    """Flows of outlets of 6 to 11 diameters by the law."""
    width = np.linspace(0.024, 0.044, 6)
    flow = 2700.0 * (width - edge * DIAMETER) ** exponent
    return pd.DataFrame({"outlet_width_m": width, "mass_flow_kg_s": flow, "root_of_flow": flow**0.4})


def test_edge_and_power_are_those_of_the_law():
    slope, cut = line(made())
    assert (slope, cut) == pytest.approx((2700.0**0.4, 1.5 * DIAMETER), rel=1e-9)
    assert power(made(), 1.5 * DIAMETER) == pytest.approx(2.5, rel=1e-12)
    assert power(made(exponent=2.0), 1.5 * DIAMETER) == pytest.approx(2.0, rel=1e-12)


def test_a_wider_edge_asks_for_a_smaller_power():
    assert power(made(), 1.0 * DIAMETER) > 2.5 > power(made(), 2.0 * DIAMETER)


def test_no_line_through_one_outlet(tmp_path):
    with pytest.raises(BadInput, match="of fewer than two outlets"):
        draw(flow_cube("beverloo").isel(outlet_width=[0]), tmp_path / "flow")


def test_no_power_where_nothing_is_free():
    assert np.isnan(power(made(), 6.0 * DIAMETER))


def test_every_filling_of_the_study_is_a_point():
    table = flows(flow_cube("beverloo"))
    assert len(table) == 15
    assert table["outlet_width_m"].nunique() == 5
