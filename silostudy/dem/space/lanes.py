"""Rows of sixteen numbers in, lanes of eight contacts out: the indexed passes of a step of spheres, as vector instructions.

A sphere is one row of two cache lines: x, y, z, u, v, w, p, q, then r and the force and the torque that gather on it.
Every function here has its meaning in plain Python, and the vector form beside it as numba's overload.
Scratches are flat: numbers of one kind stand `STRETCH` apart, or the compiler does not see that they never overlap.
"""

from math import sqrt

from llvmlite import ir
from numba import types
from numba.extending import intrinsic, overload

from silostudy.dem.vectors import (
    EIGHT,
    FOUR,
    LANE,
    WIDTH,
    base_of,
    in_eights,
    lane_of,
    load,
    mix,
    plus,
    root,
    row_of,
    store,
    transpose,
)

# numbers of a sphere's row, the last one for how many steps it has been below the outlet
X, Y, Z, U, V, W, P, Q, R, FX, FY, FZ, TX, TY, TZ, PASSED = range(16)
PLACE = (X, Y, Z)  # m
VELOCITY = (U, V, W)  # m/s
SPIN = (P, Q, R)  # rad/s
FORCE = (FX, FY, FZ)  # N
TORQUE = (TX, TY, TZ)  # N m
# lanes of relative motion: the unit normal from the second to the first, velocity of the first less that of the second, sum and
# difference of spins; curvature of a wall (1/m), distance of the centres (m)
NX, NY, NZ, DU, DV, DW, SUM_P, SUM_Q, SUM_R, APART_P, APART_Q, APART_R, CURVED, DISTANCE = range(14)
# lanes of force and of the torques on both
FORCE_X, FORCE_Y, FORCE_Z, FIRST_X, FIRST_Y, FIRST_Z, SECOND_X, SECOND_Y, SECOND_Z = range(9)
# histories (of sliding, rolling, twisting, being in touch) stand among the lanes while forces are computed
OLD = 14  # first of them before the step, after the lanes of motion
NEW = 9  # first of them after the step, after the lanes of force
HISTORIES = 8  # how many they are

# contacts whose forces are computed together, in the first-level cache
STRETCH = 120
ROW = 4  # a sphere's row has two to this power of numbers
_SECOND_LINE = [-0.0] * 8  # the one number that changes nothing where it is added
_BACK = [1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0, 1.0]  # of a second line: forces act back, torques do not


def gather(rows, first, second, start, count, lanes):
    """Normal, distance and relative motion of `count` pairs."""
    gather_rolling(rows, first, second, start, count, lanes)
    flat = lanes.reshape(-1)
    for k in range(count):
        a, b = rows[first[start + k]], rows[second[start + k]]
        for n, component in enumerate(SPIN):
            flat[(APART_P + n) * STRETCH + k] = a[component] - b[component]


def gather_rolling(rows, first, second, start, count, lanes):
    """The same without the difference of spins, which equal spheres that roll freely do not need.

    Roots and divisions take long, and their unit is idle here; in the loop of the laws each waits for the one before.
    """
    flat = lanes.reshape(-1)
    for k in range(count):
        a, b = rows[first[start + k]], rows[second[start + k]]
        dx, dy, dz = a[X] - b[X], a[Y] - b[Y], a[Z] - b[Z]
        distance = sqrt(dx * dx + dy * dy + dz * dz)
        inverse = 1.0 / distance
        for lane, number in ((NX, dx * inverse), (NY, dy * inverse), (NZ, dz * inverse), (DISTANCE, distance)):
            flat[lane * STRETCH + k] = number
        for n, component in enumerate(VELOCITY):
            flat[(DU + n) * STRETCH + k] = a[component] - b[component]
        for n, component in enumerate(SPIN):
            flat[(SUM_P + n) * STRETCH + k] = a[component] + b[component]


