"""`silostudy seismic`: the cube of such a study; and what `silostudy check` says of one."""

from pathlib import Path


def add(sub) -> None:
    seismic = sub.add_parser("seismic", help="compute the seismic cube of a study")
    seismic.add_argument("study", type=Path)
    seismic.add_argument("output", type=Path, help="netCDF file to write")
    seismic.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.compute.seismic import seismic_cube
    from silostudy.cube.io import write
    from silostudy.scene.expand import expand_file

    expansion = expand_file(chosen.study)
    write(seismic_cube(expansion, print), chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} case(s) -> {chosen.output}")


def told(expansion) -> list[str]:
    """What a seismic study shakes with, judges by, and assumes."""
    study, lines = expansion.study, []
    if asked := study.identification:
        count, trials = len(asked.fine_coefficients), asked.recovery_trials
        lines.append(f"{count} coefficients x 3 damping ratios and 2 stiffnesses, and {trials} recovery trials a case")
    lines += dict.fromkeys(f"base motion: {case.scene.base.origin}" for case in expansion.cases)
    if any(case.scene.imitation for case in expansion.cases):
        lines.append("note: the measured response is synthetic")
    return [*lines, f"note: assumed are {', '.join(study.assumed)}"] if study.assumed else lines
