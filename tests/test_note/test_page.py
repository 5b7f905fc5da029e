"""The calculation note: a dozen of its numbers by hand, what it says of itself, and what the command says of bad input."""

import re
from math import asin, atan, cos, degrees, exp, pi, radians, sin, sqrt, tan

import pytest
import yaml

from silostudy.__main__ import main
from silostudy.cube.silos import at_silo, named, silos
from silostudy.note.page import chapters, page
from silostudy.tables.outputs import files_of
from tests.conftest import ROOT
from tests.test_note.silos import cubes as cubes_of

STUDY = ROOT / "config/studies/steel-wheat-checks.yaml"


@pytest.fixture(scope="module")
def cubes():
    return cubes_of("slender")


@pytest.fixture(scope="module")
def html(cubes):
    return page(*cubes, silos(cubes[0])[0])


@pytest.fixture(scope="module")
def blocks(cubes):
    """Heading of a block -> its lines by name."""
    pressure, checks = (at_silo(cube, silos(cube)[0]).sel(pressure_method="en1991_4") for cube in cubes)
    found = [block for chapter in chapters(pressure, checks, "en1991_4") for block in chapter.blocks]
    return {block.heading: {one.line.name: one for one in block.lines} for block in found}


# the silo and the solid as the study and Table E.1 have them
D, H, R, BETA = 6.0, 18.0, 1.5, radians(30)
GAMMA, PHI, MU, MU_H, K = 9e3, radians(30), 0.38, 0.24, 0.54
A_PHI, A_MU, A_K, C_OP = 1.12, 1.16, 1.11, 0.5
F_Y, E, Q = 235e6, 210e9, 25.0


def janssen(z, mu, k):
    """(wall pressure, vertical pressure (Pa), friction summed up (N/m)) by Janssen."""
    z_o = R / (k * mu)
    full = 1 - exp(-z / z_o)
    return GAMMA * R / mu * full, GAMMA * z_o * full, GAMMA * R * (z - z_o * full)


def by_hand():
    """(heading, name) -> value in SI, each worked out here from the study's numbers alone."""
    lower, upper = (MU / A_MU, K * A_K), (MU * A_MU, K * A_K)
    p_hf, n_zf = janssen(H, *lower)[0], janssen(H, *upper)[2]
    p_vft = janssen(H, MU / A_MU, K / A_K)[1]
    z_p = min(R / (lower[0] * lower[1]), H / 2)
    c_pe = 2 * 0.21 * C_OP * (1 - exp(-1.5 * (H / D - 1)))
    force = pi / 2 * (pi * D / 16) * D * c_pe * 1.15 * janssen(z_p, *lower)[0]
    mu_e, phi_e = MU_H / A_MU, PHI * A_PHI
    turn = atan(mu_e) + asin(sin(atan(mu_e)) / sin(phi_e))
    ratio = (1 + sin(phi_e) * cos(turn)) / (1 - sin(phi_e) * cos(2 * BETA + turn))
    n = 2 * (ratio * (1 + mu_e / tan(BETA)) - 1)
    height, outlet = D / 2 / tan(BETA), 0.3 / tan(BETA)
    x = (height + outlet) / 2
    p_x = GAMMA * height / (n - 1) * (x / height - (x / height) ** n) + p_vft * (x / height) ** n
    hoop = 1.5 * ratio * p_vft * D / 2 / cos(BETA)
    k_w = 0.65
    return {
        ("After filling, at the foot of the wall", "p_hf"): p_hf,
        ("In discharge", "p_he"): 1.15 * p_hf,
        ("In discharge", "n_ze"): 1.1 * n_zf,
        ("Load on hopper or bottom", "p_vft"): p_vft,
        ("Patch load, discharge", "F_pe"): force,
        ("Hopper, discharge", "F_e"): ratio,
        ("Hopper, discharge", "p_ne"): ratio * p_x,
        ("Strake 1, governing check in full: external pressure, combination WE", "p_n__Ed"): k_w * 1.5 * 900 + 1.5 * 500,
        ("Hopper hoop, combination D", "n_theta"): hoop,
        ("Hopper hoop, combination D", "U"): hoop / 0.007 / F_Y,
    }


@pytest.mark.parametrize("place", by_hand(), ids=lambda place: f"{place[0].split(',')[0]}-{place[1]}")
def test_a_number_of_the_note_by_hand(blocks, html, place):
    one = blocks[place[0]][place[1]]
    assert one.result == pytest.approx(by_hand()[place], rel=1e-6)
    assert f"<mn>{one.shown}</mn>" in html


