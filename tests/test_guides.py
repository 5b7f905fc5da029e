"""The guides keep to their length, their links lead somewhere, and their commands and examples work."""

import contextlib
import io
import json
import re
from pathlib import Path
from typing import Any

import pytest
import yaml

from silostudy.__main__ import main, parser
from silostudy.choice.expand import expand
from silostudy.config.grain_scenes import scene_class
from silostudy.config.load import own_validated, read_yaml, study_of
from silostudy.config.schema import study_schema
from silostudy.stages import KINDS
from tests.conftest import ROOT
from tests.guides import GUIDES, blocks, commands, text_of

PLACEHOLDER = re.compile(r"[A-Z]+(\.\w+)?|\.\.\.|<.*>")
COMMANDS = [(guide, words) for guide in GUIDES for words in commands(guide)]
IDS = [" ".join(words) for _, words in COMMANDS]
EXAMPLES = [(guide, block) for guide in GUIDES for block in blocks(guide, "yaml")]
SHOWN = [block.text for guide in GUIDES for block in blocks(guide, "console")]


@pytest.fixture
def folder(tmp_path, monkeypatch) -> Path:
    """An empty folder with the project's configuration, in which commands may write."""
    (tmp_path / "config").symlink_to(ROOT / "config")
    monkeypatch.chdir(tmp_path)
    return tmp_path


def test_the_readme_is_short():
    assert len(text_of("README.md").split()) <= 900


@pytest.mark.parametrize("guide", GUIDES)
def test_links_lead_to_files_and_headings(guide):
    for place, heading in re.findall(r"\]\(([^)#:]*)(?:#([^)]*))?\)", text_of(guide)):
        target = (ROOT / guide).parent / place if place else ROOT / guide
        assert target.exists(), (guide, place)
        headings = re.findall(r"^#+ (.*)$", target.read_text(encoding="utf-8"), re.MULTILINE) if heading else []
        assert not heading or heading in {re.sub(r"[^\w -]", "", line.lower()).replace(" ", "-") for line in headings}


@pytest.mark.parametrize("guide", GUIDES)
def test_files_that_are_named_exist(guide):
    for name in re.findall(r"`((?:config|silostudy|tests)/[\w./-]*)`", text_of(guide)):
        assert (ROOT / name).exists() or (ROOT / "silostudy" / name).exists(), (guide, name)


def understood(arguments: list[str]) -> str:
    """What the command line says against some arguments; empty where it takes them.  A command alone is asked for its help."""
    with contextlib.redirect_stderr(io.StringIO()) as said, contextlib.redirect_stdout(io.StringIO()):
        try:
            parser().parse_args(arguments if arguments[1:] else [*arguments, "--help"])
        except SystemExit as ended:
            return said.getvalue() or str(ended.code or "")
    return ""


@pytest.mark.parametrize(("guide", "words"), COMMANDS, ids=IDS)
def test_commands_are_understood(guide, words):
    program, *arguments = words
    assert program != "silostudy" or not understood([word for word in arguments if word != "..."])
    named = [word.removeprefix("project=") for word in arguments if word.startswith(("project=", "config/", "tests/"))]
    assert not [name for name in named if not (ROOT / name).exists()], guide
    assert "--report" not in arguments or "--cores" in arguments, "snakemake asks for cores even there"


@pytest.mark.long
@pytest.mark.parametrize(("guide", "words"), COMMANDS, ids=IDS)
def test_questions_are_answered(folder, guide, words):
    if words[:2] in (["silostudy", "explain"], ["silostudy", "list"]) and not any(map(PLACEHOLDER.fullmatch, words)):
        assert main(words[1:]) == 0


@pytest.mark.long
@pytest.mark.parametrize("text", SHOWN)
def test_commands_print_what_is_shown(folder, capsys, text):
    """Each line below a command is printed by it, in this order; `...` stands for lines, or the end of one, left out."""
    for call in re.split(r"^\$ uv run silostudy ", text, flags=re.MULTILINE)[1:]:
        command, *shown = call.splitlines()
        assert main(command.split()) == 0
        printed = iter(capsys.readouterr().out.splitlines())
        for line in shown:
            assert any(words.startswith(line.removesuffix("...")) for words in printed) or line == "...", command


def merged(base: Any, change: Any) -> Any:
    """A content with a fragment laid over it, section by section; one of another kind or plan takes the section's place."""
    if not (isinstance(base, dict) and isinstance(change, dict)):
        return change
    if any(base.get(name) != change[name] for name in ("kind", "plan") if name in change):
        return change
    return base | {key: merged(base.get(key), value) for key, value in change.items()}


@pytest.mark.parametrize(("guide", "block"), EXAMPLES, ids=[block.mark or block.text[:30] for _, block in EXAMPLES])
def test_examples_are_sound(tmp_path, guide, block):
    """A whole study or scene, or a fragment whose mark says into which file it goes: `into config/scenes/drum.yaml`."""
    content, where = yaml.safe_load(block.text), tmp_path / "example.yaml"
    for table in blocks(guide, "csv"):
        (tmp_path / table.mark).write_text(table.text)
    if block.mark:
        assert block.mark.startswith("into "), guide
        where = ROOT / block.mark.removeprefix("into ")
        content = merged(read_yaml(where), content)
    if content.get("kind", "dem") in KINDS:
        study = study_of(content, guide, where.parent)
        assert block.mark or expand(content, "example", guide, where.parent).cases, study
    else:
        own_validated(scene_class(content, guide), content, guide, where.parent)


def keys(content: Any) -> set[str]:
    """Every key in a content, however deep, and the parts of dotted ones."""
    inner = content.values() if isinstance(content, dict) else content if isinstance(content, list) else ()
    own = {part for key in content for part in str(key).split(".")} if isinstance(content, dict) else set()
    return own.union(*map(keys, inner))


def known_keys(schema: Any) -> set[str]:
    """The keys that a JSON schema knows, however deep."""
    inner = schema.values() if isinstance(schema, dict) else schema if isinstance(schema, list) else ()
    own = (
        set(schema["properties"])
        if isinstance(schema, dict) and schema.get("type") == "object" and "properties" in schema
        else set()
    )
    return own.union(*map(known_keys, inner))


def test_every_key_has_an_example():
    files = [read_yaml(path) for path in (ROOT / "config").rglob("*.yaml")]
    shown = keys([*files, *(yaml.safe_load(block.text) for _, block in EXAMPLES)])
    assert known_keys(json.loads(study_schema())) - shown == set()
