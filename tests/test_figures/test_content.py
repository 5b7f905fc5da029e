"""Every output, drawn from a real cube: its axes name units, depth runs down, the CSV holds what it shows, every word fits.

A new output is drawn too, from the first shipped study that asks for it (small_cubes.SMALLER says what of it is left out).
"""

from importlib import import_module
from pathlib import Path

import matplotlib.pyplot as plt
import numpy as np
import pandas as pd
import pytest
import xarray as xr
from matplotlib.animation import Animation
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox

from silostudy.cube.silence import silences
from silostudy.figures.style import DPI
from silostudy.tables.outputs import ENDINGS, OUTPUTS
from tests.test_figures import content, labels, looks, words
from tests.test_figures.small_cubes import cubes_of

LEAST_TEXT = 12.0  # px, where
PAGE = 1000.0  # px: as wide as the report shows a picture in a window of 1400 px; a narrower one at its own size
WINDOW = 1056.0  # px: a picture that is higher loses its head in a window of 1080 px


class Drawn:
    """A figure as it was saved, the words on it with their places, the table beside it, and the cubes behind it."""

    def __init__(self, figure: Figure | None, table: pd.DataFrame | None, cubes: list[xr.Dataset]):
        self.figure, self.table, self.cubes = figure, table, cubes
        self.texts: list[tuple[Text, Bbox]] = []
        if figure is not None:
            self.look()

    @property
    def units(self) -> dict[str, str]:
        """Units of the variables of its cubes."""
        return {str(name): str(one.attrs.get("units", "1")) for cube in self.cubes for name, one in cube.variables.items()}

    def look(self) -> None:
        """Finds the words that are really drawn, each with its place."""
        draw, self.texts = Text.draw, []
        with pytest.MonkeyPatch.context() as patch:
            patch.setattr(Text, "draw", lambda text, renderer: (self._see(text, renderer), draw(text, renderer)))
            self.figure.draw_without_rendering()

    def _see(self, text: Text, renderer) -> None:
        if text.get_visible() and text.get_text().strip():
            self.texts.append((text, Text.get_window_extent(text, renderer)))

    @property
    def words(self) -> list:
        return [(text.get_text(), box) for text, box in self.texts]

    def faults(self) -> list[str]:
        """Everything that is wrong with it, in words."""
        if self.figure is None:
            return [] if self.table is None or len(self.table) else ["the table is empty"]  # a note is read in tests/test_note
        found = [*labels.unlabelled(self.figure, {id(text) for text, _ in self.texts}), *labels.rising_depths(self.figure)]
        found += [*content.bare(self.figure), *words.outside(self.words, self.figure), *words.overlapping(self.texts)]
        if self.table is not None:
            found += [*content.lost(self.figure, self.table, self.units)] if len(self.table) else ["the CSV is empty"]
        return found

    def faults_of_look(self) -> list[str]:
        """What a reader of the report, perhaps colour-blind or with a print in black and white, stumbles over."""
        if self.figure is None:
            return []
        px = min(PAGE / self.figure.get_figwidth(), DPI) / 72
        small = {text.get_text() for text, _ in self.texts if text.get_fontsize() * px < LEAST_TEXT}
        found = [f"{text!r} is small" for text in small]
        found += [] if self.figure.get_suptitle().strip() else ["no title"]
        found += ["too tall"] if self.figure.get_figheight() * DPI > WINDOW else []
        return [*found, *looks.colour_alone(self.figure)]


def drawn(key: str, cubes: list[xr.Dataset], folder: Path, monkeypatch: pytest.MonkeyPatch) -> Drawn:
    """An output as its module draws it, without the pixels; of an animation the first frame."""
    kept: list = []
    monkeypatch.setattr(plt, "close", kept.append)
    monkeypatch.setattr(Figure, "savefig", lambda figure, path, **options: Path(path).touch())
    monkeypatch.setattr(Animation, "save", lambda film, path, **options: (film._func(0), Path(path).touch()))
    import_module(f"silostudy.figures.{key}").draw(cubes[0], folder / key, *cubes[1:])
    monkeypatch.undo()
    has_table = "csv" in ENDINGS[OUTPUTS[key].kind]
    table = pd.read_csv(folder / f"{key}.csv") if has_table else None
    return Drawn(kept[0] if kept else None, table, cubes)


