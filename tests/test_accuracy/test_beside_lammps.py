"""Time to an accuracy beside LAMMPS: how the answer is read off the measured rows, and that both codes press alike."""

import numpy as np
import pandas as pd
import pytest

from silostudy.accuracy.peers import available
from silostudy.accuracy.silo import silo_of_rows, wall_force
from silostudy.commands import bench_accuracy
from silostudy.dem.engine import Engine

ROWS = pd.DataFrame(
    [
        ("17-18", 4e-5, 0.3, 1.0), ("17-18", 2e-5, 0.04, 2.0), ("17-18", 1e-5, 0.03, 4.0),
        ("LAMMPS", 4e-5, 0.04, 8.0), ("LAMMPS", 2e-5, 0.2, 16.0), ("LAMMPS", 1e-5, 0.03, 32.0),
    ],
    columns=["code", "step_s", "error", "cpu_s"],
)  # fmt: skip


def test_a_lucky_step_does_not_count_where_finer_ones_miss():
    assert bench_accuracy._told(ROWS, 0.05).endswith("LAMMPS takes 16.0 times as long")
    assert bench_accuracy._told(ROWS, 0.25).endswith("LAMMPS takes 4.0 times as long")
    assert bench_accuracy._told(ROWS, 0.001).count("not reached") == 2


def test_a_step_that_ran_away_reaches_nothing():
    lost = pd.concat([ROWS, pd.DataFrame([("17-18", 8e-5, np.nan, 0.5)], columns=ROWS.columns)], ignore_index=True)
    assert bench_accuracy._told(lost, 0.4).startswith("40%: 17-18 at 4e-05")


def test_wall_force_from_overlaps_is_the_contacts():
    model, _ = silo_of_rows(8, 12)
    engine = Engine(model)
    engine.step_to(24000)
    found = bench_accuracy._wall_force(model, engine.places)
    exact = wall_force(engine, bench_accuracy.PARTS)
    assert np.abs(found - exact).max() < 1e-6 * exact.max()
    assert np.isnan(bench_accuracy._wall_force(model, engine.places[:-1])).all()


@pytest.mark.skipif(bool(available()), reason=available() or "installed")
def test_lammps_presses_alike():
    model, _ = silo_of_rows(8, 12)
    ours, _ = bench_accuracy._ours("velocity-verlet", model, 1e-5)
    theirs, spent = bench_accuracy._lammps(model, 1e-5)
    assert spent > 0
    assert theirs.sum() == pytest.approx(ours.sum(), rel=0.25)
    assert np.abs(theirs[0] - theirs[1]).max() < 1e-6 * theirs.max()  # the packing is symmetric
