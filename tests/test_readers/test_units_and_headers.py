"""What a record's file says of itself against what it is told to be: units, steps, length, peak, traces."""

from importlib.resources import files

import numpy as np
import obspy
import pytest

from silostudy.errors import BadInput
from silostudy.seismic.readers import read_record
from silostudy.seismic.records import Record, in_band, scaled, without_baseline
from tests.test_seismic.test_records import AT2, written

KNET = files("obspy").joinpath("io/nied/tests/data/test.knet").read_bytes()
HEADER, SAMPLES = KNET[: KNET.index(b"Memo")].decode(), KNET[KNET.index(b"Memo") :].decode()
VALUES = 9.80665 * np.array([0.01, -0.02, 0.03, 0.04, -0.05, 0])


def refused(path, form, unit, *words, channel=None):
    with pytest.raises(BadInput) as caught:
        read_record(path, form, unit, channel)
    text = str(caught.value)
    assert str(path) in text
    assert "\n" not in text
    for word in words:
        assert word in text


@pytest.mark.parametrize("unit", ["gal", "m_s2"])
def test_at2_in_g_is_not_read_as_another_unit(tmp_path, unit):
    path = written(tmp_path, AT2)
    refused(path, "peer_at2", unit, "line 3", f"acceleration_unit = '{unit}': disagrees with the file, which says g")
    assert read_record(path, "peer_at2", "g").acceleration == pytest.approx(VALUES, rel=1e-12)


@pytest.mark.parametrize("spelled", ["CM/S/S", "CM/SEC**2", "cm/s^2.", "GAL", "CM/SEC/SEC"])
def test_at2_in_gal(tmp_path, spelled):
    path = written(tmp_path, AT2.replace("UNITS OF G", f"UNITS OF {spelled}"))
    for unit in ("gal", None):
        assert read_record(path, "peer_at2", unit).acceleration == pytest.approx(VALUES / 9.80665 / 100, rel=1e-12)
    refused(path, "peer_at2", "g", "which says gal")


@pytest.mark.parametrize("unit", [None, "g", "gal", "m_s2"])
@pytest.mark.parametrize(("line", "word"), [("VELOCITY TIME SERIES IN UNITS OF CM/S", "acceleration"),
                                            ("DISPLACEMENT TIME SERIES IN UNITS OF CM", "acceleration"),
                                            ("ACCELERATION TIME SERIES IN UNITS OF CM/S", "CM/S"),
                                            ("TIME SERIES IN UNITS OF CM", "CM"),
                                            ("TIME SERIES IN UNITS OF FURLONGS", "FURLONGS")])  # fmt: skip
def test_at2_that_holds_no_acceleration(tmp_path, unit, line, word):
    refused(written(tmp_path, AT2.replace("ACCELERATION TIME SERIES IN UNITS OF G", line)), "peer_at2", unit, "line 3", word)


def test_at2_with_its_unit_in_brackets(tmp_path):
    path = written(tmp_path, AT2.replace("IN UNITS OF G", "(CM/S2)"))
    refused(path, "peer_at2", "g", "line 3", "which says gal")
    assert read_record(path, "peer_at2", None).acceleration == pytest.approx(VALUES / 9.80665 / 100, rel=1e-12)


def test_at2_without_a_unit_takes_the_one_told(tmp_path):
    path = written(tmp_path, AT2.replace("IN UNITS OF G", ""))
    assert read_record(path, "peer_at2", "m_s2").acceleration == pytest.approx(VALUES / 9.80665, rel=1e-12)


@pytest.mark.parametrize(("text", "dt"), [("1.E-2", 0.01), ("1.000D-02", 0.01), ("5.E-03", 0.005), (".0050SEC", 0.005),
                                          ("0.02 SEC,", 0.02), (".01, SEC", 0.01), ("+1e-2", 0.01)])  # fmt: skip
def test_at2_step(tmp_path, text, dt):
    assert read_record(written(tmp_path, AT2.replace("   .0050 SEC", f" {text}")), "peer_at2", None).dt == dt


@pytest.mark.parametrize("text", ["1/200", "0,005", ".0000", "0.0", "-0.01", "nan", "inf", "1_0", "1e9", "x", "1.E-2.0"])
def test_at2_step_that_is_none(tmp_path, text):
    refused(written(tmp_path, AT2.replace("   .0050 SEC", f" {text} SEC")), "peer_at2", None)


def test_unlikely_numbers_are_told_with_the_record(tmp_path):
    record = read_record(written(tmp_path, AT2.replace(".0050", "10.0").replace(".1000000E-01", "9999")), "peer_at2", None)
    assert record.origin == "record.txt (unlikely: steps of 10 s and a peak of 9.806e+04 m/s2)"
    assert read_record(written(tmp_path, AT2), "peer_at2", None).origin == "record.txt"


def test_knet_says_gal(tmp_path):
    path = written(tmp_path, HEADER + SAMPLES)
    told, alone = read_record(path, "obspy", "gal"), read_record(path, "obspy", None)
    assert np.array_equal(told.acceleration, alone.acceleration)
    assert without_baseline(told, "mean").peak == pytest.approx(4.383e-2, rel=2e-4)
    for unit in ("g", "m_s2"):
        refused(path, "obspy", unit, f"acceleration_unit = '{unit}': disagrees with the file, which says gal")
    refused(written(tmp_path, HEADER.replace("2000(gal)", "2000(g)") + SAMPLES), "obspy", None, "2000(g)", "must be in gal")


