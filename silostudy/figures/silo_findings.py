"""Findings of silos of grains beside every theory and code, as numbers with an interval and a verdict."""

from pathlib import Path
from typing import Any

import pandas as pd
import xarray as xr

from silostudy.figures.beside import judged, methods_of, row, settings
from silostudy.figures.findings_of_grains import PHASES, of_grains
from silostudy.figures.style import save_table

OF_HOPPER = {
    "code_over_grains_hopper": "mean pressure on the hopper over the grains'",
    "code_over_grains_transition": "hopper pressure at the transition over the grains'; in flow their largest window",
    "code_over_grains_hopper_force": "downward force on the hopper, with a ring force, over the grains'; in flow their largest",
}


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the table: a row a setting, quantity and method."""
    save_table(findings(cube), stem.with_suffix(".csv"))


def findings(cube: xr.Dataset) -> pd.DataFrame:
    """The table: of the grains themselves first, then of each method beside them."""
    return pd.DataFrame(
        [line for setting, silo in settings(cube) for line in (*of_grains(silo, setting), *_methods(silo, setting))]
    )


def _methods(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    lines = _in_hopper(silo, setting) if "code_over_grains_hopper" in silo else []
    for phase in PHASES:
        for method in methods_of(silo, phase):
            about = {**setting, "of": method, "phase": phase}
            said = silo.sel(pressure_method=method, phase=phase)
            lines.append(judged(said["code_over_grains_force"], **about, quantity="wall force over the grains'"))
            lines.append(
                row(said["code_profile_residual"], **about, quantity="root mean square of pressure over the grains', less 1")
            )
            for area in silo["averaging"].values:
                lines.append(judged(said["code_over_grains_peak"].sel(averaging=area), **about, area=str(area),
                                    quantity="least pressure over the grains' largest mean on an area"))  # fmt: skip
    return lines


def _in_hopper(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    """Loads of methods on the hopper beside the grains': mean pressure, largest next to the transition, and downward force."""
    lines = []
    for phase in PHASES:
        for method in map(str, silo["pressure_method"].values):
            said, about = silo.sel(pressure_method=method, phase=phase), {**setting, "of": method, "phase": phase}
            for name, quantity in OF_HOPPER.items():
                if name in silo and said[name].notnull().any():
                    lines.append(judged(said[name], **about, quantity=quantity))
    return lines
