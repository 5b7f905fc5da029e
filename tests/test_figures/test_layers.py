"""Moving pictures: layers of grains by their height where flow begins, and how many of them run out at once."""

import numpy as np
import pytest
import xarray as xr

from silostudy.figures import layers
from silostudy.figures.bin_motion import frames, leaving, start

HEIGHTS = np.arange(80) + 0.5  # ten grains a layer


def bin_of(order: np.ndarray, *, opens: bool = True) -> xr.Dataset:
    """A bin that fills for two snapshots, opens at 0.2 s, and then loses twenty grains a snapshot in an order."""
    z = np.tile(HEIGHTS, (8, 1))
    z[:2, 40:] = np.nan
    for shot in range(3, 8):
        z[shot, order[: 20 * (shot - 2)]] = np.nan
    events = {"event_time": ("event", [0.2]), "event_action": ("event", ["rest: open_outlet" if opens else "after: stop"])}
    return xr.Dataset(
        {"grain_z": (("snapshot", "grain"), z), "grain_mass": ("grain", np.ones(80)),
         "snapshot_time": ("snapshot", 0.1 * np.arange(8)), **events}
    )  # fmt: skip


def test_a_grain_that_is_not_there_has_no_layer():
    height = np.append(HEIGHTS, np.nan)
    assert np.bincount(layers.numbers(height)[:-1]).tolist() == [10] * layers.COUNT
    assert layers.numbers(height)[-1] == -1


def test_the_film_begins_filled_and_ends_with_the_last_grain():
    cube = bin_of(np.arange(80))
    assert start(cube) == 2
    assert frames(cube, start(cube)).tolist() == [2, 3, 4, 5]


def test_a_bin_that_stays_shut_is_shown_from_the_start():
    cube = bin_of(np.arange(80)[:0], opens=False)
    assert start(cube) == 7
    assert frames(cube, start(cube)).tolist() == list(range(8))


@pytest.mark.parametrize(
    ("order", "count"),
    [(np.arange(80), 0), (np.argsort(np.arange(80) % 10, kind="stable"), 8)],
    ids=["layer after layer", "a tenth of every layer at a time"],
)
def test_layers_that_run_out_at_once_are_counted(order, count):
    cube = bin_of(order)
    assert leaving(cube, start(cube)) == (0.5, count)
