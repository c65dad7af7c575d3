"""Printed patterns, the words: what people write besides the words that a table of terms prints, language by language."""

from __future__ import annotations

from typing import Final

# Concept → spellings, parted by bars. The concepts are those of terms.WORDS, and a few more that only a reader meets.
ENGLISH: Final[dict[str, str]] = {
    "round": "rnd|rnds|round|rounds|rd|rds",
    "row": "row|rows",
    "ring": "magic ring|magic circle|magic loop|magic rng|adjustable ring|adjustable loop|adjustable circle|mr|mc|amr"
    "|magic adjustable ring|adjustable magic ring|double magic ring|magic ring method|amigurumi ring|ring of yarn",
    "loop": "ring|loop|circle|center of ring|centre of ring",
    "form": "form a ring|form ring|to form a ring|form a circle|to form a loop|form a loop|to make a ring",
    "in": "in|into|inside|through|thru|onto|on|along",
    "over": "over|using",
    "each": "each|every|all",
    "next": "next|following|nxt",
    "same": "same",
    "last": "last|final",
    "rest": "remaining|rem|rest of",
    "stitch": "st|sts|stitch|stitches|st's|s|stich|stiches",
    "space": "space|spaces|sp|sps|ch sp|ch sps|chain space|chain spaces",
    "around": "around|across|to end|to the end|until end|until the end|all around|all the way around|all round|evenly"
    " around|to end of round|to the end of the round|to end of rnd|to the end of the rnd|to end of row|to the end of the"
    " row|rnd around|along|around the round|until the end of the round|to last|round and round",
    "times": "times|time",
    "more": "more|additional",
    "total": "total|in total|a total of|altogether|total sts|total stitches",
    "repeat": "rep|repeat|repeats|rpt|repeating|rep.",
    "from": "from|between *",
    "to": "to|until|till|thru to|through to|at",
    "between": "between",
    "and": "and|then|&|plus|followed by|also",
    "front loops": "front loops only|front loop only|front loops|front loop|flo|fl|front lps only|flos",
    "back loops": "back loops only|back loop only|back loops|back loop|blo|bl|back lps only|blos",
    "both loops": "both loops|both loop",
    "turn": "turn|turn work|turn the work|turn your work",
    "join": "join|joining|join with sl st|join with a sl st|join with slip stitch|join with a slip stitch|join w sl st"
    "|join with ss|join with a ss|sl st to join|slip stitch to join|ss to join|sl st join|slst to join|join by sl st"
    "|close round with a sl st|close the round with a sl st|close with a sl st|close with sl st|join with slst|sl st together",
    "fasten off": "fasten off|finish off|fo|f o|fasten|bind off|cut yarn|cut the yarn|break yarn|break off|cut off"
    "|fasten off yarn|end off|tie off|break off yarn",
    "close": "close|closed|closing|pull tight|cinch|cinch closed|sew shut|gather|pull closed|draw closed|sew closed|sew the hole"
    "|close the hole|close hole|close up|close the opening|sew up the hole|tighten",
    "open": "leave open|do not close|don't close|leave the end open|stays open|for sewing|for attaching|to sew|to attach|for assembly",
    "leave": "leave|leaving|weave|weaving|hide|secure",
    "color": "change to|switch to|changing to|change color to|change colour to|switch color to|switch colour to"
    "|change yarn to|change colors to|color change to|change color|change colour|switch color|cc to|cont in|continue in"
    "|continue with",
    "with": "with|w|using|use",
    "even": "even|work even|straight|work straight",
    "not": "not|does not|doesn't|do not|don't|no|never|without",
    "count": "count|counts|counted|counting",
    "marker": "place marker|pm|place stitch marker|place a marker|place a stitch marker|move marker|mark|mark this|marker"
    "|stitch marker|insert marker|use a marker|attach marker",
    "stuff": "stuff|stuffed|stuffing|fill|begin stuffing|start stuffing|continue stuffing",
    "make": "make|made|cut",
    "begin": "begin|start|starting|beginning|beg|begin with|start with",
    "together": "together|tog",
    "once": "once",
    "twice": "twice",
    "other": "other|alternate|2nd one",
    "as": "as|same as|as for|like|as in|as per",
    "for": "for",
    "hook": "hook",
    "yarn": "yarn",
    "side": "other side|opposite side|both sides|underside|back side|bottom side|bottom|other half",
    "foundation": "foundation chain|foundation ch|starting chain|starting ch|beginning chain|beg ch|base chain",
    "materials": "materials|material|supplies|what you need|you will need|you'll need|materials needed|tools|notions",
    "abbreviations": "abbreviations|abbreviation|stitches used|terms|terminology|abbreviations used|stitch guide|key|glossary"
    "|special stitches|special stitch|stitch abbreviations|abbr|legend|stitch key|special terms",
    "gauge": "gauge|tension",
    "notes": "notes|note|pattern notes|tips|tip|before you start|instructions|pattern|directions|info|about|copyright|care"
    "|how to read this pattern|introduction|skill level|level|difficulty|techniques",
    "assembly": "assembly|finishing|assembling|putting it together|putting together|making up|to make up|finish|sewing"
    "|sewing up|assemble|final assembly|finishing touches|embroidery|face|details|joining the parts|to finish",
    "finished size": "finished size|size|finished measurements|measurements|dimensions|approx size|approximate size|height",
    "eyes": "safety eyes|safety eye|toy eyes|plastic eyes",
}
"""English, on both sides of the Atlantic."""

