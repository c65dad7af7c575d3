"""Rounds as shops, blogs, posts and shared notes set them: in columns, on one line, as numbers alone, with letters and signs of their own."""

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.printed.choose import read

COUNTS = [6, 12, 18, 18, 18, 12, 6]


def edges(text: str, part: int = 0) -> list[int]:
    """The stitches on the edge after each round of a part; nothing of the text is a gap or was not understood."""
    pattern = read(Text(text, "toy.txt"))
    assert not pattern.unread, [(p.message, text[p.span.start : p.span.end]) for p in pattern.unread if p.span]
    built = pattern.built or build(pattern)
    return [w.edge for w in built.worked if w.part == part and w.line.in_round]


@pytest.mark.parametrize(
    "rows",
    [
        "Round Instructions Stitches\n1 6 sc in MR 6\n2 inc x 6 12\n3 (1 sc, inc) x 6 18\n4-5 sc around 18\n6 (1 sc, dec) x 6 12\n7 dec x 6 6\n",
        "Rnd\tWhat\tCount\n1\tMR, 6 sc\t6\n2\tinc in each\t12\n3\t(1 sc, inc) x 6\t18\n4 - 5\tsc\t18\n6\t(1 sc, dec) x 6\t12\n7\tdec around\t6\n",
        "1   6 sc in magic ring    6\n2   inc x6    12\n3   (1 sc, inc) x6    18\n4   sc    18\n5   sc    18\n6   (1 sc, dec) x6    12\n7   dec x6    6\n",
        "Round Sts Instructions\n| 1 | 6 | 6 sc in MR |\n| 2 | 12 | inc x 6 |\n| 3 | 18 | (1 sc, inc) x 6 |\n| 4-5 | 18 | sc around |\n| 6 | 12 | (1 sc, dec) x 6 |\n| 7 | 6 | dec x 6 |\n",
    ],
)
def test_columns_are_rounds(rows: str) -> None:
    assert edges(f"Toy\n\nHead\n{rows}Fasten off.\n") == COUNTS


@pytest.mark.parametrize(
    "line",
    [
        "R1 6sc in MR (6) R2 inc around (12) R3 *sc 1, inc* around (18) R4-R5 sc around (18) R6 *sc 1, dec* around (12) R7 dec around (6) FO.",
        "R1: 6 sc in mr (6), R2: inc x6 (12), R3: (sc, inc) x6 (18), R4-5: sc (18) stuff R6: (sc, dec) x6 (12) R7: dec x6 (6)",
        "Rnd 1 6 sc in magic ring (6). Rnd 2 inc x 6 (12). Rnd 3 (sc, inc) x 6 (18). Rnds 4-5 sc around (18). Rnd 6 (sc, dec) x 6 (12). Rnd 7 dec x 6 (6).",
    ],
)
def test_rounds_run_together_are_rounds(line: str) -> None:
    assert edges(f"Toy\n\nHead\n{line}\n") == COUNTS


@pytest.mark.parametrize(
    "said",
    [
        "R4, R5: sc around (18)\nR6: (sc, dec) x 6 (12)",
        "R4-R5: sc around (18)\nR6: (sc, dec) x 6 (12)",
        "R4 and R5: sc around (18)\nR6: (sc, dec) x 6 (12)",
    ],
)
def test_rounds_that_share_their_words_are_not_parted(said: str) -> None:
    head = "Toy\n\nHead\nR1: 6 sc in MR (6)\nR2: inc x 6 (12)\nR3: (sc, inc) x 6 (18)\n"
    assert edges(f"{head}{said}\nR7: dec x 6 (6)\n") == COUNTS


@pytest.mark.parametrize(
    "said", ["6, 12, 18, 18, 18, 12, 6", "6 / 12 / 18 / 18 / 18 / 12 / 6", "6\n12\n18\n18 BLO\n18\n12\n6"]
)
def test_the_stitches_of_rounds_alone_are_rounds(said: str) -> None:
    assert edges(f"Toy\n\nHEAD\n{said}\nstuff\n") == COUNTS


