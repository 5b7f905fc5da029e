"""Optional parts of pressure, shell, buckling and seismic studies, each of a small study of its own."""

from pathlib import Path
from tempfile import TemporaryDirectory

import yaml

from silostudy.accuracy.optional_parts import OptionalPart, Work, ready
from silostudy.choice.expand import expand, expand_file
from silostudy.compute.buckling import buckling_cube
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.seismic import seismic_cube
from silostudy.compute.shell import shell_cube
from silostudy.compute.uncertainty import uncertainty_cube
from silostudy.pressure import jenike_mass_flow

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
    "refinement": 3,
    "shown_coefficients": [1.0, 0.7],
    "band_Hz": [5.0, 60.0],
    "damping_mismatch": 0.25,
    "empty_frequency_rounding_Hz": 0.05,
    "recovery_noise_ratio": 0.2,
    "recovery_trials": 50,
}
WITH_IDENTIFICATION = SEISMIC | {"identification": IDENTIFICATION}
UNMEASURED = {"scene": {name: value for name, value in SEISMIC["scene"].items() if name != "measured"}}
POSITIONS = {"start": 0.0, "stop": 1.0, "count": 81}
SHELL: dict = {
    "kind": "shell",
    "title": "a steel silo to price the parts of a shell study",
    "scene": {
        "silo": {"plan": "circular", "diameter_m": 10.0, "cylinder_depth_m": 20.0},
        "solid": "wheat_e1",
        "wall": "d2",
        "shell": {"yield_stress_MPa": 235.0, "quality": "B", "manufacture": "fabricated", "safety_factor": 1.65},
    },
    "methods": ["janssen", "caquot", "din1055_1964"],
    "rules": ["miller1977", "en1993_1_6_2025", "en1993_4_1_2025"],
    "depth_m": {"start": 0.0, "stop": 20.0, "count": 161},
}
STRAKES = [{"down_to": 0.5, "thickness_mm": 6.0}, {"down_to": 1.0, "thickness_mm": 9.0}]
WITH_STRAKES = SHELL | {"scene": SHELL["scene"] | {"shell": SHELL["scene"]["shell"] | {"strakes": STRAKES}}}
QUAKE: dict = {
    "kind": "seismic",
    "title": "the earthquake of the steel silo",
    "scene": {
        "silo": {"mid_wall_radius_m": 5.00375, "wall_thickness_mm": 7.5, "height_m": 20.0},
        "wall": {"density_kg_m3": 7850.0, "youngs_modulus_GPa": 210.0, "poisson_ratio": 0.3},
        "contents": {"density_kg_m3": 917.74},
        "damping_ratio": 0.05,
        "motion": {"record": "akt013_1996_ew", "peak_acceleration_gal": 200.0},
    },
    "relative_depth": {"start": 0.0, "stop": 1.0, "count": 101},
}
BUCKLING: dict = {
    "kind": "buckling",
    "title": "cylinders to price the parts of a buckling study",
    "scene": {
        "radius_m": 5.0, "radius_over_thickness": 500.0, "relative_bay_length": 20.0, "yield_stress_MPa": 235.0,
        "quality": "B", "manufacture": "fabricated",
    },
    "sweep": [{
        "axis": "radius_over_thickness",
        "values": {"radius_over_thickness": {"start": 100.0, "stop": 3000.0, "count": 301, "spacing": "log"}},
    }],
    "rules": ["miller1977", "en1993_1_6_2007", "en1993_1_6_2025"],
}  # fmt: skip


def _shells(expansion) -> None:
    shell_cube(expansion, pressure_cube(expansion))


def _shaken_shells() -> Work:
    """The shell study with its earthquake, whose seismic study is computed too."""
    content = WITH_STRAKES | {"earthquake": {"study": "quake"}}
    with TemporaryDirectory() as folder:
        beside = Path(folder, "quake.yaml")
        beside.write_text(yaml.safe_dump(QUAKE))
        expansion, quake = expand(content, "part", "part", Path(folder)), expand_file(beside)
    return lambda: shell_cube(expansion, pressure_cube(expansion), seismic_cube(quake))


PARTS = (
    OptionalPart(
        "hopper walls", "pressures",
        ready(PRESSURE | {"hopper_position": POSITIONS}, pressure_cube), ready(PRESSURE, pressure_cube),
    ),
    OptionalPart(
        "a method as printed", "pressures",
        ready(PRESSURE | {"as_printed": [jenike_mass_flow.ROW.key]}, pressure_cube), ready(PRESSURE, pressure_cube),
    ),
    OptionalPart(
        "scatter of the solid", "pressures",
        ready(PRESSURE | {"uncertainty": {}}, pressure_cube, uncertainty_cube), ready(PRESSURE, pressure_cube),
    ),
    OptionalPart("strakes and their utilisation", "shells", ready(WITH_STRAKES, _shells), ready(SHELL, _shells)),
    OptionalPart("earthquake, with its seismic study", "shells", _shaken_shells, ready(WITH_STRAKES, _shells)),
    OptionalPart(
        "rival readings", "shells", ready(BUCKLING | {"rivals": "all"}, buckling_cube), ready(BUCKLING, buckling_cube),
    ),
    OptionalPart(
        "sine sweep", "earthquake",
        ready(SEISMIC | UNMEASURED | {"sine": SINE}, seismic_cube), ready(SEISMIC | UNMEASURED, seismic_cube),
    ),
    OptionalPart(
        "identification",
        "earthquake",
        ready(WITH_IDENTIFICATION, seismic_cube),
        ready(SEISMIC | UNMEASURED, seismic_cube),
    ),
    OptionalPart(
        "recovery test, 50 trials", "earthquake", ready(WITH_IDENTIFICATION, seismic_cube),
        ready(SEISMIC | {"identification": IDENTIFICATION | {"recovery_trials": 2}}, seismic_cube),
    ),
)  # fmt: skip
