"""Design codes clause by clause: what is computed, what is off by default, what is not computed and why."""

from dataclasses import dataclass

from silostudy.tables.read import HERE, rows

STATES = ("computed", "off by default", "not computed")
EVIDENCE = ("two sources", "equilibrium", "one source", "memory only", "")
TEXT = ("method", "clause", "what", "state", "evidence", "names", "remark", "source", "locator")


@dataclass(frozen=True)
class Clause:
    """Clause of a code: how far it is computed, on what evidence, and which variables, methods and keys carry it.

    clause: its number as accounts give it; empty where they give none.
    """

    method: str
    clause: str
    what: str
    state: str
    evidence: str
    names: tuple[str, ...]
    remark: str
    source: str
    locator: str


def clauses(method: str | None = None) -> list[Clause]:
    """The clauses of a method's code, or of all."""
    texts = [{name: row[name] for name in TEXT} for row in rows(HERE / "clauses.csv", TEXT)]
    every = [Clause(**{**row, "names": tuple(row["names"].split())}) for row in texts]
    return [clause for clause in every if method in (None, clause.method)]
