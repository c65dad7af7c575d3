"""What designers post: headings, heads, counts, labels and chains, each in the ways that people have for it, read alike."""

from __future__ import annotations

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.tree import Pattern
from tambour.crochet.printed.choose import read

YARN = "Bear\n\nMaterials: yarn in brown, cream; 3 mm hook\n\n"
BODY = "Body (brown)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: (sc, inc) x 6 (18)\nFasten off.\n\n"
BALL = "Rnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: sc around (12)\nFasten off.\n"


def told(pattern: Pattern) -> list[str]:
    """What was not understood, as it stands in the text."""
    return [pattern.text.text[p.span.start : p.span.end] for p in pattern.unread if p.span]


def counts(words: str, whole: bool = True) -> list[list[int]]:
    """Stitches after each round, part by part, of a text that is read whole."""
    pattern = read(Text(words, "toy.txt"))
    assert not whole or not told(pattern)
    built = build(pattern)
    return [
        [
            w.edge or w.made
            for w in built.worked
            if built.parts[w.part].section == k and built.parts[w.part].copy == 1 and w.line.in_round and not w.line.gap
        ]
        for k in range(len(pattern.parts))
    ]


@pytest.mark.parametrize(
    ("heading", "copies"),
    [
        ("Ears • make 2 • cream", 2),
        ("Ears (2 parts). We start with cream", 2),
        ("ears (cream)", 0),
        ("Ears » 2x » cream", 2),
        ("Ear (you'll need two)", 2),
        ("LEFT AND RIGHT EAR", 2),
        ("Ears – do it twice", 2),
        ("EARS … make 2", 2),
        ("EARS  •  all in one, from the tip down  •  cream", 0),
        ("Ears (x2), in rounds, cream", 2),
    ],
)
def test_a_part_is_called_by_its_heading(heading: str, copies: int) -> None:
    pattern = read(Text(f"{YARN}{BODY}{heading}\n{BALL}", "toy.txt"))
    assert not told(pattern)
    assert [p.name.lower().rstrip("s") for p in pattern.parts] == ["body", "ear"]
    assert not copies or pattern.parts[1].copies == copies


@pytest.mark.parametrize("sentence", ["stuff the ears", "sew ears", "eyes go between rnds 2 and 3"])
def test_a_sentence_in_small_letters_heads_no_part(sentence: str) -> None:
    pattern = read(Text(f"{YARN}{BODY}{sentence}\n\nEars\n{BALL}", "toy.txt"))
    assert [p.name for p in pattern.parts] == ["Body", "Ears"]


@pytest.mark.parametrize(
    "head", ["R.{}", "Round #{}", "{}-", "R{}»", "R{}~", "Rnd {}--", "Round {}✨:", "▫️r{}", "R{} 🖤", "#{}"]
)
def test_a_round_is_known_by_its_number(head: str) -> None:
    said = [
        "6 sc in MR (6)",
        "inc x 6 (12)",
        "(sc, inc) x 6 (18)",
        "sc around (18)",
        "(sc, dec) x 6 (12)",
        "dec x 6 (6)",
    ]
    rounds = "".join(f"{head.replace('{}', str(k))} {words}\n" for k, words in enumerate(said, 1))
    assert counts(f"Bear\n\nHead\n{rounds}Fasten off\n") == [[6, 12, 18, 18, 12, 6]]


@pytest.mark.parametrize(
    "count", ["tot. 12", "sum 12", "you have 12 now", "to make 12", "12 sts now", "12sts", "  12", "  12  (1 rnd)"]
)
def test_a_count_ends_its_round(count: str) -> None:
    said = [
        ("6 sc in MR", 6),
        ("inc x 6", 12),
        ("(sc, inc) x 6", 18),
        ("sc around", 18),
        ("(sc, dec) x 6", 12),
        ("dec x 6", 6),
    ]
    rounds = "".join(f"Rnd {k}: {words} {count.replace('12', str(n))}\n" for k, (words, n) in enumerate(said, 1))
    assert counts(f"Bear\n\nHead\n{rounds}Fasten off\n") == [[6, 12, 18, 18, 12, 6]]


