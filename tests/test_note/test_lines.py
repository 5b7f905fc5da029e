"""Every line of the note: what it reads is in the contract, and its formula gives what the cube holds, on many silos."""

from dataclasses import replace

import pytest

from silostudy.buckling import BUCKLING
from silostudy.buckling.en1993_1_6_2025 import capacity
from silostudy.checks import CHECKS
from silostudy.checks.shear_buckling import length_factor
from silostudy.choice.expand import expand
from silostudy.compute.pressure import pressure_cube
from silostudy.cube.contract import VARIABLES
from silostudy.cube.silos import END, at_silo, silos
from silostudy.errors import BadInput
from silostudy.note import formula, lines, loads, steel
from silostudy.note.below import part_in_full
from silostudy.note.lines import Line, Scope, every_line
from silostudy.note.mathml import UNITS
from silostudy.note.uses import uses_of_part, uses_of_strake
from silostudy.pressure import PRESSURE
from silostudy.tables.references import cite
from tests.conftest import ROOT
from tests.test_note.silos import SILOS, content, cubes

FLAGS = {"circular", "cone", "slot", "capped", "share", "dynamic", "reaches", "full", "shaken", "windless", "patched"}
# lines that no silo here asks for: yielding before the shell buckles, cylinders longer than any wall, an earthquake
RARE = {
    ("wall", "chi_x", "lam_x < lam_p and lam_x <= 0.2"),
    ("wall", "chi_x", "lam_x < lam_p and lam_x <= 0.1"),
    ("wall", "chi_theta", "lam_theta <= 0.4"),
    ("wall", "chi_tau", "lam_tau <= 0.4"),
    ("wall", "C_tau", "omega > 8.7*r/t"),
    ("axial", "n_x__Ed", "shaken == 1"),
}


def of_pressure(pressure):
    """(lines of the chapters on loads, the scope that knows them)."""
    found, scope = loads.chapters(pressure.isel({END: 0}) if END in pressure.dims else pressure, "en1991_4", None)
    return [line for chapter in found for block in chapter.blocks for line in block.lines], scope


def of_silo(name):
    """Every line of a silo's note, and those of all checks that the note has as table rows alone."""
    pressure, checks = (at_silo(cube, silos(cube)[0]).sel(pressure_method="en1991_4") for cube in cubes(name))
    found, scope = of_pressure(pressure)
    chapters = steel.chapters(checks, pressure, scope)
    found += [line for chapter in chapters for block in chapter.blocks for line in block.lines]
    rules = [str(rule) for rule in checks["rule"].values]
    _, local = steel.given(checks, scope)
    for strake in map(int, checks["strake"].values):
        for use in uses_of_strake(checks, strake):
            found += steel.in_full(checks, local, use, rules) if use.combination else []
    for part in ("hopper", "support"):
        for use in uses_of_part(checks, part):
            found += part_in_full(checks, pressure, local, part, use) if use.combination else []
    return found


def of_plan(plan, depth=14.0, half_angle=30.0):
    study = content("slender")
    for name in ("rules", "checks"):
        study.pop(name)
    study["kind"], scene = "pressure", study["scene"]
    hopper = {"half_angle_deg": half_angle, "outlet_width_m": 0.6}
    silo = {"plan": plan, "width_m": 4.0, "cylinder_depth_m": depth, "hopper": hopper}
    study["scene"] = {"silo": silo, "solid": scene["solid"], "wall": scene["wall"]}
    return of_pressure(pressure_cube(expand(study, plan, f"{plan}.yaml", ROOT)).sel(pressure_method="en1991_4"))[0]


@pytest.fixture(scope="module")
def written():
    plans = {"slot": of_plan("slot"), "square": of_plan("square"), "low square": of_plan("square", depth=6.0)}
    return {**{name: of_silo(name) for name in SILOS}, **plans}


def test_every_formula_of_the_shipped_silo_gives_what_the_cube_holds():
    found = of_silo("slender")
    assert not [(one.line.name, one.value, one.result) for one in found if not one.agrees]
    assert len(found) > 500


