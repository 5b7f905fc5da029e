"""The list of load cases of every silo of a study as variables of a cube: which are computed, and why not the others."""

import numpy as np

from silostudy.compute.load_cases import LISTED_STATES, load_cases
from silostudy.cube.variables import flags
from silostudy.scene.expand import Expansion
from silostudy.tables.load_cases import LOAD_CASES


def listed_variables(expansion: Expansion) -> dict:
    """State and reason of every load case, (load_case, axes...); nothing where no method of the study gives any."""
    if not {key for row in LOAD_CASES.values() for key in row.methods} & set(expansion.study.method_keys):
        return {}
    cases = [load_cases(expansion.study, case.scene) for case in expansion.cases]
    states = np.array([[LISTED_STATES.index(case.state) for case in listed] for listed in cases], dtype=np.int8)
    reasons = np.array([[case.why for case in listed] for listed in cases])
    shape = (len(LOAD_CASES), *expansion.shape)
    told = flags("how far the study computes the load case", [state.replace(" ", "_") for state in LISTED_STATES])
    return {
        "load_case": list(LOAD_CASES),
        "load_case_state": (states.T.reshape(shape), told),
        "load_case_reason": reasons.T.reshape(shape),
    }
