"""A text of people's that is printed again in its own language holds all that hands do, in its designer's words."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.core.progress import Progress
from tambour.crochet.page.instructions import plain
from tambour.crochet.params import CrochetParams
from tambour.crochet.plush import make

OTTER = """Otter

MATERIALS
Riverside DK, 1 ball Slate (A), 1 ball Oat (B)
3.5 mm hook
40 cm of green ribbon
2 buttons, 9 mm

NOTES
Change yarn in the last loops of the stitch before.

BODY
With A, ch 2.
Rnd 1: 6 sc in 2nd ch from hook.
Rnds 2 and 3: 2 sc in each sc around. 24 sc at end of Rnd 3.
Rnds 4-9: Sc in each sc around.
Stuff Body.
Rnd 10: (Sc in next 2 sc, sc2tog) 6 times (18)
Rnd 11: (Sc in next sc, sc2tog) 6 times (12)
Finish stuffing.
Rnd 12: Sc2tog around (6)
Fasten off, leaving a long tail.

ARM (make 2)
With B, ch 2.
Rnd 1: 6 sc in 2nd ch from hook.
Rnds 2-5: Sc in each sc around.
Fasten off. Stuff arms lightly.

FINISHING
With B, embroider eyes as French knots. Sew arms to sides of body at Rnd 8. Tie the ribbon around the neck.
"""


def reprint(words: str, terms: str | None = None) -> list[str]:
    piece = make(Text(words, "otter.txt"), CrochetParams(solver="none", terms=terms), Progress())
    return plain(piece).text.splitlines()


@pytest.mark.parametrize(
    "said",
    [
        "- 40 cm of green ribbon",
        "- 2 buttons, 9 mm",
        "Change yarn in the last loops of the stitch before.",
        "Stuff Body.",
        "Finish stuffing.",
        "Stuff arms lightly.",
    ],
)
def test_what_hands_do_and_need_stands_in_her_words(said: str) -> None:
    assert reprint(OTTER).count(said) == 1


def test_her_sentences_of_the_assembly_are_hers_and_what_the_pictures_chose_stands_beside() -> None:
    lines = reprint(OTTER)
    put = lines[lines.index("Assembly") :]
    assert any(line.startswith("- With B, embroider eyes as French knots.") for line in put)
    assert any(line.startswith("- Sew arms to sides of body at Rnd 8. (") for line in put)
    assert any("Tie the ribbon around the neck" in line for line in put)


def test_stuffing_goes_in_before_the_rounds_that_close() -> None:
    lines = reprint(OTTER)
    assert lines.index("Stuff Body.") < next(k for k, x in enumerate(lines) if x.startswith("Rnd 10"))
    assert lines.index("Finish stuffing.") < next(k for k, x in enumerate(lines) if x.startswith("Rnd 12"))


def test_a_count_at_the_end_of_several_rounds_is_that_of_the_last() -> None:
    lines = reprint(OTTER)
    assert "Rnd 2: 6 inc (12)" in lines and "Rnd 3: 12 inc (24)" in lines
    assert not any("as written it makes" in line for line in lines)


def test_in_another_language_it_is_printed_in_that_languages_words() -> None:
    lines = reprint(OTTER, "de")
    assert "Stuff Body." not in lines and any(line.startswith("Rd 12") for line in lines)
