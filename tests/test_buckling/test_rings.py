"""Faults of rings and lengths that were found from outside: each with the small input that showed it, and the right number."""

import numpy as np
import pytest
import yaml

from silostudy.__main__ import main
from silostudy.buckling import BUCKLING
from silostudy.buckling.family import REASONS, evaluate
from silostudy.errors import BadInput
from silostudy.pressure.janssen import axial_wall_force
from tests.test_buckling.shells import shell
from tests.test_buckling.silos import EN, SAFETY, WHEAT, cube_of, reason, strength, study, thickness_mm


def test_wires_do_not_thin_the_wall():
    rules = ("miller1977", *EN)
    bare = cube_of(rules=rules)
    wired = cube_of(rules=rules, steel={"rings": {"spacing_m": 0.05, "area_cm2": 0.01}})
    np.testing.assert_allclose(thickness_mm(wired), thickness_mm(bare), rtol=1e-9)


@pytest.mark.parametrize("rule", EN[:2])
def test_only_a_ring_that_counts_ends_a_bay(rule):
    """A long shell: C_x of 2007 falls below 1; a ring that counts restores it, half of it does not."""
    wall = {"thickness": 0.05, "total_length": 300.0, "bay_length": 5.0}
    needed = (0.06 + 2 * (0.25 / 25) ** 2 / (1 - 0.09)) * 5.0 * 0.05
    found = {
        share: evaluate(BUCKLING[rule], shell(**wall, ring_area=share * needed))["supported_length"] for share in (0.999, 1.0)
    }
    expected = 300.0 if rule == "en1993_1_6_2007" else np.nan  # too long for what is known of 2025
    np.testing.assert_equal(float(found[0.999]), expected)
    assert float(found[1.0]) == 5.0


def test_a_ring_gives_no_factor_of_a_short_shell():
    """Rings do not hold the wall against turning, so C_x stays at 1 however near they stand."""
    found = evaluate(BUCKLING["en1993_1_6_2007"], shell(bay_length=0.2, ring_area=1.0))
    assert float(found["length_factor"]) == 1.0
    assert float(evaluate(BUCKLING["en1993_1_6_2007"], shell(bay_length=0.2))["length_factor"]) > 1


def test_what_counts_of_the_rings_is_told(tmp_path, capsys):
    path = tmp_path / "rings.yaml"
    path.write_text(yaml.safe_dump(study(steel={"rings": {"spacing_m": 0.05, "area_cm2": 0.01}})))
    assert main(["check", str(path)]) == 0
    assert "rings of 0.01 cm2 every 0.05 m count at most up to a wall of 0.333 mm" in capsys.readouterr().out


@pytest.mark.parametrize("bay", [0.05, 0.1, 3.0, 20.0, 90.0])
def test_the_silo_rule_has_no_factor_for_the_length(bay):
    assert strength("en1993_4_1_2007", thickness=0.005, bay_length=bay) / 1e6 == pytest.approx(21.4, abs=0.05)


def test_the_edition_of_2025_has_no_long_branch():
    wall = {"shell_radius": 5.0, "thickness": 5.0 / 300}
    assert strength("en1993_1_6_2025", **wall, bay_length=100.0) / 1e6 == pytest.approx(121.2, abs=0.05)
    longest = 1.43 * 300 * np.sqrt(5.0 * 5.0 / 300)
    assert reason("en1993_1_6_2025", **wall, bay_length=longest * 1.001) == "length_out_of_range"
    assert "mix of editions" in BUCKLING["en1993_4_1_2025"].range


def test_a_wall_too_thick_for_the_limit_of_length_does_not_end_the_search():
    """H/D 4: R/t 20 is beyond 1.43 for 2025, the thickness sought is not; at H/D 40 every wall that carries is beyond it."""
    cube = cube_of(rules=("en1993_1_6_2025",), silo={"plan": "circular", "diameter_m": 10.0, "slenderness": 4.0})
    foot = float(cube["required_thickness"][0, -1])
    force = axial_wall_force(40.0, hydraulic_radius=2.5, **WHEAT)
    carried = strength("en1993_1_6_2025", shell_radius=5 + foot / 2, thickness=foot, bay_length=40.0, yield_stress=235e6)
    assert SAFETY * force / foot == pytest.approx(carried, rel=1e-9)
    tall = cube_of(rules=("en1993_1_6_2025",), silo={"plan": "circular", "diameter_m": 3.0, "slenderness": 40.0})
    assert np.isnan(tall["required_thickness"][0, -1])
    assert REASONS[int(tall["required_thickness_scope"][0, -1])] == "length_out_of_range"


def test_rings_further_apart_than_the_wall_is_high_are_refused():
    with pytest.raises(BadInput, match=r"spacing_m.*30.*must not exceed the height of the wall, 20 m"):
        cube_of(steel={"rings": {"spacing_m": 30.0, "area_cm2": 50.0}})
