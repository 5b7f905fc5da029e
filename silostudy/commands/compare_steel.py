"""The tables that `silostudy compare` prints of shell, buckling and seismic studies: what the study's last stage gives."""

from math import isnan
from pkgutil import resolve_name
from typing import TYPE_CHECKING

from silostudy.commands import compare_cases, compare_checks
from silostudy.commands.about import cautions, rings
from silostudy.errors import BadInput

if TYPE_CHECKING:
    import xarray as xr


def shell(expansion) -> list[str]:
    """Required thickness and utilisation by method and rule, each with what governs."""
    from silostudy.compute.pressure import pressure_cube
    from silostudy.compute.shell import shell_cube
    from silostudy.cube.silence import silences

    pressure = pressure_cube(expansion)
    shaken, seismic = expansion.cases[0].scene.earthquake, shaken_cube(expansion)
    cube = shell_cube(expansion, pressure, seismic)
    head = f"{'method, rule':56}thickness   governed by     end  utilised   governed by     end"
    lines = [head]
    for method in map(str, cube["pressure_method"].values):
        for rule in map(str, cube["rule"].values):
            lines.append(f"{f'{method}, {rule}':56}{_line(cube, {'pressure_method': method, 'rule': rule})}")
    told = (
        "largest over depths, phases and strakes; safety factor, own weight, roof and snow included; end of the wall friction"
    )
    return [
        *lines,
        told,
        *(_shaken_table(cube) if shaken else []),
        *compare_checks.lines_of(expansion, pressure, seismic),
        *compare_cases.told(expansion),
        *_unlooked(pressure),
        *silences(pressure),
        *rings(expansion),
        *cautions(expansion),
    ]


def shaken_cube(expansion) -> "xr.Dataset | None":
    """The cube of the seismic study that a study of shells names; None where it names none."""
    from silostudy.compute.seismic import seismic_cube

    shaken = expansion.cases[0].scene.earthquake
    return shaken and seismic_cube(_settled(shaken))


def _shaken_table(cube: "xr.Dataset") -> list[str]:
    """The same with the earthquake: the worse side of the wall, by method and rule."""
    lines = [f"{'with the earthquake':56}thickness   governed by    side  utilised   governed by    side"]
    names = [("required_thickness",), ("utilisation", "strake_utilisation")]
    for method in map(str, cube["pressure_method"].values):
        for rule in map(str, cube["rule"].values):
            walled = cube.sel({"pressure_method": method, "rule": rule})
            cells = [_shaken(walled, [f"earthquake_{name}" for name in pair]) for pair in names if pair[0] in cube]
            lines.append(f"{f'{method}, {rule}':56}{''.join(cells)}")
    return [*lines, f"{cube.attrs['earthquake']}; characteristic values, no combination factors"]


def _shaken(walled: "xr.Dataset", names: list[str]) -> str:
    """The largest of some variables over both sides, with what governs it and the side."""
    if any(_unjudged(walled, name) for name in names):
        return f"  masked: {_reason(walled, *names)}"
    name = max(names, key=lambda name: float(walled[name].max()))
    sides = walled[name].max([dim for dim in walled[name].dims if dim != "side"])
    side = str(walled["side"].values[int(sides.values.argmax())])
    largest, by = float(walled[name].max()), _governing(walled[name], walled[f"{name}_check"])
    number = f"{largest * 1e3:6.2f} mm" if "thickness" in name else f"{largest:10.3f}"
    return f"{number}{by:>14}{side:>8}"


def _unjudged(walled: "xr.Dataset", name: str) -> bool:
    """Whether a loaded part of the wall is masked, so that the largest of the rest does not speak for it."""
    from silostudy.buckling.family import IN_SCOPE, NO_LOAD

    masked = walled[name].isnull()
    return bool((masked & ~walled[f"{name}_scope"].isin([IN_SCOPE, NO_LOAD])).any() or masked.all())


def _unlooked(pressure: "xr.Dataset") -> list[str]:
    """Note that the study's depths end above the foot of the wall."""
    deepest, foot = float(pressure["depth"].max()), float(pressure["cylinder_depth"].max())
    return [f"depths end at {deepest:g} m, the wall at {foot:g} m: its foot is not looked at"] * (deepest < foot * (1 - 1e-9))


def _settled(asked):
    from silostudy.choice.expand import resolved

    return resolved(asked, asked.name)


def _line(cube: "xr.Dataset", keys: dict[str, str]) -> str:
    """Thickness (mm) and utilisation of one method and rule."""
    walled = cube.sel(keys)
    cells = _thickness(walled)
    return cells + _utilisation(walled) if "utilisation" in cube else cells


