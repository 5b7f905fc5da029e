"""Every output, drawn from a real cube: its axes name units, depth runs down, the CSV holds what it shows, every word fits."""

from importlib import import_module
from pathlib import Path

import matplotlib.pyplot as plt
import pandas as pd
import pytest
from matplotlib.animation import Animation
from matplotlib.figure import Figure
from matplotlib.text import Text

from silostudy.tables.outputs import ENDINGS, OUTPUTS
from tests.test_figures import content
from tests.test_figures.small_cubes import cubes_of

LEAST_TEXT = 6.0  # points


class Drawn:
    """A figure as it was saved, the words on it with their places, and the table beside it."""

    def __init__(self, figure: Figure | None, table: pd.DataFrame | None, monkeypatch: pytest.MonkeyPatch):
        self.figure, self.table, self.texts = figure, table, []
        if figure is not None:
            draw = Text.draw
            with monkeypatch.context() as patch:
                patch.setattr(Text, "draw", lambda text, renderer: (self._see(text, renderer), draw(text, renderer)))
                figure.draw_without_rendering()

    def _see(self, text: Text, renderer) -> None:
        if text.get_visible() and text.get_text().strip():
            self.texts.append((text, Text.get_window_extent(text, renderer)))

    @property
    def words(self) -> list:
        return [(text.get_text(), box) for text, box in self.texts]

    def faults(self) -> list[str]:
        """Everything that is wrong with it, in words."""
        if self.figure is None:
            return [] if len(self.table) else ["the table is empty"]
        found = [*content.unlabelled(self.figure, {id(text) for text, _ in self.texts}), *content.rising_depths(self.figure)]
        found += [*content.bare(self.figure), *content.outside(self.words, self.figure), *content.overlapping(self.texts)]
        small = {text.get_text() for text, _ in self.texts if text.get_fontsize() < LEAST_TEXT}
        found += [f"{text!r} is small" for text in small]
        if self.table is not None:
            found += [*content.lost(self.figure, self.table)] if len(self.table) else ["the CSV is empty"]
        return found


def drawn(key: str, folder: Path, monkeypatch: pytest.MonkeyPatch) -> Drawn:
    """An output as its module draws it, without the pixels."""
    kept: list = []
    monkeypatch.setattr(plt, "close", kept.append)
    monkeypatch.setattr(Figure, "savefig", lambda figure, path, **options: Path(path).touch())
    monkeypatch.setattr(Animation, "save", lambda film, path, **options: (film._func(0), Path(path).touch()))
    import_module(f"silostudy.figures.{key}").draw(*_arguments(key, folder))
    monkeypatch.undo()
    has_table = "csv" in ENDINGS[OUTPUTS[key].kind]
    table = pd.read_csv(folder / f"{key}.csv") if has_table else None
    return Drawn(kept[0] if kept else None, table, monkeypatch)


def _arguments(key: str, folder: Path) -> tuple:
    first, *also = cubes_of(key)
    return first, folder / key, *also


@pytest.mark.parametrize("key", OUTPUTS)
def test_output_shows_what_its_table_holds(key, tmp_path, monkeypatch):
    output = drawn(key, tmp_path, monkeypatch)
    assert output.faults() == []
    plt.close("all")
