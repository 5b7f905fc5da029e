"""Cautions on scenes of grains: values that are possible, and beyond what is known of grains and walls."""

from collections.abc import Iterator, Mapping
from math import inf
from typing import Any

from pydantic import BaseModel

from silostudy.config.run import FLOWS
from silostudy.dem.outcomes import OUTCOMES
from silostudy.scene.laboratory_cell_discs import DiscCase
from silostudy.tables.ranges import PLAUSIBLE

OPENS = ("open_slit", "open_outlet")
LETS_OUT = (*FLOWS, "take_away", "remove_disc", "remove_sphere")  # what events do that grains leave by
HIGH_FRICTION = 1.5  # beyond any row of this package's tables, whose largest is below 1
DEEP = 0.05  # of a radius: an overlap beyond which contacts are too soft for what they bear
FRICTIONS = ("sliding_friction", "wall_friction", "disc_friction", "sphere_friction")  # keys of sliding friction
# what a plane cell is to be wide at least, for the belts at floor and lid: heights of its filling, mean diameters
HEIGHTS = 4.0
LEAST_WIDTH = 64.0


def high_frictions(config: Any, above: str = "") -> Iterator[str]:
    """A caution for each sliding friction of a section, and further in, above HIGH_FRICTION."""
    for name, value in parts(config):
        key = f"{above}{name}"
        if name in FRICTIONS and isinstance(value, float) and value > HIGH_FRICTION:
            yield f"{key} = {value:g} is unusual: grains and walls mostly have less than {HIGH_FRICTION:g}"
        yield from high_frictions(value, f"{key}.")


def unit_slips(config: Any, above: str = "") -> Iterator[str]:
    """A warning for each value of a section, and further in, beyond what grains are known to have."""
    for name, value in parts(config):
        key = f"{above}{name}"
        if name in PLAUSIBLE and value is not None:
            low, high = PLAUSIBLE[name]
            for number in value if isinstance(value, tuple) else (value,):
                if not low <= number <= high:
                    yield f"{key} = {number:g} looks like a unit slip: grains have {low:g} to {high:g}"
        elif name != "inserts":
            yield from unit_slips(value, f"{key}.")


def parts(config: Any) -> Iterator[tuple[str, Any]]:
    """Keys and values of a section, numbers and values of a list; nothing of a value."""
    if isinstance(config, list | tuple):
        return ((str(number), part) for number, part in enumerate(config))
    return iter(config.items() if isinstance(config, Mapping) else config if isinstance(config, BaseModel) else ())


def late_events(scene: Any) -> Iterator[str]:
    """A caution for each event of a scene that is told for a time before the last one's, or that its limit comes before."""
    earliest, limit = 0.0, scene.march.limit_s * (1.0 + 1e-9)
    for number, event in enumerate(scene.events):
        if event.when == "time" and event.value < earliest:
            yield f"events.{number} is told for {event.value:g} s, and waits for the one before it, at {earliest:g} s or later"
        if event.when in ("time", "after"):
            earliest = max(earliest, event.value) if event.when == "time" else earliest + event.value
        if earliest > limit:
            ends = f"the run ends before, at march.limit_s = {scene.march.limit_s:g}"
            yield f"events.{number} comes at {earliest:g} s or later: {ends}"
            return


def opened_again(scene: Any) -> Iterator[str]:
    """A caution for each outlet that an event opens again while it may grow."""
    widths = {outlet.name: outlet.width_m for outlet in scene.outlets}
    now, told, left = 0.0, True, dict.fromkeys(widths, inf)  # told: whether the clock is; left: s that an outlet may grow on
    for number, event in enumerate(scene.events):
        told = told and event.when in ("time", "after")
        passed = event.value if event.when == "after" else max(event.value - now, 0.0) if told else 0.0
        now, left = now + passed, {name: time - passed for name, time in left.items() if time > passed}
        for name in [name for name in left if event.do in OPENS and (name in event.outlets or not event.outlets)]:
            speed = event.speed_m_s
            if left[name] < inf:
                how = f"goes on at {speed:g} m/s" if speed else "opens at once"
                yield f"events.{number} opens outlet {name} again, which may grow until then: what is left of it {how}"
            left[name] = widths[name] / speed if speed else 0.0


def early_shares(scene: Any) -> Iterator[str]:
    """A caution for each event that waits for a share discharged, and number expected of it, where nothing lets grains out."""
    if scene.start_from:
        return
    lets_out = [event.do in LETS_OUT for event in scene.events]
    for number, event in enumerate(scene.events):
        if event.when == "discharged" and not any(lets_out[:number]):
            yield f"events.{number} waits for a share discharged, and no event before it lets grains out"
    for number, asked in enumerate(scene.expected):
        if OUTCOMES[asked.kind].of_outflow and not any(lets_out):
            yield f"expected.{number}.kind = {asked.kind}: no event lets grains out"


def upward(scene: Any) -> Iterator[str]:
    """A caution for gravity that pulls grains up, of a scene whose silo's top is open."""
    told = {"gravity_m_s2": scene.gravity_m_s2}
    told |= {f"events.{k}.gravity_m_s2": event.gravity_m_s2 for k, event in enumerate(scene.events)}
    for key, gravity in told.items():
        if gravity and gravity[-1] > 0.0:
            yield f"{key} points up: grains fall out of a silo whose top is open"


def narrow_cell(case: Any) -> Iterator[str]:
    """A caution where a plane cell of a laboratory is too narrow for its test of internal friction."""
    if isinstance(case, DiscCase) and case.config.cell_grains < max(LEAST_WIDTH, HEIGHTS * case.config.height_grains):
        yield (
            f"a cell of {case.config.cell_grains:g} grains by {case.config.height_grains:g}: narrower than {LEAST_WIDTH:g} "
            f"grains or {HEIGHTS:g} heights, its internal friction comes out too high"
        )
