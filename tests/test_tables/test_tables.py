"""Tables: every row has a source, numbers become SI once, and a user's own file joins in."""

from math import atan, pi, tan

import pytest

from silostudy.buckling import BUCKLING
from silostudy.choice import fronts
from silostudy.compute.load_cases import QUESTIONS
from silostudy.config.pressure import PressureStudy
from silostudy.config.run import MEANS
from silostudy.config.shell import ShellStudy
from silostudy.cube.contract import VARIABLES
from silostudy.errors import BadInput
from silostudy.pressure import PRESSURE
from silostudy.pressure.en1991_4.characteristic import SETS
from silostudy.tables import code_differences, effect_prices, load_cases, measured, published_cases
from silostudy.tables.asked import ASKED
from silostudy.tables.clauses import EVIDENCE, STATES, clauses
from silostudy.tables.handbook import TONNE_PER_M2, errata, table_4_2_5
from silostudy.tables.outputs import OUTPUTS, caption
from silostudy.tables.read import HERE, rows
from silostudy.tables.references import cite
from silostudy.tables.solids import SOLIDS, own_solids, read_solids
from silostudy.tables.units import SUFFIXES, split_unit
from silostudy.tables.walls import WALLS

HEADER = "solid,grain,unit_weight_kN_m3,internal_friction_angle_deg,wall_friction,source,locator\n"


@pytest.mark.parametrize("path", sorted(HERE.glob("*.csv")), ids=lambda path: path.stem)
def test_every_row_of_every_table_has_a_source(path):
    text = {"solid", "method", "parameter", "value", "as_printed", "grain", "wall", "rule", "particle_size", "phase"}
    text |= {"output", "kind", "stage", "axes", "methods", "phases", "rules", "demands"}
    text |= {"erratum", "place", "printed", "right", "evidence"}
    text |= {"test", "material", "steel", "collapse", "shape", "ring"}
    text |= {"problem", "group", "setting", "quantities", "reference_kind", "reference", "compare"}
    text |= {*fronts.TEXT, "decides"}
    text |= {"record", "package", "file", "claim", "variable", "measure", "trait", "quantity", "unit"}
    text |= {"limit", "methods", "clause", "what", "state", "names", "evidence"}
    text |= {"combination", "leading", "contents", "side", "first", "second", *load_cases.TEXT, *measured.TEXT}
    text |= {*published_cases.TEXT, *effect_prices.TEXT, *code_differences.TEXT}
    found = rows(path, text=text)
    assert found
    for row in found:
        assert cite(row["source"])
        assert row["locator"]


def test_traits_and_quantities_of_fronts_are_told_and_no_others():
    assert set(fronts.TRAITS) == {name for row in fronts.FRONTS for name in row.within}
    of_fronts = {(row.front, row.name, row.decides) for row in ASKED if row.front != MEANS}
    assert of_fronts == {(row.kind, row.quantity, row.keys) for row in fronts.FRONTS}


def test_units_are_converted_once():
    assert split_unit("unit_weight_kN_m3") == ("unit_weight", "N m-3", 1e3)
    assert split_unit("internal_friction_angle_deg") == ("internal_friction_angle", "rad", pi / 180)
    assert split_unit("wall_friction") == ("wall_friction", "1", 1.0)
    assert SOLIDS["wheat"].unit_weight == pytest.approx(0.85 * 9806.65)
    assert SOLIDS["wheat"].internal_friction_angle == pytest.approx(26 * pi / 180)


def test_longer_units_win_over_their_endings():
    names = list(SUFFIXES)
    for place, name in enumerate(names):
        assert not any(name.endswith(earlier) for earlier in names[:place])


def test_tables_4_2_1_to_4_2_4_and_pieper():
    assert len([row for row in SOLIDS.values() if row.source == "silo_handbook"]) == 8
    assert (SOLIDS["cement_clinker"].unit_weight_lower, SOLIDS["cement_clinker"].unit_weight) == pytest.approx(
        (1.5 * 9806.65, 1.6 * 9806.65)
    )
    assert WALLS["as_cast_concrete"].factors == {"powder": 0.8, "fine_grain": 0.75, "coarse_grain": 0.70}
    assert WALLS["roughness_5"].factors == {"fine_grain": 0.95, "coarse_grain": 0.95}
    own = SOLIDS["wheat_benchmark"].by_method
    assert own["ty124_1956"] == {"wall_friction": 0.4, "lateral_pressure_ratio": 0.44}
    assert atan(own["caquot"]["wall_friction"]) == pytest.approx(20 * pi / 180)
    assert SOLIDS["wheat_benchmark"].as_printed["caquot"] == {"i_phi": 0.584}


def test_table_4_2_5_is_whole():
    printed = table_4_2_5()
    assert len(printed) == 13 * 14
    assert {value.depth for value in printed} >= {3.5, 10.5, 18.0}
    assert printed[0].wall_normal_pressure == pytest.approx(1.062 * TONNE_PER_M2)
    assert len([erratum for erratum in errata() if erratum.method in PRESSURE]) == 5
    assert len([erratum for erratum in errata() if erratum.method in BUCKLING]) == 7


