"""UK terms: the names of the stitches differ from the American ones, most other words do not."""

from __future__ import annotations

from typing import Final

from tambour.crochet import terms_us as us
from tambour.crochet.wording import Terms, families

STITCHES: Final = {
    "ch": ("ch", "chain", "chains", "chs"),
    "slst": ("ss", "sl st", "slst", "slip stitch", "sl sts", "slip st"),
    "skip": ("miss", "skip", "sk"),
    **families(
        {
            "sc": ("dc", "double crochet", "dcs"),
            "hdc": ("htr", "half treble crochet", "half treble", "htrs"),
            "dc": ("tr", "treble crochet", "treble", "trs"),
            "tr": ("dtr", "double treble crochet", "double treble", "dtrs"),
        },
        inc=("inc", "increase", "incs", "{} inc", "{}inc", "inc {}"),
        inc3=("inc3", "triple inc", "triple increase", "{} inc3", "{}inc3", "{}3inc"),
        dec=(
            "dec",
            "decrease",
            "decs",
            "inv dec",
            "invdec",
            "invisible decrease",
            "{}2tog",
            "{} 2 tog",
            "{} dec",
            "{}dec",
        ),
        dec3=("{}3tog", "{} 3 tog", "dec3", "{} dec3", "{}dec3"),
    ),
}

MEANING: Final = {
    "ch": "chain",
    "slst": "slip stitch",
    "skip": "miss",
    "sc": "double crochet",
    "inc": "increase: 2 dc in the same stitch",
    "inc3": "3 dc in the same stitch",
    "dec": "decrease: 2 dc worked together",
    "dec3": "3 dc worked together",
    "hdc": "half treble crochet",
    "hdcinc": "2 htr in the same stitch",
    "hdcinc3": "3 htr in the same stitch",
    "hdcdec": "2 htr worked together",
    "hdcdec3": "3 htr worked together",
    "dc": "treble crochet",
    "dcinc": "2 tr in the same stitch",
    "dcinc3": "3 tr in the same stitch",
    "dcdec": "2 tr worked together",
    "dcdec3": "3 tr worked together",
    "tr": "double treble crochet",
    "trinc": "2 dtr in the same stitch",
    "trinc3": "3 dtr in the same stitch",
    "trdec": "2 dtr worked together",
    "trdec3": "3 dtr worked together",
    "round": "round",
    "front loops": "front loops only",
    "back loops": "back loops only",
}

WORDS: Final = {
    **us.WORDS,
    "color": ("colour", "color", "col", "change to"),
    "gauge": ("Tension", "Gauge"),
}

SENTENCES: Final = {
    **us.SENTENCES,
    "ring": "{count} dc in magic ring",
    "shade": "colour {letter}",
    "legend": "colour {letter}: {name} ({hex})",
}

COLORS: Final = {**us.COLORS, "gray": ("grey", "gray")}

UK: Final = Terms("uk", "UK terms", STITCHES, MEANING, WORDS, SENTENCES, COLORS)
"""The table."""
