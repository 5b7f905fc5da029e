"""The recovery test: known coefficients found again, with the uncertainty stated, and what moves the study's own answer."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.shaken import cases, head, name
from silostudy.figures.style import BLUE, SKY, VERMILION, WIDTH, save

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
    figure, panels = plt.subplots(2, len(columns), figsize=(WIDTH, 8.6), squeeze=False, sharey="row",
                                  height_ratios=(1.7, 1))  # fmt: skip
    tables = []
    for (above, below), case in zip(panels.T, columns, strict=True):
        table = _numbers(case)
        _trials(above, table)
        above.set_title(f"{name(case)}: {int(table.within.sum())} of {len(table)}")
        parts = _contributions(below, case)
        tables += [part.assign(case=str(case["case"].values)) for part in (table, parts)]
    panels[0, 0].set_ylabel("C_eff found less true C_eff")
    about = "Known coefficients found again by e_A from synthetic responses with noise, damping and stiffness unknown; bars: "
    about += "stated uncertainty. Below: half-widths that make up that of the study's own answer."
    handles = {text: line for panel in panels[0] for line, text in zip(*panel.get_legend_handles_labels(), strict=True)}
    head(figure, cube, _message(pd.concat(tables)), about, handles=handles.values())
    save(figure, pd.concat(tables, ignore_index=True), stem)


def _numbers(case: xr.Dataset) -> pd.DataFrame:
    table = case[["recovery_truth", "recovery_answer", "recovery_uncertainty"]].to_dataframe()
    table = table[["recovery_truth", "recovery_answer", "recovery_uncertainty"]].reset_index()
    table["error"] = table.recovery_answer - table.recovery_truth
    table["within"] = table.error.abs() <= table.recovery_uncertainty
    return table


def _message(table: pd.DataFrame) -> str:
    """Message: how many truths lie within the uncertainty, and which part of that is the largest."""
    within = table["within"].dropna()
    parts = table[table["contribution"].isin(NAMES.values())].groupby("contribution")["half_width"].mean()
    told = f"{int(within.sum())} of {len(within)} known coefficients lie within the stated uncertainty"
    return f"{told}, of which the largest part is the {parts.idxmax()} (half-width {parts.max():.2g})"


def _trials(panel, table: pd.DataFrame) -> None:
    for within, marker, colour, label in ((True, "o", BLUE, "truth within"), (False, "X", VERMILION, "truth outside")):
        some = table[table.within == within]
        if len(some):
            panel.errorbar(some.recovery_truth, some.error, some.recovery_uncertainty, fmt=marker, color=colour,
                           markersize=4 if within else 8, linewidth=0.7, label=label)  # fmt: skip
    panel.axhline(0, color="black", linewidth=0.8)
    panel.set_xlabel("true C_eff of the synthetic response")


def _contributions(panel, case: xr.Dataset) -> pd.DataFrame:
    """Half-widths that add up to the uncertainty of the study's own answer, and the coarse step; as a table."""
    parts = dict(zip(map(str, case["contribution"].values), map(float, case["uncertainty_contribution"].values), strict=True))
    fine, coarse = float(case["uncertainty"]), float(case["coarse_uncertainty"])
    steps = coarse - fine + parts["step"] if np.isfinite(coarse) else np.nan
    labels = [*(NAMES[key] for key in parts), "coarse step", "stated, fine", "stated, coarse"]
    values = [value if np.isfinite(value) else 0.0 for value in (*parts.values(), steps, fine, coarse)]
    told = [f"{value:.4f}" for value in parts.values()] + [_open(value) for value in (steps, fine, coarse)]
    places = np.arange(len(values))[::-1]
    panel.barh(places, values, color=[SKY] * (len(values) - 2) + [BLUE] * 2, edgecolor="black", linewidth=0.5)
    for place, value, text in zip(places, values, told, strict=True):
        panel.text(value, place, f" {text}", va="center", fontsize="small")
    panel.set_yticks(places, labels)
    panel.set(xlabel="half-width of the study's own C_eff", xlim=(0, 1.3 * max(values)))
    panel.grid(axis="y", visible=False)
    return pd.DataFrame({"contribution": labels, "half_width": values})


def _open(half_width: float) -> str:
    return f"{half_width:.4f}" if np.isfinite(half_width) else "open: reaches an end of the candidates"
