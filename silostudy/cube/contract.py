"""One table of every variable a cube may hold, and the check that a dataset keeps to it."""

from dataclasses import dataclass

import xarray as xr

from silostudy.errors import BadInput


@dataclass(frozen=True)
class Variable:
    """Name, unit, what it is, and its dimensions; '...' are the sweep axes, 'depth' also a relative depth."""

    name: str
    units: str
    long_name: str
    dims: tuple[str, ...]


def _v(name: str, units: str, long_name: str, *dims: str) -> Variable:
    return Variable(name, units, long_name, dims)


OVER_DEPTH = ("method", "phase", "...", "depth")
OVER_HOPPER = ("method", "phase", "...", "hopper_position")
TOTAL = ("method", "phase", "...")
BY_RULE = ("rule", "method", "...", "depth")  # what the phases share
VARIABLES = {
    variable.name: variable
    for variable in (
        _v("wall_normal_pressure", "Pa", "pressure of the stored solid normal to the wall", *OVER_DEPTH),
        _v("wall_friction_traction", "Pa", "friction traction on the wall, downward on the wall", *OVER_DEPTH),
        _v("vertical_pressure", "Pa", "mean vertical pressure in the stored solid", *OVER_DEPTH),
        _v("axial_wall_force", "N m-1", "axial wall force per metre of perimeter, compression positive", *OVER_DEPTH),
        _v(
            "overpressure_factor",
            "1",
            "wall normal pressure over the method's own static Janssen pressure",
            *OVER_DEPTH,
        ),
        _v("hopper_normal_pressure", "Pa", "pressure of the stored solid normal to the hopper wall", *OVER_HOPPER),
        _v("hopper_friction_traction", "Pa", "friction traction on the hopper wall, downward on the wall", *OVER_HOPPER),
        _v("hopper_vertical_pressure", "Pa", "mean vertical pressure in the hopper", *OVER_HOPPER),
        _v("switch_force", "N", "ring force on the hopper wall while the switch stands at this place", *OVER_HOPPER),
        _v("transition_force", "N", "downward force of the cylinder's contents on the hopper's", *TOTAL),
        _v("ring_force", "N", "concentrated force on the wall at the transition, downward", *TOTAL),
        _v("outlet_force", "N", "downward force of the solid on the outlet", *TOTAL),
        _v("peak_height", "m", "height of the largest hopper wall pressure above the hopper's apex", *TOTAL),
        _v("unloaded_peak_position", "1", "that height over the hopper's, without load on the hopper", *TOTAL),
        _v("radial_force_coefficient", "1", "force of the radial field at the transition over gamma D^(2+m) L^(1-m)", *TOTAL),
        _v("design_unit_weight", "N m-3", "unit weight that the method makes of those handed to it", *TOTAL),
        _v("averaging_height", "m", "height of wall over which the pressure is an average", *TOTAL),
        _v("patch_pressure", "Pa", "patch pressure", *TOTAL),
        _v("patch_depth", "m", "depth of the middle of the patch", *TOTAL),
        _v("patch_height", "m", "height of the patch", *TOTAL),
        _v("patch_resultant", "N", "resultant of the patch on a thin steel wall", *TOTAL),
        _v("hopper_balance", "1", "1 - (wall + ring + outlet) / (contents + load) of the hopper, vertically", *TOTAL),
        _v("hopper_weight", "N", "weight of the hopper's contents", *TOTAL),
        _v("hopper_wall_force", "N", "vertical force on the hopper wall by pressure and friction", *TOTAL),
        _v("perimeter", "m", "perimeter of the plan", "..."),
        _v("hopper_height", "m", "height of the transition above the hopper's apex", "..."),
        _v("hopper_half_angle", "rad", "half angle of the hopper from the vertical", "..."),
        _v("outlet_width", "m", "inner width of the outlet", "..."),
        _v("mass_flow_limit", "rad", "largest half angle of a cone in mass flow", "..."),
        _v("flow_pattern", "1", "flow pattern by the mass-flow limit", "..."),
        _v(
            "wall_normal_pressure_quantile",
            "Pa",
            "quantile of the sampled wall normal pressure",
            *("method", "phase", "quantile", "depth"),
        ),
        _v("sobol_first", "1", "first-order Sobol index of the largest wall pressure", "method", "phase", "parameter"),
        _v("sobol_total", "1", "total Sobol index of the largest wall pressure", "method", "phase", "parameter"),
        _v("quantile", "1", "share of the samples that lie below", "quantile"),
        _v("parameter", "1", "sampled property of the stored solid", "parameter"),
        _v("unit_weight", "N m-3", "unit weight handed to the method", "method", "..."),
        _v("internal_friction_angle", "rad", "internal friction angle handed to the method", "method", "..."),
        _v("wall_friction", "1", "wall friction coefficient handed to the method", "method", "..."),
        _v("wall_friction_capped", "1", "whether the wall friction was capped at tan(phi)", "method", "..."),
        _v("lateral_pressure_ratio", "1", "lateral pressure ratio handed to the method", "method", "..."),
        _v("poisson_ratio", "1", "Poisson's ratio handed to the method", "method", "..."),
        _v("unit_weight_lower", "N m-3", "lower unit weight handed to the method", "method", "..."),
        _v("effective_friction_angle", "rad", "effective friction angle handed to the method", "method", "..."),
        _v("hopper_wall_friction", "1", "wall friction coefficient of the hopper handed to the method", "method", "..."),
        _v("repose_angle", "rad", "angle of repose handed to the method", "method", "..."),
        _v("a_phi", "1", "spread of the friction angle handed to the method: upper over mean", "method", "..."),
        _v("a_K", "1", "spread of the lateral pressure ratio handed to the method: upper over mean", "method", "..."),
        _v("a_mu", "1", "spread of the wall friction handed to the method: upper over mean", "method", "..."),
        _v("hydraulic_radius", "m", "area over perimeter of the plan", "..."),
        _v("cylinder_depth", "m", "depth of the transition below the equivalent surface", "..."),
        _v("case", "1", "case identifier", "..."),
        _v("method", "1", "pressure method", "method"),
        _v("method_title", "1", "name of the method for people", "method"),
        _v("method_number", "1", "number of the method's curve in the handbook's Fig. 4.2.11", "method"),
        _v("method_colour", "1", "colour of the method in figures", "method"),
        _v("method_marker", "1", "marker of the method in figures", "method"),
        _v("method_values", "1", "characteristic values that the method uses in place of those handed to it", "method"),
        _v("hopper_position", "1", "place on the hopper wall: 0 transition, 1 outlet", "hopper_position"),
        _v("phase", "1", "phase of operation", "phase"),
        _v("elastic_local_stress", "Pa", "elastic stress at which the bay between rings buckles", "rule", "..."),
        _v("elastic_general_stress", "Pa", "elastic stress at which the shell buckles with its rings", "rule", "..."),
        _v("elastic_buckling_stress", "Pa", "elastic stress behind the buckling stress, imperfections included", "rule", "..."),
        _v("buckling_stress", "Pa", "axial stress at which the shell buckles, yielding included", "rule", "..."),
        _v("elastic_knockdown_factor", "1", "elastic buckling stress over the classical stress", "rule", "..."),
        _v("knockdown_factor", "1", "buckling stress over the classical stress", "rule", "..."),
        _v("buckling_mode", "1", "how the shell buckles", "rule", "..."),
        _v("youngs_modulus", "Pa", "Young's modulus of the shell", "..."),
        _v("yield_stress", "Pa", "yield stress of the shell", "..."),
        _v("shell_radius", "m", "radius of the shell's middle surface", "..."),
        _v("thickness", "m", "thickness of the shell", "..."),
        _v("bay_length", "m", "ring spacing, or the whole length without rings", "..."),
        _v("ring_area", "m2", "area of one ring, 0 without rings", "..."),
        _v("test_lower_buckling_stress", "Pa", "measured collapse stress, lower value", "..."),
        _v("test_upper_buckling_stress", "Pa", "measured collapse stress, upper value", "..."),
        _v("test_scale", "1", "small or large test", "..."),
        _v("test_material", "1", "material letter of the test", "..."),
        _v("test_collapse", "1", "observed collapse: G general, L local, empty where not said", "..."),
        _v("test_total_length", "m", "length between end plates, where printed", "..."),
        _v("chart_long_coefficient", "1", "Miller's C of a long shell", "chart_making", "chart_slenderness"),
        _v("chart_short_coefficient", "1", "Miller's J of a short shell", "chart_making", "chart_slenderness"),
        _v("chart_local_coefficient", "1", "Miller's C", "chart_making", "chart_slenderness", "chart_relative_length"),
        _v("chart_ring_coefficient", "1", "Miller's C_3", "chart_making", "chart_slenderness", "chart_ring_area_ratio"),
        _v("chart_strength_ratio", "1", "Miller's buckling stress over yield stress", "chart_elastic_ratio"),
        _v("chart_making", "1", "Miller's kind of shell", "chart_making"),
        _v("chart_slenderness", "1", "R/t", "chart_slenderness"),
        _v("chart_relative_length", "1", "M = L / sqrt(R t)", "chart_relative_length"),
        _v("chart_ring_area_ratio", "1", "ring area over bay area L t", "chart_ring_area_ratio"),
        _v("chart_elastic_ratio", "1", "elastic stress over yield stress", "chart_elastic_ratio"),
        _v("axial_force_source", "1", "what the axial wall force follows from", "method", "phase"),
        _v("carried_share", "1", "axial wall force at the transition over the contents' weight", "method", "phase", "..."),
        _v("lower_internal_pressure", "Pa", "smallest pressure that a method guarantees", "method", "...", "depth"),
        _v("upper_internal_pressure", "Pa", "largest pressure of a method", "method", "...", "depth"),
        _v("wall_thickness", "m", "thickness of the strake", "...", "depth"),
        _v("axial_wall_stress", "Pa", "axial stress in the wall, compression positive", *OVER_DEPTH),
        _v("wall_buckling_stress", "Pa", "axial stress at which the wall buckles", *BY_RULE),
        _v("wall_buckling_mode", "1", "how the wall buckles", *BY_RULE),
        _v("utilisation", "1", "axial stress times safety factor over buckling stress", "rule", *OVER_DEPTH),
        _v("required_thickness", "m", "wall thickness that the largest load of all phases asks for", *BY_RULE),
        _v("rule", "1", "buckling rule", "rule"),
        _v("rule_title", "1", "name of the rule for people", "rule"),
        _v("rule_colour", "1", "colour of the rule in figures", "rule"),
        _v("rule_marker", "1", "marker of the rule in figures", "rule"),
        _v("rule_line", "1", "line style of the rule in figures", "rule"),
        _v("disc_radius", "m", "radius of the disc", "disc"),
        _v("disc_mass", "kg m-1", "mass of the disc per metre thickness", "disc"),
        _v("snapshot_time", "s", "time since the start of the run", "snapshot"),
        _v("disc_x", "m", "place across, from the left wall", "snapshot", "disc"),
        _v("disc_y", "m", "place upward, from the floor", "snapshot", "disc"),
        _v("disc_u", "m s-1", "velocity across", "snapshot", "disc"),
        _v("disc_v", "m s-1", "velocity upward", "snapshot", "disc"),
        _v("disc_spin", "rad s-1", "spin, counter-clockwise positive", "snapshot", "disc"),
        _v("contact_snapshot", "1", "snapshot that the contact belongs to", "contact"),
        _v("contact_first", "1", "disc of the contact", "contact"),
        _v("contact_second", "1", "other disc of the contact, or wall counted from 0 where contact_on_wall is 1", "contact"),
        _v("contact_on_wall", "1", "whether the contact is with a wall", "contact"),
        _v("contact_x", "m", "place of the contact across", "contact"),
        _v("contact_y", "m", "place of the contact upward", "contact"),
        _v("contact_force_x", "N m-1", "force across on the contact's disc", "contact"),
        _v("contact_force_y", "N m-1", "force upward on the contact's disc", "contact"),
        _v("stress", "Pa", "coarse-grained stress, compression positive", "snapshot", "cell_y", "cell_x", "way", "of"),
        _v("cell_x", "m", "middle of the stress cell across", "cell_x"),
        _v("cell_y", "m", "middle of the stress cell upward", "cell_y"),
        _v("window_time", "s", "end of the window in which wall forces of every step are gathered", "window"),
        *(
            _v(
                f"wall_{way}_force_{what}",
                "N m-1",
                f"{text} force on the wall cell, {what} over the window",
                "window",
                "wall_cell",
            )
            for way, text in (("normal", "normal"), ("shear", "shear (carrying the solid positive)"))
            for what in ("mean", "min", "max")
        ),
        _v("wall_name", "1", "wall of the cell", "wall_cell"),
        _v("wall_cell_x", "m", "middle of the wall cell across; the two ends of a wall have a cell each", "wall_cell"),
        _v("wall_cell_y", "m", "middle of the wall cell upward", "wall_cell"),
        _v("wall_cell_length", "m", "length of the wall cell, 0 for an end", "wall_cell"),
        _v("energy", "J m-1", "entry of the energy ledger at the end of the window", "window", "energy_entry"),
        _v("energy_entry", "1", "entry of the energy ledger", "energy_entry"),
        _v("discharge_time", "s", "time at which discs were counted as discharged", "discharge"),
        _v("discharged_mass", "kg m-1", "mass discharged up to then", "discharge"),
        _v("event_time", "s", "time of the event", "event"),
        _v("event_action", "1", "what happened", "event"),
        _v("relative_depth", "1", "depth over the depth of the transition", "relative_depth"),
        _v("tube_radius", "m", "mid-wall radius of the tube", "..."),
        _v("tube_thickness", "m", "thickness of the tube's wall", "..."),
        _v("tube_height", "m", "height of the tube above its base", "..."),
        _v("fill_height", "m", "height of the contents", "..."),
        _v("mass_ratio", "1", "contents' mass over the mass of the wall beside them", "..."),
        _v("unreduced_frequency", "Hz", "first frequency of the empty tube with its whole stiffness", "..."),
        _v("empty_frequency", "Hz", "measured first frequency of the empty tube", "..."),
        _v("stiffness_reduction", "1", "share of the stiffness that the empty frequency leaves (alpha)", "..."),
        _v("damping_ratio", "1", "damping ratio of every mode", "..."),
        _v("base_motion", "1", "record that moves the base, and what was done to it", "..."),
        _v("measured_origin", "1", "where the measured response comes from", "..."),
        _v("coefficient", "1", "effective mass coefficient tried", "coefficient"),
        _v("candidate_frequency", "Hz", "first frequency for the coefficient", "...", "coefficient"),
        _v("amplitude_error", "1", "weighted relative error of Fourier amplitudes (E_A)", "...", "coefficient"),
        _v("phase_error", "1", "weighted wrapped phase difference over pi (E_P)", "...", "coefficient"),
        _v("phase_error_as_printed", "1", "E_P divided by the phase, as the source prints it", "...", "coefficient"),
        _v("effective_mass_coefficient", "1", "effective mass coefficient found (C_eff)", "...", "identification"),
        _v("identification", "1", "index and step behind a coefficient", "identification"),
        _v("uncertainty", "1", "half-width within which the fine E_A answer is stated", "..."),
        _v("coarse_uncertainty", "1", "half-width within which the coarse E_A answer is stated", "..."),
        _v("uncertainty_contribution", "1", "what moves the fine E_A answer, as half-widths", "...", "contribution"),
        _v("contribution", "1", "what moves the answer", "contribution"),
        _v("recovery_truth", "1", "coefficient of the synthetic response", "...", "trial"),
        _v("recovery_answer", "1", "coefficient found again by E_A", "...", "trial"),
        _v("recovery_uncertainty", "1", "half-width stated with the coefficient found again", "...", "trial"),
        _v("recovery_coverage", "1", "share of trials whose truth lies within the stated half-width", "..."),
        _v("shown_coefficient", "1", "effective mass coefficient of a history", "shown_coefficient"),
        _v("elapsed_time", "s", "time since the first sample, at the model's scale", "...", "sample"),
        _v("base_acceleration", "m s-2", "acceleration of the base", "...", "sample"),
        _v("measured_acceleration", "m s-2", "measured absolute acceleration of the top", "...", "sample"),
        _v("top_acceleration", "m s-2", "computed absolute acceleration of the top", "...", "shown_coefficient", "sample"),
        _v("spectrum_frequency", "Hz", "frequency of a Fourier component", "...", "bin"),
        _v("measured_spectrum", "m s-1", "Fourier amplitude of the measured top acceleration", "...", "bin"),
        _v("top_spectrum", "m s-1", "Fourier amplitude of the top acceleration", "...", "shown_coefficient", "bin"),
        _v("frequency", "Hz", "frequency of the sine", "frequency"),
        _v("sine_coefficient", "1", "effective mass coefficient behind a resonance curve", "...", "curve"),
        _v("sine_frequency", "Hz", "first frequency behind a resonance curve", "...", "curve"),
        _v("resonance", "m s-2", "amplitude of the top acceleration in a steady sine", "...", "curve", "frequency"),
        _v("curve", "1", "filling behind a resonance curve", "curve"),
        _v("sine_stiffness_reduction", "1", "stiffness reduction from the sine sweep on the empty tube", "..."),
        _v("sine_damping_ratio", "1", "damping ratio of every mode in the sine sweep", "..."),
        _v("sine_base_acceleration", "m s-2", "amplitude of the base's acceleration in the sine sweep", "..."),
        _v("sine_coefficient_bound", "1", "coefficients that the rounding of both frequencies allows", "...", "bound"),
        _v("bound", "1", "lower or upper end", "bound"),
        _v("mass_choice", "1", "how much of the contents moves with the wall", "mass_choice"),
        _v("mass_choice_coefficient", "1", "effective mass coefficient of the choice", "...", "mass_choice"),
        _v("wall_shear_force", "N", "largest shear force in the wall", "...", "mass_choice", "depth"),
        _v("wall_bending_moment", "N m", "largest bending moment in the wall", "...", "mass_choice", "depth"),
        _v(
            "seismic_axial_wall_force",
            "N m-1",
            "largest axial wall force per metre of perimeter from the bending moment",
            *("...", "mass_choice", "depth"),
        ),
        _v("wall_acceleration", "m s-2", "largest absolute acceleration of the wall", "...", "mass_choice", "depth"),
        _v(
            "seismic_wall_pressure",
            "Pa",
            "additional wall pressure of EN 1998-4 at the wall's largest acceleration, in the direction of motion",
            *("...", "mass_choice", "depth"),
        ),
        _v("base_shear", "N", "largest shear force at the base", "...", "mass_choice"),
        _v("base_moment", "N m", "largest bending moment at the base", "...", "mass_choice"),
        _v("top_peak", "m s-2", "largest top acceleration, true peak between samples included", "...", "mass_choice"),
        _v("top_peak_sampled", "m s-2", "largest top acceleration at the record's own samples", "...", "mass_choice"),
        _v("code_contents_share", "1", "share of the contents that EN 1998-4's pressure stands for", "..."),
    )
}
# depth is an axis in one study and a field over the axes in another, so its dimensions are free
DEPTH = Variable("depth", "m", "depth below the equivalent flat surface of the stored solid", ())


