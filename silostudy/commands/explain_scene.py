"""Lines of `silostudy explain` on a scene of grains, and on the parts that scenes choose from."""

from dataclasses import dataclass
from pathlib import Path
from typing import Any

from silostudy.catalogue import Entry, Family, Row
from silostudy.config.dem import EventConfig
from silostudy.config.moves import Takes
from silostudy.config.sphere_events import SphereEventConfig
from silostudy.dem.events import TRIGGERS
from silostudy.dem.inserts import LINES
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.outcomes import OUTCOMES
from silostudy.dem.rest import REST
from silostudy.dem.space.inserts import INSERTS
from silostudy.packing import PACKINGS
from silostudy.packing.filling import FILLINGS
from silostudy.packing.sizes import SIZES


@dataclass(frozen=True, kw_only=True)
class Action(Entry):
    """Something that an event does. takes: by the grains whose scenes have it, the keys that it takes."""

    takes: tuple[tuple[str, Takes], ...]


TAKES = {"discs": EventConfig.takes, "spheres": SphereEventConfig.takes}


def action(key: str) -> Action:
    """The action of a key, of any grains."""
    takes = tuple((grains, of[key]) for grains, of in TAKES.items() if key in of)
    return Action(key=key, title=takes[0][1].title, takes=takes)


def of_both(family: Family) -> dict[str, Family]:
    """A family that scenes of any grains choose from."""
    return dict.fromkeys(TAKES, family)


PARTS: dict[str, dict[str, Family]] = {  # by the grains whose scenes have them
    "packings": {"discs": PACKINGS},
    "fillings": {"spheres": FILLINGS},
    "inserts": {"discs": LINES, "spheres": INSERTS},
    "sizes": {"spheres": SIZES},
    "integrators": of_both(INTEGRATORS),
    "triggers": of_both(TRIGGERS),
    "actions": {grains: Family("action", map(action, takes)) for grains, takes in TAKES.items()},
    "rest": of_both(REST),
    "quantities": {
        grains: Family(OUTCOMES.name, (row for row in OUTCOMES.values() if grains in row.grains)) for grains in TAKES
    },
}


def rows_of(part: str) -> Family:
    """Rows of a part of scenes of any grains, each once."""
    return Family(part, {key: row for family in PARTS[part].values() for key, row in family.items()}.values())


def grains_of(part: str, key: str) -> list[str]:
    """The grains whose scenes have a row of a part."""
    return [grains for grains, family in PARTS[part].items() if key in family]


def explanation(row) -> list[str]:
    """The lines that explain a packing, an insert, an integrator, a trigger, an action, a criterion of rest or a quantity."""
    from silostudy.tables.references import with_locator

    part = next(name for name in PARTS if row in rows_of(name).values())
    lines = [f"{row.title} ({row.key}, of {part} of {' and '.join(grains_of(part, row.key))})"]
    for function in ("advance", "measure", "place", "make", "draw", "find"):
        if (told := getattr(row, function, None)) is not None:
            lines.append(f"  gives     {told.__doc__.splitlines()[0]}")
    for grains, taken in getattr(row, "takes", ()):
        said = {"needs": ", ".join(taken.needs), "may take": ", ".join(taken.may)}
        told = "; ".join(f"{how} {keys}" for how, keys in said.items() if keys)
        lines.append(f"  {grains:9} {told or 'takes nothing'}")
    for asked in getattr(row, "asks", ()):
        lines.append(f"  takes     {asked.name} ({asked.unit}): {asked.text}")
    if getattr(row, "below", None) is not None:
        lines.append(f"  below     {row.below:g}, unless a scene's rest.below says otherwise")
    if getattr(row, "most", None) is not None:
        lines.append(f"  value     at most {row.most:g}")
    return [*lines, *([f"  source    {with_locator(row.source, row.locator)}"] if isinstance(row, Row) else [])]


def scene_explanation(name: str) -> list[str]:
    """Each effect of a discrete-element scene: on or off, why, and its measured share of a step; what it costs."""
    from silostudy.choice.dem import load
    from silostudy.compute.dem import run_of, scene_model
    from silostudy.config.spheres import SphereScene

    path = Path(name)
    scene, _ = load(path)
    model: Any = scene_model(scene, path.parent, name)
    run_of(scene, model, name)  # tells what is impossible by the step, or by the end that it goes on from
    return _of_spheres(scene, model) if isinstance(scene, SphereScene) else _of_discs(scene, model)


