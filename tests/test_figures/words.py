"""The words of a figure: what they say, and whether they are cut or lie over one another."""

from collections.abc import Iterator
from itertools import combinations

import numpy as np
from matplotlib.figure import Figure
from matplotlib.text import Text
from matplotlib.transforms import Bbox


def told(figure: Figure) -> str:
    """All words of a figure's headline, of its legends and of what stands over them, in a row."""
    texts = [figure.get_suptitle()]
    for legend in figure.legends:
        texts += [legend.get_title().get_text(), *(text.get_text() for text in legend.get_texts())]
    return " ".join(" ".join(texts).split())


def outside(words: list[tuple[str, Bbox]], figure: Figure) -> Iterator[str]:
    """Words that the canvas cuts."""
    canvas = figure.bbox.padded(1.0)
    for text, box in words:
        if not (canvas.contains(box.x0, box.y0) and canvas.contains(box.x1, box.y1)):
            yield f"{text!r} leaves the canvas"


def overlapping(texts: list[tuple[Text, Bbox]]) -> Iterator[str]:
    """Words that lie over one another."""
    shapes = [(text.get_text(), box, _corners(text, box)) for text, box in texts]
    for (one, box, shape), (other, its, its_shape) in combinations(shapes, 2):
        if box.overlaps(its) and _overlap(shape, its_shape):
            yield f"{one!r} lies over {other!r}"


def _corners(text: Text, box: Bbox) -> np.ndarray:
    """Corners of a word as it is turned, a little inside its ink's box: letters that just touch are read."""
    turn = np.radians(text.get_rotation())
    middle = np.array([box.x0 + box.x1, box.y0 + box.y1]) / 2
    if abs(np.sin(2 * turn)) < 1e-6:
        width, height, turn = box.width, box.height, 0.0
    else:  # the upright box of a turned one: its height is known from the size of the letters
        height = text.get_fontsize() * text.get_figure(root=True).dpi / 72 * (1 + text.get_text().count("\n"))
        width = (box.width - height * abs(np.sin(turn))) / abs(np.cos(turn))
    inner = np.array([width - 2.0, 0.7 * height]) / 2
    along, up = np.array([np.cos(turn), np.sin(turn)]), np.array([-np.sin(turn), np.cos(turn)])
    return np.array([middle + i * inner[0] * along + j * inner[1] * up for i, j in ((-1, -1), (1, -1), (1, 1), (-1, 1))])


def _overlap(one: np.ndarray, other: np.ndarray) -> bool:
    """Whether two rectangles overlap: no side of either parts them."""
    for side in (one[1] - one[0], one[3] - one[0], other[1] - other[0], other[3] - other[0]):
        mine, its = one @ side, other @ side
        if mine.max() <= its.min() or its.max() <= mine.min():
            return False
    return True
