"""What a bench prints: counts in all their digits, since a code differs from another by a few in ten thousand."""

from silostudy.commands.bench_dem import show


def test_counts_keep_their_digits_and_rates_do_not(tmp_path, capsys):
    show([{"left": 12264.3, "rate": 3.21987e6, "ratio": 1.23456}], tmp_path / "bench.csv")
    assert capsys.readouterr().out.split() == ["left", "rate", "ratio", "12264", "3.22e+06", "1.235"]
