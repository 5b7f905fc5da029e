"""Which discs went over the walls of a silo, and which through its slit, where lines outside carry them on."""

import pytest

from silostudy.dem.engine import Engine
from silostudy.dem.leaving import Over, below
from silostudy.dem.model import Wall
from silostudy.dem.pieces import Laws

from .scenes import RADIUS, contact, free
from .small import carried, scene_of
from .test_lines import WEIGHT, line

CHUTE = {"kind": "line", "name": "chute", "ends_m": [[0.0, -0.1], [0.3, -0.3]]}


def test_what_a_chute_carries_beside_the_silo_came_through_the_slit():
    events = [{"when": "time", "value": 0.05, "do": "open_slit"}, {"when": "after", "value": 0.8, "do": "stop"}]
    run = carried(scene_of(inserts=[CHUTE], events=events, record=None))
    left = run.recording.left
    assert left["spilt"] == 0
    assert left["discharged"] > 1
    assert run.engine.n == len(run.engine.model.x) - left["discharged"]


def test_what_went_over_a_wall_is_known_wherever_a_line_carries_it():
    """Two discs over a base that is wider than the silo: the one came down beside it, the other inside."""
    walls = (Wall("floor", (0.0, 0.0), (0.2, 0.0)), line("base", (-0.5, -0.1), (0.7, -0.1)))
    engine = Engine(free([-0.03, 0.1, 0.15], [0.1, -0.02, 0.1], gravity=WEIGHT, walls=walls, dt=1e-5))
    over = Over(engine)
    order = engine.labels.copy()
    height, across = engine.column(engine.space.place[1]), engine.column(engine.space.place[0])
    over.look(engine)
    assert not over.went.any()  # the one is still above the floor
    height[order == 0] = -0.02
    over.look(engine)
    across[:] = 0.5
    height[:] = -0.05
    over.look(engine)
    assert over.went.tolist() == [True, False, True]


@pytest.mark.parametrize(
    ("cohesion", "gone"), [("none", [False] * 4 + [True]), ("constant-pull", [True, True, False, False, True])]
)
def test_clumps_of_cohesive_discs_leave_as_a_whole(cohesion, gone):
    """A pair in touch below the outlet, a pair of which the upper is still in it, and a single disc."""
    sticky = contact(laws=Laws.of(cohesion=cohesion), **({"pull": 1.0} if cohesion != "none" else {}))
    low, gap = -3.0 * RADIUS, 1.99 * RADIUS
    places = [(0.0, low), (gap, low), (10.0 * RADIUS, low), (10.0 * RADIUS, low + gap), (20.0 * RADIUS, low)]
    engine = Engine(free(*zip(*places, strict=True), pair_contact=sticky))
    mask = below(engine, -0.5 * RADIUS)
    assert [bool(mask[list(engine.labels).index(label)]) for label in range(5)] == gone