COSTLY = ("silo_of_discs", "accuracy_grains", "grains_effective_mass", "stability_map")  # cubes of kernels


@pytest.mark.parametrize("key", [pytest.param(key, marks=pytest.mark.long if key in COSTLY else ()) for key in OUTPUTS])
def test_output_shows_what_its_table_holds(key, tmp_path, monkeypatch):
    output = drawn(key, cubes_of(key), tmp_path, monkeypatch)
    assert output.faults() == []
    assert output.faults_of_look() == []
    plt.close("all")


@pytest.mark.parametrize("key", ["fig_4_2_11", "comparison_today", "overpressure_over_slenderness", "measured_silos"])
def test_silent_methods_are_named_with_their_reason(key, tmp_path, monkeypatch):
    first, *also = cubes_of(key)
    pressure = first["wall_normal_pressure"]
    last = {"pressure_method": first.pressure_method == first.pressure_method[-1]}
    silenced = first.assign(
        wall_normal_pressure=pressure.where(~last["pressure_method"]),
        wall_normal_pressure_scope=first.wall_normal_pressure_scope.where(~last["pressure_method"], 3).astype("int8"),
    )
    silenced.wall_normal_pressure_scope.attrs = first.wall_normal_pressure_scope.attrs
    output = drawn(key, [silenced, *also], tmp_path, monkeypatch)
    told = " ".join(" ".join(text for text, _ in output.words).split())
    lines = silences(silenced, in_every_case=True, titles=True)
    assert any(line.startswith(str(first.pressure_method_title.values[-1])) for line in lines)
    assert [line for line in lines if line not in told] == []
    plt.close("all")


def _swap(output):
    columns = {"depth_m": "wall_normal_pressure_t_m2", "wall_normal_pressure_t_m2": "depth_m"}
    output.table = output.table.rename(columns=columns)


def _shift(output):
    line = output.figure.axes[0].lines[2]
    line.set_xdata(np.asarray(line.get_xdata()) * 1.00001)


def _drop(output):
    output.table = output.table[output.table.curve != output.table.curve.iloc[-1]]


def _overflow(output):
    output.figure.axes[0].text(0.9, 0.5, "a label that is far too long " * 9, transform=output.figure.axes[0].transAxes)


def _empty(output):
    for line in list(output.figure.axes[1].lines):
        line.remove()


def _same_line(output):
    for number in (0, 2):
        line = output.figure.axes[0].lines[number]
        line.set(linestyle="-", marker="o", markerfacecolor=line.get_color())


MUTATIONS = {
    "columns swapped": (_swap, "is in the CSV"),
    "unit removed": (lambda output: output.figure.axes[0].set_xlabel("wall normal pressure"), "no unit"),
    "unit wrong": (lambda output: output.figure.axes[0].set_xlabel("wall normal pressure (kPa)"), "is in the CSV"),
    "depth up": (lambda output: output.figure.axes[0].invert_yaxis(), "runs up"),
    "data shifted": (_shift, "is in the CSV"),
    "curve dropped": (_drop, "is in the CSV"),
    "no rows": (lambda output: setattr(output, "table", output.table[:0]), "the CSV is empty"),
    "label too long": (_overflow, "leaves the canvas"),
    "too tall": (lambda output: output.figure.set_figheight(12), "too tall"),
    "no title": (lambda output: output.figure.suptitle(""), "no title"),
    "told by colour alone": (_same_line, "differ by colour alone"),
    "word over word": (lambda output: output.figure.text(0.5, 0.985, "a second title", ha="center", va="top"), "lies over"),
    "small print": (lambda output: output.figure.axes[0].xaxis.label.set_size(8), "is small"),
    "empty axes": (_empty, "nothing on"),
}


@pytest.mark.parametrize("mutation", MUTATIONS)
def test_a_wrong_figure_is_noticed(mutation, tmp_path, monkeypatch):
    output = drawn("fig_4_2_11", cubes_of("fig_4_2_11"), tmp_path, monkeypatch)
    change, told = MUTATIONS[mutation]
    change(output)
    output.look()
    assert any(told in fault for fault in (*output.faults(), *output.faults_of_look()))
    plt.close("all")
