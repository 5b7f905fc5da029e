"""Lines of `silostudy compare` on what was measured in a silo of this size, and the methods next below and above it."""

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    import xarray as xr


def told(cube: "xr.Dataset") -> list[str]:
    """A line for every measured wall pressure of a silo of these dimensions, whatever solid the study holds."""
    from silostudy.cube.measured import deviations, neighbour, pressures_measured_in

    lines = []
    for measurement in pressures_measured_in(cube):
        table = deviations(cube, measurement, list(map(str, cube["pressure_method"].values)))
        if not (table.phase == measurement.phase).any():
            continue
        neighbours = [(where, *neighbour(table, where)) for where in ("below", "above")]
        words = [
            f"next {where} {', '.join(names)} ({off:+.0%})" if names else f"none {where}" for where, names, off in neighbours
        ]
        what = f"{measurement.quantity} {measurement.told} at {measurement.depth:g} m, {measurement.phase}, {measurement.solid}"
        lines.append(f"measured in a silo of this size ({measurement.source}): {what}: {'; '.join(words)}")
    return lines
