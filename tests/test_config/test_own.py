"""A Python file of the user's own: its rows join for one study; every mistake in it is one line."""

import re

import pytest
import yaml

from silostudy.choice.expand import expand_file
from silostudy.config.load import read_study
from silostudy.config.schema import study_schema
from silostudy.errors import BadInput
from silostudy.pressure import PRESSURE
from silostudy.tables.references import cite
from tests.own import BOTH, RULE, THEORY

BUCKLING = {
    "kind": "buckling",
    "title": "a shell",
    "scene": {"radius_m": 5, "thickness_mm": 10, "bay_length_m": 20, "yield_stress_MPa": 235, "quality": "B",
              "manufacture": "fabricated"},
    "rules": ["classical", "a_fifth"],
    "methods_from": "mine.py",
}  # fmt: skip


@pytest.fixture
def saved(tmp_path, study):
    """Saves a study beside a file of the user's own, and gives the study's path."""

    def save(text=THEORY, bib="", **changes):
        (tmp_path / "mine.py").write_text(text)
        if bib:
            (tmp_path / "mine.bib").write_text(bib)
        path = tmp_path / "study.yaml"
        path.write_text(yaml.safe_dump(study | {"methods": ["janssen", "frictionless"], "methods_from": "mine.py"} | changes))
        return path

    return save


def refused(path) -> str:
    with pytest.raises(BadInput) as caught:
        expand_file(path)
    assert "\n" not in str(caught.value)
    return str(caught.value)


def test_a_row_joins_for_its_study_alone(saved, tmp_path, study):
    own = expand_file(saved()).study
    assert own.method_keys == ("janssen", "frictionless")
    assert own.family(PRESSURE)["frictionless"].title == "No wall friction"
    assert "frictionless" not in PRESSURE
    other = tmp_path / "other.yaml"
    other.write_text(yaml.safe_dump(study | {"methods": ["janssen", "frictionless"]}))
    assert "methods.1 = 'frictionless': unknown; known: janssen" in refused(other)


def test_all_holds_own_rows_after_the_packages(saved):
    assert expand_file(saved(methods="all")).study.method_keys == (*PRESSURE, "frictionless")


def test_a_typo_lists_what_exists_own_rows_included(saved):
    told = refused(saved(methods=["frictionles"]))
    assert "methods.0 = 'frictionles': unknown; known: janssen" in told
    assert told.endswith("frictionless")


def test_a_file_may_hold_rows_of_several_families(saved, tmp_path):
    assert expand_file(saved(BOTH)).study.method_keys == ("janssen", "frictionless")
    (tmp_path / "shell.yaml").write_text(yaml.safe_dump(BUCKLING))
    assert expand_file(tmp_path / "shell.yaml").study.rule_keys == ("classical", "a_fifth")


def test_a_changed_file_is_read_anew_in_the_same_process(saved):
    assert read_study(saved()).family(PRESSURE)["frictionless"].locator == "page 3"
    assert read_study(saved(THEORY.replace("page 3", "page 4"))).family(PRESSURE)["frictionless"].locator == "page 4"


def test_nothing_is_left_beside_the_file(saved, tmp_path):
    expand_file(saved())
    assert {path.name for path in tmp_path.iterdir()} == {"mine.py", "study.yaml"}


def test_the_files_are_watched(saved, tmp_path):
    assert set(expand_file(saved(bib="@misc{a, title={b}}")).files) == {tmp_path / "mine.py", tmp_path / "mine.bib"}


