"""What figures make of a bin of spheres: phases, means over the angle, and Janssen's curve of the column as it stands."""

from dataclasses import replace

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import xarray as xr
from matplotlib.collections import QuadMesh
from matplotlib.text import Text

from silostudy.cube.contents import levelled
from silostudy.figures import bin_pressures
from silostudy.figures.bin import Column, before, column, doubt, in_discharge, janssen, opened_at, opening, phases, profile
from silostudy.figures.style import AID
from silostudy.pressure.janssen import normal_pressure
from tests.test_figures.small_cubes import bin_cube
from tests.test_figures.test_content import drawn as figure_of

COLUMN = Column(surface=1.0, unit_weight=8e3, wall_friction=0.3, lateral_pressure_ratio=0.5)


def test_phases_lie_before_and_after_the_opening():
    cube = bin_cube()
    assert opened_at(cube) == 0.04
    cells, walls = phases(cube), cube["wall_name"].isin(["wall", "hopper"]).values
    mean, most = (cube[f"wall_pressure_{what}"].values[:, walls] for what in ("mean", "max"))
    assert np.array_equal(cells["pressure_rest_Pa"], mean[1])
    assert np.allclose(cells["pressure_discharge_Pa"], mean[2:].mean(axis=0))
    assert np.array_equal(cells["peak_discharge_Pa"], most[2:].max(axis=0))


def test_discharge_ends_when_a_quarter_is_out():
    """Of ten grains of 1 kg three are out at 0.25 s: the readings from then on show a bin that empties."""
    cube = xr.Dataset(
        {"event_time": ("event", [0.1]), "event_action": ("event", ["rest: open_outlet"]), "grain_mass": ("grain", np.ones(10)),
         "outflow_time": ("out", [0.15, 0.2, 0.25, 0.3]), "outflow_mass": ("out", [1.0, 2.0, 3.0, 4.0])}
    )  # fmt: skip
    time = np.array([0.1, 0.2, 0.25, 0.3])
    assert in_discharge(cube, time > 0.1, time).tolist() == [1, 2]
    assert in_discharge(cube, time > 0.25, time).tolist() == [3]
    assert in_discharge(cube, time > 0.3, time).tolist() == []
    assert in_discharge(cube.drop_vars("outflow_mass"), time > 0.1, time).tolist() == [1, 2, 3]


def test_means_over_the_angle_are_weighted_by_area():
    cells = pd.DataFrame({"surface": ["wall_1", "wall_2", "hopper"], "height_m": [0.5, 0.5, 0.1], "area_m2": [1.0, 3.0, 1.0],
                          "pressure_rest_Pa": [2.0, 6.0, 1.0]})  # fmt: skip
    found = profile(cells).set_index("surface")["pressure_rest_Pa"]
    assert found.to_dict() == {"wall": 5.0, "hopper": 1.0}


def test_janssen_is_the_package_s_own():
    depth = np.linspace(0.0, 3.0, 7)
    own = normal_pressure(depth, unit_weight=8e3, hydraulic_radius=0.25, wall_friction=0.3, lateral_pressure_ratio=0.5)
    assert janssen(depth, COLUMN, 0.25) == pytest.approx(own)
    smooth = Column(1.0, 8e3, 0.0, 0.5)
    assert janssen(depth, smooth, 0.25) == pytest.approx(4e3 * depth)


def test_a_column_after_janssen_is_found_again():
    """Wall pressures and shears by Janssen's curve, spheres evenly spread: unit weight, friction and K come back."""
    heights, radius, area = (np.arange(50) + 0.5) / 50, 0.25, np.pi * 0.25
    pressure = janssen(1.0 - heights, COLUMN, radius)
    count = 100_000
    cube = xr.Dataset(
        {"snapshot_time": ("snapshot", [0.0]), "event_time": ("event", [1.0]), "event_action": ("event", ["rest: open_outlet"]),
         "grain_z": (("snapshot", "grain"), (np.arange(count) + 0.5)[None] / count),
         "grain_mass": ("grain", np.full(count, 8e3 * area / 9.81 / count))},
        attrs={"transition_height_m": 0.0, "plan_area_m2": area, "hydraulic_radius_m": radius, "gravity_z_m_s2": -9.81},
    )  # fmt: skip
    cells = pd.DataFrame({"surface": "wall", "height_m": heights, "area_m2": 1.0, "pressure_rest_Pa": pressure,
                          "shear_rest_Pa": 0.3 * pressure})  # fmt: skip
    found = column(cube, cells)
    assert found is not None
    assert (found.surface, found.unit_weight) == pytest.approx((1.0, 8e3), rel=1e-3)
    assert (found.wall_friction, found.lateral_pressure_ratio) == pytest.approx((0.3, 0.5), rel=0.02)


