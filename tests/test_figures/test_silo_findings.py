"""Findings of silos of grains beside codes, of made-up pressures: what the hopper and the wall around say, and the verdicts."""

import numpy as np
import pytest
import xarray as xr

from silostudy.figures.beside import NONE_HERE, row, verdict
from silostudy.figures.findings_of_channel import NOT_RELIEVED, RELIEVED, near_over_far
from silostudy.figures.findings_of_grains import _by_law, _risen_from
from silostudy.figures.silo_findings import findings
from tests.test_figures.small_cubes import cube_of


@pytest.fixture(scope="module")
def table():
    return findings(cube_of("silo-of-spheres", "beside"))


def rows(table, quantity, of=None):
    """Rows of a quantity, or of those whose name begins so."""
    chosen = table[table["quantity"].str.startswith(quantity)]
    return chosen if of is None else chosen[chosen["of"] == of]


def test_the_hopper_stands_beside_every_method_that_knows_one(table):
    """The made-up hopper feels Janssen's pressures and 1 Pa: its switch is where the doubled cell is, in the second level."""
    place = rows(table, "height of the largest rise")
    assert len(place) == 8
    levels = cube_of("silo-of-spheres", "beside").sizes["wall_level"]
    assert place["mean"].to_numpy() == pytest.approx(1.5 / levels)
    cover = rows(table, "hopper pressure at the transition", "en1991_4")
    assert len(cover) == 16
    assert cover["verdict"].isin(["covers it", "does not cover it", "may cover it"]).all()
    assert rows(table, "mean pressure on the hopper", "janssen").empty


def test_a_patch_load_factor_stands_beside_the_largest_cell(table):
    """One cell feels twice its level in flow, and none any more at rest."""
    largest = rows(table, "largest cell over the mean")
    rest = largest[largest["phase"] == "filling"]["mean"].dropna()  # silos too low for deep levels have none
    assert len(rest) == 6
    assert rest.to_numpy() == pytest.approx(0.0, abs=1e-9)
    flow = largest[largest["phase"] == "discharge"]["mean"].dropna()
    assert flow.to_numpy() == pytest.approx(2.0 / (1.0 + 1.0 / 16) - 1.0)


@pytest.mark.parametrize(
    ("ends", "told"),
    [((1.0, 1.2), "covers it"), ((0.9, 1.1), "may cover it"), ((0.7, 0.9), "does not cover it"),
     ((float("nan"), 1.0), "no interval: fewer than two fillings have a value")],
)  # fmt: skip
def test_verdicts_hang_on_the_ends_of_the_interval(ends, told):
    assert verdict(*ends) == told


@pytest.fixture(scope="module")
def eccentric():
    """A cube whose wall feels 200 Pa within 45 degrees of the outlet's side and 400 elsewhere; codes of the made-up solid."""
    cube = cube_of("silo-of-spheres-eccentric", "beside")
    turn = np.abs((cube["wall_turn"] + np.pi) % (2.0 * np.pi) - np.pi)
    felt = xr.where(turn < np.pi / 4, 200.0, 400.0) + 0.0 * cube["pressure_around"]
    return cube.assign(pressure_around=felt.transpose(*cube["pressure_around"].dims))


def test_the_outlet_s_side_stands_beside_the_far_one_and_the_zones_of_a_code(eccentric):
    assert near_over_far(eccentric).values == pytest.approx(0.5)
    table = findings(eccentric)
    zones = table[table["of"] == "en1991_4_eccentric"]
    said = eccentric.isel(silo=-1).sel(pressure_method="en1991_4_eccentric", phase="discharge")
    assert said["code_channel_half_width"].notnull().all()
    for k, size in enumerate(said["channel"].values):
        channel = rows(zones, f"pressure in the channel zone (k_c = {size:.2f})").iloc[0]
        assert channel["mean"] == pytest.approx(float(said["code_channel_pressure"][k]) / 200.0)
        assert channel["verdict"] == (RELIEVED if channel["mean"] < 1.0 else NOT_RELIEVED)
    edge = float(said["code_channel_half_width"][0])
    assert edge < np.pi / 8  # so the narrow channel's adjacent zone lies within the outlet's side too
    beside = rows(zones, "pressure in the adjacent zone (k_c = 0.25)").iloc[0]
    assert beside["mean"] == pytest.approx(float(said["code_adjacent_pressure"][0]) / 200.0)


def test_a_patch_load_counts_on_one_cell_alone(eccentric):
    """Made-up grains feel the same on every area at rest, so what a code gives more on one cell is its patch load."""
    own = eccentric.sel(pressure_method="en1991_4", phase="filling")
    peak, patch = own["code_over_grains_peak"], own["code_patch_factor"]
    assert (patch > 0.05).all()
    assert (peak.sel(averaging="1x1") / peak.sel(averaging="ring")).values == pytest.approx(
        np.tile(1.0 + patch.values[:, None], peak.sizes["filling"])
    )


def test_none_is_not_short(table):
    """A class without patch loads is told as such."""
    none = rows(table, "patch load factor", "en1991_4")
    assert set(none[none["mean"] == 0.0]["verdict"]) <= {NONE_HERE}


def test_a_height_in_levels_is_known_to_half_a_level(table):
    cube = cube_of("silo-of-spheres", "beside").isel(silo=0)
    half = 0.5 * abs(float(cube["level_depth"].isel(filling=0).diff("wall_level").mean()))
    height = rows(table, "height up to which grains do not slide").iloc[0]
    assert height["mean"] == height["low_95"] == 0.0  # made-up grains slide all along, in every filling, and no wall is below
    assert height["high_95"] == pytest.approx(half)
    alone = findings(cube_of("silo-of-spheres", "beside").isel(filling=[0]))
    assert rows(alone, "height up to which grains do not slide")["low_95"].isna().all()  # one filling has no interval


def test_the_hopper_rises_from_where_all_above_it_has_risen():
    """Of two fillings; the lowest level of the first rises as well, but not the one above it."""
    factor = xr.DataArray([[1.2, 0.9, 1.1, 1.5], [0.5, 0.6, 0.7, 0.9]], dims=("filling", "wall_level"))
    place = xr.DataArray([0.875, 0.625, 0.375, 0.125], dims="wall_level")
    height = _risen_from(xr.Dataset({"hopper_switch_factor": factor, "hopper_level_position": place}))
    assert height.values == pytest.approx([0.625, np.nan], nan_ok=True)


@pytest.mark.parametrize(
    ("least", "largest", "told"),
    [(0.9, 1.5, "holds the grains' rate"), (0.5, 0.8, "the grains flow faster"), (1.2, 1.9, "the grains flow slower"),
     (0.99, 1.5, "may hold the grains' rate"), (0.9, 1.01, "may hold the grains' rate")],
)  # fmt: skip
def test_a_rate_lies_beside_both_ends_of_the_law(least, largest, told):
    ends = [row(xr.DataArray(mean + np.array([-0.02, 0.0, 0.02]))) for mean in (least, largest)]
    assert _by_law(*ends) == told
