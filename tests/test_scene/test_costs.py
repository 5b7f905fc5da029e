"""Words for computing times."""

import pytest

from silostudy.choice.dem import load
from silostudy.choice.expand import expand_file
from silostudy.scene.costs import SETTLES, START, cost, told_time, until_end
from silostudy.scene.scenes import SceneCase
from tests.conftest import ROOT


@pytest.mark.parametrize(
    ("seconds", "told"),
    [(0.3, "0.3 s"), (90.0, "1.5 min"), (7140.0, "119 min"), (7200.0, "2.0 h"), (15000.0, "4.2 h"), (3.6e5, "100.0 h")],
)
def test_computing_times_are_told_in_seconds_minutes_and_from_two_hours_on_in_hours(seconds, told):
    assert told_time(seconds) == told


def test_a_rain_of_grains_rests_soon_after_its_end_and_is_half_there_before():
    """13,800 grains at 10,000 a second, then half a second of flow; the limit of 6 s is far."""
    case = expand_file(ROOT / "config/studies/silo-of-spheres-eccentric.yaml").cases[0].scene
    whole, full = until_end(case.config)
    assert whole == pytest.approx(1.38 + SETTLES + 0.5)
    assert full == pytest.approx(0.69 + SETTLES + 0.5)
    slow = case.config.model_copy(update={"filling": case.config.filling.model_copy(update={"rate_1_s": 1000.0})})
    assert until_end(slow) == (6.0, pytest.approx(3.0))


def test_a_scene_without_a_rain_may_take_to_its_limit():
    case = expand_file(ROOT / "config/studies/discharge-slit.yaml").cases[0].scene
    assert len(set(until_end(case.config))) == 1
    assert cost(case) > 0.0


@pytest.mark.parametrize("name", ["kiyama-17-18", "wheat-bin"])
def test_a_time_goes_with_the_step(name):
    """With the step that a scene's model has where it is known, else with the share of the usual one that is asked for."""
    scene, _ = load(ROOT / f"config/scenes/{name}.yaml")
    fine = scene.model_copy(update={"march": scene.march.model_copy(update={"step_factor": 0.01})})
    whole, longer = (SceneCase(of, ROOT / "config/scenes") for of in (scene, fine))
    assert cost(longer) - START == pytest.approx(100.0 * (cost(whole) - START))
    assert cost(whole, 1e-7) - START == pytest.approx(10.0 * (cost(whole, 1e-6) - START))
