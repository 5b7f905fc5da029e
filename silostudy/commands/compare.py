"""Command `silostudy compare`: one silo, from flags or a study file, by every method: a table in the terminal and a figure."""

import argparse
from collections.abc import Collection, Mapping
from math import isfinite
from pathlib import Path
from typing import TYPE_CHECKING, Any

from silostudy.commands import compare_cases, compare_loads, compare_measured, compare_steel
from silostudy.commands.about import cautions
from silostudy.commands.families import add_methods_from
from silostudy.errors import BadInput

if TYPE_CHECKING:
    import xarray as xr

COLUMNS = (
    "largest: the largest pressure (kPa), at the depth beside it; factor: that over the pressure after filling of the theory "
    "the method builds on; wall carries: share of the contents' weight that hangs on the wall; balance: share of the weight "
    "that is left over, zero but for rounding",
    "'-': no single state of equilibrium, or not covered by the method's source; `silostudy explain METHOD` says which "
    "properties of the solid a method needs",
)
FLAGS = "--diameter --depth --solid, and as needed --wall --hopper-half-angle --methods"


def add(sub) -> None:
    command = sub.add_parser(
        "compare",
        help="compare the methods on one silo, given by flags or by a study file (pressure, shell, buckling, seismic)",
    )
    command.add_argument("study", type=Path, nargs="?", help="study file without sweep, in place of the flags")
    command.add_argument("--diameter", type=float, metavar="M", help="inner diameter (m)")
    command.add_argument("--depth", type=float, metavar="M", help="depth of the cylinder (m)")
    command.add_argument("--solid", help="see `silostudy list solids`")
    command.add_argument("--wall", help="see `silostudy list walls`; left out: the solid's own wall friction")
    command.add_argument("--wall-friction", type=float, metavar="MU", help="coefficient, in place of the tables'")
    command.add_argument("--hopper-half-angle", type=float, metavar="DEG", help="left out: a flat bottom")
    command.add_argument("--hopper-wall-friction", type=float, metavar="MU", help="left out: as the cylinder's")
    command.add_argument("--effective-friction-angle", type=float, metavar="DEG", help="Jenike's delta, for flow in hoppers")
    command.add_argument("--methods", nargs="+", default="all", help="see `silostudy list methods`")
    command.add_argument("--figure", type=Path, metavar="STEM", help="also draw STEM.png, STEM.svg and STEM.csv")
    add_methods_from(command)
    command.set_defaults(run=run)


def run(chosen: argparse.Namespace) -> None:
    from silostudy.choice.expand import expand, expand_file
    from silostudy.compute.evaluate import methods_of
    from silostudy.compute.pressure import pressure_cube
    from silostudy.cube.silence import silences
    from silostudy.stages.pressure import KIND

    if chosen.study:
        _check_no_flags(chosen)
        expansion = expand_file(chosen.study)
        if expansion.study.kind != KIND.key:
            lines = compare_steel.table(expansion, str(chosen.study))
            if chosen.figure:
                raise BadInput("--figure", str(chosen.figure), "draws pressure studies; use the outputs of this one")
            print("\n".join(lines))
            return
        if expansion.shape:
            raise BadInput("study", str(chosen.study), "must be without sweep: compare takes one silo")
    else:
        expansion = expand(_study(chosen), "compare", "compare", Path())
    cube = pressure_cube(expansion)
    balanced = {method.label: method.row.equilibrium for method in methods_of(expansion)}
    lines = [*table(cube, balanced), *silences(cube), *hopper_table(cube), *compare_loads.told(cube)]
    lines += [*compare_cases.told(expansion), *compare_measured.told(cube)]
    lines += [*values_used(cube), *cautions(expansion)]
    print("\n".join(lines))
    if chosen.figure:
        from silostudy.figures.comparison_today import draw

        draw(cube, chosen.figure)
        print(f"drawn: {chosen.figure}.png, {chosen.figure}.svg, {chosen.figure}.csv")


