"""Rounds as people of other countries write them: ordinals, shortened words, spread increases, headings with copies, own short words."""

import pytest

from tambour.core.errors import Text
from tambour.crochet.graph.build import build
from tambour.crochet.language.finishes import Placed
from tambour.crochet.printed.between.assembly import eyes_listed
from tambour.crochet.printed.choose import read


def counts(text: str) -> dict[str, list[int]]:
    """Heading → the stitches after each round of its first copy; a round that was not understood is told first."""
    pattern = read(Text(text, "toy.txt"))
    built = build(pattern)
    assert not [w.line for w in built.worked if w.line.gap], pattern.unread
    made: dict[str, list[int]] = {}
    for w in built.worked:
        fact = built.parts[w.part]
        if fact.copy == 1 and w.line.in_round and w.made:
            made.setdefault(pattern.parts[fact.section].heading or "", []).append(w.edge)
    return made


SPREAD = {
    "de": "Kopf\nRd 1: 6 fM in den FR (6)\nRd 2: {}\nRd 3: {}\nRd 4: {}\nRd 5: {}\n",
    "fr": "Tête\nT1 : 6 ms dans le CM (6)\nT2 : {}\nT3 : {}\nT4 : {}\nT5 : {}\n",
    "nl": "Kop\nToer 1: 6 v in de MR (6)\nToer 2: {}\nToer 3: {}\nToer 4: {}\nToer 5: {}\n",
    "es": "Cabeza\nR1.- 6pb en AM (6)\nR2.- {}\nR3.- {}\nR4.- {}\nR5.- {}\n",
    "us": "Head\nRnd 1: 6 sc in MR (6)\nRnd 2: {}\nRnd 3: {}\nRnd 4: {}\nRnd 5: {}\n",
}


@pytest.mark.parametrize(
    ("code", "rounds"),
    [
        ("de", ("jede M verd. (12)", "jede 2. M verd. (18)", "je 18 fM (18)", "jede 2. und 3. M zus. (12)")),
        ("de", ("jede Masche verdoppeln", "jede 2. Masche verdoppeln", "in jede Masche 1 fM", "* 1 fM, 2 M zus. * 6x wdh.")),
        ("de", ("alle M verd. (12 M)", "* 1 fM, 1 M verd. * 6x wdh. (18 M)", "nur hMg, je M 1 fM (18 M)", "jede 3. M zusammenhäkeln (12)")),
        ("fr", ("1 aug dans chaque m (12 m)", "1 aug ttes les 2 m (18 m)", "ms tout autour (18 m)", "*1 ms, 2 ms ens.* 6 fois. (12)")),
        ("fr", ("12 ms", "aug toutes les 2 m (18)", "1 ms dans chaque m (18)", "(1 ms, 1 dim) x 6 (12)")),
        ("nl", ("meerder in elke v (12)", "meerder in elke 2e v (18)", "18 v", "haak elke 2e en 3e v samen (12)")),
        ("nl", ("2 v in elke v (12)", "*1 v, 2 v in de volgende v*, herhaal 6x (18)", "alleen in de achterste lussen, 1 v in elke v", "*1 v, 2 v sh*, herhaal 6x (12)")),
        ("es", ("aum en todos (12)", "(1pb, aum)x6 (18)", "por HT, pb en todos los puntos (18)", "(1pb, dism)x6 (12)")),
        ("es", ("2 mp en cada punto = 12", "aum cada 2 puntos (18)", "1 mp en cada punto = 18", "(1 mp, 1 dis) repetir 6 veces = 12")),
        ("us", ("inc around (12)", "inc in every 2nd st (18)", "18 sc", "dec every 2nd and 3rd st around (12)")),
        ("us", ("inc around", "inc every 2nd stitch", "sc around", "dec every 3rd st (12)")),
    ],
)  # fmt: skip
def test_every_so_many_th_stitch(code: str, rounds: tuple[str, ...]) -> None:
    doubled = rounds[0] != "12 ms"
    made = counts(SPREAD[code].format(rounds[0] if doubled else "1 aug dans chaque m", *rounds[1:]))
    assert list(made.values()) == [[6, 12, 18, 18, 12]]


