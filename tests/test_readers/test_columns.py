"""Files of columns: equal steps within their print, heads, remarks and units; records and quakes read alike."""

from pathlib import Path

import numpy as np
import pytest

from silostudy.compute.dem_files import quake_steps
from silostudy.errors import BadInput
from silostudy.seismic.readers import read_record
from tests.test_seismic.test_records import written


def table(times, *, decimals=3, form="f"):
    return "".join(f"{time:.{decimals}{form}} {1 + n % 7}\n" for n, time in enumerate(times))


@pytest.mark.parametrize(("dt", "decimals", "form"), [(1 / 128, 3, "f"), (1 / 128, 6, "g"), (1 / 200, 4, "f"), (0.01, 2, "f"),
                                                       (1 / 60, 4, "f"), (0.02, 9, "e"), (1 / 256, 7, "g")])  # fmt: skip
def test_printed_times_are_equal_steps(tmp_path, dt, decimals, form):
    for start in (0.0, 12.0):
        text = table(start + dt * np.arange(6000), decimals=decimals, form=form)
        assert read_record(written(tmp_path, text), "two_columns", "g").dt == pytest.approx(dt, rel=1e-12)


def test_times_summed_in_single_precision(tmp_path):
    times = np.cumsum(np.full(6000, 0.01, dtype=np.float32), dtype=np.float32)
    assert read_record(written(tmp_path, table(times, decimals=7)), "two_columns", "g").dt == pytest.approx(0.01, rel=1e-3)


def spoilt(change):
    times = [f"{n / 100:.2f}" for n in range(100)]
    change(times)
    return "".join(f"{time} {1 + n % 7}\n" for n, time in enumerate(times))


def dropped(times):
    del times[50:52]


def dropped_one(times):
    del times[50]


def shuffled(times):
    times[3], times[70] = times[70], times[3]


def not_a_number(times):
    del times[60:]
    times[49] = "nan"


UNEQUAL = {"reversed": list.reverse, "shuffled": shuffled, "two samples dropped": dropped, "a sample dropped": dropped_one,
           "nan in the times": not_a_number, "one time endless": lambda times: times.__setitem__(9, "1e400")}  # fmt: skip


@pytest.mark.parametrize("name", UNEQUAL)
def test_times_that_are_no_equal_steps(tmp_path, name):
    path = written(tmp_path, spoilt(UNEQUAL[name]))
    with pytest.raises(BadInput, match=r"record\.txt line \d+: time = '[\w.]+': must (rise by equal time steps|be finite)"):
        read_record(path, "two_columns", "g")


def test_a_sample_dropped_among_times_printed_short(tmp_path):
    """1/128 s to three decimals: what the print's rounding excuses is less than a step."""
    times = np.delete(np.arange(600) / 128, 300)
    with pytest.raises(BadInput, match=r"line 301: time = .*must rise by equal time steps"):
        read_record(written(tmp_path, table(times)), "two_columns", "g")


def test_steps_that_change_on_the_way(tmp_path):
    times = np.cumsum(np.r_[np.full(1000, 0.00996), np.full(1000, 0.01004)])
    with pytest.raises(BadInput, match="off a common step"):
        read_record(written(tmp_path, table(times, decimals=6)), "two_columns", "g")


@pytest.mark.parametrize("top", ["# t, a\n", "# t, a\n\n# of a shaking table\n", "t a\n", "", "# t (s), a (gal)\n",
                                 "time_s acceleration_gal\n", "# a [cm/s2]\n"])  # fmt: skip
def test_words_above_the_numbers(tmp_path, top):
    for text in (f"{top}0.0 1.0\n0.1 -2.0 # remark, with a comma\n", f"{top}0.0, 1.0\r\n0.1,\t-2.0\r\n"):
        assert list(read_record(written(tmp_path, text), "two_columns", "gal").acceleration) == [0.01, -0.02]


