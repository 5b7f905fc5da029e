"""A bin of spheres in motion: a slice through its axis, spheres coloured by speed."""

from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection

from silostudy.figures.bin import outline
from silostudy.figures.style import foot, headline, plt
from silostudy.files import replacing

FRAMES_A_SECOND = 8
MOST = 60  # frames
DPI = 100  # at which small words have 12 px
FASTEST = 1.0  # m/s: end of the colour scale
CM = 100.0
BELOW = 2.0  # cm that are shown below the outlet


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes an animated WebP, which browsers play: as many snapshots as MOST, even in time."""
    shots = np.unique(np.linspace(0, cube.sizes["snapshot"] - 1, min(MOST, cube.sizes["snapshot"])).round().astype(int))
    half, top = (float(cube.attrs[name]) * CM for name in ("half_width_m", "top_height_m"))
    figure, panel = plt.subplots(figsize=(5.0, min(8.0, 2.4 + 3.0 * (top + BELOW) / (2.0 * half))))
    plugs = outline(panel, cube)
    panel.set(xlabel="across (cm)", ylabel="height above the outlet (cm)", aspect="equal")
    panel.set(xlim=(-half - 0.5, half + 0.5), ylim=(-BELOW, top))
    panel.grid(False)
    shown = panel.add_collection(_slice(cube, shots[-1], panel))
    figure.colorbar(shown, ax=panel, label="speed of the sphere (m/s)", shrink=0.6)
    headline(figure, _message(cube))
    foot(figure, f"{cube.attrs['title']}.", "A slice through the axis: the circles in which it cuts the spheres.")

    def show(number: int) -> None:
        nonlocal shown
        shown.remove()
        shown = panel.add_collection(_slice(cube, shots[number], panel))
        time = float(cube["snapshot_time"][shots[number]])
        for plug, opened in plugs:
            plug.set_visible(not time > opened)
        shut = sum(plug.get_visible() for plug, _ in plugs)
        panel.set_title(f"t = {time:.2f} s, {'outlet shut' if shut == len(plugs) else 'outlet open'}")

    animation = FuncAnimation(figure, show, frames=len(shots), init_func=lambda: None)
    with replacing(stem.with_suffix(".webp")) as temporary:
        animation.save(temporary, writer=PillowWriter(fps=FRAMES_A_SECOND), dpi=DPI)
    plt.close(figure)


def _message(cube: xr.Dataset) -> str:
    """Message: how much passes the outlet by the end of the film, and in which time."""
    if "outflow_mass" not in cube:
        return "No sphere passes the outlet"
    passed, filled = float(cube["outflow_mass"][-1]), float(cube["grain_mass"].sum())
    return f"{passed:.3g} of {filled:.3g} kg pass the outlet in {float(np.ptp(cube['outflow_time'].values)):.2g} s"


def _slice(cube: xr.Dataset, shot: int, panel: Axes) -> EllipseCollection:
    """The spheres that the plane through the axis cuts, as the circles that it cuts them in, those behind first."""
    frame = cube.isel(snapshot=shot)
    x, y, z, u, v, w = (frame[f"grain_{name}"].values for name in "xyzuvw")
    radius = cube["grain_radius"].values
    cut = np.flatnonzero(np.abs(y) < radius)
    size = 2.0 * np.sqrt(radius[cut] ** 2 - y[cut] ** 2) * CM
    circles = EllipseCollection(
        size, size, np.zeros(len(cut)), units="xy", offsets=np.column_stack([x[cut], z[cut]]) * CM,
        offset_transform=panel.transData, cmap="YlOrRd", edgecolors="#888888", linewidths=0.3,
    )  # fmt: skip
    circles.set_array(np.sqrt(u[cut] ** 2 + v[cut] ** 2 + w[cut] ** 2))
    circles.set_clim(0.0, FASTEST)
    return circles
