"""Vectors: steps of eight trellises in LLVM's vector types: the machine code of :func:`lanes.butterfly`, and of
:func:`uses.least_of`, :func:`uses.lesser` and :func:`uses.turned`.

Numba compiles the plain twins to a loop of lanes; written out the first takes 62 against 260 ns a stitch (R = 8, 2-core EPYC).
"""

from __future__ import annotations

from typing import Any

from llvmlite import ir
from numba import types
from numba.core import cgutils
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


def _whole(context: Any, builder: Any, signature: Any, args: Any, k: int) -> Any:
    """A function from a place in array ``k`` of whole numbers to a pointer to the eight lanes there."""
    data = context.make_array(signature.args[k])(context, builder, args[k]).data
    lanes = ir.VectorType(ir.IntType(32), LANES).as_pointer()
    return lambda place: builder.bitcast(builder.gep(data, [place]), lanes)


def _spread(builder: Any, number: Any) -> Any:
    """Eight lanes of a number."""
    nothing = ir.Constant(ir.VectorType(ir.IntType(32), LANES), ir.Undefined)
    one = builder.insert_element(nothing, builder.trunc(number, ir.IntType(32)), ir.Constant(ir.IntType(32), 0))
    return builder.shuffle_vector(one, nothing, ir.Constant(nothing.type, [0] * LANES))


def _plus(builder: Any, pointer: Any, code: Any) -> Any:
    """The lanes at a pointer, and a number more."""
    value = builder.load(pointer)
    value.align = 4
    return builder.add(value, _spread(builder, code))


def _lesser(builder: Any, a: Any, b: Any) -> Any:
    return builder.select(builder.icmp_signed("<", b, a), b, a)


@intrinsic
def least_of(typing: Any, V: Any, T: Any, M: Any, v: Any, t: Any, many: Any, m: Any, mark: Any) -> Any:
    """See :func:`tambour.knit.solve.uses.least_of`."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        values, minima = (_whole(context, builder, signature, args, k) for k in (0, 2))
        places = context.make_array(signature.args[1])(context, builder, args[1]).data
        v_, t_, many_, m_, mark_ = args[3:]
        none, one = ir.Constant(t_.type, 0), ir.Constant(t_.type, 1)

        def candidate(j: Any) -> Any:
            place = builder.sext(builder.load(builder.gep(places, [builder.add(t_, j)])), v_.type)
            return _plus(builder, values(builder.add(v_, place)), j)

        best = cgutils.alloca_once_value(builder, candidate(none))
        with cgutils.for_range_slice(builder, one, many_, one) as (j, _):
            builder.store(_lesser(builder, builder.load(best), candidate(j)), best)
        stored = builder.store(_plus(builder, best, mark_), minima(m_))
        stored.align = 4
        return context.get_dummy_value()

    return types.void(V, T, M, v, t, many, m, mark), generate


@intrinsic
def lesser(typing: Any, V: Any, M: Any, v: Any, m: Any, code: Any) -> Any:
    """See :func:`tambour.knit.solve.uses.lesser`."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        values, minima = (_whole(context, builder, signature, args, k) for k in (0, 1))
        v_, m_, code_ = args[2:]
        kept = builder.load(minima(m_))
        kept.align = 4
        stored = builder.store(_lesser(builder, kept, _plus(builder, values(v_), code_)), minima(m_))
        stored.align = 4
        return context.get_dummy_value()

    return types.void(V, M, v, m, code), generate


@intrinsic
def turned(typing: Any, M: Any, V: Any, W: Any, S: Any, m: Any, v: Any, k: Any, others: Any, mask: Any) -> Any:
    """See :func:`tambour.knit.solve.uses.turned`: a case for each number of yarns."""

    def generate(context: Any, builder: Any, signature: Any, args: Any) -> Any:
        minima, values, more = (_whole(context, builder, signature, args, k) for k in (0, 1, 3))
        places = context.make_array(signature.args[2])(context, builder, args[2]).data
        m_, v_, k_, others_, mask_ = args[4:]
        kept = _spread(builder, mask_)
        done = builder.append_basic_block("done")
        cases = builder.switch(others_, done)

        def lanes(place: Any) -> Any:
            value = builder.load(place)
            value.align = 4
            return value

        for many in range(1, LANES):
            block = builder.append_basic_block(f"others{many}")
            cases.add_case(ir.Constant(others_.type, many), block)
            builder.position_at_end(block)
            rows = [lanes(minima(builder.add(m_, ir.Constant(m_.type, p * LANES)))) for p in range(many)]
            rows = [builder.and_(row, kept) for row in rows]
            for q in range(many):
                new = rows[0]
                for p, row in enumerate(
                    rows
                ):  # lane p from column q + 1 as far as p = q, lane p + 1 from column q from there on
                    mask = [LANES + lane for lane in range(LANES)]
                    if p <= q:
                        mask[p] = q + 1
                    if p >= q:
                        mask[p + 1] = q
                    new = builder.shuffle_vector(row, new, ir.Constant(ir.VectorType(ir.IntType(32), LANES), mask))
                new = builder.add(new, lanes(more(ir.Constant(m_.type, q * LANES))))
                place = builder.load(builder.gep(places, [builder.add(k_, ir.Constant(k_.type, q))]))
                stored = builder.store(new, values(builder.add(v_, builder.sext(place, v_.type))))
                stored.align = 4
            builder.branch(done)
        builder.position_at_end(done)
        return context.get_dummy_value()

    return types.void(M, V, W, S, m, v, k, others, mask), generate
