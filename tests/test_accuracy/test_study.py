"""The accuracy study from configuration to cube to figures, on problems that take no time."""

import numpy as np
import pandas as pd
import pytest

from silostudy.accuracy import cube as accuracy
from silostudy.accuracy import optional_parts
from silostudy.accuracy import price_table as prices
from silostudy.accuracy.cube import accuracy_cube, points_of
from silostudy.accuracy.front import lasting_error
from silostudy.accuracy.measure import Rung
from silostudy.accuracy.silo import silo_of_rows
from silostudy.cube.io import read, write
from silostudy.errors import BadInput
from silostudy.figures import (
    accuracy_earthquake,
    accuracy_formulas,
    accuracy_summary,
    effect_prices,
    sphere_prices,
    work_precision,
)
from tests.conftest import expanded
from tests.test_figures.words import told as words_of

CONTENT = {
    "kind": "accuracy",
    "title": "a little accuracy",
    "scene": {"problems": ["history", "depth_levels", "beam_frequency"], "repeats": 3, "members": 4, "rungs": 5},
    "outputs": ["accuracy_earthquake", "accuracy_summary"],
}


@pytest.fixture(scope="module")
def cube():
    return accuracy_cube(expanded(CONTENT))


def test_the_cube_keeps_its_contract_and_says_what_measured_it(cube, tmp_path):
    write(cube, tmp_path / "accuracy.nc")
    again = read(tmp_path / "accuracy.nc")
    assert again.sizes["point"] == 5 * (2 * 2 + 1 * 2 + 4 * 2)
    assert again.attrs["machine"]
    assert again.attrs["measured_on"] >= "2026-01-01"
    assert (again["point_cost_low"] <= again["point_cost"]).all()
    assert (again["point_cost"] <= again["point_cost_high"]).all()


def test_every_quantity_has_a_front(cube):
    points = work_precision.table(cube)
    for _, part in points.groupby(["problem", "quantity"]):
        front = part[part["on_front"] > 0].sort_values("cost")
        assert front["error_kept"].is_monotonic_decreasing
        assert part["error_kept"].min() == front["error_kept"].min()


def test_a_lucky_setting_does_not_count():
    assert np.array_equal(lasting_error([1e-3, 1e-15, 1e-13]), [1e-3, 1e-15, 1e-13])
    assert np.array_equal(lasting_error([0.4, np.nan, 0.001, 0.2, 0.1]), [0.4, np.nan, 0.2, 0.2, 0.1], equal_nan=True)
    rungs = [Rung("history", "lucky", k, *({"peak": value},) * 3, {"peak": 0.0}, (k,)) for k, value in ((1, 0.001), (2, 0.2))]
    rungs += [Rung("history", "sound", 3, *({"peak": 0.01},) * 3, {"peak": 0.0}, (3,))]
    points = {(point["ladder"], point["setting"]): point for point in points_of(rungs)}
    assert points["lucky", 1.0]["error_kept"] == 0.2
    assert points["sound", 3.0]["on_front"] == 1.0


def test_slopes_leave_out_the_floor():
    points = pd.DataFrame({"cost": [1.0, 2.0, 4.0, 8.0, 16.0], "error": [0.4, 0.1, 0.025, 0.02, 0.02], "floor": 0.021})
    assert work_precision.slope(points) == pytest.approx(-2.0)
    assert np.isnan(work_precision.slope(points[2:]))


def test_figures(cube, tmp_path, monkeypatch):
    kept = []
    monkeypatch.setattr(work_precision, "save", lambda figure, numbers, stem: kept.append((figure, numbers)))
    monkeypatch.setattr(accuracy_summary, "save", lambda figure, numbers, stem: kept.append((figure, numbers)))
    for module in (accuracy_earthquake, accuracy_formulas, accuracy_summary):
        module.draw(cube, tmp_path / "figure")
    (earthquake, points), (_, others), (_, costs) = kept
    assert set(points["problem"]) == {"history", "beam_frequency"}
    assert set(others["problem"]) == {"depth_levels"}
    shown = [axis for axis in earthquake.axes if axis.get_visible()]
    assert len(shown) == 4
    for axis in shown:
        assert axis.get_xlabel().startswith("CPU time (s)")
        assert axis.get_ylabel() == "relative error"
        assert (axis.get_xscale(), axis.get_yscale()) == ("log", "log")
        assert axis.get_legend().get_texts()
    assert "Pareto front" in words_of(earthquake)
    reached = costs[costs["ladder"] != ""]
    assert (reached["error"] <= reached["asked"]).all()
    ordered = reached.pivot_table(index=["problem", "quantity"], columns="asked", values="cost_s").dropna()
    assert (ordered[0.01] >= ordered[0.1]).all()


