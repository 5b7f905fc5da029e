"""The chapter of the note on what was not computed and not checked, and why."""

import xarray as xr

from silostudy.checks import not_built
from silostudy.cube.unchecked import unchecked
from silostudy.note.loads import Block, Chapter
from silostudy.tables.clauses import clauses


def chapter(method: str, checks: xr.Dataset | None) -> Chapter:
    """Chapter on what a silo's cubes leave out, then on the code's clauses and the checks of the steel that are not built."""
    blocks = []
    if checks is None:
        told = "The study asks for no checks of the steel (section `checks` of a study of kind shell): this is a note of loads."
        blocks.append(Block("Steel", texts=(told,)))
    else:
        blocks.append(Block("Checks that were not made on this silo", items=tuple(unchecked(checks))))
    return Chapter("Not computed, not checked", [*blocks, *_clauses(method), *(_steel() if checks is not None else [])])


def _clauses(method: str) -> list[Block]:
    left = [clause for clause in clauses(method) if clause.state != "computed"]
    rows = tuple((clause.clause, clause.what, f"{clause.state}: {clause.evidence}", clause.remark) for clause in left)
    head = ("clause", "what", "state: evidence", "remark")
    return [Block("Of the code of actions, clause by clause", head=head, rows=rows, wordy=True)] if rows else []


def _steel() -> list[Block]:
    lines_by_reason = {
        "remembered only, by no source": not_built.MEMORY,
        "sources disagree": not_built.CONFLICT,
        "one source": not_built.ONE_SOURCE,
        "left out": not_built.LEFT_OUT,
    }
    return [Block(f"Checks of the steel that are not built: {why}", items=lines) for why, lines in lines_by_reason.items()]
