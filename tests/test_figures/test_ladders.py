"""What settings change in means of fillings, found again in cubes that were made so."""

import numpy as np
import pandas as pd
import pytest

from silostudy.figures import laboratory_ladders, shaken_ladders
from silostudy.figures.intervals import changed
from silostudy.figures.ladder_rungs import setting_label
from silostudy.figures.ladders import CODE, FILLING, LAW, PEAK, QUANTITIES, _unseen, draw, ladders, quantities
from silostudy.tables.code_differences import CODE_DIFFERENCES
from tests.test_figures.made_scenes import ladder_cube, shaken_ladder_cube
from tests.test_figures.small_studies import expansion_of
from tests.test_laboratory.made_up import cube_of as made_up


def shown(cube):
    return ladders(cube, dict(quantities(cube)))


@pytest.fixture
def table():
    return shown(ladder_cube("spheres-ladders"))


def test_a_change_is_that_of_the_means_with_its_interval():
    random = np.random.default_rng(1)
    kept = []
    for _ in range(400):
        base, other = 2.0 + 0.1 * random.normal(size=6), 2.2 + 0.2 * random.normal(size=6)
        change, half = changed(other, base)
        kept.append(abs(change - 0.1) <= half)
    assert 0.92 < np.mean(kept) < 0.98
    assert changed(np.array([2.2, np.nan, 2.2]), np.array([2.0, 2.0, 2.1])) == pytest.approx(
        (2.2 / (6.1 / 3) - 1, 0.0705), rel=1e-2
    )


def test_every_setting_stands_in_every_panel_and_laws_apart(table):
    assert len(table) == 3 * 18
    laws = set(table[table["sort"] == LAW]["setting"])
    assert laws == {title for title in table["setting"] if title.startswith("law: ")}
    assert len(laws) == 4
    first = table[table["setting"] == "as the others are held against"]
    assert (first["change"] == 0.0).all()
    assert (first["low"] < 0.0).all()
    assert (first["low"] == -first["high"]).all()


def test_a_setting_that_shows_nothing_is_named(table):
    made = ladder_cube("spheres-ladders").copy(deep=True)
    made["mean_mass_flow"][3] = np.nan
    seen = shown(made)
    assert _unseen(table, QUANTITIES) == []
    assert _unseen(seen, QUANTITIES) == ["Not come to rest, or not flowing in time: an eighth of the step (mass flow)."]
    assert seen["change"].isna().sum() == 1


def drawn(cube, folder) -> pd.DataFrame:
    draw(cube, folder / "figure")
    return pd.read_csv(folder / "figure.csv")


def test_another_code_stands_beside_settings_as_it_was_measured(tmp_path):
    cube = ladder_cube("spheres-ladders")
    measured = {told.quantity: told for told in CODE_DIFFERENCES}
    table = drawn(cube, tmp_path)
    rows = table[table["sort"] == CODE].set_index("quantity")
    assert set(rows.index) == {*QUANTITIES, *PEAK}
    for quantity, row in rows.iterrows():
        told = measured[quantity]
        assert row["change"] == pytest.approx(told.change, rel=1e-5)
        assert row["high"] - row["low"] == pytest.approx(2.0 * told.half_interval, rel=1e-5)
    elsewhere = cube.assign_attrs(title="another bin")
    assert CODE not in set(drawn(elsewhere, tmp_path)["sort"])


def test_the_largest_wall_force_is_that_of_all_cells_in_a_window(tmp_path):
    cube = ladder_cube("spheres-ladders").copy(deep=True)
    fillings = 1.0 + 0.01 * np.arange(cube.sizes["filling"])
    cube["wall_pressure_in_flow"][:] = 1000.0
    for setting in range(cube.sizes["setting"]):
        for filling, share in enumerate(fillings):
            pressure = share * (3000.0 if setting == 1 else 1500.0)
            cube["wall_pressure_in_flow"][{"setting": setting, "filling": filling, "flow_window": 2}] = pressure
    table = drawn(cube, tmp_path)
    rows = table[table["quantity"] == "largest_wall_force_in_flow"].set_index("setting")["change"]
    assert rows["half the step"] == pytest.approx(1.0)
    assert rows["a quarter of the step"] == pytest.approx(0.0, abs=1e-12)


def test_a_filling_lies_within_its_bar_as_often_as_is_said(tmp_path):
    cube = ladder_cube("spheres-ladders").copy(deep=True)
    scatter = np.array([-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]) * np.sqrt(5.0 / 6.0)
    cube["mean_mass_flow"] = ("setting", "filling"), 0.2 * (1.0 + 0.1 * scatter) * np.ones((cube.sizes["setting"], 1))
    table = drawn(cube, tmp_path)
    row = table[(table["sort"] == FILLING) & (table["quantity"] == "mean_mass_flow")].iloc[0]
    assert (row["low"], row["high"]) == pytest.approx((-0.257, 0.257), rel=1e-3)  # Student's 2.571 of five


def test_changes_of_shaken_spheres_by_what_their_settings_change(tmp_path):
    shaken_ladders.draw(shaken_ladder_cube("shaken-spheres-ladders"), tmp_path / "figure")
    table = pd.read_csv(tmp_path / "figure.csv")
    walls = table[table["quantity"] == "walls"].set_index("setting")["change"]
    assert list(walls.index[1:4]) == ["time step 0.5 of the chosen", "time step 0.25 of the chosen", "softened modulus 1 MPa"]
    assert walls.index[-1] == "size of grains 3.75 mm"
    assert walls.index[0] == "as the others are held against"
    base = setting_label(shaken_ladder_cube("shaken-spheres-ladders"), 0)
    assert base == "time step 1 of the chosen, softened modulus 10 MPa, size of grains 5 mm"
    assert walls.values == pytest.approx(-0.01 * np.arange(10) / 1.003, abs=1e-6)


def test_changes_in_the_laboratory_are_of_angles(tmp_path):
    cube = made_up(expansion_of("laboratory-ladders"))
    cube["internal_peak_shear_ratio"][1] *= 1.1
    cube["tested_unit_weight"][{"setting": 0, "cell": 0}] *= 0.9
    laboratory_ladders.draw(cube, tmp_path / "figure")
    table = pd.read_csv(tmp_path / "figure.csv").set_index(["quantity", "setting"])["change"]
    other = "time step 0.5 of the chosen"
    assert table["tested_lateral_pressure_ratio", other] == pytest.approx(0.0, abs=1e-9)
    assert table["internal_friction_angle", other] == pytest.approx(np.arctan(0.55) / np.arctan(0.5) - 1.0, rel=1e-3)
    assert table["tested_unit_weight", "cell 7 grains wide, not 10"] == pytest.approx(-0.1)
    assert table["tested_unit_weight", other] == pytest.approx(0.0, abs=1e-9)
