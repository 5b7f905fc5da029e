"""Whether, when and where an arch stops the flow, packing by packing, and what the remedy makes of it."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import ensembles
from silostudy.figures.style import AID, BLACK, WIDTH, foot, headline, save

CM = 100.0


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: chance of a stop, its time, the arch's span, discs out by the end."""
    plain = ensembles.first(cube)
    places = np.arange(cube.sizes["packing"])
    chances = np.array(
        [ensembles.chance(ensembles.runs(plain["flow_stopped"].sel(packing=s))) for s in plain["packing"].values]
    )
    figure, ((chance, time), (span, out)) = plt.subplots(2, 2, figsize=(WIDTH, 8.8))
    middle, low, high = chances.T
    chance.errorbar(places, middle, [middle - low, high - middle], fmt="o", color="black", capsize=3)
    chance.set(ylabel="share of runs that an arch stops", ylim=(-0.03, 1.03), title="chance of a stop, 95 % interval")
    stops = [_scatter(time, plain["stop_time"], places, "stopped_at_s"),
             _scatter(span, plain["arch_span"] * CM, places, "arch_span_cm")]  # fmt: skip
    time.set(ylabel="last disc passed at (s)", title="when", ylim=(0, None))
    span.axhline(
        cube.attrs["slit_width_m"] * CM, color="black", linewidth=0.8, linestyle="--", gid=AID, label="width of the slit"
    )
    span.set(ylabel="distance of the arch's feet (cm)", title="where: shortest chain of touching discs")
    span.set_ylim(0, 1.1 * max(span.get_ylim()[1], cube.attrs["slit_width_m"] * CM))
    passed = _passed(out, cube, places)
    for panel in (chance, time, span, out):
        panel.set_xticks(places, [ensembles.name(s) for s in cube["packing"].values])
        panel.set(xlabel="packing", xlim=(-0.6, len(places) - 0.4))
    headline(figure, _message(cube, chances))
    about = (
        f"{cube.sizes['run'] - 1} runs a packing, slit of {cube.attrs['slit_width_m'] * CM:g} cm. Dots: every run that stopped."
    )
    foot(
        figure,
        f"{cube.attrs['title']}.",
        about,
        handles=[*out.get_legend_handles_labels()[0], *span.get_legend_handles_labels()[0]],
    )
    save(figure, pd.concat([_numbers(cube, chances), passed, *stops], ignore_index=True), stem)


def _message(cube: xr.Dataset, chances: np.ndarray) -> str:
    """Message: how many of all runs an arch stops, in how many packings, and how many discs come out with the remedy."""
    share = chances[:, 0]
    if not share.max() > 0.0:
        return "No arch stops the flow in any packing"
    told = f"Arches stop {100 * share.mean():.0f} % of all runs, in {(share > 0).sum()} of {len(share)} packings"
    if "removal" not in cube.dims:
        return told
    plain, remedied = cube["passed_discs"].isel(sample=-1, run=slice(1, None)).mean(("packing", "run")).values
    return f"{told}; with the remedy {remedied:.0f} discs come out on average in place of {plain:.0f}"


def _scatter(panel, values: xr.DataArray, places: np.ndarray, column: str) -> pd.DataFrame:
    """Draws what the runs of each packing gave, in rising order; as a table with that column."""
    tables = []
    for place, across in zip(places, values["packing"].values, strict=True):
        known = ensembles.runs(values.sel(packing=across))
        known = np.sort(known[np.isfinite(known)])
        panel.plot(place + np.linspace(-0.25, 0.25, len(known)), known, ".", color=BLACK, markersize=4, alpha=0.6)
        tables.append(pd.DataFrame({"packing": ensembles.name(across), column: known}))
    return pd.concat(tables)


def _passed(panel, cube: xr.Dataset, places: np.ndarray) -> pd.DataFrame:
    """Draws the discs that have passed by the end, with and without the remedy; as a table."""
    tables = []
    cases = cube if "removal" in cube.dims else cube.expand_dims("removal")
    for k in range(cases.sizes["removal"]):
        values = ensembles.runs(cases["passed_discs"].isel(removal=k, sample=-1))
        low, middle, high = ensembles.spread(values)
        label = "a disc of the roof removed at each stop" if k else "as it comes"
        panel.errorbar(
            places + 0.16 * k - 0.08, middle, [middle - low, high - middle], fmt="os"[k], color=ensembles.COLOURS[bool(k)],
            capsize=3, label=label,
        )  # fmt: skip
        table = {"packing": [ensembles.name(s) for s in cases["packing"].values], "case": label}
        tables.append(pd.DataFrame(table | {"discs_out": middle, "discs_out_tenth": low, "discs_out_nine_tenths": high}))
    end = float(cube["sample"][-1])
    panel.set(
        ylabel=f"number of discs out after {end:g} s",
        title="remedy: median, middle four fifths",
        ylim=(0, None),
    )
    return pd.concat(tables)


def _numbers(cube: xr.Dataset, chances: np.ndarray) -> pd.DataFrame:
    plain = ensembles.first(cube)
    table = {"packing": [ensembles.name(s) for s in cube["packing"].values], "runs": plain.sizes["run"] - 1}
    table |= dict(zip(("stopped_share", "share_low_95", "share_high_95"), chances.T, strict=True))
    for name in ("stop_time", "arch_span", "arch_height", "arch_discs"):
        values = plain[name].isel(run=slice(1, None))
        table[f"{name}_median_of_stopped"] = values.median("run").values
        table[f"{name}_ideal_start"] = plain[name].isel(run=0).values
    if "removal" in cube.dims:
        table["discs_removed_mean"] = cube["discs_removed"].isel(removal=1, run=slice(1, None)).mean("run").values
    return pd.DataFrame(table)