@pytest.mark.parametrize("top", ["# t (s), a (m/s2)\n", "# t a [g]\n", "time_s,acceleration_m_s2\n", "t_s v_cm_s\n",
                                 "# velocity (cm/s)\n", "# (counts)\n", "time_s a_mm_s2\n"])  # fmt: skip
def test_a_unit_above_the_numbers_that_is_another(tmp_path, top):
    with pytest.raises(BadInput, match=r"acceleration_unit = 'gal': disagrees|it is no acceleration in g, gal, m_s2"):
        read_record(written(tmp_path, f"{top}0.0,1.0\n0.1,2.0\n"), "two_columns", "gal")


def test_times_in_milliseconds(tmp_path):
    for top in ("# t (ms) a\n", "time_ms,a\n"):
        with pytest.raises(BadInput, match="must be in seconds"):
            read_record(written(tmp_path, f"{top}0,1\n10,2\n"), "two_columns", "gal")


@pytest.mark.parametrize("cell", ["1_0", "٣", "0x1p3", "1.5.2", "1e", "--1", "1,5", "1;2", "", "1e400", "9" * 400])
def test_cells_that_are_no_finite_numbers(tmp_path, cell):
    with pytest.raises(BadInput, match=r"record\.txt line 2") as caught:
        read_record(written(tmp_path, f"0.0,1.0\n0.1,{cell}\n0.2,1\n"), "two_columns", "gal")
    assert len(str(caught.value).replace(str(tmp_path), "")) < 250


QUAKE = "time_s,x_m_s2,y_m_s2\n" + "".join(f"{0.01 * n:.2f},{np.sin(n):.4f},{np.cos(n):.4f}\n" for n in range(21))


def quake(folder: Path, text: str, dt=0.005, limit=1.0):
    (folder / "quake.csv").write_text(text)
    return quake_steps("quake.csv", folder, dt=dt, limit=limit)


def test_quake_goes_by_the_names_of_its_columns(tmp_path):
    rows = [line.split(",") for line in QUAKE.splitlines()]
    swapped = "\n".join(f"{y},{t},{x}" for t, x, y in rows)
    right = quake(tmp_path, QUAKE)
    assert np.array_equal(quake(tmp_path, swapped), right)
    assert right[0] == pytest.approx([0, 1])
    assert right[4] == pytest.approx([np.sin(2), np.cos(2)], abs=1e-4)


def test_quake_is_still_before_and_after_its_record(tmp_path):
    late = QUAKE.replace("\n0.", "\n1.")
    steps = quake(tmp_path, late, limit=3.0)
    assert len(steps) == int(1.2 / 0.005) + 2
    assert not steps[:199].any()
    assert steps[201].any()
    assert not steps[-1].any()
    assert len(quake(tmp_path, late, limit=1.05)) == int(1.05 / 0.005) + 2  # no more than the run needs
    with pytest.raises(BadInput, match=r"must begin before the run ends, at 0\.1 s"):
        quake(tmp_path, late, limit=0.1)


QUAKES = {
    "reversed": "\n".join([QUAKE.splitlines()[0], *QUAKE.splitlines()[:0:-1]]),
    "no header": "\n".join(QUAKE.splitlines()[1:]),
    "unknown column": QUAKE.replace("y_m_s2", "z_m_s2"),
    "another unit": QUAKE.replace("x_m_s2", "x_gal"),
    "one way": "time_s,x_m_s2\n0,1\n1,2\n",
    "single row": "\n".join(QUAKE.splitlines()[:2]),
    "header alone": QUAKE.splitlines()[0],
    "empty": "",
    "a gap": "\n".join(line for line in QUAKE.splitlines() if not line.startswith("0.1")),
    "a nan": QUAKE.replace("0.0000", "nan"),
    "beyond all measure": QUAKE.replace("0.0000", "1e30"),
    "binary": "\x00\x01\x02",
}


@pytest.mark.parametrize("name", QUAKES)
def test_quakes_that_are_refused(tmp_path, name):
    with pytest.raises(BadInput, match=r"quake\.csv"):
        quake(tmp_path, QUAKES[name])
