"""Optional parts of scenes of spheres, each of a small bin that fills, rests and flows.

Laws, wall forces, the energy balance, kinds and walls that move are priced as effects of the engine; here is what else may be
asked for.
"""

from typing import Any

from silostudy.accuracy.optional_parts import OptionalPart
from silostudy.accuracy.optional_scenes import changing_steps, look, ran
from silostudy.accuracy.priced_effects import SPHERES

ROOM = "scenes of spheres"
SCENE: dict[str, Any] = {
    "kind": "dem",
    "grains": "spheres",
    "title": "a bin of spheres to price what is recorded of it",
    "silo": {
        "plan": "circular",
        "diameter_m": 0.06,
        "cylinder_depth_m": 0.1,
        "hopper": {"half_angle_deg": 30, "outlet_width_m": 0.04},
    },
    "grain": {"youngs_modulus_MPa": 100, "poissons_ratio": 0.25, "density_kg_m3": 2500, "softened_modulus_MPa": 5},
    "wall": {"youngs_modulus_MPa": 100, "poissons_ratio": 0.25},
    "spheres": {"restitution": 0.3, "sliding_friction": 0.5},
    "walls": {"restitution": 0.3, "sliding_friction": 0.3},
    "sizes": {"kind": "equal", "diameter_mm": 6},
    "filling": {"kind": "loose", "count": 150},
    "march": {"limit_s": 0.5},
    "events": [{"when": "time", "value": 0.3, "do": "open_outlet"}, {"when": "time", "value": 0.5, "do": "stop"}],
}
TIMES = [0.01 * k for k in range(1, 50)]  # s
WINDOW: dict[str, Any] = {"wall_force_window_s": 0.02}


def _recorded(name: str, *, beside: dict | None = None, **record: Any) -> OptionalPart:
    """A part that is a record, beside a run that records nothing, or what is named."""
    return OptionalPart(name + SPHERES, ROOM, ran(SCENE | {"record": record}), ran(SCENE | {"record": beside or {}}))


PARTS = (
    look("sphere", ROOM, SPHERES),
    *changing_steps(SCENE, ROOM, SPHERES),
    _recorded("wall pressures in 1 by 1 cells, 25 windows", pressure_cells=[1, 1], **WINDOW),
    _recorded("pressure map of 10 by 12 cells", beside=WINDOW | {"pressure_cells": [1, 1]}, pressure_cells=[10, 12], **WINDOW),
    _recorded("49 snapshots", snapshots_s=TIMES),
    _recorded("fields in rings of 8 by 40 cells, 10 times", fields={"cells": [8, 40], "every_s": 0.05}),
    _recorded("fields in 8 by 8 by 20 cells, 10 times", fields={"cells": [8, 8, 20], "every_s": 0.05}),
    _recorded("contact statistics and longest step, 50 times", contact_statistics={"every_s": 0.01}),
    _recorded("50 checkpoints", checkpoint_every_s=0.01),
)  # fmt: skip
