"""Time to an error of means over fillings: how it is read off the measured runs, and that both codes fill and flow alike."""

import numpy as np
import pandas as pd
import pytest

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.accuracy.peers import available
from silostudy.commands import bench_means

FINE, COARSE = 2e-5, 4e-5


def runs(off=1.0, scatter=0.1, cost=(1.0, 8.0)) -> pd.DataFrame:
    """Runs of two codes at two steps: the means at the coarser step are so many times the others, a filling scatters."""
    spread = scatter * np.array([-1.0, 1.0, -1.0, 1.0, -1.0, 1.0]) * np.sqrt(5.0 / 6.0)
    rows = []
    for code, seconds in zip(("17-18", "LAMMPS"), cost, strict=True):
        for dt, mean in ((FINE, 2.0), (COARSE, 2.0 * off)):
            cpu = seconds * FINE / dt
            rows += [{"code": code, "step_s": dt, "force": mean * (1.0 + k), "flow": 1.0, "cpu_s": cpu} for k in spread]
    return pd.DataFrame(rows)


def test_a_mean_costs_as_many_fillings_as_its_scatter_asks_for():
    rows = bench_means.errors(runs(scatter=0.1), "force")
    assert rows["scatter"].to_numpy() == pytest.approx(0.1, rel=0.02)
    assert not rows["surely_off"].any()
    assert [bench_means.fillings_for(rows.iloc[0], asked) for asked in (0.2, 0.051, 0.0201)] == [1, 4, 25]
    assert bench_means.told(rows, 0.051) == (
        "wall force at rest within 5%: 17-18 4 fillings by 4e-05 s in 2 s; LAMMPS 4 fillings by 4e-05 s in 16 s; "
        "LAMMPS takes 8.0 times as long"
    )


def test_a_step_that_is_surely_off_is_not_the_cheapest():
    rows = bench_means.errors(runs(off=1.5, scatter=0.02), "force").set_index(["code", "step_s"])
    assert rows.loc[("17-18", COARSE), "surely_off"] > 0.2
    assert rows.loc[("17-18", FINE), "surely_off"] == 0.0
    assert "by 2e-05 s" in bench_means.told(rows.reset_index(), 0.1)


def test_a_step_that_lost_a_filling_is_left_out():
    lost = runs()
    lost.loc[lost.index[6], "force"] = np.nan
    steps = bench_means.errors(lost, "force").groupby("code")["step_s"].max()
    assert steps.to_dict() == {"17-18": FINE, "LAMMPS": COARSE}


def test_wall_force_is_hertz_force_of_what_touches_the_cylinder():
    model, of = bin_of_spheres(bench_means.BIN), bench_means.BIN
    places, depth = np.c_[model.x, model.y, model.z], 1e-5
    assert bench_means.wall_force(model, places) == 0.0
    places[-1, :2] = 0.0, of.wide - 0.5 * of.diameter + depth
    reduced = 1.0 / (2.0 / of.diameter - 0.5 / of.wide)
    hertz = 4.0 / 3.0 * of.contact_moduli["wall"] * np.sqrt(reduced) * depth**1.5
    assert bench_means.wall_force(model, places) == pytest.approx(hertz, rel=1e-9)
    assert np.isnan(bench_means.wall_force(model, places[1:]))


@pytest.mark.long
@pytest.mark.skipif(bool(available()), reason=available() or "installed")
def test_both_codes_fill_and_flow_alike(monkeypatch):
    monkeypatch.setattr(bench_means, "BIN", Bin(count=500, wide=0.02, outlet=0.024))
    model = bin_of_spheres(bench_means.BIN)
    both = [bench_means.emptied(make, model) for make in (lambda of: bench_means.ours("17-18", of), bench_means.theirs)]
    assert both[0]["force"] == pytest.approx(both[1]["force"], rel=0.3)
    assert both[0]["flow"] == pytest.approx(both[1]["flow"], rel=0.2)
