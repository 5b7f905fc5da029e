"""Lines that a scene of discs cannot have are refused, each in one line."""

from __future__ import annotations

from dataclasses import replace
from itertools import pairwise
from typing import TYPE_CHECKING

import numpy as np

from silostudy.dem.joints import CLOSE
from silostudy.dem.walls import faces
from silostudy.errors import BadInput

if TYPE_CHECKING:
    from silostudy.dem.model import Wall
    from silostudy.scene.plane_silo import PlaneSilo


def require_slits(silo: PlaneSilo) -> None:
    """BadInput for slits without names of their own, that leave the floor, or touch each other."""
    names = [slit.name for slit in silo.slits]
    if len(set(names)) < len(names):
        raise BadInput("outlets", ", ".join(names), "each outlet needs a name of its own")
    for number, slit in enumerate(silo.slits):
        if not 0.0 < slit.edges[0] < slit.edges[1] < silo.width:
            allowed = f"must leave floor on both sides, from 0 to {silo.width:g} m"
            raise BadInput(f"outlets.{number}.middle_m", slit.middle, allowed)
    ordered = sorted(silo.slits, key=lambda slit: slit.middle)
    for left, right in pairwise(ordered):
        if not left.edges[1] < right.edges[0]:
            raise BadInput("outlets", f"{left.name}, {right.name}", "must not overlap or touch")


def require_lines(silo: PlaneSilo) -> None:
    """BadInput for a line without a name of its own, or that lies on another wall: both would push."""
    if not silo.inserts:
        return
    walls = list(replace(silo, inserts=()).walls())
    parts = {wall.name.partition("_")[0] for wall in walls}
    for number, insert in enumerate(silo.inserts):
        names = [name for name, _ in faces(walls)]
        if insert.name in names or insert.name.partition("_")[0] in parts:
            raise BadInput(f"inserts.{number}.name", insert.name, f"is taken; taken by then: {', '.join(names)}")
        if taken := [name for name, _ in faces([insert]) if name in names]:
            raise BadInput(f"inserts.{number}.name", insert.name, f"has a back recorded as {taken[0]}, which is taken")
        for wall in walls:
            if (shared := shared_length(wall, insert)) > 0.0:
                raise BadInput(f"inserts.{number}", insert.name, f"lies on {wall.name} along {shared:.4g} m: both would push")
        walls.append(insert)


def shared_length(wall: Wall, line: Wall) -> float:
    """Length (m) along which a line lies on a wall; 0 where they only meet or cross."""
    start, way = np.array(wall.start), np.subtract(wall.end, wall.start)
    length = float(np.hypot(*way))
    (x0, y0), (x1, y1) = ((place - start) / length for place in (np.array(line.start), np.array(line.end)))
    (tx, ty) = way / length
    close = CLOSE * max(1.0, abs(x0), abs(y0), abs(x1), abs(y1))
    if max(abs(tx * y0 - ty * x0), abs(tx * y1 - ty * x1)) > close:
        return 0.0
    low, high = sorted((tx * x0 + ty * y0, tx * x1 + ty * y1))
    shared = min(high, 1.0) - max(low, 0.0)
    return shared * length if shared > close else 0.0
