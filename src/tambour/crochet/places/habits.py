"""Habits: the many ways in which people say a place or a distance, put as one of those that are read."""

from __future__ import annotations

import re
from collections.abc import Callable
from typing import Final

from tambour.crochet.words.numbers import QUANTITY, quantity
from tambour.crochet.words.sayings import Sayings

ROUND: Final = r"(?:rounds?|rnds?|rds?|rows?|rnd\.|r)"
ST: Final = r"(?:stitches|stitch|sts?\.?|sc|dc|x(?! ?\d))"
_R: Final = rf"(?:the\s+)?{ROUND}\s?\.?\s*(\d+)\b"
_FREE: Final = r"(?:(?:visible|full|whole|free|empty|open|clear|unworked|unused)\s+)?"
_EDGE: Final = r"(?:\s+(?:edge|end|side|part|rim|point|corner|line)s?)?"
_MEETS: Final = (
    r"(?:touch|meet|reach|align|line|sit|lie|start|run|rest|be|is|are|go)\w*\s+(?:up\s+)?(?:with|at|on|along|in|against)?\s*"
    r"|(?:at|on|along|in|level with|in line with)\s+"
)

_PLAIN: Final[tuple[tuple[str, str | Callable[[re.Match[str]], str]], ...]] = (
    (rf"({_R})\s*\((?:the\s+)?(?:inner|outer|upper|lower|front|back|top|bottom)\s+(?:corner|edge|end|side)s?\)", r"\1"),
    (
        r"\bunder\s+the\s+(?:(?:front|lower|upper|back|rear)\s+)+edge\s+of\s+(the|each|its)\s+(thigh|haunch|hip)s?\b",
        r"to the front of \1 \2",
    ),
    # rounds that a piece is sewn over
    (
        rf"\b(?:start|begin)\w*\s+(?:[^.;\d]{{0,40}}?\s)?(?:at|in|on|from|with|near|by)\s+(?:about\s+)?{_R},?\s*(?:and\s+)?(?:to\s+)?(?:end|finish|stop)\w*\s+(?:at|in|on|with|by|near|about)\s+(?:about\s+)?{_R}",
        r"over rounds \1 to \2",
    ),
    (rf"\bfrom\s+{_R}\s+(?:all the way\s+)?(?:down|up)(?:wards?)?\s+(?:to|till|until)\s+{_R}", r"over rounds \1 to \2"),
    (
        rf"\b(?:top|upper){_EDGE}\b(?:(?!\b(?:bottom|lower)\b)[^.;]){{0,40}}?\b{_R}[^.;\d]{{0,12}}\b(?:bottom|lower){_EDGE}\b[^.;\d]{{0,30}}?\b{_R}",
        r"over rounds \1 to \2",
    ),
    (
        rf"\b(?:top|upper)\s+(?:edge|end|side|rim)\s+(?:of (?:the )?\w+\s+)?(?:{_MEETS}){_R}",
        r"top edge of it at round \1",
    ),
    (
        rf"\b(?:bottom|lower)\s+(?:edge|end|side|rim)\s+(?:of (?:the )?\w+\s+)?(?:{_MEETS}){_R}",
        r"lower edge on round \1",
    ),
    (
        rf"\b(?:inner|outer|upper|front|first|one|its)\s+(?:\w+\s+)?(?:corner|edge|end|point|tip)s?\s+(?:\w+\s+)?(?:on|at|by|along|in)\s+{_R}[^.;\d]{{0,40}}?\b"
        rf"(?:outer|inner|lower|back|second|other)(?:\s+(?:\w+\s+)?(?:corner|edge|end|point|tip)s?)?\s+(?:\w+\s+){{0,2}}?(?:on|at|by|along|in|near)\s+(?:about\s+)?{_R}",
        r"over rounds \1 to \2",
    ),
    (
        rf"\b(?:tops?|upper edge)\s+(?:touch|meet|reach)\w*\s+(?:the\s+)?neck(?:\s+(?:seam|edge|line))?[^.;\d]{{0,40}}?\b(?:bottom|lower edge)\s+(?:\w+\s+){{0,2}}?(?:to|at|on)\s+(?:about\s+)?{_R}",
        r"at the neck, lower edge on round \1",
    ),
    (
        rf"\b(?:doorstep|threshold|sill|(?:(?:its|the)\s+)?(?:bottom|lower)\s+(?:edge|end))\s+(?:exactly\s+|right\s+|just\s+)?(?:on|at|along)\s+(?:the\s+line\s+[^.;\d(]{{0,30}}\(?)?{_R}(?:/\d+\)?)?(?:\s+(?:edge|line))?",
        r"lower edge on round \1",
    ),
    # what is not meant, and how a piece runs or what it touches, say no place
    (r"\s*\(\s*not\b[^()]*\)|\s*[,–—-]+\s*not\s+(?:upright|standing|vertical|lying|flat|sideways)\b[^.;,]*", ""),
    (
        r",?\s*\b(?:with\s+)?(?:the\s+|its\s+)?(?:stripes|ridges|rows|grooves|long sides?|short sides?|ribs)\s+(?:go|run|point|lie|lying|going|running|pointing)\w*\s+"
        r"(?:(?:from\s+)?(?:the\s+)?\w+\s+to\s+(?:the\s+)?\w+|across|along|lengthwise|sideways|up and down|from side to side)\b",
        "",
    ),
    (
        r",?\s*\b(?:with\s+)?(?:the\s+|its\s+)?(?:two\s+)?(?:petals|flukes|lobes|halves)\s+(?:\w+\s+)?(?:to\s+(?:the\s+)?)?left and (?:(?:to\s+)?the\s+)?right\b",
        "",
    ),
    (
        r",?\s*\b(?:and\s+|with\s+)?(?:the\s+|its\s+|their\s+)?(?:front|back|inner|outer|upper|lower)\s+(?:edge|end|side|tip|corner)s?\s+(?:\w+\s+)?touching\b[^.;,]*",
        "",
    ),
    (
        rf",?\s*\bwith\s+{QUANTITY}\s*{ST}\b[^.;\d]*\bbetween\s+(?:each|the|both|every)\s+(?:\w+\s+)?eyes?\s+and\b[^.;,]*",
        "",
    ),
    (rf"\b({QUANTITY})\s+sl ?sts?\s+(?:curving|running|going)\s+across\b", r"\1 stitches wide across"),
    (r",?\s*\b(?:exactly\s+|directly\s+|right\s+)?opposite\s+(?:the\s+)?back\b(?:\s+(?:marker|seam|line))?", ""),
    (
        r"\b(?:on|down|up)\s+(?:the\s+)?(right|left)[- ]hand\s+(?:side\s+of\s+the\s+)?slope\b",
        r"on the \1 side of the roof",
    ),
    (
        r",?\s*\bhalf ?way\s+(?:up|down)\s+(?:the|its)\s+slope\b(?:\s+on\s+the\s+(right|left)[- ]hand\s+side)?",
        lambda m: f" on the {m[1]} side of the roof" if m[1] else " halfway",
    ),
    (
        r",?\s*\bhalf ?way\s+between\s+(?:the|its)\s+(?:tip|top|crown)\s+(?:of\s+the\s+\w+\s+)?and\s+(?:the|its)\s+(?:rim|edge|brim|bottom)\b",
        " halfway",
    ),
    (
        r"\b(?:so\s+)?(?:slip|tuck|push|slide)\s+(?:its|their|the)\s+(?:bottom|lower|upper|top|back)\s+(?:edge|end)s?\s+(?:behind|under|between|into|below)\s+the\s+\w+\s*(?:,\s*)?(?:and\s+)?",
        "",
    ),
    (r"\bbehind and (?=(?:below|above|beside)\b)", ""),
    (
        r"\b(?:the\s+|their\s+)?(?:ends|tips|points)\s+(?:(?:should|must|will)\s+)?(?:look|point|fac)\w*\s+(?:back|to the back|to the rear|towards the (?:tail|back))\b",
        "pointing backwards",
    ),
    # in a translator's words
    (rf"\bat (?:the )?(?:same )?(?:height|level) of {_R}\s*(?:and|to|-|–)\s*{_R}", r"over rounds \1 to \2"),
    (rf"\b({QUANTITY})\s*{ST}\s+(?:of|in)\s+(?:wide|width)\b", r"\1 stitches wide"),
    (rf"\bwidth(?: of|:| is)?\s+(?:about\s+)?({QUANTITY})\s*{ST}(?!\w)", r"\1 stitches wide"),
    (r"\b(above|below|under|over|behind|beside) of (?=(?:the|each|both|every|its|his|her)\b)", r"\1 "),
    (
        r"\b(?:in|at) (?:the )?(?:exact )?(?:middle|cent(?:er|re)) (?:of|between) (?:the |both |her |his |its )*(?:two )?eyes\b",
        "between the eyes",
    ),
    (
        rf"\bwith (?:a )?(?:separation|distance|space) of ({QUANTITY})\s*{ST}|\bwith ({QUANTITY})\s*{ST} of (?:separation|distance|space)\b",
        lambda m: f"{m[1] or m[2]} stitches between",
    ),
    (
        rf"\bbetween (?:the )?(\d+)(?:st|nd|rd|th) and (?:the )?(\d+)(?:st|nd|rd|th) (?:{ST}|loops?)(?: of the (?:round|rnd|row))?,?\s*(?:and\s+)?(?:the\s+)?(?:second|other|next)(?: one| eye)? "
        r"between (?:the )?(\d+)(?:st|nd|rd|th) and (?:the )?(\d+)(?:st|nd|rd|th)\b(?: (?:stitch|st|loop)(?:es|s)?)?",
        r"between stitches \1 and \2, the other between stitches \3 and \4",
    ),
    (
        rf"\(?(?:at |in |on )?{ST}\s?(\d+) on (?:one|the (?:left|right)) side,? (?:and )?(?:at |in |on )?{ST}\s?(\d+) on the (?:other|left|right)(?: side)?\)?",
        r"in st \1, in st \2",
    ),
    # stitches between two
    (
        rf"\b({QUANTITY})\s+{_FREE}{ST}\s+(?:of\s+(?:the\s+)?[a-z]+\s+)?(?:(?:visible|showing|left|remaining|free|empty|open|wide|clear|in)\s+)*(?:between|in the middle\b(?! of)|inbetween)",
        r"\1 stitches between",
    ),
    (
        rf"\b({QUANTITY})\s+(?:visible|free|empty|open|clear|unworked)\s+{ST}(?!\s+(?:between|apart))",
        r"\1 stitches between",
    ),
    (rf"\b({QUANTITY})\s*-?\s*{ST}\s+(?:gap|space)\b", r"\1 stitches between"),
    (
        rf"\b(?:interspace|spac(?:e|ing)|gap)\s*(?:of|:|=|is)?\s+(?:about\s+|approx\w*\.?\s+)?({QUANTITY})\s*{ST}\b(?:\s+(?:between|apart)\b)?",
        r"\1 stitches between",
    ),
    (
        rf"\b(?:leav(?:e|ing)|skip(?:ping)?|with)\s+({QUANTITY})\s+{_FREE}{ST}\s+(?:free|empty|open|unworked|visible|showing)\b",
        r"\1 stitches between",
    ),
    (
        rf"\b(?:distance|apart)\s*(?:of|:|=|is|by)?\s+(?:about\s+|approx\w*\.?\s+)?({QUANTITY})\s*(?:{ST}|loops?)\b(?:\s+(?:between|apart)\b)?",
        r"\1 stitches apart",
    ),
    (
        rf"\bspaced\s+(?:about\s+|approx\w*\.?\s+)?({QUANTITY})\s*{ST}\b(?:\s+(?:apart|from each other)\b)?",
        r"\1 stitches apart",
    ),
    (rf"\b({QUANTITY})\s*{ST}\s+(?:away\s+)?from (?:one another|each other|the other)\b", r"\1 stitches apart"),
)
"""What is said → how it is read."""
SCATTERED: Final = re.compile(r"^(\W*(?:scatter|spread|strew)\b[^:;]*)[:;][^\d]*$", re.IGNORECASE | re.DOTALL)
"""What is scattered over another part, and, in words alone, which of it is where besides."""
_SIDE: Final = r"(?:on|at|to)\s+(?:the\s+|its\s+|his\s+|her\s+)?(?:left|right)(?:[- ]?hand)?(?:\s+side)?"
_OWN_EDGES: Final = r"(?:sides?|bottom|base|lower\s+edge|top)"
_ALIKE: Final[tuple[tuple[str, str | Callable[[re.Match[str]], str]], ...]] = (
    (
        r"\b(?:(?:to|on|at) the )?(?:left and (?:the )?right|right and (?:the )?left)(?: (?:hand )?sides?)? (?:from|of) (?:the )?(?=[a-z])",
        "one on each side of the ",
    ),
    (r"^\W*(?:the )?(\w+(?: \w+)?) we (?:then )?(sew|attach|stitch|glue|pin)\b", r"\2 the \1"),
    (
        r"\b(?:on |in |to |at )?(?:the )?(?:between|in between) (?:the |its |his |her |their )?shoulders?(?: ?blades)?\b",
        "to the upper back of the body",
    ),
    (
        r"\bcent(?:red|ered)\s+on\s+(?:the\s+|its\s+|his\s+|her\s+)?(?:bib|belly|chest|tummy|front)\b",
        "in the middle of the front",
    ),
    # one to each side, said of each
    (
        rf"\bone(\s+\w+)?\s+{_SIDE},?\s+(?:and\s+)?(?:the\s+)?(?:one|other|another|second)(?:\s+one)?(?:\s+\w+)?\s+{_SIDE}\b",
        r"one\1 on each side",
    ),
    (
        r"\bon\s+the\s+(?:left\s+and\s+(?:on\s+)?(?:the\s+)?right|right\s+and\s+(?:on\s+)?(?:the\s+)?left)\b",
        "on each side",
    ),
    (
        r"\b(\w+)\s+on\s+the\s+(?:left|right)(?:\s+side)?,?\s+(?:and\s+)?\1\s+on\s+the\s+(?:left|right)(?:\s+side)?\b",
        r"\1 on each side",
    ),
    (
        rf"\b(?:the\s+|all\s+)?({QUANTITY})\s+(?:{ST}|loops?)\s+of\s+((?:the\s+)?\w+)\s+(to|onto|on)\s+(?:the\s+|all\s+)?\1\s+(?:{ST}|loops?)\s+of\s+(?=the\b)",
        r"\2 \3 ",
    ),
    # how a piece runs, and what of its own edge is sewn, is no place
    (
        rf",?\s*\b(?:match|line up|align)(?:ing|ed)?\s+(?:up\s+)?(?:the|its|their|all)?\s*(?:{QUANTITY}\s+)?(?:{ST}|loops?)\b[^.;]*?\b(?:to|with|and)\b[^.;]*",
        "",
    ),
    (rf",?\s*\b({QUANTITY})\s+(?:{ST}|loops?)\s+(?:to|on|with)\s+\1\s+(?:{ST}|loops?)\b", ""),
    (
        r"\b(?:along|by|at)\s+(?:its\s+|their\s+|the\s+)?(?:row 1|first row)\b(?=.*\b(?:rnds?|rounds?|r)\s?\d)",
        "along its edge",
    ),
    (
        r"\b(?:(?:running|going|lying|placed)\s+)?(?:lengthwise\s+)?(?:from\s+)?(?:the\s+)?front\s+to\s+(?:the\s+)?back\b",
        "lengthwise",
    ),
    (r"\bfront-to-back\b|\bfrom back to front\b", "lengthwise"),
    (
        rf"\bleaving\s+(?:the\s+|its\s+|their\s+)?(?:{_OWN_EDGES}|upper\s+edge)(?:\s+(?:edge|side|end))?\s+(?:open|free|loose|unsewn|unattached)\b",
        "",
    ),
    (
        rf"\b(?:along|around|on|at|by)\s+(?:the\s+|its\s+)?(?:{_OWN_EDGES},?\s+and\s+(?:the\s+)?{_OWN_EDGES}|(?:three|3|two|2)\s+(?:of\s+its\s+)?(?:sides|edges))\b(?!\s+of)",
        "",
    ),
    # how hair is turned that goes all round
    (r",\s*cent(?:er|r)ing\s+(?:the\s+|its\s+)?(?:bangs|fringe|parting|curls)\b[^.;]*", ""),
    # a round of what is sewn, that is folded first
    (
        r"^\W*(?:fold|roll|turn|flatten)\w*\s+(?:the\s+)?(?:rounds?|rnds?|rows?)\s+\d+\b[^.;]*?\b(?:and|then)\s+(?=(?:sew|attach|stitch|pin)\b)",
        "",
    ),
    # pairs told one after the other
    (
        rf"\b(?:the\s+)?(?:first|front)\s+(?:pair\s+(?:of\s+)?)?(\w+\s+)?(?:at|in|on|to)\s+{_R},?\s*(?:and\s+)?(?:the\s+)?(?:second|middle|next|hind|back)\s+(?:pair\s*(?:of\s+)?)?(?:\w+\s+)?(?:at|in|on|to)\s+{_R}"
        rf"(?:,?\s*(?:and\s+)?(?:the\s+)?(?:third|hind|back|last|rear)\s+(?:pair\s*(?:of\s+)?)?(?:\w+\s+)?(?:at|in|on|to)\s+{_R})?",
        lambda m: f"{m[1] or 'legs '}at rounds {', '.join(n for n in m.groups()[1:] if n)} on each side",
    ),
    (
        rf"\bone\s+(\w+\s+)?(?:at|in|on|over)\s+{_R}\s*,?\s*(?:and\s+)?(?:the\s+)?(?:one|other|another)(?:\s+one)?\s+(?:at|in|on|over)\s+{_R}",
        r"one \1at rounds \2 and \3",
    ),
)
"""What is said of two, or of several pairs, and of how they lie."""
_TWICE: Final = (
    rf"\b({QUANTITY})\s*{ST}\s+(?:away\s+|out\s+)?(?:(?:to|on|at)\s+)?(?:either|each|both)\s+sides?\s+(?:of|from)\s+(?:the\s+)?(?:very\s+)?"
    r"(?:middle|cent(?:er|re)|midline)(?:\s+(?:line|front|st(?:itch)?))?\b"
)
"""So many to each side of the middle are twice as many apart."""
_RULES: Final = Sayings[str | Callable[[re.Match[str]], str]](
    [(_TWICE, lambda m: f"{2 * quantity(m[1]):g} stitches apart"), *_ALIKE, *_PLAIN]
)


