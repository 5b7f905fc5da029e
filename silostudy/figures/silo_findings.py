"""Findings of silos of grains beside every theory and code, as numbers with an interval and a verdict."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures.beside import hopper_rise, methods_of, row, settings, verdict
from silostudy.figures.style import save_table

PHASES = ("filling", "discharge")


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the table: a row a setting, quantity and method."""
    save_table(findings(cube), stem.with_suffix(".csv"))


def findings(cube: xr.Dataset) -> pd.DataFrame:
    """The table: of the grains themselves first, then of each method beside them."""
    return pd.DataFrame(
        [line for setting, silo in settings(cube) for line in (*_grains(silo, setting), *_methods(silo, setting))]
    )


def _grains(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    lines = [row(silo["contents_unit_weight"], **setting, of="grains", quantity="unit weight at rest (N/m3)")]
    friction = silo["mobilised_wall_friction"]
    lines += [row(friction.sel(phase=phase), **setting, of="grains", quantity="wall shear over wall pressure", phase=phase)
              for phase in PHASES]  # fmt: skip
    lines.append(row(silo["lateral_pressure_ratio_at_rest"], **setting, of="grains", quantity="lateral pressure ratio at rest"))
    quantity = "height up to which grains do not slide down the wall in flow (m): effective transition"
    lines.append(row(silo["stagnant_wall_height"], **setting, of="grains", quantity=quantity))
    lines += [
        row(silo["largest_over_rest"].sel(phase=phase, averaging=area), **setting, of="grains", phase=phase, area=str(area),
            quantity="largest mean on an area over the ring's mean at rest")
        for phase in PHASES for area in silo["averaging"].values
    ]  # fmt: skip
    lines += _around(silo, setting)
    if silo["hopper_switch_factor"].notnull().any():
        quantity = "largest ring mean on the hopper in flow over that at rest"
        lines.append(row(hopper_rise(silo)[0], **setting, of="grains", quantity=quantity))
        lines += _switch(silo, setting)
    return lines


def _around(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    """Distance of cells from the mean around their level, and whether a method's patch load covers the largest."""
    if "largest_over_ring" not in silo:
        return []
    lines = []
    for phase in PHASES:
        largest = silo["largest_over_ring"].sel(phase=phase)
        about = {**setting, "of": "grains", "phase": phase}
        lines.append(row(silo["deviation_around"].sel(phase=phase), **about, quantity="deviation around a level over its mean"))
        lines.append(row(largest, **about, quantity="largest cell over the mean around its level, less 1"))
        patches = silo["code_patch_factor"].sel(phase=phase) if "code_patch_factor" in silo else silo["pressure_method"][:0]
        for method in map(str, patches["pressure_method"].values):
            factor = float(patches.sel(pressure_method=method))
            if np.isfinite(factor):
                cover = row(factor / largest, **about | {"of": method}, quantity="patch load factor over the largest cell's")
                lines.append({**cover, "verdict": verdict(cover["low_95"], cover["high_95"])})
    return lines


def _switch(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    """Height on the hopper where the rise is largest, and when its outlet and its transition feel most."""
    time = silo["hopper_switch_time"]
    about = {**setting, "of": "grains"}
    return [
        row(hopper_rise(silo)[1], **about, quantity="height of the largest rise over the transition's"),
        row(time.isel(wall_level=0), **about, quantity="time at which the outlet feels most (s)"),
        row(time.isel(wall_level=-1), **about, quantity="time at which the transition feels most (s)"),
    ]


def _methods(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    lines = _in_hopper(silo, setting) if "code_over_grains_hopper" in silo else []
    for phase in PHASES:
        for method in methods_of(silo, phase):
            about = {**setting, "of": method, "phase": phase}
            said = silo.sel(pressure_method=method, phase=phase)
            lines.append(row(said["code_over_grains_force"], **about, quantity="wall force over the grains'"))
            lines.append(
                row(said["code_profile_residual"], **about, quantity="root mean square of pressure over the grains', less 1")
            )
            for area in silo["averaging"].values:
                cover = row(said["code_over_grains_peak"].sel(averaging=area), **about, area=str(area),
                            quantity="least pressure over the grains' largest mean on an area")  # fmt: skip
                lines.append({**cover, "verdict": verdict(cover["low_95"], cover["high_95"])})
    return lines


def _in_hopper(silo: xr.Dataset, setting: dict[str, Any]) -> list[dict[str, Any]]:
    """Pressures of methods on the hopper beside the grains': the mean in each phase, and the largest next to the transition."""
    lines = []
    for phase in PHASES:
        for method in map(str, silo["pressure_method"].values):
            said = silo.sel(pressure_method=method, phase=phase)
            if said["code_over_grains_hopper"].isnull().all():
                continue
            about = {**setting, "of": method, "phase": phase}
            lines.append(row(said["code_over_grains_hopper"], **about, quantity="mean pressure on the hopper over the grains'"))
            cover = row(said["code_over_grains_transition"], **about,
                        quantity="hopper pressure at the transition over the grains' largest window there")  # fmt: skip
            lines.append({**cover, "verdict": verdict(cover["low_95"], cover["high_95"])})
    return lines
