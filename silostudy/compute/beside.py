"""Walls of silos of grains beside what theories and codes say of them: the same silo and solid, level by level.

The grains' pressures are those of the sweep; the codes' are read at the depth of each level below the level surface.
"""

import numpy as np
import xarray as xr

from silostudy.compute.axes import axis_coordinates, axis_names
from silostudy.compute.beside_around import PATCH, around, around_mean, zones
from silostudy.compute.beside_codes import PHASES, at_depths, by_phase, matched, profiles
from silostudy.compute.beside_flow import in_full_flow, outflow
from silostudy.compute.beside_hopper import compared_in_hopper, forces, in_cone
from silostudy.compute.beside_plan import Plan, plan_of
from silostudy.cube.areas import AVERAGED, largest_mean, of_profile, step_of
from silostudy.cube.assemble import Sweep, assemble
from silostudy.cube.contract import variable
from silostudy.scene.expand import Expansion

SLIDES = 0.8  # of the largest friction of any level: with less a level counts as one where grains do not slide
SMALLEST = next(iter(AVERAGED))  # of the areas: about as wide as the patch of EN 1991-4's patch load
DEEP = 0.5  # diameters below the surface: where pressures are large enough that ratios of them tell something
OF_METHODS = ("pressure_method_title", "pressure_method_number", "pressure_method_colour", "pressure_method_marker")
SOURCES = ("en1991_4_2006", "silo_handbook")


def beside_cube(expansion: Expansion, scenes: xr.Dataset, codes: xr.Dataset | None) -> xr.Dataset:
    """The cube of a sweep of scenes beside that of the study of pressures which it names."""
    study = expansion.study
    axes = tuple(name for name in axis_names(study) if name != study.fillings)
    grains = scenes if study.fillings == "filling" else scenes.rename({study.fillings: "filling"})
    pressures = matched(expansion, codes, grains)
    plan = plan_of(study)
    data = felt(grains, plan) | in_cone(grains)
    data |= said(pressures, data)
    data |= compared(data, plan.width, local(pressures, data)) | compared_in_hopper(data)
    if plan.around:
        data |= outflow(grains, expansion) | forces(pressures, grains)
        deep = data["level_depth"] >= DEEP * plan.width
        data |= around(grains, deep) | zones(pressures, data["level_depth"].mean("filling"), deep)
    arrays = {name: _in_order(value, name, axes) for name, value in data.items()}
    arrays |= {name: pressures[name].values for name in ("pressure_method", *OF_METHODS)}
    arrays |= {name: grains[name].values for name in ("filling", "wall_level")}
    arrays |= {"phase": np.array(PHASES), "averaging": np.array(list(AVERAGED))}
    arrays |= {"code_level": np.arange(data["code_profile_depth"].sizes["code_level"])}
    arrays |= {"hopper_position": pressures["hopper_position"].values} if "code_hopper_profile" in data else {}
    coordinates = {name: given for name, given in axis_coordinates(study).items() if given[0] in axes}
    notes = {"codes": pressures.attrs["title"]}
    return assemble(study, "beside", arrays, sources=SOURCES, notes=notes, sweep=Sweep(axes, coordinates))


def _in_order(value: xr.DataArray, name: str, axes: tuple[str, ...]) -> np.ndarray:
    dims = variable(name).dims_in(axes, relative=False)
    return value.transpose(*dims).values


def felt(grains: xr.Dataset, plan: Plan) -> dict[str, xr.DataArray]:
    """Loads on the vertical wall: depths (m), pressures (Pa) by phase and area, friction and lateral pressure ratio."""
    height, step = grains["wall_level_height"], step_of(grains["wall_level_height"])
    depth = grains["filled_height_at_rest"] - (height - height.isel(wall_level=0) + step / 2)
    depth = depth.where(depth >= step / 2)  # levels that are wholly below the surface
    rest, flow = (grains[f"wall_pressure_{when}"].where(depth.notnull()) for when in ("at_rest", "in_flow"))
    ring = by_phase(rest.mean("wall_turn"), in_full_flow(flow, grains).mean(("wall_turn", "flow_window")))
    sheared = in_full_flow(grains["wall_shear_in_flow"], grains).mean(("wall_turn", "flow_window"))
    shear = by_phase(grains["wall_shear_at_rest"].mean("wall_turn"), sheared)
    shear = shear.where(depth.notnull())
    largest = by_phase(_largest(rest.expand_dims("flow_window")), _largest(flow))
    weight = grains["unit_weight_at_rest"]
    by_level = shear.fillna(0.0) * step / plan.hydraulic_radius
    carried = (
        by_level.isel(wall_level=slice(None, None, -1)).cumsum("wall_level").isel(wall_level=slice(None, None, -1))
        - by_level / 2
    )
    vertical = (weight * depth - carried.sel(phase="filling")).where(depth.notnull())
    return {
        "level_depth": depth,
        "ring_pressure": ring,
        "largest_area_pressure": largest,
        "mobilised_wall_friction": shear.sum("wall_level") / ring.sum("wall_level"),
        "lateral_pressure_ratio_at_rest": ring.sel(phase="filling").sum("wall_level") / vertical.sum("wall_level"),
        "stagnant_wall_height": _stagnant((shear / ring).sel(phase="discharge", drop=True), step),
        "contents_unit_weight": weight,
        "averaging_side": _sides(step, plan, grains.sizes["wall_turn"]),
    }


