"""What brackets the measurements: the figure's numbers against the cube and against closed forms."""

from functools import cache
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

from silostudy.cube.measured import cases_of, deviations, neighbour
from silostudy.errors import BadInput
from silostudy.figures import measured_brackets, measured_silos, measured_swelling
from silostudy.tables.measured import measurements
from tests.test_figures.small_cubes import cube_of

MEASURED = {one.measurement: one for one in measurements()}


@cache
def cube():
    return cube_of("measured-brackets", "pressure")


@pytest.fixture(scope="module")
def numbers(tmp_path_factory):
    """The table beside the figure, drawn once and without its pixels."""
    stem = tmp_path_factory.mktemp("figure") / "brackets"
    with pytest.MonkeyPatch.context() as patch:
        patch.setattr(Figure, "savefig", lambda figure, path, **options: Path(path).touch())
        measured_brackets.draw(cube(), stem)
    return pd.read_csv(stem.with_suffix(".csv"))


def test_every_measurement_has_its_finding(numbers):
    findings = numbers[numbers.shown == "finding"].set_index("measurement")
    assert sorted(findings.index) == sorted(MEASURED)
    for name, one in MEASURED.items():
        assert findings.verdict[name] == one.why_none or (
            one.answer and ("next" in findings.verdict[name] or "z/z_o" in findings.verdict[name])
        )
    assert findings.next_above["thompson_12_8"] == "as3774_1996"
    assert pd.isna(findings.next_below["thompson_12_8"])
    assert (findings.next_below["thompson_11_0"], findings.next_above["thompson_11_0"]) == ("as3774_1996", "caquot")


def test_curves_of_swelling_solids_have_a_mark_each():
    swollen = [one for one in MEASURED.values() if one.answer == measured_brackets.SWELLING_OVER_FILLING]
    drawn = measured_swelling.curves(
        cube(), swollen, measured_brackets.SWOLLEN, (measured_brackets.FILLED, measured_brackets.STATIC)
    )
    panel = plt.figure().add_subplot()
    measured_swelling.draw_on(panel, drawn, measured_swelling.crossings(drawn, swollen), swollen)
    curves = [line for line in panel.lines if " wall, over " in str(line.get_label())]
    assert len({line.get_marker() for line in curves}) == len(curves) > 3
    assert len({(line.get_color(), line.get_linestyle()) for line in curves}) == len(curves)
    plt.close("all")


def test_the_soybeans_ratio_stands_between_its_neighbours(numbers):
    """Table E.1: phi 25 degrees, K_m 0.63, a_K 1.11; AS 3774's k on D2 of 0.38."""
    rows = numbers[(numbers.measurement == "atewologun_ratio") & (numbers.shown == "method")].set_index("pressure_method")
    measured = 1 - np.sin(np.radians(25))
    assert rows.measured.unique() == pytest.approx([measured], rel=1e-6)
    assert rows.computed["janssen"] == pytest.approx(0.63)
    assert rows.computed["en1991_4"] == pytest.approx(0.63 * 1.11)
    assert rows.ratio.to_numpy() == pytest.approx((rows.computed / measured).to_numpy(), rel=1e-5)
    assert "as3774_1996_swelling" not in rows.index
    below, above = (rows[rows.bracket == f"next {where}"].computed for where in ("below", "above"))
    assert not ((rows.computed > below.max()) & (rows.computed < above.min())).any()
    assert below.max() < measured < above.min()


def test_swelling_comes_to_the_measured_ratio_where_the_closed_form_does(numbers):
    """(exp(x) - 1)/(1 - exp(-K x)), x = z/z_o: never below 1/K."""
    crossings = numbers[numbers.shown == "crossing"]
    over_janssen = crossings[crossings.pressure_method == "janssen"]
    ratio = {"wheat_e1": 0.54, "barley_e1": 0.59}
    assert len(over_janssen) == 5
    for row in over_janssen.itertuples():
        x, k = row.relative_depth, ratio[row.taken_solid]
        assert np.expm1(x) / -np.expm1(-k * x) == pytest.approx(MEASURED[row.measurement].value, rel=2e-4)
        assert row.least_ratio > 1 / k
    oats = crossings[(crossings.measurement == "swelling_oats_1998") & (crossings.pressure_method == "as3774_1996")]
    assert oats.relative_depth.isna().all()
    assert (oats.least_ratio > 1.87).all()


def test_a_measurement_is_answered_with_its_own_solid_wall_and_size():
    solid, wall = cube()["silo_solid"].values, cube()["silo_wall"].values
    for one in measurements():
        places = cases_of(cube(), one) if one.answer else []
        assert bool(places) == bool(one.answer)
        assert {str(solid[place]) for place in places} <= {one.taken_solid}
        assert not one.taken_wall or [str(wall[place]) for place in places] == [one.taken_wall]


def test_brackets_follow_the_pressures():
    one = MEASURED["thompson_11_0"]
    here = cube().isel(silo=cases_of(cube(), one)[0])
    methods = ["janssen", "en1991_4"]
    halved = here.assign(wall_normal_pressure=here["wall_normal_pressure"] * 0.5)
    assert neighbour(deviations(here, one, methods), "above")[0] == ["janssen"]
    assert neighbour(deviations(here, one, methods), "below")[0] == []
    assert neighbour(deviations(halved, one, methods), "below")[0] == ["en1991_4"]


@pytest.mark.parametrize(
    ("change", "told"),
    [
        (lambda cube: cube.drop_vars("silo_wall"), "must set solid and wall"),
        (lambda cube: cube.isel(silo=slice(1, None)), "12.8 m x 17.1 m with maize_e1 on d3 of thompson_12_8"),
        (lambda cube: cube.isel(silo=slice(0, 5)), "silo with barley_e1 of swelling_oats_1998"),
    ],
)
def test_a_study_without_a_case_is_told(tmp_path, change, told):
    with pytest.raises(BadInput, match=told):
        measured_brackets.draw(change(cube()), tmp_path / "brackets")
    plt.close("all")


def test_a_depth_that_the_cube_does_not_reach_is_not_answered():
    one = MEASURED["thompson_12_8"]
    here = cube().isel(silo=0, relative_depth=slice(0, 100))
    assert deviations(here, one, ["janssen"]).empty


def test_a_study_without_a_measured_size_is_told(tmp_path):
    with pytest.raises(BadInput, match="no silo of the study has the size of a measured one"):
        measured_silos.draw(cube().isel(silo=slice(2, None)), tmp_path / "silos")
