"""Layers of grains by their height where flow begins: colours of moving pictures, as in tests with coloured layers."""

from pathlib import Path

import matplotlib as mpl
import numpy as np
from matplotlib.animation import FuncAnimation, PillowWriter
from matplotlib.collections import Collection, EllipseCollection
from matplotlib.colors import BoundaryNorm, ListedColormap
from matplotlib.figure import Figure

from silostudy.figures.style import plt
from silostudy.files import replacing

COUNT = 8
COLOURS = mpl.colormaps["viridis"](np.linspace(0.2, 1.0, COUNT))
COLOURS[1::2] = 0.45 * COLOURS[1::2] + 0.55  # every other layer is pale: neighbours differ, and lines of force stay visible
FRAMES_A_SECOND = 8
DPI = 100  # at which small words have 12 px


def bounds(height: np.ndarray) -> np.ndarray:
    """Bounds (COUNT + 1, of the unit of the heights) of layers of equal depth over all grains that are there."""
    return np.linspace(np.nanmin(height), np.nanmax(height), COUNT + 1)


def numbers(height: np.ndarray) -> np.ndarray:
    """Number of the layer of each grain, from 0 at the bottom; -1 where it is not there (height is missing)."""
    layer = np.digitize(height, bounds(height)[1:-1])
    return np.where(np.isfinite(height), layer, -1)


def colour(circles: EllipseCollection, height: np.ndarray, edges: np.ndarray) -> None:
    """Colours circles by the height that each had when flow began; edges: bounds of the layers, same unit."""
    circles.set_array(np.ma.masked_invalid(height))
    circles.set_cmap(ListedColormap(COLOURS).with_extremes(bad="white"))
    circles.set_norm(BoundaryNorm(edges, COUNT))


def legend(figure: Figure, circles: Collection, panels, moment: str, **looks) -> None:
    """Draws the bar of the layers; moment: at which the heights are."""
    bar = figure.colorbar(circles, ax=panels, label=f"height {moment} (cm)", shrink=0.6, **looks)
    bar.ax.yaxis.set_major_formatter("{x:.1f}")


def save(figure: Figure, show, frames: int, stem: Path) -> None:
    """Writes an animated WebP, which browsers play; show: draws the frame of a number."""
    animation = FuncAnimation(figure, show, frames=frames, init_func=lambda: None)
    with replacing(stem.with_suffix(".webp")) as temporary:
        animation.save(temporary, writer=PillowWriter(fps=FRAMES_A_SECOND), dpi=DPI)
    plt.close(figure)
