"""`silostudy explain KEY`: formula, symbols, source, range of a method or rule, and its source's errors; or a DEM scene."""

from pathlib import Path
from typing import TYPE_CHECKING

from silostudy.commands.families import add_methods_from, families

if TYPE_CHECKING:
    from silostudy.config.own_rows import Families


def add(sub) -> None:
    command = sub.add_parser(
        "explain", help="explain a method, a rule, or a discrete-element scene: which effects it calls for and their price"
    )
    what = (
        "see `silostudy list methods`, `buckling` and `mass-rules`; earthquake: that on a shell; accuracy: who may ask for it; "
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
    """The lines that explain a pressure method, a buckling rule or an effective mass rule; BadInput lists the known ones."""
    from silostudy.buckling import BUCKLING, RIVALS
    from silostudy.commands import explain_accuracy, explain_buckling, explain_seismic
    from silostudy.errors import unknown
    from silostudy.pressure import PRESSURE
    from silostudy.pressure.family import PARAMETERS
    from silostudy.seismic.rules import MASS_RULES
    from silostudy.tables.handbook import errata
    from silostudy.tables.references import with_locator

    if key == explain_seismic.EARTHQUAKE:
        return explain_seismic.earthquake()
    if key == explain_accuracy.KEY:
        return explain_accuracy.explanation()
    if key in MASS_RULES:
        return explain_seismic.explanation(MASS_RULES[key])
    rules, methods = {**known[BUCKLING.name], **known[RIVALS.name]}, known[PRESSURE.name]
    if key in rules:
        return explain_buckling.explanation(rules[key])
    if key not in methods:
        raise unknown("method or rule", key, [*methods, *rules, *MASS_RULES, explain_seismic.EARTHQUAKE, explain_accuracy.KEY])
    row = methods[key]
    lines = [f"{row.title} ({row.key})", f"  formula   {row.formula}", f"  range     {row.range}"]
    lines.append(f"  plans     {', '.join(sorted(row.plans))}")
    for phase, quantities in row.phases.items():
        lines.append(f"  {phase:9} gives {', '.join(quantities)}")
    for phase, quantities in row.hopper.items():
        lines.append(f"  {phase:9} gives on the hopper wall {', '.join(quantities)}")
    for phase, quantities in row.totals.items():
        lines.append(f"  {phase:9} gives for the silo {', '.join(quantities)}")
    lines += [f"  {quantity} with {values}" for quantity, values in row.values.items()]
    lines.append("  symbols   z depth below the equivalent surface (m)")
    lines += [f"            {symbol}: {name} ({unit})" for name, (unit, symbol, _) in PARAMETERS.items() if name in row.needs]
    if row.equilibrium:
        lines.append(f"  weight = vertical pressure + wall friction, to rounding, in {' and '.join(row.equilibrium)}")
    lines += [f"  not computed: {what}" for what in row.not_computed]
    lines.append(f"  source    {with_locator(row.source, row.locator)}")
    for erratum in (erratum for erratum in errata() if erratum.method == key):
        lines.append(f"  error of the source, {erratum.place}: printed {erratum.printed}; right: {erratum.right}")
        lines.append(f"            known because {erratum.evidence}")
    if row.has_misprint:
        lines.append(f"  to see the print's own reading, list the method under `as_printed` in a study: [{key}]")
    return lines


def priced(price) -> str:
    """Share of a step; below zero the kernel without the effect was the slower one on these discs."""
    if price is None:
        return ""
    if price.high < 0:
        return f"{price.time:6.1%} (a step without it is slower here)"
    return f"{price.time:6.1%} of a step, {price.memory:.0%} of memory"
