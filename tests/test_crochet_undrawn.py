"""A booklet says what it does not show, what is not its designer's, and puts each of her sentences under its step."""

from __future__ import annotations

from functools import cache

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.page.assembly import _told
from tambour.crochet.page.book import OURS, Book
from tambour.crochet.page.parts import _explained, with_hers
from tambour.crochet.page.placement import placement
from tambour.crochet.page.undrawn import undrawn
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

FINCH = """FINCH THE BIRD

MATERIALS
DK yarn in brown and cream, 3 mm hook, fiberfill

BODY
With brown. Begin at the bottom.
Rnd 1: 6 sc in MR (6)
Rnd 2: inc x 6 (12)
Rnd 3: (1 sc, inc) x 6 (18)
Rnd 4: (2 sc, inc) x 6 (24)
Rnd 5: (3 sc, inc) x 6 (30)
Rnd 6-14: sc in each st (30)
Rnd 15: (3 sc, dec) x 6 (24)
Rnd 16: (2 sc, dec) x 6 (18)
Stuff firmly.
Rnd 17: (1 sc, dec) x 6 (12)
Rnd 18: dec x 6 (6)
Fasten off.

HIPS (make 2)
With brown.
1. 6 sc in a magic ring. [6]
2. 2 sc in each st. [12]
3. *Sc in next st, 2 sc in next st; rep from * 5 more times. [18]
4. *Sc in next 2 sts, 2 sc in next st; rep from * 5 more times. [24]
5. Sc in each st. [24]
Fold flat so the increases are at the sides: you have a rim of 12 sts.

FEET (make 2)
With cream.
Rnd 1: 6 sc in MR (6)
Rnd 2: (1 sc, inc) x 3 (9)
Rnd 3-4: sc in each st (9)
Stuff lightly.

TAIL
With brown.
Rnd 1: 6 sc in MR (6)
Rnd 2-8: sc in each st (6)
Edging, cream - start at a corner: 10 sc up the side, 3 sc over the top.

PUTTING IT TOGETHER
Hips: sew one to each side of the body, the middle on round 9. Poke a last bit of stuffing in before the end.
Feet: sew the open end of each to the hip, toes forward.
Tail: sew the open end to the middle of the back on round 8. Bring it round her left side and catch the tip to the foot. With cream, sew four short straight stitches under the chin as freckles.
Hide all ends.
"""


@cache
def finch() -> Book:
    return Book(make(Text(FINCH, "finch.txt"), CrochetParams(), Progress()))


def test_what_is_told_and_not_drawn_is_listed_in_her_words() -> None:
    told = undrawn(finch())
    for words in ("Bring it round her left side", "Edging, cream"):
        assert any(one.startswith(words) for one in told), told
    assert not any("Hips" in one or "Hide" in one for one in told)


def test_a_sentence_that_names_nothing_stands_with_the_one_before_it() -> None:
    steps = [" ".join(words for words, _ in said) for _, said in _told(finch())]
    hips = next(words for words in steps if words.startswith("Hips"))
    assert "Poke a last bit of stuffing" in hips and "Hide all" not in " ".join(steps), steps


def test_what_closes_an_end_is_no_round_with_a_box() -> None:
    rows = [row for block in finch().said.blocks for row in with_hers(finch(), block)]
    folded = next(row for row in rows if row.words.startswith("Fold flat"))
    assert not folded.label and not folded.count


def test_all_that_is_ours_is_marked() -> None:
    book = finch()
    assert book.marked("words") == f"{OURS}words"
    for block in book.said.blocks:
        for row in _explained(book, block, with_hers(book, block)):
            assert row.hers or row.ours or row.label, row
    for _, said in _told(book):
        for words, _ in said:
            assert words.startswith(OURS) or " ".join(words.split())[:20] in " ".join(FINCH.split()), words


def test_copies_and_small_parts_on_which_nothing_is_counted_have_no_charts() -> None:
    heads = [chunk.title for chunk in placement(finch())]
    assert len(heads) == len(set(heads)) and not any("HIPS" in head for head in heads), heads