def _check_no_flags(chosen: argparse.Namespace) -> None:
    """BadInput for a flag beside a study file, which says all of the silo itself."""
    for name, value in vars(chosen).items():
        if name not in ("study", "figure", "run") and value not in (None, "all"):
            flag, told = f"--{name.replace('_', '-')}", value if isinstance(value, (float, list)) else str(value)
            raise BadInput(flag, told, f"write it into {chosen.study}: flags stand in place of a study file")


def _study(chosen: argparse.Namespace) -> dict[str, Any]:
    """The flags as the content of a study file; what the others are set against is always shown."""
    from silostudy.pressure import janssen

    for flag in ("diameter", "depth", "solid"):
        if getattr(chosen, flag) is None:
            raise BadInput(f"--{flag}", None, f"is missing; give a study file, or {FLAGS}", "compare")
    silo = {"plan": "circular", "diameter_m": chosen.diameter, "cylinder_depth_m": chosen.depth}
    if chosen.hopper_half_angle is not None:
        silo["hopper"] = {"half_angle_deg": chosen.hopper_half_angle}
    flags = {
        "wall_friction": chosen.wall_friction,
        "hopper_wall_friction": chosen.hopper_wall_friction,
        "effective_friction_angle_deg": chosen.effective_friction_angle,
    }

    own = {name: value for name, value in flags.items() if value is not None}
    methods = chosen.methods if chosen.methods == "all" else list(dict.fromkeys([janssen.ROW.key, *chosen.methods]))
    return {
        "kind": "pressure",
        "title": f"{chosen.solid} in a silo of {chosen.diameter:g} m by {chosen.depth:g} m",
        "scene": {"silo": silo, "solid": chosen.solid, "wall": chosen.wall, "properties": own},
        "methods_from": chosen.methods_from and str(chosen.methods_from),
        "methods": methods,
        "relative_depth": {"start": 0.0, "stop": 1.0, "count": 289},
        "hopper_position": None if chosen.hopper_half_angle is None else {"start": 0.0, "stop": 1.0, "count": 41},
    }


def table(cube: "xr.Dataset", balanced: Mapping[str, Collection[str]]) -> list[str]:
    """Wall pressure (kPa) at the quarters of the depth, its maximum, and what the wall carries, a line for each curve.

    balanced: method -> its phases that are single states of equilibrium.
    """
    from numpy import nanargmax

    depth = cube["depth"].values
    quarters = [abs(depth - share * float(cube["cylinder_depth"])).argmin() for share in (0.25, 0.5, 0.75, 1.0)]
    head = "".join(f"{depth[i]:8.2f}m" for i in quarters)
    lines = [f"wall normal pressure (kPa) at depth {'':9}{head}   largest  at depth  factor  wall carries  balance"]
    for method in map(str, cube["pressure_method"].values):
        for phase in map(str, cube["phase"].values):
            state = cube.sel(pressure_method=method, phase=phase)
            pressure = state["wall_normal_pressure"].values / 1e3
            if not state["wall_normal_pressure"].isnull().all():
                name = f"{method}, {phase}"
                values = "".join(f"{_cell(pressure[i]):>9}" for i in quarters)
                peak = int(nanargmax(pressure))
                factor = float(state["overpressure_factor"][peak])
                lines.append(
                    f"{name:44}{values}{pressure[peak]:10.2f}{depth[peak]:9.2f}m{factor:8.2f}"
                    f"{_carried(state):>14}{_balance(state) if phase in balanced[method] else '-':>9}"
                )
    return [*lines, *COLUMNS]


def _cell(value: float) -> str:
    return f"{value:.2f}" if isfinite(value) else "-"


def _carried(state: "xr.Dataset") -> str:
    """Share of the cylinder's contents that hangs on the wall by friction."""
    weight = _unit_weight(state) * float(state["cylinder_depth"]) * float(state["hydraulic_radius"])
    share = float(state["axial_wall_force"][-1]) / weight
    return f"{share:.1%}" if isfinite(share) else "-"


def _balance(state: "xr.Dataset") -> str:
    """Weight less vertical pressure and wall friction, over the weight, at the transition."""
    weight = _unit_weight(state) * float(state["cylinder_depth"])
    carried = float(state["vertical_pressure"][-1]) + float(state["axial_wall_force"][-1]) / float(state["hydraulic_radius"])
    return f"{1 - carried / weight:.0e}" if isfinite(carried) else "-"


