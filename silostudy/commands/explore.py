"""Command `silostudy explore CUBE`: shows a cube in the browser, served on this machine alone."""

from importlib.util import find_spec
from pathlib import Path

from silostudy.errors import BadInput

GROUP = "show"


def add(sub) -> None:
    command = sub.add_parser("explore", help="open a cube in the browser: choose, slice, overlay, see sources, export")
    command.add_argument("cube", type=Path)
    command.add_argument("--port", type=int, default=0, help="of this machine; left out: any that is free")
    command.add_argument("--no-browser", action="store_true", help="print the address alone")
    command.set_defaults(run=run)


def run(chosen) -> None:
    if find_spec("panel") is None:
        raise BadInput("explore", "panel", f"is not installed: uv sync --group {GROUP}, or pip install panel")
    from silostudy.cube.io import read
    from silostudy.explore.page import serve
    from silostudy.explore.shown import quantities

    cube = read(chosen.cube)
    if not quantities(cube):
        raise BadInput("cube", str(chosen.cube), "holds no quantity with an axis and a value")
    serve(cube, chosen.cube, chosen.port, not chosen.no_browser)
