"""Patterns as people post them: small letters without marks, doings on lines of their own, a page's comments below."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Embroidery, Eye
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.pattern import read_printed

BEE = """Ok so many of you asked so here is my bee, free for the group!!

yarn: bulky yellow, black, white. 6mm hook, 15mm eyes

BODY start w yellow
R1: 6sc in MR [6]
R2: inc x6 [12]
R3: (1sc, inc)x6 [18]
R4-6: sc around [18]
{eyes}
switch to black
R7-8: sc around [18]
yellow
R9: (1sc, dec)x6 [12]
stuff!!
R10: dec x6 [6]
FO, sew the hole shut

WINGS white x2
R1: 6sc in MR [6]
R2: inc x6 [12]
FO, leave tail. sew on top of body at R5

smile: black yarn, btw the eyes on R6

👍 312   58 comments   77 shares
Like  Comment  Share
Kim how much yarn did u use?
Nora like half a skein of yellow and less than 1/4 of the others x
View 55 more comments
"""


def dyes(items: tuple[Item, ...]) -> list[Action]:
    return [a for i in items for a in (dyes(i.items) if isinstance(i, Group) else [i] if i.name == "color" else [])]


@pytest.mark.parametrize("eyes", ["eyes btw R5 & R6, 7 st apart", "15mm eyes between R5 and R6, 7 st apart", "press the eyes in b/w R5 & R6, 7 st apart"])  # fmt: skip
def test_a_pattern_of_a_chat_is_read_whole(eyes: str) -> None:
    pattern = read_printed(Text(BEE.format(eyes=eyes), "bee.txt"))
    assert [(p.name, p.copies) for p in pattern.parts] == [("BODY", 1), ("WINGS", 2)] and not pattern.unread
    assert [len([a for line in p.lines for a in dyes(line.items)]) for p in pattern.parts] == [3, 1]
    put = [f for f in pattern.finish if isinstance(f, Eye)]
    assert [(e.size, e.spot.round) for e in put] == [(15.0, 5.5)] * 2
    assert any(isinstance(f, Embroidery) for f in pattern.finish)


@pytest.mark.parametrize(
    "note", ["stuff", "start to stuff here", "put the coin into the base, stuff", "stuff firmly", "fasten off black"]
)
def test_a_note_below_a_round_is_no_part_of_it(note: str) -> None:
    text = f"Rook\n\nX = single crochet, V = increase, A = decrease\n\nROOK\nR1  6X in magic ring  = 6\nR2  6V  = 12\nR3-R8  12X  = 12\n{note}\nR9  FLO (X, V)*6  = 18\nR10-R12  18X  = 18\n"
    pattern = read_printed(Text(text, "rook.txt"))
    rounds = [w.made for w in build(pattern).worked if w.line.in_round and w.made]
    assert not pattern.unread and rounds == [6, *[12] * 7, *[18] * 4]


def test_a_sentence_below_a_count_is_no_part_of_the_round() -> None:
    rounds = "".join(
        f"Rnd {k}: *1 sc in next {n} sts, 2 sc in next st; rep from * to end. {6 * (n + 2)} sts\n"
        for k, n in ((3, 1), (4, 2), (5, 3))
    )
    text = f"Doll\n\nHEAD\nRnd 1: 6 sc in ring. 6 sts\nRnd 2: 2 sc in each st around. 12 sts\n{rounds}Rnds 6-9: 1 sc in each st around. 30 sts\nRnd 10: *1 sc in next 3 sts, sc2tog; rep from * to end. 24 sts\nFix eyes between Rnds 7 and 8, 7 sts apart. Stuff head.\nRnd 11: *1 sc in next 2 sts, sc2tog; rep from * to end. 18 sts\n"
    pattern = read_printed(Text(text, "doll.txt"))
    assert [w.made for w in build(pattern).worked if w.line.in_round][-2:] == [24, 18] and not pattern.warnings


@pytest.mark.parametrize("below", ["Comments\n\nAnna says:\nMarch 15, 2022 at 7:02 am\nI am stuck at Rnd 6, I get 14 instead of 15?", "You might also like\n10 Best Yarns for Amigurumi", "Related: 15 Dinosaur Crafts Your Kids Will Love", "3 responses\nJo: 6 sc, then 3 decreases, then 6 sc"])  # fmt: skip
def test_what_stands_around_a_pattern_on_its_page_is_none(below: str) -> None:
    text = (
        f"Egg\n\nBody\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnds 3-6: sc around (12)\nFasten off.\n\n{below}\n"
    )
    pattern = read_printed(Text(text, "egg.txt"))
    assert not pattern.unread and len(pattern.parts) == 1


@pytest.mark.parametrize("name", ["CHERRY (Red)", "STRAWBERRY (Red)", "ROSE (pink)"])
def test_a_part_called_like_a_colour_with_its_yarn_in_brackets_is_a_part(name: str) -> None:
    text = f"Cake\n\nBOTTOM (White)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nFasten off.\n\n{name}\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n"
    assert [p.name for p in read_printed(Text(text, "cake.txt")).parts] == ["BOTTOM", name.split()[0]]
