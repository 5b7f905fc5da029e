"""Load cases that a silo is designed for: what calls for each, which characteristic values it takes, how far it is computed."""

from dataclasses import dataclass, fields

from silostudy.catalogue import Entry, Family
from silostudy.tables.read import HERE, rows

STATES = ("computed", "not computed")
LISTS = ("methods", "sets", "names", "needs")


@dataclass(frozen=True, kw_only=True)
class LoadCase(Entry):
    """One load case of a code.

    called_for: the question that tells whether a silo calls for it; state: one of STATES
    methods, phase: whose rows give it, the first that covers the silo; names: variables and keys that carry it
    field: how its pressures stand on the wall; empty: it has none of its own
    sets: the characteristic values that its quantities take
    needs: dotted keys of a study without which it is not computed
    """

    called_for: str
    state: str
    methods: tuple[str, ...]
    phase: str
    field: str
    sets: tuple[str, ...]
    names: tuple[str, ...]
    needs: tuple[str, ...]
    clause: str
    evidence: str
    remark: str
    source: str
    locator: str


TEXT = ("load_case", *(item.name for item in fields(LoadCase)))


def _load_case(raw: dict) -> LoadCase:
    cells: dict = {name: raw[name] for name in TEXT if name in raw and name not in LISTS and name != "load_case"}
    cells |= {name: tuple(raw[name].split()) for name in LISTS}
    return LoadCase(key=raw["load_case"], **cells)


LOAD_CASES: Family[LoadCase] = Family("load case", map(_load_case, rows(HERE / "load_cases.csv", text=TEXT)))
