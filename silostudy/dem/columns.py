"""A block's rows turned to lanes and back, a number of a body to a lane: so that its bodies are moved eight at a time.

Every function has its meaning in plain Python, and the vector form beside it as numba's overload.
What is written back is written out for discs and for spheres: one function for both makes 350 discs 5 % slower.
Lanes are flat: numbers of one kind stand `stride` apart, or the compiler does not see that they never overlap.
"""

from llvmlite import ir
from numba import types
from numba.extending import intrinsic, overload

from silostudy.dem.vectors import EIGHT, INDEX, WIDTH, base_of, load, store, transpose


def _steps(builder, start, step):
    """Eight indices, each a step after the one before."""
    return [builder.add(start, builder.mul(step, ir.Constant(INDEX, k))) for k in range(WIDTH)]


@intrinsic
def _to_lanes(typing, rows, place, wide, lanes, spot, stride):
    def generate(context, builder, signature, args):
        data, out = (base_of(context, builder, signature, args, k) for k in (0, 3))
        lines = [load(builder, data, index, EIGHT) for index in _steps(builder, *args[1:3])]
        for column, index in zip(transpose(builder, lines), _steps(builder, *args[4:6]), strict=True):
            store(builder, column, out, index, EIGHT)
        return context.get_dummy_value()

    return types.void(rows, place, wide, lanes, spot, stride), generate


def _write_back(context, builder, signature, args, cleared):
    """Write eight lines of rows back, some of their numbers as zero."""
    data, given = (base_of(context, builder, signature, args, k) for k in (0, 3))
    nothing = ir.Constant(EIGHT, [0.0] * WIDTH)
    spots = enumerate(_steps(builder, *args[4:6]))
    columns = [nothing if k in cleared else load(builder, given, index, EIGHT) for k, index in spots]
    for line, index in zip(transpose(builder, columns), _steps(builder, *args[1:3]), strict=True):
        store(builder, line, data, index, EIGHT)
    return context.get_dummy_value()


@intrinsic
def _back(typing, rows, place, wide, lanes, spot, stride):
    def generate(context, builder, signature, args):
        return _write_back(context, builder, signature, args, cleared=())

    return types.void(rows, place, wide, lanes, spot, stride), generate


@intrinsic
def _back_but_the_last_three(typing, rows, place, wide, lanes, spot, stride):
    def generate(context, builder, signature, args):
        return _write_back(context, builder, signature, args, cleared=range(5, 8))

    return types.void(rows, place, wide, lanes, spot, stride), generate


@intrinsic
def _back_the_first_and_last(typing, rows, place, wide, lanes, spot, stride):
    def generate(context, builder, signature, args):
        return _write_back(context, builder, signature, args, cleared=range(1, 7))

    return types.void(rows, place, wide, lanes, spot, stride), generate


def to_lanes(rows, begin, end, lanes, stride):
    """Bring the rows of bodies from `begin` to `end` to lanes."""
    for number in range(rows.shape[1]):
        lanes[number * stride :][: end - begin] = rows[begin:end, number]


def to_rows_of_spheres(lanes, stride, rows, begin, end):
    """Take all numbers of spheres from lanes back to rows but forces and torques, which are cleared there."""
    for number in range(16):
        rows[begin:end, number] = 0.0 if 9 <= number < 15 else lanes[number * stride :][: end - begin]


def to_rows_of_discs(lanes, stride, rows, begin, end):
    """The same of discs."""
    for number in range(8):
        rows[begin:end, number] = 0.0 if number >= 5 else lanes[number * stride :][: end - begin]


@overload(to_lanes)
def _to_lanes_overload(rows, begin, end, lanes, stride):
    def eight_at_a_time(rows, begin, end, lanes, stride):
        wide, whole = rows.shape[1], (end - begin) // WIDTH * WIDTH
        for k in range(0, whole, WIDTH):
            for line in range(0, wide, WIDTH):
                _to_lanes(rows, (begin + k) * wide + line, wide, lanes, line * stride + k, stride)  # type: ignore[call-arg]
        for k in range(whole, end - begin):
            for number in range(wide):
                lanes[number * stride + k] = rows[begin + k, number]

    return eight_at_a_time


@overload(to_rows_of_spheres)
def _to_rows_of_spheres_overload(lanes, stride, rows, begin, end):
    def eight_at_a_time(lanes, stride, rows, begin, end):
        whole = (end - begin) // WIDTH * WIDTH
        for k in range(0, whole, WIDTH):
            _back(rows, (begin + k) * 16, 16, lanes, k, stride)  # type: ignore[call-arg]
            _back_the_first_and_last(rows, (begin + k) * 16 + 8, 16, lanes, 8 * stride + k, stride)
        for k in range(whole, end - begin):
            for number in range(16):
                rows[begin + k, number] = 0.0 if 9 <= number < 15 else lanes[number * stride + k]

    return eight_at_a_time


@overload(to_rows_of_discs)
def _to_rows_of_discs_overload(lanes, stride, rows, begin, end):
    def eight_at_a_time(lanes, stride, rows, begin, end):
        whole = (end - begin) // WIDTH * WIDTH
        for k in range(0, whole, WIDTH):
            _back_but_the_last_three(rows, (begin + k) * 8, 8, lanes, k, stride)  # type: ignore[call-arg]
        for k in range(whole, end - begin):
            for number in range(8):
                rows[begin + k, number] = 0.0 if number >= 5 else lanes[number * stride + k]

    return eight_at_a_time
