"""A scene of spheres in LAMMPS: start, rain, step, laws and events of a run of the engine, which says when they happened."""

from collections import defaultdict
from collections.abc import Callable
from functools import partial

import numpy as np

from silostudy.accuracy.arrivals import Arrival
from silostudy.accuracy.grains_in_lammps import GrainsInLammps
from silostudy.accuracy.laws_in_lammps import CannotSay, Way, words
from silostudy.accuracy.walls_in_lammps import regions
from silostudy.config.spheres import SphereScene
from silostudy.dem.feeder import DOWN
from silostudy.dem.moves import OF_LID
from silostudy.dem.outcomes import Looks
from silostudy.dem.run import CHECK_EVERY, Run
from silostudy.dem.space.model import SphereModel
from silostudy.scene.spheres import space_silo_of

SEED = 1  # of the order in which its feeder takes spheres
Act = Callable[[], None]


class SceneInLammps:
    """A scene in LAMMPS, told in a way; run: of the engine, at its end; came: the spheres that came in on its way."""

    def __init__(self, scene: SphereScene, run: Run, came: list[Arrival], way: Way):
        if scene.other_grains or scene.pairs or scene.surfaces:
            raise CannotSay("contacts that differ by kind or surface are not told here")
        assert isinstance(run.engine.model, SphereModel)
        self.run, self.model, self.space = run, run.engine.model, space_silo_of(scene)
        self.regions = regions(self.model.walls)
        pair, self.wall = words(scene, way, float(self.model.radius.mean()))
        self.step, self.flows, self.load, self.momentum = 0, False, np.nan, np.nan
        self.there: set[int] = set()
        self.seen: list[tuple[float, np.ndarray, np.ndarray]] = []  # times (s), places and radii (m)
        self.out: list[tuple[float, float]] = []  # s at which a sphere was seen to be out, and its mass (kg)
        self.due = self._due(came)
        self.grains = GrainsInLammps(self.model, pair)

    def go(self) -> Looks:
        """Carry it to the end; gives what it came to."""
        for name in self.regions:
            self._fix(name)
        self._act()
        while self.step < self.run.engine.step:
            following = min(step for step in self.due if step > self.step)
            following = min(following, (self.step // CHECK_EVERY + 1) * CHECK_EVERY) if self.flows else following
            self.grains.step(following - self.step)
            self.step = following
            self._count_out()
            self._act()
        self.grains.close()
        return self._looks()

    def _due(self, came: list[Arrival]) -> dict[int, list[Act]]:
        """List what is to be done at which step, in order."""
        due: dict[int, list[Act]] = defaultdict(list)
        run, end = self.run, self.run.engine.step
        for step in {arrival.step for arrival in came}:
            due[step].append(partial(self._let_in, [arrival for arrival in came if arrival.step == step]))
        for step in run.snapshots:
            due[step].append(self._look)
        if run.window:
            due[end - run.window].append(self._begin_window)
            due[end].append(self._end_window)
        for event, (time, _, _) in zip(run.events, run.recording.happened, strict=True):
            due[round(time / self.model.dt)].append(self._action(event.action, event.what))
        return due

    def _act(self) -> None:
        for act in self.due.get(self.step, ()):
            act()

    def _action(self, action: str, what: tuple) -> Act:
        """Tell what an event does; CannotSay for one that LAMMPS has no words for."""
        known: dict[str, Callable[..., None]] = {
            "open": self._open, "turn": self._turn, "feed": self._feed, "stop": lambda: None
        }  # fmt: skip
        if action in OF_LID:
            raise CannotSay("its walls move as they are told and bear no load: no lid that presses")
        if action not in known:
            raise CannotSay(f"the event {action} is not told here")
        return partial(known[action], *what)

    def _fix(self, name: str, turned: str = "") -> None:
        self.grains.command(f"""
            region {name} {self.regions[name]} {turned}
            fix {name} all wall/gran/region granular {self.wall} region {name}
            """)

    def _open(self, name: str) -> None:
        self.grains.command(f"unfix {name}")
        self.flows = True

    def _turn(self, spin: float, *names: str) -> None:
        self.grains.command(f"variable turn equal {spin:.17g}*{self.model.dt:.17g}*(step-{self.step})")
        for name in names:
            self.grains.command(f"unfix {name}\nregion {name} delete")
            self._fix(name, "rotate v_turn 0 0 0 0 0 1")

    def _feed(self, rate: float) -> None:
        """One sphere near the plug is taken, any of them, as often as the rate (kg/s) asks for."""
        (outline,) = self.space.openings.values()
        reach = (1.0 + DOWN) * float(self.model.radius.max())
        self.grains.command(f"""
            region fed cylinder z 0 0 {outline.half[0]} 0 {reach}
            fix feeder all evaporate {round(float(self.model.mass.mean()) / rate / self.model.dt)} 1 fed {SEED}
            """)
        self.flows = True

    def _let_in(self, arrivals: list[Arrival]) -> None:
        numbers, places, velocities = (np.array([arrival[k] for arrival in arrivals]) for k in (1, 2, 3))
        self.grains.put(numbers, places, velocities)
        self.there |= set(numbers.tolist())

    def _look(self) -> None:
        self.seen.append((self.step * self.model.dt, self.grains.places, self.model.radius[self.grains.numbers]))

    def _begin_window(self) -> None:
        self.momentum = self._upward_momentum()

    def _end_window(self) -> None:
        """Mean load (N) of the window: the weight, and what the spheres' momentum tells beside it."""
        weight = -self.model.gravity[2] * float(self.model.mass[self.grains.numbers].sum())
        self.load = weight + (self._upward_momentum() - self.momentum) / (self.run.window * self.model.dt)

    def _upward_momentum(self) -> float:
        return float(self.model.mass[self.grains.numbers] @ self.grains.velocities[:, 2])

    def _count_out(self) -> None:
        """Count the spheres that the feeder took, and take those that are out below the silo."""
        if not self.flows:
            return
        numbers, places = self.grains.numbers, self.grains.places
        low = (places[:, 2] < -self.model.radius[numbers]) & ~self.model.space.beside(self.model.walls, places)
        gone = (self.there - set(numbers.tolist())) | set(numbers[low].tolist())
        self.out += [(self.step * self.model.dt, float(self.model.mass[number])) for number in gone]
        self.there -= gone
        if low.any():
            self.grains.take(numbers[low])

    def _looks(self) -> Looks:
        weight = np.array(self.model.gravity)
        times, places, radii = zip(*self.seen, strict=True) if self.seen else ((), (), ())
        return Looks(
            places=places, radii=radii, times=times, left_time=np.array([time for time, _ in self.out]),
            left_mass=np.cumsum([mass for _, mass in self.out]), load=self.load,
            up=-weight / np.linalg.norm(weight) if weight.any() else weight,
        )  # fmt: skip
