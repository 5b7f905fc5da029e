"""Vector instructions that the indexed passes of a step are written in: eight numbers at a time, in whole cache lines.

The compiler does not find them by itself.  A builder writes instructions; a base is a pointer to numbers.
"""

from collections.abc import Callable

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, overload, register_jitable

from silostudy.dem.cache import named

WIDTH = 8  # contacts taken at a time
REAL = ir.DoubleType()
INDEX = ir.IntType(64)
LANE = ir.IntType(32)
EIGHT = ir.VectorType(REAL, 8)  # a whole cache line
FOUR = ir.VectorType(REAL, 4)
WHOLE = ir.VectorType(LANE, 8)  # eight whole numbers of 32 bits


def _pointer(builder, base, index, vector):
    return builder.bitcast(builder.gep(base, [index]), vector.as_pointer())


def load(builder, base, index, vector):
    """The numbers of a vector's length that start at an index."""
    value = builder.load(_pointer(builder, base, index, vector))
    value.align = 8
    return value


def store(builder, value, base, index, vector):
    """Write a vector from an index on."""
    builder.store(value, _pointer(builder, base, index, vector)).align = 8


def mix(builder, a, b, order):
    """A vector of numbers of two others, the second's counted after the first's."""
    return builder.shuffle_vector(a, b, ir.Constant(ir.VectorType(LANE, len(order)), order))


def root(builder, square):
    """Square roots of eight numbers."""
    kind = ir.FunctionType(EIGHT, [EIGHT])
    return builder.call(cgutils.get_or_insert_function(builder.module, kind, "llvm.sqrt.v8f64"), [square])


def base_of(context, builder, signature, args, position):
    """Pointer to the numbers of an array argument."""
    return cgutils.create_struct_proxy(signature.args[position])(context, builder, value=args[position]).data


def plus(builder, value, constant):
    """An index further on."""
    return builder.add(value, ir.Constant(INDEX, constant))


def lane_of(builder, lane, component, stretch):
    """Index where eight numbers of a component start among the lanes of a scratch, each of which holds a stretch."""
    return plus(builder, lane, component * stretch)


def row_of(builder, indices, start, lane, shift):
    """Index where the row of 2**shift numbers of a body of the list starts."""
    position = plus(builder, start, lane)
    return builder.shl(builder.sext(builder.load(builder.gep(indices, [position])), INDEX), ir.Constant(INDEX, shift))


def transpose(builder, rows):
    """Eight rows of eight to eight columns of eight: numbers of two rows in turn, then pairs of them by whole quarters.

    In this order each exchange is an instruction with its order built in; one that reads its order takes twice as long.
    """
    even = [mix(builder, rows[k], rows[k + 1], [0, 8, 2, 10, 4, 12, 6, 14]) for k in (0, 2, 4, 6)]
    odd = [mix(builder, rows[k], rows[k + 1], [1, 9, 3, 11, 5, 13, 7, 15]) for k in (0, 2, 4, 6)]
    columns = [None] * WIDTH
    for first, pairs in enumerate((even, odd)):
        for step in (0, 1):
            low, high = (quarters(builder, pairs[k], pairs[k + 1], step) for k in (0, 2))
            columns[first + 2 * step], columns[first + 2 * step + 4] = (quarters(builder, low, high, half) for half in (0, 1))
    return columns


