"""The effective mass coefficient found again in synthetic responses, over the number of candidates tried."""

import numpy as np

from silostudy.accuracy.problems.beam_frequency import TUBE
from silostudy.seismic import identify
from silostudy.seismic.readers import read_known
from silostudy.seismic.records import Record, compressed, without_baseline

LADDERS = {"even candidates from 0 to 1": (5, 9, 17, 33, 65, 129)}
TRUTHS = np.array([0.2718, 0.4669, 0.5772, 0.6931, 0.8414])  # on no grid of candidates
COMPRESSION = 8.0  # of time: the record runs so many times as fast
SAMPLES = 2500  # of the record that are kept
SEED = 1  # of the noise


def _question(coefficients) -> identify.Question:
    base = compressed(without_baseline(read_known("akt013_1996_ew"), "mean"), COMPRESSION)
    return identify.Question(
        tube=TUBE,
        stiffness_reduction=1.0,
        damping_ratio=0.045,
        base=Record(base.acceleration[:SAMPLES], base.dt, base.origin),
        band=(5.0, 60.0),
        coefficients=np.asarray(coefficients),
        damping_mismatch=0.25,
        frequency_mismatch=0.0,
    )


def prepare(ladder: str, setting: float):
    """The bank of candidates and the answers to all responses."""
    question = _question(np.linspace(0.0, 1.0, int(setting)))
    measured = [identify.transform(question, identify.top_acceleration(question, truth)) for truth in TRUTHS]

    def run():
        bank = identify.bank(question)
        random = np.random.default_rng(SEED)
        return {
            "effective_mass_coefficient": np.array([identify.estimate(bank, record, random).coefficient for record in measured])
        }

    return run


def reference():
    """The coefficients that made the responses."""
    return {"effective_mass_coefficient": TRUTHS}
