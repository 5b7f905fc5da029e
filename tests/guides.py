"""What the guides show: their fenced blocks by language and mark, and the commands in blocks and in running text."""

import re
import shlex
from collections.abc import Iterator
from typing import NamedTuple

from tests.conftest import ROOT

GUIDES = (
    "README.md",
    "config/README.md",
    "config/scenes/hard/README.md",
    "silostudy/README.md",
    "results/README.md",
    "results/findings.md",
    "tests/README.md",
)
BLOCK = re.compile(r"(?:<!-- ([^\n]*) -->\n)?```(\w+)\n(.*?)```", re.DOTALL)
INLINE = re.compile(r"`((?:uv run |silostudy |snakemake )[^`]*)`")


class Block(NamedTuple):
    """A fenced block: the mark in the comment above it (empty where there is none), its language, its text."""

    mark: str
    language: str
    text: str


def text_of(guide: str) -> str:
    """The text of a guide."""
    return (ROOT / guide).read_text(encoding="utf-8")


def blocks(guide: str, language: str) -> list[Block]:
    """The blocks of a guide in one language."""
    found = (Block(*groups) for groups in BLOCK.findall(text_of(guide)))
    return [block for block in found if block.language == language]


def commands(guide: str) -> Iterator[list[str]]:
    """The words of every command that a guide names, in blocks and in running text, from `silostudy` or `snakemake` on."""
    shown = [line for language in ("bash", "console") for block in blocks(guide, language) for line in block.text.splitlines()]
    lines = [line.removeprefix("$ ") for line in shown if line.startswith(("$ ", "uv ", "silostudy ", "snakemake "))]
    for line in (*lines, *INLINE.findall(BLOCK.sub("", text_of(guide)))):
        words = shlex.split(" ".join(line.split()), comments=True)
        yield words[next((k for k, word in enumerate(words) if word in ("silostudy", "snakemake", "pytest")), 0) :]