@pytest.mark.parametrize(
    "said",
    [
        "time for the ears! 12 sc",
        "ears: 12 sc",
        "Ear holes: 12 sc",
        "neck - 12 sc",
        "(knee) 12 sc",
        "12 sc without changes",
        "12 sc behind the back half-loop",
        "sc in each sc of previous round",
        "sc into every single stitch",
        "BLO - 12 sc",
        "12 scblo",
        "crochet 12",
        "keep going: 12 sc",
        "🤎6 sc 🤍6 sc",
    ],
)
def test_a_round_in_the_words_people_have(said: str) -> None:
    words = (
        f"{YARN}Head (brown)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: {said} (12)\nRnd 4: sc around (12)\n"
    )
    assert counts(words) == [[6, 12, 12, 12]]


@pytest.mark.parametrize("said", ["with B: 12 sc", "FLO: 12 sc", "cream: 12 sc"])
def test_a_yarn_or_a_loop_before_a_colon_is_no_name(said: str) -> None:
    pattern = read(
        Text(f"{YARN}Head (brown)\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nRnd 3: {said} (12)\n", "t.txt")
    )
    assert any(getattr(i, "name", "") in ("color", "flo") for i in pattern.parts[0].lines[-1].items)


_LANGUAGES = {
    "en": "Body\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n\nWing\n",
    "fr": "Corps\nT1 : 6 ms dans un cm (6)\nT2 : 6 aug (12)\n\nAile\n",
    "de": "Körper\nRd 1: 6 fM in den Magischen Ring (6)\nRd 2: 6 Zun (12)\n\nFlügel\n",
    "es": "Cuerpo\nV1: 6 pb en anillo mágico (6)\nV2: 6 aum (12)\n\nAla\n",
    "nl": "Lijf\nToer 1: 6 v in mr (6)\nToer 2: 6 meerd (12)\n\nVleugel\n",
}


@pytest.mark.parametrize(
    ("language", "chain", "said", "made"),
    [
        ("en", "Ch 8 + 1", "Row 1: 8 sc, turn", 8),
        ("fr", "Montez 9 ml.", "R1 : 8 ms à partir de la 2e ml, tournez", 8),
        ("fr", "Montez 9 ml.", "R1 : à partir de la 2e ml : 8 ms, tournez", 8),
        ("fr", "Faire une chaînette de 9 ml", "R1 : 8 ms en commençant dans la 2e ml, tourner", 8),
        ("de", "9 Lm anschlagen", "R 1: ab der 2. Lm 8 fM, wenden", 8),
        ("de", "9 Lm", "R 1: 8 fM ab der 2. Lm, wenden", 8),
        ("de", "9 Lm anschlagen.", "R 1: in die 2. Lm von der Nadel aus: 8 fM, wenden", 8),
        ("de", "8 Lm + 1 Wendeluftmasche", "R 1: 8 fM, wenden", 8),
        ("es", "Hacer 9 cadenas", "H1: desde la 2ª cadena, 8 pb, girar", 8),
        ("es", "Tejer 9 cadenas.", "H1: empezando en la 2ª cadena desde el ganchillo: 8 pb, girar", 8),
        ("nl", "Haak een ketting van 9 l", "Rij 1: begin in de 2e losse: 8 v, keren", 8),
        (
            "fr",
            "5 ml",
            "T1 : dans la 2e ml à partir du crochet : 3 ms, 3 ms dans la dernière ml, de l'autre côté de la chaînette : 2 ms, aug",
            10,
        ),
        ("fr", "5 ml", "T1 : 3 ms, 3 ms dans la dernière ml, continuer de l'autre côté de la chaînette, 2 ms, aug", 10),
        (
            "de",
            "5 Lm anschlagen",
            "Rd 1: ab der 2. Lm: 3 fM, 3 fM in die letzte Lm, auf der anderen Seite: 2 fM, Zun",
            10,
        ),
        (
            "es",
            "5 cad",
            "V1: 3 pb, 3 pb en la última cad, girar y seguir por el otro lado de la cadeneta: 2 pb, aum",
            10,
        ),
        ("nl", "5 l", "Toer 1: vanaf de 2e l: 3 v, 3 v in de laatste l, andere kant: 2 v, meerd", 10),
    ],
)
def test_a_chain_and_its_other_side_in_five_languages(language: str, chain: str, said: str, made: int) -> None:
    assert counts(f"{_LANGUAGES[language]}{chain}\n{said} ({made})\n") == [[6, 12], [made]]


