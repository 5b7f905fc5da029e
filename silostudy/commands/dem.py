"""Command `silostudy dem SCENE.yaml`: runs a scene of grains, with its progress, into a netCDF file."""

import sys
from pathlib import Path

from silostudy.say import say


def add(sub) -> None:
    command = sub.add_parser("dem", help="run a discrete-element scene into a netCDF file")
    command.add_argument("scene", type=Path, help="a scene file")
    command.add_argument("output", type=Path, nargs="?", help="netCDF file to write; default results/dem/SCENE.nc")
    command.add_argument("--threads", type=int, default=1, help="threads that step the scene together (the bits stay the same)")
    command.add_argument("--seeds", type=int, help="run this many scenes that differ in their seed, at once on all cores")
    command.set_defaults(run=run)


def run(chosen) -> None:
    import os

    from silostudy.choice.dem import load
    from silostudy.errors import BadInput
    from silostudy.scene.scenes import files_of_scene

    cores = os.cpu_count() or 1
    if not 1 <= chosen.threads <= cores:  # more wait for each other at every step
        raise BadInput("--threads", chosen.threads, f"must be 1 to {cores}, the cores of this machine")
    scene, choice = load(chosen.scene)
    output = chosen.output or Path("results/dem") / f"{chosen.scene.stem}.nc"
    read = (chosen.scene, *files_of_scene(chosen.scene))
    if chosen.seeds is None:
        _check_places(scene, output, read)
        run_one(chosen, scene, choice, output)
        return
    if chosen.seeds < 1:
        raise BadInput("--seeds", chosen.seeds, "must be 1 or more")
    outputs = [output.with_name(f"{output.stem}-{seed}.nc") for seed in range(chosen.seeds)]
    for path in outputs:
        _check_places(scene, path, read)
    run_ensemble(chosen, scene, choice, outputs)


def _check_places(scene, output: Path, read) -> None:
    """BadInput unless the output and what is written beside it can be, each in a place of its own."""
    from silostudy.errors import BadInput
    from silostudy.files import check_folder, check_output

    check_output(output, read)
    for beside, what in ((checkpoint_of(scene, output), "the checkpoints go"), (end_beside(scene, output), "the end goes")):
        if output == beside:
            raise BadInput("output", str(output), f"is where {what}: name it otherwise, as SCENE.nc")
    if end := end_beside(scene, output):
        check_output(end, read)
    if scene.record.paraview:
        if output == paraview_of(output):
            raise BadInput("output", str(output), "is the folder of the files for ParaView: give it an ending, as SCENE.nc")
        check_folder(paraview_of(output))


def run_ensemble(chosen, scene, choice, outputs: list[Path]) -> None:
    """Runs scenes with the seeds 0, 1, ... at once, a thread a core, each into a file of its own."""
    import os
    from concurrent.futures import ThreadPoolExecutor

    from tqdm import tqdm

    from silostudy.compute.dem import carry_through, run_of
    from silostudy.errors import BadInput

    _check_seeds(chosen, scene)

    def carried(seed: int):
        member = scene.model_copy(update={"seed": seed})
        task = run_of(member, _model(chosen, member), str(chosen.scene))
        carry_through(task, member, checkpoint_of(member, outputs[seed]), lambda step: None)
        return member, task

    failed = []
    with ThreadPoolExecutor(os.cpu_count()) as pool:
        for member, task in tqdm(pool.map(carried, range(len(outputs))), total=len(outputs), unit=" scenes", file=sys.stderr):
            keep(task, member, choice, outputs[member.seed])
            if task.trouble:
                failed.append(f"seed {member.seed}: {task.trouble}")
    print(f"{scene.title}: {len(outputs)} scenes -> {outputs[0]} ... {outputs[-1].name}")
    if failed:
        print("\n".join(failed), file=sys.stderr)
        raise BadInput("--seeds", len(outputs), f"{len(failed)} did not come to their end; what they recorded is kept")


