"""Printed motifs: squares, hexagons and flowers: rounds in a ring of chains, in chain spaces, in corners; stitch by stitch."""

from __future__ import annotations

from dataclasses import replace

import pytest

from tambour.core.errors import Span, TambourError, Text
from tambour.crochet.graph.build import build
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.fits import ENDLESS
from tambour.crochet.language.stitches import STITCHES
from tambour.crochet.language.tree import Action, Group
from tambour.crochet.page.own import pattern
from tambour.crochet.printed.choose import read
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.rounds.motifs import begun
from test_crochet_build import made

HEAD = "Blanket\n\nMATERIALS\nYarn: A = white, B = red\n\nSQUARE\n"
RING = "With A, ch 4. Join with sl st to form ring.\n"


def worked(text: str) -> Built:
    """A text that is read whole, without a doubt about a count or a ring."""
    found = read(Text(HEAD + text, "square.txt"))
    assert not [found.text.text[p.span.start : p.span.end] for p in found.unread if p.span]
    built = build(found)
    assert not [w.message for w in built.warnings if "pattern says" in w.message or "ring" in w.message]
    return built


def kinds(built: Built, number: int) -> str:
    """The stitches of a round in order: "ch3dc 2 dc 2 ch …", runs counted."""
    hook, row = built.hook, next(r for r in built.rounds if r.number == number)
    runs: list[list] = []
    for n in range(row.first, row.last + 1):
        kind = hook.styles[hook.style[n]][0]
        if n in hook.lifts:
            continue
        if runs and runs[-1][0] == kind:
            runs[-1][1] += 1
        else:
            runs.append([kind, 1])
    return " ".join(kind if many == 1 else f"{many} {kind}" for kind, many in runs)


def spaces(built: Built, number: int) -> list[int]:
    """How many stitches go into each chain space of the round below, in its order."""
    hook, row = built.hook, next(r for r in built.rounds if r.number == number)
    into = [u for n in range(row.first, row.last + 1) for u in hook.anchors[hook.ends[n] : hook.ends[n + 1]]]
    below = next(r for r in built.rounds if r.number == number - 1)
    found, run = [], None
    for n in range(below.first, below.last + 1):
        chain = hook.styles[hook.style[n]][0] == "ch" and n not in hook.lifts
        run = None if not chain else found.append(0) or len(found) - 1 if run is None else run
        if chain:
            found[run] += into.count(n)
    return found


FIRST = "ch3dc 2 dc 2 ch 3 dc 2 ch 3 dc 2 ch 3 dc 2 ch"


@pytest.mark.parametrize(
    "words",
    [
        "1st rnd: Ch 3 (counts as dc). 2 dc in ring. (Ch 2. 3 dc in ring) 3 times. Ch 2. Join with sl st to top of ch 3.",
        "Rnd 1: Ch 3 (counts as dc), 2 dc in ring, *ch 2, 3 dc in ring; rep from * twice more, ch 2, join with sl st in top of beg ch-3. (12 dc, 4 ch-2 sps)",
        "Round 1: Ch 3 (counts as dc), 2 dc in ring, ch 2, *3 dc in ring, ch 2; rep from * 2 times more; join with sl st to top of ch-3.",
        "Rnd 1: Ch 3, 2 dc in ring, ch 2, [3 dc in ring, ch 2] 3 times; join with sl st in top of ch-3 - 12 dc and 4 ch-2 sps.",
    ],
)
def test_the_first_round_of_a_square_is_one_ring_with_its_spaces(words: str) -> None:
    assert kinds(worked(f"{RING}{words}\n"), 1) == FIRST


def test_longer_chains_at_the_beginning_are_a_stitch_and_a_space() -> None:
    words = "1st rnd: Ch 6. (3 dc in ring. Ch 3) 3 times. 2 dc in ring. Join. Fasten off. 12 dc and 4 ch-3 sps.\n"
    assert kinds(worked(RING + words), 1) == "ch3dc 3 ch 3 dc 3 ch 3 dc 3 ch 3 dc 3 ch 2 dc"


