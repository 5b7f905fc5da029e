"""The arrays of a run, struct by struct.  A part that a scene does not call for has length zero or one."""

from typing import NamedTuple

import numpy as np

BLOCK = 128  # discs that are moved together, right after the last contact that can touch them
LINE = 64  # bytes of a cache line
BEHIND = 1 << 62  # key behind all others, which ends a memory


class Discs(NamedTuple):
    """Discs. Rows (n, 8): x, y (m), u, v (m/s), w (rad/s), fx, fy (N/m), torque (N m/m); held (n, 4): an integrator's own."""

    rows: np.ndarray
    held: np.ndarray
    radius: np.ndarray  # m; length one where all are equal, as are the next three
    mass: np.ndarray  # kg/m
    inverse_mass: np.ndarray
    inverse_inertia: np.ndarray
    label: np.ndarray  # number of the disc in its packing
    kind: np.ndarray  # by which coefficients differ; length one where all are of one


class Spheres(NamedTuple):
    """Spheres. Rows (n, 16): x, y, z (m), u, v, w (m/s), p, q, r (rad/s), force (N), torque (N m); held (n, 8): as of discs."""

    rows: np.ndarray
    held: np.ndarray
    radius: np.ndarray  # m; length one where all are equal, as are the next three
    mass: np.ndarray  # kg
    inverse_mass: np.ndarray
    inverse_inertia: np.ndarray
    label: np.ndarray  # number of the sphere in its packing
    kind: np.ndarray  # by which coefficients differ; length one where all are of one


class Contacts(NamedTuple):
    """A list of near pairs in the order (first, second), or of bodies near walls in the order (body, wall).

    Numbers are those of discs, per metre thickness; histories of spheres are N and N m, in three rows.
    """

    first: np.ndarray
    second: np.ndarray
    stored: np.ndarray  # tangential spring force, N/m
    rolled: np.ndarray  # rolling moment, N m/m
    twisted: np.ndarray  # moment about the normal, N m; of spheres
    touched: np.ndarray  # 1 where the bodies are in touch, by laws under which those that have touched hold on
    arm: np.ndarray  # radius of the first, m; length one where all are equal, as are the next two
    other: np.ndarray  # radius of the second, m
    mass: np.ndarray  # reduced mass, kg/m
    which: np.ndarray  # number of the set of coefficients; length one where all have the same
    begin: np.ndarray  # where each block starts


class WallRecord(NamedTuple):
    """Forces that the walls feel: every contact of this step, thread by thread, and sums over a window by cells and walls."""

    force: np.ndarray  # (threads, contacts, 2) along the inner normal (pressing positive), along the wall (carrying positive)
    cell: np.ndarray  # (threads, contacts)
    counts: np.ndarray  # (threads,)
    now: np.ndarray  # (cells, 2) this step
    window: np.ndarray  # (cells, 2, 3) sum, least, largest since the window began
    owner: np.ndarray  # (cells,) wall of the cell
    whole_now: np.ndarray  # (walls, 2) this step, over the whole of each wall
    whole: np.ndarray  # (walls, 2, 3) as of cells


class Memory(NamedTuple):
    """Histories of touching contacts by key first * 2**32 + second, sorted: what survives a new list, and a restart."""

    key: np.ndarray
    stored: np.ndarray
    rolled: np.ndarray
    twisted: np.ndarray
    touched: np.ndarray

    def picked(self, which, key: np.ndarray | None = None) -> "Memory":
        """The entries that `which` picks, under other keys where these are given; columns that no law calls for stay empty."""
        columns = (column[..., which] if column.shape[-1] else column for column in self[1:])
        return Memory(self.key[which] if key is None else key, *columns)

    @staticmethod
    def joined(memories: tuple["Memory", ...]) -> "Memory":
        """A copy of several as one; an entry that two of them have is kept once."""
        if len(memories) == 1:
            return Memory(*(column.copy() for column in memories[0]))
        key = np.concatenate([memory.key for memory in memories])
        _, order = np.unique(key, return_index=True)
        return Memory(*(np.concatenate(columns, axis=-1) for columns in zip(*memories, strict=True))).picked(order)


class Walls(NamedTuple):
    """Walls. shape (n, 20): start x, y (m) of its line, unit direction, from where to where along it the wall reaches (m),
    kinds of the ends, speed of rise (m/s), of each end the unit direction of the wall that it meets, from where to where it
    reaches once outlets are open (m), how fast it is drawn back, kinds of the ends then, speed along it (columns of `walls`).

    The solid lies left of the direction.
    """

    shape: np.ndarray
    live: np.ndarray
    cells: np.ndarray  # (n, 3): first cell, cells between those of the two ends, cells before those of its back
    drive: np.ndarray  # (n, 6) what moves each wall: columns of `drive`


