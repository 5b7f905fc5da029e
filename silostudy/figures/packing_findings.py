"""Every claim of the source as a number with its spread over the runs, and a verdict that follows from the runs alone."""

from itertools import product
from pathlib import Path

import numpy as np
import pandas as pd
import xarray as xr
from scipy.stats import binomtest

from silostudy.figures.style import save_table
from silostudy.tables.claims import Claim, kiyama_1983

MOST = 0.8  # share of the runs from which on a claim counts as reproduced
FEW = 0.2  # share below which it counts as not reproduced


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes one row for each claim, packing and variant of the study; runs 1 and on count, run 0 (ideal) stands beside."""
    save_table(findings(cube), stem.with_suffix(".csv"))


def findings(cube: xr.Dataset) -> pd.DataFrame:
    """The table; cases with the remedy are left out, since the source's flows are judged before it."""
    if "removal" in cube.dims:
        cube = cube.isel(removal=0)
    cube = cube.assign(falling_steps=_falling_steps(cube), janssen_gain=_gain(cube))
    others = [axis for axis in cube.attrs["sweep_axes"].split() if axis in cube.dims and axis != "packing"]
    lines = []
    for claim in kiyama_1983():
        across = cube["packing"].values if claim.across is None else [claim.across]
        if claim.variable == "falling_steps":
            across = [cube["packing"].values[0]]
        for packing, *place in product(across, *(range(cube.sizes[axis]) for axis in others)):
            if packing in cube["packing"].values:
                variant = cube.sel(packing=packing).isel(dict(zip(others, place, strict=True)))
                lines.append(_row(claim, variant, int(packing), _settings(variant, others)))
    return pd.DataFrame(lines)


def _settings(variant: xr.Dataset, axes: list[str]) -> dict:
    """Settings of the axes: their own values, or those of the keys that change together on them."""
    beside = {axis: [str(name) for name in variant.coords if str(name).startswith(f"{axis}_")] or [axis] for axis in axes}
    return {name: variant[name].item() for names in beside.values() for name in names}


def _falling_steps(cube: xr.Dataset) -> xr.DataArray:
    """Share of the steps to the next packing at which the force falls."""
    return (cube["rest_side_share"].diff("packing") < 0).mean("packing") * xr.ones_like(cube["rest_side_share"])


def _gain(cube: xr.Dataset) -> xr.DataArray:
    return 1.0 - cube["janssen_residual"] / cube["hydrostatic_residual"]


def _row(claim: Claim, variant: xr.Dataset, across: int, settings: dict) -> dict:
    values = variant[claim.variable]
    values = values.sel({values.dims[-1]: claim.measure}) if claim.measure else values
    ideal, runs = float(values.isel(run=0)), values.isel(run=slice(1, None)).values
    runs = runs[np.isfinite(runs)]
    meet = int(((runs >= claim.at_least) & (runs <= claim.at_most)).sum())
    chance = binomtest(meet, len(runs)).proportion_ci(method="wilson") if len(runs) else (np.nan, np.nan)
    low, median, high = np.quantile(runs, [0.1, 0.5, 0.9]) if len(runs) else (np.nan,) * 3
    every = claim.variable == "falling_steps"
    return {
        "claim": claim.claim, "packing": "all" if every else f"{across - 1}/{across}", **settings,
        "printed": claim.printed, "at_least": claim.at_least, "at_most": claim.at_most,
        "median": median, "tenth": low, "nine_tenths": high, "ideal_start": ideal,
        "runs": len(runs), "runs_that_meet_it": meet, "share_low_95": chance[0], "share_high_95": chance[1],
        "verdict": verdict(meet, len(runs)), "how": claim.remark, "locator": claim.locator,
    }  # fmt: skip


def verdict(meet: int, runs: int) -> str:
    """A plain word for how many of the runs meet a claim."""
    if not runs:
        return "no run to judge by"
    if meet >= MOST * runs:
        return "reproduced"
    return "not reproduced" if meet < FEW * runs else "in some runs"
