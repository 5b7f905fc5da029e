"""The chapter of the note on load cases: which the silo calls for, with which characteristic values, and how far computed."""

import xarray as xr

from silostudy.note.loads import Block, Chapter
from silostudy.tables.load_cases import LOAD_CASES

NOT_WRITTEN = "Large eccentric discharge (5.2.4), which e_o > 0.25 d_c in class 3 calls for, is not written out in this note."


def chapter(checks: xr.Dataset | None) -> Chapter:
    """The list of Table 3.1 for one silo, from the cube of the checks, which alone holds it."""
    if checks is None or "load_case" not in checks.dims:
        told = "The cubes of this study hold no list of load cases: `silostudy compare STUDY` gives it for one silo."
        return Chapter("Load cases", [Block(texts=(told, NOT_WRITTEN))])
    rows = []
    for key in map(str, checks["load_case"].values):
        load_case, row = checks.sel(load_case=key), LOAD_CASES[key]
        state = _state(load_case)
        why = str(load_case["load_case_reason"].values)
        sets = ", ".join(text.replace("_", " ") for text in row.sets)
        rows.append((row.title, row.clause, sets, row.evidence, f"{state}: {why}" if why else state))
    head = ("load case", "clause", "sets of characteristic values", "evidence", "in this study")
    listed = Block("Of EN 1991-4:2006, Table 3.1", head=head, rows=tuple(rows), wordy=True, texts=(NOT_WRITTEN,))
    return Chapter("Load cases", [listed])


def not_asked_for(checks: xr.Dataset) -> list[str]:
    """Load cases that the silo calls for and the study does not ask for, each with what it needs."""
    load_cases = (
        (checks.sel(load_case=key) for key in map(str, checks["load_case"].values)) if "load_case" in checks.dims else ()
    )
    return [f"{LOAD_CASES[str(load_case['load_case'].values)].title}: {load_case['load_case_reason'].values}"
            for load_case in load_cases if _state(load_case) == "not asked for"]  # fmt: skip


def _state(load_case: xr.Dataset) -> str:
    return load_case["load_case_state"].attrs["flag_meanings"].split()[int(load_case["load_case_state"])].replace("_", " ")
