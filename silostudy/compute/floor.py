"""The flat floor: pressure and shear over the distance from the axis."""

from collections.abc import Mapping, Sequence

import numpy as np

from silostudy.compute.evaluate import AskedMethod, filled, masked
from silostudy.config.fields import expand
from silostudy.pressure.family import FLOOR_QUANTITIES, IN_SCOPE, NO_FLOOR, NO_QUANTITY, OUT_OF_RANGE
from silostudy.scene.expand import Expansion


def floor_variables(expansion: Expansion, methods: list[AskedMethod], given: Sequence[Mapping]) -> dict:
    """Pressures on the floor (method, phase, axes..., floor_position)."""
    places = np.array(expand(expansion.study.floor_position))

    def on_floor(row, phase, parameters):
        functions, x = row.floor.get(phase, {}), places * parameters["diameter"] / 2
        values: dict[str, tuple] = {}
        for name in FLOOR_QUANTITIES if phase in row.phases else ():
            if name not in functions:
                values[name] = np.nan, np.int8(NO_QUANTITY)
                continue
            value, scope = masked(row, name, phase, functions[name], x, parameters)
            hopper = np.isin(scope, [IN_SCOPE, OUT_OF_RANGE]) & np.isfinite(parameters["hopper_half_angle"])
            values[name] = np.where(hopper, np.nan, value), np.where(hopper, np.int8(NO_FLOOR), scope)
        return values

    return {**filled(expansion, given, methods, FLOOR_QUANTITIES, on_floor, places.size), "floor_position": places}
