"""Drift of the wall forces of a silo at rest with the time step: every integrator and dashpot, and LAMMPS."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.stability_map import COLOURS
from silostudy.figures.style import BLACK, LINES, MARKERS, WIDTH, foot, headline, save

ASIDE = 1.015  # factor from a marcher's place on the time axis to the next one's, so that bars do not hide one another


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers."""
    figure, (panel, heights) = plt.subplots(1, 2, figsize=(WIDTH, 6.6), width_ratios=(3, 2))
    steps = cube["march_step"].to_numpy() * 1e3
    height = (cube["wall_part"].to_numpy() + 0.5) / cube.sizes["wall_part"]
    profiles = []
    for k, marcher in enumerate(cube["marcher"].to_numpy()):
        here = cube.isel(marcher=k)
        peer = marcher == "LAMMPS"
        look: dict = {
            "color": BLACK if peer else COLOURS[k % len(COLOURS)],
            "marker": "x" if peer else MARKERS[k % len(MARKERS)],
        }
        look |= {"linestyle": LINES[k % len(LINES)], "linewidth": 1.2}
        panel.errorbar(steps * ASIDE**k, here["profile_error"], here["profile_noise"], label=str(marcher), capsize=2, **look)
        last = int(np.flatnonzero(np.isfinite(here["profile_error"]))[-1])
        profiles.append(
            _profile(heights, here["silo_push"].isel(march_step=last), height, f"{marcher}, {steps[last]:g} ms", **look)
        )
        if k == 0 or peer:
            short = f"{marcher if peer else 'eqs. (17), (18)'}, {cube.attrs['reference_step_s'] * 1e3:g} ms"
            profiles.append(_profile(heights, here["reference_push"], height, short, color="0.6", linewidth=3.0,
                                     linestyle="--" if peer else "-"))  # fmt: skip
    panel.set(xscale="log", xlabel="time step (ms)", ylabel="distance of the wall profile from a short step's (1)")
    panel.set_ylim(bottom=0.0)
    panel.set_xticks(steps, [f"{step:g}" for step in steps])
    panel.minorticks_off()
    panel.set_title("error over the step")
    heights.set(xlabel="normal force on both walls (N/m)", ylabel="height over that of the fill (1)")
    heights.set_title("profiles at the longest step")
    table = _numbers(cube)
    headline(figure, _message(table))
    about = (
        f"Critically damped discs in a silo at rest, {cube.attrs['fillings']} fillings. Bars: standard error; a line ends at "
    )
    about += "the last step at which all fillings came to rest, whose profile stands on the right; grey: at the short step."
    foot(figure, about, handles=panel.get_legend_handles_labels()[0])
    save(figure, pd.concat([table, *profiles], ignore_index=True), stem)


def _message(table: pd.DataFrame) -> str:
    """The integrator with the longest step that comes to rest, and how far off its wall profile is there."""
    known = table.dropna(subset="profile_error")
    longest = known[known["march_step_s"] == known["march_step_s"].max()]
    best = longest.loc[longest["profile_error"].idxmin()]
    error = f"{100 * best.profile_error:.0f} ± {100 * best.profile_noise:.0f} % off"
    count = f"{len(longest)} of {known['marcher'].nunique()} integrators come to rest"
    return f"At {1e3 * best.march_step_s:g} ms {count}; the wall profile of {best.marcher} is least off: {error}"


def _profile(panel, push: xr.DataArray, height: np.ndarray, label: str, **look) -> pd.DataFrame:
    """Draws the force on both walls over the height; as a table."""
    panel.plot(push, height, label=label, **look)
    return pd.DataFrame({"profile": label, "wall_force_N_m": push.to_numpy(), "relative_height": height})


def _numbers(cube: xr.Dataset) -> pd.DataFrame:
    table = cube[["profile_error", "profile_noise"]].to_dataframe().reset_index()
    total = cube["silo_push"].sum("wall_part", skipna=False) / cube["reference_push"].sum("wall_part")
    table["wall_force_over_reference"] = total.transpose("marcher", "march_step").to_numpy().ravel()
    aside = table["marcher"].map({marcher: ASIDE**k for k, marcher in enumerate(cube["marcher"].to_numpy())})
    table["drawn_at_ms"] = table["march_step"] * 1e3 * aside
    return table.rename(columns={"march_step": "march_step_s"})
