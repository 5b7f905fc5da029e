"""Cautions on events that find nothing to do, or nothing to wait for, and on outlets that open too slowly for their run."""

from collections.abc import Iterator, Mapping
from typing import Any

from silostudy.config.moves import OF_LID
from silostudy.scene.cautions import OPENS


def vain_events(scene: Any, widths: Mapping[str, float]) -> Iterator[str]:
    """A caution for each event of a scene that comes too late or too soon to do anything; widths (m): of outlets by name."""
    yield from waits_for_lids(scene)
    yield from taken_again(scene)
    yield from never_open(scene, widths)


def waits_for_lids(scene: Any) -> Iterator[str]:
    """A caution for each event that waits for the rest of a lid which no event before it has moved."""
    for number, event in enumerate(scene.events):
        moved = scene.start_from or any(before.do in OF_LID for before in scene.events[:number])
        if event.when == "lid_rests" and not moved:
            yield f"events.{number} waits for the lid to rest, and no event before it moves the lid"


def taken_again(scene: Any) -> Iterator[str]:
    """A caution for each insert that an event takes away after another has."""
    taken: dict[str, int] = {}
    for number, event in enumerate(scene.events):
        for name in event.surfaces if event.do == "take_away" else ():
            if name in taken:
                yield f"events.{number} takes {name} away, which events.{taken[name]} has done"
            taken.setdefault(name, number)


def never_open(scene: Any, widths: Mapping[str, float]) -> Iterator[str]:
    """A caution for each outlet that grows too slowly to be open when the run ends."""
    for number, event in enumerate(scene.events):
        for name, width in widths.items() if event.do in OPENS and event.speed_m_s else ():
            takes = width / event.speed_m_s
            if takes > scene.march.limit_s and (name in event.outlets or not event.outlets):
                told = f"{width:g} m take {takes:.3g} s, and the run ends at march.limit_s = {scene.march.limit_s:g}"
                yield f"events.{number}.speed_m_s = {event.speed_m_s:g}: {told}"
