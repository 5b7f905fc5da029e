"""Command `silostudy check FILE`: a study, a scene or a whole project is validated and counted, and nothing is computed."""

from collections.abc import Collection
from pathlib import Path
from pkgutil import resolve_name
from typing import TYPE_CHECKING

from silostudy.errors import BadInput

if TYPE_CHECKING:
    from silostudy.choice.expand import Resolved
    from silostudy.config.study import BaseStudy

LOOKED = 10_000  # cases of a study that `check` looks at


def add(sub) -> None:
    check = sub.add_parser(
        "check", help="validate a study, a scene or all of a project, and count cases, without computing them"
    )
    check.add_argument("study", type=Path, help="a study file, or its name in config/studies; a scene file; or a project file")
    check.add_argument("--price", action="store_true", help="of a grains study: settle and time one filling")
    check.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.commands.check_project import project_checked
    from silostudy.commands.studies import path_of
    from silostudy.config.load import is_project, read_yaml

    path = path_of(chosen.study)
    if is_project(read_yaml(path)):
        if chosen.price:
            raise BadInput("--price", True, "is of one study: check that alone", str(path))
        project_checked(path)
    else:
        print("\n".join(checked(path, priced=chosen.price)[0]))


def checked(path: Path, *, priced: bool = False) -> tuple[list[str], float | None]:
    """Lines on a study or a scene, and the time (s) that it computes where that is known."""
    from silostudy.config.load import read_yaml
    from silostudy.stages import FILE_KINDS, KINDS

    said = read_yaml(path).get("kind")
    if said in FILE_KINDS and said not in KINDS:
        _check_price(priced, said, ())
        return scene_checked(path)
    return study_checked(path, priced)


def _check_price(asked: bool, kind: object, timed: Collection[str]) -> None:
    """BadInput where a price is asked for that no study of the kind tells."""
    if asked and not timed:
        raise BadInput("--price", True, f"kind {kind} has none to tell")


def study_checked(path: Path, priced: bool) -> tuple[list[str], float | None]:
    """Lines on a study: its cases, and what its kind tells of them; its time (s) where that is known."""
    from silostudy.commands.about import gathered
    from silostudy.config.load import read_study
    from silostudy.stages import KINDS

    study = read_study(path)
    kind, expansion, notes = KINDS[study.kind], *looked_at(path, study)
    _check_price(priced, study.kind, kind.timed)
    axes = " x ".join(f"{axis.axis} {len(axis.settings())}" for axis in study.sweep) or "no sweep"
    told = [line for about in (*kind.about, *(kind.timed if priced else ())) for line in resolve_name(about)(expansion)]
    lines = [f"{count_of(study)} case(s): {axes}", *notes, *gathered(told), *chosen_for(expansion.promise)]
    return [f"{path}: {study.title}", *(f"  {line}" for line in lines)], resolve_name(kind.seconds)(
        expansion
    ) if kind.seconds else None


def count_of(study: "BaseStudy") -> int:
    """Cases of a study."""
    from math import prod

    return prod(len(axis.settings()) for axis in study.sweep)


def looked_at(path: Path, study: "BaseStudy") -> tuple["Resolved", list[str]]:
    """The cases of a study that `check` builds, LOOKED at most, and what to say where they are not all.

    Of a study in parts they are drawn at random, since their mean time is told; else a part of each axis, with its ends.
    """
    import random

    from silostudy.choice.expand import expand, expand_file
    from silostudy.config.load import read_yaml
    from silostudy.scene.expand import MOST
    from silostudy.scene.thinned import thinned
    from silostudy.stages import KINDS

    count = count_of(study)
    if count <= LOOKED or count > MOST:
        return expand_file(path), []
    if KINDS[study.kind].parts:
        told = f"note: {LOOKED:,} of them, drawn at random, are looked at here"
        return expand_file(path, sorted(random.Random(0).sample(range(count), LOOKED))), [told]
    expansion = expand(thinned(study, read_yaml(path), LOOKED), path.stem, str(path), path.parent)
    told = f"note: {len(expansion.cases):,} of them, evenly over the axes, are looked at here: what follows is of these"
    return expansion, [told]


def scene_checked(path: Path) -> tuple[list[str], float]:
    """Lines on a scene of grains, and its time (s); its start is built, with every file that it names, and its run is not."""
    from silostudy.choice.dem import load
    from silostudy.choice.promise import promises
    from silostudy.compute.dem import run_of, scene_model
    from silostudy.scene.costs import cost, told_time
    from silostudy.scene.scenes import SceneCase

    scene, choice = load(path)
    model = scene_model(scene, path.parent, str(path))
    task = run_of(scene, model, str(path))  # tells too what is impossible by the step alone
    seconds = cost(SceneCase(scene, path.parent), model.step)
    about = "at most about" if model.pace.lively else "about"
    run = f"{len(model.x)} {model.space.body}s, {steps_ahead(task)}: {about} {told_time(seconds)} of one core"
    told = [run, *told_before(scene, model, path.parent), *chosen_for(promises([choice] if choice else []))]
    return [f"{path}: {scene.title}", *(f"  {line}" for line in told)], seconds


def steps_ahead(task) -> str:
    """Steps of a run to its limit, and how long they are."""
    model = task.engine.model
    told = f"at most {(task.last - task.began) // model.pace.ticks:,} steps of {model.step:.3g} s"
    return f"{told}, were they all as long as the first" if model.pace.changes else told


def told_before(scene, model, folder: Path) -> list[str]:
    """Lines that a user should know of a scene before it runs: where it goes on from, softening, possible mistakes."""
    from silostudy.compute.dem_files import rates_left
    from silostudy.config.spheres import SphereScene
    from silostudy.scene.notes import notes
    from silostudy.scene.spheres_about import softening

    cautions = [*notes(scene, model), *rates_left(scene, folder)]
    branch = branch_told(scene, model) if model.end else []
    if not isinstance(scene, SphereScene):
        return [*branch, *cautions]
    return [*branch, *cautions, *softening(scene, model)]


def branch_told(scene, model) -> list[str]:
    """Lines on where a scene goes on from, and with what that its file states otherwise."""
    from silostudy.dem.likeness import as_events_left

    then = f"goes on from {scene.start_from} at {model.end['engine']['step'] * model.dt:.6g} s"
    left = "; ".join(as_events_left(model, model.end))
    return [then, *([f"goes on as events left it there: {left}"] if left else [])]


def chosen_for(promise: dict[str, str]) -> list[str]:
    """The settings chosen for an accuracy and the error expected of them, in the words of the cube's attributes."""
    return [f"{name.replace('_', ' ')}: {text}" for name, text in promise.items()]
