"""An input deck of CalculiX: a silo's wall and hopper as shells on a skirt, under the nodal forces of a load case.

At the edge of two strakes the nodes have the mean thickness: a step within one smooth shell of S4 makes CalculiX 2.20 stop.
"""

from collections.abc import Iterator

import numpy as np

from silostudy.compute.finite_elements import Mesh, mesh, nodal_forces
from silostudy.cube.load import Load
from silostudy.errors import BadInput
from silostudy.scene.scene import Scene

HELD = "HELD"
LAW = "MATERIAL=STEEL"


def deck(load: Load, scene: Scene, *, size: float) -> str:
    """The text of the deck, of elements of about a size (m); BadInput where the silo has no steel to be modelled."""
    on = _mesh(load, scene, size)
    lines = [*_head(load, on), *_shells(on), *_steel(scene, on), *_step(nodal_forces(load, on), on)]
    return "\n".join(lines) + "\n"


def _mesh(load: Load, scene: Scene, size: float) -> Mesh:
    wall, hopper = getattr(scene, "shell", None), getattr(scene, "steelwork", {}).get("hopper_thickness", np.nan)
    if wall is None or not wall.edges:
        raise BadInput("scene.shell.strakes", None, "is needed: a deck is for a shell study whose wall is given in strakes")
    if scene.silo.hopper and np.isnan(hopper):
        raise BadInput("scene.hopper_shell", None, "is needed: the hopper's thickness for its shells")
    feet = scene.silo.contact_depth + np.array(wall.edges) * scene.silo.wall_depth
    return mesh(load, (feet, np.array(wall.thicknesses)), size=size)


def _head(load: Load, on: Mesh) -> Iterator[str]:
    nodes = on.nodes
    yield "*HEADING"
    yield f"{load.title}; x towards the outlet's side, z up from the equivalent surface; m, N, Pa; own weight left out"
    yield "*NODE, NSET=ALL"
    for ring in range(len(nodes)):
        for angle in range(len(on.angles)):
            x, y, z = nodes[ring, angle]
            yield f"{on.number(ring, angle)}, {x:.9g}, {y:.9g}, {z:.9g}"
    yield f"*NSET, NSET={HELD}"
    yield from (f"{on.number(len(on.depths), angle)}," for angle in range(len(on.angles)))


def _shells(on: Mesh) -> Iterator[str]:
    """The elements of wall, hopper and skirt, numbered one after the other."""
    number = 0
    for part, rows in on.rows.items():
        if rows:
            yield f"*ELEMENT, TYPE=S4, ELSET={part}"
        for upper, lower in rows:
            for nodes in on.elements(upper, lower):
                number += 1
                yield f"{number}, {', '.join(map(str, nodes))}"


def _steel(scene, on: Mesh) -> Iterator[str]:
    """The material; thicknesses at the nodes of the wall, of one number in the hopper and the skirt."""
    steel, foot = scene.shell.steel, on.thickness[-1]
    yield from ("*MATERIAL, NAME=STEEL", "*ELASTIC", f"{steel['youngs_modulus']:.9g}, {steel['shell_poisson_ratio']:.9g}")
    yield from (f"*SHELL SECTION, ELSET=WALL, {LAW}, NODAL THICKNESS", f"{foot:.9g}")
    yield from (f"*SHELL SECTION, ELSET=SKIRT, {LAW}", f"{foot:.9g}")
    if on.rows["HOPPER"]:
        yield from (f"*SHELL SECTION, ELSET=HOPPER, {LAW}", f"{scene.steelwork['hopper_thickness']:.9g}")
    yield "*NODAL THICKNESS"
    for ring, thickness in enumerate(on.thickness):
        yield from (f"{on.number(ring, angle)}, {thickness:.9g}" for angle in range(len(on.angles)))


def _step(forces: np.ndarray, on: Mesh) -> Iterator[str]:
    """A linear step; the reactions of the held ring are summed in the .dat file."""
    yield from ("*BOUNDARY", f"{HELD}, 1, 3", "*STEP", "*STATIC", "*CLOAD")
    for ring in range(len(forces)):
        for angle in range(len(on.angles)):
            for axis, force in enumerate(forces[ring, angle], 1):
                if force != 0:
                    yield f"{on.number(ring, angle)}, {axis}, {force:.9g}"
    yield from (f"*NODE PRINT, NSET={HELD}, TOTALS=ONLY", "RF", "*NODE FILE", "U", "*EL FILE", "S", "*END STEP")