def run_one(chosen, scene, choice, output: Path) -> None:
    from silostudy.commands.check import told_before
    from silostudy.commands.progress import progress
    from silostudy.compute.dem import carry_through, run_of
    from silostudy.compute.expected import verdicts
    from silostudy.dem.cache import is_compiled
    from silostudy.dem.follow import mean_step, steps_made
    from silostudy.dem.kernel import kernel
    from silostudy.errors import BadInput

    model = _model(chosen, scene)
    for line in told_before(scene, model, chosen.scene.parent):
        say(line)
    task = run_of(scene, model, str(chosen.scene), threads=chosen.threads)
    if not is_compiled(kernel(model.pieces)):
        say("the kernel of these laws is compiled first, once: that takes 20 to 40 s")
    with progress(task) as tell:
        carry_through(task, scene, checkpoint_of(scene, output), tell)
    keep(task, scene, choice, output)
    print(f"{scene.title}: {steps_made(task)} steps of {mean_step(task):.3g} s, {where_discs_are(task)} -> {output}")
    for verdict in () if task.recording.explosion else verdicts(task, scene):
        print(f"  {verdict}")
    if task.trouble:
        stepped = ("march.step", model.pace.kind) if model.pace.changes else ("march.step_s", model.step)
        key, value = ("march.limit_s", scene.march.limit_s) if task.recording.waiting else stepped
        if task.recording.buried:
            key, value = "filling.count", len(model.x)
        raise BadInput(key, value, f"{task.trouble}; what was recorded is in {output}", str(chosen.scene))


def _model(chosen, scene):
    from silostudy.compute.dem import scene_model

    return scene_model(scene, chosen.scene.parent, str(chosen.scene))


def _check_seeds(chosen, scene) -> None:
    """BadInput where the seed changes nothing: the members would be one."""
    import numpy as np

    from silostudy.errors import BadInput

    first, second = (_model(chosen, scene.model_copy(update={"seed": seed})) for seed in (0, 1))
    same = np.array_equal(first.place, second.place) and np.array_equal(first.radius, second.radius)
    if same and not first.waiting:  # the seed says where those come in that wait
        raise BadInput("--seeds", chosen.seeds, "the start is the same for every seed", str(chosen.scene))


def checkpoint_of(scene, output: Path) -> Path | None:
    """File of the checkpoints of a run into this output, where the scene asks for them."""
    return output.with_suffix(".checkpoint") if scene.record.checkpoint_every_s else None


def end_beside(scene, output: Path) -> Path | None:
    """File of where a run into this output ends, where the scene asks for it."""
    return output.with_suffix(".end") if scene.record.keep_end else None


def paraview_of(output: Path) -> Path:
    """Folder of the files for ParaView beside this output."""
    return output.with_suffix("")


def keep(task, scene, choice, output: Path) -> None:
    """Write what a run recorded; only then its checkpoint goes."""
    from silostudy.compute.branches import keep_end
    from silostudy.compute.dem_cube import cube_of
    from silostudy.compute.paraview import export
    from silostudy.cube.io import write
    from silostudy.dem.feeder import shortfall
    from silostudy.dem.rain import delay

    cube = cube_of(task, scene, choice)
    write(cube, output)
    if (end := end_beside(scene, output)) and not task.recording.explosion:
        keep_end(task, scene, end)
    if deep := cube.attrs.get("deep_overlaps"):
        say(f"{output}: overlaps {deep}")
    if scene.record.paraview:
        export(task, paraview_of(output))
    if checkpoint := checkpoint_of(scene, output):
        checkpoint.unlink(missing_ok=True)
    for told in filter(None, (delay(task), shortfall(task), *_events_in_vain(task))):
        say(f"{output}: {told}")
    half, began = 0.5 * task.engine.model.step, task.began * task.engine.model.dt
    late = [time for time in scene.record.snapshots_s if time > task.engine.time + half]
    early = [time for time in scene.record.snapshots_s if time < began - half]
    for missed, why in ((late, "the run ended before"), (early, f"the run goes on from {began:g} s")):
        if missed:
            times = ", ".join(f"{time:g}" for time in missed)
            say(f"{output}: no snapshots at {times} s: {why}")


def _events_in_vain(task) -> list[str]:
    """Events of a run, in words, that found nothing to do."""
    return [f"at {time:.4g} s {action}" for time, _, action in task.recording.happened if " nothing: " in action]


def where_discs_are(task) -> str:
    """Number of discs that are left in the silo, and how the others left it."""
    counts = {**task.recording.left, "not in yet": task.engine.most - task.come}
    counts["gone before this run"] = len(task.engine.model.x) - task.engine.n - sum(counts.values())
    gone = ", ".join(f"{count} {way}" for way, count in counts.items() if count)
    return f"{task.engine.n} of {len(task.engine.model.x)} {task.engine.space.body}s still there" + (
        f" ({gone})" if gone else ""
    )
