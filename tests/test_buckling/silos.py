"""The steel wheat silo that several tests of faults share, with changes."""

import yaml

from silostudy.buckling import BUCKLING
from silostudy.buckling.family import REASONS, evaluate
from silostudy.compute.pressure import pressure_cube
from silostudy.compute.shell import shell_cube
from tests.conftest import ROOT, expanded
from tests.test_buckling.shells import shell

EN = ("en1993_1_6_2007", "en1993_1_6_2025", "en1993_4_1_2007", "en1993_4_1_2025")
WHEAT = {"unit_weight": 9e3, "wall_friction": 0.38, "lateral_pressure_ratio": 0.54}
SAFETY = 1.65


def study(rules=EN, methods=("janssen",), sweep=(), levels=41, steel=None, **scene):
    """The steel wheat silo by Janssen, without the steel's own weight."""
    content = yaml.safe_load((ROOT / "config/studies/steel-wheat-strakes.yaml").read_text(encoding="utf-8"))
    content["scene"] |= scene
    content["scene"]["shell"] |= {"strakes": [], "density_kg_m3": 0.0} | (steel or {})
    content |= {"rules": list(rules), "methods": list(methods), "sweep": list(sweep), "outputs": []}
    content.pop("depth_m")
    return content | {"relative_depth": {"start": 0.0, "stop": 1.0, "count": levels}}


def cube_from(content):
    expansion = expanded(content)
    return shell_cube(expansion, pressure_cube(expansion)).squeeze("pressure_method")


def cube_of(**changes):
    return cube_from(study(**changes))


def thickness_mm(cube):
    return cube["largest_required_thickness"].values * 1e3


def strength(rule, **changes):
    return float(evaluate(BUCKLING[rule], shell(**changes))["buckling_stress"])


def reason(rule, **changes):
    return REASONS[int(evaluate(BUCKLING[rule], shell(**changes))["buckling_stress_scope"])]


SQUAT = {"plan": "circular", "diameter_m": 30.0, "slenderness": 1.0}