SECOND = "ch3dc 2 dc 2 ch 3 dc ch 3 dc 2 ch 3 dc ch 3 dc 2 ch 3 dc ch 3 dc 2 ch 3 dc ch"
ONE = "Rnd 1: Ch 3 (counts as dc), 2 dc in ring, *ch 2, 3 dc in ring; rep from * twice more, ch 2, join with sl st in top of beg ch-3.\n"


@pytest.mark.parametrize(
    "words",
    [
        "Rnd 2: Sl st in next 2 dc and ch-2 sp. Ch 3 (counts as dc). (2 dc. Ch 2. 3 dc) in same ch-2 sp. *Ch 1. (3 dc. Ch 2. 3 dc) in next ch-2 sp. Rep from * twice more. Ch 1. Join with sl st to top of ch 3.",
        "Rnd 2: Sl st to first ch-2 sp, ch 3, (2 dc, ch 2, 3 dc) in same sp (beg corner made), *ch 1, (3 dc, ch 2, 3 dc) in next ch-2 sp (corner made); rep from * twice more, ch 1, join.",
        "Rnd 2: Join B in any ch-2 corner sp; ch 3, 2 dc, ch 2, 3 dc in same sp; *ch 1, in next corner sp work (3 dc, ch 2, 3 dc); rep from * around, ch 1; join.",
        "Rnd 2: Sl st in each of next 2 dc, sl st in corner sp, ch 3, 2 dc in same sp, ch 2, 3 dc in same sp, ch 1, [(3 dc, ch 2, 3 dc) in next corner sp, ch 1] 3 times; join.",
    ],
)
def test_a_round_that_begins_in_a_corner(words: str) -> None:
    built = worked(f"{RING}{ONE}{words}\n")
    assert kinds(built, 2) == SECOND and spaces(built, 2) == [6, 6, 6, 6]


def test_a_round_may_end_in_the_space_that_it_began_in() -> None:
    built = worked(
        f"{RING}1st rnd: Ch 6. (3 dc in ring. Ch 3) 3 times. 2 dc in ring. Join. Fasten off. 12 dc and 4 ch-3 sps.\n"
        "2nd rnd: Join B with sl st in any ch-3 sp. Ch 6. 3 dc in same ch-3 sp. *Ch 1. (3 dc. Ch 3. 3 dc) in next ch-3 sp. Rep from * twice. Ch 1. 2 dc in first ch-3 sp. Join. Fasten off. 24 dc, 4 ch-1 sps and 4 ch-3 sps.\n"
        "3rd rnd: Join A with sl st in any ch-3 sp. Ch 6. 3 dc in same ch-3 sp. *Ch 1. 3 dc in next ch-1 sp. Ch 1. (3 dc. Ch 3. 3 dc) in next ch-3 sp. Rep from * twice more. Ch 1. 3 dc in last ch-1 sp. Ch 1. 2 dc in first ch-3 sp. Join. Fasten off. 36 dc, 8 ch-1 sps and 4 ch-3 sps.\n"
    )
    assert kinds(built, 2) == "ch3dc 3 ch 3 dc ch 3 dc 3 ch 3 dc ch 3 dc 3 ch 3 dc ch 3 dc 3 ch 3 dc ch 2 dc"
    assert spaces(built, 2) == [6] * 4 and sorted(spaces(built, 3)) == [3] * 4 + [6] * 4


@pytest.mark.parametrize(
    "words, many",
    [
        (
            "Rnd 2: Ch 1, sc in each dc and (sc, ch 2, sc) in each ch-2 sp around; join with sl st to first sc. (20 sc)",
            28,
        ),
        ("Rnd 2: Ch 1, sc in each dc and 2 sc in each ch-2 sp around. Join. 20 sc.", 20),
        (
            "Rnd 2: Join B with sc in any corner sp, (sc, ch 2, 2 sc) in same sp, *sc in next 3 dc, (2 sc, ch 2, 2 sc) in next corner sp; rep from * 2 more times, sc in next 3 dc; join.",
            36,
        ),
    ],
)
def test_stitches_and_spaces_are_worked_as_they_come(words: str, many: int) -> None:
    built = worked(f"{RING}{ONE}{words}\n")
    row = next(r for r in built.rounds if r.number == 2)
    assert row.count == many
    hook, below = built.hook, next(r for r in built.rounds if r.number == 1)
    into = {u for n in range(row.first, row.last + 1) for u in hook.anchors[hook.ends[n] : hook.ends[n + 1]]}
    tops = {n for n in range(below.first, below.last + 1) if hook.styles[hook.style[n]][0] != "ch"}
    assert tops <= into  # no stitch of the square is left out, wherever the round began


