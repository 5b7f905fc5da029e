"""The bar of a run: what its clock counts, and lines beside it."""

from types import SimpleNamespace

import numpy as np
import pytest

from silostudy.commands.progress import progress
from silostudy.dem.pace import FIXED, following
from silostudy.say import say


@pytest.fixture
def task():
    """A run of ten spheres over 1000 steps."""
    model = SimpleNamespace(x=np.zeros(10), dt=1e-3, pace=FIXED)
    engine = SimpleNamespace(model=model, time=0.1, n=10, space=SimpleNamespace(body="sphere"))
    return SimpleNamespace(engine=engine, began=0, last=1000)


def test_the_clock_starts_after_the_compiling(task, capsys):
    shown = progress(task)
    with shown as tell:
        assert capsys.readouterr().err == ""
        tell(200)  # what the first steps took is compiling
        assert capsys.readouterr().err.count("?") == 2  # no rate, no time left
        assert (shown.bar.n, shown.bar.initial, shown.bar.total) == (2000, 2000, 10000)
        tell(400)
    assert shown.bar.n == 4000


def test_steps_that_change_are_counted_in_model_time(task, capsys):
    task.engine.model.pace = following()
    shown = progress(task)
    with shown as tell:
        tell(200)
        tell(400)
    assert shown.bar.n == pytest.approx(0.4)
    assert shown.bar.unit == " s"


def test_a_run_that_stops_before_its_limit_is_done(task, capsys):
    with progress(task) as tell:
        tell(200)
        tell(400)
    assert "100%" in capsys.readouterr().err.split("\r")[-1]


def test_a_run_of_no_step_has_no_bar(task, capsys):
    with progress(task):
        pass
    assert capsys.readouterr().err == ""


def test_a_line_beside_the_bar_stands_on_its_own(task, capsys):
    with progress(task) as tell:
        tell(200)
        capsys.readouterr()
        say("overlaps are deep")
    lines = [line.split("\r")[-1] for line in capsys.readouterr().err.split("\n")]
    assert "silostudy: overlaps are deep" in lines
