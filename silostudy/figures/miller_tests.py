"""Miller's tests one by one: measured, predicted by every rule, and what the source gets wrong about them."""

from pathlib import Path

import pandas as pd
import xarray as xr

from silostudy.figures.rules import PSI, group
from silostudy.figures.style import save_table
from silostudy.tables.handbook import errata


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes a row for each test and rule."""
    groups, modes = group(cube), str(cube["buckling_mode"].attrs["flag_meanings"]).split()
    rows = []
    for place, test in enumerate(map(str, cube["test"].values)):
        for rule in map(str, cube["rule"].values):
            state = cube.isel({"test": place}).sel({"rule": rule})
            rows.append(_row(test, rule, groups[place], state, modes))
    save_table(pd.DataFrame(rows), stem.with_suffix(".csv"))


def _row(test: str, rule: str, kind: str, state: xr.Dataset, modes: list[str]) -> dict:
    measured, predicted = float(state["test_lower_buckling_stress"]), float(state["buckling_stress"])
    mode = int(state["buckling_mode"])
    return {
        "test": test,
        "group": kind,
        "rule": rule,
        "R_over_t": float(state["shell_radius"] / state["thickness"]),
        "L_over_sqrt_Rt": float(state["bay_length"] / (state["shell_radius"] * state["thickness"]) ** 0.5),
        "ring_area_ratio": float(state["ring_area"] / (state["bay_length"] * state["thickness"])),
        "measured_psi": measured / PSI,
        "predicted_psi": predicted / PSI,
        "test_over_prediction": measured / predicted,
        "predicted_mode": modes[mode] if mode >= 0 else "masked",
        "observed_collapse": str(state["test_collapse"].values),
        "remark": _remark(kind, test),
    }


def _remark(kind: str, test: str) -> str:
    """The errors of the source that touch a test."""
    known = {"miller_large_radius", "miller_table_3_units"} if kind == "large" else {"miller_radius", "miller_table_1_units"}
    known |= {"miller_buckle_heights"} if test in ("9", "10", "12") else set()
    return "; ".join(f"{e.place}: printed {e.printed}, right {e.right}" for e in errata() if e.erratum in known)
