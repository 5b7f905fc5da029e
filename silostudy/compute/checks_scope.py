"""Scope of the checks: which are made in which combination, why the others are not, and the largest of the results."""

from collections.abc import Mapping, Sequence

import numpy as np

from silostudy.checks import CHECKS
from silostudy.checks.family import GIVEN_BY, IN_SCOPE, NO_LOAD, OTHER_COMBINATION, OUT_OF_RANGE, REASONS, SteelCheck
from silostudy.tables.combinations import Combination


def rows_of(study, part: str) -> list[SteelCheck]:
    """The checks of a part that a study makes: those of one source only where it names them."""
    return [row for row in CHECKS.values() if row.part == part and (not row.one_source or row.key in study.checks.one_source)]


def acts(row: SteelCheck, combination: Combination) -> bool:
    """Whether a combination gives a check anything to look at."""
    idle = bool(row.idle_with) and row.idle_with <= combination.actions
    return not idle and (not row.acts_in or bool(row.acts_in & combination.actions))


def scope(row: SteelCheck, parameters: Mapping, combinations: Sequence[Combination], lacks, shape) -> np.ndarray:
    """Flag of REASONS of a check in every combination (first axis); lacks: flags by combination and case."""
    idle = np.array([not acts(row, combination) for combination in combinations]).reshape(-1, *[1] * (len(shape) - 1))
    missing = {name: np.isnan(np.asarray(parameters[name], dtype=float)) for name in sorted(row.needs)}
    # of what a study gives all is missing, or a method says nothing somewhere
    absent = [name for name, where in missing.items() if name in GIVEN_BY and where.all()]
    conditions = [lacks > 0, idle, *(missing[name] for name in absent), *missing.values()]
    reasons = [lacks, OTHER_COMBINATION, *(REASONS.index(f"needs_{GIVEN_BY[name]}") for name in absent)]
    reasons += [NO_LOAD] * len(missing)
    conditions += [limit.broken(None, parameters) for limit in row.bounds]
    reasons += [OUT_OF_RANGE] * len(row.bounds)
    conditions, reasons = ([np.broadcast_to(part, shape) for part in many] for many in (conditions, reasons))
    return np.select(conditions, reasons, IN_SCOPE).astype(np.int8)


def judged(values: np.ndarray, flags: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Values, NaN where masked, and flags, out of range where a value is none."""
    flags = np.where((flags == IN_SCOPE) & np.isnan(values), OUT_OF_RANGE, flags).astype(np.int8)
    return np.where(flags == IN_SCOPE, values, np.nan), flags


def largest(values: np.ndarray) -> tuple[np.ndarray, np.ndarray]:
    """Largest value over the first axis and its position there; NaN and 0 where all are masked."""
    place = np.argmax(np.where(np.isnan(values), -np.inf, values), axis=0)
    return np.take_along_axis(values, place[None], axis=0)[0], place.astype(np.int8)


def combined(buckling: np.ndarray, checked: np.ndarray, unjudged: np.ndarray) -> tuple[np.ndarray, np.ndarray, np.ndarray]:
    """Largest by rule, its check (0: buckling) and its combination, each (rule, method, axes..., place).

    buckling: (rule, combination, method, ...); checked: (check, combination, method, ...); unjudged: where a rule is silent.
    """
    own, when = largest(np.moveaxis(buckling, 1, 0))
    parts = [(own, when)] + [tuple(np.broadcast_to(part, own.shape) for part in largest(of_check)) for of_check in checked]
    values, check = largest(np.array([value for value, _ in parts]))
    combination = np.take_along_axis(np.array([place for _, place in parts]), check[None].astype(int), axis=0)[0]
    values = np.where(unjudged, np.nan, values)
    silent = np.isnan(values)
    return values, np.where(silent, 0, check).astype(np.int8), np.where(silent, 0, combination).astype(np.int8)
