"""`silostudy buckling`, `shell`: the stages that compute shells; what the pipeline's rules call, and can be called by hand."""

from pathlib import Path


def add(sub) -> None:
    buckling = sub.add_parser("buckling", help="compute the buckling cube of a study")
    shell = sub.add_parser("shell", help="compute the shell cube of a study from its pressure cube")
    for command, run in ((buckling, run_buckling), (shell, run_shell)):
        command.add_argument("study", type=Path)
        if command is shell:
            command.add_argument("pressure", type=Path, help="pressure cube of the same study")
        command.add_argument("output", type=Path, help="netCDF file to write")
        if command is shell:
            command.add_argument("earthquake", type=Path, nargs="?", help="seismic cube of the study that `earthquake` names")
        command.set_defaults(run=run)


def run_buckling(chosen) -> None:
    from silostudy.compute.buckling import buckling_cube
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    cube = buckling_cube(_of_kind(expansion, "buckling", chosen.study))
    write(cube, chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} shell(s) by {cube.sizes['rule']} rule(s) -> {chosen.output}")


def run_shell(chosen) -> None:
    from silostudy.compute.shell import shell_cube
    from silostudy.cube.io import read, write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    seismic = read(chosen.earthquake) if chosen.earthquake else None
    cube = shell_cube(_of_kind(expansion, "shell", chosen.study), read(chosen.pressure), seismic)
    write(cube, chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} wall(s) by {cube.sizes['rule']} rule(s) -> {chosen.output}")


def _of_kind(expansion, kind: str, path: Path):
    """The expansion itself; BadInput for a study of another kind."""
    from silostudy.errors import BadInput

    if expansion.study.kind != kind:
        raise BadInput("kind", expansion.study.kind, f"must be {kind}", str(path))
    return expansion


def told(expansion) -> list[str]:
    """Which earthquake a shell study lays on its wall, and what is not checked with it."""
    from silostudy.compute.shell_earthquake import UNCHECKED

    asked = expansion.study.earthquake
    return [f"earthquake: {asked.study}, {asked.mass_choice}", f"note: {UNCHECKED}"] if asked else []
