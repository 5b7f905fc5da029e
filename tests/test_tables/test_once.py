"""What stands in one place only: gravity, Kiyama and Fujimura's numbers, the walls of a plane silo."""

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from silostudy.tables import kiyama_1983 as kiyama
from silostudy.tables.constants import ROUNDED_GRAVITY, STANDARD_GRAVITY
from tests.conftest import ROOT

PACKAGE = ROOT / "silostudy"
GRAVITY = {ROUNDED_GRAVITY, *(STANDARD_GRAVITY * 10.0**power for power in range(-1, 5))}
OF_THE_SOURCE = {
    kiyama.NORMAL_STIFFNESS, kiyama.NORMAL_DAMPING, kiyama.YOUNGS_MODULUS / 1e6, kiyama.CONTACT_LOAD, kiyama.DENSITY,
    kiyama.DISC_FRICTION, kiyama.WALL_FRICTION, *kiyama.GAPS.values(), 364, 0.153,
}  # fmt: skip
EQUAL_BY_CHANCE = {("laboratory_scenes.py", 3e-4)}  # the speed of a laboratory's tests, and a gap in metres
BUILDERS = {"plane_silo.py", "inserts.py", "stability.py", "dem_impact.py"}  # the last three: walls that are no silo's


def numbers() -> Iterator[tuple[Path, float]]:
    """Numbers in the package's code, file by file."""
    for path in PACKAGE.rglob("*.py"):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.Constant) and type(node.value) in (int, float):
                yield path, node.value


def test_gravity_stands_once():
    found = {(path.name, value) for path, value in numbers() if any(abs(value / g - 1) < 1e-12 for g in GRAVITY)}
    assert found == {("constants.py", STANDARD_GRAVITY), ("constants.py", ROUNDED_GRAVITY)}


def test_numbers_of_the_source_stand_in_its_table():
    assert {(path.name, value) for path, value in numbers() if value in OF_THE_SOURCE} == EQUAL_BY_CHANCE


def test_one_place_builds_walls_of_a_silo():
    for path in PACKAGE.rglob("*.py"):
        tree = ast.parse(path.read_text())
        names = {
            alias.name
            for node in ast.walk(tree) if isinstance(node, ast.ImportFrom) and node.module == "silostudy.dem.model"
            for alias in node.names
        }  # fmt: skip
        calls = {node.func.id for node in ast.walk(tree) if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)}
        assert "Wall" not in names & calls or path.name in BUILDERS, path


def test_walls_are_rigid():
    """Table 2 prints the walls' constants as well: K_n / rho g in m, eta_n / rho g in m s, and the same along the wall."""
    weight, walls = kiyama.DENSITY * ROUNDED_GRAVITY, kiyama.WALL_STIFFNESS_RATIO
    along = kiyama.STIFFNESS_RATIO
    assert walls * kiyama.NORMAL_STIFFNESS / weight == pytest.approx(728.0, rel=1e-12)
    assert walls * kiyama.NORMAL_DAMPING / weight == pytest.approx(0.306, rel=1e-12)
    assert along * kiyama.NORMAL_STIFFNESS / weight == pytest.approx(91.0, rel=1e-12)
    assert along**0.5 * kiyama.NORMAL_DAMPING / weight == pytest.approx(0.0765, rel=1e-12)


def test_neighbours_of_11_12_stand_farther_apart_than_those_of_17_18():
    assert kiyama.pitch(kiyama.PASSIVE) == pytest.approx(38.0 / 11.0, rel=1e-12)
    for packing in (kiyama.PASSIVE, kiyama.ACTIVE):
        assert kiyama.width_as_steep(packing, packing) == pytest.approx(kiyama.SILO_WIDTH, rel=1e-12)


SCENES = ["config/scenes/kiyama-17-18.yaml", "config/studies/discharge-thousand.yaml", "config/studies/discharge-slit.yaml"]


@pytest.mark.parametrize("file", SCENES)
def test_shipped_scenes_hold_the_table_s_numbers(file):
    content = yaml.safe_load((ROOT / file).read_text())
    scene = content.get("scene", content)
    assert (scene["radius_m"], scene["density_kg_m3"]) == (kiyama.RADIUS, kiyama.DENSITY)
    assert scene["packing"]["gap_m"] == kiyama.GAPS[kiyama.ACTIVE]
    for contact, factor, friction in (
        ("discs", 1.0, kiyama.DISC_FRICTION),
        ("walls", kiyama.WALL_STIFFNESS_RATIO, kiyama.WALL_FRICTION),
    ):
        printed = {
            "normal_stiffness_N_m2": factor * kiyama.NORMAL_STIFFNESS,
            "normal_damping_N_s_m2": factor * kiyama.NORMAL_DAMPING,
        }
        assert scene[contact] == printed | {"sliding_friction": friction}
    if scene["packing"]["across"] == kiyama.ACTIVE:
        assert (scene["silo"]["width_m"], scene["silo"]["slit_width_m"]) == (kiyama.SILO_WIDTH, kiyama.SLIT_WIDTH)
