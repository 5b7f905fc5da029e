"""A scene in time: what leaves and which surface is pushed most, from made-up numbers whose answer is known."""

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.errors import BadInput
from silostudy.figures import silo_of_spheres
from silostudy.figures.flow_in_time import Flow, flow_of
from silostudy.figures.in_time import SHOWN, draw_forces, forces, left_out, message, pushed
from silostudy.figures.style import AID
from tests.test_figures.small_cubes import bin_cube
from tests.test_figures.test_content import drawn

TIME = np.array([1.0, 2.0, 3.0, 4.0])
OPENED = 2.0
PUSH = np.array([[9.0, 1.0, 0.1], [8.0, 2.0, 0.1], [4.0, 6.0, 9.0], [4.0, 5.0, 1.0]])  # floor, left, a bolt of no weight


SURFACES = ("floor", "left", "bolt")


def scene(opened, push=PUSH, events=((5.0, "rest: stop"),), **more):
    """A scene that opens at a time (s), or never, then of other events, and the forces on its surfaces."""
    times, actions = zip(*([(opened, "rest: open_outlet")] if np.isfinite(opened) else []), *events, strict=True)
    data = {"event_time": ("event", list(times)), "event_action": ("event", list(actions)), "window_time": TIME}
    return xr.Dataset(data | {"surface": list(SURFACES), "push": (("window_time", "surface"), push)} | more)


def table_of(cube):
    return forces(cube, cube["push"].values, "force_N")


def flow(times=(2.5, 3.0, 3.5)):
    rows = {"time_s": np.array(times), "outlet": "outlet", "mass_kg": 2.0 * np.arange(1, len(times) + 1)}
    return Flow(pd.DataFrame(rows), "mass_kg", 20.0, "kg")


def test_the_surface_that_rises_most_carries_something_at_rest():
    table = table_of(scene(OPENED))
    assert pushed(table, "force_N", OPENED) == ("left", 3.0)
    assert pushed(table[table.time_s <= OPENED], "force_N", np.inf)[0] == "floor"
    assert set(table_of(scene(OPENED, PUSH * [1, 0, 1])).surface) == {"floor", "bolt"}


def test_facets_of_a_sheet_are_one_surface():
    table = table_of(scene(OPENED, surface_sheet=("surface", ["floor", "tube", "tube"]))).set_index("surface")["force_N"]
    assert table["tube"].tolist() == pytest.approx((PUSH[:, 1] + PUSH[:, 2]).tolist())
    assert set(table.index) == {"floor", "tube"}


def told(cube, leaves):
    return message(cube, table_of(cube), "force_N", "N", leaves)


def test_what_leaves_is_told_with_its_rate():
    words = told(scene(OPENED), flow())
    assert words.startswith("Once the outlet opens 6 of 20 kg leave, 4 kg/s on average; the force on ")
    assert "left" in words
    assert "3 times that at rest" in words
    assert "nothing leaves" in told(scene(OPENED), flow(times=()))


def test_a_force_that_falls_is_not_said_to_rise():
    assert told(scene(OPENED, np.array([[9.0], [8.0], [7.0], [6.0]]) * [1, 0, 0]), flow()).endswith(
        "no surface is pressed more than at rest"
    )


def test_a_force_that_rises_by_less_than_is_told_is_not_said_to_rise():
    words = told(scene(OPENED, np.array([[9.0], [8.0], [8.01], [8.02]]) * [1, 0, 0]), flow())
    assert words.endswith("no surface is pressed more than at rest")


@pytest.mark.parametrize(
    ("events", "begins"),
    [
        ([(4.0, "rest: stop")], "At rest the largest force is that on “left"),
        ([(4.0, "time: stop")], "At the end the largest force is that on “left"),
        (
            [(2.0, "time: rotate"), (4.0, "time: stop")],
            "From “rotate” on the largest force is 9 N, on “bolt” at 3 s",
        ),
    ],
)
def test_a_scene_that_stays_shut_is_at_rest_only_where_it_came_to_rest(events, begins):
    assert told(scene(np.inf, events=events), flow(times=())).startswith(begins)


def test_what_a_feeder_takes_is_told():
    assert "6 of 20 kg leave, 4 kg/s on average; from \N{LEFT DOUBLE QUOTATION MARK}feed" in told(
        scene(np.inf, events=[(2.5, "rest: feed")]), flow()
    )


def test_mass_of_outlets_adds_up():
    rows = {"time_s": [2.0, 2.0, 3.0, 3.0], "outlet": ["a", "b"] * 2, "mass_kg": [1.0, 0.0, 1.0, 4.0]}
    assert Flow(pd.DataFrame(rows), "mass_kg", 10.0, "kg").told() == "5 of 10 kg leave, 4 kg/s on average"


