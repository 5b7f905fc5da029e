"""From a laboratory's cube to the row of its solid: means, factors, and what must hold."""

import numpy as np
import pandas as pd
import pytest

from silostudy.choice.expand import expand
from silostudy.config.load import read_yaml
from silostudy.cube.laboratory import MeasuredSolid, Scatter, active_ratio, checks
from silostudy.errors import BadInput
from silostudy.figures import laboratory_checks, laboratory_solid
from silostudy.tables.solids import own_solids
from tests.conftest import ROOT
from tests.test_laboratory.made_up import cube_of, expansion


def held(**ratios):
    return {one.what: one.holds for one in checks(cube_of(expansion(), **ratios))}


def test_the_row_is_read_as_any_solid_of_a_user_and_pressures_are_computed_with_it(tmp_path):
    laboratory_solid.draw(cube_of(expansion()), tmp_path / "solids")
    row = own_solids(tmp_path / "solids.csv")["small_spheres"]
    assert row.lateral_pressure_ratio == pytest.approx(0.45, rel=1e-6)
    assert row.internal_friction_angle == pytest.approx(np.arctan(0.5), rel=1e-4)
    assert row.repose_angle == pytest.approx(0.4, rel=1e-6)
    assert row.wall_friction == pytest.approx(0.9 * 0.3, rel=1e-6)
    assert row.a_K == row.a_mu == pytest.approx(1.0128, rel=1e-6)  # fillings 1 % apart: that is their deviation
    assert row.unit_weight == pytest.approx(8.5e3 * 1.0128, rel=1e-6)
    assert row.unit_weight_lower == pytest.approx(7.9e3 / 1.0128, rel=1e-6)
    silo = {"plan": "circular", "diameter_m": 4.0, "cylinder_depth_m": 8.0}
    study = {"kind": "pressure", "title": "silo", "materials": "solids.csv", "scene": {"solid": row.key, "silo": silo},
             "methods": ["janssen"], "relative_depth": [1.0]}  # fmt: skip
    (case,) = expand(study, "silo", "silo.yaml", tmp_path).cases
    assert case.scene.solid.a_phi == row.a_phi


def test_the_row_is_the_widest_cell_s():
    cube = cube_of(expansion())
    wide = cube["tested_lateral_pressure_ratio"].copy()
    wide[{"cell": 0}] = 9.0
    assert MeasuredSolid.of(cube.assign(tested_lateral_pressure_ratio=wide)).lateral_pressure_ratio.mean == pytest.approx(0.45)


def test_a_scatter_needs_two_fillings_and_a_row_one_solid():
    cube = cube_of(expansion())
    lost = cube["loose_unit_weight"].copy()
    lost[{"filling": slice(1, None)}] = np.nan
    with pytest.raises(BadInput, match=r"1 of \d fillings of a cell show it: a scatter needs two"):
        MeasuredSolid.of(cube.assign(loose_unit_weight=lost))
    friction = {"axis": "friction", "values": {"spheres.sliding_friction": [0.2, 0.4]}}
    with pytest.raises(BadInput, match=r"friction.*one solid is one row"):
        MeasuredSolid.of(cube_of(expansion(sweep=[friction])))


def test_checks_tell_what_cannot_be():
    sound = held()
    assert all(sound.values())
    wall = {what for what in sound if what.startswith("wall over internal")}
    assert len(wall) == 2
    assert {what for what, holds in held(wall=0.6).items() if not holds} == wall
    low = {what for what, holds in held(ratio=0.9 * active_ratio(0.51)).items() if not holds}
    assert len(low) == 2
    assert all("Rankine" in what for what in low)
    assert [what for what, holds in held(ratio=0.62).items() if not holds] == ["K over 1.1 (1 - sin phi)"]


def test_checks_are_written_and_said(tmp_path, capsys):
    laboratory_checks.draw(cube_of(expansion(), wall=0.6), tmp_path / "checks")
    assert not pd.read_csv(tmp_path / "checks.csv")["holds"].all()
    assert "does not hold" in capsys.readouterr().out


def test_factor_is_that_of_the_ten_and_ninety_percent_fractiles():
    assert Scatter(mean=2.0, deviation=0.1, count=5).factor == pytest.approx(1.064)


BORROWING = [
    path
    for path in sorted((ROOT / "config/studies").glob("*.yaml"))
    if "laboratory_solid.csv" in str(read_yaml(path).get("materials"))
]


@pytest.mark.parametrize("path", BORROWING, ids=lambda path: path.stem)
def test_a_study_that_takes_a_laboratory_s_row_is_whole_once_it_is_there(path, tmp_path):
    """Mistakes in its scenes are not to be found out when hours of grains are computed."""
    content = read_yaml(path)
    laboratory_solid.draw(cube_of(expansion()), tmp_path / "solids")
    row = pd.read_csv(tmp_path / "solids.csv").assign(solid=content["scene"]["solid"])
    row.to_csv(tmp_path / "solids.csv", index=False)
    content["materials"] = str(tmp_path / "solids.csv")
    assert expand(content, path.stem, str(path), path.parent).cases


def test_a_row_that_no_laboratory_has_made_yet_names_the_study_that_makes_it():
    content = read_yaml(ROOT / "config/studies/silo-of-spheres-codes.yaml")
    content["materials"] = "../../nowhere/spheres-laboratory/tables/laboratory_solid.csv"
    with pytest.raises(BadInput, match=r"materials = .*: is not there yet: the study spheres-laboratory makes it"):
        expand(content, "codes", "codes.yaml", ROOT / "config/studies", [0])
    content["materials"] = "../../nowhere/spheres-laboratory/tables/other.csv"
    with pytest.raises(BadInput, match="must be a readable file of text"):
        expand(content, "codes", "codes.yaml", ROOT / "config/studies", [0])
