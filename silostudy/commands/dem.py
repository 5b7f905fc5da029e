"""`silostudy dem SCENE.yaml`: runs a discrete-element scene, with its progress, into a netCDF file."""

import sys
from pathlib import Path


def add(sub) -> None:
    command = sub.add_parser("dem", help="run a discrete-element scene into a netCDF file")
    command.add_argument("scene", type=Path, help="a scene file")
    command.add_argument("output", type=Path, nargs="?", help="netCDF file to write; default results/dem/SCENE.nc")
    command.add_argument("--threads", type=int, default=1, help="threads that step the scene together (the bits stay the same)")
    command.add_argument("--seeds", type=int, help="run this many scenes that differ in their seed, at once on all cores")
    command.set_defaults(run=run)


def run(chosen) -> None:
    run_ensemble(chosen) if chosen.seeds else run_one(chosen)


def run_ensemble(chosen) -> None:
    """Runs scenes with the seeds 0, 1, ... at once, a thread a core, each into a file of its own."""
    import os
    from concurrent.futures import ThreadPoolExecutor

    from tqdm import tqdm

    from silostudy.choice.dem import load
    from silostudy.compute.dem import carry_through, run_of, scene_model
    from silostudy.compute.dem_cube import cube_of
    from silostudy.cube.io import write

    scene, choice = load(chosen.scene)
    output = chosen.output or Path("results/dem") / f"{chosen.scene.stem}.nc"

    def one(seed: int):
        member = scene.model_copy(update={"seed": seed})
        task = run_of(member, scene_model(member, chosen.scene.parent, str(chosen.scene)))
        carry_through(task, member, None, lambda step: None)
        return member, task

    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for member, task in tqdm(pool.map(one, range(chosen.seeds)), total=chosen.seeds, unit=" scenes", file=sys.stderr):
            write(cube_of(task, member, choice), output.with_name(f"{output.stem}-{member.seed}.nc"))
    print(f"{scene.title}: {chosen.seeds} scenes -> {output.with_name(output.stem)}-*.nc")


def run_one(chosen) -> None:
    from silostudy.choice.dem import load
    from silostudy.compute.dem import carry_through, run_of, scene_model
    from silostudy.compute.dem_cube import cube_of
    from silostudy.cube.io import write
    from silostudy.errors import BadInput

    scene, choice = load(chosen.scene)
    output = chosen.output or Path("results/dem") / f"{chosen.scene.stem}.nc"
    model = scene_model(scene, chosen.scene.parent, str(chosen.scene))
    task = run_of(scene, model, threads=chosen.threads)
    checkpoint = output.with_suffix(".checkpoint") if scene.record.checkpoint_every_s else None
    with progress(task) as tell:
        carry_through(task, scene, checkpoint, tell)
    write(cube_of(task, scene, choice), output)
    if scene.record.paraview:
        from silostudy.compute.paraview import export

        export(task, output.with_suffix(""))
    print(
        f"{scene.title}: {task.engine.step} steps of {model.dt:.3g} s, {task.engine.n} of {len(model.x)} discs left -> {output}"
    )
    if task.recording.explosion is not None:
        raise BadInput("march.step_s", model.dt, f"{task.recording.explosion}; what was recorded is in {output}")


class progress:
    """A bar of model time with the rate in particle-steps a second and the time that remains."""

    def __init__(self, task):
        from tqdm import tqdm

        self.task, self.done = task, 0
        self.bar = tqdm(
            total=task.last * len(task.engine.model.x),
            unit=" particle-steps",
            unit_scale=True,
            file=sys.stderr,
            mininterval=0.5,
        )

    def __enter__(self):
        return self.tell

    def tell(self, step: int) -> None:
        self.bar.set_postfix_str(f"t = {self.task.engine.time:.3f} s, {self.task.engine.n} discs", refresh=False)
        self.bar.update((step - self.done) * len(self.task.engine.model.x))
        self.done = step

    def __exit__(self, kind, error, trace) -> None:
        self.bar.close()
