"""The fronts of seismic studies: candidates for the effective mass coefficient, levels that a bending moment is read between.

References: the coefficient that made the response; the moment at the heights themselves.
"""

from collections.abc import Callable, Iterator
from dataclasses import dataclass, replace
from functools import partial

import numpy as np

from silostudy.accuracy.trial import Trial, cpu_seconds, front_row
from silostudy.choice.choose import choose
from silostudy.choice.seismic import valley_number
from silostudy.config.seismic import Identification
from silostudy.seismic import identify
from silostudy.seismic.beam import Tube
from silostudy.seismic.demand import demand
from silostudy.seismic.readers import read_known
from silostudy.seismic.records import Record, compressed, without_baseline

REFINEMENTS = (1, 2, 3, 4, 6, 8, 12, 24)  # all divide the last
LEVELS = (3, 4, 5, 6, 7, 9, 11, 13, 16, 17, 21, 25, 31, 41, 49, 61, 81, 121, 161, 241)  # one less divides the finest less one
FINEST = 961
COARSE = 11  # candidates before refinement
TRUTHS = 20  # right values within a step of a candidate
AROUND = 3  # steps of candidates beside that one
TRIALS = Identification.model_fields["recovery_trials"].default  # of the recovery test that goes with an identification
FEW_TRIALS = 5  # of them are timed
NOISE = 0.1  # of their responses, over their rms
MEASURED = 40  # scenes for the coefficient
MOVED = 200  # scenes for the moment
UNSEEN = 60  # other scenes
SHARE = 0.95  # of the truths that must meet it
KEPT = 0.97  # share of the scenes that keep a row's error of the moment
PERIODS = 30  # of the empty tube: length of the base motion
PER_PERIOD = 25  # samples of the base motion in one of them
ASKED = {"effective_mass_coefficient": (1e-4, 1e-2), "wall_bending_moment": (4e-3, 0.1)}  # errors asked for lie between
SOURCE = "sasaki_yoshimura_effective_mass"


@dataclass(frozen=True)
class ShakenTube:
    """A tube, its damping, its base motion, the candidates for its coefficient before they are refined, and the truth."""

    question: identify.Question
    truth: float

    @property
    def step(self) -> float:
        """Step of the candidates before refinement."""
        return float(np.diff(self.question.coefficients)[0])

    @property
    def number(self) -> float:
        """The trait that the coefficient's error goes with."""
        return valley_number(self.question.tube, self.question.damping_ratio, self.step, self.truth)


def shakings(seed: int, count: int, widest: float, least: float) -> Iterator[ShakenTube]:
    """Tubes of many sizes, every second one under the record at hand, the others under noise; other seeds give others.

    widest: half of the candidates' range; least: damping ratio.
    """
    random = np.random.default_rng(seed)
    for number in range(count):
        tube = _tube(random)
        first = identify.emptied(tube)
        middle, half = random.uniform(0.45, 0.8), random.uniform(0.1, widest)
        question = identify.Question(
            tube=tube, stiffness_reduction=1.0, damping_ratio=random.uniform(least, 0.08),
            base=_noise(first, random) if number % 2 else _record(first), band=(0.1 * first, 2.0 * first),
            coefficients=np.linspace(middle - half, middle + half, COARSE), damping_mismatch=0.0, frequency_mismatch=0.0,
        )  # fmt: skip
        yield ShakenTube(question, random.uniform(middle - 0.5 * half, middle + 0.5 * half))


def _tube(random: np.random.Generator) -> Tube:
    radius = float(np.exp(random.uniform(np.log(0.2), np.log(5.0))))
    height = radius * random.uniform(2.0, 8.0)
    return Tube(
        radius=radius, thickness=radius * float(np.exp(random.uniform(np.log(2e-3), np.log(0.05)))), height=height,
        fill_height=height, wall_density=random.uniform(2000.0, 8000.0), youngs_modulus=random.uniform(2e10, 2e11),
        poisson_ratio=0.25, shear_factor=0.5, contents_density=random.uniform(500.0, 1500.0),
    )  # fmt: skip


def _record(first: float) -> Record:
    """The record at hand, as fast as the tube's first frequency (Hz) asks."""
    record = without_baseline(read_known("akt013_1996_ew"), "mean")
    fast = compressed(record, PER_PERIOD * first * record.dt)
    start = int(np.argmax(np.abs(fast.acceleration))) // 2
    return Record(fast.acceleration[start : start + PERIODS * PER_PERIOD], fast.dt, fast.origin)


def _noise(first: float, random: np.random.Generator) -> Record:
    samples = random.standard_normal(PERIODS * PER_PERIOD)
    return Record(samples * np.hanning(samples.size), 1.0 / (PER_PERIOD * first), "noise")


