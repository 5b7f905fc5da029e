"""The page of the explorer: choices at the left; the curves, their numbers and where they come from at the right."""

import html
import io
from pathlib import Path

import pandas as pd
import panel as pn
import xarray as xr
from bokeh.models import ColumnDataSource, HoverTool
from bokeh.plotting import figure

from silostudy.explore.picture import png
from silostudy.explore.shown import Selection, downward, labels, numbers, overlays, quantities, said, usual_axis, usual_place

MARKERS = ("circle", "square", "triangle", "diamond", "inverted_triangle", "star")
DASHES = ("solid", "dashed", "dotdash", "dotted")
COLOURS = ("#0072B2", "#D55E00", "#009E73", "#CC79A7", "#56B4E9", "#E69F00", "#000000")  # told apart by the colour-blind
MARKS = 14  # on a curve
FIRST_CURVES = 6  # shown before the user chooses
FILES = "files"  # address under which the folder of the cube's study is served
KINDS = {
    "figures/*.png": "picture",
    "notes/*.html": "calculation note",
    "tables/*.csv": "table",
    "animations/*.webp": "animation",
}


class Explorer:
    """One visitor's choices and what they show."""

    def __init__(self, cube: xr.Dataset, path: Path):
        self.cube, self.path = cube, path
        known = quantities(cube)
        self.quantity = pn.widgets.Select(name="quantity", options=known, width=330)
        self.along = pn.widgets.Select(name="along", width=330)
        self.overlay = pn.widgets.Select(name="a curve for each", width=330)
        self.curves = pn.widgets.MultiChoice(name="curves", width=330)
        self.places: dict[str, pn.widgets.Select] = {}
        self.slices, self.shown = pn.Column(), pn.Column(sizing_mode="stretch_width")
        self.quantity.param.watch(lambda event: self.take_quantity(), "value")
        self.along.param.watch(lambda event: self.take_axis(), "value")
        self.overlay.param.watch(lambda event: self.take_overlay(), "value")
        self.curves.param.watch(lambda event: self.show(), "value")
        self.take_quantity()

    def take_quantity(self) -> None:
        """Offers the axes of the quantity."""
        axes = [str(dim) for dim in self.cube[self.quantity.value].dims if self.cube.sizes[dim] > 1]
        self.along.param.update(options=axes, value=usual_axis(self.cube, self.quantity.value))
        self.take_axis()

    def take_axis(self) -> None:
        """Offers what curves may stand for beside the axis."""
        offered = overlays(self.cube, self.quantity.value, self.along.value)
        self.overlay.param.update(options=[*offered, ""], value=offered[0] if offered else "")
        self.take_overlay()

    def take_overlay(self) -> None:
        """Offers the curves, and the places on all other axes."""
        name, axis = self.quantity.value, self.overlay.value
        self.places = {str(dim): self._place(str(dim)) for dim in self.cube[name].dims if dim not in (self.along.value, axis)}
        self.slices.objects = [widget for dim, widget in self.places.items() if self.cube.sizes[dim] > 1]
        known = labels(self.cube, axis) if axis else []
        here = self.cube[name].isel({dim: widget.value for dim, widget in self.places.items()})
        held = [label for k, label in enumerate(known) if here.isel({axis: k}).notnull().any()]
        self.curves.param.update(options=known, value=held[:FIRST_CURVES], visible=bool(axis))
        self.show()

    def _place(self, dim: str):
        options = {label: k for k, label in enumerate(labels(self.cube, dim))}
        place = usual_place(self.cube, self.quantity.value, dim)
        widget = pn.widgets.Select(name=dim, options=options, value=place, width=330)
        widget.param.watch(lambda event: self.show(), "value")
        return widget

    @property
    def choice(self) -> Selection:
        """The current selection."""
        places = {dim: widget.value for dim, widget in self.places.items()}
        return Selection(self.quantity.value, self.along.value, self.overlay.value, tuple(self.curves.value), places)

    def show(self) -> None:
        """Draws the choice anew."""
        choice = self.choice
        table = numbers(self.cube, choice)
        stem = f"{self.path.stem}-{choice.quantity}"
        save = pn.Row(
            pn.widgets.FileDownload(callback=lambda: _csv(table), filename=f"{stem}.csv", label="numbers (CSV)"),
            pn.widgets.FileDownload(
                callback=lambda: png(self.cube, choice, table, self.title(choice)),
                filename=f"{stem}.png",
                label="picture (PNG)",
            ),
        )
        drawn = pn.pane.Bokeh(drawing(self.cube, choice, table, self.title(choice)), sizing_mode="stretch_width")
        self.shown.objects = [drawn, save, pn.pane.HTML(scopes(table, choice), sizing_mode="stretch_width")]

    def title(self, choice: Selection) -> str:
        """Title of what is shown: the study's, and the places on the axes that are cut."""
        cut = [f"{dim} {labels(self.cube, dim)[place]}" for dim, place in choice.places.items() if self.cube.sizes[dim] > 1]
        return ", ".join([self.cube.attrs["title"], *cut])

    def page(self) -> pn.viewable.Viewable:
        """Everything side by side."""
        heading = pn.pane.HTML(f"<h2>{html.escape(self.cube.attrs['title'])}</h2>")
        chosen = pn.Column(self.quantity, self.along, self.overlay, self.slices, self.curves, width=350)
        return pn.Column(heading, pn.Row(chosen, self.shown, sizing_mode="stretch_width"), links(self.path), about(self.cube))


