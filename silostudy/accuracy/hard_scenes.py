"""Hard cases as scene files in the engine and in LAMMPS: what each comes to beside the number that it expects."""

from collections.abc import Iterator
from pathlib import Path

from silostudy.accuracy.arrivals import Arrival, followed
from silostudy.accuracy.laws_in_lammps import OTHERS, PLAIN, CannotSay, Way
from silostudy.accuracy.scene_in_lammps import SceneInLammps
from silostudy.choice.dem import load
from silostudy.compute.dem import run_of, scene_model
from silostudy.compute.expected import Verdict, verdicts, verdicts_on
from silostudy.config.spheres import SphereScene
from silostudy.dem.run import Run
from silostudy.errors import BadInput

MET = {True: "met", False: "not met"}


def scenes_in(folder: Path) -> list[Path]:
    """Scene files of a folder, by name; BadInput where it holds none."""
    paths = sorted(folder.glob("*.yaml"))
    if not paths:
        raise BadInput("--scenes", str(folder), "must be a folder with scene files (*.yaml)")
    return paths


def verdict_rows(path: Path, with_peer: bool) -> list[dict[str, str]]:
    """A row each number that a scene of spheres expects: what both codes come to. Where it goes with the way in which LAMMPS is
    told the scene whether it meets the number, a row for the other way too."""
    scene, _ = load(path)
    if not isinstance(scene, SphereScene):
        raise BadInput("grains", "discs", "must be spheres: LAMMPS is told of no others here", str(path))
    run = run_of(scene, scene_model(scene, path.parent))
    came = followed(run)
    ours = verdicts(run, scene)
    if not with_peer:
        return [_row(path.stem, verdict) | _unsaid("not run") for verdict in ours]
    try:
        theirs = list(_in_ways(scene, run, came))
    except CannotSay as reason:
        return [_row(path.stem, verdict) | _unsaid(f"cannot be told: {reason}") for verdict in ours]
    return [_row(path.stem, ours[number]) | _said(verdict, way.title(scene)) for number, verdict, way in theirs]


def _in_ways(scene: SphereScene, run: Run, came: list[Arrival]) -> Iterator[tuple[int, Verdict, Way]]:
    """Yields number, verdict and way of each number expected: of the plain way, and of others whose verdict is another."""
    plain = verdicts_on(SceneInLammps(scene, run, came, PLAIN).go(), scene)
    others = [(way, verdicts_on(SceneInLammps(scene, run, came, way).go(), scene)) for way in OTHERS]
    for number, verdict in enumerate(plain):
        yield number, verdict, PLAIN
        for way, again in others:
            if again[number].met != verdict.met:
                yield number, again[number], way


def _row(name: str, verdict: Verdict) -> dict[str, str]:
    return {
        "scene": name, "quantity": verdict.quantity.key, "unit": verdict.quantity.unit,
        "expected": _number(verdict, verdict.value), "tolerance": f"{verdict.tolerance:.3g}",
        "silostudy": _number(verdict, verdict.computed), "silostudy_verdict": MET[verdict.met],
    }  # fmt: skip


def _said(verdict: Verdict, told: str) -> dict[str, str]:
    return {"lammps": _number(verdict, verdict.computed), "lammps_verdict": MET[verdict.met], "told": told}


def _unsaid(why: str) -> dict[str, str]:
    return {"lammps": "", "lammps_verdict": why, "told": ""}


def _number(verdict: Verdict, value: float) -> str:
    return f"{value:.{verdict.digits}g}"
