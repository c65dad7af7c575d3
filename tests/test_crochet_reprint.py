"""A printed pattern's text carries all that its booklet does: a maker has it alone in her hands."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.page.instructions import plain, view
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make
from tambour.crochet.printed.choose import read

OTTER = """Otto the Otter
Pattern by Fern Lane

He floats on his back.

MATERIALS
Yarn: DK, 50 g in brown (A) and a little cream (B).
Hook: 3 mm.
Two black beads, a scrap of felt.

BODY
With A, ch 2.
Round 1: 6 sc in 2nd ch from hook - 6 sc.
2nd and 3rd rounds: 2 sc in each sc around. 24 sc at end of 3rd round.
Rounds 4-9: Sc in each sc around; do not join, place marker.
Stuff Body.
Round 10: *Sc2tog; rep from * around - 12 sc.
Fasten off, leaving a long tail. Sew the bottom edge closed.

PAW (make 2)
With B, ch 2.
Round 1: 5 sc in 2nd ch from hook - 5 sc.
Rounds 2-3: Sc in each sc around.
Do not stuff. Fasten off.

FINISHING
Sew the paws to the body between rounds 5 and 6, 6 stitches apart.
With black yarn, embroider two closed eyes on the body over round 4, in backstitch.
Brush him a little.
"""


@pytest.fixture(scope="module")
def reprint() -> str:
    return plain(make(Text(OTTER, "otter.txt"), CrochetParams(solver="none"), Progress())).text


@pytest.mark.parametrize(
    "said",
    [
        "by Fern Lane",
        "He floats on his back.",
        "Two black beads, a scrap of felt.",
        "Stuff Body.",
        "leaving a long tail.",
        "Sew the bottom edge closed.",
        "Do not stuff.",
        "do not join, place marker.",
        "Sew the paws to the body between rounds 5 and 6, 6 stitches apart.",
        "With black yarn, embroider two closed eyes on the body over round 4, in backstitch.",
        "Brush him a little.",
    ],
)
def test_what_she_says_is_there(reprint, said):
    assert said in reprint


def test_a_count_of_two_rounds_is_the_last_ones(reprint):
    assert "Rnd 2-3: 2 sc in each sc around. 24 sc at end of 3rd round. (24)" in reprint
    assert "as written" not in reprint


def test_a_round_that_begins_on_chains_is_no_ring(reprint):
    """Two chains and six stitches in the second are drawn as a ring; she begins otherwise, and says how."""
    assert "With A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook (6)" in reprint and "magic ring" not in reprint


def test_sentences_stand_in_their_order(reprint):
    order = ["Rnd 4-9", "do not join", "Stuff Body", "Rnd 10", "Fasten off, leaving", "bottom edge closed", "PAW"]
    places = [reprint.index(words) for words in order]
    assert places == sorted(places)


@pytest.mark.parametrize("marks", [plain, view])
def test_it_reads_as_the_same_pattern(marks):
    piece = make(Text(OTTER, "otter.txt"), CrochetParams(solver="none"), Progress())
    again = make(Text(marks(piece).text, "again.txt"), CrochetParams(solver="none"), Progress())
    rounds = [[r.count for r in one.built.rounds if r.count] for one in (piece, again)]
    assert rounds[0] == rounds[1]
    kinds = [sorted(type(f).__name__ for f in one.built.pattern.finish) for one in (piece, again)]
    assert kinds[0] == kinds[1]
    assert not again.built.pattern.unread


def test_a_line_of_ours_is_not_read_as_hers():
    """What stands behind a › is found again; in a text of other people it is a line as any."""
    mine = "Ball\n\nAbbreviations (US terms)\n\nBODY\nRnd 1: 6 sc in magic ring (6)\n› Each 2 stitches from Rnd 1.\nRnd 2: 6 inc (12)\n"
    assert not read(Text(mine, "mine.txt")).unread
    theirs = "BODY\nRnd 1: 6 sc in magic ring (6)\n› Rnd 2: 6 inc (12)\n"
    assert [line.number for line in read(Text(theirs, "theirs.txt")).parts[0].lines] == [1, 2]


@pytest.mark.parametrize("bullet", list("•›»‣⁃∙~▪➤✓☐-"))
def test_a_bullet_before_a_round_is_a_bullet(bullet):
    text = f"BODY\n{bullet} Rnd 1: 6 sc in magic ring (6)\n{bullet} Rnd 2: 6 inc (12)\n"
    pattern = read(Text(text, "listed.txt"))
    assert [line.number for line in pattern.parts[0].lines] == [1, 2] and not pattern.unread


def test_yarns_keep_the_letters_that_she_gives_them():
    """Her sentences go on saying C, whichever yarn is taken up first."""
    text = (
        "Rug\n\nABBREVIATIONS\nA, B, and C = Color A, Color B, and Color C\nch = chain\n\nRUG\nWith C, ch 7.\n"
        "Row 1: Sc in 2nd ch from hook and in each ch across; turn - 6 sc.\nRow 2: With B, ch 1, sc in each sc across; turn.\n"
        "Row 3: With A, ch 1, sc in each sc across; turn.\nCut a fringe of C.\n"
    )
    piece = make(Text(text, "rug.txt"), CrochetParams(solver="none"), Progress())
    said = plain(piece).text
    assert list(piece.built.pattern.letters) == ["C", "B", "A"]
    assert "With C, ch 7." in said and "Row 2: With B, ch 1" in said and "Row 3: With A, ch 1" in said
    assert "A, B, and C = Color A, Color B, and Color C" in said and "\n- C = " not in said


@pytest.mark.parametrize(
    "end",
    [
        "Fasten off, leaving a long tail for sewing.",
        "Fasten off leaving a long end.",
        "Fasten off.",
        'Join. Fasten off, leaving a 12" tail.',
        "Sl st in next sc. Fasten off leaving a long end for sewing.",
    ],
)
def test_a_piece_is_fastened_off(end):
    """It vanished wherever it stood in the last round's own line."""
    tail = "TAIL\nRound 1: 6 sc in magic ring.\nRounds 2-5: Sc in each sc."
    for between in (" ", "\n"):
        text = f"Cat\n\nEAR (make 2)\nRound 1: 6 sc in magic ring - 6 sc.\n\n{tail}{between}{end}\n"
        said = plain(make(Text(text, "cat.txt"), CrochetParams(solver="none"), Progress())).text
        words = end[end.index("Fasten") :]
        assert said.count(words) == 1 and said.lower().count("long tail") <= 1
        assert said.index("Rnd 2-") < said.index(words)