def _csv(table: pd.DataFrame) -> io.StringIO:
    return io.StringIO(table.to_csv(index=False, float_format="%.7g"))


def drawing(cube: xr.Dataset, choice: Selection, table: pd.DataFrame, title: str):
    """The curves; whoever points at one reads its value, scope and source.  Depth runs downward."""
    deep = downward(cube, choice.along)
    across, up = (choice.quantity, choice.along) if deep else (choice.along, choice.quantity)
    names = {choice.quantity: said(cube[choice.quantity]), choice.along: said(cube[choice.along])}
    words = cube[choice.along].dtype.kind not in "iuf"
    options = {"x_range": list(dict.fromkeys(map(str, table[across])))} if words else {}
    axes = figure(title=title, height=520, x_axis_label=names[across], y_axis_label=names[up], **options)
    axes.sizing_mode = "stretch_width"
    axes.y_range.flipped = deep
    for k, (curve, rows) in enumerate(table.groupby("curve", sort=False)):
        look = {"color": COLOURS[k % len(COLOURS)], "legend_label": str(curve)}
        if words:
            rows = rows.assign(**{choice.along: rows[choice.along].astype(str)})
        else:
            axes.line(across, up, source=ColumnDataSource(rows), line_width=2, line_dash=DASHES[k % len(DASHES)], **look)
        marked = ColumnDataSource(rows.iloc[k % 3 :: max(1, len(rows) // MARKS)] if len(rows) > MARKS else rows)
        axes.scatter(across, up, source=marked, size=7, marker=MARKERS[k % len(MARKERS)], **look)
    told = [(choice.along, f"@{{{choice.along}}}"), (choice.quantity, f"@{{{choice.quantity}}}")]
    axes.add_tools(
        HoverTool(line_policy="nearest", tooltips=[("curve", "@curve"), *told, ("scope", "@scope"), ("source", "@source")])
    )
    if len(table):
        axes.legend.click_policy = "hide"
        axes.add_layout(axes.legend[0], "right")
    return axes


def scopes(table: pd.DataFrame, choice: Selection) -> str:
    """A table of the curves: how many points are in scope, why the others are not, and the source."""
    rows = []
    for curve, points in table.groupby("curve", sort=False):
        counts = points["scope"].value_counts()
        words = "; ".join(f"{count} {scope}" for scope, count in counts.items())
        rows.append((str(curve), words, str(points["source"].iloc[0])))
    cells = "".join(f"<tr>{''.join(f'<td>{html.escape(cell)}</td>' for cell in row)}</tr>" for row in rows)
    head = "<tr><th>curve</th><th>points by scope</th><th>source</th></tr>"
    return f"<table class='scopes' style='text-align:left;border-spacing:12px 2px'>{head}{cells}</table>"


def links(path: Path) -> pn.pane.HTML:
    """Links to the pictures, tables and calculation notes that the pipeline made of the same study."""
    inside = path.parent / path.stem if (path.parent / path.stem).is_dir() else path.parent  # a scene has a folder of its own
    made = [(kind, file) for pattern, kind in KINDS.items() for file in sorted(inside.glob(pattern))]
    shown = [
        f"<li>{kind}: <a href='{FILES}/{file.relative_to(path.parent)}' target='_blank'>{file.stem}</a></li>"
        for kind, file in made
    ]
    return pn.pane.HTML(f"<h3>Made of this study</h3><ul>{''.join(shown)}</ul>" if shown else "")


def about(cube: xr.Dataset) -> pn.pane.HTML:
    """Provenance of the cube."""
    rows = {"computed by": "source", "hash of the study": "study_hash", "references": "references"}
    said_of = "".join(f"<p>{name}: {html.escape(str(cube.attrs[key]))}</p>" for name, key in rows.items())
    return pn.pane.HTML(f"<h3>About this cube</h3>{said_of}", sizing_mode="stretch_width")


def serve(cube: xr.Dataset, path: Path, port: int, browser: bool) -> None:
    """Serves the page on this machine alone until it is stopped."""
    pn.extension()
    pn.serve(
        lambda: Explorer(cube, path).page(),
        address="127.0.0.1",
        port=port,
        show=browser,
        title=f"{path.name}: {cube.attrs['title']}",
        static_dirs={FILES: str(path.parent.absolute())},
    )
