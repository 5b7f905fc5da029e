"""The checks below the cylinder: the hopper's wall, the transition ring, the ring beam on columns, the anchors."""

from collections.abc import Callable, Mapping, Sequence

import numpy as np
import xarray as xr

from silostudy.checks import anchors, hopper, ring_beam, transition_ring, tube
from silostudy.checks.family import HOPPER, REASONS, SUPPORT, call
from silostudy.compute.checks_actions import FILLING, of_earthquake, of_wind
from silostudy.compute.checks_scope import judged, rows_of, scope
from silostudy.compute.checks_wall import WallActions
from silostudy.cube.variables import flags as meaning
from silostudy.tables.combinations import Combination

NUMBERS = ("hopper_thickness", "hopper_joint_efficiency", "ultimate_stress", "ring_area", "ring_second_moment", "column_count",
           "section_modulus", "anchor_count", "anchor_resistance")  # fmt: skip
LOADED_BY = {"support_force": "wall hopper", "hopper_meridional_force": "hopper"}  # force that a check asks for -> whose it is


def hopper_forces(pressure: xr.Dataset, loads: WallActions) -> dict[str, np.ndarray]:
    """Forces n_phi and n_th (N/m) of the hopper's wall, (combination, method, axes..., hopper_position), with own weight."""
    height, half_angle = heights(pressure)
    normal, traction = pressures_in_hopper(pressure)
    shape = {"height": height, "half_angle": half_angle}
    along = hopper.meridional_force(normal, traction, **shape)
    if "ring_force" in pressure:  # of a switch of stresses: it hangs on the upper edge
        around = 2 * np.pi * (height * np.tan(half_angle) * np.cos(half_angle))[..., 0]
        along[..., 0] += np.nan_to_num(pressure["ring_force"].values) / around
    round_it = hopper.hoop_force(normal, **shape)
    plate = loads.source.numbers["steel_weight"] * loads.source.numbers["hopper_thickness"]
    nothing = np.zeros(np.broadcast_shapes(height.shape, plate.shape))
    weight = np.nan_to_num(hopper.meridional_force(nothing, nothing, wall_weight=plate, **shape))
    forces = {"hopper_meridional_force": along, "hopper_hoop_force": round_it}
    arrays = {
        name: np.array([_of_contents(combination, value, loads) for combination in loads.combinations])
        for name, value in forces.items()
    }
    arrays["hopper_meridional_force"] = arrays["hopper_meridional_force"] + loads.factor("permanent") * weight
    return arrays