FILLERS: Final[dict[str, str]] = {
    "en": "the|a|an|of|your|now|work|working|crochet|evenly|loosely|tightly|carefully|please|just|only|it|we|you|this"
    "|sts:|also|gently|approx|do|here|next:|up|only:|will|simply|another|yo|first off|finally|still|post|posts|main|contrast|contrasting",
    "es": "el|la|los|las|un|una|unos|unas|de|del|al|lo|su|sus|el mismo|tejer|trabajar",
    "de": "der|die|das|den|dem|des|ein|eine|einen|einem|einer|eines|je|dann|jeweils|nun|arbeiten|häkeln",
    "fr": "le|la|les|l'|un|une|des|de|du|d'|au|aux|puis|votre|crocheter|travailler",
    "nl": "de|het|een|'t|van|je|dan|nu|haken|haak",
}
"""Words that carry no meaning among stitches, by language."""

UK: Final[dict[str, str]] = {
    "sc": "dc|double crochet|dcs|double",
    "hdc": "htr|half treble|half treble crochet|htr c|half tr",
    "dc": "tr|treble|treble crochet|trs|trc",
    "tr": "dtr|double treble|double treble crochet",
    "slst": "ss|sl st|slip stitch|slip st|sl|slst|slip stitches|sl sts",
    "skip": "miss|sk|skip",
    "ch": "ch|chain|chains|chs|chain stitch|ch st",
}
US: Final[dict[str, str]] = {
    "sc": "sc|single crochet|single crochets|scs|single|single crochet stitch|single crochet stitches",
    "hdc": "hdc|half double crochet|half double|half double crochets|hdcs|half dc",
    "dc": "dc|double crochet|double crochets|dcs|double",
    "tr": "tr|treble|treble crochet|triple crochet|trc|trs|triple|tc",
    "slst": "sl st|slip stitch|ss|slst|sl|slip st|sl sts|slip stitches|slip|sst|slst's",
    "skip": "sk|skip|miss|skip over",
    "ch": "ch|chain|chains|chs|chain stitch|ch st",
}
"""Stitches with their spellings; the reader makes increases and decreases of them by itself."""

INCREASES: Final = "inc|increase|increases|incs|increasing|increase stitch"
DECREASES: Final = (
    "dec|decrease|decreases|decs|inv dec|invdec|invisible decrease|invisible dec|decreasing|invisible decreases"
)
"""Words for two in one and one over two; alone they mean the basic stitch."""

ORDINALS: Final = "first|second|third|fourth|fifth|sixth|seventh|eighth|ninth|tenth"
NUMBERS: Final = "one|two|three|four|five|six|seven|eight|nine|ten|eleven|twelve"

FOREIGN: Final[dict[str, dict[str, str]]] = {
    "es": {
        "to": "hasta|a la",
        "with": "con|con hilo",
        "color": "cambiar a|cambio a|cambia a",
        "and": "y|e",
        "close": "cerrar|cerrar el agujero|cierra",
        "fasten off": "cortar el hilo|cortar hebra|rematar|corta el hilo",
        "leave": "dejar|dejando",
        "stuff": "rellenar|relleno|rellena",
    },
    "de": {
        "to": "bis",
        "with": "mit",
        "stitch:inc": "verdoppeln|verdopple",
        "color": "wechseln zu|farbwechsel zu|wechsel zu",
        "and": "und|dann",
        "leave": "lassen",
    },
    "fr": {
        "to": "à|a|jusqu'à",
        "next": "suivant|suivants|prochain",
        "with": "avec|en",
        "color": "changer pour|passer au|passer en|changer de couleur",
        "and": "et|puis",
        "close": "fermer|refermer|resserrer",
        "fasten off": "couper le fil|arrêter|arrêter le fil|rentrer le fil",
        "leave": "laisser|laissant",
        "stuff": "rembourrer|bourrer",
    },
    "nl": {
        "to": "t/m|tot|tot en met",
        "with": "met",
        "color": "wissel naar|wissel van kleur",
        "and": "en|dan",
        "close": "dichttrekken|sluiten|dichtnaaien|dicht",
        "fasten off": "afhechten|hecht af|draad afknippen",
        "leave": "laat",
        "stuff": "vullen|opvullen",
    },
}
"""What people write in the other languages besides their tables: a concept, or ``stitch:`` and a stitch."""

LETTERS: Final[dict[str, str]] = {
    "sc": "x",
    "inc": "v",
    "dec": "a",
    "hdc": "t",
    "dc": "f",
    "inc3": "w",
    "dec3": "m",
    "slst": "sl|ss",
    "ch": "ch",
    "fo": "fo",
}
"""Letter notation, as it came from East Asia."""
