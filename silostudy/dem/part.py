"""The share of one thread in a scene: its contact lists, the memories of their histories, and its scratch."""

import numpy as np

from silostudy.dem.arrays import BEHIND, BLOCK, Contacts, Memory, Scratch, aligned
from silostudy.dem.history import histories
from silostudy.dem.pieces import Laws
from silostudy.dem.varied import Varied
from silostudy.dem.vectors import WIDTH
from silostudy.dem.wide import KEPT_PAIRS, KEPT_WALLS, SEAMS

NEAR_ROOM = 1024  # bodies near one, to begin with


class Part:
    """The share of one thread: its lists, memories and scratch."""

    def __init__(self, engine, number: int):
        self.number, self.engine = number, engine
        self.room, self.wall_room = 3 * BLOCK * WIDTH + int(2.7 * engine.most), 64 + 4 * int(engine.most ** (2 / 3))
        self.near_room = NEAR_ROOM
        self.ghost_room = 0 if engine.threads == 1 else 1024 + 8 * int(engine.most**0.5)
        self.laws = engine.model.pair_contact.laws, engine.model.wall_contact.laws
        self.memories = self._memory(0, self.laws[0]), self._memory(0, self.laws[1])
        self.varied = engine.model.pieces.varied
        widths = (contact.ordered.shape[1] for contact in engine.contacts if isinstance(contact, Varied))
        self.coefficients = aligned(max(widths, default=0) * engine.space.stretch)
        self.counts = np.zeros(SEAMS + 1, np.int64)
        self.make_lists()

    def _memory(self, room: int, laws: Laws) -> Memory:
        vectors = self._histories(room), self._histories(room)
        return Memory(np.full(room, BEHIND), *vectors, aligned(room * laws.winds), aligned(room * laws.clings))

    def _histories(self, room: int) -> np.ndarray:
        return histories(room, self.engine.space.components)

    def _contacts(self, room: int, laws: Laws, other: float, mass: float, varied: bool) -> Contacts:
        length = room if self.engine.model.unequal else 1
        return Contacts(
            first=np.zeros(room, np.int32),
            second=np.zeros(room, np.int32),
            stored=self._histories(room if laws.slides else 0),
            rolled=self._histories(room if laws.rolls else 0),
            twisted=aligned(room * laws.winds),
            touched=aligned(room * laws.clings),
            arm=np.full(length, self.engine.bodies.radius[0]),
            other=np.full(length, other),
            mass=np.full(length, mass),
            which=np.zeros(room if varied else 1, np.int32),
            begin=np.zeros(self.engine.most // BLOCK + 3, np.int64),
        )

    def make_lists(self):
        """Lists with the room asked for; memories grow with them and keep what they hold."""
        engine = self.engine
        engine.blocks.wide_travel[:] = np.inf
        mass, radius = engine.bodies.mass[0], engine.bodies.radius[0]
        self.pairs = self._contacts(self.room, self.laws[0], radius, 0.5 * mass, self.varied[0])
        self.near = self._contacts(self.wall_room, self.laws[1], 0.0, mass, self.varied[1])
        pair, wall = self.memories
        self.memories = self._grown(pair, self.room, self.laws[0]), self._grown(wall, self.wall_room, self.laws[1])
        motion = aligned(BLOCK)
        self.scratch = Scratch(
            lanes=aligned(*engine.space.lanes),
            force=aligned(*engine.space.forces),
            motion=motion,
            motion_bits=motion.view(np.uint64),
            cell_begin=np.zeros(engine.most + 1024, np.int32),
            order=np.zeros(engine.most + WIDTH, np.int32),
            near=aligned(4, engine.most + WIDTH),
            close=np.zeros(self.near_room, np.int32),
            wide=np.zeros(2 * self.room, np.int32),
            wide_begin=np.zeros(engine.most + 1, np.int64),
            wide_body=np.zeros(2 * self.wall_room, np.int32),
            wide_wall=np.zeros(2 * self.wall_room, np.int32),
            seams=np.zeros(self.wall_room, np.int32),
            cross=np.zeros(4 * self.ghost_room + 1, np.int64),
            slot=np.zeros(engine.most if engine.threads > 1 else 0, np.int32),
            ghost=np.zeros(self.ghost_room, np.int32),
            counts=self.counts,
        )

    def _grown(self, memory: Memory, room: int, laws: Laws) -> Memory:
        new = self._memory(room if laws.stores else 0, laws)
        for old, fresh in zip(memory, new, strict=True):
            both = min(old.shape[-1], fresh.shape[-1])
            fresh[..., :both] = old[..., :both]
        return new

    def grow(self):
        """More room for everything, after a list ran out of it; the memories keep the histories."""
        self.room, self.wall_room, self.near_room = int(1.3 * self.room) + 256, 2 * self.wall_room, 2 * self.near_room
        self.make_lists()

    def load(self, pair_memory: Memory, wall_memory: Memory):
        """Take histories from outside; the next lists are made with them."""
        rooms = max(self.room, len(pair_memory.key) + 1), max(self.wall_room, len(wall_memory.key) + 1)
        if rooms != (self.room, self.wall_room):
            self.room, self.wall_room = rooms
            self.make_lists()
        for mine, given in zip(self.memories, (pair_memory, wall_memory), strict=True):
            for old, new in zip(mine, given, strict=True):
                old[..., : new.shape[-1]] = new
            mine.key[len(given.key) :] = BEHIND
        self.scratch.counts[[KEPT_PAIRS, KEPT_WALLS]] = len(pair_memory.key), len(wall_memory.key)
