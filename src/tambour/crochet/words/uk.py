"""UK terms: the names of the stitches differ from the American ones, most other words do not."""

from __future__ import annotations

from typing import Final

from tambour.crochet.words import us
from tambour.crochet.words.table import Terms, bumped, bumps, explained, families, posts, standing

_PLAIN: Final = {
    "sc": ("dc", "double crochet", "dcs"),
    "hdc": ("htr", "half treble crochet", "half treble", "htrs"),
    "dc": ("tr", "treble crochet", "treble", "trs"),
    "tr": ("dtr", "double treble crochet", "double treble", "dtrs"),
    "dtr": ("ttr", "triple treble crochet", "triple treble"),
    "trtr": ("qtr", "quadruple treble crochet", "quadruple treble"),
    "esc": ("exdc", "extended double crochet"),
    "ehdc": ("exhtr", "extended half treble crochet"),
    "edc": ("extr", "extended treble crochet"),
}
_KINDS: Final = {**_PLAIN, **posts(_PLAIN, ("FP{k}", "raised {k} front"), ("BP{k}", "raised {k} back"))}
_BUMPS: Final = {
    "bobble": ("bobble", "bo", "mb", "bobble stitch"),
    "popcorn": ("popcorn", "pc", "popcorn stitch"),
    "puff": ("puff", "pf", "puff stitch"),
    "cl": ("cl", "cluster"),
}

STITCHES: Final = {
    "ch": ("ch", "chain", "chains", "chs"),
    "slst": ("ss", "sl st", "slst", "slip stitch", "sl sts", "slip st"),
    "skip": ("miss", "skip", "sk"),
    "picot": ("picot",),
    "crab": ("rev dc", "reverse double crochet", "crab stitch"),
    "spike": ("spike st", "spike stitch", "spike"),
    "loopst": ("loop st", "loop stitch"),
    "fur": ("fur st", "fur stitch"),
    **families(
        _KINDS,
        inc=("inc", "increase", "incs", "{k} inc", "{k}inc", "inc {k}"),
        incs=("inc{n}", "{k} inc{n}", "{k}inc{n}"),
        dec=(
            "dec",
            "decrease",
            "decs",
            "inv dec",
            "invdec",
            "invisible decrease",
            "{k}2tog",
            "{k} 2 tog",
            "{k} dec",
            "{k}dec",
        ),
        decs=("{k}{n}tog", "{k} {n} tog", "dec{n}", "{k} dec{n}", "{k}dec{n}"),
    ),
    **bumps(_BUMPS),
    **standing(_PLAIN, "ch {n} as {k}"),
}

MEANING: Final = explained(
    _KINDS,
    "increase: 2 {k} in the same stitch",
    "{n} {k} in the same stitch",
    "decrease: 2 {k} worked together",
    "{n} {k} worked together",
    {
        **bumped(_BUMPS, "{k}: {n} loops drawn together in one stitch"),
        **{k: v[0] for k, v in standing(_PLAIN, "chain {n}, which counts as a {k}").items()},
        "ch": "chain",
        "slst": "slip stitch",
        "skip": "miss",
        "picot": "picot: 3 chains, joined to where they began",
        "crab": "reverse double crochet",
        "spike": "spike stitch: a double crochet into the round below",
        "loopst": "loop stitch",
        "fur": "fur stitch",
        "round": "round",
        "row": "row",
        "front loops": "front loops only",
        "back loops": "back loops only",
    },
)

WORDS: Final = {
    **us.WORDS,
    "color": ("colour", "color", "col", "change to"),
    "gauge": ("Tension", "Gauge"),
}

SENTENCES: Final = {
    **us.SENTENCES,
    "terms": "UK terms",
    "ring": "{count} dc in magic ring",
    "foundation": "{count} foundation dc",
    "shade": "colour {letter}",
    "legend": "colour {letter}: {name} ({hex})",
}

COLORS: Final = {**us.COLORS, "gray": ("grey", "gray")}

UK: Final = Terms("uk", "UK terms", STITCHES, MEANING, WORDS, SENTENCES, COLORS)
"""The table."""
