"""What a scene of spheres costs before it runs: measured on a sample of its spheres that steps the same kernel."""

from dataclasses import replace

import numpy as np
import pytest

from silostudy.accuracy.sample_of_spheres import SAMPLE, sample
from silostudy.commands.explain_scene import run_cost, scene_explanation
from silostudy.compute.dem import scene_model
from tests.conftest import ROOT
from tests.test_spheres.small import scene_of


@pytest.mark.long
def test_a_sample_steps_the_kernel_of_its_scene():
    many = {"sizes": {"kind": "uniform", "least_mm": 3, "largest_mm": 4}, "filling__count": 3000, "filling__rate_1_s": 3e4}
    model = scene_model(scene_of(**many), ROOT)
    few = sample(model)
    assert few.pieces == model.pieces
    assert len(few.x) == SAMPLE
    assert few.waiting == 0
    assert few.radius.mean() == pytest.approx(model.radius.mean(), rel=0.01)
    gaps = np.linalg.norm(few.place[:300, None] - few.place[None, :300], axis=2) - few.radius[:300, None] - few.radius[:300]
    assert gaps[~np.eye(300, dtype=bool)].min() > 0.0


@pytest.mark.long
def test_the_cost_of_a_run_is_bodies_times_steps():
    scene = scene_of(events=[{"when": "time", "value": 0.5, "do": "stop"}])
    model = replace(scene_model(scene, ROOT), dt=1e-5)
    told = run_cost(scene, model, 40e-9, 700.0)
    assert told.startswith("at most 50,000 steps of 150 spheres, 40.0 ns each here and now: about 0.3 s of one core")
    assert told.endswith("700 bytes a sphere, 0.105 MB")


@pytest.mark.long
def test_a_scene_tells_its_cost():
    told = "\n".join(scene_explanation(str(ROOT / "config/scenes/wheat-bin.yaml")))
    assert "steps of 7,000 spheres" in told
    assert "ns each here and now" in told
