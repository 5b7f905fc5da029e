"""A key of a family stands in its own row and in tables; everything else asks the family, a table or the cube for it."""

import ast
from pathlib import Path

import pytest

from silostudy.buckling import BUCKLING, RIVALS
from silostudy.contact import FAMILIES
from silostudy.cube.contract import VARIABLES
from silostudy.dem.integrate import INTEGRATORS
from silostudy.packing import PACKINGS
from silostudy.pressure import PRESSURE
from silostudy.seismic.rules import MASS_RULES
from silostudy.stages import FILE_KINDS, STAGES
from silostudy.tables.outputs import OUTPUTS
from silostudy.tables.problems import PROBLEMS
from silostudy.tables.references import references
from tests.conftest import ROOT

PACKAGE = ROOT / "silostudy"
METHODS = [PRESSURE, BUCKLING, RIVALS, *FAMILIES.values(), INTEGRATORS, PACKINGS, MASS_RULES]
KEYS = {key for family in (*METHODS, OUTPUTS, PROBLEMS, FILE_KINDS, STAGES) for key in family}
OWN = ("key", "source")  # arguments of a row that say its own key and its source


CHOOSERS = {"kind", "method", "rule", "law", "key", "normal", "tangential", "rolling", "cohesion", "integrator", "packing"}


def is_plain(key: str) -> bool:
    """Whether a key is also a word of English, or the name of a variable or an output: it then stands in texts and fields."""
    return key.isalpha() or key in VARIABLES or not any(key in family for family in METHODS)


def names_a_choice(node: ast.AST) -> bool:
    """Whether an expression is what a key of some family is chosen by, as `study.kind` or `method`."""
    name = node.attr if isinstance(node, ast.Attribute) else node.id if isinstance(node, ast.Name) else ""
    return name in CHOOSERS or name.endswith(("_method", "_kind", "_key"))


def choosing(tree: ast.AST) -> set[ast.AST]:
    """Constants that are compared with such an expression, or that pick a row of a family."""
    found: set[ast.AST] = set()
    for node in ast.walk(tree):
        if isinstance(node, ast.Compare) and any(map(names_a_choice, (node.left, *node.comparators))):
            for side in (node.left, *node.comparators):
                found |= {side, *(side.elts if isinstance(side, (ast.Tuple, ast.List, ast.Set)) else ())}
        elif isinstance(node, ast.Subscript) and isinstance(node.value, ast.Name) and node.value.id.isupper():
            found.add(node.slice)
    return found


def own_and_written_out(tree: ast.AST) -> set[ast.AST]:
    """What a row says of itself (its key and source), and all that stands in a study or a scene written out as a dictionary."""
    found = {node.value for node in ast.walk(tree) if isinstance(node, ast.keyword) and node.arg in OWN}
    for node in ast.walk(tree):
        if isinstance(node, ast.Dict) and any(isinstance(key, ast.Constant) and key.value == "kind" for key in node.keys):
            found |= set(ast.walk(node))
    return found


def literals(tree: ast.AST) -> list[tuple[str, int]]:
    """Keys that stand as text constants: words of English only where they choose, all others anywhere."""
    chosen, exempt = choosing(tree), own_and_written_out(tree)
    texts = [node for node in ast.walk(tree) if isinstance(node, ast.Constant) and isinstance(node.value, str)]
    kept = [node for node in texts if node.value in KEYS and node not in exempt]
    return [(node.value, node.lineno) for node in kept if node in chosen or not is_plain(node.value)]


def its_own(path: Path, key: str) -> bool:
    """Whether a file declares the row of a key: by its name or its folder's, or by the key that it gives a row."""
    homes = path.relative_to(PACKAGE).with_suffix("").parts[1:]
    return any(key.startswith(home) for home in homes) or f'key="{key}"' in path.read_text()


@pytest.mark.parametrize("room", sorted(path.name for path in PACKAGE.iterdir() if path.is_dir() and list(path.glob("*.py"))))
def test_no_key_stands_outside_its_row(room):
    """Some keys are names of tables and references too: those are known by them."""
    offenders = [
        f"{path.relative_to(PACKAGE)}:{line}: {key}"
        for path in sorted((PACKAGE / room).rglob("*.py"))
        for key, line in literals(ast.parse(path.read_text()))
        if room != "tables" and not its_own(path, key) and key not in references().entries
    ]
    assert not offenders


def test_a_key_out_of_its_row_is_noticed():
    assert literals(ast.parse('x = "en1991_4"')) == [("en1991_4", 1)]
    assert literals(ast.parse('if packing.kind == "loose": pass')) == [("loose", 1)]
    assert literals(ast.parse('Row(key="en1991_4", source="miller1977")\ntext = "loose"')) == []
