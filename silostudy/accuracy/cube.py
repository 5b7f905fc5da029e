"""The accuracy stage: every problem measured on this machine, and the prices of effects where they are asked for."""

from collections.abc import Callable

import numpy as np
import xarray as xr

from silostudy.accuracy.front import lasting_error, on_front
from silostudy.accuracy.measure import Rung, machine, measure
from silostudy.accuracy.price_table import price_variables
from silostudy.cube.assemble import assemble
from silostudy.scene.expand import Expansion
from silostudy.tables.problems import PROBLEMS


def accuracy_cube(expansion: Expansion, tell: Callable[[str], None] = lambda text: None) -> xr.Dataset:
    """Errors and costs (point) of every problem; attributes say what machine measured them and when."""
    study, asked = expansion.study, expansion.study.scene
    options = {"repeats": asked.repeats, "members": asked.members, "rungs": asked.rungs, "ladders": asked.ladders}
    rungs = {key: measure(key, tell=tell, **options) for key in study.problem_keys}
    points = [point for ladder in rungs.values() for point in points_of(ladder)]
    data: dict = {f"point_{name}": np.array([point[name] for point in points]) for name in points[0]}
    rows = [PROBLEMS[key] for key in study.problem_keys]
    for name in ("title", "group", "setting"):
        data[f"problem_{name}"] = np.array([getattr(row, name) for row in rows])
    data["problem_reference"] = np.array([f"{row.reference_kind}: {row.reference}" for row in rows])
    data["problem"] = np.array(study.problem_keys)
    if asked.prices:
        data |= price_variables(asked.repeats, tell)
    sources = [row.source for row in rows]
    notes = {**machine(), "repeats": asked.repeats, "members": asked.members}
    return assemble(study, "accuracy", data, sources=sources, notes=notes)


def points_of(rungs: list[Rung]) -> list[dict]:
    """One point a rung and quantity, with the front of each quantity marked: by the error that finer settings keep."""
    points = []
    for quantity in rungs[0].error:
        ladders = {rung.ladder: [other.high[quantity] for other in rungs if other.ladder == rung.ladder] for rung in rungs}
        lasting = np.concatenate([lasting_error(errors) for errors in ladders.values()])
        front = on_front([rung.cost for rung in rungs], lasting)
        for rung, lasts, chosen in zip(rungs, lasting, front, strict=True):
            points.append(
                {
                    "problem": rung.problem,
                    "quantity": quantity,
                    "quantity_title": PROBLEMS[rung.problem].quantities[quantity],
                    "ladder": rung.ladder,
                    "setting": float(rung.setting),
                    "error": rung.error[quantity],
                    "error_low": rung.low[quantity],
                    "error_high": rung.high[quantity],
                    "error_kept": float(lasts),
                    "floor": rung.floor[quantity],
                    "cost": rung.cost,
                    "cost_low": min(rung.seconds),
                    "cost_high": max(rung.seconds),
                    "on_front": float(chosen),
                }
            )
    return points
