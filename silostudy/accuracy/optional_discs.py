"""Optional parts of discrete-element scenes and of studies of discs, each of a small scene of its own.

Laws, wall forces, energy balance and shaking are priced as effects of the engine; here is what else may be asked for.
"""

from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory

from silostudy.accuracy.optional_parts import OptionalPart, Work, ready
from silostudy.accuracy.optional_scenes import changing_steps, look, ran
from silostudy.accuracy.profile import profile_cube
from silostudy.accuracy.stability import stability_cube
from silostudy.compute.dem_cube import cube_of
from silostudy.compute.grains import grains_cube
from silostudy.compute.motion import motion_cube
from silostudy.compute.packing import packing_cube
from silostudy.compute.paraview import export
from silostudy.tables.kiyama_1983 import DENSITY, DISC_FRICTION, NORMAL_STIFFNESS, RADIUS, SLIT_WIDTH, WALL_FRICTION

CONTACT = {"normal_stiffness_N_m2": NORMAL_STIFFNESS, "damping_ratio": 0.7, "sliding_friction": DISC_FRICTION}
SCENE: dict = {
    "kind": "dem",
    "title": "a silo of discs to price what is recorded of it",
    "silo": {"width_m": 0.2, "height_m": 0.4, "slit_width_m": SLIT_WIDTH},
    "packing": {"kind": "rows", "across": 9, "fill_height_m": 0.3, "gap_m": 1e-4, "offset_m": 2e-5},
    "radius_m": RADIUS,
    "density_kg_m3": DENSITY,
    "discs": CONTACT,
    "march": {"limit_s": 0.5},
    "events": [{"when": "time", "value": 0.25, "do": "open_slit"}, {"when": "time", "value": 0.5, "do": "stop"}],
}
ROOM = "scenes and studies of discs"
TIMES = [0.01 * k for k in range(1, 50)]  # s
GRAINS: dict = {
    "kind": "grains",
    "title": "a box of discs to price the parts of a grains study",
    "scene": {
        "box": {"width_m": 0.2, "slenderness": 0.5},
        "packing": "loose",
        "wall_friction": WALL_FRICTION,
        "shaking": {"amplitude_gal": 100.0, "frequency_Hz": 10.0},
    },
    "fillings": 1,
    "cycles": 3,
    "rest_limit_s": 0.5,
}
PACKING: dict = {
    "kind": "packing",
    "title": "a small silo to price the parts of a packing study",
    "scene": {"silo": {"width_m": 0.2, "slit_width_m": 0.03}, "across": 9, "disc_count": 140},
    "runs": 3,
    "discharge_s": 0.6,
    "rest_limit_s": 0.5,
}
REMEDY = PACKING | {"scene": PACKING["scene"] | {"remedy": True}}
STABILITY: dict = {
    "kind": "stability",
    "title": "one disc to price the parts of a stability study",
    "scene": {"network": "disc", "radius_m": RADIUS, "density_kg_m3": DENSITY, "discs": CONTACT},
}
SILO = {"steps_ms": [0.05], "reference_step_ms": 0.025, "fillings": 2, "rest_s": 0.5}


def recorded(then: Callable = cube_of, **record) -> Callable[[], Work]:
    """Makes ready a run of the scene that records what is named, into a cube or whatever `then` makes of (run, scene)."""
    return ran(SCENE | {"record": record}, then)


def _exported(run, scene) -> None:
    cube_of(run, scene)
    with TemporaryDirectory() as folder:
        export(run, Path(folder))


SCENES = (
    look("disc", ROOM),
    *changing_steps(SCENE, ROOM),
    OptionalPart("49 snapshots", ROOM, recorded(snapshots_s=TIMES), recorded()),
    OptionalPart(
        "49 snapshots also for ParaView",
        ROOM,
        recorded(_exported, snapshots_s=TIMES, paraview=True),
        recorded(snapshots_s=TIMES),
    ),
    OptionalPart(
        "fields in 10 by 20 cells, 50 times",
        ROOM,
        recorded(fields={"cells": (10, 20), "every_s": 0.01}),
        recorded(),
    ),
    OptionalPart("50 checkpoints", ROOM, recorded(checkpoint_every_s=0.01), recorded()),
)
PARTS = (
    *SCENES,
    OptionalPart(
        "shaken discs: 3 cycles waited for", ROOM,
        ready(GRAINS, grains_cube), ready(GRAINS | {"waited_cycles": 0}, grains_cube),
    ),
    OptionalPart("remedy: a disc out of every arch", ROOM, ready(REMEDY, packing_cube), ready(PACKING, packing_cube)),
    OptionalPart(
        "one run of four kept frame by frame", ROOM,
        ready(PACKING | {"detailed": [{"across": 9, "run": 1}]}, packing_cube, motion_cube), ready(PACKING, packing_cube),
    ),
    OptionalPart(
        "silo beside the stability map", ROOM,
        ready(STABILITY | {"silo": SILO}, stability_cube, profile_cube), ready(STABILITY, stability_cube),
    ),
)  # fmt: skip
