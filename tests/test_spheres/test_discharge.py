"""The table of two codes' discharges from the same fillings."""

import numpy as np
import pytest

from silostudy.__main__ import main
from silostudy.accuracy.bin_of_spheres import bin_silo
from silostudy.commands.bench_discharge import SILOS, table

(SMALL,) = SILOS["small"]


def test_means_scatter_and_difference_of_pairs():
    ours = np.array([[900, 800, 700, 600, 500, 400], [904, 808, 712, 616, 520, 424]])
    rows = table(SMALL, {"silostudy": ours, "LAMMPS": ours - np.array([[2], [4]])})
    assert [row["time_s"] for row in rows] == pytest.approx(SMALL.times.tolist())
    last = rows[-1]
    assert (last["silostudy_left"], last["LAMMPS_left"]) == (412.0, 409.0)
    assert last["silostudy_deviation"] == pytest.approx(np.sqrt(2.0) * 12.0)
    assert last["mean_difference"] == 3.0
    assert last["its_standard_error"] == pytest.approx(1.0)  # differences 2 and 4: the pairs count, not the fillings


def test_alone_there_is_no_difference():
    assert "mean_difference" not in table(SMALL, {"silostudy": np.ones((3, len(SMALL.times)))})[0]


def test_an_unknown_silo_is_one_line(capsys):
    assert main(["bench", "discharge", "--silo", "large"]) == 2
    assert "--silo = 'large': unknown; known: small, benchmark-8mm, benchmark" in capsys.readouterr().err


def test_the_benchmark_keeps_its_mass_and_its_silo():
    """Whatever the spheres' size, as much of them; the walls begin where the published cone of 45 degrees ends."""
    for published, reduced in zip(SILOS["benchmark"], SILOS["benchmark-8mm"], strict=True):
        assert published.name == reduced.name
        assert published.bin.count * published.bin.diameter**3 == pytest.approx(reduced.bin.count * reduced.bin.diameter**3)
        assert published.bin.spheres.modulus == pytest.approx(500.0 * reduced.bin.spheres.modulus)
    first, second, *_ = SILOS["benchmark"]
    heights = [bin_silo(case.bin, case.bin.high).bottom for case in (first, second)]
    assert heights == pytest.approx([0.0145778 + 0.0554222, 0.0207 + 0.0593008], abs=2e-4)
    assert bin_silo(first.bin, first.bin.high).top - heights[0] == pytest.approx(0.3)


def test_a_wall_of_other_material_has_its_own_modulus():
    (small,), (first, *_) = SILOS["small"], SILOS["benchmark"]
    assert small.bin.contact_moduli["pair"] == small.bin.contact_moduli["wall"]
    assert first.bin.contact_moduli["wall"] / first.bin.contact_moduli["pair"] == pytest.approx(2.0 / (1.0 + 1.0 / 210.0))
