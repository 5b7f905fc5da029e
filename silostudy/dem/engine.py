"""The engine: the arrays of one model and the compiled kernel that steps them, on one thread or several."""

from concurrent.futures import ThreadPoolExecutor

import numpy as np

from silostudy.dem.arrays import (
    BLOCK,
    Blocks,
    Discs,
    Ledger,
    March,
    Memory,
    Share,
    Shared,
    Spheres,
    Table,
    WallRecord,
    Walls,
    aligned,
)
from silostudy.dem.explosion import explosion_of
from silostudy.dem.integrate import INTEGRATORS
from silostudy.dem.kernel import kernel
from silostudy.dem.ledger import empty
from silostudy.dem.model import Model
from silostudy.dem.neighbours import harvest
from silostudy.dem.part import Part
from silostudy.dem.sweep import EXPLODED, FRESH, REMEMBERED, SHORT_OF_ROOM, STALE
from silostudy.dem.varied import Varied
from silostudy.dem.watch import NOTHING, first_of_faces, owners, record_of
from silostudy.dem.wide import GHOSTS, KEPT_PAIRS, KEPT_WALLS
from silostudy.errors import BadInput

FAR = 1e9  # m: where the pair stands that pads the lists


def sweep_order(place: np.ndarray, radius: np.ndarray) -> np.ndarray:
    """Order of bodies (n, d) in strips across the longer sides of their box: neighbours come close together in memory."""
    sides = place.T[::-1]
    *long, short = sides[np.argsort(-np.ptp(sides, axis=1), kind="stable")]
    strips = [np.floor((side - side.min()) / (2.0 * radius.max())) for side in long]
    return np.lexsort((short, *reversed(strips)))


