"""The switch over height and time: a relief that runs up at a known speed, and a largest pressure at known times."""

import numpy as np
import pandas as pd
import pytest
import xarray as xr

from silostudy.figures import switch_in_time
from tests.test_figures.made_scenes import walls_cube

STEP = 1e-3  # s: a window
SPEED = 20.0  # m/s
REST = 500.0  # Pa


@pytest.fixture
def cube():
    """Levels of 8 mm, windows of 1 ms, fillings that are alike.

    Each level falls to a half when a relief from the outlet arrives; the upper half rises to the double for a window at 30 ms,
    a window later with each level up.
    """
    whole = walls_cube("silo-of-spheres").isel(silo=[0])
    levels, turns = whole.sizes["wall_level"], whole.sizes["wall_turn"]
    height = 0.008 * (np.arange(levels) + 0.5)
    middle = STEP * (np.arange(60) + 0.5)
    flow = np.where(middle[:, None] > height / SPEED, 0.5, 1.0)
    upper = np.arange(levels // 2, levels)
    flow[30 + upper - upper[0], upper] = 2.0
    kept = ["silo", "silo_title", "filling", "wall_level", "wall_turn"]
    cube = xr.Dataset(coords={name: whole[name] for name in kept if name in whole}, attrs=whole.attrs)
    fillings = (1, whole.sizes["filling"])
    dims = ("silo", "filling")

    def all_alike(values):
        return np.broadcast_to(values, (*fillings, *values.shape))

    around = np.ones(turns)
    return cube.assign(
        hopper_pressure_in_flow=((*dims, "flow_window", "wall_level", "wall_turn"), all_alike(REST * flow[..., None] * around)),
        hopper_pressure_at_rest=((*dims, "wall_level", "wall_turn"), all_alike(np.full((levels, turns), REST))),
        hopper_level_height=((*dims, "wall_level"), all_alike(height)),
        flow_window_end=((*dims, "flow_window"), all_alike(middle + STEP / 2)),
    )


def test_the_speed_of_the_relief_and_the_times_of_the_largest_come_back(cube, tmp_path, kept):
    switch_in_time.draw(cube, tmp_path / "switch")
    table = pd.read_csv(tmp_path / "switch.csv").set_index("what")
    levels = cube.sizes["wall_level"]
    assert table.loc[switch_in_time.SPEED, "value"] == pytest.approx(SPEED, rel=0.15)  # windows of 1 ms
    assert table.loc[switch_in_time.TOP, "value"] == pytest.approx(30.5 + levels / 2 - 1)
    assert table.loc[switch_in_time.LATER, "value"] == pytest.approx(levels / 2 - 1)
    assert len(table.loc[["largest"]]) == levels / 2
    headline = " ".join(kept[0].get_suptitle().split())
    assert headline.startswith("Opening relieves the hopper from below at ")
    assert headline.endswith(f"its top feels most {30.5 + levels / 2 - 1:.2g} ms after it")


def test_a_hopper_that_never_feels_less_or_more_is_told_so(cube, tmp_path, kept):
    calm = cube.assign(hopper_pressure_in_flow=cube["hopper_pressure_in_flow"] * 0.0 + REST)
    switch_in_time.draw(calm, tmp_path / "switch")
    assert kept[0].get_suptitle() == "No relief is told; nowhere it feels more than at rest"
    assert set(pd.read_csv(tmp_path / "switch.csv").dropna(subset=["time_ms"])["what"]) == {"map"}
