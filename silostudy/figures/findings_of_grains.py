"""Findings of silos of grains themselves: walls at rest and in flow, all around, on the hopper, and the rate of flow."""

from typing import Any

import numpy as np
import xarray as xr

from silostudy.figures.beside import NONE_HERE, hopper_rise, judged, row
from silostudy.figures.findings_of_channel import of_channel

PHASES = ("filling", "discharge")
STAGNANT = "height up to which grains do not slide down the wall in flow (m), to half a level: effective transition"
LAWS = {
    "least_law_mass_flow": "least mass flow by Beverloo's law (C = 0.55, edge of 2 grains) over the grains'",
    "largest_law_mass_flow": "largest mass flow by Beverloo's law (C = 0.65, edge of 1 grain) over the grains'",
}

Lines = list[dict[str, Any]]


def of_grains(silo: xr.Dataset, setting: dict[str, Any]) -> Lines:
    """Rows of a setting that tell what the grains did; of methods where one number of theirs stands beside it."""
    about = {**setting, "of": "grains"}
    friction = silo["mobilised_wall_friction"]
    lines = [row(silo["contents_unit_weight"], **about, quantity="unit weight at rest (N/m3)")]
    lines += [
        row(friction.sel(phase=phase), **about, quantity="wall shear over wall pressure", phase=phase) for phase in PHASES
    ]
    lines.append(row(silo["lateral_pressure_ratio_at_rest"], **about, quantity="lateral pressure ratio at rest"))
    lines.append(height_not_sliding(silo, about))
    lines += [
        row(silo["largest_over_rest"].sel(phase=phase, averaging=area), **about, phase=phase, area=str(area),
            quantity="largest mean on an area over the ring's mean at rest")
        for phase in PHASES for area in silo["averaging"].values if (phase, area) != ("filling", "ring")
    ]  # fmt: skip
    return lines + _around(silo, about) + of_channel(silo, about) + _on_hopper(silo, about) + _rate(silo, about)


def height_not_sliding(silo: xr.Dataset, about: dict[str, Any]) -> dict[str, Any]:
    """Height (m) where grains begin to slide: no better known than to half a level, however alike the fillings are."""
    line = row(silo["stagnant_wall_height"], **about, quantity=STAGNANT)
    return _to_half(line, float(abs(silo["level_depth"].diff("wall_level")).median()))


def _to_half(line: dict[str, Any], step: float) -> dict[str, Any]:
    """A row of a height that is read in levels: its interval wider by half of one, and none below zero."""
    return line | {"low_95": float(np.maximum(0.0, line["low_95"] - step / 2)), "high_95": line["high_95"] + step / 2}


def _around(silo: xr.Dataset, about: dict[str, Any]) -> Lines:
    """Distance of cells from the mean around their level, and whether a method's patch load covers the largest."""
    if "largest_over_ring" not in silo:
        return []
    lines = []
    for phase in PHASES:
        largest = silo["largest_over_ring"].sel(phase=phase)
        here = {**about, "phase": phase}
        lines.append(row(silo["deviation_around"].sel(phase=phase), **here, quantity="deviation around a level over its mean"))
        lines.append(row(largest, **here, quantity="largest cell over the mean around its level, less 1"))
        patches = silo["code_patch_factor"].sel(phase=phase) if "code_patch_factor" in silo else silo["pressure_method"][:0]
        for method in map(str, patches["pressure_method"].values):
            factor = float(patches.sel(pressure_method=method))
            if np.isfinite(factor):
                cover = judged(factor / largest, **here | {"of": method}, quantity="patch load factor over the largest cell's")
                lines.append(cover if factor else cover | {"verdict": NONE_HERE})
    return lines


def _on_hopper(silo: xr.Dataset, about: dict[str, Any]) -> Lines:
    """Wall friction on the hopper; how far the pressure rises in flow, where, down to where, and when at the transition."""
    if silo["hopper_switch_factor"].isnull().all():
        return []
    most, height = hopper_rise(silo)
    step = float(abs(silo["hopper_level_position"].diff("wall_level")).median())
    risen = "height from which up the hopper feels more in flow than at rest, over the same, to half a level"
    lines = [
        row(most, **about, quantity="largest ring mean on the hopper in flow over that at rest"),
        _to_half(row(height, **about, quantity="height of the largest rise over the transition's, to half a level"), step),
        _to_half(row(_risen_from(silo), **about, quantity=risen), step),
        row(silo["hopper_switch_time"].isel(wall_level=-1), **about, quantity="time at which the transition feels most (s)"),
    ]
    if "hopper_mobilised_friction" in silo:
        friction = silo["hopper_mobilised_friction"]
        lines += [row(friction.sel(phase=phase), **about, quantity="wall shear over pressure on the hopper", phase=phase)
                  for phase in PHASES]  # fmt: skip
    return lines


def _risen_from(silo: xr.Dataset) -> xr.DataArray:
    """Height over the transition's of the level from which up all feel more in flow than at rest; missing without one."""
    from_above = (silo["hopper_switch_factor"] > 1.0).isel(wall_level=slice(None, None, -1))
    risen = from_above.cumprod("wall_level") > 0
    return (1.0 - silo["hopper_level_position"]).isel(wall_level=slice(None, None, -1)).where(risen).min("wall_level")


def _rate(silo: xr.Dataset, about: dict[str, Any]) -> Lines:
    """Mass flow, beside the least and largest that Beverloo's law gives for an outlet in a flat floor."""
    if "filling_mass_flow" not in silo or silo["least_law_mass_flow"].isnull().all():
        return []
    flow, law = silo["filling_mass_flow"], {**about, "of": "beverloo"}
    least, largest = (row(silo[name] / flow, **law, quantity=quantity) for name, quantity in LAWS.items())
    return [row(flow, **about, quantity="mass flow (kg/s)"), least, {**largest, "verdict": _by_law(least, largest)}]


def _by_law(least: dict[str, Any], largest: dict[str, Any]) -> str:
    """A plain word on where the grains' mass flow lies beside both ends of a law."""
    if largest["high_95"] < 1.0:
        return "the grains flow faster"
    if least["low_95"] > 1.0:
        return "the grains flow slower"
    return "holds the grains' rate" if least["high_95"] <= 1.0 <= largest["low_95"] else "may hold the grains' rate"