def test_words_of_a_translation_that_another_language_has_for_its_stitches_do_not_make_it_that_language() -> None:
    legend = "Legend:\nKA – amigurumi ring\nRLS – single crochet\nPR – increase (2 RLS in one loop)\nUB – decrease (2 RLS together)\n\n"
    rounds = "1 row: 6 RLS in KA\n2 row: 6 PR (12)\n3 row: (1 RLS, PR) * 6 (18)\n4-5 rows: 18 RLS (2 rows)\n6 row: (1 RLS, UB) * 6 (12)\n"
    tail = "Tail\n1 row: 6 RLS in KA\n2 row: 6 PR (12)\n3 row: 6 PR, 6 RLS (18)\n4 row: (1 RLS, PR) * 9 (27)\n"
    assert counts(f"Potap\n\n{legend}Head\n{rounds}\n{tail}") == [[6, 12, 18, 18, 18, 12], [6, 12, 18, 27]]


def test_the_bottom_of_a_body_is_no_other_side_of_a_chain() -> None:
    begun = "BODY\nBeginning at bottom of body with A, ch 2.\nRnd 1: 6 sc in 2nd ch from hook. (6)\nRnd 2: 2 sc in each sc around. (12)\n"
    pattern = read(Text(f"Toy\n\nMATERIALS\nYarn: A = blue, B = cream\n\n{begun}", "toy.txt"))
    assert [p.name for p in pattern.parts] == ["BODY"]


@pytest.mark.parametrize("blue", ["blue", "dusty blue", "light dusty blue"])
@pytest.mark.parametrize("brackets", ["()", "[]"])
def test_the_last_stitches_of_a_round_behind_a_yarn_in_brackets_are_no_count(blue: str, brackets: str) -> None:
    one, two = (f"{brackets[0]}{yarn}{brackets[1]}" for yarn in (blue, "white"))
    text = (
        f"Ball\n\nMaterials: white yarn, {blue} yarn\n\nBALL\nWith {blue}:\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n"
        f"Rnd 3: {one} 4 sc, {two} 4 sc, {one} 4 sc (12)\nRnd 4: {two} 4 sc, {one} 8 sc (12)\n"
    )
    assert counts(text) == [[6, 12, 12, 12]]


@pytest.mark.parametrize(
    "words",
    [
        "Cut the dusty blue yarn and carry on with white only.",
        "Carry on with white only.",
        "Continue in white alone.",
        "From here on work with white only.",
        "The rest is worked in white.",
        "The rest of the body is worked in white only.",
    ],
)
def test_a_yarn_is_taken_up_alone_and_for_all_the_rest(words: str) -> None:
    text = (
        "Ball\n\nMaterials: white yarn, dusty blue yarn\n\nBALL\nWith dusty blue:\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\n"
        f"{words}\nRnd 3: sc around (12)\nRnd 4: sc around (12)\n"
    )
    pattern = read(Text(text, "ball.txt"))
    colors = build(pattern).graph.color.tolist()
    assert not told(pattern) and colors[-1] != colors[0] == colors[17]
