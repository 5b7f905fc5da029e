"""Weight = vertical pressure + wall friction, to rounding, for each method that claims it, over random scenes."""

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from silostudy.pressure import PRESSURE
from silostudy.pressure.calls import call

CLAIMS = [(row.key, phase) for row in PRESSURE.values() for phase in row.equilibrium]


@st.composite
def scenes(draw):
    diameter = draw(st.floats(0.1, 50))
    depth = diameter * draw(st.floats(-3, 2).map(lambda e: 10**e))
    phi, cone = np.radians(draw(st.floats(5, 60))), diameter * draw(st.floats(0, 0.5))
    return {
        "unit_weight": draw(st.floats(1e3, 5e4)),
        "internal_friction_angle": phi,
        "wall_friction": np.tan(phi) * draw(st.floats(1e-9, 1.0)),
        "lateral_pressure_ratio": draw(st.floats(0.05, 2)),
        "poisson_ratio": draw(st.floats(0, 0.49)),
        "hydraulic_radius": diameter / 4,
        "diameter": diameter,
        "cylinder_depth": depth,
        "outlet_depth": depth + diameter * draw(st.floats(0, 2)),
        "top_cone_height": cone,
        "powder": draw(st.sampled_from([0.0, 1.0])),
        "i_phi": 0.5,
        "unit_weight_lower": 1e3,
        "slot": 0.0,
        "hopper_half_angle": np.nan,
        "contact_depth": cone / 3,
        "sets_capped": draw(st.sampled_from([0.0, 1.0])),
        "contact_share": draw(st.one_of(st.just(1.0), st.floats(0.05, 1))),
        "largest_particle": np.nan,
        "repose_angle": np.radians(draw(st.floats(5, 60))),
        "a_phi": draw(st.floats(1, 1.3)),
        "a_K": draw(st.floats(1, 1.5)),
        "a_mu": draw(st.floats(1, 1.4)),
    }


def test_some_methods_claim_it():
    assert {"janssen", "reimbert", "caquot", "din1055_1964"} <= {key for key, _ in CLAIMS}


@pytest.mark.parametrize(("method", "phase"), CLAIMS)
@settings(max_examples=120, deadline=None)
@given(scene=scenes(), share=st.floats(1e-6, 1))
def test_vertical_equilibrium(method, phase, scene, share):
    functions = PRESSURE[method].bounded(phase)
    z = scene["top_cone_height"] / 3 + share * scene["cylinder_depth"]
    own_weight = PRESSURE[method].totals.get(phase, {}).get("design_unit_weight")
    weight = (call(own_weight, None, scene) if own_weight else scene["unit_weight"]) * z
    vertical = call(functions["vertical_pressure"], z, scene)
    hung = call(functions["axial_wall_force"], z, scene) / scene["hydraulic_radius"]
    if np.isfinite(vertical):
        largest = max(abs(float(vertical)), float(weight))  # a swelling solid presses with more than its weight
        assert float(vertical + hung) == pytest.approx(float(weight), rel=0, abs=1e-12 * largest)
    else:
        assert method.startswith(("din1055_1964", "reimbert", "en1991_4", "as3774"))
        # DIN's relieved part; a cone too high for Reimbert's c; EN's limits; a swelling solid beyond all numbers


@pytest.mark.parametrize(("method", "phase"), CLAIMS)
def test_axial_force_is_the_integral_of_the_traction(method, phase):
    """Independent of the balance above: Gauss-Legendre over the method's own traction."""
    scene = {
        "unit_weight": 8e3, "internal_friction_angle": 0.5, "wall_friction": 0.4, "lateral_pressure_ratio": 0.45,
        "poisson_ratio": 0.4, "hydraulic_radius": 1.25, "diameter": 5.0, "cylinder_depth": 12.0, "outlet_depth": 20.5,
        "top_cone_height": 1.5, "powder": 0.0, "i_phi": 0.5,
        "unit_weight_lower": 6e3, "slot": 0.0, "repose_angle": 0.6, "a_phi": 1.1, "a_K": 1.2, "a_mu": 1.3,
        "contact_depth": 0.0, "sets_capped": 1.0, "contact_share": 1.0,
    }  # fmt: skip
    functions = PRESSURE[method].phases[phase]
    top, end = (0.5 if method == "reimbert" else 0.0), 12.0
    nodes, weights = np.polynomial.legendre.leggauss(60)
    z = top + (nodes + 1) / 2 * (end - top)
    integral = (end - top) / 2 * np.sum(weights * call(functions["wall_friction_traction"], z, scene))
    assert float(call(functions["axial_wall_force"], np.float64(end), scene)) == pytest.approx(integral, rel=1e-12, abs=0)