@pytest.mark.parametrize(
    ("text", "copies"),
    [
        ("Orejas (2 iguales, crudo)\nVta 1: 6 mp en un aro mágico = 6\nVta 2: 2 mp en cada punto = 12\n", 2),
        (
            "OREILLES (x2, commencer en brun)\nRang 1 : 6 ms dans l'anneau magique. (6)\nRang 2 : 1 aug dans chaque m (12)\n",
            2,
        ),
        ("Nageoires (en faire 3, bleu canard)\nT1 : 6 ms dans le CM (6 m)\nT2 : 1 aug dans chaque m (12 m)\n", 3),
        ("BEINE, 4 Stück, mit Schwarz anfangen\nR1: 6 fM in MR (6)\nR2: jede M verd. (12)\n", 4),
        ("Vleugels (oudroze, 2x)\nToer 1: 6 v in de MR (6)\nToer 2: 2 v in elke v (12)\n", 2),
        ("POTEN - lichtgroen, 4x\nt1: 6 v in de mr (6)\nt2: meerder in elke v (12)\n", 4),
    ],
)
def test_a_heading_says_its_copies(text: str, copies: int) -> None:
    pattern = read(Text(text, "toy.txt"))
    assert [p.copies for p in pattern.parts] == [copies] and not pattern.unread
    assert list(counts(text).values()) == [[6, 12]]


def test_short_words_that_the_text_explains() -> None:
    text = (
        "Abkürzungen:\nFM - feste Masche\nNO - Noppe: 5 Stäbchen in dieselbe M\nAB - Abnahme\n\n"
        "KÖRPER\nR1: 6 FM in MR (6)\nR2: ZU*6 (12)\nR3: (1 FM, NO)*6 (12)\nR4: AB*6 (6)\nab hier Grau\nR5+R6: 6 FM\n"
    )
    assert list(counts(text).values()) == [[6, 12, 12, 6, 6, 6]]
    assert not read(Text(text, "toy.txt")).unread


def test_colours_have_their_names_in_each_language() -> None:
    for text, hue in (
        ("Kopf\nMit Moosgrün beginnen\nRd 1: 6 fM in MR (6)\n", "olive"),
        ("Cabeza (crudo)\nVta 1: 6 mp en AM = 6\n", "natural"),
        ("Tête\nAvec le bleu canard.\nT1 : 6 ms dans le CM (6)\n", "teal"),
        ("KOP - oudroze\nToer 1: 6 v in de MR (6)\n", "old rose"),
    ):
        from tambour.crochet.printed.yarns.shades import shade

        graph = build(read(Text(text, "toy.txt"))).graph
        assert tuple(int(c) for c in graph.color[3][:3]) == shade(hue), text


def test_lines_that_say_all_twice_are_read_once() -> None:
    text = (
        "GHOST / FANTASMA\n\nMR / AM = magic ring / anillo mágico\n\n1. HEAD / CABEZA (white / blanco)\n"
        "R1: 6 sc in MR / 6 pb en AM [6]\nR2: 6 inc / 6 aum [12]\nR3: (1 sc, inc) x 6 / (1 pb, aum) x 6 [18]\n"
        "R4-R6: 18 sc / 18 pb [18]\nR7: (1 sc, dec) x 6 / (1 pb, dis) x 6 [12]\n"
    )
    assert list(counts(text).values()) == [[6, 12, 18, 18, 18, 18, 12]]


