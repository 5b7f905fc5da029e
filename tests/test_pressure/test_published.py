"""Every method reproduces its published values, and every row brings the proof that it may be shipped."""

import inspect
from pathlib import Path

import pytest

from silostudy.pressure import PRESSURE
from silostudy.pressure.family import HOPPER_QUANTITIES, PARAMETERS, PHASES, PLANS, QUANTITIES, TOTALS
from silostudy.tables.handbook import TONNE_PER_M2
from silostudy.tables.read import rows
from silostudy.tables.references import cite

PUBLISHED = Path(__file__).parents[1] / "published/pressure"
ROUNDING = 0.001  # the print has three decimals, rounded or truncated: 0.1 % of the smallest value
UNPUBLISHED = dict.fromkeys(  # method -> what its row must tell the user
    [
        "reimbert", "jenike_1969", "jenike_funnel_1973", "pieper_flour", "pieper_flour_small", "pieper_flour_buckling",
        "en1991_4", "en1991_4_mean", "en1991_4_wall_normal", "en1991_4_wall_friction", "en1991_4_vertical_load",
        "en1991_4_eccentric", "as3774_1996",
    ],
    "no published numbers",
)  # fmt: skip


def published(method: str) -> list[dict]:
    return rows(PUBLISHED / f"{method}.csv", text=("reading", "phase"))


@pytest.mark.parametrize("method", sorted(set(PRESSURE) - set(UNPUBLISHED)))
def test_published_values(wheat, method):
    points = published(method)
    assert len(points) >= 13
    for point in points:
        label = method + ("_as_printed" if point["reading"] == "as_printed" else "")
        here = {"pressure_method": label, "phase": point["phase"], "depth": point["depth"]}
        computed = float(wheat["wall_normal_pressure"].sel(here))
        assert computed == pytest.approx(point["wall_normal_pressure"], rel=ROUNDING, abs=0), point["where"]


def test_jenike_as_printed_is_within_two_in_ten_thousand(wheat):
    for point in published("jenike_mass_flow"):
        here = {"pressure_method": "jenike_mass_flow_as_printed", "phase": "discharge", "depth": point["depth"]}
        assert float(wheat["wall_normal_pressure"].sel(here)) == pytest.approx(point["wall_normal_pressure"], rel=2e-4, abs=0)


def test_jenike_corrected_peaks_at_4_357(wheat):
    column = wheat["wall_normal_pressure"].sel(pressure_method="jenike_mass_flow", phase="discharge") / TONNE_PER_M2
    recomputed = {3.5: 2.563, 5.5: 3.272, 12.5: 4.357, 18.0: 3.172}  # independently recomputed with R = D/4
    for depth, value in recomputed.items():
        assert float(column.sel(depth=depth)) == pytest.approx(value, abs=5e-4)


def test_caquot_misprint_is_the_only_value_off(wheat):
    here = {"pressure_method": "caquot", "phase": "discharge", "depth": 3.5}
    assert float(wheat["wall_normal_pressure"].sel(here)) / TONNE_PER_M2 == pytest.approx(2.353, rel=ROUNDING, abs=0)


@pytest.mark.parametrize("row", PRESSURE.values(), ids=list(PRESSURE))
def test_row_is_complete(row):
    assert cite(row.source)
    assert row.needs <= set(PARAMETERS)
    assert set(row.phases) <= set(PHASES)
    assert row.plans <= set(PLANS)
    assert row.colour.startswith("#")
    assert row.key in UNPUBLISHED or (PUBLISHED / f"{row.key}.csv").is_file()
    assert UNPUBLISHED.get(row.key, "") in row.validity
    for quantities in (*row.hopper.values(), *row.totals.values()):
        assert set(quantities) <= {*HOPPER_QUANTITIES, *TOTALS}
        for name, function in quantities.items():
            unit = TOTALS.get(name, "N" if name == "switch_force" else "Pa").replace(" m-", "/m")
            assert f"({unit})" in inspect.getdoc(function).replace("N m-3", "N/m3")
            assert "Source: " in inspect.getdoc(function)
    for quantities in row.phases.values():
        assert set(quantities) <= set(QUANTITIES)
        assert "wall_normal_pressure" in quantities
        for function in quantities.values():
            assert "(Pa)" in inspect.getdoc(function) or "(N/m" in inspect.getdoc(function)


def test_rows_can_be_told_apart_without_colour():
    assert len({row.marker for row in PRESSURE.values()}) == len(PRESSURE)
    assert len({row.colour for row in PRESSURE.values()}) == len(PRESSURE)