def plainly(text: str) -> str:
    """A sentence (in small letters) with its places and distances as :mod:`tambour.crochet.places.said` reads them."""
    k = _RULES.next(text)
    while k < _RULES.n:
        said, read = _RULES[k]
        text = said.sub(read, text)
        k = _RULES.next(text, k + 1)
    return text


_LIST: Final = re.compile(r"\s*\(([^()]*\b(?:r|rnds?|rounds?|rows?)\s?\.?\s*\d[^()]*)\)")
"""A place in brackets behind a part: "the ears (R4-8)"."""
_JOIN: Final = re.compile(r"\s*(?:,\s*(?:and\s+)?|\band\s+|;\s*)")
_LEAD: Final = re.compile(r"^(\W*(?:\w+\s+){0,3}?(?:sew|attach|place|position|put|pin|stitch|glue|insert|add)\w*)\s")


def unlisted(text: str) -> str:
    """A sentence that lists several parts, each with its place in brackets, as one clause for each: "Place the ears (R4-8) and the muzzle
    (R10-14)"."""
    lead = _LEAD.match(text)
    places = list(_LIST.finditer(text))
    if lead is None or len(places) < 2 or any("stitch" in m[1] and " in " in m[1] for m in places):
        return text
    made, at = lead[1], lead.end(1)
    for k, m in enumerate(places):
        name = text[at : m.start()]
        joined = _JOIN.match(name) if k else None
        if k and joined is None:
            return text
        name = name[joined.end() :] if joined is not None else name
        made += (", and place " if k else " ") + name.strip() + " at " + m[1]
        at = m.end()
    return made + text[at:]