def coefficient_errors(shaking: ShakenTube) -> np.ndarray:
    """Relative error of the coefficient with every refinement, wherever within a step the truth lies: (refinement, truth)."""
    question, finest = shaking.question, REFINEMENTS[-1]
    start, step = question.coefficients[0], shaking.step
    cell = int((shaking.truth - start) / step)
    first, last = max(0, cell - AROUND), min(COARSE - 1, cell + 1 + AROUND)
    candidates = start + step * np.arange(first * finest, last * finest + 1) / finest
    known = _spectra(question, candidates)
    truths = start + step * (cell + np.arange(TRUTHS) * 0.618034 % 1.0)
    responses, steps = _spectra(question, truths), [finest // refinement for refinement in REFINEMENTS]
    answers = [[identify.between(known[::k], response, candidates[::k]) for response in responses] for k in steps]
    return np.abs(np.array(answers) / truths - 1.0)


def _spectra(question: identify.Question, coefficients) -> np.ndarray:
    return np.array([identify.transform(question, identify.top_acceleration(question, value)) for value in coefficients])


def moment_errors(shaking: ShakenTube) -> np.ndarray:
    """Largest error of the moment read between every number of levels, over its largest value."""
    depth = np.linspace(0.0, 1.0, FINEST)
    right = _moment(shaking, depth)
    every = [(FINEST - 1) // (levels - 1) for levels in LEVELS]
    return np.array([np.abs(np.interp(depth, depth[::k], right[::k]) - right).max() / right.max() for k in every])


def _moment(shaking: ShakenTube, depth: np.ndarray) -> np.ndarray:
    """Largest bending moment (N m) at depths over the height."""
    tube, question = shaking.question.tube, shaking.question
    return demand(tube, 1.0, shaking.truth, question.damping_ratio, question.base, (1.0 - depth) * tube.height).bending_moment


def coefficient_costs(shaking: ShakenTube) -> np.ndarray:
    """CPU seconds of an identification with every refinement: so many candidates, and the trials of its recovery test."""
    question, random = shaking.question, np.random.default_rng(0)
    few = replace(question, coefficients=question.coefficients[:2])
    candidate = cpu_seconds(partial(identify.bank, few)) / few.coefficients.size
    recovery = partial(identify.recovery, identify.bank(question), FEW_TRIALS, NOISE, random)
    return candidate * ((COARSE - 1) * np.array(REFINEMENTS) + 1) + TRIALS / FEW_TRIALS * cpu_seconds(recovery)


def moment_costs(shaking: ShakenTube) -> np.ndarray:
    """CPU seconds of every number of levels; more levels never cost less, what says otherwise is noise."""
    return np.maximum.accumulate([cpu_seconds(partial(_moment, shaking, np.linspace(0.0, 1.0, count))) for count in LEVELS])


def measured_fronts(tell: Callable[[str], None]) -> list[dict]:
    """Rows of tables/fronts.csv: what all but a few of the truths keep, and of the moments."""
    shaken = list(shakings(0, MEASURED, 0.4, 0.008))
    over = np.quantile(np.hstack([coefficient_errors(shaking) / shaking.number for shaking in shaken]), SHARE, axis=1)
    tell(f"effective_mass_coefficient: {MEASURED} scenes, {TRUTHS} truths each")
    spent = coefficient_costs(shaken[0])
    within = {"valley_number": (0.0, float(f"{1.05 * max(shaking.number for shaking in shaken):.2g}"))}
    rows = [
        front_row("seismic", "effective_mass_coefficient", {"identification.refinement": refinement}, over[k], spent[k],
                  MEASURED * TRUTHS, SOURCE, scaled_by="valley_number", within=within)
        for k, refinement in enumerate(REFINEMENTS)
    ]  # fmt: skip
    lasting = np.quantile([moment_errors(shaking) for shaking in shakings(0, MOVED, 0.4, 0.008)], KEPT, axis=0)
    tell(f"wall_bending_moment: {MOVED} scenes")
    spent = moment_costs(shaken[0])
    return rows + [
        front_row("seismic", "wall_bending_moment", {"relative_depth": {"start": 0.0, "stop": 1.0, "count": count}},
                  lasting[k], spent[k], MOVED, SOURCE)
        for k, count in enumerate(LEVELS)
    ]  # fmt: skip


def trials(tell: Callable[[str], None], count: int = UNSEEN) -> list[Trial]:
    """Other tubes and motions; a refinement would have met it with which 19 of 20 truths do."""
    shaken, random = list(shakings(1, count, 0.3, 0.015)), np.random.default_rng(2)
    tried = [trial for shaking in shaken for trial in coefficient_trials(shaking, random)]
    tried += [moment_trial(shaking, random) for shaking in shaken]
    tell(f"seismic: {sum(trial.met for trial in tried)} of {len(tried)} met")
    return tried


def coefficient_trials(shaking: ShakenTube, random: np.random.Generator) -> list[Trial]:
    """One for each truth."""
    name = "effective_mass_coefficient"
    asked = float(np.exp(random.uniform(*np.log(ASKED[name]))))
    chosen = choose(["seismic"], {name: asked}, [{"valley_number": shaking.number}]).settings["identification.refinement"]
    wrong, spent = coefficient_errors(shaking), coefficient_costs(shaking)
    k, enough = REFINEMENTS.index(chosen), int(np.argmax(np.quantile(wrong, SHARE, axis=1) <= asked))
    return [Trial("seismic", name, asked, error, spent[k], spent[enough], chosen, REFINEMENTS[enough]) for error in wrong[k]]


def moment_trial(shaking: ShakenTube, random: np.random.Generator) -> Trial:
    """The moment read between the levels chosen."""
    name = "wall_bending_moment"
    asked = float(np.exp(random.uniform(*np.log(ASKED[name]))))
    chosen = choose(["seismic"], {name: asked}).settings["relative_depth"]["count"]
    wrong, spent = moment_errors(shaking), moment_costs(shaking)
    k, enough = LEVELS.index(chosen), int(np.argmax(wrong <= asked))
    return Trial("seismic", name, asked, wrong[k], spent[k], spent[enough], chosen, LEVELS[enough])