def test_a_scene_that_recorded_nothing_is_told_what_to_record(tmp_path):
    with pytest.raises(BadInput, match=r"record\.wall_force_window_s = 'nothing': must be given"):
        silo_of_spheres.draw(bin_cube().drop_vars("surface_normal_force_mean"), tmp_path / "silo")


def shut_bin():
    """The bin of spheres whose outlet stays shut, so that nothing leaves it."""
    cube = bin_cube()
    leaves = [name for name in cube.variables if "outflow" in str(name)]
    return cube.drop_vars(leaves).assign(event_action=("event", np.array(["rest: set_friction", "after: stop"])))


@pytest.mark.parametrize("rests", [False, True])
def test_a_scene_without_a_flow_has_no_panel_of_mass(rests, tmp_path, monkeypatch):
    cube = shut_bin()
    cube = cube.isel(event=[1]).assign(event_action=("event", np.array(["rest: stop"]))) if rests else cube
    output = drawn("silo_of_spheres", [cube], tmp_path, monkeypatch)
    assert (output.faults(), output.faults_of_look()) == ([], [])
    titles = [panel.get_title() for panel in output.figure.axes]
    assert len(set(titles)) == len(titles) == (2 if rests else 3)
    assert not any("mass" in title for title in titles)
    plt.close("all")


@pytest.mark.parametrize("flows", [False, True])
def test_forces_that_no_surface_feels_have_no_panel(flows, tmp_path, monkeypatch):
    cube = (bin_cube() if flows else shut_bin()).copy(deep=True)
    cube["surface_normal_force_mean"][:] = 0.0
    output = drawn("silo_of_spheres", [cube], tmp_path, monkeypatch)
    assert (output.faults(), output.faults_of_look()) == ([], [])
    titles = [panel.get_title() for panel in output.figure.axes]
    assert [title for title in titles if "spheres" not in title] == (["mass through the outlet"] if flows else [])
    plt.close("all")


def test_the_end_of_the_run_is_on_the_axis_of_time(tmp_path, monkeypatch):
    """Nothing touches a surface in the last windows."""
    cube = bin_cube().copy(deep=True)
    cube["surface_normal_force_mean"][-2:] = 0.0
    output = drawn("silo_of_spheres", [cube], tmp_path, monkeypatch)
    panel = next(panel for panel in output.figure.axes if panel.get_title() == "forces on the surfaces")
    low, high = panel.get_xlim()
    assert low <= float(cube["event_time"].min()) <= float(cube["event_time"].max()) < high
    assert output.faults() == []
    plt.close("all")


def test_the_window_of_an_event_does_not_count_as_after_it():
    """What the floor bore until a moment before, 8 N, is no force of what follows."""
    push = np.array([[9.0, 1.0, 0.0], [8.0, 2.0, 0.0], [4.0, 6.0, 0.0], [4.0, 7.0, 0.0]])
    words = told(scene(np.inf, push, events=[(1.5, "rest: lower"), (4.0, "after: stop")]), flow(times=()))
    assert "on the largest force is 7 N, on \N{LEFT DOUBLE QUOTATION MARK}left" in words


def test_the_axis_of_a_run_that_goes_on_begins_where_it_does(tmp_path, monkeypatch):
    later = 10.0
    cube = bin_cube()
    moved = {name: cube[name].copy(data=cube[name].values + later) for name in cube.variables if str(name).endswith("_time")}
    later_on = cube.assign(moved).assign_attrs(began_s=later)
    output = drawn("silo_of_spheres", [later_on], tmp_path, monkeypatch)
    panel = next(panel for panel in output.figure.axes if panel.get_title() == "forces on the surfaces")
    assert panel.get_xlim()[0] == later
    assert {float(line.get_xdata()[0]) for line in panel.lines if line.get_gid() == AID} == {later}
    plt.close("all")


def test_outlets_are_named_in_a_legend_and_look_like_no_surface(tmp_path, monkeypatch):
    cube = bin_cube()
    share = np.array([0.55, 0.45])
    mass = ("outflow_time", "outlet"), cube["outflow_mass"].values[:, None] * share
    own = {"outlet": ["round", "slot"], "outlet_outflow_mass": mass, "outlet_opened": ("outlet", [0.04, 0.04]),
           "outlet_left": ("outlet", [-0.03, 0.01]), "outlet_right": ("outlet", [-0.01, 0.03])}  # fmt: skip
    output = drawn("silo_of_spheres", [cube.assign(own)], tmp_path, monkeypatch)
    panels = {panel.get_title(): panel for panel in output.figure.axes}
    mass = panels["mass through the outlets"]
    assert [text.get_text() for text in mass.get_legend().get_texts()] == ["round", "slot"]
    assert output.faults() == []
    assert output.faults_of_look() == []
    curves = {line.get_color() for line in mass.lines if line.get_label() in ("round", "slot")}
    assert curves == {"black"}
    plt.close("all")