def _unit_weight(state: "xr.Dataset") -> float:
    """The unit weight (N m-3) that the method reckons with."""
    own = float(state["design_unit_weight"]) if "design_unit_weight" in state else float("nan")
    return own if isfinite(own) else float(state["unit_weight"])


def hopper_table(cube: "xr.Dataset") -> list[str]:
    """Forces (kN) that carry the hopper's contents and the load on them, a line for each state, and the flow pattern."""
    if "hopper_balance" not in cube:
        return []
    names = ("hopper_weight", "transition_force", "hopper_wall_force", "ring_force", "outlet_force")
    lines = [f"hopper (kN){'':33}  contents      load      wall      ring    outlet  balance"]
    for method in map(str, cube["pressure_method"].values):
        for phase in map(str, cube["phase"].values):
            state = cube.sel(pressure_method=method, phase=phase)
            if isfinite(float(state["hopper_balance"])):
                forces = "".join(f"{_cell(float(state[name]) / 1e3) if name in state else '-':>10}" for name in names)
                lines.append(f"{f'{method}, {phase}':44}{forces}{float(state['hopper_balance']):>9.0e}")
    pattern = cube["flow_pattern"].attrs["flag_meanings"].split()[int(cube["flow_pattern"])].replace("_", " ")
    return [*lines, f"flow pattern by the mass-flow limit: {pattern}{_limit(cube)}"]


def _limit(cube: "xr.Dataset") -> str:
    from math import degrees

    limit, angle = float(cube["mass_flow_limit"]), float(cube["hopper_half_angle"])
    return f" (half angle {degrees(angle):.1f} deg, limit {degrees(limit):.1f} deg, margin 3 deg)" if isfinite(limit) else ""


def values_used(cube: "xr.Dataset") -> list[str]:
    """The characteristic values behind the methods that have them, as numbers, with a mark where mu was cut to tan(phi)."""
    from math import degrees

    lines = []
    for method in map(str, cube["pressure_method"].values):
        of_method = cube.sel(pressure_method=method)
        if text := str(of_method["pressure_method_values"].values):
            mean = f"phi {degrees(float(of_method['internal_friction_angle'])):.1f} deg"
            for name, label in (("wall_friction", "mu"), ("lateral_pressure_ratio", "K"), ("a_phi", "a_phi"), ("a_K", "a_K")):
                mean += f", {label} {float(of_method[name]):.3g}" if name in of_method else ""
            mean += f", a_mu {float(of_method['a_mu']):.3g}" if "a_mu" in of_method else ""
            lines.append(f"{method}: {text} (means: {mean}; unit weight {float(of_method['unit_weight']) / 1e3:.2f} kN/m3)")
            lines += [f"  {line}" for line in _numbers_used(of_method)]
    return lines


def _numbers_used(of_method: "xr.Dataset") -> list[str]:
    """A line for each different set of values: what is reckoned with them, mu, K and phi."""
    from math import degrees

    phases_by_text: dict[str, dict[str, list[str]]] = {}
    for phase in map(str, of_method["phase"].values):
        for quantity in map(str, of_method["used_for"].values):
            values = of_method.sel(phase=phase, used_for=quantity)
            mu, k, phi = (
                float(values[f"used_{name}"]) for name in ("wall_friction", "lateral_pressure_ratio", "internal_friction_angle")
            )
            if isfinite(mu):
                cut = float(values["used_wall_friction_uncapped"])
                capped = f" (cut from {cut:.3g} to tan phi)" if bool(values["used_wall_friction_capped"]) else ""
                text = f"mu {mu:.3g}{capped}, K {k:.3g}, phi {degrees(phi):.1f} deg"
                phases_by_text.setdefault(text, {}).setdefault(quantity, []).append(phase)
    told = {text: (f"{what} ({', '.join(when)})" for what, when in whats.items()) for text, whats in phases_by_text.items()}
    return [f"{text}: {', '.join(what)}" for text, what in told.items()]
