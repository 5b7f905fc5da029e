"""The catalogue of hard cases and their tests are one: no row without a test, no test without a row."""

import ast
import csv
from pathlib import Path

HERE = Path(__file__).parent
# what every new room of the package should think of first
NAMED = {"mass_ratio", "radius_ratio", "stiffness", "stack_of_a_thousand", "wedged", "edge_of_a_slit", "coincident", "grazing",
         "opens_and_closes", "friction", "critical", "no_gravity", "hundred_metres", "jammed_arch", "million_steps", "bound",
         "sub_normal", "restart", "janssen_at_a_wall", "janssen_at_a_slenderness", "strain_energy", "exponent_next_to_one",
         "vertical_hopper", "flat_hopper", "no_internal", "ninety", "one_half", "radius_over_thickness", "no_length", "spike",
         "gap", "trend", "million_samples", "rises_when_filled"}  # fmt: skip


def catalogue() -> list[dict]:
    with (HERE / "catalogue.csv").open(encoding="utf-8", newline="") as stream:
        return list(csv.DictReader(stream))


def with_a_test() -> list[str]:
    nodes = [
        node for file in HERE.glob("test_*.py") if file.name != "test_catalogue.py" for node in ast.parse(file.read_text()).body
    ]
    return [node.name.removeprefix("test_") for node in nodes if isinstance(node, ast.FunctionDef) and node.name[:5] == "test_"]


def test_every_case_has_a_test_and_every_test_a_case():
    cases = [row["case"] for row in catalogue()]
    assert len(set(cases)) == len(cases) >= 60
    assert sorted(cases) == sorted(with_a_test())


def test_every_row_says_what_is_hard_and_what_must_hold():
    for row in catalogue():
        assert all(row.values()), row
        assert None not in row, row
        assert (HERE.parents[1] / "silostudy" / row["room"]).exists() or row["room"] == "files", row


def test_the_first_things_to_think_of_are_there():
    cases = " ".join(row["case"] for row in catalogue())
    assert not {name for name in NAMED if name not in cases}