def test_knet_cut_short(tmp_path):
    """800 of 5,900 samples: the header says 59 s of 100 Hz."""
    cut = "\n".join((HEADER + SAMPLES).splitlines()[:117]) + "\n"
    refused(written(tmp_path, cut), "obspy", None, "says 59 s of 100 Hz, 5900 samples; the file holds 800")
    relabelled = cut.replace("Duration Time(s)  59", "Duration Time(s)  8")
    refused(written(tmp_path, relabelled), "obspy", None, "Max. Acc. = 4.383", "the samples have 0.05083")


def test_byte_order_marks(tmp_path):
    plain = read_record(written(tmp_path, HEADER + SAMPLES), "obspy", None)
    assert np.array_equal(
        read_record(written(tmp_path, "\ufeff" + HEADER + SAMPLES), "obspy", None).acceleration, plain.acceleration
    )
    assert read_record(written(tmp_path, "\ufeff0.0,1.0\n0.1,2.0\n"), "two_columns", "g").dt == 0.1
    assert read_record(written(tmp_path, "\ufeff" + AT2), "peer_at2", None).dt == 0.005


def stream(*channels, dtype=float):
    samples = [np.array([1.0, 2.0, -4.0 * (n + 1)]).astype(dtype) for n in range(len(channels))]
    headers = [{"delta": 0.01, "station": "AAA", "channel": channel} for channel in channels]
    return obspy.Stream(map(obspy.Trace, samples, headers))


def test_a_trace_is_chosen_by_its_channel(tmp_path):
    path = tmp_path / "three.mseed"
    stream("HNE", "HNN", "HNZ").write(str(path), format="MSEED")
    refused(path, "obspy", "gal", "channel = None: must name one trace", ".AAA..HNE, .AAA..HNN, .AAA..HNZ")
    refused(path, "obspy", "gal", "channel = 'HN2'", ".AAA..HNE", channel="HN2")
    for channel in ("HNN", ".AAA..HNN"):
        assert read_record(path, "obspy", "gal", channel).peak == pytest.approx(0.08)


def test_a_trace_with_a_gap(tmp_path):
    path, pieces = tmp_path / "gap.mseed", stream("HNE", "HNE")
    pieces[1].stats.starttime += 10
    pieces.write(str(path), format="MSEED")
    refused(path, "obspy", "gal", "one gapless trace, not 2 pieces", channel="HNE")


def test_counts_are_no_unit(tmp_path):
    path = tmp_path / "counts.mseed"
    stream("HNE", dtype="int32").write(str(path), format="MSEED")
    refused(path, "obspy", "gal", "counts of a digitiser")


def test_a_velocity_by_its_sac_header(tmp_path):
    path = tmp_path / "trace.sac"
    trace = stream("HNE", dtype="float32")[0]
    trace.stats.sac = {"idep": 7}
    trace.write(str(path), format="SAC")
    refused(path, "obspy", "gal", "idep = 7", "a velocity")


def test_nothing_in_a_file_is_run(tmp_path):
    """obspy looks for pickled streams by unpickling them; and a name with brackets is no pattern."""
    path = tmp_path / "stream[1].pickle"
    stream("HNE").write(str(path), format="PICKLE")
    refused(path, "obspy", "gal", "none of its formats")
    path = tmp_path / "trace[1].mseed"
    stream("HNE").write(str(path), format="MSEED")
    assert read_record(path, "obspy", "gal").peak == pytest.approx(0.04)


@pytest.mark.parametrize("baseline", ["none", "mean", "linear"])
def test_a_flat_record_is_refused(tmp_path, baseline):
    flat = "".join(f"{0.01 * n:.2f} 0.1\n" for n in range(2000))
    refused(written(tmp_path, flat), "two_columns", "g", "holds no motion")
    with pytest.raises(BadInput, match="holds no motion"):
        scaled(without_baseline(Record(np.zeros(100), 0.01, "still"), baseline), 2.0)


def test_what_a_baseline_or_a_filter_leaves_of_nothing_is_refused():
    """Rounding is no motion: scaled to a peak, 0.1 g throughout became a steady -2 m/s2."""
    ramp = Record(0.3 + 0.1 * np.arange(2000), 0.01, "ramp")
    with pytest.raises(BadInput, match="holds no motion any more"):
        without_baseline(ramp, "linear")
    with pytest.raises(BadInput, match="holds no motion any more"):
        without_baseline(Record(np.full(2000, 0.98), 0.01, "flat"), "mean")
    with pytest.raises(BadInput, match="holds no motion any more"):
        in_band(Record(np.full(2000, 0.98), 0.01, "flat"), 1.0, 5.0)
    assert without_baseline(ramp, "mean").peak > 90


def test_folder_in_place_of_a_file(tmp_path):
    for form in ("two_columns", "peer_at2", "obspy"):
        refused(tmp_path, form, "g", "must be a readable file")
