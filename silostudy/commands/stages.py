"""Commands `silostudy STAGE STUDY ... OUTPUT`, one for every stage that computes a cube, as the pipeline's rules call them."""

from pathlib import Path

from silostudy.stages import STAGES


def add(sub) -> None:
    for stage in STAGES.values():
        if stage.compute:
            command = sub.add_parser(stage.key, help=f"compute the {stage.key} cube of a study: {stage.title}")
            command.add_argument("study", type=Path)
            for other in stage.reads:
                command.add_argument(other, type=Path, help=f"{other} cube of the same study")
            command.add_argument("output", type=Path, help="netCDF file to write")
            for section, other in stage.borrows.items():
                command.add_argument(section, type=Path, nargs="?", help=f"{other} cube of the study that `{section}` names")
            command.set_defaults(run=run, stage=stage)


def run(chosen) -> None:
    import time

    from silostudy.choice.expand import expand_file
    from silostudy.commands.about import gathered, unusual_inputs
    from silostudy.cube.io import read, write
    from silostudy.errors import BadInput

    stage, expansion = chosen.stage, expand_file(chosen.study)
    if stage.key not in expansion.study.stages:
        known = f"has no stage {stage.key}; its stages: {', '.join(expansion.study.stages)}"
        raise BadInput("kind", expansion.study.kind, known, str(chosen.study))
    files = [getattr(chosen, name) for name in (*stage.reads, *stage.borrows)]
    for text in gathered([f"note: {text}" for text in unusual_inputs(expansion)]):
        print(text, flush=True)
    start = time.perf_counter()
    cube = stage.cube(expansion, lambda text: print(text, flush=True), tuple(file and read(file) for file in files))
    seconds = time.perf_counter() - start
    write(cube, chosen.output)
    extent = ", ".join(f"{name} {size}" for name, size in cube.sizes.items())
    print(f"{expansion.name}: {len(expansion.cases)} case(s) ({extent}) in {seconds:.2f} s -> {chosen.output}")
