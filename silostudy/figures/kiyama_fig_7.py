"""Contact forces on the side walls over depth at rest, after the source's Fig. 7, with the shear beside them."""

from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import xarray as xr

from silostudy.figures import discs
from silostudy.figures.style import LINES, MARKERS, WIDTH, foot, headline, save


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the figure and its numbers: every contact of both walls, depth from the top of the fill."""
    numbers = pd.concat([_contacts(cube, film) for film in discs.films(cube, moving=False)], ignore_index=True)
    figure, (normal, shear) = plt.subplots(1, 2, figsize=(WIDTH, 7.4), sharey=True)
    packings = list(numbers.groupby("packing", sort=False))
    for k, (packing, group) in enumerate(packings):
        mean = group.groupby("level").mean(numeric_only=True)
        look = {
            "color": plt.colormaps["viridis"](k / max(1, len(packings) - 1) * 0.8),
            "marker": MARKERS[k % len(MARKERS)],
            "linestyle": LINES[k % len(LINES)],
            "markersize": 5,
            "linewidth": 1.3,
        }
        normal.plot(mean.normal_disc_weights, mean.depth_cm, label=packing, **look)
        shear.plot(mean.shear_disc_weights, mean.depth_cm, **look)
    normal.invert_yaxis()
    normal.set(xlabel="normal force $P_y$ of a contact (disc weights)", ylabel="depth below the top of the fill (cm)")
    normal.set_title("pushing on the wall")
    shear.set(xlabel="shear of a contact (disc weights)", title="along the wall: positive carries the fill")
    shear.axvline(0, color="black", linewidth=0.8)
    normal.secondary_xaxis("top", functions=_newtons(cube)).set_xlabel("N/m")
    headline(figure, _message(numbers))
    about = "Contacts at the side walls at rest, ideal starts, mean of both walls, by packing."
    foot(figure, f"{cube.attrs['title']}.", about, handles=normal.get_legend_handles_labels()[0])
    save(figure, numbers, stem)


def _message(numbers: pd.DataFrame) -> str:
    """Message: how the largest force on a side wall differs from packing to packing, and between which ends its shear lies."""
    push = numbers.groupby(["packing", "level"], sort=False)["normal_disc_weights"].mean().groupby("packing").max()
    shear = numbers.groupby(["packing", "level"])["shear_disc_weights"].mean()
    largest = f"{push.max():.0f} disc weights in {push.idxmax()}, {push.min():.0f} in {push.idxmin()}"
    return f"A contact pushes a side wall with at most {largest}; shear goes both ways, {shear.min():.1f} to {shear.max():.1f}"


def _newtons(cube: xr.Dataset):
    weight = discs.disc_weight(cube)
    return lambda value: value * weight, lambda value: value / weight


def _contacts(cube: xr.Dataset, film: int) -> pd.DataFrame:
    """Contacts with the side walls, numbered from the top of each wall down."""
    snapshot, across = discs.frames(cube, film)[0], int(cube["film_across"][film])
    here = (cube["contact_snapshot"].values == snapshot) & (cube["contact_on_wall"].values == 1)
    x, y, fx, fy = (cube[f"contact_{key}"].values[here] for key in ("x", "y", "force_x", "force_y"))
    radius, width = float(cube.attrs["radius_m"]), float(cube.attrs["width_m"])
    top = float(np.nanmax(cube["disc_y"].values[snapshot])) + radius
    walls = []
    for wall, side in (("left", x < 1e-6), ("right", x > width - 1e-6)):
        order = np.argsort(-y[side])
        weight = discs.disc_weight(cube)
        walls.append(pd.DataFrame({
            "packing": f"{across - 1}/{across}", "wall": wall, "level": np.arange(int(side.sum())),
            "depth_cm": (top - y[side][order]) * discs.CM,
            "normal_disc_weights": np.abs(fx[side][order]) / weight, "shear_disc_weights": fy[side][order] / weight,
        }))  # fmt: skip
    return pd.concat(walls)
