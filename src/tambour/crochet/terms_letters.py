"""Letters: the notation of East Asian and Russian amigurumi charts, a letter for each stitch."""

from __future__ import annotations

from typing import Final

from tambour.crochet import terms_us as us
from tambour.crochet.wording import Terms

STITCHES: Final = {
    "ch": ("CH",),
    "slst": ("SL",),
    "skip": ("K",),
    "sc": ("X",),
    "inc": ("V",),
    "inc3": ("W",),
    "dec": ("A",),
    "dec3": ("M",),
    "hdc": ("T",),
    "hdcinc": ("TV",),
    "hdcinc3": ("TW",),
    "hdcdec": ("TA",),
    "hdcdec3": ("TM",),
    "dc": ("F",),
    "dcinc": ("FV",),
    "dcinc3": ("FW",),
    "dcdec": ("FA",),
    "dcdec3": ("FM",),
    "tr": ("E",),
    "trinc": ("EV",),
    "trinc3": ("EW",),
    "trdec": ("EA",),
    "trdec3": ("EM",),
}

MEANING: Final = {
    "ch": "chain",
    "slst": "slip stitch",
    "skip": "skip a stitch",
    "sc": "single crochet (UK: double crochet)",
    "inc": "increase: 2 X in the same stitch",
    "inc3": "3 X in the same stitch",
    "dec": "decrease: 2 X worked together",
    "dec3": "3 X worked together",
    "hdc": "half double crochet (UK: half treble)",
    "hdcinc": "2 T in the same stitch",
    "hdcinc3": "3 T in the same stitch",
    "hdcdec": "2 T worked together",
    "hdcdec3": "3 T worked together",
    "dc": "double crochet (UK: treble)",
    "dcinc": "2 F in the same stitch",
    "dcinc3": "3 F in the same stitch",
    "dcdec": "2 F worked together",
    "dcdec3": "3 F worked together",
    "tr": "treble crochet (UK: double treble)",
    "trinc": "2 E in the same stitch",
    "trinc3": "3 E in the same stitch",
    "trdec": "2 E worked together",
    "trdec3": "3 E worked together",
    "round": "round",
    "front loops": "front loops only",
    "back loops": "back loops only",
}

WORDS: Final = {
    **us.WORDS,
    "round": ("R", "Rnd", "Round", "Rd", "Rnds", "Rounds", "Rds"),
    "each": ("each", "every"),
    "times": ("*", "×", "times", "time"),
    "ring": ("MR", "magic ring", "magic circle", "MC", "ring"),
}

SENTENCES: Final = {
    **us.SENTENCES,
    "ring": "{count}X in MR",
    "attach chain": "bridge to marker {label} with {count} CH",
    "place": us.SENTENCES["place"].replace("Rnd", "R"),
    "at round": us.SENTENCES["at round"].replace("Rnd ", "R"),
    "at between": us.SENTENCES["at between"].replace("Rnd ", "R"),
    "several": "{count}{item}",
    "group": "({items}) * {count}",
}

LETTERS: Final = Terms("letters", "letters", STITCHES, MEANING, WORDS, SENTENCES, us.COLORS)
"""The table."""
