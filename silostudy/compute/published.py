"""Results of a filling of a published case, in tolerances off the published numbers."""

from typing import Any

import numpy as np

from silostudy.compute.dem import carry_through, run_of, scene_model
from silostudy.compute.expected import Verdict, verdicts
from silostudy.config.published import PublishedStudy
from silostudy.scene.published import PublishedCase
from silostudy.tables.published_cases import published_numbers, published_of

Numbers = dict[str, np.ndarray]


def coordinates(study: PublishedStudy) -> dict[str, Any]:
    """The dimension that a case's numbers have of their own: as many as any case of the table has."""
    return {"expectation": np.arange(_most())}


def sources(study: PublishedStudy) -> list[str]:
    """References of the published numbers."""
    return sorted({number.source for case in study.cases for number in published_of(case)})


def measure(study: PublishedStudy, case: PublishedCase) -> Numbers:
    """The numbers of one filling, by the names of the contract; Explosion or BadInput where it cannot be computed."""
    scene = case.config
    run = run_of(scene, scene_model(scene, case.folder))
    carry_through(run, scene, None, lambda step: None)
    if run.recording.explosion is not None:
        raise run.recording.explosion
    return misses(verdicts(run, scene)) | {"end_time": np.array(run.engine.time)}


def misses(verdicts: list[Verdict]) -> Numbers:
    """Deviation of each quantity from the published number, in tolerances; missing beyond the case's own."""
    off = np.full(_most(), np.nan)
    off[: len(verdicts)] = [(verdict.computed - verdict.value) / verdict.tolerance for verdict in verdicts]
    return {"off_published": off}


def _most() -> int:
    """Most numbers that a case of the table has."""
    return max(len(published_of(number.case)) for number in published_numbers())