def test_an_accuracy_study_takes_no_sweep_and_no_unknown_problem():
    with pytest.raises(BadInput, match="takes no sweep"):
        expanded(CONTENT | {"sweep": [{"axis": "repeats", "values": {"repeats": [1, 2]}}]})
    with pytest.raises(BadInput, match="dem_static"):
        expanded(CONTENT | {"scene": {"problems": ["dem_statics"]}})
    with pytest.raises(BadInput, match=r"needs scene\.prices"):
        expanded(CONTENT | {"outputs": ["effect_prices"]})


@pytest.mark.long
def test_prices_of_optional_parts(tmp_path, monkeypatch):
    """The part that samples a thousand solids costs nearly all there is."""
    parts = {part.name: part for part in prices.PARTS}
    scatter = optional_parts.part_price(parts["scatter of the solid"], 3)
    assert scatter.time > 0.5
    assert scatter.memory > 0.5
    kept = []
    monkeypatch.setattr(effect_prices, "save", lambda figure, numbers, stem: kept.append((figure, numbers)))
    columns = {"effect": ["a", "b"], "effect_room": ["pressures", "earthquake"]}
    columns |= {key: [0.5, -0.1] for key in effect_prices.COLUMNS[1:]}
    columns |= {"effect_instruction_share": [0.4, np.nan], "effect_uncounted": ["", "no valgrind"]}
    monkeypatch.setattr(accuracy, "price_variables", lambda repeats, tell: {k: np.array(v) for k, v in columns.items()})
    scene = {"problems": ["beam_frequency"], "repeats": 1, "rungs": 2, "prices": True}
    effect_prices.draw(accuracy_cube(expanded(CONTENT | {"scene": scene, "outputs": []})), tmp_path / "figure")
    (figure, numbers) = kept[0]
    assert figure.axes[0].get_xlabel() == "share with it (%)"
    assert [tick.get_text() for tick in figure.axes[0].get_yticklabels()] == ["a", "b"]
    assert numbers["effect_memory_share"].tolist() == [0.5, -0.1]
    assert [[text.get_text() for text in axis.texts] for axis in figure.axes[:2]] == [
        ["50 %", "-10 %"],
        ["40 %", "no valgrind"],
    ]


def test_share_of_instructions_or_why_there_is_none(monkeypatch):
    counted = {"with a": 100, "without a": 80, "with b (c)": 50, "without b (c)": 50}
    monkeypatch.setattr(prices, "missing", lambda: "")
    monkeypatch.setattr(prices, "count", lambda work: counted)
    shares, why = prices.instruction_shares()
    assert (shares, why) == ({"a": pytest.approx(0.2), "b (c)": 0.0}, "")
    monkeypatch.setattr(prices, "missing", lambda: "valgrind not found")
    assert prices.instruction_shares() == ({}, "valgrind not found")


def test_instructions_are_counted_of_steps_with_every_effect_and_without(monkeypatch):
    models = silo_of_rows(4, 4)[0], silo_of_rows(4, 4)[0]
    monkeypatch.setattr(prices, "priced_effects", lambda: {"an effect": models})
    monkeypatch.setattr(prices, "COUNTED", prices.COUNTED[2:4])
    names = ["an effect", *(part.name for part in prices.COUNTED)]
    assert list(prices.counted_work()) == [f"{end} {name}" for name in names for end in ("with", "without")]


@pytest.mark.parametrize("part", prices.PARTS, ids=lambda part: part.name)
def test_the_studies_of_every_part_are_sound(part):
    assert part.room in effect_prices.ROOMS + sphere_prices.ROOMS
    assert callable(part.whole())
    assert callable(part.less())


@pytest.mark.parametrize(
    ("name", "memory"),
    [("hopper walls", 0.0), ("rival readings", 0.05), pytest.param("49 snapshots", 0.4, marks=pytest.mark.long)],
)
def test_parts_that_surely_need_memory_do(name, memory):
    found = optional_parts.part_price(next(part for part in prices.PARTS if part.name == name), 1)
    assert memory < found.memory < 1.0
