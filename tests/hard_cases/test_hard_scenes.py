"""Hard cases as scene files for anybody to run: each comes to what it expects."""

import pytest

from silostudy.choice.dem import load
from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.expected import verdicts
from tests.conftest import ROOT

SCENES = sorted((ROOT / "config/scenes/hard").glob("*.yaml"))


@pytest.mark.long
@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_hard_scenes_come_to_what_they_expect(path):
    scene, _ = load(path)
    run = run_of(scene, scene_model(scene, path.parent))
    run.go()
    assert not run.trouble
    found = verdicts(run, scene)
    assert found
    assert [str(verdict) for verdict in found if not verdict.met] == []