def scatter(rows, first, second, start, count, force):
    """Add force and first torque to the first of each pair; take the force from the second, and add the second torque to it.

    Pair after pair: the order of the list is the order of the sums.
    """
    flat = force.reshape(-1)
    for k in range(count):
        a, b = rows[first[start + k]], rows[second[start + k]]
        for n in range(3):
            a[FORCE[n]] += flat[(FORCE_X + n) * STRETCH + k]
            b[FORCE[n]] -= flat[(FORCE_X + n) * STRETCH + k]
            a[TORQUE[n]] += flat[(FIRST_X + n) * STRETCH + k]
            b[TORQUE[n]] += flat[(SECOND_X + n) * STRETCH + k]


def scatter_rolling(rows, first, second, start, count, force):
    """As `scatter`, where both torques are the same: of equal spheres that roll freely."""
    flat = force.reshape(-1)
    for k in range(count):
        a, b = rows[first[start + k]], rows[second[start + k]]
        for n in range(3):
            a[FORCE[n]] += flat[(FORCE_X + n) * STRETCH + k]
            b[FORCE[n]] -= flat[(FORCE_X + n) * STRETCH + k]
            a[TORQUE[n]] += flat[(FIRST_X + n) * STRETCH + k]
            b[TORQUE[n]] += flat[(FIRST_X + n) * STRETCH + k]


def bring(history, start, count, lanes, place):
    """Copy the histories of a stretch, in three rows or in one, into lanes that follow each other from a place on."""
    flat = lanes.reshape(-1)
    for n, row in enumerate(history.reshape(-1, history.shape[-1])):
        flat[place + n * STRETCH :][:count] = row[start : start + count]


def take(lanes, place, history, start, count):
    """Copy lanes that follow each other from a place on into the histories of a stretch."""
    flat = lanes.reshape(-1)
    for n, row in enumerate(history.reshape(-1, history.shape[-1])):
        row[start : start + count] = flat[place + n * STRETCH :][:count]


@intrinsic
def _copy(typing, source, spot, target, to):
    def generate(context, builder, signature, args):
        out_of, into = (base_of(context, builder, signature, args, k) for k in (0, 2))
        store(builder, load(builder, out_of, args[1], EIGHT), into, args[3], EIGHT)
        return context.get_dummy_value()

    return types.void(source, spot, target, to), generate


def _both(builder, args, bodies, firsts, seconds, lane):
    """First lines of both rows of a pair, and their last spins, which stand on the second lines."""
    i, j = (row_of(builder, listed, args[3], lane, ROW) for listed in (firsts, seconds))
    lines = (load(builder, bodies, row, EIGHT) for row in (i, j))
    return *lines, *(builder.load(builder.gep(bodies, [plus(builder, row, R)])) for row in (i, j))


def _faced(builder, columns):
    """Lanes of eight pairs by differences of places, which become normals and distances, and what stands behind them."""
    *away, u, v, w, p, q = columns
    x, y, z = (builder.fmul(way, way) for way in away)
    distance = root(builder, builder.fadd(builder.fadd(x, y), z))
    inverse = builder.fdiv(ir.Constant(EIGHT, [1.0] * WIDTH), distance)
    normal = [builder.fmul(way, inverse) for way in away]
    return dict(enumerate([*normal, u, v, w, p, q])) | {DISTANCE: distance}


@intrinsic
def _gather_rolling(typing, rows, first, second, start, lanes, offset):
    def generate(context, builder, signature, args):
        bodies, firsts, seconds, out = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        near, last = [], ir.Constant(EIGHT, ir.Undefined)
        for lane in range(WIDTH):
            a, b, c, d = _both(builder, args, bodies, firsts, seconds, lane)
            near.append(mix(builder, builder.fsub(a, b), builder.fadd(a, b), [X, Y, Z, U, V, W, 8 + P, 8 + Q]))
            last = builder.insert_element(last, builder.fadd(c, d), ir.Constant(LANE, lane))
        for lane, column in {**_faced(builder, transpose(builder, near)), SUM_R: last}.items():
            store(builder, column, out, lane_of(builder, args[5], lane, STRETCH), EIGHT)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, lanes, offset), generate


