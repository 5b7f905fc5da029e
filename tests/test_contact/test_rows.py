"""A law's row says all of it: ranges, units, losses; its key stands nowhere else."""

import ast
import re
from dataclasses import replace

import pytest

from silostudy.contact import FAMILIES, LAWS, NORMAL
from silostudy.dem.engine import Engine
from silostudy.dem.ledger import DASHPOT, ENTRIES, SLIDING, TURNOVER
from silostudy.dem.model import Contact
from silostudy.dem.pieces import Laws
from silostudy.errors import BadInput
from tests.conftest import ROOT
from tests.test_dem.scenes import silo
from tests.test_dem.test_every_law import KNOWN

ROWS = [(family, row) for family, rows in FAMILIES.items() for row in rows.values()]
OF_DISCS = [(family, row) for family, rows in LAWS.items() for row in rows.values()]


@pytest.mark.parametrize(("family", "row"), ROWS, ids=lambda part: part if isinstance(part, str) else part.key)
def test_a_contact_names_law_coefficient_unit_and_range(family, row):
    normal = NORMAL["hertz"] if getattr(row, "of_hertz", False) else Laws().normal
    laws = replace(Laws(normal), **{family: row})
    values = Contact.taking(laws, KNOWN).coefficients
    for one in row.coefficients:
        assert one.unit
        asking = normal if one in normal.coefficients and family != "normal" else row
        message = f"{one.name} = None: missing: the law {asking.key} takes it, in {one.unit}"
        with pytest.raises(BadInput, match=re.escape(message)):
            Contact(laws, {name: value for name, value in values.items() if name != one.name})
        with pytest.raises(BadInput, match=rf"{one.name} = -1\.0: must be (positive|zero or more) .* for the law"):
            Contact(laws, values | {one.name: -1.0})
        if one.positive:
            with pytest.raises(BadInput, match=rf"{one.name} = 0\.0: must be positive"):
                Contact(laws, values | {one.name: 0.0})


@pytest.mark.parametrize("normal", NORMAL)
def test_surface_energy_stands_on_hertz(normal):
    """Another normal law knows no radius of contact that an attraction could widen."""
    laws = Laws.of(normal=normal, cohesion="jkr")
    if NORMAL[normal].of_hertz:
        assert Contact.taking(laws, KNOWN).laws is laws
    else:
        with pytest.raises(BadInput, match=f"cohesion = 'jkr': stands on hertz, hertz-tension as normal law, not on {normal}"):
            Contact.taking(laws, KNOWN)


def test_a_normal_law_needs_a_spring():
    """Every normal law has a coefficient that may not be zero: a contact of zeros alone is none."""
    for row in NORMAL.values():
        with pytest.raises(BadInput, match="must be positive"):
            Contact(Laws(normal=row), {one.name: 0.0 for one in row.coefficients})


@pytest.mark.long
@pytest.mark.parametrize(("family", "row"), OF_DISCS, ids=lambda part: part if isinstance(part, str) else part.key)
def test_a_law_costs_what_its_row_says(family, row):
    """What a ledger books with the law and not without it are the entries that the row names."""
    assert set(row.dissipates) <= set(ENTRIES)
    laws = replace(Laws(normal=NORMAL["spring-dashpot"]), **{family: row})
    undamped = {name: 0.0 if "normal_damping" in name and family != "normal" else value for name, value in KNOWN.items()}
    touch = Contact.taking(laws, undamped)
    engine = Engine(silo(across=5, height=0.12, pair_contact=touch, wall_contact=touch, booked=True, dt=5e-6))
    engine.bodies.rows[: engine.n, 4] = 30.0  # spin, which rolling resistance brakes
    engine.step_to(4000)
    account = engine.ledger.account
    for name, entry in (("dashpot", DASHPOT), ("sliding", SLIDING)):
        assert (abs(account[entry]) > 1e-6 * account[TURNOVER]) == (name in row.dissipates)


def test_the_key_of_a_law_stands_in_its_row_alone():
    """`none` is a word of many; whatever else is a key may stand in one module of the package only."""
    keys = {row.key for _, row in ROWS if row.acts}
    assert len(keys) > 5
    homes = set((ROOT / "silostudy/contact").rglob("*.py"))
    for path in (ROOT / "silostudy").rglob("*.py"):
        found = {
            node.value
            for node in ast.walk(ast.parse(path.read_text()))
            if isinstance(node, ast.Constant) and node.value in keys
        }
        own = {path.stem.replace("_", "-")} if path in homes else set()
        assert found <= own, f"{path.relative_to(ROOT)} holds {sorted(found - own)}"