@pytest.mark.parametrize(
    "text",
    [
        "Body\nRnd1) 6 sc in magic ring >>6\nRnd2) inc(6) >>12\nRnd3) {sc 1, inc}x6 >>18\nRnd4-5) sc all around >>18\nRnd6) dec(9) >>9\n",
        "UK terms\n\nBODY\nRd 1 – 6 dc in a magic ring (6)\nRd 2 – 2dc inc in every st (12)\nRd 3 – [1 dc, 2dc inc] x 6 (18)\n"
        "Rd 4 + 5 – dc all round\nRd 6 – dc2tog x 9 (9)\n",
        "KOP\nt1: 6 v in mr (6)\nt2: meerd in elke v (12)\nt3: *1 v, meerd* 6 keer (18)\nt4 t/m t5: 1 v in elke v (18)\nt6: 9 mind (9)\n",
        "## Head\n\n* Rnd 1: 6 sc in MR [6]\n* Rnd 2: inc around [12]\n* Rnd 3: \\*sc 1, inc\\* 6 times [18]\n* Rnds 4 & 5: sc in each st [18]\n* Rnd 6: dec 9 times [9]\n",
    ],
)
def test_signs_of_their_own(text: str) -> None:
    assert list(counts(text).values()) == [[6, 12, 18, 18, 18, 9]]


HANDS = [
    # a leaflet's dotted initials
    ("Tête\n1er tour : 6 m. s. dans la boucle. = 6 m.\n2e tour : 2 m. s. dans chaque m. = 12 m.\n3e au 4e tour : 1 m. s. dans chaque m.\n"
     "5e tour : * 2 m. s. écoulées ens. *, rép. de * à * = 6 m.", [6, 12, 12, 12, 6]),
    ("Bras\n1er tour : 6 m.s. dans un cercle magique (6)\n2e tour : 1 m.s., 4 fois 2 m.s. dans la m. suiv., 1 m.s. (10)\n"
     "3e tour : écouler ens. les 2 premières m., 1 m.s. dans chaque m. suiv. (9)", [6, 10, 9]),
    # a lesson's table of steps and eyes
    ("HEAD  white  1 sheet\nStep | Eyes | How\n1 | 6 | ring, 6 sc\n2 | 12 | +6 (inc each eye)\n3 | 18 | +6\n4~6 | 18 | no change\n7 | 12 | -6 (1sc, dec)",
     [6, 12, 18, 18, 18, 18, 12]),
    ("BODY\nRnd\tSts\tHow\n1\t6\tmagic ring 6\n2\t12\t+6\n3・4\t12\tno change\n5\t9\t-3", [6, 12, 12, 12, 9]),
    # a booklet's short ways
    ("UK terms\nLEG\n1st Round.—Make a ring, 6 d.c. into it.\n2nd Round.—2 d.c. into each d.c. (12 d.c.).\nWork 2 rounds straight in d.c.\n"
     "Next Round.—* 1 d.c. into next d.c., dec. 1; rep. from * to end (8 d.c.).", [6, 12, 12, 12, 8]),
    ("UK terms\nHEAD\nRound 1  Six dc into a ring. (6)\nRound 2  Two dc in each. (12)\nRound 3  One dc in every stitch.\nRound 4  Dec all round (6)\nRound 5  As 3rd.",
     [6, 12, 12, 6, 6]),
    # the round before once more
    ("HAT\nR1 6 sc in magic ring [6]\nR2 inc x 6 [12]\nR3 sc round [12]\nR4 same again [12]\nR5 and the same again [12]", [6, 12, 12, 12, 12]),
    # an end worked shut
    ("Vleugel\nToer 1: 6 v in mr (6)\nToer 2: meerd x6 (12)\nToer 3: vouw de vleugel plat en haak hem dicht met 6 v door beide lagen (6)", [6, 12, 0]),
    ("Arm\nRnd 1: 6 sc in MR (6)\nRnd 2: inc x 6 (12)\nWe fill only the palm. Fold the edge in half and knit 6 sc for both sides. Cut the thread.", [6, 12, 0]),
    # back along a chain
    ("Strap\nChain 19, return with 18 sc.", [18]),
    ("Tail\nChain 8. Knit 2 sc in each chain from 2nd chain (14).", [14]),
    ("Band\nMake twenty-one chain.\nRow 1  Dc in the second chain from the hook and in every chain after. (20)", [20]),
    # a translation's walls and loops
    ("Cuff\n1. 6 sc in MR (6)\n2. 6 inc (12)\n3. 12 sc behind the back wall of the loop (12)\n4. 12 sc (12)", [6, 12, 12, 12]),
    ("Collar\nDial 9 ch.\n1. from the second loop from hook 8 sc (8)\n2. 8 sc (8)", [8, 8]),
    # told, without heads
    ("The Egg\n\nWith white, put six single crochet into a ring and draw it shut. Next work two into every stitch and you will have twelve. Then one plain and "
     "two in the next, all the way about, for eighteen. Work three rounds plain. Then one plain and two together, six times over, leaving twelve.",
     [6, 12, 18, 18, 18, 18, 12]),
    ("The cap. Start with six single crochet in a magic ring. Increase in every stitch (12). Then one single crochet and an increase, six times (18). For the round "
     "after that it's two single crochet between the increases (24), then three (30). Now work even for two rounds.", [6, 12, 18, 24, 30, 30, 30]),
    ("CAP\nRound one, we're putting six single crochets into the ring.\nRound two, increase in each one, that's twelve.\nRound three, one single one increase, repeat, "
     "eighteen.\nRound four, two singles and an increase, all round. You should have twenty, no sorry, twenty-four.\nRounds five to seven just single crochet around, "
     "twenty-four every time.\nRound eight, two singles and a decrease, six times, so we are at eighteen.", [6, 12, 18, 24, 24, 24, 24, 18]),
    # boxes to tick
    ("Horn\n☐ Round 1: 6 sc in m/r {6}\n☐ Rounds 2 – 4: sc 6 {6} ☐☐☐\n☐ Round 5: inc x 6 {12} ☐", [6, 6, 6, 6, 12]),
    # what other languages put behind
    ("Sjaal (heen en weer, om de 4 rijen wisselen)\n\nZet met rood 7 l op.\nRij 1: hst in de 3e l vanaf de naald en in elke volgende l (5)\n"
     "Rij 2 t/m 4: 2 l (telt niet mee), keer, hst in elke hst (5)", [5, 5, 5, 5]),
]  # fmt: skip


