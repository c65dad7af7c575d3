"""Vectors: one step of eight trellises in LLVM's vector types: the machine code of :func:`lanes.butterfly`.

Numba compiles the plain twin to a loop of lanes; written out it takes 62 against 260 ns a stitch (R = 8, 2-core EPYC).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.extending import intrinsic

LANES = 8


@intrinsic
def butterfly(
    typing: Any, V: Any, W: Any, P: Any, U: Any, Z: Any, i: Any, j: Any, o: Any, x: Any, p: Any, s: Any, t: Any
) -> Any:
    """See :func:`tambour.knit.solve.lanes.butterfly`."""
    signature = types.void(V, W, P, U, Z, i, j, o, x, p, s, t)
    vector = ir.VectorType(ir.FloatType(), LANES)
    index = ir.IntType(32)

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        def at(k: int, place: Any, kind: Any) -> Any:
            data = context.make_array(signature.args[k])(context, builder, args[k]).data
            return builder.bitcast(builder.gep(data, [place]), kind.as_pointer())

        def load(k: int, place: Any) -> Any:
            value = builder.load(at(k, place, vector))
            value.align = 4
            return value

        def spread(value: Any) -> Any:
            nothing = ir.Constant(vector, ir.Undefined)
            one = builder.insert_element(nothing, value, ir.Constant(index, 0))
            return builder.shuffle_vector(one, nothing, ir.Constant(ir.VectorType(index, LANES), [0] * LANES))

        def choose(a: Any, b: Any, extra: Any, out: Any, pick: Any) -> None:
            less = builder.fcmp_ordered("<", b, a)
            stored = builder.store(builder.fadd(builder.select(less, b, a), extra), at(1, out, vector))
            stored.align = 4
            builder.store(builder.bitcast(less, ir.IntType(LANES)), at(2, pick, ir.IntType(8)))

        i_, j_, o_, x_, p_, s_, t_ = args[5:]
        a, b = load(0, i_), load(0, j_)
        eight, one = ir.Constant(o_.type, LANES), ir.Constant(p_.type, 1)
        choose(a, b, load(4, x_), o_, p_)
        choose(
            builder.fadd(a, spread(s_)),
            builder.fadd(b, spread(t_)),
            load(3, x_),
            builder.add(o_, eight),
            builder.add(p_, one),
        )
        return context.get_dummy_value()

    return signature, generate
