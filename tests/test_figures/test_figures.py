"""Figures show what the cube holds, with labels and units, and save the numbers they show."""

import numpy as np
import pandas as pd
import pytest

from silostudy.compute.pressure import pressure_cube
from silostudy.figures import fig_4_2_11, governing_method, overpressure_over_slenderness, table_4_2_5
from silostudy.tables.handbook import TONNE_PER_M2
from silostudy.tables.outputs import OUTPUTS
from tests.conftest import expanded
from tests.test_figures.words import told


@pytest.fixture
def family(study):
    study.pop("depth_m")
    study |= {"methods": "all", "relative_depth": {"start": 0.1, "stop": 1.0, "count": 10}}
    study["scene"] |= {"solid": "wheat", "wall": "as_cast_concrete", "properties": {"poisson_ratio": 0.4}}
    study["sweep"] = [
        {"axis": "diameter", "values": {"silo.diameter_m": [3.0, 9.0]}},
        {"axis": "slenderness", "values": {"silo.slenderness": [1.0, 2.0, 4.0]}},
        {"axis": "solid", "values": {"solid": ["wheat", "cement"]}},
    ]
    return pressure_cube(expanded(study))


def test_fig_4_2_11(wheat, tmp_path, kept):
    fig_4_2_11.draw(wheat, tmp_path / "fig_4_2_11")
    left, right = kept[0].axes
    assert left.yaxis_inverted()
    assert left.get_ylabel() == "depth z (m)"
    assert left.get_xlabel() == "wall normal pressure (t/m²)"
    assert left.child_axes[0].get_xlabel() == "wall normal pressure (kPa)"
    assert right.get_xlabel() == "ratio to static Janssen (curve 6)"
    named = [line for line in left.lines if not line.get_label().startswith("_")]  # a stepped curve has pieces without a name
    labels = [line.get_label() for line in named]
    numbered = [label for label in labels if label[0].isdigit() and "as printed" not in label]
    assert len(numbered) == 13
    assert "8  Jenike, mass flow (as printed), discharge" in labels
    looks = {(line.get_color(), line.get_marker(), str(line.get_linestyle()), line.get_markerfacecolor()) for line in named}
    assert len(looks) == len(named)
    assert len({look[1:] for look in looks}) == len(looks)  # without colour too
    janssen = next(line for line in left.lines if line.get_label() == "6  Janssen, filling")
    expected = wheat["wall_normal_pressure"].sel(pressure_method="janssen", phase="filling").values / TONNE_PER_M2
    np.testing.assert_allclose(janssen.get_xdata(), expected)
    numbers = pd.read_csv(tmp_path / "fig_4_2_11.csv")
    assert set(numbers["curve"]) == set(labels)
    for suffix in (".png", ".svg"):
        assert (tmp_path / f"fig_4_2_11{suffix}").stat().st_size > 10_000


def test_svg_is_the_same_each_time(wheat, tmp_path):
    for name in ("one", "two"):
        fig_4_2_11.draw(wheat, tmp_path / name)
    assert (tmp_path / "one.svg").read_bytes() == (tmp_path / "two.svg").read_bytes()


def test_table_4_2_5(wheat, tmp_path):
    table_4_2_5.draw(wheat, tmp_path / "table")
    table = pd.read_csv(tmp_path / "table.csv", keep_default_na=False)
    assert list(table) == ["pressure_method", "phase", "depth_m", "printed_t_m2", "computed_t_m2", "deviation", "remark"]
    right = table[~table.pressure_method.str.endswith("_as_printed")]
    assert len(right) == 13 * 14
    off = right[right.deviation.abs() > 1e-3]
    assert set(zip(off.pressure_method, off.phase, strict=True)) == {("jenike_mass_flow", "discharge"), ("caquot", "discharge")}
    assert off.remark.str.contains("printed").all()
    assert list(off[off.pressure_method == "caquot"].depth_m) == [3.5]
    assert right[right.pressure_method != "jenike_mass_flow"].remark.ne("").sum() == 1
    as_printed = table[table.pressure_method == "jenike_mass_flow_as_printed"]
    assert as_printed.deviation.abs().max() < 2e-4


def test_overpressure_over_slenderness(family, tmp_path, kept):
    overpressure_over_slenderness.draw(family, tmp_path / "over")
    left = kept[0].axes[0]
    assert left.get_xlabel() == "cylinder depth over diameter H/D"
    assert "overpressure factor" in left.get_ylabel()
    numbers = pd.read_csv(tmp_path / "over.csv")
    peak = numbers[numbers.quantity == "largest pressure over largest static pressure"].set_index(
        ["pressure_method", "slenderness"]
    )
    assert peak.loc[("aij_load_draft", 2.0), "median"] == pytest.approx(2.6)
    assert peak.loc[("safarian_steel", 4.0), "max"] == pytest.approx(1.95)
    assert peak.loc[("jenike_mass_flow", 4.0), "cases"] == 4
    assert "deutsch" not in set(numbers["pressure_method"])  # masked throughout this family


def test_governing_method(family, tmp_path, kept):
    governing_method.draw(family, tmp_path / "governing")
    panels = kept[0].axes
    assert [panel.get_title() for panel in panels[:2]] == ["wheat", "cement"]
    assert panels[0].yaxis_inverted()
    assert "the same for all diameters" in told(kept[0])
    numbers = pd.read_csv(tmp_path / "governing.csv")
    for row in numbers.itertuples():
        level = int(np.abs(family["relative_depth"].values - row.relative_depth).argmin())
        here = {"diameter": 3.0, "slenderness": row.slenderness, "solid": row.solid}
        column = family["wall_normal_pressure"].sel(here).isel(relative_depth=level)
        assert row.wall_normal_pressure_Pa == pytest.approx(float(column.max()), rel=1e-6)
        assert float(column.sel(pressure_method=row.pressure_method).max()) == pytest.approx(float(column.max()), rel=1e-12)


def test_every_output_has_its_file():
    from importlib import import_module

    for key, row in OUTPUTS.items():
        assert callable(import_module(f"silostudy.figures.{key}").draw)
        assert row.kind in ("figure", "table", "animation", "note")
        assert row.demands <= {
            "single_case",
            "only_axes",
            "strakes",
            "hopper",
            "sine",
            "identification",
            "earthquake",
            "prices",
            "rings",
            "only_spheres",
            "only_discs",
            "means",
        }