@pytest.mark.parametrize("depth", [14.0, 6.0])
def test_the_band_of_a_square_silo_has_its_lines(depth):
    found = {one.line.name: one for one in of_plan("square", depth)}
    assert {"p_ncf", "p_nce"} <= set(found)
    assert all(one.agrees for one in found.values())


def test_the_declared_class_is_told():
    assert {one.line.name: one.shown for one in of_silo("slender")}["AAC_d"] == "none"


def test_the_numbers_as_shown_give_the_result_as_shown(monkeypatch):
    """Whoever puts the four digits of the page into a formula finds the page's result, to a hundredth."""
    exact = Scope.numbers
    monkeypatch.setattr(Scope, "numbers", lambda self, names: {n: float(f"{v:.4g}") for n, v in exact(self, names).items()})
    found = [one for one in of_silo("slender") if one.value == one.value]
    assert not [(one.line.name, one.value, one.result) for one in found if one.value != pytest.approx(one.result, rel=0.01)]


@pytest.mark.long
def test_every_formula_gives_what_the_cube_holds(written):
    off = [(name, one.line.name, one.value, one.result) for name, found in written.items() for one in found if not one.agrees]
    assert not off
    assert sum(len(found) for found in written.values()) > 1000


@pytest.mark.long
def test_every_line_with_a_formula_was_put_to_that_test(written):
    tried = {one.line for found in written.values() for one in found if one.value == one.value}
    left = {(one.section, one.name, one.when) for one in every_line() if one.formula and one not in tried}
    assert left <= RARE | {("wall", "U", "")}
    assert {one.owner for one in every_line() if (one.section, one.name, one.when) in left - RARE} <= {("other_rule",)} | {
        one.owner for one in tried
    }


def test_what_the_rare_lines_say_is_what_the_rules_do():
    rare = {(one.section, one.name, one.when): one.formula for one in every_line()}
    hardened = formula.evaluate(rare["wall", "chi_x", "lam_x < lam_p and lam_x <= 0.1"], {"lam_x": 0.06})
    assert hardened == pytest.approx(float(capacity(0.06, 0.5, 1.0)))
    long = formula.evaluate(rare["wall", "C_tau", "omega > 8.7*r/t"], {"omega": 9000.0, "r": 3.0, "t": 0.005})
    assert long == pytest.approx(float(length_factor(9000.0, 600.0)))


def test_a_wrong_formula_is_noticed():
    pressure, _ = cubes("slender")
    pressure = at_silo(pressure, silos(pressure)[0]).sel(pressure_method="en1991_4")
    _, scope = of_pressure(pressure)
    line = next(one for one in every_line() if one.name == "p_hf" and one.when == "lam_s >= 2")
    cube = pressure.isel({END: 0, "phase": 0, "relative_depth": -1})
    there = Scope((cube,), scope.known)
    result = lines.read(line, there.cubes)
    assert lines.written(line, result, there).agrees
    wrong = replace(line, formula=line.formula.replace("mu_n", "mu_w"))
    assert not lines.written(wrong, result, there).agrees


@pytest.mark.parametrize("line", every_line(), ids=lambda line: f"{line.section}-{line.name}")
def test_row_is_sound(line: Line):
    assert UNITS[line.unit][0] == VARIABLES[line.variable].units
    assert line.what
    assert line.locator
    assert cite(line.source)
    assert {*line.owner} <= {*PRESSURE, *BUCKLING, *CHECKS, "other_rule"}
    before = {one.name for one in every_line()[: every_line().index(line) + 1]} | FLAGS
    assert {*formula.names(line.formula or "0"), *formula.names(line.when or "0")} <= before


def test_a_number_that_still_has_a_dimension_is_refused():
    pressure, _ = cubes("slender")
    line = next(one for one in every_line() if one.name == "p_hf")
    with pytest.raises(BadInput, match="still has pressure_method"):
        lines.read(line, (pressure,))


def test_a_formula_with_tall_brackets_is_set_smaller():
    found = {one.line.name: one.size for one in of_silo("slender")}
    assert (found["C_pf"], found["C_pe"]) == ("long", "longer")
    assert found["p_he"] == ""