def fours(builder, columns):
    """Four columns of eight to eight rows of four."""
    a, b, c, d = columns
    even, odd = ([0, 8, 2, 10, 4, 12, 6, 14], [1, 9, 3, 11, 5, 13, 7, 15])
    halves = [(mix(builder, a, b, order), mix(builder, c, d, order)) for order in (even, odd)]
    return [mix(builder, *halves[row % 2], [row // 2 * 2 + k for k in (0, 1, 8, 9)]) for row in range(WIDTH)]


def quarters(builder, a, b, odd):
    """The even or the odd quarters, two numbers each, of one vector and then of another."""
    return mix(builder, a, b, [start + 2 * odd + k for start in (0, 4, 8, 12) for k in (0, 1)])


@intrinsic
def fetch(typing, rows, row):
    """Ask for the cache line that number `row` of an array stands in: it will be read and written soon."""

    def generate(context, builder, signature, args):
        byte = ir.IntType(8).as_pointer()
        kind = ir.FunctionType(ir.VoidType(), [byte, LANE, LANE, LANE])
        ask = cgutils.get_or_insert_function(builder.module, kind, "llvm.prefetch.p0")
        place = builder.bitcast(builder.gep(base_of(context, builder, signature, args, 0), [args[1]]), byte)
        builder.call(ask, [place, ir.Constant(LANE, 1), ir.Constant(LANE, 3), ir.Constant(LANE, 1)])
        return context.get_dummy_value()

    return types.void(rows, row), generate


@register_jitable(forceinline=True)
def fetch_rows(rows, listed, begin, end):
    """Fetch the rows of a stretch of a list ahead: a cache line holds as many numbers as a lane is wide.

    Of this module and not of a kernel: an intrinsic that a kernel closes over has other bytes in every process.
    """
    wide = rows.shape[1]
    for k in range(begin, end):
        for line in range(0, wide, WIDTH):
            fetch(rows, listed[k] * wide + line)  # type: ignore[call-arg]


def repeated(builder, value, vector):
    """A vector that is a value eight times."""
    first = builder.insert_element(ir.Constant(vector, ir.Undefined), value, ir.Constant(LANE, 0))
    return mix(builder, first, first, [0] * WIDTH)


@intrinsic
def _pick_eight(typing, near, order, room, t, end, middle, own, i, lo, picked, spot):
    def generate(context, builder, signature, args):
        numbers, listed, into = (base_of(context, builder, signature, args, k) for k in (0, 1, 9))
        room, t, end, middle, own, i, lo = args[2:9]
        square, reach = ir.Constant(EIGHT, [0.0] * WIDTH), repeated(builder, own, EIGHT)
        lanes = [load(builder, numbers, builder.add(t, builder.mul(room, ir.Constant(INDEX, k))), EIGHT) for k in range(4)]
        for k in range(3):
            away = builder.fsub(lanes[k], repeated(builder, builder.extract_value(middle, k), EIGHT))
            square = builder.fadd(square, builder.fmul(away, away))
        reach = builder.fadd(reach, lanes[3])
        bodies = load(builder, listed, t, WHOLE)
        after, before, left = (repeated(builder, builder.trunc(bound, LANE), WHOLE) for bound in (i, lo, builder.sub(end, t)))
        wanted = builder.or_(builder.icmp_signed(">", bodies, after), builder.icmp_signed("<", bodies, before))
        wanted = builder.and_(wanted, builder.icmp_signed("<", ir.Constant(WHOLE, list(range(WIDTH))), left))
        hits = builder.and_(wanted, builder.fcmp_ordered("<", square, builder.fmul(reach, reach)))
        kind = ir.FunctionType(WHOLE, [WHOLE, hits.type, WHOLE])
        compress = cgutils.get_or_insert_function(builder.module, kind, "llvm.experimental.vector.compress.v8i32")
        store(builder, builder.call(compress, [bodies, hits, bodies]), into, args[10], WHOLE)
        return builder.zext(builder.ctpop(builder.bitcast(hits, ir.IntType(WIDTH))), INDEX)

    whole = (types.int64,) * 3
    return types.int64(near, order, *whole, middle, own, types.int64, types.int64, picked, types.int64), generate


@register_jitable(forceinline=True)
def pick_eight(near, order, t, end, middle, own, i, lo, picked, spot):
    """Write those of eight bodies, from place t of an order on and before `end`, that lie nearer to a middle than their reach
    and `own` (m), and come after body i or before `lo`, from a spot on, where eight find room; gives how many these are.

    near (4, n): x, y, z and reach (m) in that order.
    """
    return _pick_eight(near, order, near.shape[1], t, end, middle, own, i, lo, picked, spot)  # type: ignore[call-arg]


def in_eights(meaning: Callable, instruction: Callable) -> None:
    """Give an indexed pass that is written in plain Python its compiled form: an instruction for eight contacts, in turn."""

    def eight_at_a_time(rows, first, second, start, count, lanes):
        for k in range(0, count, WIDTH):
            instruction(rows, first, second, start + k, lanes, k)

    compiled = named(eight_at_a_time, f"{meaning.__module__}.{meaning.__name__}")

    @overload(meaning)
    def _compiled(rows, first, second, start, count, lanes):
        return compiled
