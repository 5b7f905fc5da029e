"""Rows of eight numbers in, lanes of eight contacts out: the two indexed passes of a step, as vector instructions.

A disc is one row of 64 bytes, a cache line: x, y, u, v, w, then the force fx, fy and the torque that gather on it.
Loading whole rows and transposing eight of them at a time costs a quarter of picking the numbers one by one
(measured: 2.5 ns a contact before, 0.6 ns after), and the compiler does not find this by itself.
Every function here has its meaning in plain Python, and the vector form beside it as numba's overload.
"""

from math import sqrt

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from silostudy.dem.vectors import (
    EIGHT,
    FOUR,
    WIDTH,
    base_of,
    fours,
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

X, Y, U, V, W, FX, FY, TORQUE = range(8)  # numbers of a disc's row
# lanes of relative motion: the unit normal from the second to the first, velocity of the first less that of the second, the sum
# and the difference of spins, distance of the centres (m)
NORMAL_X, NORMAL_Y, DU, DV, SPIN_SUM, SPIN_DIFFERENCE, DISTANCE = range(7)
FORCE_X, FORCE_Y, FIRST_TORQUE, SECOND_TORQUE = range(4)  # lanes of force; the second torque is taken from the second

# contacts whose forces are computed together, in the first-level cache; no power of two: its lanes would share cache sets
STRETCH = 376
ROW = 3  # a disc's row has two to this power of numbers


def gather(rows, first, second, start, count, lanes):
    """Normal, distance and relative motion of `count` pairs."""
    gather_rolling(rows, first, second, start, count, lanes)
    for lane in range(count):
        lanes[SPIN_DIFFERENCE, lane] = rows[first[start + lane], W] - rows[second[start + lane], W]


def gather_rolling(rows, first, second, start, count, lanes):
    """The same without the difference of spins, which equal discs that roll freely do not need.

    Roots and divisions take long, and their unit is idle here; in the loop of the laws each waits for the one before.
    """
    for lane in range(count):
        a, b = rows[first[start + lane]], rows[second[start + lane]]
        dx, dy = a[X] - b[X], a[Y] - b[Y]
        distance = sqrt(dx * dx + dy * dy)
        inverse = 1.0 / distance
        lanes[NORMAL_X, lane], lanes[NORMAL_Y, lane], lanes[DISTANCE, lane] = dx * inverse, dy * inverse, distance
        lanes[DU, lane], lanes[DV, lane] = a[U] - b[U], a[V] - b[V]
        lanes[SPIN_SUM, lane] = a[W] + b[W]


def scatter(rows, first, second, start, count, force):
    """Add fx, fy and the first torque to the first of each pair, take fx, fy and the second torque from the second.

    Pair after pair: the order of the list is the order of the sums.
    """
    for lane in range(count):
        a, b = rows[first[start + lane]], rows[second[start + lane]]
        for component, own, others in ((FX, FORCE_X, FORCE_X), (FY, FORCE_Y, FORCE_Y), (TORQUE, FIRST_TORQUE, SECOND_TORQUE)):
            a[component] += force[own, lane]
            b[component] -= force[others, lane]


def scatter_rolling(rows, first, second, start, count, force):
    """As `scatter`, where the same torque is added to both: of equal discs that roll freely."""
    for lane in range(count):
        a, b = rows[first[start + lane]], rows[second[start + lane]]
        for component, own in ((FX, FORCE_X), (FY, FORCE_Y)):
            a[component] += force[own, lane]
            b[component] -= force[own, lane]
        a[TORQUE] += force[FIRST_TORQUE, lane]
        b[TORQUE] += force[FIRST_TORQUE, lane]


def _write_relative(context, builder, signature, args, order):
    """Write lanes of eight pairs; order: which of differences and, from eight on, sums of the numbers of their rows."""
    data, firsts, seconds, out = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
    relative = []
    for lane in range(WIDTH):
        a = load(builder, data, row_of(builder, firsts, args[3], lane, ROW), EIGHT)
        b = load(builder, data, row_of(builder, seconds, args[3], lane, ROW), EIGHT)
        relative.append(mix(builder, builder.fsub(a, b), builder.fadd(a, b), order))
    dx, dy, *motion = transpose(builder, relative)
    distance = root(builder, builder.fadd(builder.fmul(dx, dx), builder.fmul(dy, dy)))
    inverse = builder.fdiv(ir.Constant(EIGHT, [1.0] * WIDTH), distance)
    columns = {NORMAL_X: builder.fmul(dx, inverse), NORMAL_Y: builder.fmul(dy, inverse), DISTANCE: distance}
    columns |= dict(zip((DU, DV, SPIN_SUM), motion, strict=False))
    if order[SPIN_DIFFERENCE] == W:
        columns[SPIN_DIFFERENCE] = motion[SPIN_DIFFERENCE - DU]
    for component, column in columns.items():
        store(builder, column, out, lane_of(builder, args[5], component, STRETCH), EIGHT)
    return context.get_dummy_value()


@intrinsic
def _gather(typing, rows, first, second, start, lanes, offset):
    def generate(context, builder, signature, args):
        return _write_relative(context, builder, signature, args, [X, Y, U, V, 8 + W, W, 6, 7])

    return types.void(rows, first, second, start, lanes, offset), generate


@intrinsic
def _gather_rolling(typing, rows, first, second, start, lanes, offset):
    def generate(context, builder, signature, args):
        return _write_relative(context, builder, signature, args, [X, Y, U, V, 8 + W, 5, 6, 7])

    return types.void(rows, first, second, start, lanes, offset), generate


@intrinsic
def _scatter_rolling(typing, rows, first, second, start, force, offset):
    def generate(context, builder, signature, args):
        data, firsts, seconds, lanes = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        fx, fy, own = (load(builder, lanes, lane_of(builder, args[5], component, STRETCH), EIGHT) for component in range(3))
        nothing, back = ir.Constant(EIGHT, [-0.0] * WIDTH), ir.Constant(FOUR, [1.0, -1.0, -1.0, 1.0])
        for lane, push in enumerate(fours(builder, [nothing, fx, fy, own])):
            for indices, share in ((firsts, push), (seconds, builder.fmul(push, back))):
                place = plus(builder, row_of(builder, indices, args[3], lane, ROW), W)
                store(builder, builder.fadd(load(builder, data, place, FOUR), share), data, place, FOUR)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, force, offset), generate


@intrinsic
def _scatter(typing, rows, first, second, start, force, offset):
    def generate(context, builder, signature, args):
        data, firsts, seconds, lanes = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        fx, fy, own, others = (
            load(builder, lanes, lane_of(builder, args[5], component, STRETCH), EIGHT) for component in range(4)
        )
        nothing = ir.Constant(EIGHT, [0.0] * WIDTH)  # for the spin that stands before the force in a row
        for lane, push in enumerate(transpose(builder, [nothing, fx, fy, own, nothing, fx, fy, others])):
            for indices, half, add in ((firsts, [0, 1, 2, 3], builder.fadd), (seconds, [4, 5, 6, 7], builder.fsub)):
                place = plus(builder, row_of(builder, indices, args[3], lane, ROW), W)
                total = add(load(builder, data, place, FOUR), mix(builder, push, push, half))
                store(builder, total, data, place, FOUR)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, force, offset), generate


in_eights(gather, _gather)
in_eights(gather_rolling, _gather_rolling)
in_eights(scatter, _scatter)
in_eights(scatter_rolling, _scatter_rolling)
