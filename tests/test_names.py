"""Names tell what they hold, a class name has one meaning, constants stand one a line, docstrings name a quantity or an act."""

import ast
import re
from collections import Counter
from collections.abc import Iterator

from silostudy import PACKAGE

VAGUE = {"one", "at", "found", "each", "kept"}
# how no first line of a docstring begins: it names a quantity (and its unit), or says by a verb what is done
VAGUE_STARTS = re.compile(
    "(What|Those|With|Of|How|Itself|By|On|In|At|From|Which|Where|Who|When|That|For|Its|Not|Without|Beside|Why|While|Until|It)\\b"
)
TREES = {path.relative_to(PACKAGE): ast.parse(path.read_text()) for path in sorted(PACKAGE.rglob("*.py"))}


def names_given(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Line and name of every variable, argument, field, function and import that a file names."""
    for node in ast.walk(tree):
        if isinstance(node, ast.Name) and not isinstance(node.ctx, ast.Load):
            yield node.lineno, node.id
        elif isinstance(node, ast.arg):
            yield node.lineno, node.arg
        elif isinstance(node, ast.Attribute) and not isinstance(node.ctx, ast.Load):
            yield node.lineno, node.attr
        elif isinstance(node, (ast.FunctionDef, ast.ClassDef)):
            yield node.lineno, node.name
        elif isinstance(node, ast.alias):
            yield node.lineno, node.asname or node.name


def first_lines(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """Line and first line of every docstring of a file."""
    for node in ast.walk(tree):
        if isinstance(node, (ast.Module, ast.ClassDef, ast.FunctionDef)) and (words := ast.get_docstring(node)):
            yield getattr(node, "lineno", 1), words.splitlines()[0]


def begins_vaguely(line: str) -> bool:
    """Whether a docstring begins with a word that names nothing, a tuple or a call."""
    return not line[:1].isupper() or VAGUE_STARTS.match(line) is not None


def packed_constants(tree: ast.Module) -> Iterator[tuple[int, str]]:
    """Line and names of constants that are given literal values several a line."""
    for node in tree.body:
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Tuple) and isinstance(node.value, ast.Tuple):
            yield node.lineno, ast.unparse(node.targets[0])


def test_no_name_is_vague():
    places = [f"{path}:{line} {name}" for path, tree in TREES.items() for line, name in names_given(tree) if name in VAGUE]
    assert places == []


def test_a_class_name_has_one_meaning():
    names = Counter(node.name for tree in TREES.values() for node in ast.walk(tree) if isinstance(node, ast.ClassDef))
    assert [name for name, count in names.items() if count > 1] == []


def test_a_docstring_names_a_quantity_or_says_what_is_done():
    places = [
        f"{path}:{line} {words}" for path, tree in TREES.items() for line, words in first_lines(tree) if begins_vaguely(words)
    ]
    assert places == []


def test_constants_stand_one_a_line():
    places = [f"{path}:{line} {names}" for path, tree in TREES.items() for line, names in packed_constants(tree)]
    assert places == []


def test_what_is_refused_would_be_seen():
    tree = ast.parse('"""What it is."""\nA, B = 1, 2\ndef at(each, *, kept): self.found = [one for one in each]\n')
    assert {name for _, name in names_given(tree)} & VAGUE == VAGUE
    assert [begins_vaguely(words) for _, words in first_lines(tree)] == [True]
    assert [names for _, names in packed_constants(tree)] == ["(A, B)"]
    assert not begins_vaguely("Wall normal pressure (Pa) at depth z (m).")
    assert begins_vaguely("(depth, height) of a silo.")
