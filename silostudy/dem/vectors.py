"""Vector instructions that the indexed passes of a step are written in: eight numbers at a time, in whole cache lines.

The compiler does not find them by itself.  A builder writes instructions; a base is a pointer to numbers.
"""

from llvmlite import ir
from numba.core import cgutils

WIDTH = 8  # contacts taken at a time
REAL, INDEX, LANE = ir.DoubleType(), ir.IntType(64), ir.IntType(32)
EIGHT, FOUR = ir.VectorType(REAL, 8), ir.VectorType(REAL, 4)


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


def base_of(context, builder, signature, args, position):
    """Pointer to the numbers of an array argument."""
    return cgutils.create_struct_proxy(signature.args[position])(context, builder, value=args[position]).data


def plus(builder, value, constant):
    """An index further on."""
    return builder.add(value, ir.Constant(INDEX, constant))


def lane_of(builder, lane, component, stretch):
    """Where eight numbers of a component start among the lanes of a scratch, each of which holds a stretch."""
    return plus(builder, lane, component * stretch)


def row_of(builder, indices, start, lane, shift):
    """Where the row of 2**shift numbers of a body of the list starts."""
    position = plus(builder, start, lane)
    return builder.shl(builder.sext(builder.load(builder.gep(indices, [position])), INDEX), ir.Constant(INDEX, shift))


def transpose(builder, rows):
    """Eight rows of eight to eight columns of eight, in three rounds of exchanges."""
    for distance in (1, 2, 4):
        low = [lane + (WIDTH - distance if lane & distance else 0) for lane in range(WIDTH)]
        high = [lane + (WIDTH if lane & distance else distance) for lane in range(WIDTH)]
        turned = list(rows)
        for k in range(WIDTH):
            if not k & distance:
                turned[k] = mix(builder, rows[k], rows[k + distance], low)
                turned[k + distance] = mix(builder, rows[k], rows[k + distance], high)
        rows = turned
    return rows
