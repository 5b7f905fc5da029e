"""Cautions on grains: `check` notes frictions beyond what is known and cells too narrow for their test, and refuses none."""

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.config.load import read_yaml
from silostudy.scene.cautions import HIGH_FRICTION
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
