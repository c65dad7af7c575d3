"""Passes: the table that says which of them a line concerns leaves out none that would change it."""

from pathlib import Path

import pytest

from tambour.crochet.printed.tokens import rows
from tambour.crochet.printed.wordings import passes
from tambour.crochet.printed.wordings.inner import evened
from tambour.crochet.printed.wordings.vocabulary import vocabulary

TEXTS = sorted(path for path in (Path(__file__).parent / "data").rglob("*.txt"))
WORDINGS = """\
Round 1: Sc in next 4 ch, 3 sc in last ch, working in front loops of chain, sc in next 4.
Row 1: Sc in next 4 ch, 3 sc in last ch, working in the back loops of foundation, sc in next 4.
Row 1: Sc in next 4 ch, 3 sc in last ch, back along the chain sc in next 4 ch.
Row 1: Sc in next 4 ch, 3 sc in last ch, back down the foundation, sc 4.
Round 1: 2 sc in next ch, sc in next 4, sc in rem loops of next 3 ch.
Round 1: 2 sc in next ch, sc in next 4, sc in unworked loops of next 3 ch.
Round 2: Sc twice in next st, 2sc6, 8 more sc, no increases, turn your work.
Round 3: bobble of 4 dc, sc 8, inc (2 times), 6 sc [FLO], sc in the rest.
Round 4: inc every 3rd st. Round 5: 3 sc in next st, ch 8 + 1, sc in every 3rd st around.
Round 6: Leave 3 sts, ch 3, sc in each st across, 3 dc, ch 2, 3 dc in corner, 1 sc and 1 hdc in next st.
Using 4 mm hook and Mustard, ch 4, join B in 13th sc of previous round, sc until 2 sts remain, dec.
Round 7: *ch 5, sl st back down the chain, sl st in next sc* around, ch 6, turn, sl st in 2nd ch and along to ring.
Round 8: (ch 6, sl st in 2nd ch from hook, sl st back along the next 4 ch, 1 sc in ring) 5 times. Ch 6, skip 1, sl st in next 5.
*Ch 10, sl st in 2nd ch and in next 8 ch* twice more.
Work as for Arm, omitting all references to color changes. Repeat Rnds 1-4 of Arm in C, with no color changes.
As for Arm, using C instead of B. Same as Arm but work Rounds 1-4 with C. Repeat Rnd 4, replacing A with C. As Arm, all in C.
Work as Arm, substituting C for A. Work as for Arm, using C for Rnds 2-3. Same as Arm, in one color throughout.
R3: 1 sc 1 inc x 6 (18). R4: 2 sc inc x 6 (24). R5: sc3 inc1 x3 (15). R6: 3 sc 1 inc *3 (15). R7: sc inc six times (18).
8 sc; 2 inc; 8 sc - 1 thumb and 8 sc. Fold flat and work 6 sc through both layers.
""".splitlines()


def missed(said: str, code: str = "us") -> list[str]:
    """The passes that would change a line of ``said`` though the table has it that none of its words concerns them."""
    found, known = [], vocabulary(code)
    for row in rows(said):
        tokens = known._phrased(evened(row.tokens))
        for k, one in enumerate(passes._PASSES):
            made = one.put(tokens)
            found += [one.put.__name__] if made != tokens and not passes._concerned(tokens) >> k & 1 else []
            tokens = made
    return found


@pytest.mark.parametrize("said", WORDINGS)
def test_no_wording_is_kept_from_a_pass_that_changes_it(said: str) -> None:
    assert not missed(said)


@pytest.mark.slow
@pytest.mark.parametrize("code", ["us", "uk", "de", "fr", "es", "nl"])
def test_no_line_of_our_texts_is_kept_from_a_pass_that_changes_it(code: str) -> None:
    for path in TEXTS:
        assert not missed(path.read_text(encoding="utf-8"), code), path.name