def _stagnant(friction: xr.DataArray, step: xr.DataArray) -> xr.DataArray:
    """Height (m) above the transition up to which every level's friction in flow (1) stays below most of the largest level's.

    Where grains slide down a wall all of its friction acts; below, where they hardly move, less.
    """
    low = (friction < SLIDES * friction.max("wall_level")).cumprod("wall_level")
    return low.sum("wall_level") * step


def _largest(pressure: xr.DataArray) -> xr.DataArray:
    """Largest mean over each area in any window."""
    values = pressure.transpose(..., "flow_window", "wall_level", "wall_turn")
    shaped = values.isel(wall_turn=0, drop=True).max("flow_window")
    means = [shaped.copy(data=np.fmax.reduce(largest_mean(values.values, area), axis=-2)) for area in AVERAGED]
    return xr.concat(means, xr.IndexVariable("averaging", list(AVERAGED)))


def _sides(step: xr.DataArray, plan: Plan, around: int) -> xr.DataArray:
    """Side of each averaging area over the diameter (1)."""
    sides = [plan.side(levels * step, (turns or around) / around) / plan.width for levels, turns in AVERAGED.values()]
    return xr.concat(sides, xr.IndexVariable("averaging", list(AVERAGED)))


def said(codes: xr.Dataset, felt_arrays: dict[str, xr.DataArray]) -> dict[str, xr.DataArray]:
    """Pressures (Pa) by theories and codes at the levels, at their mean depth over the fillings, and at depths of their own."""
    depth = felt_arrays["level_depth"].mean("filling")
    even = codes.assign(wall_normal_pressure=around_mean(codes))
    at_levels = {"code_wall_pressure": at_depths(even, "wall_normal_pressure", depth)}
    return at_levels | profiles(even, depth.isel(wall_level=0, drop=True))


def local(codes: xr.Dataset, arrays: dict[str, xr.DataArray]) -> xr.DataArray:
    """Largest pressures (Pa) by theories and codes anywhere around the levels: with patch load, or beside a flow channel."""
    said_here = at_depths(codes, "wall_normal_pressure", arrays["level_depth"].mean("filling"))
    return said_here * (1.0 + codes[PATCH].fillna(0.0)) if PATCH in codes else said_here


def compared(arrays: dict[str, xr.DataArray], wide: float, somewhere: xr.DataArray) -> dict[str, xr.DataArray]:
    """Ratios of what codes say to what the grains did, and of the grains' peaks to their rest.

    somewhere: what codes say (Pa) of the place around each level where it is most, for the smallest area.
    """
    code, ring, largest = (arrays[name] for name in ("code_wall_pressure", "ring_pressure", "largest_area_pressure"))
    deep = arrays["level_depth"] >= DEEP * wide
    both = code.notnull() & ring.notnull()
    said_force, felt_force = (pressure.where(both).sum("wall_level", min_count=1) for pressure in (code, ring))
    rest = ring.sel(phase="filling", drop=True)
    means = {area: _averaged(somewhere if area == SMALLEST else code, area) for area in AVERAGED}
    rests = {area: _averaged(rest, area) for area in AVERAGED}
    index = xr.IndexVariable("averaging", list(AVERAGED))
    share = {area: means[area] / largest.sel(averaging=area) for area in AVERAGED}
    rises = {area: largest.sel(averaging=area) / rests[area] for area in AVERAGED}
    return {
        "code_over_grains_force": said_force / felt_force,
        "code_profile_residual": ((code / ring - 1.0) ** 2).where(deep).mean("wall_level") ** 0.5,
        "code_over_grains_peak": xr.concat([share[area].where(deep).min("wall_level") for area in AVERAGED], index),
        "code_largest_over_rest": (code.sel(phase="discharge") / code.sel(phase="filling"))
        .where(deep.any("filling"))
        .max("wall_level"),
        "largest_over_rest": xr.concat([rises[area].where(deep).max("wall_level") for area in AVERAGED], index),
    }


def _averaged(profile: xr.DataArray, area: str) -> xr.DataArray:
    """Means of a profile over the levels of an area, whose lowest is each."""
    values = profile.transpose(..., "wall_level")
    return values.copy(data=of_profile(values.values, area))