def check(cube: xr.Dataset) -> xr.Dataset:
    """The cube itself, if every variable is known with its unit and dimensions; BadInput otherwise."""
    axes = cube.attrs.get("sweep_axes", "").split()
    for name in map(str, cube.variables):
        dims, units = tuple(map(str, cube[name].dims)), cube[name].attrs.get("units", "1")
        known = DEPTH if name == "depth" else VARIABLES.get(name.removesuffix("_scope"))
        if known is None:
            if not set(dims) <= set(axes):  # coordinates of the sweep axes carry the study's own names
                raise BadInput("variable", name, f"not in the cube's contract; known: {', '.join(VARIABLES)}, depth")
        elif known is not DEPTH and dims != expected_dims(known, cube):
            raise BadInput(f"dimensions of {name}", dims, f"must be {expected_dims(known, cube)}")
        elif units != known.units and not name.endswith("_scope"):
            raise BadInput(f"units of {name}", units, f"must be {known.units}")
    return cube


def expected_dims(variable: Variable, cube: xr.Dataset) -> tuple[str, ...]:
    """The variable's dimensions with '...' replaced by the cube's sweep axes and depth by the cube's kind of depth."""
    filled: list[str] = []
    for dim in variable.dims:
        if dim == "...":
            filled += cube.attrs.get("sweep_axes", "").split()
        else:
            filled.append("relative_depth" if dim == "depth" and "relative_depth" in cube.dims else dim)
    return tuple(filled)
