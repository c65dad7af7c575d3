"""The fewest changes of thread that what lies over what allows."""

from dataclasses import replace
from itertools import pairwise

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from tambour.core.progress import Progress
from tambour.embroidery.params import EmbroideryParams
from tambour.embroidery.plan import order as room
from tambour.embroidery.plan.make import make
from tambour.embroidery.plan.order import blocks, order


@st.composite
def scenes(draw, most=9):
    n = draw(st.integers(1, most))
    colors = draw(st.lists(st.integers(0, 3), min_size=n, max_size=n))
    waits = [draw(st.sets(st.integers(0, i - 1), max_size=3)) if i else set() for i in range(n)]
    known: dict[int, int] = {}
    return [known.setdefault(c, len(known)) for c in colors], waits


def fewest(colors, waits):
    """By looking at every order, one region at a time."""
    n = len(colors)
    front = {(0, -1)}
    changes = 0
    while True:
        stack, seen = list(front), set(front)
        while stack:  # all that can be had with the thread that is in the needle
            done, color = stack.pop()
            for i in range(n):
                if not done >> i & 1 and colors[i] == color and all(done >> b & 1 for b in waits[i]):
                    state = (done | 1 << i, color)
                    if state not in seen:
                        seen.add(state)
                        stack.append(state)
        if any(done == (1 << n) - 1 for done, _ in seen):
            return changes
        changes += 1
        front = {(done, color) for done, _ in seen for color in set(colors)} - seen


@settings(max_examples=150, deadline=None)
@given(scenes())
def test_no_order_needs_fewer_changes(scene):
    colors, waits = scene
    made = blocks(colors, waits)
    assert len(made) == fewest(colors, waits)


@pytest.mark.parametrize("work", [0, 2_000_000])
@settings(max_examples=60, deadline=None)
@given(scene=scenes(most=40))
def test_each_is_sewn_once_after_what_it_lies_on(work, scene):
    colors, waits = scene
    was, room.WORK = room.WORK, work
    try:
        made = blocks(colors, waits)
    finally:
        room.WORK = was
    assert sorted(i for block in made for i in block) == list(range(len(colors)))
    assert all(len({colors[i] for i in block}) == 1 for block in made)
    at = {i: k for k, block in enumerate(made) for i in block}
    assert all(at[b] <= at[i] for i, w in enumerate(waits) for b in w)
    assert all(colors[a[0]] != colors[b[0]] for a, b in pairwise(made))


@pytest.mark.slow
def test_thousands_are_ordered_in_bounded_work():
    draw = np.random.Generator(np.random.PCG64(3))
    n = 3000
    colors = (np.arange(n) % 40).tolist()
    waits = [set(draw.integers(max(0, i - 60), i, 2).tolist()) if i else set() for i in range(n)]
    assert sum(map(len, blocks(colors, waits))) == n


@pytest.mark.parametrize("words", ["Anna", "Hello to you"])
def test_letters_are_sewn_as_one_reads(words):
    piece = make(None, EmbroideryParams(text=words, text_size=12, text_arc=40 if " " in words else None), Progress())
    sewn = [k for k in dict.fromkeys(piece.region.tolist()) if k >= 0]
    assert len(sewn) == len(words.replace(" ", ""))
    assert sewn == sorted(sewn)


def test_letters_of_two_threads_save_the_change():
    a = make(None, EmbroideryParams(text="abcd", text_size=12), Progress()).regions
    two = [replace(r, color=(200, 0, 0)) if k in (0, 2) else r for k, r in enumerate(a)]
    made = order(two, "auto")
    assert [two[k].color for k in made] in ([c, c, d, d] for c, d in pairwise([a[0].color, (200, 0, 0), a[0].color]))
