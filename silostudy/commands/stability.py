"""`silostudy stability`: the cube of a stability study, largest stable steps of resting discs."""

from pathlib import Path


def add(sub) -> None:
    command = sub.add_parser("stability", help="compute the stability cube of a study: largest stable steps of resting discs")
    command.add_argument("study", type=Path)
    command.add_argument("output", type=Path, help="netCDF file to write")
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.compute.stability import stability_cube
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    write(stability_cube(expansion, lambda text: print(text, flush=True)), chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} case(s) -> {chosen.output}")
