"""`silostudy accuracy`: the stage that measures what accuracy costs."""

from pathlib import Path


def add(sub) -> None:
    command = sub.add_parser("accuracy", help="measure error against CPU time of an accuracy study's problems")
    command.add_argument("study", type=Path)
    command.add_argument("output", type=Path, help="netCDF file to write")
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.compute.accuracy import accuracy_cube
    from silostudy.cube.io import write
    from silostudy.errors import BadInput
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    if expansion.study.kind != "accuracy":
        raise BadInput("kind", expansion.study.kind, "must be accuracy", str(chosen.study))
    cube = accuracy_cube(expansion, tell=lambda text: print(text, flush=True))
    write(cube, chosen.output)
    print(f"{expansion.name}: {cube.sizes['point']} errors with their cost, on {cube.attrs['machine']} -> {chosen.output}")