def _of_spheres(scene, model) -> list[str]:
    """Materials, coefficients, softening, times and effects of a scene of spheres."""
    from silostudy.accuracy.prices import price_of_step
    from silostudy.accuracy.sample_of_spheres import sample
    from silostudy.dem.explosion import Explosion
    from silostudy.dem.stability import packed_bound
    from silostudy.scene.coefficients import coefficient_lines, impact_lines
    from silostudy.scene.notes import notes
    from silostudy.scene.spheres_about import materials, shares, softening, sphere_effects, wave_times

    lines = [
        f"{scene.title}: {len(model.x)} spheres, diameters {2e3 * model.radius.min():.4g} to {2e3 * model.radius.max():.4g} mm"
    ]
    about = (*shares(scene, model), *materials(scene), *coefficient_lines(model, tuple(scene.grain_kinds)))
    lines += [f"  {line}" for line in (*about, surfaces(model), *softening(scene, model))]
    lines.append(
        f"  step {model.step:.3g} s; stability bound of the densest packing {packed_bound(model):.3g} s; Rayleigh time of the "
        f"smallest sphere {wave_times(scene, model)}; integrator {model.integrator}"
    )
    lines += [f"  {line}" for line in impact_lines(model, tuple(scene.grain_kinds))]
    try:
        lines.append(f"  {run_cost(scene, model, *price_of_step(sample(model)))}")
    except Explosion as explosion:
        lines.append(f"  {unpriced(explosion)}")
    for effect in sphere_effects(scene):
        lines.append(f"  {effect.name:30}{'on ' if effect.on else 'off'}  {listed(effect):42}{effect.why}")
    return lines + [f"  {line}" for line in notes(scene, model)]


def run_cost(scene, model, price: float, memory: float) -> str:
    """Cost of a run at most, from the CPU time (s) of a body's step and the memory (bytes) of a body."""
    from math import ceil

    from silostudy.scene.costs import duration, told_time

    began = model.end["engine"]["step"] if model.end else 0
    steps = max(0, ceil((duration(scene) / model.dt - int(began)) / model.pace.ticks))
    count, body = len(model.x), model.space.body
    taken, megabytes = told_time(count * steps * price), count * memory / 1e6
    return (
        f"at most {steps:,} steps of {count:,} {body}s, {price * 1e9:.1f} ns each here and now: about {taken} of one "
        f"core, looks and records apart; {memory:.0f} bytes a {body}, {megabytes:.3g} MB"
    )


def unpriced(explosion) -> str:
    """Line in place of the cost where a sample of the grains does not come to rest."""
    return f"warning: no cost is told, since a sample of these grains does not come to rest: {explosion}"


def surfaces(model) -> str:
    """The names that a scene may give to its surfaces."""
    from silostudy.scene.surfaces import known_names

    return f"surfaces: {', '.join(known_names([wall.name for wall in model.walls]))}"


def _of_discs(scene, model) -> list[str]:
    from silostudy.accuracy.prices import prices
    from silostudy.dem.engine import Engine
    from silostudy.dem.explosion import Explosion
    from silostudy.dem.stability import longest_step
    from silostudy.scene.coefficients import coefficient_lines, impact_lines
    from silostudy.scene.dem import effects
    from silostudy.scene.notes import notes

    share: dict[str, Any] = {}
    lines = [f"{scene.title}: {len(model.x)} discs"]
    try:
        whole, share = prices(model)
        lines = [f"{lines[0]}, {whole / len(model.x) * 1e9:.1f} ns a particle-step"]
        cost = run_cost(scene, model, whole / len(model.x), Engine(model).nbytes / len(model.x))
    except Explosion as explosion:
        cost = unpriced(explosion)
    lines.append(
        f"  step {model.step:.3g} s; stability bound of this start {longest_step(model):.3g} s; integrator {model.integrator}"
    )
    about = (*impact_lines(model, scene.kinds), cost, *coefficient_lines(model, scene.kinds), surfaces(model))
    lines += [f"  {line}" for line in about]
    for effect in effects(scene):
        price = priced(share.get(effect.name))
        lines.append(f"  {effect.name:30}{'on ' if effect.on else 'off'}  {price:42}{effect.why}")
    return lines + [f"  {line}" for line in notes(scene, model)]


def listed(effect) -> str:
    """Share of a step's instructions and of memory of an effect of spheres, by the shipped list; nothing where it is off."""
    from silostudy.accuracy.priced_effects import SPHERES, label
    from silostudy.tables.effect_prices import EFFECT_PRICES

    price = EFFECT_PRICES.get(label(effect.name, effect.law) + SPHERES) if effect.on else None
    if price is None:
        return ""
    return f"{price.instructions:6.1%} of instructions, {price.memory:.0%} of memory"


def priced(price) -> str:
    """Share of a step; below zero the kernel without the effect was the slower one on these discs."""
    if price is None:
        return ""
    if price.high < 0:
        return f"{price.time:6.1%} (a step without it is slower here)"
    return f"{price.time:6.1%} of a step, {price.memory:.0%} of memory"
