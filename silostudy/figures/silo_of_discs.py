"""A scene of discs: force chains before and in discharge, the force on each wall in time, and the mass that leaves."""

from pathlib import Path
from typing import Any

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection

from silostudy.figures import in_time, moments, silo_cut
from silostudy.figures.flow_in_time import draw_flow, flow_of
from silostudy.figures.style import AID, foot, headline, save

CM = 100.0
LONGEST = 2.0  # diameters: the line of the largest contact force
FORCE = "force_kN_m"  # column of the forces
MASS = "mass_kg_m"  # column of the mass


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure: the chains of snapshots, the forces on the walls, and the mass through the outlets."""
    in_time.check_recorded(cube)
    contacts = _contacts(cube)
    force = in_time.forces(cube, cube["surface_normal_force_mean"].values / 1e3, FORCE)
    flow = flow_of(cube, "disc_mass", MASS, "kg/m")
    shots = moments.snapshots(cube, contacts["force_N_m"].to_numpy(), flow)
    seen = contacts["force_N_m"][contacts["contact_snapshot"].isin(shots)]
    largest = float(seen.max()) if len(seen) else 1.0
    tables = [_chains(cube, contacts, shot, largest) for shot in shots]
    box = silo_cut.view(cube, float(cube["disc_y"].isel(snapshot=shots).max()))
    box = silo_cut.reaching(box, pd.concat(tables).filter(like="_cm").to_numpy())
    figure, panels, wide = in_time.lay_out(cube, shots, force, flow, box)
    for number, (shot, table) in enumerate(zip(shots, tables, strict=True)):
        _draw_chains(panels[str(number)], cube, shot, table, largest)
    lines = in_time.draw_forces(panels, force, FORCE, "kN/m", cube)
    if "mass" in panels:
        draw_flow(panels["mass"], flow)
        panels["mass"].set(ylabel="mass that has left (kg/m)")
    moments.mark_events([panels[name] for name in in_time.LOWER if name in panels], cube, wide)
    headline(figure, in_time.message(cube, force, FORCE, "kN/m", flow))
    chains = (
        f"Line of a contact: as long and wide as its force, at most {largest:.3g} N/m. Forces: normal, mean of each "
        f"window{in_time.left_out(cube)}."
    )
    foot(figure, f"{cube.attrs['title']}.", f"{moments.told(shots, cube, flow)}{chains}", handles=lines)
    save(figure, pd.concat([*tables, force, flow.table], ignore_index=True), stem)


def _contacts(cube: xr.Dataset) -> pd.DataFrame:
    """Snapshot, place (m), force and its size (N/m) of each contact."""
    names = ["contact_snapshot", *(f"contact_{kind}{way}" for kind in ("", "force_") for way in "xy")]
    table = pd.DataFrame({name: cube[name].values if name in cube else np.empty(0) for name in names})
    return table.assign(force_N_m=np.hypot(table["contact_force_x"], table["contact_force_y"]))


def _chains(cube: xr.Dataset, contacts: pd.DataFrame, snapshot: int, largest: float) -> pd.DataFrame:
    """Contact forces (N/m) of a snapshot, and the ends (cm) of the lines that they are drawn as."""
    own = contacts[contacts["contact_snapshot"] == snapshot]
    place, force = (own[[f"contact_{kind}{way}" for way in "xy"]].to_numpy() for kind in ("", "force_"))
    half = force / largest * LONGEST * float(cube["disc_radius"].mean())
    ends = np.hstack([place - half, place + half]) * CM
    table = pd.DataFrame(ends, columns=["from_across_cm", "from_height_cm", "to_across_cm", "to_height_cm"])
    return table.assign(force_N_m=own["force_N_m"].to_numpy(), snapshot_s=float(cube["snapshot_time"][snapshot]))


def _draw_chains(panel: Axes, cube: xr.Dataset, snapshot: int, table: pd.DataFrame, largest: float) -> None:
    """The discs of a snapshot, and its contacts, as wide as their force over the largest (N/m)."""
    x, y = (cube[f"disc_{way}"].isel(snapshot=snapshot).values * CM for way in "xy")
    there, size = np.isfinite(x), 2 * cube["disc_radius"].values * CM
    style: dict[str, Any] = {
        "units": "xy",
        "transOffset": panel.transData,
        "facecolors": "0.92",
        "edgecolors": "0.7",
        "linewidths": 0.5,
    }
    offsets = np.column_stack([x[there], y[there]])
    panel.add_collection(EllipseCollection(size[there], size[there], 0.0, offsets=offsets, gid=AID, **style))
    silo_cut.draw(panel, cube, float(cube["snapshot_time"][snapshot]))
    widths = np.clip(4.0 * table.force_N_m / largest, 0.3, 4.0)
    panel.add_collection(
        LineCollection(list(table.filter(like="_cm").to_numpy().reshape(-1, 2, 2)), linewidths=widths, colors="k")
    )
    panel.set_title(f"{float(cube['snapshot_time'][snapshot]):.3g} s: {there.sum()} discs")
