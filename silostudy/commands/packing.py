"""`silostudy packing` and `silostudy motion`: the cubes of a packing study."""

from pathlib import Path


def add(sub) -> None:
    stages = (("packing", run_packing, "ensembles at rest and in discharge"), ("motion", run_motion, "single runs in detail"))
    for name, run, what in stages:
        command = sub.add_parser(name, help=f"compute the {name} cube of a packing study: {what}")
        command.add_argument("study", type=Path)
        command.add_argument("output", type=Path, help="netCDF file to write")
        command.set_defaults(run=run)


def run_packing(chosen) -> None:
    from silostudy.compute.packing import packing_cube

    _write(packing_cube, chosen)


def run_motion(chosen) -> None:
    from silostudy.compute.motion import motion_cube

    _write(motion_cube, chosen)


def _write(cube_of, chosen) -> None:
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    write(cube_of(expansion, lambda text: print(text, flush=True)), chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} case(s) -> {chosen.output}")
