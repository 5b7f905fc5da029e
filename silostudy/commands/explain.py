"""Command `silostudy explain KEY`: formula, symbols, source, range of a method or rule, its source's errors; or a scene."""

from typing import TYPE_CHECKING

from silostudy.commands.families import add_methods_from, families
from silostudy.errors import BadInput

if TYPE_CHECKING:
    from silostudy.config.own_rows import Families


def add(sub) -> None:
    command = sub.add_parser(
        "explain",
        help="explain a method, a rule, a contact law or another part of a scene, the keys of a kind of study, a key, or a "
        "discrete-element scene: which effects it calls for and their price",
    )
    what = (
        "see `silostudy list methods`, `buckling`, `laws`, `packings`, `integrators`, `triggers`, `actions`, `rest`, "
        "`mass-rules` and `kinds`; earthquake (on a shell); checks (of its steel); accuracy (who may ask); "
        "a key of a study or scene, as sample; "
        "or a scene file (*.yaml)"
    )
    command.add_argument("method", help=what)
    add_methods_from(command)
    command.set_defaults(run=run)


def run(chosen) -> None:
    from silostudy.commands.explain_scene import scene_explanation

    scene = chosen.method.endswith((".yaml", ".yml"))
    if scene and chosen.methods_from:
        raise BadInput("--methods-from", str(chosen.methods_from), f"write `methods_from` into {chosen.method}")
    print("\n".join(scene_explanation(chosen.method) if scene else explanation(chosen.method, families(chosen))))


def explanation(key: str, known: "Families") -> list[str]:
    """The lines that explain a method, a rule, a part of a scene, a kind, a key or a topic; BadInput lists all but keys."""
    from silostudy.buckling import BUCKLING, RIVALS
    from silostudy.checks import CHECKS
    from silostudy.commands import (
        explain_accuracy,
        explain_buckling,
        explain_check,
        explain_keys,
        explain_law,
        explain_pressure,
        explain_scene,
        explain_seismic,
    )
    from silostudy.contact import FAMILIES
    from silostudy.errors import unknown
    from silostudy.pressure import PRESSURE
    from silostudy.seismic.rules import MASS_RULES
    from silostudy.stages import FILE_KINDS

    topics = {explain_seismic.EARTHQUAKE: explain_seismic.earthquake, explain_accuracy.KEY: explain_accuracy.explanation}
    topics[explain_check.KEY] = explain_check.checks
    families = [(known[PRESSURE.name], explain_pressure), (known[BUCKLING.name], explain_buckling)]
    families += [(known[RIVALS.name], explain_buckling), (MASS_RULES, explain_seismic), (CHECKS, explain_check)]
    families += [(known[family.name], explain_law) for family in FAMILIES.values()]
    families += [(explain_scene.rows_of(part), explain_scene) for part in explain_scene.PARTS]
    families.append((FILE_KINDS, explain_keys))
    parts = [topics[key]()] if key in topics else []
    parts += [told.explanation(family[key]) for family, told in families if key in family]
    parts.append(explain_keys.key_explanation(key))
    if not any(parts):
        raise unknown(
            "key of a file, method, rule, law, part of a scene or kind of study",
            key,
            dict.fromkeys([*(key for family, _ in families for key in family), *topics]),
        )
    return [line for lines in parts for line in lines]