def test_chains_that_count_as_a_stitch_and_a_space() -> None:
    lace = (
        "With A, ch 5; join with sl st in first ch to form ring.\nRound 1: Ch 3 (counts as first dc), 15 dc in ring; join with sl st in 3rd ch of beginning ch-3 – 16 dc.\n"
        "Round 2: Ch 5 (counts as first dc and ch-2 space), [dc in next dc, ch 2] 15 times; join with sl st in 3rd ch of beginning ch-5 – 16 dc and 16 ch-2 spaces.\n"
        "Round 3: Sl st in first ch-2 space, ch 3, 2 dc in same space, ch 1, [3 dc in next ch-2 space, ch 1] 15 times; join – 48 dc.\n"
    )
    built = worked(lace)
    assert kinds(built, 2) == "ch3dc 2 ch" + " dc 2 ch" * 15
    assert spaces(built, 3) == [3] * 16


def test_two_chains_that_count_as_a_single_crochet_and_a_space() -> None:
    built = worked(
        "Ch 12.\nRow 1: Sc in 2nd ch from hook and in each ch across, turn. (11)\n"
        "Row 2: Ch 2 (counts as first sc and ch-1 space here and throughout), skip next sc, sc in next sc, [ch 1, skip next sc, sc in next sc] 4 times.\n"
    )
    assert kinds(built, 2) == "ch1sc ch sc" + " ch sc" * 4


@pytest.mark.parametrize("sides, said", [(6, "5 times"), (5, "4 times")])
def test_the_ring_of_a_hexagon(sides: int, said: str) -> None:
    built = worked(
        f"{RING}Rnd 1: Ch 3, dc in ring, ch 1, (2 dc in ring, ch 1) {said}; join with sl st in top of ch-3. {2 * sides} dc and {sides} ch-1 sps.\n"
        f"Rnd 2: Sl st in next dc and in ch-1 sp, ch 3, (dc, ch 1, 2 dc) in same sp, (2 dc, ch 1, 2 dc) in each ch-1 sp around; join. {4 * sides} dc.\n"
        f"Rnd 3: Ch 1, sc in each dc and ch-1 sp around; join. {5 * sides} sc.\n"
    )
    assert spaces(built, 2) == [4] * sides and kinds(built, 3) == f"{5 * sides} sc"


def test_petals_in_a_ring() -> None:
    built = worked(
        "With B, make a magic ring.\nRnd 1: [Ch 3, 2 dc in ring, ch 3, sl st in ring] 5 times. Fasten off.\n"
    )
    assert kinds(built, 1) == " ".join(["3 ch 2 dc 3 ch sc"] * 5)


def test_a_count_of_spaces_is_no_count_of_stitches() -> None:
    text = "With A, ch 6, join with a sl st to form a ring.\nRnd 1: Ch 1, 16 sc in ring, sl st to first sc. (16 sc)\nRnd 2: Ch 1, sc in same st, *ch 3, skip next st, sc in next st; rep from * 6 more times, ch 3, skip last st, sl st in first sc. (8 ch-3 sps)\n"
    assert (
        spaces(
            worked(f"{text}Rnd 3: *(Sc, hdc, 3 dc, hdc, sc) in next ch-3 sp; rep from * around, sl st in first sc.\n"),
            3,
        )
        == [7] * 8
    )


