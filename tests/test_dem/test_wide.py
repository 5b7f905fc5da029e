"""The wide list against all pairs of a scene, taken one by one."""

import numpy as np
import pytest

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.dem.arrays import BLOCK
from silostudy.dem.engine import Engine
from silostudy.dem.model import Model
from silostudy.dem.wide import SHIFT

from .scenes import silo


def heap() -> Model:
    return silo(across=20, height=0.3, slit=0.12)


def ball_bin() -> Model:
    return bin_of_spheres(Bin(count=600, wide=0.03))


def settled(model: Model, threads: int) -> tuple[Engine, np.ndarray]:
    """An engine whose wide list was just made, and the places (n, d; m) of its bodies then."""
    engine = Engine(model, threads=threads)
    engine.step_to(700)
    engine.blocks.wide_travel[:] = np.inf
    engine.give_memories(*engine.take_memories())
    engine.step_to(engine.step)
    return engine, engine.bodies.rows[: engine.n, engine.space.place]


def of_parts(engine: Engine) -> set[tuple[int, int]]:
    """Pairs of the wide lists of all threads, lower number first."""
    pairs = set()
    for part in engine.parts:
        lo, hi = engine.bounds(part.number)
        begin, crossing = part.scratch.wide_begin, part.scratch.cross[1 : part.scratch.cross[0] + 1]
        pairs |= {(i, int(j)) for i in range(lo, hi) for j in part.scratch.wide[begin[i - lo] : begin[i - lo + 1]]}
        pairs |= {(int(key >> SHIFT), int(key & ((1 << SHIFT) - 1))) for key in crossing}
    return pairs


@pytest.mark.parametrize("threads", [1, 2])
@pytest.mark.parametrize("model", [heap, ball_bin])
def test_holds_all_pairs_within_reach_and_no_others(model, threads):
    engine, place = settled(model(), threads)
    i, j = np.triu_indices(engine.n, 1)
    skin = engine.blocks.wide_skin
    reach = engine.radius[i] + engine.radius[j] + skin[i // BLOCK] + skin[j // BLOCK] + engine.model.gap
    near = np.linalg.norm(place[i] - place[j], axis=1) < reach
    assert of_parts(engine) == set(zip(i[near].tolist(), j[near].tolist(), strict=True))
    assert near.sum() > engine.n
