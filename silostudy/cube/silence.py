"""Methods of a cube that give no wall pressure, and why: for tables in the terminal and for figures."""

import numpy as np
import xarray as xr

from silostudy.cube.contract import SCOPE

PRESSURE = "wall_normal_pressure"
DEPTHS = ("depth", "relative_depth")
# flags of the pressures' scope
NOT_COVERED = "phase_not_covered"
OUT_OF_RANGE = "outside_published_range"


def silences(cube: xr.Dataset, *, in_every_case: bool = False, titles: bool = False) -> list[str]:
    """A line for every method and phase that gives no wall pressure in some case, or in every one, with the reasons.

    A phase that a method's source does not treat is told where the method gives nothing in any other.
    titles: methods are called by their title, as in figures, in place of their key.
    """
    lines = []
    for key in map(str, cube["pressure_method"].values):
        of_method = cube.sel(pressure_method=key)
        method = str(of_method["pressure_method_title"].values) if titles else key
        phases = [phase for phase in map(str, cube["phase"].values) if _reasons(of_method.sel(phase=phase)) != [NOT_COVERED]]
        told = [phase for phase in phases if not in_every_case or _silent(of_method.sel(phase=phase)).all()]
        lines += [f"{method}, {phase}: {text}" for phase in told if (text := _silence(of_method.sel(phase=phase)))]
        if not phases:
            lines.append(f"{method}: gives nothing: {', '.join(map(str, cube['phase'].values))} not covered by its source")
    return lines


def _silence(of_method: xr.Dataset) -> str:
    """Words on a method in a phase; empty where it speaks in every case."""
    silent = _silent(of_method)
    if not silent.any():
        return ""
    count = f" in {int(silent.sum())} of {silent.size} cases" if silent.ndim else ""
    limits = _limits(of_method, silent)
    broken = [f"out of its range, which is {', '.join(limits)}"] if limits else []
    reasons = [reason.replace("_", " ") for reason in _reasons(of_method) if not (limits and reason == OUT_OF_RANGE)]
    return f"gives nothing{count}: {'; '.join([*reasons, *broken])}"


def _silent(state: xr.Dataset) -> xr.DataArray:
    return state[PRESSURE].isnull().all([dim for dim in DEPTHS if dim in state[PRESSURE].dims])


def _reasons(state: xr.Dataset) -> list[str]:
    """Flags of the cases in which a method is silent."""
    flags = state[PRESSURE + SCOPE]
    here = flags.values[np.broadcast_to(_silent(state).values[..., None], flags.shape)]
    return [flags.attrs["flag_meanings"].split()[flag] for flag in np.unique(here)]


def _limits(state: xr.Dataset, silent: xr.DataArray) -> list[str]:
    """The limits that these cases break, in words."""
    numbers = np.unique(state["limit_broken"].values[silent.values])
    phase = f"{state['phase'].values}: "  # a line of its own names it
    return [str(state["limit"].values[number]).removeprefix(phase) for number in numbers if number > 0]


def reason(cube: xr.Dataset, name: str, method: str, phase: str) -> str:
    """Reason, in words, why a variable of a method is masked in a phase: the first of all its masked values."""
    flags = cube[name + SCOPE].sel(pressure_method=method, phase=phase)
    meanings = flags.attrs["flag_meanings"].split()
    return meanings[int(flags.where(flags > 0).min())].replace("_", " ")