def _thickness(walled: "xr.Dataset") -> str:
    largest = _first(walled["largest_required_thickness"])
    if isnan(largest):
        return f"masked: {_reason(walled, 'required_thickness')}"
    by = _governing(walled["required_thickness"], walled["required_thickness_check"])
    return f"{largest * 1e3:6.2f} mm{by:>14}{_end(walled['largest_required_thickness_friction_end']):>8}"


def _utilisation(walled: "xr.Dataset") -> str:
    largest = _first(walled["largest_utilisation"])
    places = ("utilisation", "strake_utilisation")
    if isnan(largest):
        return f"  masked: {_reason(walled, *places)}"
    name = max(places, key=lambda name: float(walled[name].max()))
    by = _governing(walled[name], walled[f"{name}_check"])
    return f"{largest:10.3f}{by:>14}{_end(walled['largest_utilisation_friction_end']):>8}"


def _first(values: "xr.DataArray") -> float:
    """A number that is the same for all cases."""
    return float(values.values.ravel()[0])


def _governing(values: "xr.DataArray", checks: "xr.DataArray") -> str:
    import numpy as np

    place = int(np.nanargmax(values.values))
    return checks.attrs["flag_meanings"].split()[int(checks.values.ravel()[place])]


def _end(flags: "xr.DataArray") -> str:
    return flags.attrs["flag_meanings"].split()[int(flags.values.ravel()[0])]


def _reason(walled: "xr.Dataset", *names: str) -> str:
    """Reason why a number is masked: the first that is no want of a load, and whether for a part of the wall alone."""
    from silostudy.buckling.family import IN_SCOPE, NO_LOAD, REASONS

    flags = [flag for name in names for flag in walled[f"{name}_scope"].values[walled[name].isnull().values].ravel()]
    reasons = [REASONS[flag].replace("_", " ") for flag in flags if flag not in (IN_SCOPE, NO_LOAD)]
    part = " in a part of the wall" if any(walled[name].notnull().any() for name in names) else ""
    return f"{reasons[0]}{part}" if reasons else "no load"


def buckling(expansion) -> list[str]:
    """Buckling stress, knock-down and mode by rule, or why a rule is silent."""
    from silostudy.compute.buckling import buckling_cube

    cube = buckling_cube(expansion)
    modes = cube["buckling_mode"].attrs["flag_meanings"].split()
    lines = [f"{'rule':32}buckling stress  over classical  mode"]
    for rule in map(str, cube["rule"].values):
        walled = cube.sel({"rule": rule})
        stress = float(walled["buckling_stress"])
        told = f"masked, its range: {cube['rule_limit'].values[int(walled['rule_limit_broken'])]}"
        if not isnan(stress):
            told = f"{stress / 1e6:11.2f} MPa{float(walled['knockdown_factor']):16.3f}  {modes[int(walled['buckling_mode'])]}"
        lines.append(f"{rule:32}{told}")
    return lines


def seismic(expansion) -> list[str]:
    """Demand on the wall by the share of the contents that moves with it."""
    from silostudy.compute.seismic import seismic_cube

    cube = seismic_cube(expansion)
    lines = [f"{'contents that move':24}   share  base shear  base moment  axial force   pressure  top peak"]
    for choice in map(str, cube["mass_choice"].values):
        shaken = cube.sel(mass_choice=choice)
        numbers = (
            f"{float(shaken['mass_choice_coefficient']):8.3f}{float(shaken['base_shear']) / 1e6:9.3f} MN"
            f"{float(shaken['base_moment']) / 1e6:8.2f} MN m{float(shaken['seismic_axial_wall_force'].max()) / 1e3:8.1f} kN/m"
            f"{float(shaken['seismic_wall_pressure'].max()) / 1e3:7.2f} kPa{float(shaken['top_peak']):5.2f} m/s2"
        )
        lines.append(f"{choice:24}{numbers}")
    return lines


def table(expansion, where: str) -> list[str]:
    """The table of a study without sweep; BadInput for a kind that has none."""
    from silostudy.compute.axes import axis_names
    from silostudy.compute.shell_ends import KEY
    from silostudy.stages import KINDS
    from silostudy.stages.pressure import KIND as PRESSURE

    kind = KINDS[expansion.study.kind]
    if not kind.table:
        known = ", ".join(key for key, other in KINDS.items() if other.table or other.key == PRESSURE.key)
        allowed = f"compare takes studies of kind {known}; use `silostudy {expansion.study.stages[-1]}`"
        raise BadInput("kind", kind.key, allowed, where)
    if set(axis_names(expansion.study)) - {KEY}:
        raise BadInput("study", where, "must be without sweep: compare takes one silo or shell")
    return resolve_name(kind.table)(expansion)
