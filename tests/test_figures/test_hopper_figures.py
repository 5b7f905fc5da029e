"""Figures of hoppers, of today's codes, of scatter and of measurements: what they show is what the cube holds."""

import copy

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest

from silostudy.choice.expand import expand_file
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.uncertainty import uncertainty_cube
from silostudy.figures import (
    comparison_today,
    governing_load_case,
    jenike_charts,
    measured_silos,
    silo_pressures,
    sobol_indices,
    uncertainty_bands,
)
from silostudy.figures.steps import jumps, over_depth
from silostudy.tables.measured import measured_pressures
from silostudy.tables.outputs import OUTPUTS
from tests.conftest import ROOT, expanded
from tests.test_figures.words import told

MODULES = (
    comparison_today,
    governing_load_case,
    jenike_charts,
    measured_silos,
    silo_pressures,
    sobol_indices,
    uncertainty_bands,
)
BIN = {
    "kind": "pressure",
    "title": "a bin",
    "scene": {
        "silo": {
            "plan": "circular",
            "diameter_m": 4.0,
            "cylinder_depth_m": 10.0,
            "hopper": {"half_angle_deg": 18.0, "outlet_width_m": 0.5, "wall": "d2"},
        },
        "solid": "wheat_e1",
        "wall": "d2",
        "properties": {"effective_friction_angle_deg": 45.0, "poisson_ratio": 0.35},
    },
    "methods": ["janssen", "jenike_1969", "en1991_4", "en1991_4_wall_normal", "en1991_4_vertical_load"],
    "phases": ["filling", "switch", "discharge"],
    "depth_m": {"start": 0.0, "stop": 10.0, "count": 21},
    "hopper_position": {"start": 0.0, "stop": 1.0, "count": 11},
}


@pytest.fixture
def hopper_bin():
    return copy.deepcopy(BIN)


def test_every_output_has_its_module():
    assert {module.__name__.split(".")[-1] for module in MODULES} <= set(OUTPUTS)


def test_silo_to_scale_with_pressures_off_the_wall(hopper_bin, tmp_path, kept):
    cube = pressure_cube(expanded(hopper_bin))
    silo_pressures.draw(cube, tmp_path / "silo")
    panels = kept[0].axes
    assert len(panels) == 2 * 3  # two methods with a hopper, three load cases
    for panel in panels:
        assert panel.get_aspect() == 1.0
        assert panel.yaxis_inverted()
    assert panels[0].get_ylabel() == "depth z (m)"
    assert panels[-1].get_xlabel() == "distance from the axis (m)"
    said = "\n".join(text.get_text() for text in panels[2].texts)
    ring = float(cube["ring_force"].sel(pressure_method="jenike_1969", phase="discharge")) / 1e3
    assert f"P {ring:.0f} kN" in said
    assert "off by" in said
    numbers = pd.read_csv(tmp_path / "silo.csv")
    flow = numbers[(numbers.pressure_method == "jenike_1969") & (numbers.phase == "discharge") & (numbers.side == "normal")]
    peak = float(cube["hopper_normal_pressure"].sel(pressure_method="jenike_1969", phase="discharge").max()) / 1e3
    assert flow.pressure_kPa.iloc[21:].max() == pytest.approx(peak, rel=1e-6)  # 21 depths, then the hopper


def test_the_switch_lies_between_flow_and_initial_field(hopper_bin):
    cube = pressure_cube(expanded(hopper_bin))
    table = silo_pressures.state(cube, "jenike_1969", "switch")
    shown = table[(table.side == "normal") & (table.part == "hopper")].pressure_kPa.to_numpy() * 1e3
    pressure = cube["hopper_normal_pressure"].sel(pressure_method="jenike_1969")
    assert shown[:5] == pytest.approx(pressure.sel({"phase": "filling"}).values[:5])
    assert shown[5:] == pytest.approx(pressure.sel({"phase": "discharge"}).values[5:])
    assert silo_pressures.state(cube, "en1991_4", "switch") is None


