"""The chapter of the note on load cases: which the silo calls for, with which characteristic values, and how far computed."""

import xarray as xr

from silostudy.note.loads import Block, Chapter
from silostudy.tables.load_cases import LOAD_CASES


def chapter(checks: xr.Dataset | None) -> Chapter:
    """The list of Table 3.1 for one silo, from the cube of the checks, which alone holds it."""
    if checks is None or "load_case" not in checks.dims:
        told = "The cubes of this study hold no list of load cases: `silostudy compare STUDY` gives it for one silo."
        return Chapter("Load cases", [Block(texts=(told,))])
    rows = []
    for key in map(str, checks["load_case"].values):
        one, row = checks.sel(load_case=key), LOAD_CASES[key]
        state = one["load_case_state"].attrs["flag_meanings"].split()[int(one["load_case_state"])].replace("_", " ")
        why = str(one["load_case_reason"].values)
        sets = ", ".join(text.replace("_", " ") for text in row.sets)
        rows.append((row.title, row.clause, sets, row.evidence, f"{state}: {why}" if why else state))
    head = ("load case", "clause", "sets of characteristic values", "evidence", "in this study")
    return Chapter("Load cases", [Block("Of EN 1991-4:2006, Table 3.1", head=head, rows=tuple(rows), wordy=True)])
