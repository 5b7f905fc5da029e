"""Shipped studies with less of what takes long, to draw every output from."""

import copy
from functools import cache

from silostudy.choice.expand import expand
from silostudy.config.load import read_yaml
from silostudy.scene.expand import Expansion
from tests.conftest import ROOT

# in place of the laboratory's row, which is made by a run of the whole pipeline
ROUND = {"plan": "circular", "diameter_m": 0.1, "cylinder_depth_m": 0.1}
MADE_UP = {
    "solid": "wheat_e1",
    "properties": {"unit_weight_kN_m3": 7.85, "wall_friction": 0.4, "lateral_pressure_ratio": 0.5},
}
STUDIES = ROOT / "config/studies"
# what is changed of a shipped study so that its cube takes no time; a study not named here is computed as it ships
SMALLER: dict[str, dict] = {
    "accuracy": {
        "scene": {
            "problems": ["dem_impact", "depth_levels", "shell_thickness", "history", "beam_frequency"],
            "repeats": 1,
            "members": 3,
            "rungs": 3,
            "prices": True,
        }
    },
    "grains-amplitude": {
        "scene": {
            "box": {"slenderness": 0.5},
            "packing": "rows_17_18",
            "wall_friction": 0.176,
            "shaking": {"amplitude_gal": 100.0, "frequency_Hz": 4.0},
        },
        "sweep": [
            {"axis": "packing", "values": {"packing": ["rows_17_18"]}},
            {"axis": "amplitude", "values": {"shaking.amplitude_gal": [100.0, 300.0]}},
        ],
        "fillings": 2,
        "cycles": 1,
        "waited_cycles": 0,
    },
    "kiyama-1983": {
        "sweep": [
            {"axis": "packing", "values": {"across": [12, 18]}},
            {"axis": "removal", "values": {"remedy": [False, True]}},
        ],
        "scene": {"across": 18, "disc_count": 200},
        "runs": 2,
        "discharge_s": 0.6,
        "stopped_s": 0.1,
        "rest_limit_s": 1.5,
        "detailed": [{"across": 18, "run": 0}],
    },
    "kiyama-1983-slit": {
        "sweep": [
            {"axis": "packing", "values": {"across": [12]}},
            {"axis": "slit", "values": {"silo.slit_width_m": [0.06, 0.1, 0.14]}},
        ],
        "scene": {"across": 18, "disc_count": 200},
        "runs": 1,
        "discharge_s": 0.6,
        "stopped_s": 0.1,
        "rest_limit_s": 1.5,
    },
    "sasaki-1991": {
        "identification": {
            "coefficients": {"start": 0.5, "stop": 1.0, "count": 11},
            "refinement": 2,
            "recovery_trials": 3,
            "shown_coefficients": [1.0, 0.75, 0.7, 0.6],
            "band_Hz": [5.0, 60.0],
            "damping_mismatch": 0.25,
            "empty_frequency_rounding_Hz": 0.05,
            "recovery_noise_ratio": 0.2,
        },
    },
    "stability-map": {
        "sweep": [
            {"axis": "network", "values": {"network": ["column"]}},
            {"axis": "damping", "values": {"discs.damping_ratio": [0.1, 1.0]}},
            {
                "axis": "march",
                "points": [
                    {"integrator": "17-18", "discs.normal": "spring-dashpot", "discs.tangential": "spring-slider"},
                    {"integrator": "17-19", "discs.normal": "spring-dashpot", "discs.tangential": "spring-slider"},
                ],
            },
        ],
        "silo": {"steps_ms": [0.04, 0.05], "reference_step_ms": 0.025, "fillings": 2, "rest_s": 0.4, "parts": 4},
        "trial_steps": 1000,
        "peer": False,
    },
    "silo-of-spheres": {},  # shown for all sweeps of silos beside codes
    "silo-of-spheres-codes": {
        "materials": None,
        "scene": MADE_UP | {"silo": ROUND | {"hopper": {"half_angle_deg": 20, "outlet_width_m": 0.05}}},
    },
    "silo-of-spheres-eccentric-codes": {
        "materials": None,
        "scene": MADE_UP | {"silo": ROUND | {"cylinder_depth_m": 0.2, "action_assessment_class": 3}},
    },
    "wheat-silo-today": {"uncertainty": {"log2_samples": 6, "seed": 1}},
}


@cache
def study_of(output: str) -> str:
    """Name of the first shipped study that asks for an output, of those made small where there are some."""
    studies = sorted((path.stem for path in STUDIES.glob("*.yaml")), key=lambda name: (name not in SMALLER, name))
    return next(name for name in studies if output in (read_yaml(STUDIES / f"{name}.yaml").get("outputs") or ()))


@cache
def expansion_of(study: str) -> Expansion:
    """The cases of a shipped study, made small."""
    content = copy.deepcopy(read_yaml(STUDIES / f"{study}.yaml")) | copy.deepcopy(SMALLER.get(study, {}))
    return expand(content, study, f"{study}.yaml", STUDIES)