def test_comparison_shows_the_band_and_the_measured_point(hopper_bin, tmp_path, kept):
    point = measured_pressures()[0]
    hopper_bin["scene"]["silo"] = {"plan": "circular", "diameter_m": point.diameter, "cylinder_depth_m": point.height}
    hopper_bin |= {"hopper_position": None, "phases": ["filling", "discharge"]}
    cube = pressure_cube(expanded(hopper_bin))
    comparison_today.draw(cube, tmp_path / "today")
    left = kept[0].axes[0]
    assert left.yaxis_inverted()
    assert " ".join(left.get_xlabel().split()) == "wall normal pressure (kPa)"
    stars = [line for line in left.lines if line.get_marker() == "*"]
    assert stars[0].get_xydata().tolist() == [[28.2, 15.2]]
    numbers = pd.read_csv(tmp_path / "today.csv")
    band = numbers[numbers.curve.str.contains("all sets") & numbers.curve.str.contains("discharge")].iloc[-1]
    ends = cube["wall_normal_pressure"].sel(
        {"phase": "discharge", "pressure_method": ["en1991_4_wall_normal", "en1991_4_vertical_load"]}
    )
    assert (band.wall_normal_pressure_kPa, band.upper_kPa) == pytest.approx(
        (float(ends[..., -1].min()) / 1e3, float(ends[..., -1].max()) / 1e3), rel=1e-6
    )


def test_comparison_shows_the_sampled_scatter(hopper_bin, tmp_path, kept):
    """Where the uncertainty cube comes along: a bar beside the mark of each largest pressure, and a word on it."""
    hopper_bin |= {"uncertainty": {"log2_samples": 8, "seed": 3}, "hopper_position": None, "phases": ["filling", "discharge"]}
    expansion = expanded(hopper_bin)
    cube, sampled = pressure_cube(expansion), uncertainty_cube(expansion)
    comparison_today.draw(cube, tmp_path / "plain")
    comparison_today.draw(cube, tmp_path / "today", sampled)
    plain, barred = (len(figure.axes[-1].collections) for figure in kept)
    assert (plain, barred) == (0, len(kept[1].axes[-1].lines))
    row = (
        pd.read_csv(tmp_path / "today.csv").query("largest_kPa > 0").set_index("curve").loc["EN 1991-4:2006, design, discharge"]
    )
    quantiles = sampled["wall_normal_pressure_quantile"].sel(pressure_method="en1991_4", phase="discharge").values / 1e3
    assert (row.p05_kPa, row.p95_kPa) == pytest.approx((quantiles[0].max(), quantiles[2].max()))
    bar = kept[1].axes[-1].collections[int(row["rank"])].get_segments()[0]
    assert bar[:, 0] == pytest.approx([row.p05_kPa, row.p95_kPa])
    assert "5 % to 95 %" in told(kept[1])
    assert "5 % to 95 %" not in told(kept[0])


def test_the_comparison_s_title_says_its_message(wheat, tmp_path, kept):
    comparison_today.draw(wheat, tmp_path / "today")
    deutsch = wheat["wall_normal_pressure"].sel(phase="discharge", pressure_method="deutsch") / 1e3
    assert f"to {float(deutsch.max()):.0f} kPa in discharge" in told(kept[0])


def test_a_jump_is_drawn_as_a_step(kept):
    """Between two levels the curve goes down, across at their middle, and down; elsewhere it is as it was."""
    panel = plt.figure().subplots()
    depth, values = np.linspace(0.0, 10.0, 11), np.array([0, 1, 2, 3, 4, 5, 16, 17, 18, 19, 20.0])
    over_depth(panel, values, depth, color="k")
    upper, lower, step = panel.lines
    assert upper.get_ydata().tolist() == [0, 1, 2, 3, 4, 5]
    assert lower.get_xdata().tolist() == [16, 17, 18, 19, 20]
    assert step.get_xydata().tolist() == [[5, 5], [5, 5.5], [16, 5.5], [16, 6]]
    assert jumps(np.linspace(0, 1, 9) ** 2).size == 0


