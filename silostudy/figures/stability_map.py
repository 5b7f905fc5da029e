"""Largest stable step over damping, an arrangement a panel: found by bisection (marks), the engine's bound (lines), LAMMPS."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.style import BLACK, LINES, MARKERS, WIDTH, foot, headline, save

COLOURS = ("#0072B2", "#E69F00", "#009E73", "#56B4E9", "#D55E00", "#CC79A7", "#999999")
NAMES = {"disc": "one disc", "column": "column", "rows": "rows", "hexagonal": "hexagonal"}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    networks = [str(name) for name in cube["network"].values]
    figure, panels = plt.subplots(1, len(networks), figsize=(WIDTH, 6.4), sharey=True, squeeze=False)
    for panel, network in zip(panels[0], networks, strict=True):
        _panel(panel, cube.sel(network=network), network)
    panels[0, 0].set_ylabel("largest stable step (ms)")
    table = _numbers(cube)
    headline(figure, _message(table))
    about = "Marks: found by bisection; lines: the engine's own bound; n: contacts of a disc on average."
    foot(figure, f"{cube.attrs['title']}.", about, handles=panels[0, 0].get_legend_handles_labels()[0])
    save(figure, table, stem)


def _message(table: pd.DataFrame) -> str:
    """Message: how the largest stable step compares with the engine's bound, and with the peer's where there is one."""
    ratio = table["found_over_bound"].dropna()
    ends = f"{ratio.min():.2f} to {ratio.max():.2f}"
    told = f"The largest stable step is {ends} times the engine's bound, {ratio.median():.2f} in the median"
    peer = table["found_over_peer"].dropna()
    return f"{told}, and up to {peer.max():.1f} times the peer's" if len(peer) else told


def _panel(panel, grains: xr.Dataset, network: str) -> None:
    damping = grains["damping"].to_numpy()
    for march in range(grains.sizes["march"]):
        here = grains.isel(march=march)
        look = {"color": COLOURS[march % len(COLOURS)]}
        panel.plot(damping, here["stability_bound"] * 1e3, linewidth=1.2, linestyle=LINES[march % len(LINES)], **look)
        panel.plot(damping, here["stable_step"] * 1e3, linestyle="none", marker=MARKERS[march % len(MARKERS)], markersize=5.5,
                   label=march_name(here), **look)  # fmt: skip
    if grains.attrs["peer"]:
        panel.plot(damping, grains["peer_step"].isel(march=0) * 1e3, linestyle="none", marker="x", color=BLACK,
                   label=f"{grains.attrs['peer']}, velocity Verlet, dashpots at half-step speeds")  # fmt: skip
    contacts = float(grains["contact_number"].mean())
    panel.set(xscale="log", yscale="log", xlabel="damping ratio (1)")
    panel.set_title(f"{NAMES.get(network, network)}\nn = {contacts:.2g}")


def march_name(march: xr.Dataset) -> str:
    """Integrator and dashpots of one label."""
    integrator = str(march["march_integrator"].values)
    named = f"eqs. ({integrator.replace('-', '), (')})" if integrator[0].isdigit() else integrator.replace("-", " ")
    implicit = int(march["implicit_dashpots"].max())
    return named + {0: "", 1: ", one dashpot semi-implicit"}.get(implicit, ", semi-implicit dashpots")


def _numbers(cube: xr.Dataset) -> pd.DataFrame:
    names = ["stable_step", "stability_bound", "peer_step", "contact_number"]
    table = cube[names].to_dataframe().reset_index()
    table["march"] = [march_name(cube.isel(march=int(np.flatnonzero(cube["march"] == m)[0]))) for m in table["march"]]
    table = table[["network", "damping", "march", *names]]
    table["found_over_bound"] = table["stable_step"] / table["stability_bound"]
    table["found_over_peer"] = table["stable_step"] / table["peer_step"]
    return table
