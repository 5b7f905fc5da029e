"""How far the wall forces of a silo at rest move with the time step: every way of marching, and LAMMPS."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.stability_map import COLOURS, MARKERS
from silostudy.figures.style import save


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    figure, (panel, heights) = plt.subplots(1, 2, figsize=(11, 5.2), width_ratios=(3, 2))
    steps = cube["march_step"].to_numpy() * 1e3
    height = (cube["wall_part"].to_numpy() + 0.5) / cube.sizes["wall_part"]
    for k, marcher in enumerate(cube["marcher"].to_numpy()):
        one = cube.isel(marcher=k)
        peer = marcher == "LAMMPS"
        look = {"color": "black" if peer else COLOURS[k % len(COLOURS)], "marker": "x" if peer else MARKERS[k % len(MARKERS)]}
        panel.errorbar(
            steps * 1.015**k, one["profile_error"], one["profile_noise"], label=str(marcher), capsize=2, linewidth=1, **look
        )
        last = int(np.flatnonzero(np.isfinite(one["profile_error"]))[-1])
        heights.plot(one["silo_push"].isel(march_step=last), height, linewidth=1,
                     label=f"{marcher}, {steps[last]:g} ms", **look)  # fmt: skip
        if k == 0 or peer:
            short = f"{marcher if peer else 'eqs. (17), (18)'}, {cube.attrs['reference_step_s'] * 1e3:g} ms"
            heights.plot(one["reference_push"], height, color="black", linewidth=2.5, alpha=0.4, label=short,
                         linestyle="--" if peer else "-")  # fmt: skip
    panel.set(xscale="log", xlabel="time step (ms)", ylabel="distance of the mean wall profile from a short step's (1)")
    panel.set_ylim(bottom=0.0)
    panel.set_xticks(steps, [f"{step:g}" for step in steps])
    panel.minorticks_off()
    panel.set_title("bars: standard error; a line ends at the last step at which all fillings came to rest", fontsize=9)
    heights.set(xlabel="normal force on both walls (N/m)", ylabel="height over that of the fill (1)")
    heights.set_title("at the longest step of each, and at the short one", fontsize=9)
    panel.legend(fontsize=8)
    heights.legend(fontsize=7)
    figure.suptitle(f"Critically damped discs in a silo at rest, {cube.attrs['fillings']} fillings", fontsize=10)
    save(figure, _numbers(cube), stem)


def _numbers(cube: xr.Dataset) -> pd.DataFrame:
    table = cube[["profile_error", "profile_noise"]].to_dataframe().reset_index()
    total = cube["silo_push"].sum("wall_part", skipna=False) / cube["reference_push"].sum("wall_part")
    table["wall_force_over_reference"] = total.transpose("marcher", "march_step").to_numpy().ravel()
    return table.rename(columns={"march_step": "march_step_s"})
