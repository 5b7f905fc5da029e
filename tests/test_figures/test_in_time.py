"""A scene in time: what leaves and which surface is pushed most, from made-up numbers whose answer is known."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.errors import BadInput
from silostudy.figures import silo_of_spheres
from silostudy.figures.in_time import Flow, forces, message, pushed
from tests.test_figures.small_cubes import bin_cube

TIME = np.array([1.0, 2.0, 3.0, 4.0])
OPENED = 2.0
PUSH = np.array([[9.0, 1.0, 0.1], [8.0, 2.0, 0.1], [4.0, 6.0, 9.0], [4.0, 5.0, 1.0]])  # floor, left, a bolt of no weight


def scene(opened):
    """Events of a scene that opens at a time (s), or never."""
    actions = ["rest: open"] if np.isfinite(opened) else ["after: stop"]
    return xr.Dataset({"event_time": ("event", [min(opened, 5.0)]), "event_action": ("event", actions)})


def flow(times=(2.5, 3.0, 3.5)):
    rows = {"time_s": np.array(times), "outlet": "outlet", "mass_kg": 2.0 * np.arange(1, len(times) + 1)}
    return Flow(pd.DataFrame(rows), "mass_kg", 20.0, "kg")


def test_the_surface_that_rises_most_carries_something_at_rest():
    table = forces(TIME, PUSH, ["floor", "left", "bolt"], "force_N")
    assert pushed(table, "force_N", OPENED) == ("left", 3.0)
    assert pushed(table[table.time_s <= OPENED], "force_N", np.inf)[0] == "floor"
    assert set(forces(TIME, PUSH * [1, 0, 1], ["floor", "left", "bolt"], "force_N").surface) == {"floor", "bolt"}


def test_what_leaves_is_told_with_its_rate():
    table = forces(TIME, PUSH, ["floor", "left", "bolt"], "force_N")
    told = message(scene(OPENED), table, "force_N", flow())
    assert told.startswith("Once the outlet opens 6 of 20 kg leave, 4 kg/s on average; the force on ")
    assert "left" in told
    assert "3 times that at rest" in told
    assert "nothing leaves" in message(scene(OPENED), table, "force_N", flow(times=()))
    assert message(scene(np.inf), table, "force_N", flow(times=())).startswith("At rest the largest force is that on")


def test_mass_of_outlets_adds_up():
    rows = {"time_s": [2.0, 2.0, 3.0, 3.0], "outlet": ["a", "b"] * 2, "mass_kg": [1.0, 0.0, 1.0, 4.0]}
    assert Flow(pd.DataFrame(rows), "mass_kg", 10.0, "kg").told() == "5 of 10 kg leave, 4 kg/s on average"


def test_a_scene_that_recorded_nothing_is_told_what_to_record(tmp_path):
    with pytest.raises(BadInput, match=r"record\.wall_force_window_s = 'nothing': must be given"):
        silo_of_spheres.draw(bin_cube().drop_vars("surface_normal_force"), tmp_path / "silo")
