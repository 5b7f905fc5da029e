"""Meeting points of threads that step one scene together: atomic counters and a gate built of them."""

from llvmlite import ir
from numba import types
from numba.core import cgutils
from numba.extending import intrinsic, register_jitable

SPINS = 2000  # looks at the gate before the processor is offered to others


def _place(context, builder, signature, args):
    array = cgutils.create_struct_proxy(signature.args[0])(context, builder, value=args[0])
    return builder.gep(array.data, [args[1]])


@intrinsic
def _add(typing, counters, index, value):
    def generate(context, builder, signature, args):
        return builder.atomic_rmw("add", _place(context, builder, signature, args), args[2], "seq_cst")

    return types.int64(counters, index, types.int64), generate


@intrinsic
def _read(typing, counters, index):
    def generate(context, builder, signature, args):
        return builder.load_atomic(_place(context, builder, signature, args), "seq_cst", 8)

    return types.int64(counters, index), generate


@intrinsic
def _offer(typing):
    def generate(context, builder, signature, args):
        yielding = cgutils.get_or_insert_function(builder.module, ir.FunctionType(ir.IntType(32), []), "sched_yield")
        builder.call(yielding, [])
        return context.get_dummy_value()

    return types.void(), generate


@register_jitable
def meet(gate, parties):
    """Wait until all parties are here; gate is two integers: how many came, and how often all had come."""
    if parties == 1:
        return
    passed: int = _read(gate, 1)  # type: ignore[call-arg]  # numba hands the typing context in itself
    if _add(gate, 0, 1) == parties - 1:
        _add(gate, 0, -parties)
        _add(gate, 1, 1)
        return
    looks = 0
    while _read(gate, 1) == passed:
        looks += 1
        if looks % SPINS == 0:
            _offer()
