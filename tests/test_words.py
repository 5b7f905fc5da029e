"""Retired words, of the glossary's last column, stand in no guide, message or figure."""

import ast
import re
from collections.abc import Iterator

from silostudy import PACKAGE
from tests.guides import GUIDES, text_of

GLOSSARY = text_of("silostudy/README.md").split("## The words\n")[1].split("\n## ")[0]
ROWS = [[cell.strip() for cell in line.strip("|").split("|")] for line in GLOSSARY.splitlines() if line.startswith("| ")][1:]
RETIRED = [word.strip() for row in ROWS for word in row[5].split(",") if word.strip()]
CODE = re.compile(r"```.*?```|`[^`]*`", re.DOTALL)
SPOKEN = ("commands", "figures", "note", "explore")  # rooms whose texts people read


def prose() -> Iterator[tuple[str, str]]:
    """(where, text) of all that people read, without code in it."""
    for guide in GUIDES:
        yield guide, CODE.sub(" ", text_of(guide).replace(GLOSSARY, ""))
    for name in ("rules/report.rst", "CHANGELOG.md"):
        yield name, CODE.sub(" ", (PACKAGE / name).read_text())
    for path in (path for room in SPOKEN for path in (PACKAGE / room).rglob("*.py")):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Constant) and isinstance(node.value, str) and " " in node.value:
                yield f"{path.relative_to(PACKAGE)}:{node.lineno}", CODE.sub(" ", node.value)


def test_the_glossary_has_its_terms_once():
    terms = [row[0] for row in ROWS]
    assert len(terms) >= 40
    assert len(set(terms)) == len(terms)
    assert not {term.lower() for term in terms} & {word.lower() for word in RETIRED}


def test_no_retired_word_is_read_anywhere():
    pattern = re.compile(rf"\b({'|'.join(map(re.escape, RETIRED))})\b", re.IGNORECASE)
    found = [(where, match[0]) for where, text in prose() for match in pattern.finditer(" ".join(text.split()))]
    assert found == []


def test_a_retired_word_would_be_found():
    assert {"march", "ledger", "network"} <= set(RETIRED)
    assert any("discrete elements" in text for _, text in prose())
