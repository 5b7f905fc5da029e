"""A scene of spheres: force chains before and in discharge, the force on each surface in time, the mass that leaves."""

from pathlib import Path

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
FORCE = "force_N"  # column of the forces
MASS = "mass_kg"  # column of the mass


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure: slices of snapshots, the forces on the surfaces, and the mass through the outlets."""
    in_time.check_recorded(cube)
    force = in_time.forces(cube, cube["surface_normal_force_mean"].values, FORCE)
    flow = flow_of(cube, "grain_mass", MASS, "kg")
    shots = moments.snapshots(cube, _sizes(cube), flow)
    near = _near(cube)
    largest = _largest(near, shots)
    tables = [_chains(near, shot, LONGEST * float(cube["grain_radius"].mean()) / largest) for shot in shots]
    box = silo_cut.view(cube, float(cube["grain_z"].isel(snapshot=shots).max()))
    box = silo_cut.reaching(box, pd.concat(tables).filter(like="_cm").to_numpy())
    figure, panels, wide = in_time.lay_out(cube, shots, force, flow, box)
    for number, (shot, table) in enumerate(zip(shots, tables, strict=True)):
        _draw_slice(panels[str(number)], cube, shot, table, largest)
    lines = in_time.draw_forces(panels, force, FORCE, "N", cube)
    if "mass" in panels:
        draw_flow(panels["mass"], flow, silo_cut.off_the_slice(cube))
        panels["mass"].set(ylabel="mass that has passed (kg)")
    moments.mark_events([panels[name] for name in in_time.LOWER if name in panels], cube, wide)
    headline(figure, in_time.message(cube, force, FORCE, "N", flow))
    about = (
        "Spheres that the plane through the axis cuts, and contacts within a mean radius of it: a line as long and wide as the "
    )
    about += f"force in the plane, at most {largest:.3g} N. Forces: normal, mean of each "
    about += f"window{in_time.left_out(cube)}."
    foot(figure, f"{cube.attrs['title']}.", f"{moments.told(shots, cube, flow)}{about}", handles=lines)
    save(figure, pd.concat([*tables, force, flow.table], ignore_index=True), stem)


def _sizes(cube: xr.Dataset) -> np.ndarray:
    """Size (N) of the force of each contact."""
    if "contact_x" not in cube:
        return np.empty(0)
    return np.linalg.norm([cube[f"contact_force_{way}"].values for way in "xyz"], axis=0)


def _near(cube: xr.Dataset) -> xr.Dataset:
    """The contacts within a mean radius of the plane through the axis: snapshot, place (m) and force (N) of each."""
    names = ["contact_snapshot", *(f"contact_{kind}{way}" for kind in ("", "force_") for way in "xyz")]
    if "contact_y" not in cube:  # no two spheres touch
        return xr.Dataset({name: ("contact", np.empty(0)) for name in names})
    return cube[names].isel(contact=np.abs(cube["contact_y"].values) < float(cube["grain_radius"].mean()))


def _largest(near: xr.Dataset, shots: list[int]) -> float:
    """Largest force (N) in the plane in some snapshots; one where nothing touches."""
    shown = near.isel(contact=np.isin(near["contact_snapshot"].values, shots))
    return float(np.hypot(shown["contact_force_x"].values, shown["contact_force_z"].values).max(initial=0.0)) or 1.0


def _draw_slice(panel: Axes, cube: xr.Dataset, snapshot: int, chains: pd.DataFrame, largest: float) -> None:
    """The spheres that the plane cuts, as the circles that it cuts them in, and contacts, as wide as their force."""
    shot, radius = cube.isel(snapshot=snapshot), cube["grain_radius"].values
    x, y, z = (shot[f"grain_{way}"].values for way in "xyz")
    cut = np.flatnonzero(np.abs(y) < radius)
    size = 2.0 * np.sqrt(radius[cut] ** 2 - y[cut] ** 2) * CM
    style: dict = {"facecolors": "0.92", "edgecolors": "0.75", "linewidths": 0.4, "gid": AID}
    panel.add_collection(EllipseCollection(size, size, 0.0, units="xy", offsets=np.column_stack([x[cut], z[cut]]) * CM,
                                           offset_transform=panel.transData, **style))  # fmt: skip
    silo_cut.draw(panel, cube, float(shot["snapshot_time"]))
    widths = np.clip(4.0 * chains["force_N"] / largest, 0.2, 4.0)
    ends = chains.filter(like="_cm").to_numpy().reshape(-1, 2, 2)
    panel.add_collection(LineCollection(list(ends), linewidths=widths, colors="k"))
    panel.set_title(f"{float(shot['snapshot_time']):.3g} s: {np.isfinite(z).sum()} spheres")


def _chains(near: xr.Dataset, snapshot: int, scale: float) -> pd.DataFrame:
    """Contact forces (N) near the plane, and the ends (cm) of the lines that they are drawn as; scale: half a line (m/N)."""
    here = near["contact_snapshot"].values == snapshot
    place, force = (np.stack([near[f"contact_{kind}{way}"].values[here] for way in "xz"], axis=1) for kind in ("", "force_"))
    half = force * scale
    ends = np.hstack([place - half, place + half]) * CM
    table = pd.DataFrame(ends, columns=["from_across_cm", "from_height_cm", "to_across_cm", "to_height_cm"])
    return table.assign(force_N=np.hypot(*force.T), snapshot=snapshot)