def pressures_in_hopper(pressure: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Normal pressure and friction (Pa) on the hopper's wall, (method, phase, axes..., hopper_position)."""
    normal, traction = (pressure[name].values for name in ("hopper_normal_pressure", "hopper_friction_traction"))
    return normal, traction


def heights(pressure: xr.Dataset) -> tuple[np.ndarray, np.ndarray]:
    """Height above the apex (m), (axes..., hopper_position), and half angle (rad), (axes..., 1)."""
    half_angle = pressure["hopper_half_angle"].values[..., None]
    top, outlet = pressure["hopper_height"].values[..., None], pressure["outlet_width"].values[..., None]
    bottom = outlet / 2 / np.tan(half_angle)
    return top - pressure["hopper_position"].values * (top - bottom), half_angle


def _of_contents(combination: Combination, values: np.ndarray, loads: WallActions) -> np.ndarray:
    """A force of the solid in a combination: of the worst phase or of filling, with its factor; 0 in an empty silo."""
    phases = list(loads.source.expansion.study.phases)
    if combination.contents == "empty":
        return np.zeros(values[:, 0].shape)
    if combination.contents == FILLING:
        chosen = values[:, phases.index(FILLING)] if FILLING in phases else values[:, 0] * np.nan
    else:
        chosen = np.fmax.reduce(values, axis=1)
    return combination.solids * chosen


def parameters_below(pressure: xr.Dataset, loads: WallActions, built: Mapping) -> dict[str, np.ndarray]:
    """The parameters of everything below the cylinder, without a place: (combination, method, axes..., 1); NaN: not known."""
    source, number = loads.source, loads.source.numbers
    values = {name: number[name] for name in NUMBERS} | {"inner_radius": number["inner_radius"]}
    values |= {name: loads.parameters[name] for name in ("yield_stress", "youngs_modulus")}
    values |= {name: loads.parameters[name] for name in ("partial_yield", "partial_buckling", "partial_joint")}
    foot = {name: built[name][..., -1:] for name in ("axial_wall_force", "thickness") if name in built}
    angle = [case.scene.silo.hopper.half_angle if case.scene.silo.hopper else np.nan for case in source.expansion.cases]
    values["hopper_half_angle"] = np.reshape(angle, (*source.expansion.shape, 1))
    values["thickness"] = foot.get("thickness", np.full_like(number["inner_radius"], np.nan))
    values["anchor_tension"] = anchor_tension(loads)
    force = foot.get("axial_wall_force", loads.parameters["axial_wall_force"][..., -1:] * np.nan)
    values["hopper_meridional_force"] = np.full(force.shape, np.nan)
    values["hopper_hoop_force"] = np.full(force.shape, np.nan)
    if "hopper_position" in pressure:
        forces = hopper_forces(pressure, loads)
        values |= forces | {"hopper_top_force": forces["hopper_meridional_force"][..., :1]}
    top = values.get("hopper_top_force", values["hopper_meridional_force"])
    values["support_force"] = force + top * np.cos(values["hopper_half_angle"])
    return values


def anchor_lifts(loads: WallActions) -> dict[str, np.ndarray]:
    """Forces (N/m) that lift the foot of the wall or hold it down, (combination, 1, axes..., 1): the contents hold nothing."""
    source, number, lifts = loads.source, loads.source.numbers, []
    asked = source.expansion.study.checks.earthquake
    for combination in loads.combinations:
        wind = of_wind(combination, source)["force"][..., -1:]
        pressure = combination.wind * np.nan_to_num(number["wind_pressure"])
        silo = {"height": number["wall_height"], "radius": number["inner_radius"], "top_held": number["top_held"] > 0}
        shaken = of_earthquake(combination, source)["force"][..., -1:] * (asked.overstrength if asked else 1.0)
        dead = combination.permanent_favourable * (source.places.own_weight[..., -1:] + number["roof"])
        lift = {"bending": wind, "harmonics": tube.wind_lift(pressure=pressure, **silo), "earthquake": shaken, "weight": dead}
        lifts.append({name: np.broadcast_to(value, wind.shape) for name, value in lift.items()})
    return {f"anchor_lift_{name}": np.array([part[name] for part in lifts])[:, None] for name in lifts[0]}


def anchor_tension(loads: WallActions) -> np.ndarray:
    """Tension (N) of the anchor that is drawn most, (combination, 1, axes..., 1)."""
    number = loads.source.numbers
    lifts = {name.removeprefix("anchor_lift_"): value for name, value in anchor_lifts(loads).items()}
    ring = {name: number[name] for name in ("inner_radius", "circle_diameter", "anchor_count")}
    return anchors.tension(lifts["bending"] + lifts["earthquake"], lifts["harmonics"] - lifts["weight"], **ring)


def below(pressure: xr.Dataset, loads: WallActions, built: Mapping) -> dict:
    """The cube's variables of hopper, ring, beam and anchors."""
    parameters = parameters_below(pressure, loads, built)
    top = parameters.pop("hopper_top_force", parameters["hopper_meridional_force"])
    study, shape = loads.source.expansion.study, (*loads.shape[:-1], 1)
    support = {**parameters, "hopper_meridional_force": top}
    rows = rows_of(study, SUPPORT)
    data: dict = _checked(rows, support, loads, shape, SUPPORT)
    data["support_check_loaded_by"] = [
        " ".join(whose for name, whose in LOADED_BY.items() if name in row.needs) for row in rows
    ]
    if "hopper_position" in pressure:
        names = ("hopper_meridional_force", "hopper_hoop_force")
        data |= _checked(rows_of(study, HOPPER), parameters, loads, parameters[names[0]].shape, HOPPER)
        data |= {name: parameters[name] for name in names}
        # every stress there is a force over the thickness, the hopper's present weight in the force
        data["hopper_required_thickness"] = data["hopper_check_utilisation"] * parameters["hopper_thickness"]
    inner: dict[str, Callable] = {
        "transition_ring_force": transition_ring.ring_force,
        "ring_effective_area": transition_ring.effective_area,
        "ring_cylinder_length": transition_ring.cylinder_length,
        "ring_hopper_length": transition_ring.hopper_length,
        "ring_beam_support_moment": ring_beam.support_moment,
        "ring_beam_midspan_moment": ring_beam.midspan_moment,
        "ring_beam_shear_force": ring_beam.shear_force,
        "ring_beam_torque": ring_beam.largest_torque,
    }
    behind = {name: np.broadcast_to(call(function, support), shape)[..., 0] for name, function in inner.items()}
    tension = anchor_lifts(loads) | {
        "anchor_tension": parameters["anchor_tension"],
        "support_force": parameters["support_force"],
    }
    return data | behind | {name: np.broadcast_to(value, shape)[..., 0] for name, value in tension.items()}


def _checked(rows: Sequence, parameters: Mapping, loads: WallActions, shape, part: str) -> dict:
    """Utilisation by every check of a part with its scope; the last axis left out where it is one number a case."""
    values, flags = [], []
    for row in rows:
        with np.errstate(invalid="ignore", divide="ignore"):
            used = np.broadcast_to(row.utilisation(parameters), shape)
            used, why = judged(used, scope(row, parameters, loads.combinations, loads.lacks, shape))
        values.append(used if part == HOPPER else used[..., 0])
        flags.append(why if part == HOPPER else why[..., 0])
    name = f"{part}_check_utilisation"
    told = meaning(f"why {name} is masked", REASONS)
    return {f"{part}_check": [row.key for row in rows], name: np.array(values), f"{name}_scope": (np.array(flags), told)}
