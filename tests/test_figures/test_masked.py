"""What a figure, a table or compare leaves out for a limit is told: which limit, where, how often and why."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
from matplotlib.figure import Figure

from silostudy.__main__ import main
from silostudy.figures import (
    knockdown_over_slenderness,
    overpressure_over_slenderness,
    required_thickness,
    shell_earthquake,
    shell_summary,
    silo_pressures,
)
from silostudy.figures.style import AID
from tests.conftest import ROOT
from tests.test_figures.small_cubes import cube_of, cubes_of
from tests.test_figures.words import told

HOOP = "hoop_stress_at_yield"


@pytest.fixture(autouse=True)
def without_pixels(monkeypatch):
    monkeypatch.setattr(Figure, "savefig", lambda figure, path, **options: Path(path).touch())
    yield
    plt.close("all")


def masked(cube, name, where):
    """The cube with a variable masked somewhere, as a wall whose hoop stress is at yield."""
    flag = cube[name + "_scope"].attrs["flag_meanings"].split().index(HOOP)
    changed = cube.assign({name: cube[name].copy(deep=True), name + "_scope": cube[name + "_scope"].copy(deep=True)})
    changed[name].loc[where], changed[name + "_scope"].loc[where] = np.nan, flag
    return changed


def test_knock_down_curves_that_end_name_their_limit(tmp_path, kept):
    (cube,) = cubes_of("knockdown_over_slenderness")
    np.testing.assert_array_equal(cube["rule_limit_broken"] > 0, cube["buckling_stress_scope"] > 0)
    knockdown_over_slenderness.draw(cube, tmp_path / "knock")
    words = told(kept[0])
    assert "NASA SP-8007; ends: R/t < 1500 (range of the tests)" in words
    assert "Miller (1977); ends: C of a long shell > 0 (manufactured shells: R/t up to 2329)" in words


def test_lone_points_of_the_overpressure_are_explained(tmp_path, kept):
    overpressure_over_slenderness.draw(cubes_of("overpressure_over_slenderness")[0], tmp_path / "over")
    words = told(kept[0])
    assert "ACI 313-77, discharge: gives nothing in 1464 of 1584 cases: solid property missing; out of its range" in words
    assert "aci313" not in words
    assert "jenike_funnel" not in words
    table = pd.read_csv(tmp_path / "over.csv")
    assert kept[0].axes[1].get_ylim()[1] > table["max"].max()  # no band is cut


def test_thickness_of_a_wall_not_judged_is_not_shown(tmp_path, kept):
    cube = cubes_of("required_thickness")[0].sel(diameter=[7.5, 10.0], slenderness=[1.0, 2.0])
    where = {"rule": "nasa_sp8007", "pressure_method": "janssen", "diameter": 10.0, "slenderness": 2.0, "relative_depth": 1.0}
    required_thickness.draw(masked(cube, "required_thickness", where), tmp_path / "needed")
    assert kept[0].axes[0].texts[cube.sizes["pressure_method"]].get_text() == "-"
    assert "required thickness masked (hoop stress at yield) at NASA SP-8007 2 of 3600 depths" in told(kept[0])


def test_shaken_wall_says_where_it_is_not_judged(tmp_path, kept):
    where = {"rule": "miller1977", "pressure_method": "janssen", "side": "pressed", "depth": 20.0}
    (cube,) = cubes_of("shell_earthquake")
    cube = masked(cube, "earthquake_utilisation", where)
    shell_earthquake.draw(masked(cube, "earthquake_required_thickness", where), tmp_path / "shaken")
    assert "earthquake required thickness masked (hoop stress at yield) at Miller (1977) 1 of 322 depths" in told(kept[0])
    look = {"color": str(cube["rule_colour"].sel(rule="miller1977").values), "linewidth": shell_earthquake.WITH["linewidth"]}
    pieces = [line for line in kept[0].axes[2].lines if {name: line.properties()[name] for name in look} == look]
    # Miller's from step to step, whose pressed side is masked at the foot: not the lifted one's
    full = np.concatenate([line.get_xdata() for line in pieces if line.get_gid() != AID])
    assert np.isnan(full[-1])
    assert np.isfinite(full[:-1]).all()
    assert "mm, masked" in told(kept[0])


def test_summary_keeps_the_rules_that_give_nothing(tmp_path):
    where = {"rule": "miller1977", "pressure_method": "janssen", "wall_friction_end": "upper"}
    cube = cube_of("steel-wheat-strakes", "shell")
    cube = masked(cube, "utilisation", {**where, "phase": "filling"})
    shell_summary.draw(cube, tmp_path / "summary")
    table = pd.read_csv(tmp_path / "summary.csv").query("rule == 'miller1977' and pressure_method == 'janssen'")
    row = table[table.wall_friction_end == "upper"].iloc[0]
    assert np.isnan(row.utilisation)
    assert row.masked_depths == cube.sizes["depth"]
    assert row.masked_why == "hoop stress at yield"


def test_compare_shows_the_shaken_wall(capsys):
    assert main(["compare", str(ROOT / "config/studies/steel-wheat-shaken.yaml")]) == 0
    shaken = capsys.readouterr().out.split("with the earthquake")[1].split("under combinations")[0]
    cube = cube_of("steel-wheat-shaken", "shell")
    one = cube.sel(rule="en1993_1_6_2007", pressure_method="janssen")
    (line,) = (line for line in shaken.splitlines() if line.startswith("janssen, en1993_1_6_2007"))
    used = max(float(one["earthquake_utilisation"].max()), float(one["earthquake_strake_utilisation"].max()))
    needed = float(one["earthquake_required_thickness"].max()) * 1e3
    assert line.split()[2:] == [f"{needed:.2f}", "mm", "buckling", "pressed", f"{used:.3f}", "buckling", "pressed"]


def test_pressures_of_several_sets_are_no_single_state(tmp_path, kept):
    (cube,) = cubes_of("silo_pressures")
    silo_pressures.draw(cube, tmp_path / "silo")
    starred = {panel.get_title().split(":2006")[0] for panel in kept[0].axes if "*" in panel.get_title()}
    assert starred == {"EN 1991-4"}
    assert "each by their own set of characteristic values" in told(kept[0])
    assert not silo_pressures.of_sets(cube_of("wheat-silo-today", "pressure"), "en1991_4_mean")
