"""Rows of eight numbers in, lanes of eight contacts out: the two indexed passes of a step, as vector instructions.

A disc is one row of 64 bytes, a cache line: x, y, u, v, w, then the force fx, fy and the torque that gather on it.
Loading whole rows and transposing eight of them at a time costs a quarter of picking the numbers one by one
(measured: 2.5 ns a contact before, 0.6 ns after), and the compiler does not find this by itself.
Every function here has its meaning in plain Python, and the vector form beside it as numba's overload.
"""

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

from silostudy.dem.vectors import EIGHT, FOUR, WIDTH, base_of, in_eights, lane_of, load, mix, plus, row_of, store, transpose

X, Y, U, V, W, FX, FY, TORQUE = range(8)  # numbers of a disc's row
DX, DY, DU, DV, SPIN_SUM, SPIN_DIFFERENCE = range(6)  # lanes of relative motion, first less second
FORCE_X, FORCE_Y, FIRST_TORQUE, SECOND_TORQUE = range(4)  # lanes of force; the second torque is taken from the second

# contacts whose forces are computed together, in the first-level cache; no power of two: its lanes would share cache sets
STRETCH = 376
ROW = 3  # a disc's row has two to this power of numbers


def gather(rows, first, second, start, count, lanes):
    """Relative motion of `count` pairs: differences of x, y, u, v, the sum and the difference of w."""
    for lane in range(count):
        a, b = rows[first[start + lane]], rows[second[start + lane]]
        for difference, component in ((DX, X), (DY, Y), (DU, U), (DV, V), (SPIN_DIFFERENCE, W)):
            lanes[difference, lane] = a[component] - b[component]
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


@intrinsic
def _gather(typing, rows, first, second, start, lanes, offset):
    def generate(context, builder, signature, args):
        data, firsts, seconds, out = (base_of(context, builder, signature, args, k) for k in (0, 1, 2, 4))
        relative = []
        for lane in range(WIDTH):
            a = load(builder, data, row_of(builder, firsts, args[3], lane, ROW), EIGHT)
            b = load(builder, data, row_of(builder, seconds, args[3], lane, ROW), EIGHT)
            relative.append(mix(builder, builder.fsub(a, b), builder.fadd(a, b), [0, 1, 2, 3, 12, 4, 6, 7]))
        for component, column in enumerate(transpose(builder, relative)[:6]):
            store(builder, column, out, lane_of(builder, args[5], component, STRETCH), EIGHT)
        return context.get_dummy_value()

    return types.void(rows, first, second, start, lanes, offset), generate


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
in_eights(scatter, _scatter)
