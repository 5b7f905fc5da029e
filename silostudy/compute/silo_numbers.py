"""Numbers that a reader of a cube needs to follow it: the silo's sizes, its contents, and where the properties come from."""

from collections.abc import Sequence

import numpy as np

from silostudy.compute.evaluate import AskedMethod
from silostudy.cube.variables import flags
from silostudy.pressure.en1991_4.classes import capacity
from silostudy.scene.expand import Expansion
from silostudy.scene.origin import ORIGINS, PROPERTIES, origins

SIZES = {
    "given_diameter": "diameter",
    "given_filled_height": "wall_depth",
    "given_heap_height": "top_cone_height",
    "given_filling_eccentricity": "filling_eccentricity",
    "given_outlet_eccentricity": "outlet_eccentricity",
    "given_volume": "volume",
    "given_assessment_class": "assessment_class",
    "given_plan": "plan",
}


def silo_variables(expansion: Expansion, methods: Sequence[AskedMethod]) -> dict:
    """Sizes and kinds of every case, and the origin of every property by method."""
    scenes = [case.scene for case in expansion.cases]
    numbers = {name: _of_cases(expansion, [getattr(scene.silo, own) for scene in scenes]) for name, own in SIZES.items()}
    numbers["given_slenderness"] = _of_cases(expansion, [scene.silo.cylinder_depth / scene.silo.diameter for scene in scenes])
    capped = [float(scene.characteristic_friction == "capped") for scene in scenes]
    numbers["given_friction_capped"] = _of_cases(expansion, capped)
    numbers["given_dynamic_bottom"] = _of_cases(expansion, [float(scene.silo.dynamic_bottom) for scene in scenes])
    numbers["given_contact_share"] = _of_cases(expansion, [scene.contact_share for scene in scenes])
    numbers["given_solid"] = _of_cases(expansion, [scene.solid.key for scene in scenes])
    numbers["given_wall"] = _of_cases(expansion, [scene.wall.key if scene.wall else "" for scene in scenes])
    numbers["given_hopper_wall"] = _of_cases(
        expansion, [scene.hopper_wall.key if scene.hopper_wall else "" for scene in scenes]
    )
    return numbers | _origins(expansion, methods, scenes)


def contents_mass(expansion: Expansion, given: Sequence) -> np.ndarray:
    """Mass (kg) of the contents with the unit weight handed to each method, (method, axes...)."""
    volume = _of_cases(expansion, [case.scene.silo.volume for case in expansion.cases])
    return np.array([capacity(volume=volume, unit_weight=parameters["unit_weight"][..., 0]) for parameters in given])


def _origins(expansion: Expansion, methods: Sequence[AskedMethod], scenes) -> dict:
    numbers_of = [
        [origins(scene, method.row.table_key or method.row.key, method.row.varies) for scene in scenes] for method in methods
    ]
    numbers = np.array(numbers_of, dtype=np.int8).reshape(len(methods), *expansion.shape, len(PROPERTIES))
    told = flags("where the property handed to the method comes from", ORIGINS)
    return {"solid_property": list(PROPERTIES), "property_origin": (numbers, told)}


def _of_cases(expansion: Expansion, values: list) -> np.ndarray:
    return np.array(values).reshape(expansion.shape)