def test_users_materials_extend_the_tables(tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text(HEADER + "barley,fine_grain,7.0,28,0.4,silo_handbook,my own test of 2026\n")
    solids = own_solids(path)
    assert len(solids) == len(SOLIDS) + 1
    assert solids["barley"].unit_weight == 7000
    assert solids["barley"].internal_friction_angle == pytest.approx(28 * pi / 180)


@pytest.mark.parametrize(
    ("text", "expected"),
    [
        (HEADER + "barley,fine_grain,7.0,28,0.4,,my test\n", "mine.csv line 2: source = ''"),
        (HEADER + "barley,fine_grain,7.0,28,0.4,me,\n", "mine.csv line 2: locator = ''"),
        (HEADER + "barley,fine_grain,seven,28,0.4,me,test\n", "unit_weight_kN_m3 = 'seven': must be a number"),
        (HEADER + "barley,fine_grain,nan,28,0.4,me,test\n", "unit_weight_kN_m3 = 'nan': must be finite"),
        (HEADER + "barley,fine_grain,-7,28,0.4,me,test\n", "unit_weight_kN_m3 = -7.0: must lie between 0 and 200"),
        (HEADER + "barley,fine_grain,7,90,0.4,me,test\n", "internal_friction_angle_deg = 90.0: must lie between 0 and 90"),
        (HEADER + "barley,dust,7,28,0.4,me,test\n", "grain = 'dust': must be one of powder, fine_grain, coarse_grain"),
        (
            HEADER + "wheat,fine_grain,7,28,0.4,silo_handbook,test\n",
            "mine.csv line 2: solid = 'wheat': this key is already taken",
        ),
        (HEADER + "b,fine_grain,7,28,0.4,me,my test\n" * 2, "mine.csv line 3: solid = 'b': this key is already taken"),
        (HEADER + "barley,fine_grain,7,28,0.4,me\n", "has more or fewer cells than the header"),
        (HEADER.replace("unit_weight_kN_m3", "unit_weight_lb") + "b,fine_grain,7,28,0.4,me,t\n", "unit_weight_lb"),
        (
            HEADER.replace("unit_weight_kN_m3,", "") + "b,fine_grain,28,0.4,me,t\n",
            "unit_weight = None: is missing (write the unit",
        ),
    ],
)
def test_bad_materials_file(tmp_path, text, expected):
    path = tmp_path / "mine.csv"
    path.write_text(text)
    with pytest.raises(BadInput) as caught:
        own_solids(path)
    assert expected in str(caught.value)
    assert "mine.csv" in str(caught.value)


def test_missing_materials_file(tmp_path):
    with pytest.raises(BadInput, match=r"nowhere\.csv"):
        read_solids(tmp_path / "nowhere.csv")


def test_angle_columns_become_coefficients(tmp_path):
    path = tmp_path / "mine.csv"
    path.write_text("solid,grain,unit_weight_kN_m3,internal_friction_angle_deg,wall_friction_angle_deg,source,locator\n"
                    "barley,fine_grain,7.0,28,20,me,test\n")  # fmt: skip
    assert read_solids(path)["barley"].wall_friction == pytest.approx(tan(20 * pi / 180))


def names_of_keys(model) -> set[str]:
    """Every key of a configuration model, its sections included."""
    schema = model.model_json_schema()
    return {key for part in (schema, *schema["$defs"].values()) for key in part.get("properties", {})}


@pytest.mark.parametrize("clause", clauses(), ids=lambda clause: f"{clause.method} {clause.clause} {clause.what[:30]}")
def test_clauses_say_their_state_and_what_carries_them(clause):
    assert clause.method in PRESSURE
    assert clause.state in STATES
    assert clause.evidence in EVIDENCE
    assert bool(clause.names) == (clause.state != "not computed"), "names what carries it, and nothing where there is nothing"
    assert not set(clause.names) - {*VARIABLES, *PRESSURE, *names_of_keys(PressureStudy)}
    if clause.evidence == "memory only":
        assert clause.state == "not computed"
    if clause.state == "off by default":
        assert all(PRESSURE[name].on_request for name in clause.names if name in PRESSURE)


@pytest.mark.parametrize("row", load_cases.LOAD_CASES.values(), ids=lambda row: row.key)
def test_load_cases_say_what_calls_for_them_and_what_carries_them(row):
    assert row.state in load_cases.STATES
    assert row.evidence in EVIDENCE
    assert row.called_for in QUESTIONS
    assert not set(row.methods) - set(PRESSURE)
    assert not set(row.sets) - set(SETS)
    assert bool(row.names) == (row.state == "computed")
    assert not set(row.names) - {*VARIABLES, *names_of_keys(PressureStudy), *names_of_keys(ShellStudy)}
    if row.evidence == "memory only":
        assert row.state == "not computed"


def test_what_one_source_has_is_off_by_default():
    assert {clause.evidence for clause in clauses() if clause.state == "computed"} == {"two sources", "equilibrium"}


def test_methods_on_one_source_stand_in_the_clauses():
    told = {name for clause in clauses() if clause.state == "off by default" for name in clause.names}
    assert {key for key, row in PRESSURE.items() if row.on_request} <= told


@pytest.mark.parametrize("key", OUTPUTS)
def test_a_caption_names_the_cube_that_was_drawn(key):
    told = caption(key)
    assert told.endswith("Drawn from ``{{ snakemake.input[0] }}``.\n")
    assert ".nc" not in told
    assert "none:" not in told