@pytest.mark.parametrize(
    ("changes", "why"),
    [
        ({}, ""),
        ({"wall_friction": 0.0}, ""),
        ({"surface": 0.408}, "stands 0.008 m deep against the upright walls, less than half a diameter, 0.5 m"),
        ({"wall_friction": -0.03}, "walls press the solid down, with a friction of -0.03"),
        ({"lateral_pressure_ratio": -0.2}, "K at the end comes out as -0.2"),
    ],
)
def test_a_column_that_janssen_says_nothing_of_is_doubted(changes, why):
    heights = np.append(np.linspace(0.41, 2.0, 20), 0.405)
    cells = pd.DataFrame({"surface": "wall", "height_m": heights})
    cube = xr.Dataset(
        {"event_time": ("event", []), "event_action": ("event", [])},
        attrs={"transition_height_m": 0.4, "hydraulic_radius_m": 0.25},
    )
    found = doubt(replace(COLUMN, **changes), cube, cells)
    assert why in found
    assert bool(found) == bool(why)


def test_a_single_layer_has_no_level_surface():
    assert np.isnan(levelled(np.full(5, 0.108), np.ones(5), 0.1, 1.0)).all()


def test_one_level_of_wall_cells_bears_no_curve():
    cube = xr.Dataset(
        {"event_time": ("event", []), "event_action": ("event", [])},
        attrs={"transition_height_m": 0.0, "hydraulic_radius_m": 0.25},
    )
    cells = pd.DataFrame({"surface": "wall", "height_m": [0.7, 2.1]})
    assert "1 of at least 2 levels of wall cells" in doubt(COLUMN, cube, cells)


@pytest.mark.parametrize(("sign", "drawn"), [(1.0, True), (-1.0, False)])
def test_a_doubted_curve_is_neither_drawn_nor_told(sign, drawn, tmp_path, monkeypatch):
    cube, said = bin_cube(), []
    cube["wall_shear_stress_mean"] = sign * cube["wall_shear_stress_mean"]
    monkeypatch.setattr(bin_pressures, "foot", lambda figure, *remarks, handles: said.extend([*remarks, handles]))
    bin_pressures.draw(cube, tmp_path / "bin")
    _, left_out, handles = said
    assert any("Janssen" in line.get_label() for line in handles) == drawn
    assert left_out.startswith("Janssen's curve is left out: at rest the walls press") != drawn
    assert ("janssen" in set(pd.read_csv(tmp_path / "bin.csv", comment="#")["kind"])) == drawn


def test_pressures_are_drawn_whole_up_to_the_level_over_the_highest_pressed_one(tmp_path, monkeypatch):
    cube = bin_cube().copy(deep=True)
    heights = np.unique(cube["wall_cell_z"].values.round(9))
    for name in ("wall_pressure_mean", "wall_pressure_max"):
        cube[name][:, cube["wall_cell_z"].values.round(9) >= heights[-3]] = 0.0
    output = figure_of("bin_pressures", [cube], tmp_path, monkeypatch)
    high = output.figure.axes[0].get_ylim()[1]
    assert heights[-3] < high < heights[-2]
    meshes = [mesh for panel in output.figure.axes[:2] for mesh in panel.findobj(QuadMesh)]
    assert max(mesh.get_coordinates()[..., 1].max() for mesh in meshes) == pytest.approx(high)
    curves = [line.get_ydata() for line in output.figure.axes[2].lines if line.get_gid() != AID]
    assert max(np.max(curve) for curve in curves) <= high
    plt.close("all")


def test_cells_of_a_hopper_that_narrows_go_round_wall_by_wall():
    """Four walls of four cells; the outer two are no part of a wall that has narrowed, and would lie beyond its corners."""
    off = np.array([-60.0, -20.0, 20.0, 60.0])
    angles = (np.add.outer([0.0, 90.0, 180.0, 270.0], off) % 360.0).ravel()
    walls = {"surface": np.repeat([f"hopper_{k}" for k in range(1, 5)], 4), "area_m2": np.tile([np.nan, 1, 1, np.nan], 4)}
    row = pd.DataFrame(walls | {"angle_deg": angles, "number": np.arange(16)})
    edges, cells = bin_pressures.around(row)
    assert cells["area_m2"].notna().all()
    inside = [
        (number, low, high) for number, low, high in zip(cells["number"], edges[:-1], edges[1:], strict=True) if 0 <= low < 360
    ]
    assert [number for number, *_ in inside] == [2, 5, 6, 9, 10, 13, 14, 1]
    assert [low for _, low, _ in inside] == pytest.approx(np.arange(0.0, 360.0, 45.0))
    assert edges[0] <= 0.0
    assert edges[-1] >= 360.0


@pytest.mark.parametrize("count", [1, 6])
def test_cells_around_a_round_wall_are_equal(count):
    angle = (np.arange(count) + 0.5) * 360.0 / count
    edges, cells = bin_pressures.around(pd.DataFrame({"surface": "wall", "area_m2": 1.0, "angle_deg": angle}))
    assert np.diff(edges) == pytest.approx(360.0 / count)
    assert np.unique(edges % (360.0 / count)) == pytest.approx(0.0)
    assert len(cells) == len(edges) - 1


def turning(cube):
    spin = np.ones((cube.sizes["window_time"], cube.sizes["surface"]))
    return cube.assign(surface_spin=(("window_time", "surface"), spin))