@pytest.mark.parametrize(
    ("text", "made"), HANDS, ids=lambda value: value.split("\n")[0] if isinstance(value, str) else ""
)
def test_what_only_some_say(text: str, made: list[int]) -> None:
    assert list(counts(text).values()) == [made]


ROUNDS = {
    "de": ("Rd", "6 fM in den FR (6)", "jede M verdoppeln (12)", "12 fM (12)", ("Kopf", "Körper", "Ohren (2x)", "Schwanz")),
    "fr": ("Rang", "6 ms dans le CM (6)", "1 aug dans chaque m (12)", "12 ms (12)", ("Tête", "Corps", "Oreilles (x2)", "Queue")),
    "es": ("Vta", "6 pb en AM (6)", "aum en todos (12)", "12 pb (12)", ("Cabeza", "Cuerpo", "Orejas (2 iguales)", "Cola")),
    "nl": ("Toer", "6 v in de MR (6)", "meerder in elke v (12)", "12 v (12)", ("Hoofd", "Lijf", "Oren (2x)", "Staart")),
}  # fmt: skip
"""Four parts of a toy in each language: the head of a round, its first three, and their names."""


@pytest.mark.parametrize(
    ("code", "sewn"),
    [
        ("de", "Den Kopf auf den Körper nähen. Die Ohren zwischen Rd 2 und 4 am Kopf annähen, den Schwanz hinten an der 3. Rd des Körpers."),
        ("de", "Nähe den Kopf an den Körper. Ohren seitlich an R3 vom Kopf, der Schwanz kommt hinten an Rd. 3 des Körpers."),
        ("de", "Kopf auf den Körper setzen und annähen. Die Ohren werden an der 2. bis 4. Rd des Kopfes angenäht. Schwanz: hinten an Rd 3 des Körpers"),
        ("fr", "Cousez la tête sur le corps. Les oreilles se cousent entre les rangs 2 et 4 de la tête, la queue dans le dos, au rang 3 du corps."),
        ("fr", "Coudre la tête sur le corps, puis les oreilles de chaque côté de la tête au rang 3. Fixer la queue à l'arrière du corps au 3e rang."),
        ("fr", "La tête se coud sur le corps. Placez les oreilles sur la tête, du rang 2 au rang 4. La queue vient derrière, au rang 3 du corps."),
        ("es", "Coser la cabeza al cuerpo. Orejas: entre la vta 2 y la 4 de la cabeza. La colita va atrás, en la vta 3 del cuerpo."),
        ("es", "1) Cosemos la cabeza al cuerpo. 2) Las orejas a los lados de la cabeza, en la vta 3. 3) La cola detrás, en la 3ª vuelta del cuerpo."),
        ("es", "Une la cabeza con el cuerpo. Cosed las orejitas entre las vueltas 2 y 4 de la cabeza y la cola en la parte de atrás del cuerpo, vuelta 3."),
        ("nl", "Naai het hoofd op het lijf, de oortjes op de 3e toer van het hoofd. Het staartje komt achteraan op toer 3 van het lijf."),
        ("nl", "Het hoofd op het lijf naaien. Zet de oren vast tussen toer 2 en 4 van het hoofd en de staart aan de achterkant van het lijf op toer 3."),
        ("nl", "Naai het hoofd aan het lijf vast. Oren aan de zijkant van het hoofd, ter hoogte van toer 3. Staart achteraan op t3 van het lijf."),
    ],
)  # fmt: skip
def test_assembly_is_placed_in_every_language(code: str, sewn: str) -> None:
    head, *rounds, parts = ROUNDS[code]
    worked = "\n".join(f"{head} {k}: {words}" for k, words in enumerate((*rounds, *2 * rounds[-1:]), 1))
    pattern = read(Text("\n\n".join([*(f"{name}\n{worked}" for name in parts), sewn]), "toy.txt"))
    kopf, korper, ohren, schwanz = (part.name for part in pattern.parts)
    sewn_to = {r.part: (r.spot.part, r.spot.round) for r in pattern.finish if isinstance(r, Placed)}
    assert {kopf, korper} & set(sewn_to)  # one of them is sewn to the other
    assert sewn_to[f"{ohren}.1"] == sewn_to[f"{ohren}.2"] == (kopf, 3)
    assert sewn_to[schwanz] == (korper, 3)


@pytest.mark.parametrize(
    "lists, said",
    [
        ("brins avant : BAV / brins arrière : BAR", "12 ms en BAR"),
        ("brins arrière : BRA", "12 ms dans BRA"),
        ("bra : dans le brin arrière", "12 ms bra"),
        ("", "12 ms en brin arrière"),
    ],
)
def test_one_loop_by_a_short_word_of_the_text(lists, said):
    text = f"OURS\n\nAbréviations\nms : maille serrée\n{lists}\n\nTÊTE (en blanc)\nT1 : 6 ms dans un CM (6)\nT2 : 6 aug (12)\nT3 : {said} (12)\n"
    made = read(Text(text, "ours.txt"))
    assert not made.unread and "blo" in str(made.parts[0].lines[-1].items).lower()


@pytest.mark.parametrize(
    "line",
    [
        "– 2 Sicherheitsaugen, 8 mm",
        "Häkelnadel 3 mm, Augen 8 mm",
        "* Yeux de sécurité 8 mm (x 2)",
        "Crochet 2,5 mm, yeux 8 mm",
    ],
)
def test_the_eyes_of_a_list_in_any_language(line):
    assert "8" in eyes_listed(f"3 mm\n{line}\n") and "3 mm" not in eyes_listed(line)
