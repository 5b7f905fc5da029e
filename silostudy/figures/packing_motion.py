"""The detailed discharges in motion: discs coloured in layers by their first height, force chains, wall forces beside them."""

from pathlib import Path
from textwrap import fill

import numpy as np
import xarray as xr
from matplotlib.axes import Axes
from matplotlib.collections import LineCollection

from silostudy.figures import discs, layers
from silostudy.figures.style import BLUE, WIDTH, foot, headline, plt

EVERY = 2  # snapshots a frame
SCALE = 4 * discs.DIAMETER_IS
ABOUT = "Blue bars: normal force on 1 cm of wall (mean of 10 ms). Black lines: forces of contacts,"
LENGTH = 10.0  # cm: length of the bar of the largest wall force of a film


def draw(cube: xr.Dataset, stem: Path) -> None:
    """Writes the films side by side; one that ends before the others keeps its last frame."""
    films = [Film(cube, film) for film in discs.films(cube, moving=True)]
    columns = min(2, len(films))
    rows = -(-len(films) // columns)
    figure, panels = plt.subplots(rows, columns, figsize=(WIDTH, 6.2 * rows / columns + 1.8), squeeze=False)
    for panel in panels.flat[len(films) :]:
        panel.axis("off")
    edges = layers.bounds(np.concatenate([film.height(0) for film in films]))
    for film, panel in zip(films, panels.flat, strict=False):
        film.prepare(panel, edges)
    layers.legend(figure, films[0].circles, panels, "when the slit opened", pad=0.01, fraction=0.04)
    headline(figure, f"Force on 1 cm of wall: {'; '.join(film.told() for film in films)}")
    foot(figure, f"{cube.attrs['title']}.", f"{ABOUT} {SCALE:.0f} disc weights a diameter.")
    last = max(len(film.shots) for film in films)

    def show(number: int) -> None:
        for film in films:
            film.show(min(EVERY * number, len(film.shots) - 1))

    layers.save(figure, show, -(-last // EVERY), stem)


class Film:
    """One film on its panel: what is drawn once, and what every frame changes."""

    def __init__(self, cube: xr.Dataset, film: int):
        self.cube, self.shots, self.name = cube, discs.frames(cube, film), discs.name(cube, film)
        self.force = cube["frame_normal_force"].values[self.shots]
        self.width, self.heights = float(cube.attrs["width_m"]) * discs.CM, cube["side_cell"].values * discs.CM

    def height(self, number: int) -> np.ndarray:
        """Height (cm) in the first frame of the discs that are left in another one."""
        return discs.first_height(self.cube, self.shots[number], self.shots[0])

    def prepare(self, panel: Axes, edges: np.ndarray) -> None:
        """Draw the box and empty collections; edges: bounds (cm) of the layers."""
        self.panel, self.edges = panel, edges
        discs.draw_box(panel, self.cube, opened=True)
        panel.set(
            xlim=(-LENGTH - 1, self.width + LENGTH + 1),
            xlabel="across (cm)",
            ylabel="height (cm)",
            xticks=np.linspace(0, self.width, 5),
        )
        self.circles = panel.add_collection(self._circles(0))
        self.chains = panel.add_collection(self._chains(0))
        self.bars = LineCollection([], colors=BLUE, linewidths=1.6)
        panel.add_collection(self.bars)
        panel.plot([self.width, self.width + LENGTH], [38.5, 38.5], color=BLUE, linewidth=1.6)
        panel.text(self.width, 36.0, f"{self.force.max():.0f} N/m", fontsize="small", color=BLUE)

    def told(self) -> str:
        """Message on the film: its largest force over that of the first frame, and when."""
        most = self.force.max(axis=(1, 2))
        time = float(self.cube["snapshot_time"][self.shots[most.argmax()]])
        return f"{self.name.split(',')[0]} comes to {most.max() / most[0]:.1f} times rest at {time:.2g} s"

    def show(self, number: int) -> None:
        """Show a frame."""
        self.circles.remove()
        self.chains.remove()
        self.circles = self.panel.add_collection(self._circles(number))
        self.chains = self.panel.add_collection(self._chains(number))
        self.bars.set_segments(self._bars(number))
        time = float(self.cube["snapshot_time"][self.shots[number]])
        self.panel.set_title(f"{fill(self.name, 45)}\nt = {time:.2f} s")

    def _circles(self, number: int):
        circles = discs.circles(self.cube, self.shots[number], self.panel, edgecolors="#888888", linewidths=0.3)
        layers.colour(circles, self.height(number), self.edges)
        return circles

    def _chains(self, number: int) -> LineCollection:
        return discs.chains(discs.contacts(self.cube, self.shots[number], scale=SCALE), scale=SCALE)

    def _bars(self, number: int) -> list[np.ndarray]:
        """Bars outward from both walls, as long as the force of each cell."""
        long = self.force[number] / self.force.max() * LENGTH
        bars = []
        for wall, way, side in ((0.0, -1.0, 0), (self.width, 1.0, 1)):
            tips = np.stack([wall + way * long[side], self.heights], axis=1)
            feet = np.stack([np.full_like(self.heights, wall), self.heights], axis=1)
            bars += list(np.stack([feet, tips], axis=1)[long[side] > 0])
        return bars