MISTAKES = {
    "known key": (('key="frictionless"', 'key="janssen"'), "row janssen: this key is already taken by another pressure method"),
    "no source": (('    source="J. Doe, Notes on a smooth silo, 2026",\n', ""), "line 11: TypeError: .* missing .* 'source'"),
    "empty source": (("J. Doe, Notes on a smooth silo, 2026", " "), "row frictionless: source = ' ': must be a text"),
    "source of one word": (("J. Doe, Notes on a smooth silo, 2026", "Doe2026"),
                           "row frictionless: source = 'Doe2026': no key of references.bib or of mine.bib"),
    "no unit": (("(Pa) at depth", "at depth"), r"row frictionless: static: its docstring must name its unit, \(Pa\)"),
    "parameter without unit": (("lateral_pressure_ratio", "ratio"),
                               "static: asks for ratio, which has no unit; known: unit_weight"),
    "no wall pressure": (("wall_normal_pressure", "vertical_pressure"), "must give wall_normal_pressure"),
    "unknown quantity": (('"wall_normal_pressure": normal_pressure', '"wall_normal_pressure": normal_pressure, "p": None'),
                         "phases\\['filling'\\]: p unknown; known: wall_normal_pressure"),
    "unknown phase": (('"filling"', '"emptying"'), "phases: emptying unknown; known: filling, switch, discharge"),
    "numbers for arrays": (("lateral_pressure_ratio * unit_weight * z", "float(z)"),
                           "static: fails for usual values: TypeError: only"),
    "colour": (("#CC3311", "red"), "colour = 'red': must be #rrggbb"),
    "marker": (("$f$", "star"), "marker = 'star': must be"),
    "no function": (("static=normal_pressure", "static=1.0"), "row frictionless: TypeError: 1.0 is not a callable object"),
    "no row": (("ROW = ", "MINE = "), "declares neither ROW nor ROWS"),
    "something else": (("ROW = ", "ROWS = [1]\nMINE = "), "ROWS holds 1: must be rows of a family"),
    "twice": (("ROW = ", "ROWS = [0, 0]\nROWS[0] = ROWS[1] = "), "row frictionless: this key is already taken"),
    "syntax": (("return", "retrun"), "line 8: SyntaxError: invalid syntax"),
    "import": (("import ANY_PLAN,", "import ANY_PLAN, NOTHING,"), "line 3: ImportError: cannot import name 'NOTHING'"),
    "no result": (("lateral_pressure_ratio * unit_weight * z", "None"), r"gives no real numbers but \[None\]"),
    "complex": (("unit_weight * z", "unit_weight * z * 1j"), "gives no real numbers but"),
    "infinite": (("unit_weight * z", "unit_weight * z * float('inf')"), "gives an infinite value"),
    "chance": (("unit_weight * z", "__import__('random').random() * z"), "gives other values when it is called again"),
    "a row as rows": (("\n)\n", "\n)\nROWS = ROW\n"), "ROWS must be a tuple or a list of rows"),
    "plans in one word": (("plans=ANY_PLAN", "plans='circular'"), "plans = 'circular': must be several, as {'circular'}"),
    "no text": (("import ANY_PLAN", "import\0ANY_PLAN"), "SyntaxError: source code string cannot contain null bytes"),
    "exit": (("ROW = ", "raise SystemExit('no')\nROW = "), "line 11: SystemExit: no"),
}  # fmt: skip


@pytest.mark.parametrize("name", MISTAKES)
def test_a_mistake_is_one_line_with_file_and_row(saved, name):
    (old, new), expected = MISTAKES[name]
    assert old in THEORY
    path = saved(THEORY.replace(old, new))
    assert re.search(rf"^{re.escape(str(path))}: methods_from = 'mine.py': .*{expected}", refused(path))


@pytest.mark.parametrize("line", ["import helper", "from helper import x", "from . import helper", "from .helper import x"])
def test_an_import_of_another_file_is_refused_from_wherever_it_would_come(saved, tmp_path, monkeypatch, line):
    (tmp_path / "helper.py").write_text("x = 1\n")
    path = saved(f"{line}\n{THEORY}")
    expected = r"methods_from = 'mine.py': line 1: imports \.?(helper)?, which is no installed package"
    assert re.search(expected, refused(path))
    monkeypatch.syspath_prepend(tmp_path)  # as where the pipeline's own folder is searched
    assert re.search(expected, refused(path))


def test_a_file_beside_hides_no_installed_package(saved, tmp_path):
    (tmp_path / "numpy.py").write_text("")
    assert expand_file(saved(f"import numpy.linalg, json\n{THEORY}")).study.method_keys == ("janssen", "frictionless")


def test_a_file_that_is_missing_or_of_no_use_here(saved, tmp_path):
    path = saved(RULE)
    assert "methods_from = 'mine.py': holds no pressure method" in refused(path)
    (tmp_path / "mine.py").unlink()
    assert "methods_from = 'mine.py': must be a readable Python file" in refused(path)


def test_a_rule_masks_for_a_known_reason(tmp_path):
    (tmp_path / "mine.py").write_text(
        RULE.replace("limits=(NO_SUCTION,)", "limits=(replace(NO_SUCTION, reason=99),)").replace(
            "from silo", "from dataclasses import replace\nfrom silo", 1
        )
    )
    (tmp_path / "shell.yaml").write_text(yaml.safe_dump(BUCKLING))
    assert "masks for reason 99, not one of" in refused(tmp_path / "shell.yaml")


def test_a_source_is_words_or_a_key_of_either_bibliography(saved):
    def source(written, bib=""):
        row = read_study(saved(THEORY.replace("J. Doe, Notes on a smooth silo, 2026", written), bib)).family(PRESSURE)
        return cite(row["frictionless"].source)

    assert source("J. Doe, 2026") == "J. Doe, 2026"
    assert source("silo_handbook") == cite("silo_handbook")
    assert source("doe", "@book{doe, author={J. Doe}, title={Smooth silos}, year=2026}") == "Doe, J.. Smooth silos. 2026."
    titled = '@book{doe, author={M{\\"u}ller, J.}, title={{EN} silos: 50% and 5\\% more}, year=2026}'
    assert source("doe", titled) == "Müller, J.. EN silos: 50% and 5% more. 2026."
    assert "must be readable BibTeX" in refused(saved(bib="@book{doe, author"))


def test_the_schema_completes_the_packages_keys_and_takes_others():
    text = study_schema()
    assert '"janssen"' in text
    assert '"methods_from"' in text
