"""Silos of spheres that are shaken: a record of accelerations moves the box, in all three ways."""

import numpy as np
import pytest

from silostudy.dem.ledger import BASE, TURNOVER, balance
from silostudy.errors import BadInput

from .small import carried, resumed, run, scene_of

STOP = [{"when": "time", "value": 0.002, "do": "stop"}]


def shaken(tmp_path, rows, **changes):
    """The small bin under a record of its own; rows: time, x, y, z."""
    record = tmp_path / "base.csv"
    record.write_text("time_s,x_m_s2,y_m_s2,z_m_s2\n" + "".join(",".join(map(str, row)) + "\n" for row in rows))
    return scene_of(quake={"file": str(record)}, filling={"kind": "loose", "count": 120}, **changes)


def test_what_touches_nothing_stays_behind(tmp_path):
    scene = shaken(tmp_path, [(0, 2.0, -1.0, 0.5), (9, 2.0, -1.0, 0.5)], gravity_m_s2=[0.0, 0.0, 0.0], events=STOP)
    engine = carried(scene).engine
    velocity = np.median(engine.bodies.rows[: engine.n, engine.space.velocity], axis=0)
    assert velocity == pytest.approx(-engine.time * np.array([2.0, -1.0, 0.5]), rel=1e-9)


def rocked(tmp_path, **changes):
    time = np.arange(0.0, 0.3, 0.005)
    rows = np.column_stack([time, 4.0 * np.sin(40.0 * time), np.cos(25.0 * time), 2.0 * np.sin(60.0 * time)])
    return shaken(tmp_path, rows, events=[{"when": "time", "value": 0.25, "do": "stop"}], **changes)


def test_the_energy_of_shaking_is_balanced(tmp_path):
    task = run(rocked(tmp_path, record__energy=True))
    task.go(until=1)
    account = task.engine.ledger.account
    start = balance(account)
    task.go()
    assert abs(account[BASE]) > 1e-3 * account[TURNOVER]
    assert abs(balance(account) - start) < 1e-9 * account[TURNOVER]


def test_a_shaken_run_goes_on_with_its_bits(tmp_path):
    scene = rocked(tmp_path)
    whole = carried(scene)
    other, _ = resumed(scene, whole.engine.step // 2, threads=2)
    count = whole.engine.n
    assert np.array_equal(whole.engine.labels[:count], other.engine.labels[:count])
    assert np.array_equal(whole.engine.bodies.rows[:count, :9], other.engine.bodies.rows[:count, :9])


def test_a_record_in_the_plane_is_refused(tmp_path):
    record = tmp_path / "plane.csv"
    record.write_text("time_s,x_m_s2,y_m_s2\n0,2.0,0\n10,2.0,0\n")
    with pytest.raises(BadInput, match=r"must hold the 4 columns time_s, x_m_s2, y_m_s2, z_m_s2"):
        run(scene_of(quake={"file": str(record)}))
