"""The table of two codes' discharges from the same fillings."""

import numpy as np
import pytest

from silostudy.commands.bench_discharge import TIMES, table


def test_means_scatter_and_difference_of_pairs():
    ours = np.array([[900, 800, 700, 600, 500, 400], [904, 808, 712, 616, 520, 424]])
    rows = table({"silostudy": ours, "LAMMPS": ours - np.array([[2], [4]])})
    assert [row["time_s"] for row in rows] == pytest.approx(TIMES.tolist())
    last = rows[-1]
    assert (last["silostudy_left"], last["LAMMPS_left"]) == (412.0, 409.0)
    assert last["silostudy_deviation"] == pytest.approx(np.sqrt(2.0) * 12.0)
    assert last["mean_difference"] == 3.0
    assert last["its_standard_error"] == pytest.approx(1.0)  # differences 2 and 4: the pairs count, not the fillings


def test_alone_there_is_no_difference():
    assert "mean_difference" not in table({"silostudy": np.ones((3, len(TIMES)))})[0]