@pytest.mark.parametrize(
    ("legend", "said"),
    [
        ("x – single crochet\nV = increase", ["6 x in MR", "6 V", "(1 x, V)*6"]),
        ("KA - amigurumi ring\nSb - single crochet\nPr - increase", ["6 sb in the ka", "6 pr", "(1 sb, pr) * 6"]),
        ("Key: s = single crochet, ic = increase, am = magic ring", ["6 s in am", "ic x6", "(s, ic) x6"]),
    ],
)
def test_words_that_the_text_explains_are_known(legend: str, said: list[str]) -> None:
    rounds = "\n".join(
        f"R{k}: {words} ({count})" for k, (words, count) in enumerate(zip(said, COUNTS, strict=False), 1)
    )
    assert edges(f"Toy\n\nAbbreviations\n{legend}\n\nHead\n{rounds}\n") == COUNTS[:3]


@pytest.mark.parametrize(
    "rounds",
    [
        "1st round. — 6 d.c. into loop.\n2nd round. — 2 d.c. into each d.c. (12 d.c.).\n3rd round. — * 1 d.c. into next d.c., 2 d.c. into next d.c.; rep. from * all round (18 d.c.).",
        "1 row： ６ dc in MR （6）\n2 row： 6 inc （12）\n３ row： （1 dc， inc）×6 (18)",
        "Rnd 1 ➜ 6 dc in a magic ring {6}\nRnd 2 ➜ inc x 6 {12}\nRnd 3 → 1 dc, inc, repeat around {18}",
    ],
)
def test_points_wide_signs_and_arrows_are_read_as_plain_ones(rounds: str) -> None:
    assert edges(f"Toy (UK terms)\n\nHead\n{rounds}\n") == COUNTS[:3]


@pytest.mark.parametrize(
    "rounds",
    [
        "Rd 1: 6 fM in FR (6)\nRd 2: alle M verd. (12)\nRd 3: jede 2. M verd. (18)\nRd 4-5: je 18 fM (18)\nRd 6: jede 2. und 3. M zus. (12)\nRd 7: immer 2 M zus. (6)",
        "Rnd 1: 6 sc in MR (6)\nRnd 2: increase in every stitch (12)\nRnd 3: increase in every second stitch (18)\nRnds 4-5: without changes (18)\nRnd 6: (sc, dec) x 6 (12)\nRnd 7: dec x 6 (6)",
        "1e toer: 6 v in een magische ring (6)\n2e toer: 6 meerd. (12)\n3e toer: in elke 2e v een meerdering (18)\n4e - 5e toer: 18 v (18)\n6e toer: *1 v, 2 v sh*, herhaal 6x (12)\n7e toer: 6x 2 v sh (6)",
        "Rang 1 : 6 ms dans un cercle magique (6)\nRang 2 : 6 augm. (12)\nRang 3 : *1 ms, 1 augm.* 6 fois (18)\nRang 4 et 5 : sans augmentation (18)\nRang 6 : *1 ms, 2 ms ens.* 6 fois (12)\nRang 7 : 6 fois 2 ms ens. (6)",
        "Vta 1: 6 mp en un aro mágico = 6\nVta 2: 2 mp en cada punto = 12\nVta 3: (1 mp, 1 aum) repetir 6 veces = 18\nVta 4 y 5: solo la hebra de atrás, 18 mp = 18\nVta 6: (1 mp, 1 dis) repetir 6 veces = 12\nVta 7: 6 dis = 6",
    ],
)
def test_every_second_stitch_and_two_together_in_five_languages(rounds: str) -> None:
    assert edges(f"Toy\n\n{rounds}\n") == COUNTS


@pytest.mark.parametrize(
    ("chain", "first"),
    [
        ("5 Lm anschlagen.", "Reihe 1: ab der 2. Lm von der Nadel 4 fM (4)"),
        ("Haak 5 lossen.", "Rij 1: vanaf de 2e losse op de haaknaald 4 vasten (4)"),
        ("5 ml", "Rang 1 : dans la 2e ml à partir du crochet, 4 ms (4)"),
    ],
)
def test_chains_are_counted_from_the_hook(chain: str, first: str) -> None:
    assert edges(f"Toy\n\n{chain}\n{first}\n") == [4]