@intrinsic
def _gather(typing, rows, first, second, start, lanes, offset):
    def generate(context, builder, signature, args):
        bodies, firsts, seconds, out = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        near, apart = [], []
        for lane in range(WIDTH):
            a, b, c, d = _both(builder, args, bodies, firsts, seconds, lane)
            less, more = builder.fsub(a, b), builder.fadd(a, b)
            near.append(mix(builder, less, more, [X, Y, Z, U, V, W, 8 + P, 8 + Q]))
            spins = builder.insert_element(less, builder.fsub(c, d), ir.Constant(LANE, 0))  # in the place of x
            apart.append(builder.insert_element(spins, builder.fadd(c, d), ir.Constant(LANE, 1)))
        columns, rest = _faced(builder, transpose(builder, near)), transpose(builder, apart)
        columns |= {SUM_R: rest[1], APART_P: rest[P], APART_Q: rest[Q], APART_R: rest[0]}
        for lane, column in columns.items():
            store(builder, column, out, lane_of(builder, args[5], lane, STRETCH), EIGHT)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, lanes, offset), generate


def _add(builder, bodies, row, push):
    """Add to the second line of a row, half by half: what was just stored comes back sooner in halves of a line."""
    for half in (0, 4):
        spot, part = plus(builder, row, R + half), mix(builder, push, push, [half + k for k in range(4)])
        store(builder, builder.fadd(load(builder, bodies, spot, FOUR), part), bodies, spot, FOUR)


@intrinsic
def _scatter(typing, rows, first, second, start, force, offset):
    def generate(context, builder, signature, args):
        bodies, firsts, seconds, lanes = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        pushes = [load(builder, lanes, lane_of(builder, args[5], lane, STRETCH), EIGHT) for lane in range(9)]
        nothing = ir.Constant(EIGHT, _SECOND_LINE)
        onto_first = transpose(builder, [nothing, *pushes[:6], nothing])
        away = [builder.fneg(push) for push in pushes[:3]]
        onto_second = transpose(builder, [nothing, *away, *pushes[6:], nothing])
        for lane in range(WIDTH):
            for listed, push in ((firsts, onto_first[lane]), (seconds, onto_second[lane])):
                _add(builder, bodies, row_of(builder, listed, args[3], lane, ROW), push)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, force, offset), generate


@intrinsic
def _scatter_rolling(typing, rows, first, second, start, force, offset):
    def generate(context, builder, signature, args):
        bodies, firsts, seconds, lanes = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        pushes = [load(builder, lanes, lane_of(builder, args[5], lane, STRETCH), EIGHT) for lane in range(6)]
        nothing, back = ir.Constant(EIGHT, _SECOND_LINE), ir.Constant(EIGHT, _BACK)
        for lane, push in enumerate(transpose(builder, [nothing, *pushes, nothing])):
            for listed, share in ((firsts, push), (seconds, builder.fmul(push, back))):
                _add(builder, bodies, row_of(builder, listed, args[3], lane, ROW), share)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, force, offset), generate


in_eights(gather_rolling, _gather_rolling)
in_eights(gather, _gather)
in_eights(scatter, _scatter)
in_eights(scatter_rolling, _scatter_rolling)


@overload(bring)
def _bring_overload(history, start, count, lanes, place):
    rows = 1 if history.ndim == 1 else 3

    def eight_at_a_time(history, start, count, lanes, place):
        room = history.size // rows
        for k in range(0, count, WIDTH):
            for n in range(rows):
                _copy(history, n * room + start + k, lanes, place + n * STRETCH + k)  # type: ignore[call-arg]

    return eight_at_a_time


@overload(take)
def _take_overload(lanes, place, history, start, count):
    rows = 1 if history.ndim == 1 else 3

    def eight_at_a_time(lanes, place, history, start, count):
        room = history.size // rows
        for k in range(0, count, WIDTH):
            for n in range(rows):
                _copy(lanes, place + n * STRETCH + k, history, n * room + start + k)  # type: ignore[call-arg]

    return eight_at_a_time