def flowless(cube):
    """The bin whose outlet stays shut, so that nothing leaves it."""
    shut = cube.drop_vars([name for name in cube.variables if "outflow" in str(name)])
    return shut.assign(event_action=("event", ["rest: set_friction", "after: stop"]))


def flowing(cube):
    """A run that goes on from another in flow: nothing opens the outlet any more."""
    friction = cube.assign(event_action=("event", ["after: set_friction"] * cube.sizes["event"]))
    return friction.assign_attrs(outlet_opened_s=0.005, began_s=0.01)


@pytest.mark.parametrize(("changed", "told"), [(turning, "while surfaces turn"), (flowing, "while grains flow")])
def test_what_turns_or_flows_is_not_said_to_rest(changed, told, tmp_path, monkeypatch):
    output = figure_of("bin_pressures", [changed(bin_cube())], tmp_path, monkeypatch)
    titles = [panel.get_title() for panel in output.figure.axes]
    assert told in titles
    assert "at rest" not in titles
    assert not any("at rest" in text.get_text() for text in output.figure.findobj(Text))


def outlets(*opened):
    return {"outlet": list("abc"[: len(opened)]), "outlet_opened": ("outlet", list(opened))}


@pytest.mark.parametrize(
    ("own", "told"),
    [
        ({}, "the outlet opens"),
        (outlets(1.0), "the outlet opens"),
        (outlets(1.0, 2.0), "the first outlet opens"),
        (outlets(1.0, np.nan), "an outlet opens"),
        (outlets(1.0, 1.0), "the outlets open"),
    ],
)
def test_only_what_was_waited_for_is_said_to_rest(own, told):
    """A scene with times alone says the moment."""
    timed = xr.Dataset({"event_time": ("event", [1.0]), "event_action": ("event", ["time: open_outlet"])} | own)
    assert opening(timed) == told
    assert before(timed) == f"before {told}"
    assert before(timed.assign(event_action=("event", ["time: stop"]))) == "at the end"
    assert before(timed.assign(event_action=("event", ["rest: open_outlet"]))) == "at rest"
    assert before(timed.assign(event_action=("event", ["rest: open_outlet"]), event_time=("event", [2.0]))) == "at rest"
    lifted = ("event", ["rest: lower_lid", "after: move_lid", "after: stop"])
    assert before(xr.Dataset({"event_time": ("event", [0.5, 0.8, 1.0]), "event_action": lifted})) == "at the end"


def test_what_has_open_in_its_name_opens_no_outlet():
    cube = xr.Dataset(
        {"event_time": ("event", [0.5, 1.0]), "event_action": ("event", ["rest: take_away opener", "after: stop"])}
    )
    assert opened_at(cube) == np.inf
    assert opened_at(cube.assign(event_action=("event", ["rest: take_away opener", "after: open_slit left"]))) == 1.0


def timed(cube):
    """The bin whose outlet opens at a time, whether its solid rests or not."""
    return cube.assign(event_action=("event", [str(what.values).replace("rest:", "time:") for what in cube["event_action"]]))


@pytest.mark.parametrize("name", ["bin_pressures", "bin_fields"])
def test_figures_of_a_timed_scene_say_no_rest(name, tmp_path, monkeypatch):
    output = figure_of(name, [timed(bin_cube())], tmp_path, monkeypatch)
    said = " ".join(text.get_text() for text in output.figure.findobj(Text)).replace("\n", " ")
    assert "before the outlet opens" in said
    assert "at rest" not in said
    assert (output.faults(), output.faults_of_look()) == ([], [])
    plt.close("all")


def test_the_headline_s_peak_is_that_of_a_curve(tmp_path, monkeypatch):
    output = figure_of("bin_pressures", [bin_cube()], tmp_path, monkeypatch)
    curves = {line.get_label(): np.max(line.get_xdata()) for line in output.figure.axes[2].lines if line.get_gid() != AID}
    over = curves["in discharge, mean of the cells' peaks"] / curves["at rest"]
    assert output.figure.get_suptitle().replace("\n", " ").endswith(f"the mean of the cells' peaks {over:.2g} times")
    plt.close("all")


def test_numbers_under_neighbouring_panels_stand_apart(tmp_path, monkeypatch):
    output = figure_of("bin_pressures", [bin_cube()], tmp_path, monkeypatch)
    output.figure.draw_without_rendering()
    maps, curves = output.figure.axes[1:3]
    last, first = maps.get_xticklabels()[-1].get_window_extent(), curves.get_xticklabels()[0].get_window_extent()
    assert first.x0 - last.x1 > 0.6 * last.width
    plt.close("all")


def test_fields_without_a_discharge_are_not_said_to_be_in_one(tmp_path, monkeypatch):
    output = figure_of("bin_fields", [turning(flowless(bin_cube()))], tmp_path, monkeypatch)
    assert {panel.get_title() for panel in output.figure.axes} == {"while surfaces turn", ""}
    assert not any("discharge" in text.get_text() for text in output.figure.findobj(Text))
    plt.close("all")
