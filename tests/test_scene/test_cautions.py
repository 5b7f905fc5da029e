"""Cautions on grains: `check` notes frictions beyond what is known and cells too narrow for their test, and refuses none."""

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.config.load import read_yaml
from silostudy.scene.cautions import HIGH_FRICTION, late_events
from silostudy.scene.scenes import scene_in
from silostudy.tables.materials import PAIRS
from tests.conftest import ROOT


def notes(path, content, capsys):
    """Notes of `check` on a content saved there."""
    path.write_text(yaml.safe_dump(content, sort_keys=False))
    assert main(["check", str(path)]) == 0
    return [line.strip() for line in capsys.readouterr().out.split("\n") if line.strip().startswith("note: ")]


def test_no_row_of_the_tables_is_noted():
    assert max(pair.sliding_friction for pair in PAIRS.values()) < HIGH_FRICTION


@pytest.mark.parametrize(("friction", "told"), [(50.0, ["walls.sliding_friction = 50"]), (1.2, [])])
def test_a_scene_s_high_friction_is_noted(friction, told, tmp_path, capsys):
    content = read_yaml(ROOT / "config/scenes/kiyama-17-18.yaml")
    content["walls"] = content["discs"] | {"sliding_friction": friction}
    found = notes(tmp_path / "scene.yaml", content, capsys)
    assert [note.removeprefix("note: ").split(" is")[0] for note in found] == told


def test_a_study_s_high_friction_is_noted_once(tmp_path, capsys):
    content = read_yaml(ROOT / "config/studies/hopper-of-discs.yaml") | {"codes": None, "outputs": []}
    content["scene"]["walls"]["sliding_friction"] = 50.0
    found = notes(tmp_path / "study.yaml", content, capsys)
    assert found == ["note: scene.walls.sliding_friction = 50 is unusual: grains and walls mostly have less than 1.5"]


@pytest.mark.parametrize(
    ("cells", "height", "count"), [([64, 96], 16, 0), ([63, 96], 8, 1), ([64, 96], 20, 1), ([40, 60], 20, 2)]
)
def test_a_plane_cell_too_narrow_is_noted(cells, height, count, tmp_path, capsys):
    content = read_yaml(ROOT / "config/studies/discs-laboratory.yaml") | {"cells": cells}
    content["scene"]["height_grains"] = height
    found = notes(tmp_path / "study.yaml", content, capsys)
    assert len(found) == count
    for cell, note in zip(cells, found, strict=False):
        assert note.startswith(f"note: a cell of {cell} grains by {height}: narrower than 64 grains or 4 heights")


def at(when, value, do="stop"):
    return {"when": when, "value": value, "do": do}


@pytest.mark.parametrize(
    ("events", "told"),
    [
        (
            [at("time", 0.5, "open_slit"), at("time", 0.1)],
            ["events.1 is told for 0.1 s, and waits for the one before it, at 0.5 s"],
        ),
        ([at("time", 0.5, "open_slit"), at("time", 0.5)], []),
        (
            [at("time", 0.5, "open_slit"), at("after", 9.0)],
            ["events.1 comes at 9.5 s or later: the run ends before, at march.limit_s"],
        ),
        ([at("time", 3.0, "open_slit"), at("after", 1.0)], []),
    ],
)
def test_events_out_of_order_or_beyond_the_limit_are_noted(events, told, tmp_path, capsys):
    content = read_yaml(ROOT / "config/scenes/kiyama-17-18.yaml")
    assert content["march"]["limit_s"] == 4.0
    found = notes(tmp_path / "scene.yaml", content | {"events": events}, capsys)
    assert [note.removeprefix("note: ")[: len(words)] for note, words in zip(found, told, strict=True)] == told


@pytest.mark.parametrize("path", sorted((ROOT / "config/scenes").rglob("*.yaml")), ids=lambda path: path.stem)
def test_no_shipped_scene_has_events_that_cannot_come_as_told(path):
    assert list(late_events(scene_in(path))) == []
