"""A small model of one perfect cylinder for CalculiX: a sector of quadratic bricks, one through the thickness."""

import re
import subprocess
from pathlib import Path

import numpy as np

# corners of a C3D20R brick, then its mid-side nodes, as steps (radial, circumferential, axial) on a grid of half elements
BRICK = (
    *((0, 0, 0), (2, 0, 0), (2, 2, 0), (0, 2, 0), (0, 0, 2), (2, 0, 2), (2, 2, 2), (0, 2, 2)),
    *((1, 0, 0), (2, 1, 0), (1, 2, 0), (0, 1, 0), (1, 0, 2), (2, 1, 2), (1, 2, 2), (0, 1, 2)),
    *((0, 0, 1), (2, 0, 1), (2, 2, 1), (0, 2, 1)),
)


def buckling_stress(folder: Path, *, radius, thickness, length, sector, around, along, youngs_modulus) -> float:
    """Lowest axial stress at which CalculiX lets the cylinder buckle; nu = 0, so that the stress before is uniform.

    Ends held radially and circumferentially in the middle surface, free to turn; symmetry at the edges of the sector.
    """
    places = [
        (i, j, k)
        for k in range(2 * along + 1)
        for j in range(2 * around + 1)
        for i in range(3)
        if (i % 2) + (j % 2) + (k % 2) <= 1
    ]
    numbers = {place: number for number, place in enumerate(places, 1)}
    lines = ["*NODE, NSET=ALL"]
    for (i, j, k), number in numbers.items():
        r, angle = radius + (i - 1) * thickness / 2, sector * j / (2 * around)
        lines.append(f"{number}, {r * np.cos(angle):.12g}, {r * np.sin(angle):.12g}, {length * k / (2 * along):.12g}")
    lines.append("*ELEMENT, TYPE=C3D20R, ELSET=WALL")
    elements = [(j, k) for k in range(along) for j in range(around)]
    for number, (j, k) in enumerate(elements, 1):
        nodes = [str(numbers[i, 2 * j + b, 2 * k + c]) for i, b, c in BRICK]
        lines.append(f"{number}, " + ", ".join(nodes[:15]) + ",\n" + ", ".join(nodes[15:]))
    lines.append("*TRANSFORM, NSET=ALL, TYPE=C\n0, 0, 0, 0, 0, 1")
    lines.append(f"*MATERIAL, NAME=STEEL\n*ELASTIC\n{youngs_modulus}, 0.0\n*SOLID SECTION, ELSET=WALL, MATERIAL=STEEL")
    lines.append("*BOUNDARY")
    for (i, j, k), number in numbers.items():
        end, edge = i == 1 and k in (0, 2 * along), j in (0, 2 * around)
        lines += [f"{number}, 1"] * end + [f"{number}, 2"] * (end or edge) + [f"{number}, 3"] * (i == 1 and k == 0)
    lines.append("*STEP\n*BUCKLE\n4, 1e-6, 40, 1000\n*DLOAD")
    ends = ((0, "P1"), (along - 1, "P2"))
    lines += [f"{n}, {face}, 1.0" for n, (_, k) in enumerate(elements, 1) for end, face in ends if k == end]
    lines.append("*NODE FILE\nU\n*END STEP")
    (folder / "cylinder.inp").write_text("\n".join(lines) + "\n")
    subprocess.run(["ccx", "cylinder"], cwd=folder, check=True, capture_output=True, timeout=300)
    found = re.search(r"FACTOR\s+1\s+([-+.\dE]+)", (folder / "cylinder.dat").read_text())
    assert found, "CalculiX gave no buckling factor"
    return float(found[1])