class Engine:
    """A model in motion.  The number of threads and the skin (m, 0: chosen by the engine) change no bit of what it gives."""

    def __init__(self, model: Model, *, threads: int = 1, skin: float = 0.0, sort: bool = True):
        if threads < 1:
            raise BadInput("threads", threads, "must be 1 or more")
        if not 0.0 <= skin < 2.0 * model.radius.min():
            raise BadInput("skin", skin, "must be less than the smallest diameter")
        self.model, self.space, self.threads, self.skin = model, model.space, threads, skin
        self.most = len(model.radius)
        self.n = self.most - model.waiting
        self.contacts = (model.pair_contact, model.wall_contact)
        self.gravity = model.gravity
        self._quake = model.quake if model.quake is not None else np.zeros((1, len(model.gravity)))
        label = np.arange(self.most)
        if sort and self.n:
            label[: self.n] = sweep_order(model.place[: self.n], model.radius[: self.n])
        self.bodies = self._bodies(label.astype(np.int32))
        self.walls: Walls = self.space.walls_of(model.walls)
        blocks = self.most // BLOCK + 2
        self.blocks = Blocks(*np.zeros((5, blocks)))
        self.clock = np.zeros(2 + threads, np.int64)
        self.ticks = self.past = model.pace.ticks  # of the steps to come, and of the last that was made
        self.said = np.full(threads, REMEMBERED)
        self.gate = np.zeros(2, np.int64)
        self.parts = [Part(self, number) for number in range(threads)]
        self.record = self._record()
        self.ledger = self._ledger()
        self._pool = ThreadPoolExecutor(threads - 1) if threads > 1 else None
        self._kernel = kernel(model.pieces)

    def _ledger(self) -> Ledger:
        if not self.model.booked:
            return empty(self.space, 0, 0, 0)
        if self.threads > 1:
            raise BadInput("threads", self.threads, "the energy balance sums in one order: use 1 thread")
        fresh = empty(self.space, len(self.bodies.rows), self.parts[0].room, self.parts[0].wall_room)
        return fresh._replace(account=self.ledger.account) if hasattr(self, "ledger") else fresh

    def _bodies(self, label: np.ndarray) -> Discs | Spheres:
        model, space, unequal = self.model, self.space, self.model.unequal
        ghosts = self.threads * (2 + (0 if self.threads == 1 else 1024 + 8 * int(self.most**0.5)))
        rows = aligned(self.most + ghosts, space.row)
        for lanes, values in ((space.place, model.place), (space.velocity, model.velocity), (space.spin, model.spin)):
            rows[: self.most, lanes] = values[label]
        radius = model.radius[label] if unequal else model.radius[:1].copy()
        mass = model.mass[label] if unequal else model.mass[:1].copy()
        holds = INTEGRATORS[model.integrator].holds
        held = aligned(self.most if holds else 0, space.row // 2)
        rates = (*space.velocity, *space.spin)
        held[:, : len(rates)] = rows[: len(held), rates]
        kind = np.zeros(1, np.int32) if model.kind is None else model.kind[label].astype(np.int32)
        return space.bodies(rows, held, radius, mass, 1.0 / mass, space.inverse_inertia / (mass * radius**2), label, kind)

    def _record(self) -> WallRecord:
        room = max(part.wall_room for part in self.parts)
        watched = self.model.pieces.watched
        cells = self.space.cell_count(self.model.walls) if watched else 0
        first = first_of_faces(self.walls.cells) if watched else np.zeros(0, int)
        return record_of(owners(first, cells), len(first), self._felt, self.threads, room)

    @property
    def _felt(self) -> int:
        return int(self.space.felt(self.model))

    @property
    def lid(self) -> int:
        """Number of the lid among the walls."""
        assert self.model.lid is not None
        return self.model.wall_number(self.model.lid.name)

    @property
    def step(self) -> int:
        """Ticks since the start of the model; of each step one, unless steps follow the contacts."""
        return int(self.clock[0])

    @property
    def time(self) -> float:
        """Time (s) since the start of the model."""
        return self.step * self.model.dt

    @property
    def dt(self) -> float:
        """Time step (s) of the steps to come."""
        return self.ticks * self.model.dt

    @property
    def past_dt(self) -> float:
        """Time step (s) by which the bodies came where they are."""
        return self.past * self.model.dt

    def column(self, lane: int) -> np.ndarray:
        """One number of every disc that is left, in the order of `labels`."""
        return self.bodies.rows[: self.n, lane]

    @property
    def labels(self) -> np.ndarray:
        """Numbers of the discs that are left, in the engine's own order."""
        return self.bodies.label[: self.n]

    def bounds(self, number: int) -> tuple[int, int]:
        """First disc of a thread and first of the next: whole blocks, evenly shared."""
        blocks = (self.n + BLOCK - 1) // BLOCK
        lo, hi = (min(self.n, blocks * k // self.threads * BLOCK) for k in (number, number + 1))
        return lo, hi

    def base(self, part: Part) -> int:
        """First row of a thread's own room beyond the discs: for its ghosts, and for the pair that pads its lists."""
        return self.most + part.number * (part.ghost_room + 2)

    def blocks_of(self, part: Part) -> int:
        """Number of blocks of a thread's discs."""
        lo, hi = self.bounds(part.number)
        return -(-(hi - lo) // BLOCK)

    def true_number(self, part: Part, listed: np.ndarray) -> np.ndarray:
        """The engine's numbers of discs in a thread's list, whose ghosts stand elsewhere."""
        base = self.base(part)
        ghosts = np.append(part.scratch.ghost, [0, 0])  # the padding pair counts as disc 0; it never touches
        return np.where(listed < base, listed, ghosts[np.maximum(listed - base, 0)])

    @property
    def nbytes(self) -> int:
        """Memory (bytes) of all arrays that stepping needs."""
        bundles: list[tuple] = [self.bodies, self.walls, self.blocks, self.record, self.ledger]
        for part in self.parts:
            bundles += [part.pairs, part.near, *part.memories, part.scratch]
        return sum(array.nbytes for bundle in bundles for array in bundle)

    @property
    def radius(self) -> np.ndarray:
        """Radius (m) of every disc that is left, in the engine's own order."""
        return np.broadcast_to(self.bodies.radius[: self.n], self.n)

    @property
    def mass(self) -> np.ndarray:
        """Mass (kg/m) of every disc that is left, in the engine's own order."""
        return np.broadcast_to(self.bodies.mass[: self.n], self.n)

    @property
    def kind(self) -> np.ndarray:
        """Kind of every disc that is left, in the engine's own order."""
        return np.broadcast_to(self.bodies.kind[: self.n], self.n)

    @property
    def places(self) -> np.ndarray:
        """Place (m) of every body by its label; NaN for those that were dropped."""
        places = np.full((self.most, len(self.space.place)), np.nan)
        places[self.labels] = self.bodies.rows[: self.n, self.space.place]
        return places

    def step_to(self, stop: int) -> None:
        """Step to a tick, or over it by a part of a step; raises Explosion where a disc runs away.

        The first step after the step has changed is made by itself: springs stretch by the way of the step before.
        """
        if self.past != self.ticks and self.step < stop:
            self._step_to(self.step + 1)
            self.past = self.ticks
        self._step_to(stop)

    def _step_to(self, stop: int) -> None:
        while True:
            self._run(stop)
            if (self.said == EXPLODED).any():
                raise explosion_of(self)
            if (self.said == FRESH).all():
                return
            for part in self.parts:
                if self.said[part.number] == SHORT_OF_ROOM:
                    part.grow()
                    self.said[part.number] = REMEMBERED
            self._widen_record()

    def take_steps_of(self, ticks: int) -> None:
        """Make steps of so many ticks from now on; what is summed or counted by the step goes on in these."""
        share = self.ticks / ticks
        self.record.window[:, :, 0] *= share
        self.bodies.rows[:, list(self.space.passed)] *= share
        self.ticks = ticks

    def list_contacts(self) -> None:
        """Have the lists made without a step, and the threads' copies of each other's discs stand where those are."""
        self.step_to(self.step)
        for part in self.parts:
            ghosts = part.scratch.ghost[: part.scratch.counts[GHOSTS]]
            motion = self.space.motion
            self.bodies.rows[self.base(part) :][: len(ghosts), :motion] = self.bodies.rows[ghosts, :motion]

    def _widen_record(self) -> None:
        if self.model.booked:
            self.ledger = self._ledger()
        room = max(part.wall_room for part in self.parts)
        if room > self.record.force.shape[1]:
            self.record = self.record._replace(
                force=np.zeros((self.threads, room, self._felt)), cell=np.zeros((self.threads, room), np.int32)
            )

    def _run(self, stop: int) -> None:
        calls = [self._arguments(part, stop) for part in self.parts]
        others = [self._pool.submit(self._kernel, *call) for call in calls[1:]] if self._pool else []
        self._kernel(*calls[0])  # the calling thread takes a share: handing over all of them costs milliseconds
        for done in others:
            done.result()

    def _arguments(self, part: Part, stop: int) -> tuple:
        lo, hi = self.bounds(part.number)
        base = self.base(part)
        self.bodies.rows[base + part.ghost_room, 0] = FAR
        self.bodies.rows[base + part.ghost_room + 1, 0] = -FAR
        smallest = float(self.model.radius.min())
        pair, wall = self.coefficients(part)
        kick = 0.5 * (self.past_dt + self.dt) if INTEGRATORS[self.model.integrator].half_start else self.dt
        steps, lists = (self.dt, self.past_dt, kick, self.ticks), (self.space.ahead, float(self.skin))
        return (
            Shared(
                self.bodies, self.walls, self.blocks, self.record, self.ledger, self._quake, self.clock, self.said, self.gate
            ),
            Share(part.number, part.pairs, part.near, *part.memories, part.scratch, lo, hi, base),
            March(pair, wall, self.gravity, *steps, stop, self.n, self.threads, smallest, self.model.gap, *lists),
        )

    def coefficients(self, part: Part) -> tuple:
        """Coefficients of pairs and of walls as kernels take them."""
        return tuple(
            Table(contact.ordered, part.coefficients) if isinstance(contact, Varied) else contact.ordered
            for contact in self.contacts
        )

    def take_memories(self) -> tuple[Memory, Memory]:
        """Histories of all touching pairs and wall contacts, sorted by key; the engine goes on with them."""
        for part in self.parts:
            if self.said[part.number] in (FRESH, STALE, EXPLODED):
                harvest(part.pairs, part.near, *part.memories, part.scratch, self.blocks_of(part), self.base(part))
                self.said[part.number] = REMEMBERED
        filled = ((part.memories, part.scratch.counts[[KEPT_PAIRS, KEPT_WALLS]]) for part in self.parts)
        of_parts = [[memory.picked(slice(count)) for memory, count in zip(*part, strict=True)] for part in filled]
        pairs, near = zip(*of_parts, strict=True)
        return Memory.joined(pairs), Memory.joined(near)

    def give_memories(self, pair_memory: Memory, wall_memory: Memory, *, wide_holds: bool = False) -> None:
        """Go on with these histories: the next list is made with them, and the wide list unless it still holds."""
        if not wide_holds:
            self.blocks.wide_travel[:] = np.inf
        for part in self.parts:
            part.load(pair_memory, wall_memory)
        self.said[:] = REMEMBERED
        self._widen_record()

    def clear_window(self) -> None:
        """Begin a new window of wall forces."""
        self.record.window[:] = self.record.whole[:] = NOTHING
