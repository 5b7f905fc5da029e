"""A bin of spheres in motion: a slice through its axis, spheres coloured in layers by their height when the outlet opens."""

from pathlib import Path

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import EllipseCollection

from silostudy.figures import layers, silo_cut
from silostudy.figures.bin import opened_at, opening
from silostudy.figures.style import foot, headline, plt

MOST = 60  # frames
CM = 100.0
LEAST = 3.9  # inches: the words beside a silo that is wide and low stand upright
HALF = 0.5  # share of the solid that is out where the headline counts layers
PARTLY = (0.05, 0.95)  # share of a layer that is out while it runs out


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the film: as many snapshots as MOST, even in time, from the one that gives the layers."""
    first = start(cube)
    shots = frames(cube, first)
    left, right, low, high = silo_cut.view(cube, float(cube["grain_z"].isel(snapshot=shots).max()))
    figure, panel = plt.subplots(figsize=(5.0, max(LEAST, min(8.0, 2.4 + 3.0 * (high - low) / (right - left)))))
    silo = silo_cut.draw(panel, cube, 0.0)
    panel.set(xlabel="across (cm)", ylabel="height (cm)", aspect="equal", xlim=(left, right), ylim=(low, high))
    panel.grid(False)
    shown = panel.add_collection(_slice(cube, shots[0], first, panel))
    layers.legend(figure, shown, panel, f"when\n{opening(cube)}" if np.isfinite(opened_at(cube)) else "at the end")
    headline(figure, _message(cube, first))
    foot(figure, f"{cube.attrs['title']}.", "A slice through the axis: the circles in which it cuts the spheres.")

    def show(number: int) -> None:
        nonlocal shown
        shown.remove()
        shown = panel.add_collection(_slice(cube, shots[number], first, panel))
        time = float(cube["snapshot_time"][shots[number]])
        silo.set_segments(silo_cut.standing(cube, time))
        panel.set_title(", ".join(filter(None, (f"t = {time:.2f} s", silo_cut.outlet_words(cube, time)))))

    layers.save(figure, show, len(shots), stem)


def start(cube: xr.Dataset) -> int:
    """Number of the last snapshot before the outlet opens; of all where it does not, and the first where it opens at once."""
    before = np.flatnonzero(cube["snapshot_time"].values <= opened_at(cube))
    return int(before[-1]) if len(before) else 0


def frames(cube: xr.Dataset, first: int) -> np.ndarray:
    """Numbers of the snapshots that are shown: those from `first` on that hold spheres; of a bin that stays shut, all."""
    filled = np.flatnonzero(np.isfinite(cube["grain_z"].values).any(axis=1))
    shown = filled[filled >= first] if np.isfinite(opened_at(cube)) else filled
    return shown[np.unique(np.linspace(0, len(shown) - 1, min(MOST, len(shown))).round().astype(int))]


def leaving(cube: xr.Dataset, first: int) -> tuple[float, int]:
    """Share of the solid that is out in the first snapshot with HALF out (or in the last), and layers that run out then."""
    z, mass = cube["grain_z"].values[first:], cube["grain_mass"].values
    layer = layers.numbers(z[0])
    there = layer >= 0
    out = there & ~(z > 0.0)
    shares = (out * mass).sum(axis=1) / mass[there].sum()
    shot = next(iter(np.flatnonzero(shares >= HALF)), len(z) - 1)
    whole, gone = (np.bincount(layer[which], mass[which], layers.COUNT) for which in (there, out[shot]))
    part = gone[whole > 0.0] / whole[whole > 0.0]
    return float(shares[shot]), int(((part > PARTLY[0]) & (part < PARTLY[1])).sum())


def _message(cube: xr.Dataset, first: int) -> str:
    """Message: how many layers run out at once, one or two in mass flow, many in funnel flow."""
    share, count = leaving(cube, first)
    if not share > 0.0:
        return "No sphere leaves the silo"
    return f"Layers running out at once: {count} of {layers.COUNT}, when {share:.0%} of the solid is out"


def _slice(cube: xr.Dataset, shot: int, first: int, panel: Axes) -> EllipseCollection:
    """The spheres that the plane through the axis cuts, as the circles that it cuts them in, those behind first."""
    x, y, z = (cube[f"grain_{name}"].values[shot] for name in "xyz")
    radius, height = cube["grain_radius"].values, cube["grain_z"].values[first] * CM
    cut = np.flatnonzero(np.abs(y) < radius)
    size = 2.0 * np.sqrt(radius[cut] ** 2 - y[cut] ** 2) * CM
    circles = EllipseCollection(
        size, size, np.zeros(len(cut)), units="xy", offsets=np.column_stack([x[cut], z[cut]]) * CM,
        offset_transform=panel.transData, edgecolors="#888888", linewidths=0.3,
    )  # fmt: skip
    layers.colour(circles, height[cut], layers.bounds(height))
    return circles
