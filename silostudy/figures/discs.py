"""Discs of a film: force chains, their first heights, and the box with its slit."""

import numpy as np
import pandas as pd
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection, LineCollection

from silostudy.figures.style import AID
from silostudy.tables.constants import STANDARD_GRAVITY

DIAMETER_IS = 50 / np.pi  # disc weights: a line as long as a diameter, as in the source's Fig. 6
CM = 100.0


def disc_weight(cube: xr.Dataset) -> float:
    """Weight of a disc (N/m)."""
    return float(cube.attrs["density_kg_m3"]) * np.pi * float(cube.attrs["radius_m"]) ** 2 * STANDARD_GRAVITY


def films(cube: xr.Dataset, *, moving: bool) -> list[int]:
    """Films with frames of a discharge, or those of a packing at rest."""
    count = np.bincount(cube["snapshot_film"].values, minlength=cube.sizes["film"])
    return [int(film) for film in np.flatnonzero(count > 1 if moving else count == 1)]


def frames(cube: xr.Dataset, film: int) -> np.ndarray:
    """Numbers of a film's snapshots."""
    return np.flatnonzero(cube["snapshot_film"].values == film)


def name(cube: xr.Dataset, film: int) -> str:
    """A film in words: packing, run, remedy."""
    here = cube.isel(film=film)
    across, run = int(here["film_across"]), int(here["film_run"])
    text = f"{across - 1}/{across}, " + ("ideal start" if run == 0 else f"run {run}")
    return text + (", a disc of the roof removed at each stop" if int(here["film_remedy"]) else "")


def draw_box(panel: Axes, cube: xr.Dataset, *, opened: bool) -> None:
    """Walls and floor (cm), with the slit where it is open; one centimetre is as long across as up."""
    width, height = (float(cube.attrs[key]) * CM for key in ("width_m", "height_m"))
    half = float(cube.attrs["slit_width_m"]) * CM / 2
    panel.plot([0, 0], [0, height], [width, width], [0, height], color="black", linewidth=1, gid=AID)
    edges = [(0, width / 2 - half), (width / 2 + half, width)] if opened else [(0, width)]
    for left, right in edges:
        panel.plot([left, right], [0, 0], color="black", linewidth=1, gid=AID)
    panel.set(xlim=(-1, width + 1), ylim=(-4, height), aspect="equal")
    panel.grid(False)


def contacts(cube: xr.Dataset, snapshot: int, *, scale: float = DIAMETER_IS) -> pd.DataFrame:
    """Contact forces of a snapshot (disc weights), and the ends (cm) of the lines they are drawn as: see `chains`."""
    here = cube["contact_snapshot"].values == snapshot
    place, force = (np.stack([cube[f"contact_{kind}{way}"].values[here] for way in "xy"], axis=1) for kind in ("", "force_"))
    half = 0.5 * force / (scale * disc_weight(cube)) * 2 * float(cube.attrs["radius_m"])
    ends = np.hstack([place - half, place + half]) * CM
    table = pd.DataFrame(ends, columns=["from_across_cm", "from_height_cm", "to_across_cm", "to_height_cm"])
    return table.assign(force_disc_weights=np.hypot(*force.T) / disc_weight(cube))


def chains(table: pd.DataFrame, *, scale: float = DIAMETER_IS) -> LineCollection:
    """Contact forces as lines centred on their contacts: length and width by force, `scale` disc weights a diameter."""
    lines = table.filter(like="_cm").to_numpy().reshape(-1, 2, 2)
    widths = np.clip(0.35 + 0.9 * table.force_disc_weights / scale, 0.35, 4.0)
    return LineCollection(list(lines), linewidths=widths, colors="black", capstyle="butt")


def circles(cube: xr.Dataset, snapshot: int, panel: Axes, **style) -> EllipseCollection:
    """The discs of a snapshot."""
    places = centres(cube, snapshot).to_numpy()
    size = np.full(len(places), 2 * float(cube.attrs["radius_m"]) * CM)
    return EllipseCollection(
        size, size, np.zeros(len(size)), units="xy", offsets=places, offset_transform=panel.transData, **style
    )


def centres(cube: xr.Dataset, snapshot: int) -> pd.DataFrame:
    """Centres (cm) of the discs of a snapshot that are left."""
    frame = cube.isel(snapshot=snapshot)
    return pd.DataFrame({"across_cm": frame["disc_x"].values * CM, "height_cm": frame["disc_y"].values * CM}).dropna()


def first_height(cube: xr.Dataset, snapshot: int, first: int) -> np.ndarray:
    """Height (cm) in the snapshot `first` of the discs that are left in another one."""
    left = np.isfinite(cube["disc_x"].values[snapshot])
    return cube["disc_y"].values[first][left] * CM


def scale_bar(panel: Axes, cube: xr.Dataset, x: float, y: float, scale: float = DIAMETER_IS) -> None:
    """A line as long as a diameter, with the force it stands for."""
    diameter = 2 * float(cube.attrs["radius_m"]) * CM
    panel.plot([x, x + diameter], [y, y], color="black", linewidth=1.25, solid_capstyle="butt", gid=AID)
    text = f" {scale:.1f} disc weights ({scale * disc_weight(cube):.0f} N/m)"
    panel.text(x + diameter, y, text, va="center", fontsize="small")
