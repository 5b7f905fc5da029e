"""What the figure of fields in a bin shows: the solid, inserts and words inside it, colours that end at what is shown."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from matplotlib.collections import LineCollection, QuadMesh
from matplotlib.text import Text

from silostudy.figures import bin_fields
from tests.test_figures.small_cubes import bin_cube
from tests.test_figures.test_content import drawn as figure_of


@pytest.mark.parametrize(("width", "told"), [(1.0, "the ratio of lateral to vertical stress"), (4.0, "where fields fade")])
def test_fields_that_fade_everywhere_give_no_ratio(width, told):
    cube = bin_cube()
    cube.attrs["field_width_m"] *= width
    assert told in bin_fields._message(cube, bin_fields.phases(cube), "at rest")


def test_a_solid_within_the_hopper_alone_gives_no_ratio():
    cube = bin_cube()
    low = cube.assign_attrs(transition_height_m=float(cube["field_z"].max()))
    assert "No solid stands" in bin_fields._message(low, bin_fields.phases(low), "at rest")


@pytest.mark.parametrize(
    ("times", "told"),
    [
        ([0.02, 0.04, 0.06, 0.08], ", the mean of 2 readings from 0.06 to 0.08 s"),
        ([0.01, 0.02, 0.04, 0.05], ", one reading alone, 0.01 s after the opening"),
    ],
)
def test_readings_in_discharge_are_told(times, told, tmp_path, monkeypatch):
    output = figure_of("bin_fields", [bin_cube().assign_coords(field_time=times)], tmp_path, monkeypatch)
    words = " ".join(text.get_text() for text in output.figure.findobj(Text)).replace("\n", " ")
    assert f"until a quarter of the solid is out{told}" in words
    plt.close("all")


def test_fields_of_a_low_silo_have_room_for_their_words(tmp_path, monkeypatch):
    cube = bin_cube()
    wide = cube.assign_coords(field_r=cube["field_r"] * 6.0)
    wide.attrs |= {name: cube.attrs[name] * 6.0 for name in ("half_width_m", "outlet_half_width_m")}
    output = figure_of("bin_fields", [wide], tmp_path, monkeypatch)
    assert (output.faults(), output.faults_of_look()) == ([], [])
    panels = [panel for panel in output.figure.axes if panel.get_title("left")]
    assert len({round(panel.get_position().y0, 3) for panel in panels}) == 2
    top = max(panel.get_tightbbox().y1 for panel in panels)
    assert max(panel.yaxis.label.get_window_extent().y1 for panel in panels) < top
    plt.close("all")


def test_an_insert_above_the_solid_is_not_cut_off(tmp_path, monkeypatch):
    cube = bin_cube()
    top = 0.9 * cube.attrs["top_height_m"]
    hat = {"insert_name": ["hat"] * 3, "insert_x": [0.0, 0.01, np.nan], "insert_z": [top, top, np.nan]}
    cube = cube.assign({name: ("insert_point", values) for name, values in hat.items()})
    output = figure_of("bin_fields", [cube], tmp_path, monkeypatch)
    assert output.figure.axes[0].get_ylim()[1] >= 100.0 * top
    plt.close("all")


def test_an_insert_is_drawn_on_both_sides_of_the_axis(tmp_path, monkeypatch):
    """Fields are means around the axis, of which the right side shows a later time."""
    cube = bin_cube()
    ramp = {"insert_name": ["ramp"] * 3, "insert_x": [0.01, 0.02, np.nan], "insert_z": [0.05, 0.06, np.nan]}
    cube = cube.assign({name: ("insert_point", values) for name, values in ramp.items()})
    output = figure_of("bin_fields", [cube], tmp_path, monkeypatch)
    drawn = [line.tolist() for silo in output.figure.axes[0].findobj(LineCollection) for line in silo.get_segments()]
    for side in (-1.0, 1.0):
        assert any(np.allclose(line, [(side, 5.0), (2.0 * side, 6.0)]) for line in drawn if len(line) == 2)
    plt.close("all")


def test_colours_of_fields_end_at_what_is_shown_and_no_blank_band_stands_over_them(tmp_path, monkeypatch):
    """Spheres that fall below the outlet are fast, and not shown."""
    cube = bin_cube().copy(deep=True)
    below = cube["field_z"].values < 0.0
    assert below.any()
    for name in ("field_density", "field_solid_fraction"):
        cube[name].loc[{"field_cell": below}] = float(cube[name].max())
    cube["field_velocity"].loc[{"field_cell": below}] = 10.0
    output = figure_of("bin_fields", [cube], tmp_path, monkeypatch)
    cells = pd.read_csv(next(tmp_path.glob("**/bin_fields.csv")), comment="#")
    mesh = output.figure.axes[1].findobj(QuadMesh)[0]
    assert mesh.get_clim()[1] <= cells["speed_m_s"][cells["height_cm"] > 0.0].max()
    output.figure.draw_without_rendering()
    gap = output.figure._suptitle.get_window_extent().y0 - output.figure.axes[0].get_tightbbox().y1
    assert 0.0 < gap < 0.15 * output.figure.dpi
    plt.close("all")
