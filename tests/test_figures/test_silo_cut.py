"""The silo as figures cut it: what stands when, of discs and of spheres, and where a lid is."""

import numpy as np
import pytest
import xarray as xr

from silostudy.figures.silo_cut import outlet_words, reaching, standing, view


def happened(*events):
    times, actions = zip(*events, strict=True)
    return {"event_time": ("event", list(times)), "event_action": ("event", list(actions))}


def discs(walls, events=((0.0, "rest: stop"),), **more):
    """A silo of discs whose walls are lines of three cells: a start, a middle and an end."""
    x, y = np.concatenate([np.linspace(start, end, 3) for start, end in walls.values()]).T
    cells = {"wall_name": np.repeat(list(walls), 3), "wall_cell_x": x, "wall_cell_y": y}
    return xr.Dataset({"disc": [0]} | {name: ("wall_cell", of) for name, of in cells.items()} | happened(*events) | more)


def spheres(events=((0.0, "rest: stop"),), plug=0.0, **more):
    """A round silo of spheres with a flat floor, or a plug so wide (m, half)."""
    sizes = {"half_width_m": 0.2, "outlet_half_width_m": plug, "outlet_middle_m": 0.0}
    return xr.Dataset(happened(*events) | more, attrs=sizes | {"transition_height_m": 0.0, "top_height_m": 0.5})


def lines(cube, time):
    """Ends (cm) of the straight pieces that stand at a time, smaller end first."""
    pieces = [piece for line in standing(cube, time) for piece in zip(line[:-1].tolist(), line[1:].tolist(), strict=True)]
    return {tuple(tuple(round(number, 6) + 0.0 for number in end) for end in sorted(piece)) for piece in pieces}


SIDES = {"left": ((0.0, 0.4), (0.0, 0.0)), "right": ((0.2, 0.0), (0.2, 0.4))}
OPEN = ((1.0, "rest: open_outlet"), (2.0, "after: stop"))


def test_walls_floor_and_inserts_of_discs_stand():
    hat = {"hat": ((0.05, 0.1), (0.1, 0.15))}
    cube = discs({"floor": ((0.0, 0.0), (0.2, 0.0))} | SIDES | hat)
    assert lines(cube, 5.0) == {((0, 0), (20, 0)), ((0, 0), (0, 40)), ((20, 0), (20, 40)), ((5, 10), (10, 15))}


def test_a_floor_of_discs_goes_when_it_opens_and_its_halves_stay():
    halves = {"floor_left": ((0.0, 0.0), (0.08, 0.0)), "floor_right": ((0.12, 0.0), (0.2, 0.0))}
    cube = discs({"floor": ((0.0, 0.0), (0.2, 0.0))} | halves | SIDES, OPEN)
    assert ((0, 0), (20, 0)) in lines(cube, 0.9)
    after = lines(cube, 1.1)
    assert ((0, 0), (20, 0)) not in after
    assert {((0, 0), (8, 0)), ((12, 0), (20, 0))} <= after


@pytest.mark.parametrize("of", ["discs", "spheres"])
def test_an_outlet_is_a_gap_once_it_is_open(of):
    edges = ([0.02, 0.12], [0.06, 0.16])
    outlets = {"outlet": ["a", "b"], "outlet_left": ("outlet", edges[0]), "outlet_right": ("outlet", edges[1]),
               "outlet_opened": ("outlet", [1.0, np.nan])}  # fmt: skip
    floor = {"floor_1": ((0, 0), (0.02, 0)), "floor_2": ((0.06, 0), (0.12, 0)), "floor_3": ((0.16, 0), (0.2, 0))}
    cube = discs(floor | SIDES, OPEN, **outlets) if of == "discs" else spheres(OPEN, **outlets)
    shut = {((2, 0), (6, 0)), ((12, 0), (16, 0))}
    assert shut <= lines(cube, 0.9)
    assert shut & lines(cube, 1.1) == {((12, 0), (16, 0))}
    assert ((6, 0), (12, 0)) in lines(cube, 1.1)


def test_an_outlet_that_opened_before_the_run_began_is_a_gap_from_the_start():
    """A run that goes on from the end of another, 5 s after it."""
    unnamed = spheres(((5.3, "after: set_friction"),), plug=0.05).assign_attrs(
        outlet_opened_s=1.0, outlet_whole_s=1.0, began_s=5.0
    )
    assert ((-5, 0), (5, 0)) not in lines(unnamed, 5.0)
    named = {"outlet": ["a", "b"], "outlet_left": ("outlet", [-0.1, 0.1]), "outlet_right": ("outlet", [-0.05, 0.15]),
             "outlet_opened": ("outlet", [1.0, np.nan])}  # fmt: skip
    found = lines(spheres(((5.3, "after: set_friction"),), **named), 5.0)
    assert ((-10, 0), (-5, 0)) not in found
    assert ((10, 0), (15, 0)) in found


def test_the_plug_of_a_hopper_goes_and_its_sides_stay():
    cube = spheres(OPEN, plug=0.05)
    assert ((-5, 0), (5, 0)) in lines(cube, 1.0)
    assert lines(cube, 1.1) == lines(cube, 1.0) - {((-5, 0), (5, 0))}


