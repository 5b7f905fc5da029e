"""What a rain of spheres cannot do as its scene says is warned of before it runs, and what it can do is not."""

from math import pi

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.scene.raining import too_fast
from tests.test_spheres.small import carried, content, scene_of

ASIDE = {"filling__count": 60, "filling__width_m": 0.02, "filling__rate_1_s": 100, "silo__filling_eccentricity_m": 0.02}
OPEN = [{"when": "time", "value": 0.05, "do": "open_outlet"}, {"when": "after", "value": 0.15, "do": "stop"}]
FLOWS = [OPEN[0], {"when": "after", "value": 0.7, "do": "stop"}]
REST = [{"when": "rest", "do": "stop"}]


@pytest.mark.parametrize(
    ("changes", "told"),
    [
        ({"filling__count": 640}, "filling.count = 640: fills 0.562 of the room below the plane of the rain, and grains that"),
        ({"filling__count": 600}, ""),
        ({"filling__count": 2000, "filling__rate_1_s": 3000, "events": FLOWS}, ""),
        ({"filling__rate_1_s": 1e7}, "filling.rate_1_s = 1e+07: at most about 3.99e+03 of these spheres a second find room"),
        ({"filling__rate_1_s": 3000}, ""),
        ({"filling__rate_1_s": 1e7, "filling__count": 20}, ""),
        (
            {**ASIDE, "filling__width_m": 0.03},
            "filling.width_m = 0.03: the stream reaches 0.005 m past the wall, which cuts it",
        ),
        (ASIDE, ""),
        ({"filling__rate_1_s": 100, "events": OPEN},
         "filling.rate_1_s = 100: the last sphere comes in at 1.49 s, events.1 stops it at 0.2 s"),
        ({"filling__rate_1_s": 100},
         "filling.rate_1_s = 100: the last sphere comes in at 1.49 s, march.limit_s ends it at 1 s"),
        ({"silo": {"plan": "square", "width_m": 0.06, "cylinder_depth_m": 0.1}, **ASIDE, "filling__width_m": 0.03,
          "events": REST, "record": {}}, "filling.width_m = 0.03: the stream reaches 0.005 m past the wall"),
    ],
    ids=["too many", "not so many", "many, and flowing", "too fast", "not so fast", "all in one layer", "past the wall",
         "at the wall", "stopped before", "ended before", "past a flat wall"],
)  # fmt: skip
def test_a_rain_that_cannot_be_is_warned_of(changes, told, tmp_path, capsys):
    path = tmp_path / "bin.yaml"
    path.write_text(yaml.safe_dump(content(**changes), sort_keys=False))
    assert main(["check", str(path)]) == 0
    lines = [line.strip() for line in capsys.readouterr().out.split("\n") if "warning: filling" in line]
    assert [line[: len(told) + len("warning: ")] for line in lines] == [f"warning: {told}"] * bool(told)


def test_as_many_as_are_told_for_a_second_do_not_come_in():
    """The layer and the time that it takes are the most that a rain comes to."""
    scene = scene_of(filling__count=300, filling__rate_1_s=1e7, events=[{"when": "rest", "do": "stop"}], record=None)
    run = carried(scene)
    last = run.came * run.engine.model.dt
    (told,) = too_fast(scene, pi * 0.03**2, run.engine.model)
    most = float(told.partition("about ")[2].split()[0])
    assert 0.5 * most < run.come / last < most
