"""Command `silostudy bench spheres`: the engine and LAMMPS in turn, on the same bin of spheres, law and step."""

from silostudy.accuracy.bin_of_spheres import Bin, bin_of_spheres
from silostudy.commands.bench_dem import has_peer, in_turn, show
from silostudy.commands.own_process import OwnProcess
from silostudy.dem.change import keep_discs, take_walls
from silostudy.dem.leaving import below
from silostudy.dem.run import CHECK_EVERY
from silostudy.scene.space_silo import FLOOR

# spheres, radius of the bin (m), steps that settle, steps a turn
SIZES = {"5 thousand": (5_000, 0.05, 30_000, 1_000), "50 thousand": (50_000, 0.108, 30_000, 100)}
# spheres and radius of the bin (m) that fill it equally deep; steps before, steps a turn
DEEP = ((1_000_000, 0.33), (10_000, 0.033))  # spheres, and radius (m) of the bin that they fill equally deep
DEEP_STEPS = (20_000, 20)  # steps that settle, steps a turn
MOST = {"500 thousand": (500_000, 0.233, 30_000, 10)}
FLOWING = 3  # turns between the opening of the outlet and the first reading
SKINS = (0.1, 0.2)  # of a diameter: of the peer's lists; the best of them counts
CHEAPER = "gran/hertz/history"  # a law of the peer without a restitution


def run(chosen) -> None:
    with_peer, sizes = has_peer(), SIZES | (MOST if chosen.most else {})
    rows = [line for size in sizes.values() for line in compare(size, with_peer)] + threads()
    show(rows + (million() if chosen.most else []), chosen.output)


class OwnSpheres:
    """The engine under the bench's own names."""

    def __init__(self, model, threads=1):
        from silostudy.dem.engine import Engine

        self.engine = Engine(model, threads=threads)

    def step(self, steps):
        """Step on, and drop the spheres that have left, as a scene does; the peer drops them at the end of its box."""
        stop = self.engine.step + steps
        while self.engine.step < stop:
            self.engine.step_to(min(stop, self.engine.step + CHECK_EVERY))
            if (left := below(self.engine, 0.0)).any():
                keep_discs(self.engine, ~left)

    def open_outlet(self):
        take_walls(self.engine, (FLOOR,))

    @property
    def grains(self):
        return self.engine.n

    @property
    def places(self):
        """Places x, y, z (m) of the spheres."""
        return self.engine.places

    @property
    def nbytes(self) -> int:
        """Bytes of all arrays."""
        return self.engine.nbytes

    @property
    def contacts(self) -> float:
        """Listed pairs a sphere."""
        self.engine.list_contacts()  # none are after spheres were dropped
        return sum(part.pairs.begin[self.engine.blocks_of(part)] for part in self.engine.parts) / self.engine.n


def ours_of(of: Bin) -> OwnSpheres:
    """The engine with a bin."""
    return OwnSpheres(bin_of_spheres(of))


def peer_of(of: Bin, *args):
    """LAMMPS with a bin."""
    from silostudy.accuracy.peer_of_spheres import LammpsSpheres

    return LammpsSpheres(of, bin_of_spheres(of), *args)


def compare(size: tuple, with_peer: bool) -> list[dict]:
    """Both codes, settled and discharging, in turn, by CPU time, each in a process of its own."""
    count, wide, settle, steps = size
    of = Bin(count=count, wide=wide)
    ours = OwnProcess(ours_of, of)
    ours.step(settle)
    codes = {"silostudy": ours} | (peers_of(of, ours.get("places"), steps) if with_peer else {})
    rows = []
    for phase in ("settled", "discharging"):
        if phase == "discharging":
            for code in codes.values():
                code.call("open_outlet")
                code.step(FLOWING * steps)
        rows += beside(in_turn(codes, phase, steps, OwnProcess.step), ours)
    for code in codes.values():
        code.close()
    return rows


def peers_of(of: Bin, places, steps: int) -> dict:
    """LAMMPS with the same law at each skin, and with a cheaper one."""
    laws = {f"LAMMPS, skin {skin:g} d": ("granular", skin) for skin in SKINS} | {"LAMMPS, a cheaper law": (CHEAPER, SKINS[-1])}
    codes = {name: OwnProcess(peer_of, of, places, law, skin * of.diameter) for name, (law, skin) in laws.items()}
    for code in codes.values():
        code.step(steps)
    return codes


def beside(rows: list[dict], ours: OwnProcess) -> list[dict]:
    """Rows with the rate of the engine over each code's, and what a sphere costs."""
    for row in rows:
        row["ratio"] = rows[0]["particle_steps_per_s"] / row["particle_steps_per_s"]
        row["ns_per_particle_step"] = 1e9 / row["particle_steps_per_s"]
    rows[0]["listed_pairs_per_sphere"] = ours.get("contacts")
    rows[0]["bytes_per_sphere"] = ours.get("nbytes") / ours.grains
    return rows


def million() -> list[dict]:
    """A million spheres beside ten thousand, in turn, in bins equally deep; the ratio is of their costs a particle-step."""
    codes = {f"silostudy, {count} spheres": OwnProcess(ours_of, Bin(count=count, wide=wide)) for count, wide in DEEP}
    for code in codes.values():
        code.step(DEEP_STEPS[0])
    rows = in_turn(codes, "settled", DEEP_STEPS[1], OwnProcess.step)
    for line, code in zip(rows, codes.values(), strict=True):
        line["ratio"] = rows[-1]["particle_steps_per_s"] / line["particle_steps_per_s"]
        line["listed_pairs_per_sphere"], line["bytes_per_sphere"] = code.get("contacts"), code.get("nbytes") / code.grains
        code.close()
    return rows


def threads() -> list[dict]:
    """Fifty thousand spheres on one thread and on two, in turn; the ratio is to one thread, by the clock on the wall."""
    count, wide, _, steps = SIZES["50 thousand"]
    codes = {
        f"silostudy, {number} threads": OwnSpheres(bin_of_spheres(Bin(count=count, wide=wide)), number) for number in (2, 1)
    }
    for code in codes.values():
        code.step(3_000)
    return in_turn(codes, "falling", steps)