class Blocks(NamedTuple):
    """Distances (m) of blocks of bodies: travelled since the list was made, allowed, most of the last step; of both lists."""

    travel: np.ndarray
    skin: np.ndarray
    peak: np.ndarray
    wide_travel: np.ndarray  # up to the last list; infinite: the wide list does not hold
    wide_skin: np.ndarray


class Scratch(NamedTuple):
    """Lanes of one thread, its cell grid, and the numbers it borrows from its neighbours (ghosts)."""

    lanes: np.ndarray
    force: np.ndarray
    motion: np.ndarray
    motion_bits: np.ndarray  # the same memory as unsigned integers: their maximum vectorises, and a NaN comes out largest
    cell_begin: np.ndarray
    order: np.ndarray
    near: np.ndarray  # (4, n): x, y, z, reach (m) in that order
    close: np.ndarray  # neighbours of one body
    wide: np.ndarray  # the wide list: later bodies that may come near, body after body
    wide_begin: np.ndarray  # where those of each body begin
    wide_body: np.ndarray  # bodies that may come near walls
    wide_wall: np.ndarray  # and which
    seams: np.ndarray  # entries of the list at walls behind that of the same body at the piece of a floor before theirs
    cross: np.ndarray  # keys of pairs of the wide list whose first body belongs to an earlier thread
    slot: np.ndarray
    ghost: np.ndarray
    counts: np.ndarray  # ghosts, kept histories of pairs, of walls, a body pressed too deep, entries of wide_body, of seams


class Ledger(NamedTuple):
    """Energy balance of a run. account: entries (J/m), then what the next step needs; mean: discs at mean speeds."""

    account: np.ndarray
    mean: np.ndarray
    lanes: np.ndarray
    pair_stored: np.ndarray
    pair_rolled: np.ndarray
    pair_twisted: np.ndarray
    pair_touched: np.ndarray
    wall_stored: np.ndarray
    wall_rolled: np.ndarray
    wall_twisted: np.ndarray
    wall_touched: np.ndarray


class Shared(NamedTuple):
    """Arrays that all threads of a scene share. clock: steps made, then the disc that ran away, thread by thread."""

    bodies: Discs | Spheres
    walls: Walls
    blocks: Blocks
    record: WallRecord
    ledger: Ledger
    quake: np.ndarray  # (steps, 2) acceleration of the box, m/s2
    clock: np.ndarray
    said: np.ndarray  # a word of each thread on its lists
    gate: np.ndarray  # where threads meet


class Share(NamedTuple):
    """One thread's share: its number, its lists and their memories, its discs lo to hi, the first row of its own room."""

    number: int
    pairs: Contacts
    near: Contacts
    pair_memory: Memory
    wall_memory: Memory
    scratch: Scratch
    lo: int
    hi: int
    base: int


class Table(NamedTuple):
    """Coefficients of contacts that differ, and the lanes that those of a stretch of a list are brought to."""

    values: np.ndarray  # (sets, coefficients)
    lanes: np.ndarray  # a stretch for each coefficient


class March(NamedTuple):
    """Settings of a run's steps: coefficients of the laws of pairs and of walls, gravity (m/s2), step (s), where to stop."""

    pair_coefficients: tuple[tuple[float, ...], ...] | Table
    wall_coefficients: tuple[tuple[float, ...], ...] | Table
    gravity: tuple[float, ...]
    dt: float
    past: float  # step (s) before the first of these
    kick: float  # s, by which a kept velocity goes on
    ticks: int  # of the clock in a step
    stop: int
    bodies: int  # that are left
    parties: int  # threads
    smallest: float  # radius, m
    gap: float  # m, across which bodies that have touched may hold on
    ahead: float  # steps that a list of near contacts should last
    skin: float  # m; 0: chosen by the engine


def aligned(*shape: int, dtype=np.float64) -> np.ndarray:
    """Zeros that start on a cache line."""
    size = int(np.prod(shape)) * np.dtype(dtype).itemsize
    raw = np.zeros(size + LINE, np.uint8)
    offset = -raw.ctypes.data % LINE
    return raw[offset : offset + size].view(dtype).reshape(shape)
