"""`silostudy draw`, `redraw`: figures and tables from cubes."""

from pathlib import Path


def add(sub) -> None:
    draw = sub.add_parser("draw", help="draw a figure or table from a cube")
    draw.add_argument("key", help="see `silostudy list outputs`")
    draw.add_argument("cube", type=Path, nargs="+", help="the cube, and further ones that the figure can show")
    draw.add_argument("stem", type=Path, help="file to write, without its ending")
    draw.set_defaults(run=run_draw)

    redraw = sub.add_parser("redraw", help="draw figures and tables of a study anew")
    redraw.add_argument("folder", type=Path, help="results/STUDY")
    redraw.add_argument("keys", nargs="+", metavar="key", help="see `silostudy list outputs`")
    redraw.set_defaults(run=run_redraw)


def run_draw(chosen) -> None:
    from silostudy.cube.io import read

    _draw(chosen.key, [read(path) for path in chosen.cube], chosen.stem)


def run_redraw(chosen) -> None:
    from functools import cache

    from silostudy.cube.io import read
    from silostudy.tables.outputs import OUTPUTS

    once = cache(read)
    for key in chosen.keys:
        row = OUTPUTS[key]
        files = [chosen.folder / f"{stage}.nc" for stage in (row.stage, *row.also)]
        _draw(key, [once(file) for file in files[:1] + [file for file in files[1:] if file.exists()]],
              chosen.folder / f"{row.kind}s" / key)  # fmt: skip


def _draw(key: str, cubes: list, stem: Path) -> None:
    from importlib import import_module

    from silostudy.tables.outputs import OUTPUTS

    import_module(f"silostudy.figures.{OUTPUTS[key].key}").draw(cubes[0], stem, *cubes[1:])