def test_an_insert_that_is_taken_away_is_gone():
    cuts = {"insert_name": ["plate"] * 3 + ["gate_1"] * 3, "insert_x": [0.0, 0.1, np.nan] * 2}
    cuts |= {"insert_z": [0.1, 0.1, np.nan, 0.2, 0.2, np.nan]}
    inserts = {name: ("insert_point", values) for name, values in cuts.items()}
    cube = spheres(((1.0, "rest: take_away gate_1, gate_2"), (2.0, "after: set_friction")), **inserts)
    both = {((0, 10), (10, 10)), ((0, 20), (10, 20))}
    assert both <= lines(cube, 0.5)
    assert both & lines(cube, 3.0) == {((0, 10), (10, 10))}
    assert ((20, 0), (20, 50)) in lines(cube, 3.0)


@pytest.mark.parametrize("moves", [True, False])
def test_the_lid_stands_where_windows_saw_it(moves):
    cube = discs(SIDES | {"lid": ((0.2, 0.4), (0.0, 0.4))})
    cube = cube.assign(window_time=[1.0, 2.0], lid_height=("window_time", [0.4, 0.2])) if moves else cube
    assert ((0, 40), (20, 40)) in lines(cube, 0.5)
    height = 30.0 if moves else 40.0
    assert ((0, height), (20, height)) in lines(cube, 1.5)
    assert len(lines(cube, 1.5)) == 3


def test_a_silo_that_is_little_filled_is_cut_off_above():
    cube = discs({"floor": ((0.0, 0.0), (0.2, 0.0))} | SIDES)
    left, right, low, high = view(cube, 0.05)
    assert (left, right) == pytest.approx((-1.0, 21.0))
    assert low < 0.0
    assert 20.0 <= high < 22.0
    assert view(cube, 0.39)[3] >= 40.0


def test_what_stands_in_the_silo_or_beside_it_is_not_cut_off():
    cuts = {"insert_name": ["hat"] * 3, "insert_x": [0.0, 0.1, np.nan], "insert_z": [0.45, 0.42, np.nan]}
    cube = spheres(**{name: ("insert_point", values) for name, values in cuts.items()})
    assert view(cube, 0.05)[3] >= 45.0
    base = {"base": ((-0.3, -0.2), (0.6, -0.2)), "shelf": ((0.05, 0.35), (0.1, 0.35))}
    left, right, low, high = view(discs({"floor": ((0.0, 0.0), (0.2, 0.0))} | SIDES | base), 0.05)
    assert left < -30.0
    assert right > 60.0
    assert low < -20.0
    assert high >= 35.0


def test_words_on_an_outlet_say_when_it_opens_and_whether_there_is_one():
    cube = spheres(OPEN, plug=0.1).assign_attrs(outlet_whole_s=2.0)
    assert [outlet_words(cube, time) for time in (0.5, 1.5, 2.5)] == ["outlet shut", "outlet opening", "outlet open"]
    assert outlet_words(spheres(OPEN, plug=0.1), 1.1) == "outlet open"
    assert outlet_words(spheres(), 1.0) == ""


def test_several_outlets_are_counted_those_off_the_slice_too():
    own = {"outlet": ["a", "b"], "outlet_left": ("outlet", [-0.1, np.nan]), "outlet_right": ("outlet", [0.1, np.nan]),
           "outlet_opened": ("outlet", [1.0, 2.0]), "outlet_whole": ("outlet", [1.0, 3.0])}  # fmt: skip
    said = [outlet_words(spheres(OPEN, **own), time) for time in (0.5, 1.5, 2.5, 3.5)]
    assert said == ["0 of 2 outlets open", "1 of 2 outlets open", "1 of 2 outlets open, 1 opening", "2 of 2 outlets open"]


def test_a_view_holds_lines_that_it_shows_half_of():
    lines = np.array([[9.0, 1.0, 10.5, 1.0], [20.0, 1.0, 30.0, 1.0], [5.0, 0.5, 5.0, -2.0]])
    left, right, low, high = reaching((0.0, 10.0, -1.0, 10.0), lines)
    assert (left, high) == (0.0, 10.0)
    assert 10.5 < right < 11.0
    assert -2.5 < low < -2.0
    assert reaching((0.0, 10.0, -1.0, 10.0), np.empty((0, 4))) == (0.0, 10.0, -1.0, 10.0)


@pytest.mark.parametrize("named", [True, False])
def test_the_gap_of_an_outlet_that_opens_at_a_speed_grows(named):
    outlets = {"outlet": ["a"], "outlet_left": ("outlet", [-0.1]), "outlet_right": ("outlet", [0.1]),
               "outlet_opened": ("outlet", [1.0]), "outlet_whole": ("outlet", [2.0])}  # fmt: skip
    cube = spheres(OPEN, **outlets) if named else spheres(OPEN, plug=0.1).assign_attrs(outlet_whole_s=2.0)
    assert ((-10, 0), (10, 0)) in lines(cube, 1.0)
    assert {((-10, 0), (-5, 0)), ((5, 0), (10, 0))} <= lines(cube, 1.5)
    assert not {((-10, 0), (10, 0)), ((-10, 0), (-5, 0))} & lines(cube, 2.1)
