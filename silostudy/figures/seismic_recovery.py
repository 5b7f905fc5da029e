"""The recovery test: known coefficients found again, with the uncertainty stated, and what moves the study's own answer."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import cases, head, name
from silostudy.figures.style import save

NAMES = {
    "noise": "noise (2 sigma)",
    "damping": "damping mismatch",
    "stiffness": "empty frequency",
    "band": "ends of the band",
    "step": "fine step",
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and the trials."""
    columns = cases(cube)
    figure, panels = plt.subplots(2, len(columns), figsize=(5.6 * len(columns) + 1, 7.2), squeeze=False, sharey="row",
                                  height_ratios=(2, 1))  # fmt: skip
    tables = []
    for (above, below), one in zip(panels.T, columns, strict=True):
        table = _numbers(one)
        _trials(above, table, float(one["recovery_coverage"]))
        above.set_title(f"{name(one)}\n{_coverage(table)}", fontsize=9)
        parts = _contributions(below, one)
        tables += [part.assign(case=str(one["case"].values)) for part in (table, parts)]
    panels[0, 0].set_ylabel("C_eff found less true C_eff")
    head(
        figure, cube, "known coefficients found again by e_A from synthetic responses with noise, damping and stiffness unknown"
    )
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _numbers(one: xr.Dataset) -> pd.DataFrame:
    table = one[["recovery_truth", "recovery_answer", "recovery_uncertainty"]].to_dataframe()
    table = table[["recovery_truth", "recovery_answer", "recovery_uncertainty"]].reset_index()
    table["error"] = table.recovery_answer - table.recovery_truth
    table["within"] = table.error.abs() <= table.recovery_uncertainty
    return table


def _coverage(table: pd.DataFrame) -> str:
    return f"{int(table.within.sum())} of {len(table)} truths within the stated uncertainty"


def _trials(panel, table: pd.DataFrame, coverage: float) -> None:
    for within, marker, colour, label in ((True, "o", "#0072b2", "truth within"), (False, "X", "#d55e00", "truth outside")):
        some = table[table.within == within]
        if len(some):
            panel.errorbar(some.recovery_truth, some.error, some.recovery_uncertainty, fmt=marker, color=colour,
                           markersize=4 if within else 8, linewidth=0.7, label=label)  # fmt: skip
    panel.axhline(0, color="black", linewidth=0.8)
    panel.set_xlabel("true C_eff of the synthetic response")
    panel.margins(y=0.16)  # room for the legend above the bars
    panel.legend(fontsize=8, loc="upper left", ncols=2)


def _contributions(panel, one: xr.Dataset) -> pd.DataFrame:
    """Half-widths that add up to the uncertainty of the study's own answer, and the coarse step; as a table."""
    parts = dict(zip(map(str, one["contribution"].values), map(float, one["uncertainty_contribution"].values), strict=True))
    fine, coarse = float(one["uncertainty"]), float(one["coarse_uncertainty"])
    steps = coarse - fine + parts["step"] if np.isfinite(coarse) else np.nan
    labels = [*(NAMES[key] for key in parts), "coarse step", "stated, fine", "stated, coarse"]
    values = [value if np.isfinite(value) else 0.0 for value in (*parts.values(), steps, fine, coarse)]
    told = [f"{value:.4f}" for value in parts.values()] + [_open(value) for value in (steps, fine, coarse)]
    places = np.arange(len(values))[::-1]
    panel.barh(places, values, color=["#56b4e9"] * (len(values) - 2) + ["#0072b2"] * 2, edgecolor="black", linewidth=0.5)
    for place, value, text in zip(places, values, told, strict=True):
        panel.text(value, place, f" {text}", va="center", fontsize=7)
    panel.set_yticks(places, labels, fontsize=8)
    panel.set(xlabel="half-width of the study's own C_eff", xlim=(0, 1.2 * max(values)))
    panel.grid(axis="y", visible=False)
    return pd.DataFrame({"contribution": labels, "half_width": values})


def _open(half_width: float) -> str:
    return f"{half_width:.4f}" if np.isfinite(half_width) else "open: reaches an end of the candidates"
