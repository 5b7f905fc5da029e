"""Optional parts of the stages besides discrete elements, and what each adds: the same study with the part and without it."""

import copy
import time
import tracemalloc
from collections.abc import Callable
from dataclasses import dataclass
from pathlib import Path

from threadpoolctl import threadpool_limits

from silostudy.accuracy.prices import Price, price
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.seismic import seismic_cube
from silostudy.compute.uncertainty import uncertainty_cube
from silostudy.scene.expand import expand

SILO = {
    "plan": "circular",
    "diameter_m": 5.0,
    "cylinder_depth_m": 12.0,
    "hopper": {"half_angle_deg": 18.0, "outlet_width_m": 0.8},
}
PROPERTIES = {"hopper_wall_friction": 0.30, "effective_friction_angle_deg": 40.0, "poisson_ratio": 0.4}
PRESSURE = {
    "kind": "pressure",
    "title": "a bin to price the parts of a pressure study",
    "scene": {"silo": SILO, "solid": "wheat_e1", "wall": "d2", "properties": PROPERTIES},
    "methods": ["janssen", "jenike_1969", "jenike_mass_flow", "en1991_4"],
    "phases": ["filling", "switch", "discharge"],
    "depth_m": {"start": 0.0, "stop": 12.0, "count": 97},
}
SEISMIC: dict = {
    "kind": "seismic",
    "title": "a tube to price the parts of a seismic study",
    "scene": {
        "silo": {"mid_wall_radius_m": 0.25, "wall_thickness_mm": 15.0, "height_m": 1.08},
        "wall": {"density_kg_m3": 2350.0, "youngs_modulus_GPa": 25.0, "poisson_ratio": 0.2},
        "contents": {"density_kg_m3": 790.0},
        "empty_frequency_Hz": 35.5,
        "damping_ratio": 0.02,
        "motion": {"record": "akt013_1996_ew", "time_compression": 8.0, "peak_acceleration_gal": 99.0},
        "measured": {"imitation": {"effective_mass_coefficient": 0.7, "damping_ratio": 0.023, "noise_ratio": 0.2}},
    },
    "relative_depth": {"start": 0.0, "stop": 1.0, "count": 25},
}
SINE = {
    "empty_frequency_Hz": 33.0, "full_frequency_Hz": 19.0, "rounding_Hz": 0.5, "damping_ratio": 0.02,
    "base_acceleration_gal": 20.0, "frequency_Hz": {"start": 5.0, "stop": 45.0, "count": 101},
}  # fmt: skip
IDENTIFICATION = {
    "coefficients": {"start": 0.5, "stop": 1.0, "count": 6},
    "refinement": 10,
    "shown_coefficients": [1.0, 0.7],
    "band_Hz": [5.0, 60.0],
    "damping_mismatch": 0.25,
    "empty_frequency_rounding_Hz": 0.05,
    "recovery_noise_ratio": 0.2,
    "recovery_trials": 100,
}
WITH_IDENTIFICATION = SEISMIC | {"identification": IDENTIFICATION}
UNMEASURED = {"scene": {name: value for name, value in SEISMIC["scene"].items() if name != "measured"}}
POSITIONS = {"start": 0.0, "stop": 1.0, "count": 81}


@dataclass(frozen=True)
class Part:
    """A part of a study: contents with it and without it, and the functions that make the cubes of each."""

    name: str
    room: str
    whole: dict
    less: dict
    making: tuple[Callable, ...]
    making_less: tuple[Callable, ...]


def _part(name: str, room: str, whole: dict, less: dict, make: Callable, *further: Callable) -> Part:
    return Part(name, room, whole, less, (make, *further), (make,))


PARTS = (
    _part("hopper walls", "pressures", PRESSURE | {"hopper_position": POSITIONS}, PRESSURE, pressure_cube),
    _part("scatter of the solid", "pressures", PRESSURE | {"uncertainty": {}}, PRESSURE, pressure_cube, uncertainty_cube),
    _part("identification", "earthquake", WITH_IDENTIFICATION, SEISMIC | UNMEASURED, seismic_cube),
    _part(
        "recovery test, 100 trials", "earthquake", WITH_IDENTIFICATION,
        SEISMIC | {"identification": IDENTIFICATION | {"recovery_trials": 2}}, seismic_cube,
    ),
    _part("sine sweep", "earthquake", SEISMIC | UNMEASURED | {"sine": SINE}, SEISMIC | UNMEASURED, seismic_cube),
)  # fmt: skip


@threadpool_limits.wrap(limits=1)
def part_price(part: Part, turns: int) -> Price:
    """Share of CPU time and of the largest memory that goes without the part; readings in turn."""
    whole, less = _making(part.whole, part.making), _making(part.less, part.making_less)
    memory = 1.0 - _memory(less) / _memory(whole)
    readings: tuple[list[float], list[float]] = ([], [])
    for _ in range(turns):
        for make, found in zip((whole, less), readings, strict=True):
            start = time.process_time()
            make()
            found.append(time.process_time() - start)
    return price(*readings, memory)


def _making(content: dict, functions: tuple[Callable, ...]) -> Callable[[], None]:
    expansion = expand(copy.deepcopy(content), "part", "part", Path())

    def make() -> None:
        for function in functions:
            function(expansion)

    return make


def _memory(make: Callable[[], None]) -> int:
    """Largest memory (bytes) that is held at once beyond what was held before."""
    make()  # what is kept for good is kept before
    tracemalloc.start()
    make()
    _, most = tracemalloc.get_traced_memory()
    tracemalloc.stop()
    return most
