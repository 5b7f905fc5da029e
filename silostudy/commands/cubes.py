"""The stages whose cube is computed from a study alone and takes its time: `silostudy STAGE STUDY OUTPUT`."""

from importlib import import_module
from pathlib import Path

# stage -> what its cube holds; computed by compute/STAGE.py's STAGE_cube
HOLDS = {
    "seismic": "earthquakes: demand on the wall, effective mass of the contents",
    "grains": "contents of a shaken box of discs",
    "packing": "ensembles of discs at rest and in discharge",
    "motion": "single runs of a packing study in detail",
    "stability": "largest stable steps of resting discs",
    "profile": "wall profiles of a stability study's silo over the time step",
}


def add(sub) -> None:
    for stage, what in HOLDS.items():
        command = sub.add_parser(stage, help=f"compute the {stage} cube of a study: {what}")
        command.add_argument("study", type=Path)
        command.add_argument("output", type=Path, help="netCDF file to write")
        command.set_defaults(run=run, stage=stage)


def run(chosen) -> None:
    from silostudy.cube.io import write
    from silostudy.errors import BadInput
    from silostudy.scene.expand import expand_file

    expansion, stage = expand_file(chosen.study), chosen.stage
    if stage not in expansion.study.stages:
        known = f"has no stage {stage}; its stages: {', '.join(expansion.study.stages)}"
        raise BadInput("kind", expansion.study.kind, known, str(chosen.study))
    cube_of = getattr(import_module(f"silostudy.compute.{stage}"), f"{stage}_cube")
    write(cube_of(expansion, lambda text: print(text, flush=True)), chosen.output)
    print(f"{expansion.name}: {len(expansion.cases)} case(s) -> {chosen.output}")
