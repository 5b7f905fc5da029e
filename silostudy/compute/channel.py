"""Silos in large eccentric discharge: the pressures on three zones of wall, for each size of the flow channel."""

from collections.abc import Mapping, Sequence

import numpy as np

from silostudy.compute.evaluate import AskedMethod, masked, with_reasons
from silostudy.pressure.family import CHANNEL_QUANTITIES, CHANNEL_SIZES, CHANNEL_TOTALS, NO_PHASE
from silostudy.scene.expand import Expansion


def channel_variables(expansion: Expansion, methods: list[AskedMethod], given: Sequence[Mapping], z: np.ndarray) -> dict:
    """Every quantity of the channels, (method, phase, axes..., channel[, depth]); nothing where no method has one."""
    if not any(method.row.channel for method in methods):
        return {}
    cases = (len(methods), len(expansion.study.phases), *expansion.shape)
    shapes = {name: (*cases, len(CHANNEL_SIZES), z.shape[-1]) for name in CHANNEL_QUANTITIES}
    shapes |= {name: (*cases, len(CHANNEL_SIZES)) for name in CHANNEL_TOTALS}
    values = {name: np.full(shape, np.nan) for name, shape in shapes.items()}
    scopes = {name: np.full(shape, NO_PHASE, dtype=np.int8) for name, shape in shapes.items()}
    for m, (method, handed) in enumerate(zip(methods, given, strict=True)):
        for phase in method.row.channel.keys() & set(expansion.study.phases):
            p = expansion.study.phases.index(phase)
            for c, size in enumerate(CHANNEL_SIZES):
                parameters = {**handed, "channel_size": np.full_like(handed["diameter"], size)}
                for name, function in method.row.channel[phase].items():
                    place = z if name in CHANNEL_QUANTITIES else None
                    value, scope = masked(method.row, name, phase, function, place, parameters)
                    spot = (m, p, ..., c, slice(None)) if name in CHANNEL_QUANTITIES else (m, p, ..., c)
                    last = slice(None) if name in CHANNEL_QUANTITIES else 0
                    values[name][spot], scopes[name][spot] = value[..., last], scope[..., last]
    return values | with_reasons(scopes) | {"channel": list(CHANNEL_SIZES)}
