"""Commands on a study before it is computed: `check`, `cases`, and `schema` for editors."""

from collections.abc import Collection
from pathlib import Path
from pkgutil import resolve_name

from silostudy.errors import BadInput

LOOKED = 10_000  # cases of a sweep of grains that `check` looks at


def add(sub) -> None:
    check = sub.add_parser("check", help="validate a study or a scene and count its cases, without computing anything")
    check.add_argument("study", type=Path, help="a study file, or its name in config/studies; or a scene file")
    check.add_argument("--price", action="store_true", help="of a grains study: settle and time one filling")
    check.set_defaults(run=run_check)

    cases = sub.add_parser("cases", help="write the table of cases of a study")
    cases.add_argument("study", type=Path, help="a study file, or its name in config/studies")
    cases.add_argument("output", type=Path, help="CSV file to write")
    cases.set_defaults(run=run_cases)

    schema = sub.add_parser("schema", help="write the JSON schema of study files, for editors")
    schema.add_argument("output", type=Path)
    schema.set_defaults(run=run_schema)


def run_check(chosen) -> None:
    from silostudy.choice.expand import expand_file
    from silostudy.config.load import read_study, read_yaml
    from silostudy.stages import FILE_KINDS, KINDS

    path = path_of(chosen.study)
    said = read_yaml(path).get("kind")
    if said in FILE_KINDS and said not in KINDS:
        _check_price(chosen.price, said, ())
        print("\n".join(scene_checked(path)))
        return
    expansion = expand_file(path, looked_at(read_study(path)))
    kind = KINDS[expansion.study.kind]
    _check_price(chosen.price, said, kind.timed)
    axes = " x ".join(f"{axis.axis} {len(axis.settings())}" for axis in expansion.study.sweep) or "no sweep"
    print(f"{path}: {expansion.study.title}")
    print(f"  {expansion.size} case(s): {axes}")
    if len(expansion.cases) < expansion.size:
        print(f"  note: {len(expansion.cases):,} of them, drawn at random, are looked at here")
    for about in (*kind.about, *(kind.timed if chosen.price else ())):
        for line in resolve_name(about)(expansion):
            print(f"  {line}")
    for line in chosen_for(expansion.promise):
        print(f"  {line}")


def looked_at(study) -> list[int] | None:
    """Positions of the cases that `check` builds: LOOKED of a study in parts that has more; None: all."""
    import random
    from math import prod

    from silostudy.stages import KINDS

    count = prod(len(axis.settings()) for axis in study.sweep)
    if count <= LOOKED or not any(stage.parts for stage in KINDS[study.kind].stages):
        return None
    return sorted(random.Random(0).sample(range(count), LOOKED))


def path_of(study: Path) -> Path:
    """The file of a study that is named by its path, or by its name in config/studies."""
    return study if study.suffix in (".yaml", ".yml") or study.is_file() else Path("config/studies") / f"{study}.yaml"


def _check_price(asked: bool, kind: object, timed: Collection[str]) -> None:
    """BadInput where a price is asked for that no study of the kind tells."""
    if asked and not timed:
        raise BadInput("--price", True, f"kind {kind} has none to tell")


def scene_checked(path: Path) -> list[str]:
    """Lines on a scene of grains: its start is built, with every file that it names, and its run is not."""
    from silostudy.choice.dem import load
    from silostudy.choice.promise import promises
    from silostudy.compute.dem import run_of, scene_model

    scene, choice = load(path)
    model = scene_model(scene, path.parent, str(path))
    task = run_of(scene, model)  # tells too what is impossible by the step alone
    run = f"{len(model.x)} {model.space.body}s, {steps_ahead(task)}"
    told = [run, *told_before(scene, model), *chosen_for(promises([choice] if choice else []))]
    return [f"{path}: {scene.title}", *(f"  {line}" for line in told)]


def steps_ahead(task) -> str:
    """Steps of a run to its limit, and how long they are."""
    model = task.engine.model
    told = f"at most {(task.last - task.began) // model.pace.ticks:,} steps of {model.step:.3g} s"
    return f"{told}, were they all as long as the first" if model.pace.share else told


def told_before(scene, model) -> list[str]:
    """Lines that a user should know of a scene before it runs: where it goes on from, softening, possible mistakes."""
    from silostudy.config.spheres import SphereScene
    from silostudy.scene.cautions import high_frictions
    from silostudy.scene.spheres_about import softening, warnings

    cautions = [f"note: {text}" for text in high_frictions(scene)]
    branch = [f"goes on from {scene.start_from} at {model.end['engine']['step'] * model.dt:.6g} s"] if model.end else []
    if not isinstance(scene, SphereScene):
        return [*branch, *cautions]
    return [*branch, *cautions, *softening(scene, model), *(f"warning: {line}" for line in warnings(scene, model))]


def chosen_for(promise: dict[str, str]) -> list[str]:
    """The settings chosen for an accuracy and the error expected of them, in the words of the cube's attributes."""
    return [f"{name.replace('_', ' ')}: {text}" for name, text in promise.items()]


def run_cases(chosen) -> None:
    import csv
    import json

    from silostudy.choice.expand import expand_file
    from silostudy.files import replacing, seal

    expansion = expand_file(path_of(chosen.study))
    keys = list(expansion.cases[0].settings)
    with replacing(chosen.output) as temporary, temporary.open("w", newline="", encoding="utf-8") as stream:
        table = csv.writer(stream)
        table.writerow(["case", *keys])
        for case in expansion.cases:
            values = (case.settings[key] for key in keys)
            table.writerow(
                [case.id, *(value if isinstance(value, (str, int, float)) else json.dumps(value) for value in values)]
            )
    seal(chosen.output)


def run_schema(chosen) -> None:
    from silostudy.config.schema import study_schema
    from silostudy.files import replacing

    with replacing(chosen.output) as temporary:
        temporary.write_text(study_schema(), encoding="utf-8")