def test_charts_from_the_fields(tmp_path, kept):
    cube = pressure_cube(expand_file(ROOT / "config/studies/jenike-charts.yaml"))
    jenike_charts.draw(cube, tmp_path / "charts")
    initial, flow = kept[0].axes
    assert initial.get_xlabel() == flow.get_xlabel() == "half angle of the cone θ (°)"
    numbers = pd.read_csv(tmp_path / "charts.csv")
    first = numbers[numbers.chart == "i_1"].groupby("wall_friction_angle_deg").value
    assert all(np.all(np.diff(values) <= 1e-12) for _, values in first)  # flatter cones carry their peak lower
    last = numbers[numbers.chart == "q_2"].groupby("wall_friction_angle_deg").half_angle_deg.max()
    limits = np.degrees(cube["mass_flow_limit"].isel(half_angle=0)).values
    assert np.abs(np.sort(last.to_numpy())[::-1] - limits).max() < 0.6  # the field ends at the mass-flow limit


def test_governing_load_case_is_the_largest_pressure(hopper_bin, tmp_path, kept):
    hopper_bin.pop("depth_m")
    hopper_bin |= {"relative_depth": [1.0], "phases": ["filling", "discharge"], "methods": ["jenike_1969", "en1991_4"]}
    hopper_bin["sweep"] = [
        {"axis": "half_angle", "values": {"silo.hopper.half_angle_deg": [10.0, 20.0, 50.0]}},
        {"axis": "slenderness", "values": {"silo.slenderness": [1.0, 3.0]}},
    ]
    cube = pressure_cube(expanded(hopper_bin))
    governing_load_case.draw(cube, tmp_path / "map")
    case, largest = governing_load_case.governing(cube.sel(pressure_method="en1991_4"))
    pressure = cube["hopper_normal_pressure"].sel(pressure_method="en1991_4")
    assert (case[2] < 2).all()  # shallow: discharge as filling, which then counts
    beyond, _ = governing_load_case.governing(cube.sel(pressure_method="jenike_1969"))
    assert np.isnan(beyond[2]).all()  # no mass flow
    for i in range(2):
        for j in range(2):
            one = pressure.isel(half_angle=i, slenderness=j)
            assert float(largest[i, j]) == float(one.max())
            assert (float(case[i, j]) >= 2) == bool(one.sel({"phase": "discharge"}).max() > one.sel({"phase": "filling"}).max())
    assert " ".join(kept[0].axes[0].get_xlabel().split()) == "cylinder depth over diameter H/D"


def test_measured_points_and_what_brackets_them(tmp_path, kept):
    cube = pressure_cube(expand_file(ROOT / "config/studies/measured-silos.yaml"))
    measured_silos.draw(cube, tmp_path / "measured")
    numbers = pd.read_csv(tmp_path / "measured.csv").query("shown == 'at the measured depth'")
    assert set(numbers.measurement) == {"thompson_12_8", "thompson_11_0"}
    assert numbers.off.to_numpy() == pytest.approx(
        (numbers.computed_kPa / numbers.measured_kPa - 1).to_numpy(), rel=1e-5, abs=1e-6
    )
    for _, group in numbers[numbers.phase == "filling"].groupby("measurement"):
        above = group[group.bracket == "next above"]
        assert above.off.min() == group[group.off >= 0].off.min()
        assert len(group[group.bracket == "next below"]) == (group.off < 0).any()


def test_scatter_and_its_indices(hopper_bin, tmp_path, kept):
    hopper_bin |= {"uncertainty": {"log2_samples": 8, "seed": 3}, "hopper_position": None, "phases": ["filling", "discharge"]}
    cube = uncertainty_cube(expanded(hopper_bin))
    uncertainty_bands.draw(cube, tmp_path / "bands")
    sobol_indices.draw(cube, tmp_path / "sobol")
    numbers = pd.read_csv(tmp_path / "bands.csv")
    assert (numbers.p05_kPa <= numbers.p50_kPa).all()
    assert (numbers.p50_kPa <= numbers.p95_kPa).all()
    assert uncertainty_bands.distinct_methods(cube) == ["janssen", "jenike_1969", "en1991_4"]
    assert "share of the variance" in kept[1].axes[0].get_xlabel()
    assert kept[0].axes[0].yaxis_inverted()
