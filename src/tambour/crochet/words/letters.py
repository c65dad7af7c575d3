"""Letters: the notation of East Asian and Russian amigurumi charts, a letter for each stitch."""

from __future__ import annotations

from typing import Final

from tambour.crochet.words import us
from tambour.crochet.words.table import MOST, Terms, bumped, bumps, explained, standing

_PLAIN: Final = {
    "sc": ("X", "single crochet (UK: double crochet)"),
    "hdc": ("T", "half double crochet (UK: half treble)"),
    "dc": ("F", "double crochet (UK: treble)"),
    "tr": ("E", "treble crochet (UK: double treble)"),
    "dtr": ("DE", "double treble crochet"),
    "trtr": ("TE", "triple treble crochet"),
    "esc": ("LX", "extended single crochet"),
    "ehdc": ("LT", "extended half double crochet"),
    "edc": ("LF", "extended double crochet"),
}
_KINDS: Final = {
    **_PLAIN,
    **{
        end.lower() + kind: (end + _PLAIN[kind][0], f"{said} post {_PLAIN[kind][1]}")
        for end, said in (("FP", "front"), ("BP", "back"))
        for kind in ("sc", "hdc", "dc", "tr", "dtr")
    },
}
_BUMPS: Final = {
    "bobble": ("Q", "bobble"),
    "popcorn": ("G", "popcorn"),
    "puff": ("PF", "puff"),
    "cl": ("CL", "cluster"),
}

STITCHES: Final = {
    "ch": ("CH",),
    "slst": ("SL",),
    "skip": ("K",),
    "picot": ("P",),
    "crab": ("CR",),
    "spike": ("SPK",),
    "loopst": ("LP",),
    "fur": ("FU",),
    **{kind: (spellings[0],) for kind, spellings in _KINDS.items()},
    **{
        f"{'' if kind == 'sc' else kind}{what}{'' if n == 2 else n}": (
            f"{'' if kind == 'sc' else spellings[0]}{letters[n - 2] if n < 4 else f'{letters[0]}{n}'}",
        )
        for kind, spellings in _KINDS.items()
        for what, letters in (("inc", "VW"), ("dec", "AM"))
        for n in range(2, MOST + 1)
    },
    **bumps(_BUMPS),
    **standing(_PLAIN, "CH{n} as {k}"),
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
        "skip": "skip a stitch",
        "picot": "picot: 3 chains, joined to where they began",
        "crab": "reverse single crochet: an X backwards",
        "spike": "spike stitch: an X into the round below",
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
    "round": ("R", "Rnd", "Round", "Rd", "Rnds", "Rounds", "Rds"),
    "each": ("each", "every"),
    "times": ("*", "×", "times", "time"),
    "ring": ("MR", "magic ring", "magic circle", "MC", "ring"),
}

SENTENCES: Final = {
    **us.SENTENCES,
    "terms": "letters",
    "ring": "{count}X in MR",
    "oval": us.SENTENCES["oval"].replace("ch {", "CH {"),
    "foundation": "{count} foundation X",
    "one ring": "({items}) in MR",
    "attach chain": "bridge to marker {label} with {count} CH",
    "place": us.SENTENCES["place"].replace("Rnd", "R"),
    "at round": us.SENTENCES["at round"].replace("Rnd ", "R"),
    "at between": us.SENTENCES["at between"].replace("Rnd ", "R"),
    "several": "{count}{item}",
    "group": "({items}) * {count}",
}

LETTERS: Final = Terms("letters", "letters", STITCHES, MEANING, WORDS, SENTENCES, us.COLORS)
"""The table."""
