"""Largest stable step over damping, an arrangement a panel: found by bisection (marks), the engine's bound (lines), LAMMPS."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import save

COLOURS = ("#0072B2", "#E69F00", "#009E73", "#56B4E9", "#D55E00", "#CC79A7", "#999999")
MARKERS = ("o", "s", "^", "v", "D", "P", "X")
NAMES = {"disc": "one disc", "column": "column, up and down", "rows": "rows of s and s - 1", "hexagonal": "hexagonal"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    networks = [str(name) for name in cube["network"].values]
    figure, panels = plt.subplots(1, len(networks), figsize=(max(6.0, 3.6 * len(networks)), 5.6), sharey=True, squeeze=False)
    for panel, network in zip(panels[0], networks, strict=True):
        _panel(panel, cube.sel(network=network), network)
    panels[0, 0].set_ylabel("largest stable step (ms)")
    handles, labels = panels[0, 0].get_legend_handles_labels()
    figure.legend(handles, labels, loc="outside lower center", ncols=2, fontsize=8)
    figure.suptitle(f"{cube.attrs['title']}\nmarks: found by bisection; lines: the engine's own bound", fontsize=10)
    save(figure, _numbers(cube), stem)


def _panel(panel, one: xr.Dataset, network: str) -> None:
    damping = one["damping"].to_numpy()
    for march in range(one.sizes["march"]):
        here = one.isel(march=march)
        look = {"color": COLOURS[march % len(COLOURS)]}
        panel.plot(damping, here["stability_bound"] * 1e3, linewidth=1, **look)
        panel.plot(damping, here["stable_step"] * 1e3, linestyle="none", marker=MARKERS[march % len(MARKERS)], markersize=4.5,
                   label=march_name(here), **look)  # fmt: skip
    if one.attrs["peer"]:
        panel.plot(damping, one["peer_step"].isel(march=0) * 1e3, linestyle="none", marker="x", color="black",
                   label=f"{one.attrs['peer']}, velocity Verlet, dashpots at half-step speeds")  # fmt: skip
    contacts = float(one["contact_number"].mean())
    panel.set(xscale="log", yscale="log", xlabel="damping ratio of a disc on a spring (1)")
    panel.set_title(f"{NAMES.get(network, network)}: {contacts:.2g} contacts a disc", fontsize=9)


def march_name(one: xr.Dataset) -> str:
    """Integrator and dashpots of one label."""
    integrator = str(one["march_integrator"].values)
    named = f"eqs. ({integrator.replace('-', '), (')})" if integrator[0].isdigit() else integrator.replace("-", " ")
    implicit = int(one["implicit_dashpots"].max())
    return named + {0: "", 1: ", one dashpot semi-implicit"}.get(implicit, ", semi-implicit dashpots")


def _numbers(cube: xr.Dataset) -> pd.DataFrame:
    names = ["stable_step", "stability_bound", "peer_step", "contact_number"]
    table = cube[names].to_dataframe().reset_index()
    table["march"] = [march_name(cube.isel(march=int(np.flatnonzero(cube["march"] == m)[0]))) for m in table["march"]]
    kept = ["network", "damping", "march", *names]
    table = table[kept]
    table["found_over_bound"] = table["stable_step"] / table["stability_bound"]
    table["found_over_peer"] = table["stable_step"] / table["peer_step"]
    return table