def test_surfaces_beyond_those_with_a_look_have_one_entry():
    count = SHOWN + 5
    names = [f"bar_{number}" for number in range(count)]
    push = np.tile(np.arange(1.0, count + 1.0), (4, 1))
    cube = scene(OPENED).drop_dims("surface").assign(surface=names, push=(("window_time", "surface"), push))
    figure, panel = plt.subplots()
    lines = draw_forces({"force": panel}, table_of(cube), "force_N", "N", cube)
    assert [line.get_label() for line in lines][-1] == "5 more"
    assert len(lines) == SHOWN + 1
    plt.close(figure)


def test_a_first_window_has_its_level_and_a_last_short_one_is_left_out():
    cube = scene(OPENED).assign_coords(window_time=[1.0, 2.0, 3.0, 3.1])
    assert set(table_of(cube).time_s) == {1.0, 2.0, 3.0}
    assert left_out(cube) == "; the last, of 0.1 s only, is left out"
    assert left_out(scene(OPENED)) == ""
    _, panel = plt.subplots()
    draw_forces({"force": panel}, table_of(cube), "force_N", "N", cube)
    levels = [line.get_xydata().tolist() for line in panel.lines if line.get_gid() == AID]
    assert [[0.0, 9.0], [1.0, 9.0]] in levels
    plt.close("all")


def test_a_run_that_goes_on_in_flow_tells_of_no_rest():
    """An outlet was open before, and another opens: what it began with is not all that there once was."""
    cube = scene(OPENED, outlet=["a", "b"], outlet_opened=("outlet", [0.2, 2.0])).assign_attrs(began_s=0.5, began_with_kg=15.0)
    words = told(cube, flow())
    assert words.startswith("From 0.5 s on 6 of 20 kg leave, 4 kg/s on average; meanwhile the largest force is 9 N, on ")
    assert "rest" not in words
    mass = {"outflow_mass": ("outflow_time", [0.0, 1.0, 3.0]), "grain_mass": ("grain", [20.0]),
            "outlet_outflow_mass": (("outflow_time", "outlet"), [[0.0, 0.0], [1.0, 0.0], [2.0, 1.0]])}  # fmt: skip
    passing = flow_of(cube.assign(mass).assign_coords(outflow_time=[0.5, 1.0, 2.0]), "grain_mass", "mass_kg", "kg")
    assert passing.filled == 15.0
    assert passing.begins == 1.0
    assert passing.told() == "3 of 15 kg leave, 2 kg/s on average"


def test_two_outlets_one_after_the_other_are_told_and_one_off_the_slice_too(tmp_path, monkeypatch):
    cube = bin_cube()
    mass = ("outflow_time", "outlet"), cube["outflow_mass"].values[:, None] * np.array([0.55, 0.45])
    own = {"outlet": ["a", "b"], "outlet_outflow_mass": mass, "outlet_opened": ("outlet", [0.04, 0.05]),
           "outlet_left": ("outlet", [-0.03, np.nan]), "outlet_right": ("outlet", [-0.01, np.nan])}  # fmt: skip
    output = drawn("silo_of_spheres", [cube.assign(own)], tmp_path, monkeypatch)
    assert output.figure.get_suptitle().startswith("Once the first outlet opens ")
    panel = next(panel for panel in output.figure.axes if panel.get_title() == "mass through the outlets")
    assert [text.get_text() for text in panel.get_legend().get_texts()] == ["a", "b, off the slice"]
    assert (output.faults(), output.faults_of_look()) == ([], [])
    plt.close("all")


def test_a_rise_over_what_was_not_at_rest_is_told_over_what_was_before():
    cube = scene(OPENED).assign(event_action=("event", ["time: open_outlet", "rest: stop"]))
    assert told(cube, flow()).endswith("comes to 3 times that before, more than on any other")


def test_lines_of_forces_on_walls_are_not_cut_off(tmp_path, monkeypatch):
    cube = bin_cube().copy(deep=True)
    half = cube.attrs["half_width_m"]
    cube["contact_x"][:], cube["contact_y"][:] = half, 0.0
    cube["contact_force_x"][:], cube["contact_force_y"][:], cube["contact_force_z"][:] = 5.0, 0.0, 0.0
    output = drawn("silo_of_spheres", [cube], tmp_path, monkeypatch)
    reach = 100.0 * (half + 2.0 * float(cube["grain_radius"].mean()))
    assert output.figure.axes[0].get_xlim()[1] > reach
    plt.close("all")
