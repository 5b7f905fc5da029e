"""Commands `silostudy draw`, `redraw`, `captions`: figures and tables from cubes, and what the report says of them."""

from pathlib import Path


def add(sub) -> None:
    draw = sub.add_parser("draw", help="draw a figure or table from a cube")
    draw.add_argument("key", help="see `silostudy list outputs`")
    draw.add_argument("cube", type=Path, nargs="+", help="the cube, and further ones that the figure can show")
    draw.add_argument("stem", type=Path, help="file to write, without its ending")
    draw.set_defaults(run=run_draw)

    redraw = sub.add_parser("redraw", help="draw figures and tables of a study anew")
    redraw.add_argument("folder", type=Path, help="results/STUDY")
    redraw.add_argument("--cube", type=Path, help="the cube, where it does not lie in the folder: of a scene")
    redraw.add_argument("keys", nargs="+", metavar="key", help="see `silostudy list outputs`")
    redraw.set_defaults(run=run_redraw)

    captions = sub.add_parser("captions", help="write what the report says of outputs")
    captions.add_argument("files", type=Path, nargs="+", help="files to write: KEY.rst")
    captions.set_defaults(run=run_captions)


def run_draw(chosen) -> None:
    from silostudy.cube.io import read
    from silostudy.errors import BadInput

    if chosen.stem.suffix:
        raise BadInput("stem", str(chosen.stem), "must hold no dot in its name: each file gets an ending of its own")
    _check_stages(chosen.key, cubes := [read(path) for path in chosen.cube], chosen.cube)
    _draw(chosen.key, cubes, chosen.stem)


def run_redraw(chosen) -> None:
    from functools import cache

    from silostudy.cube.io import read
    from silostudy.cube.silos import silos
    from silostudy.files import seal
    from silostudy.tables.outputs import OUTPUTS, files_of

    once = cache(read)
    for key in chosen.keys:
        row = OUTPUTS[key]
        files = [chosen.cube] if chosen.cube else [chosen.folder / f"{stage}.nc" for stage in (row.stage, *row.also)]
        _draw(key, [once(file) for file in files[:1] + [file for file in files[1:] if file.exists()]],
              chosen.folder / f"{row.kind}s" / key)  # fmt: skip
        for name in files_of(key, str(chosen.folder), silos(once(files[0])) if row.per_silo else ()):
            seal(Path(name))


def run_captions(chosen) -> None:
    from silostudy.files import replacing
    from silostudy.tables.outputs import caption

    for path in chosen.files:
        with replacing(path) as temporary:
            temporary.write_text(caption(path.stem), encoding="utf-8")


def _check_stages(key: str, cubes: list, paths: list[Path]) -> None:
    """BadInput for a cube of another stage than the output is drawn from."""
    from silostudy.errors import BadInput
    from silostudy.tables.outputs import OUTPUTS

    row = OUTPUTS[key]
    for number, (cube, path) in enumerate(zip(cubes, paths, strict=True)):
        wanted, stage = (row.also if number else (row.stage,)), cube.attrs.get("stage")
        if stage not in wanted:
            allowed = f"{key} is drawn from a {row.stage} cube" + (f", and {' and '.join(row.also)}" if row.also else "")
            raise BadInput("cube", str(path), f"is of the stage {stage}; {allowed}")


def _draw(key: str, cubes: list, stem: Path) -> None:
    from importlib import import_module

    from silostudy.cube.contract import VARIABLES
    from silostudy.errors import BadInput
    from silostudy.tables.outputs import OUTPUTS

    try:
        import_module(f"silostudy.figures.{OUTPUTS[key].key}").draw(cubes[0], stem, *cubes[1:])
    except KeyError as error:
        lacking = [name for name in VARIABLES if repr(name) in str(error) and all(name not in cube.variables for cube in cubes)]
        if not lacking:
            raise
        raise BadInput("cube", cubes[0].attrs["title"], f"holds no {lacking[0]}, which {key} shows") from None
