"""`silostudy explain KEY`: formula, symbols, source, range of a method or rule, and its source's errors; or a DEM scene."""

from pathlib import Path
from typing import TYPE_CHECKING

from silostudy.commands.families import add_methods_from, families

if TYPE_CHECKING:
    from silostudy.config.own_rows import Families


def add(sub) -> None:
    command = sub.add_parser(
        "explain",
        help="explain a method, a rule, a contact law, or a discrete-element scene: which effects it calls for and their price",
    )
    what = (
        "see `silostudy list methods`, `buckling`, `laws` and `mass-rules`; earthquake (on a shell); accuracy (who may ask); "
        "or a scene file (*.yaml)"
    )
    command.add_argument("method", help=what)
    add_methods_from(command)
    command.set_defaults(run=run)


def run(chosen) -> None:
    scene = chosen.method.endswith((".yaml", ".yml"))
    print("\n".join(scene_explanation(chosen.method) if scene else explanation(chosen.method, families(chosen))))


def scene_explanation(name: str) -> list[str]:
    """Each effect of a discrete-element scene: on or off, why, and its measured share of a step."""
    from silostudy.accuracy.prices import prices
    from silostudy.choice.dem import load
    from silostudy.compute.dem import scene_model
    from silostudy.dem.stability import longest_step
    from silostudy.scene.dem import effects

    path = Path(name)
    scene, _ = load(path)
    model = scene_model(scene, path.parent, name)
    whole, share = prices(model)
    lines = [f"{scene.title}: {len(model.x)} discs, {whole / len(model.x) * 1e9:.1f} ns a particle-step"]
    lines.append(
        f"  step {model.dt:.3g} s; stability bound of this start {longest_step(model):.3g} s; integrator {model.integrator}"
    )
    for effect in effects(scene):
        price = priced(share.get(effect.name))
        lines.append(f"  {effect.name:30}{'on ' if effect.on else 'off'}  {price:42}{effect.why}")
    return lines


def explanation(key: str, known: "Families") -> list[str]:
    """The lines that explain a method, a rule, a contact law, or a topic; BadInput lists the known ones."""
    from silostudy.buckling import BUCKLING, RIVALS
    from silostudy.checks import CHECKS
    from silostudy.commands import (
        explain_accuracy,
        explain_buckling,
        explain_check,
        explain_law,
        explain_pressure,
        explain_seismic,
    )
    from silostudy.contact import LAWS
    from silostudy.errors import unknown
    from silostudy.pressure import PRESSURE
    from silostudy.seismic.rules import MASS_RULES

    topics = {explain_seismic.EARTHQUAKE: explain_seismic.earthquake, explain_accuracy.KEY: explain_accuracy.explanation}
    if key in topics:
        return topics[key]()
    families = [(known[PRESSURE.name], explain_pressure), (known[BUCKLING.name], explain_buckling)]
    families += [(known[RIVALS.name], explain_buckling), (MASS_RULES, explain_seismic), (CHECKS, explain_check)]
    families += [(known[family.name], explain_law) for family in LAWS.values()]
    found = [told.explanation(family[key]) for family, told in families if key in family]
    if not found:
        raise unknown("method, rule or law", key, dict.fromkeys([*(key for family, _ in families for key in family), *topics]))
    return [line for lines in found for line in lines]


def priced(price) -> str:
    """Share of a step; below zero the kernel without the effect was the slower one on these discs."""
    if price is None:
        return ""
    if price.high < 0:
        return f"{price.time:6.1%} (a step without it is slower here)"
    return f"{price.time:6.1%} of a step, {price.memory:.0%} of memory"
