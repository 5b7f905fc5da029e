"""The published table of hard scenes: it is of these scenes, its guide shows it, and LAMMPS comes to it again."""

import csv
from itertools import groupby

import numpy as np
import pytest

from silostudy.accuracy.hard_scenes import scenes_in, verdict_rows
from silostudy.accuracy.laws_in_lammps import OTHERS, PLAIN, CannotSay, viscosity, words
from silostudy.accuracy.peers import available
from silostudy.accuracy.walls_in_lammps import regions
from silostudy.choice.dem import load
from silostudy.contact import elastic
from silostudy.dem.outcomes import OUTCOMES
from silostudy.scene.spheres import grain_of, space_silo_of
from silostudy.tables.materials import MATERIALS
from tests.conftest import ROOT

FOLDER = ROOT / "config/scenes/hard"
SCENES = scenes_in(FOLDER)
with (FOLDER / "verdicts.csv").open(encoding="utf-8") as file:
    ROWS = list(csv.DictReader(file))
BY_SCENE = {name: list(rows) for name, rows in groupby(ROWS, key=lambda row: row["scene"])}
TOLD = ("scene", "quantity", "told", "silostudy_verdict", "lammps_verdict")


def scene_of(name: str):
    return load(FOLDER / f"{name}.yaml")[0]


@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_the_table_is_of_what_the_scene_expects(path):
    published = {(row["quantity"], float(row["tolerance"])): float(row["expected"]) for row in BY_SCENE[path.stem]}
    asked = scene_of(path.stem).expected
    assert len(published) == len(asked)
    for number in asked:
        suffix = OUTCOMES[number.kind].suffix
        value, tolerance = (getattr(number, f"{name}_{suffix}") for name in ("value", "tolerance"))
        found = published[number.kind, float(f"{tolerance:.3g}")]
        assert found == pytest.approx(value, rel=0.0, abs=0.1 * tolerance)


@pytest.mark.parametrize("row", ROWS, ids=lambda row: f"{row['scene']}, {row['quantity']}, {row['told']}")
def test_the_verdicts_are_those_of_the_numbers(row):
    for code in ("silostudy", "lammps"):
        if row[code]:
            off = abs(float(row[code]) - float(row["expected"]))
            assert row[f"{code}_verdict"] == ("met" if off <= float(row["tolerance"]) else "not met")


def line_of(name: str, rows: list[dict[str, str]]) -> str:
    """The scene's line in the guide."""
    plain = [row for row in rows if row["lammps_verdict"] != "not met"]
    asked = "; ".join(f"{row['quantity']} {row['expected']} ± {row['tolerance']} {row['unit']}" for row in plain)
    others = [f"; with {row['told']} {row['lammps_verdict']}: {row['lammps']}" for row in rows if row not in plain]
    (here,), (there,) = ({row[f"{code}_verdict"] for row in plain} for code in ("silostudy", "lammps"))
    return f"| [{name}]({name}.yaml) | {asked} | {here} | {there}{''.join(others)} |"


def test_the_guide_shows_the_table():
    assert set(BY_SCENE) == {path.stem for path in SCENES}
    shown = [line for line in (FOLDER / "README.md").read_text(encoding="utf-8").splitlines() if line.startswith("| [")]
    assert shown == [line_of(name, rows) for name, rows in BY_SCENE.items()]


def test_a_folder_without_scenes_is_told(tmp_path):
    with pytest.raises(ValueError, match="must be a folder with scene files"):
        scenes_in(tmp_path)


def test_a_face_in_the_plane_of_a_wall_is_told_once():
    said = regions(space_silo_of(scene_of("outlet-tangent-to-the-wall")).walls())
    planes = [words for words in said.values() if words.startswith("plane")]
    assert len(planes) == len(set(planes)) == 5  # a plug, and four walls of which one goes on as a face
    assert sum(words.startswith("prism") for words in said.values()) == 3


def test_a_block_behind_a_sloping_wall_ends_at_its_slot():
    said = regions(space_silo_of(scene_of("slot-of-6-d")).walls())
    high = 0.008 / np.tan(np.radians(20.0))
    left, right = ([float(word) for word in said[name].split()[1:10]] for name in ("hopper_3", "hopper_1"))
    (behind, foot), (bottom, top), tilts = left[:2], left[4:6], left[6:]
    assert (foot, bottom, top, *tilts) == pytest.approx((-0.012, 0.0, high, 0.0, -0.008, 0.0))
    assert (right[0], *right[6:]) == pytest.approx((0.012, 0.0, 0.008, 0.0))
    assert behind < -0.1 < 0.1 < right[1]


def test_a_lid_that_presses_cannot_be_told():
    (row,) = BY_SCENE["grain-under-a-lid"]
    assert row["lammps_verdict"].startswith("cannot be told")
    told = load(FOLDER / "dust.yaml")[0].model_dump(exclude_unset=True)
    told["spheres"] |= {"tangential": "none"}
    with pytest.raises(CannotSay, match="the law none"):
        words(type(scene_of("dust")).model_validate(told), PLAIN, 5e-6)


def test_walls_get_the_modulus_that_makes_the_contacts():
    scene = scene_of("sphere-on-steel")
    grain, ratio = grain_of(scene), 0.25
    (_, plain), (_, own) = (words(scene, way, 0.002) for way in (PLAIN, OTHERS[1]))
    given = float(plain.split()[1])
    exact = elastic.contact_modulus(grain.youngs_modulus, ratio, 2.1e11, 0.3)
    assert elastic.contact_modulus(given, ratio, given, ratio) == pytest.approx(exact)
    assert own.split()[1:4:2] == ["210000000000.0", "0.3"]


def test_the_viscous_dashpot_is_as_strong_as_that_of_the_restitution():
    material, radius, mass, adhesion = MATERIALS["dosta-m1"], 0.002, 8e-5, 0.5
    modulus = elastic.contact_modulus(*(material.youngs_modulus, material.poissons_ratio) * 2)
    wide = (9.0 * np.pi * adhesion * radius**2 / (2.0 * modulus)) ** (1.0 / 3.0)
    ours = elastic.damping_where_cut(0.5) * np.sqrt(4.0 / 3.0 * modulus) * np.sqrt(mass * wide)
    assert viscosity(material, 0.5, adhesion, radius, mass) * mass * wide == pytest.approx(ours, rel=1e-12)


@pytest.mark.skipif(bool(available()), reason=available() or "installed")
def test_a_wall_of_its_own_modulus_is_too_stiff_in_lammps():
    found = verdict_rows(FOLDER / "sphere-on-steel.yaml", with_peer=True)
    assert [{name: row[name] for name in (*TOLD, "lammps")} for row in found] == [
        {name: row[name] for name in (*TOLD, "lammps")} for row in BY_SCENE["sphere-on-steel"]
    ]


@pytest.mark.long
@pytest.mark.skipif(bool(available()), reason=available() or "installed")
@pytest.mark.parametrize("path", SCENES, ids=lambda path: path.stem)
def test_lammps_comes_to_the_verdicts_again(path):
    found = verdict_rows(path, with_peer=True)
    assert [[row[name] for name in TOLD] for row in found] == [[row[name] for name in TOLD] for row in BY_SCENE[path.stem]]
