"""A scene of spheres: force chains before and in discharge, the force on each surface in time, the mass that leaves."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection

from silostudy.figures import in_time
from silostudy.figures.bin import opened_at, outline
from silostudy.figures.style import AID, WIDTH, foot, headline, save

CM = 100.0
LONGEST = 3.0  # diameters: the line of the largest contact force
FORCE = "force_N"  # column of the forces
MASS = "mass_kg"  # column of the mass


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure: slices of two snapshots, the forces on the surfaces, and the mass through the outlets."""
    in_time.check_recorded(cube, "surface_normal_force")
    figure, panels = plt.subplot_mosaic([["rest", "flow"], ["force", "mass"]], figsize=(WIDTH, 9.2), height_ratios=(1.7, 1))
    near, tables = _near(cube), []
    for panel, snapshot in zip((panels["rest"], panels["flow"]), in_time.snapshots(cube, "outflow_time"), strict=True):
        tables.append(_chains(near, snapshot, LONGEST * float(cube["grain_radius"].mean()) / _largest(near)))
        _draw_slice(panel, cube, snapshot, tables[-1])
    push = cube["surface_normal_force"].values
    force = in_time.forces(cube["window_time"].values, push, cube["surface"].values, FORCE)
    flow = in_time.flow_of(cube, "outflow_time", "outflow_mass", "grain_mass", MASS, "kg")
    lines = in_time.draw_forces(panels["force"], force, FORCE, opened_at(cube))
    in_time.draw_flow(panels["mass"], flow)
    panels["force"].set(ylabel="normal force (N)")
    panels["mass"].set(ylabel="mass that has passed (kg)")
    panels["mass"].sharex(panels["force"])
    in_time.mark_events((panels["force"], panels["mass"]), cube)
    headline(figure, in_time.message(cube, force, FORCE, flow))
    about = (
        "Spheres that the plane through the axis cuts, and contacts within a mean radius of it: a line as long and wide as the "
    )
    about += f"force in the plane, at most {_largest(near):.3g} N. Forces: normal, mean of each window."
    foot(figure, f"{cube.attrs['title']}.", about, handles=lines)
    save(figure, pd.concat([*tables, force, flow.table], ignore_index=True), stem)


def _near(cube: xr.Dataset) -> xr.Dataset:
    """The contacts within a mean radius of the plane through the axis: snapshot, place (m) and force (N) of each."""
    names = ["contact_snapshot", *(f"contact_{kind}{way}" for kind in ("", "load_") for way in "xyz")]
    if "contact_y" not in cube:  # no two spheres touch
        return xr.Dataset({name: ("contact", np.empty(0)) for name in names})
    return cube[names].isel(contact=np.abs(cube["contact_y"].values) < float(cube["grain_radius"].mean()))


def _largest(near: xr.Dataset) -> float:
    """Largest force (N) in the plane; one where nothing touches."""
    return float(np.hypot(near["contact_load_x"].values, near["contact_load_z"].values).max(initial=0.0)) or 1.0


def _draw_slice(panel: Axes, cube: xr.Dataset, snapshot: int, chains: pd.DataFrame) -> None:
    """The spheres that the plane cuts, as the circles that it cuts them in, and the contacts near it."""
    outline(panel, cube)
    shot, radius = cube.isel(snapshot=snapshot), cube["grain_radius"].values
    x, y, z = (shot[f"grain_{way}"].values for way in "xyz")
    cut = np.flatnonzero(np.abs(y) < radius)
    size = 2.0 * np.sqrt(radius[cut] ** 2 - y[cut] ** 2) * CM
    style: dict = {"facecolors": "0.92", "edgecolors": "0.75", "linewidths": 0.4, "gid": AID}
    panel.add_collection(EllipseCollection(size, size, 0.0, units="xy", offsets=np.column_stack([x[cut], z[cut]]) * CM,
                                           offset_transform=panel.transData, **style))  # fmt: skip
    widths = np.clip(4.0 * chains["force_N"] / max(chains["force_N"].max(), 1e-300), 0.2, 4.0) if len(chains) else None
    ends = chains.filter(like="_cm").to_numpy().reshape(-1, 2, 2)
    panel.add_collection(LineCollection(list(ends), linewidths=widths, colors="k"))
    half, top = (float(cube.attrs[name]) * CM for name in ("half_width_m", "top_height_m"))
    high = min(top, 1.1 * float(cube["grain_z"].max()) * CM)
    panel.set(xlabel="across (cm)", ylabel="height (cm)", aspect="equal", xlim=(-1.05 * half, 1.05 * half), ylim=(-1.0, high))
    panel.set_title(f"{float(shot['snapshot_time']):.3g} s: {np.isfinite(z).sum()} spheres")
    panel.grid(False)


def _chains(near: xr.Dataset, snapshot: int, scale: float) -> pd.DataFrame:
    """Contact forces (N) near the plane, and the ends (cm) of the lines that they are drawn as; scale: half a line (m/N)."""
    here = near["contact_snapshot"].values == snapshot
    place, force = (np.stack([near[f"contact_{kind}{way}"].values[here] for way in "xz"], axis=1) for kind in ("", "load_"))
    half = force * scale
    ends = np.hstack([place - half, place + half]) * CM
    table = pd.DataFrame(ends, columns=["from_across_cm", "from_height_cm", "to_across_cm", "to_height_cm"])
    return table.assign(force_N=np.hypot(*force.T), snapshot=snapshot)
