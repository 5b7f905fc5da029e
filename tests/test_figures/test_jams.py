"""Slots that jam: shares with their intervals, and powers with and without the fillings that jam."""

from itertools import pairwise

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.figures import jams_over_outlet
from silostudy.figures.beside import told
from silostudy.figures.jams_over_outlet import over_outlet, power, share_interval
from tests.test_figures.made_scenes import jam_cube


def test_interval_of_a_share():
    """Clopper and Pearson for 0, 5 and 10 of 10, as tables print them."""
    assert share_interval(0, 10) == pytest.approx((0.0, 0.3085), abs=1e-4)
    assert share_interval(5, 10) == pytest.approx((0.1871, 0.8129), abs=1e-4)
    assert share_interval(10, 10) == pytest.approx((0.6915, 1.0), abs=1e-4)


def test_power_is_that_of_the_flow():
    table = pd.DataFrame({"outlet_diameters": [4.0, 5.0, 8.0], "flow": 3.0 * np.array([4.0, 5.0, 8.0]) ** 1.4})
    assert power(table, "flow") == pytest.approx(1.4)
    assert np.isnan(power(table[:1], "flow"))


def test_jams_count_in_the_flow_of_all_and_not_in_that_of_the_others():
    """Two of four fillings jam at a quarter of the flow; one that never came to rest counts nowhere."""
    one = xr.Dataset(
        {"limit_reached": (("outlet_width", "filling"), [[0.0, 0.0, 1.0, 1.0, 1.0]]),
         "mean_discharge_rate": (("outlet_width", "filling"), [[4.0, 4.0, 1.0, 1.0, np.nan]]),
         "mean_grain_diameter": (("outlet_width", "filling"), np.full((1, 5), 0.005))},
        {"outlet_width": [0.02]},
    )  # fmt: skip
    (row,) = over_outlet(one).to_dict("records")
    assert (row["fillings"], row["jammed"], row["share_jammed"]) == (4, 2, 0.5)
    assert (row["flow_kg_m_s"], row["flow_with_jams_kg_m_s"]) == (4.0, 2.5)
    assert row["outlet_diameters"] == pytest.approx(4.0)


def test_the_shipped_study_is_read_by_its_axes():
    cube = jam_cube("slot-of-discs")
    assert cube.sizes["friction"] == 2
    assert cube["friction_title"].values.tolist() == ["without friction", "friction of 0.5"]


def test_settings_are_told_with_their_units():
    case = xr.Dataset(coords={"outlet_width": ((), 0.06, {"units": "m"}), "slenderness": ((), 2.0, {"units": "1"})})
    assert told({"outlet_width": 0.06, "slenderness": 2.0, "material": "M1"}, case) == "outlet width 0.06 m, slenderness 2, M1"
    assert told({}, case) == "the silo"


def test_it_says_which_setting_jams_and_what_has_no_part_in_a_power(tmp_path, kept):
    """With friction alone slots jam, and nothing at all leaves the narrowest."""
    cube = jam_cube("slot-of-discs").copy(deep=True)
    cube["limit_reached"][:] = 0.0
    cube["limit_reached"][1, :2] = 1.0
    cube["mean_discharge_rate"][1, 0] = 0.0
    cube["mean_discharge_rate"][1, 1] *= 1e-3
    jams_over_outlet.draw(cube, tmp_path / "jams")
    figure = kept[0]
    assert "Friction of 0.5: slots of up to 4.5 diameters jam (in no other setting any)" in " ".join(
        figure.get_suptitle().split()
    )
    (legend,) = figure.legends
    labels = [text.get_text() for text in legend.get_texts()]
    assert [label for label in labels if label.endswith(", 1 of no flow left out")] == labels[3:]
    assert "nothing flows" in legend.get_title().get_text()
    figure.draw_without_rendering()
    names = [tick.label1 for tick in figure.axes[1].yaxis.get_minor_ticks() + figure.axes[1].yaxis.get_major_ticks()]
    boxes = sorted((name.get_window_extent() for name in names if name.get_text()), key=lambda box: box.y0)
    inside = [box for box in boxes if figure.axes[1].bbox.y0 <= 0.5 * (box.y0 + box.y1) <= figure.axes[1].bbox.y1]
    assert len(inside) > 3
    assert all(below.y1 <= above.y0 for below, above in pairwise(inside))