def test_axial_buckling_by_hand(blocks):
    """EN 1993-4-1 from the force and both pressures that the note shows."""
    block = blocks["Strake 2, governing check in full: axial buckling, EN 1993-4-1 on 1-6:2007, combination WF"]
    force, low, high = (block[name].result for name in ("n_x__Ed", "p_s", "p_g"))
    t, r = 0.005, 3.0025
    critical = 0.605 * E * t / r
    alpha = 0.62 / (1 + 1.91 * (sqrt(r / t) / Q) ** 1.44)
    p_s, p_g, lam, s = low * r / t / critical, high * r / t / critical, sqrt(F_Y / critical), r / t / 400
    helped = alpha + (1 - alpha) * p_s / (p_s + 0.3 / sqrt(alpha))
    foot = (1 - (p_g / lam**2) ** 2) * (1 - 1 / (1.12 + s**1.5)) * (s**2 + 1.21 * lam**2) / (s * (s + 1))
    assert lam > sqrt(min(helped, foot) / 0.4)  # elastic
    strength = min(helped, foot) * critical / 1.1
    assert block["sigma_x__Rd"].result == pytest.approx(strength, rel=1e-9)
    assert block["U"].result == pytest.approx(force / t / strength, rel=1e-9)


def test_ring_beam_and_anchors_by_hand(blocks):
    beam, anchors, ring = (
        blocks[f"{name}, combination {key}"] for name, key in (("Ring beam", "WF"), ("Anchors", "WE"), ("Transition ring", "D"))
    )
    half = pi / 8
    assert beam["M_s"].result == pytest.approx(beam["q_Ed"].result * 9 * (1 - half / tan(half)), rel=1e-12)
    wind = 1.5 * 0.7 * 900 * 6 * 18**2 / 2 / (pi * 9)
    moment, weight = wind * pi * 9, (anchors["g_d"].result - anchors["n_k"].result) * pi * 6
    assert anchors["F_Ed"].result == pytest.approx((4 * moment / 6.2 - weight) / 24, rel=1e-9)
    assert ring["N_Ed"].result == pytest.approx(ring["n_phi"].result * 3 * 0.5, rel=1e-12)


def test_what_governs_is_what_the_summary_says(blocks, cubes, html):
    checks = at_silo(cubes[1], silos(cubes[1])[0]).sel(pressure_method="en1991_4").isel(rule=0)
    for strake in (1, 2, 3):
        (block,) = (lines for heading, lines in blocks.items() if heading.startswith(f"Strake {strake}, governing"))
        most = float(checks["design_strake_utilisation"].sel(strake=strake).max())
        assert block["U"].result == pytest.approx(most, rel=1e-12)


def test_the_page_stands_alone_and_is_the_same_each_time(cubes, html):
    assert page(*cubes, silos(cubes[0])[0]) == html
    assert "<script" not in html
    assert not re.search(r'(src|href)="', html)
    assert html.count("<svg") == 2
    for told in ("printed standards were not seen", "counter(page)", "Not computed, not checked", "Table 3.1", "Table E.1"):
        assert told in html
    assert "all give the cubes" in html
    assert "DISAGREEING" not in html


def test_a_study_of_pressures_gives_a_note_of_loads_and_says_so(tmp_path, capsys):
    path = tmp_path / "loads.html"
    assert main(["note", str(ROOT / "config/studies/pieper-flour.yaml"), "--output", str(path)]) == 0
    assert "loads alone" in capsys.readouterr().out
    text = path.read_text()
    assert "this is a note of loads" in text
    assert "utilisation" not in text.lower()


def test_the_first_page_tells_what_load_cases_are_left_out(html):
    first = html.split("<h2>")[0]
    assert "full, earthquake, pressed side: needs checks.earthquake" in first


def test_a_shipped_study_is_found_by_its_name(tmp_path, monkeypatch):
    monkeypatch.chdir(ROOT)
    assert main(["note", "pieper-flour", "--output", str(tmp_path / "loads.html")]) == 0


def test_bad_input_names_what_there_is(tmp_path, capsys):
    out = str(tmp_path / "n.html")
    assert main(["note", str(STUDY), "--case", "nonsense", "--output", out]) == 2
    assert re.search(r"--case = 'nonsense': must be one of [0-9a-f]{16}$", capsys.readouterr().err.strip())
    assert main(["note", str(ROOT / "config/studies/miller-1977.yaml"), "--output", out]) == 2
    assert "a note is of a study of kind pressure, shell" in capsys.readouterr().err
    study = yaml.safe_load((ROOT / "config/studies/pieper-flour.yaml").read_text())
    study["outputs"] = []
    study["sweep"] = [{"axis": "slenderness", "values": {"silo.slenderness": [9.0, 10.0]}}]
    (tmp_path / "two.yaml").write_text(yaml.safe_dump(study))
    assert main(["note", str(tmp_path / "two.yaml"), "--output", out]) == 2
    assert re.search(
        r"is missing, and the study has 2 silos: must be one of [0-9a-f]{16}, [0-9a-f]{16}$", capsys.readouterr().err.strip()
    )


def test_either_end_of_the_wall_friction_names_the_silo(cubes):
    ends = cubes[0]["case"].values
    assert ends.shape == (2,)
    assert named(ends, ["wall_friction_end"]) == [ends[0]]
    assert files_of("calculation_note", "f", silos(cubes[0])) == [f"f/notes/calculation_note-{ends[0]}.html"]


def test_angles_are_shown_in_degrees(blocks):
    assert blocks["Characteristic values"]["phi_n"].shown == f"{degrees(PHI / A_PHI):.2f}"