@pytest.mark.parametrize("start", ["tospace", "tospace(half)"])
def test_written_back_it_is_the_same(start: str) -> None:
    end = ", ch, sp{2 dc}" if "half" in start else ""
    built = made(
        f": MR{{[3 dc, 2 ch] x 4}}, join\n: {start}, sp{{ch3dc, 2 ch, 3 dc}}, [ch, sp{{3 dc, 2 ch, 3 dc}}] x 3{end}, join\n"
    )
    again = made(pattern(built).text)
    assert again.graph.edges.tolist() == built.graph.edges.tolist()


# -- readings that what lies below decides ------------------------------------------------------------------------------

SKIRT = "Rnd 1: 6 sc in magic ring. (6)\nRnd 2: 2 sc in each sc around. (12)\nRnd 3: 2 sc in each sc around. (24)\n"


@pytest.mark.parametrize(
    "words", ["Dc in front loop only. (24)", "Hdc in back loops only. (24)", "Dc in front loops. (24)"]
)
def test_a_stitch_in_a_loop_is_the_whole_round(words: str) -> None:
    built = worked(f"{SKIRT}Rnd 4: {words}\n")
    assert built.worked[-1].made == 24 and built.worked[-1].left == 0


@pytest.mark.parametrize("words", ["repeat from * to * 6 times. [6 shells]", "repeat 6 times. (6 shells)"])
def test_shells_of_which_nobody_says_that_they_are_in_one_stitch(words: str) -> None:
    """Stitch after stitch they would use up more of the round than there is."""
    built = worked(f"{SKIRT}Rnd 4: *skip 1, 5 dc, skip 1, sl st*, {words}\n")
    assert kinds(built, 4) == "30 dc" and built.worked[-1].left == 0


def test_a_spiral_is_joined_where_its_yarn_ends_and_not_before() -> None:
    built = worked(f"{SKIRT}4th to 8th rnds: 1 sc in each sc around. Sl st in first sc of rnd. Fasten off.\n")
    assert len(built.hook.joins) == 1 and [w.made for w in built.worked][-5:] == [24] * 5


@pytest.mark.parametrize(
    "words", ["sc in back loop of same sc and of each sc around", "sc in back loop of first sc and in each sc around"]
)
def test_a_loop_that_is_said_once_holds_for_the_stitches_that_go_on(words: str) -> None:
    built = worked(f"{SKIRT}Rnd 4: {words}.\n")
    hook, row = built.hook, built.rounds[-1]
    assert len({hook.styles[hook.style[n]][4] for n in range(row.first, row.last + 1)}) == 1 and row.count == 24


def test_an_abbreviation_behind_its_word_is_no_further_stitch() -> None:
    built = worked(
        "Chain (ch) 4.\nJoin with slip stitch (sl st) to first ch to form ring.\n1st rnd: Ch 1. Work 10 single crochet (sc) in ring.\n"
    )
    assert [s.name for s in built.pattern.parts] == ["SQUARE"] and kinds(built, 1) == "10 sc"


def test_a_space_that_nothing_said_the_round_began_in_is_told() -> None:
    where = Span(0, 1)
    one, inside = Action("firstspace", where), Group((Action("firstspace", where),), 2, where)
    for items in ([one], [Action("sc", where), inside], [Action("tospace", where), Action("sc", where), inside]):
        with pytest.raises(NotUnderstood, match="space"):
            begun(items, dict(STITCHES))


def test_what_comes_for_stitches_or_spaces_and_works_none_ends() -> None:
    """ "Chain 4" once for every stitch that comes grew to 200,000 chains, for two minutes."""
    ball = read(Text("Ball\nRnd 1: 6 sc in MR (6)\nRnd 2: 6 sc (6)\n", "ball.txt"))
    part = ball.parts[0]
    chains = Action("ch", Span(0, 2), 4, None, (), ())
    endless = Group((Group((chains,), None, Span(0, 2)), Group((chains,), None, Span(0, 2))), None, Span(0, 2))
    lines = (*part.lines[:-1], replace(part.lines[-1], items=(endless,)))
    with pytest.raises(TambourError, match=ENDLESS):
        build(replace(ball, parts=(replace(part, lines=lines),)))
