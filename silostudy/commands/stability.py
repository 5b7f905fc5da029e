"""`silostudy stability` and `silostudy profile`: the cubes of a stability study, of resting discs and of its silo."""

from pathlib import Path


def add(sub) -> None:
    command = sub.add_parser("stability", help="compute the stability cube of a study: largest stable steps of resting discs")
    command.add_argument("study", type=Path)
    command.add_argument("output", type=Path, help="netCDF file to write")
    command.set_defaults(run=run)

    silo = sub.add_parser("profile", help="compute the wall profiles of a stability study's silo over the time step")
    silo.add_argument("study", type=Path)
    silo.add_argument("output", type=Path, help="netCDF file to write")
    silo.set_defaults(run=run_profile)


def run_profile(chosen) -> None:
    from silostudy.compute.profile import profile_cube
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    write(profile_cube(expand_file(chosen.study), lambda text: print(text, flush=True)), chosen.output)


def run(chosen) -> None:
    from silostudy.compute.stability import stability_cube
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    write(stability_cube(expansion, lambda text: print(text, flush=True)), chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} case(s) -> {chosen.output}")
