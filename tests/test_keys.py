"""A key of a family stands nowhere but in its own row, a table, or a user's file: what others need to know, the row says.

What counts is a text in the code (no docstring) that equals a key and can be taken for nothing else:
a key with a digit, - or _ and the name of a pressure method count wherever they stand, unless it is a variable of the cube too;
a key of one plain word (rows, none, shell, packing) is a word of the language as well, and counts where it is compared, or
picked from a family by its name in capitals.
A row's own room, where it lies in its family's folder, may say its key.
"""

import ast
from collections.abc import Iterator, Mapping
from pathlib import Path

import pytest

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.catalogue import Family
from silostudy.contact import COHESION, NORMAL, ROLLING, TANGENTIAL
from silostudy.cube.contract import VARIABLES
from silostudy.dem.integrate import INTEGRATORS
from silostudy.packing import PACKINGS
from silostudy.pressure import PRESSURE
from silostudy.seismic.rules import MASS_RULES
from silostudy.stages import FILE_KINDS, STAGES
from silostudy.tables.outputs import OUTPUTS
from silostudy.tables.problems import PROBLEMS
from tests.conftest import ROOT

PACKAGE = ROOT / "silostudy"
# the room or file in which a family's rows lie -> the families
ROOMS: dict[str, tuple[Mapping, ...]] = {
    "pressure": (PRESSURE,),
    "buckling": (BUCKLING, RIVALS),
    "contact": (NORMAL, TANGENTIAL, ROLLING, COHESION),
    "packing": (PACKINGS,),
    "dem/integrate.py": (INTEGRATORS,),
    "seismic": (MASS_RULES,),
    "stages": (FILE_KINDS, STAGES),
    "tables": (OUTPUTS, PROBLEMS),
}
KEYS = {key: room for room, families in ROOMS.items() for family in families for key in family}
NAMES = {name for name, value in globals().items() if isinstance(value, Family)}
# file -> words that are keys by accident there
ACCIDENTS = {
    "config/seismic.py": {"sasaki_1991"},  # published results, which a table of the same name holds
    "figures/seismic_resonance.py": {"sasaki_1991"},
    "figures/shaken.py": {"sasaki_1991"},
    "figures/miller_tests.py": {"test_over_prediction"},  # a column
    "figures/packing_findings.py": {"packing"},  # an axis
    "figures/packing_slit.py": {"packing"},
    "scene/stability.py": {"rows"},  # a network of resting discs
    "seismic/records.py": {"none"},  # a baseline that is left as it is
}
# file -> keys that still stand in it; the list may only become shorter
LEFT = {
    # what is measured are studies, written in code; they name their methods as a study file does
    "accuracy/optional_formulas.py": {"caquot", "din1055_1964", "en1991_4", "en1993_1_6_2007", "en1993_1_6_2025",
                                      "en1993_4_1_2025", "janssen", "jenike_1969", "jenike_mass_flow", "miller1977"},
    "accuracy/problems/shell_levels.py": {"en1993_4_1_2025"},
    "accuracy/problems/shell_strength.py": {"en1993_4_1_2007"},
    # choices of how much of the contents moves, one of them a rule
    "config/shell.py": {"eighty_percent"},
    "figures/seismic_demand.py": {"eighty_percent"},
    # which curves are the handbook's, and which of EN's rows are local, no coordinate of the cube says yet
    "figures/comparison_today.py": {"en1991_4_eccentric", "reimbert"},
    "figures/packing_against_codes.py": {"janssen"},
}  # fmt: skip


def texts(tree: ast.Module) -> Iterator[tuple[str, bool]]:
    """Every text of a module that is no docstring, and whether it is compared or picks from a family."""
    docs = {id(node.value) for node in ast.walk(tree) if isinstance(node, ast.Expr)}
    chosen = {id(part) for node in ast.walk(tree) for part in _choosing(node)}
    for node in ast.walk(tree):
        if isinstance(node, ast.Constant) and isinstance(node.value, str) and id(node) not in docs:
            yield node.value, id(node) in chosen


def _choosing(node: ast.AST) -> Iterator[ast.AST]:
    if isinstance(node, ast.Compare):
        one_of = isinstance(node.ops[0], (ast.In, ast.NotIn))  # "packing" in dims asks for a word, key in ("rows",) for a key
        for part in node.comparators if one_of else (node.left, *node.comparators):
            yield from ast.walk(part) if isinstance(part, (ast.Tuple, ast.Set, ast.List)) else [part]
    if isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id in NAMES:
        yield node.slice


def counts(key: str, chosen: bool) -> bool:
    """Whether a text that equals a key is taken for the key."""
    if key in VARIABLES:
        return False
    return chosen or not key.isalpha() or key in PRESSURE


def found(path: Path) -> set[str]:
    """Keys that stand in a file although their rows lie elsewhere."""
    name = path.relative_to(PACKAGE).as_posix()
    keys = {
        text for text, chosen in texts(ast.parse(path.read_text(encoding="utf-8"))) if text in KEYS and counts(text, chosen)
    }
    return {key for key in keys if not name.startswith(KEYS[key]) and path.stem != key}


@pytest.mark.parametrize("path", sorted(PACKAGE.rglob("*.py")), ids=lambda path: path.relative_to(PACKAGE).as_posix())
def test_a_key_stands_in_its_own_row_alone(path):
    name = path.relative_to(PACKAGE).as_posix()
    assert found(path) == LEFT.get(name, set()) | ACCIDENTS.get(name, set())


def test_a_key_is_found_where_it_stands(tmp_path, monkeypatch):
    monkeypatch.setattr("tests.test_keys.PACKAGE", tmp_path)
    path = tmp_path / "some.py"
    path.write_text(
        '"""janssen"""\nif key == "none" or kind in ("rows", 1) and "packing" in dims:\n'
        '    PACKINGS["given"], cube["loose"], "spring-slider", "fig_4_2_11"\n'
    )
    assert found(path) == {"none", "rows", "given", "spring-slider", "fig_4_2_11"}
