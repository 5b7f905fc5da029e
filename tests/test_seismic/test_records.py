"""Records: what the readers accept and refuse, and what is done to a record before it shakes a model."""

import numpy as np
import pytest

from silostudy.errors import BadInput
from silostudy.seismic.readers import read_known, read_record
from silostudy.seismic.records import Record, compressed, in_band, scaled, without_baseline
from silostudy.tables.records import RECORDS
from silostudy.tables.references import cite

AT2 = """PEER NGA STRONG MOTION DATABASE RECORD
SOMEWHERE, A STATION, 90
ACCELERATION TIME SERIES IN UNITS OF G
NPTS=   6, DT=   .0050 SEC
  .1000000E-01  -.2000000E-01   .3000000E-01
  .4000000E-01  -.5000000E-01   .0000000E+00
"""
COLUMNS = "# t (s)  a\n0.00 1.0\n0.02 -2.0\n0.04 3.0\n"


def written(folder, text, name="record.txt"):
    path = folder / name
    path.write_text(text)
    return path


def test_known_record_is_the_real_one():
    """K-NET AKT013: the file's own header says 4.383 gal, once the mean is gone."""
    record = without_baseline(read_known("akt013_1996_ew"), "mean")
    assert (len(record.acceleration), record.dt) == (5900, 0.01)
    assert record.peak == pytest.approx(4.383e-2, rel=2e-4)
    assert cite(RECORDS["akt013_1996_ew"].source)
    assert "AKT013" in record.origin


def test_at2(tmp_path):
    record = read_record(written(tmp_path, AT2), "peer_at2", None)
    assert record.dt == 0.005
    assert record.acceleration == pytest.approx(9.80665 * np.array([0.01, -0.02, 0.03, 0.04, -0.05, 0]), rel=1e-12)


@pytest.mark.parametrize(("unit", "factor"), [("g", 9.80665), ("gal", 0.01), ("m_s2", 1.0)])
@pytest.mark.parametrize("text", [COLUMNS, "0.00,1.0\n0.02,-2.0\n0.04,3.0\n"])
def test_two_columns(tmp_path, unit, factor, text):
    record = read_record(written(tmp_path, text), "two_columns", unit)
    assert record.dt == pytest.approx(0.02)
    assert record.acceleration == pytest.approx(factor * np.array([1.0, -2.0, 3.0]), rel=1e-12)


def test_knet_file_of_a_user(tmp_path):
    from importlib.resources import files

    row = RECORDS["akt013_1996_ew"]
    path = tmp_path / "AKT0139608110312.EW"
    path.write_bytes(files(row.package).joinpath(row.file).read_bytes())
    assert read_record(path, "obspy", None).acceleration == pytest.approx(read_known("akt013_1996_ew").acceleration, rel=1e-12)


def test_other_formats_of_obspy_need_their_unit(tmp_path):
    obspy = pytest.importorskip("obspy")
    path = tmp_path / "trace.mseed"
    obspy.Trace(np.array([1.0, 2.0, -4.0]), {"delta": 0.01}).write(str(path), format="MSEED")
    with pytest.raises(BadInput, match=r"acceleration_unit = None: the file does not say it; one of g, gal, m_s2"):
        read_record(path, "obspy", None)
    assert read_record(path, "obspy", "gal").peak == pytest.approx(0.04)


@pytest.mark.parametrize(
    ("text", "form", "unit", "expected"),
    [
        (COLUMNS, "two_columns", None, "acceleration_unit = None: the file does not say it"),
        ("0.00 1.0\n0.02 2.0\n0.05 3.0\n", "two_columns", "g", "line 3: time = '0.05': must rise by equal time steps"),
        ("0.00 1.0\n0.00 2.0\n", "two_columns", "g", "line 2: time = '0.00': must rise by equal time steps"),
        ("1.0\n2.0\n", "two_columns", "g", "line 1: row = '1.0': must hold the 2 columns time (s), acceleration"),
        ("0.0 1.0\n0.02 x\n", "two_columns", "g", "line 2: acceleration = 'x': must be a number"),
        ("0.0 1.0\n0.02 nan\n", "two_columns", "g", "line 2: acceleration = 'nan': must be finite"),
        ("0.0 1.0\n", "two_columns", "g", "rows = 1: must be two or more"),
        ("", "two_columns", "g", "rows = 0: must be two or more"),
        (AT2.replace("NPTS=   6", "NPTS=   7"), "peer_at2", None, "line 4: NPTS = 7: differs from the 6 values"),
        (AT2.replace("IN UNITS OF G", ""), "peer_at2", None, "must say UNITS OF G"),
        (AT2.replace("DT=", "T="), "peer_at2", None, "must be PEER AT2"),
        (COLUMNS, "obspy", "g", "obspy cannot read it"),
    ],
)
def test_refusals_name_the_file(tmp_path, text, form, unit, expected):
    with pytest.raises(BadInput) as caught:
        read_record(written(tmp_path, text), form, unit)
    assert expected in str(caught.value)
    assert "record.txt" in str(caught.value)


def test_missing_file(tmp_path):
    with pytest.raises(BadInput, match=r"nowhere\.at2"):
        read_record(tmp_path / "nowhere.at2", "peer_at2", None)


def test_treatment():
    t = 0.01 * np.arange(1000)
    record = Record(0.3 + 0.02 * t + np.sin(2 * np.pi * 2 * t) + np.sin(2 * np.pi * 20 * t), 0.01, "test")
    straight = without_baseline(record, "linear")
    assert abs(np.polyfit(t, straight.acceleration, 1)[0]) < 1e-12
    assert compressed(straight, 8).dt == 0.00125
    assert compressed(straight, 8).duration == pytest.approx(record.duration / 8)
    narrow = in_band(straight, 1.0, 5.0)
    inner = slice(200, 800)
    assert narrow.acceleration[inner] == pytest.approx(np.sin(2 * np.pi * 2 * t)[inner], abs=0.05)
    assert scaled(narrow, 2.28).peak == pytest.approx(2.28, rel=1e-12)
    assert "1 to 5 Hz" in scaled(narrow, 2.28).origin
    with pytest.raises(BadInput, match=r"motion.band_Hz = \[1.0, 60.0\]: must be 0 < low < high < 50 Hz"):
        in_band(straight, 1.0, 60.0)
    with pytest.raises(BadInput, match="holds no motion"):
        scaled(Record(np.zeros(5), 0.01, "still"), 1.0)
