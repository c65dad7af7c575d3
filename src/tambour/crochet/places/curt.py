"""Curt: sentences of the assembly as people write them in a language that is not theirs, a part and its place and no verb, "Head on the body, 24 to 24
stitches", "Legs: the closed edge at round 8", "Nose brown, on the muzzle", put as most say them."""

from __future__ import annotations

import re
from typing import Final

from tambour.crochet.places import face
from tambour.crochet.places.habits import SCATTERED
from tambour.crochet.places.names import Made, kind_of, one
from tambour.crochet.places.said import VERB, where
from tambour.crochet.words.numbers import QUANTITY

_LONG: Final = 260
_LIST: Final = r"(?P<list>\W*(?:[a-z\d]{1,2}\s*[.)]\s*)?)"
_TAKEN: Final = re.compile(
    rf"^{_LIST}(?:(?:then|now|next|first|and|finally)\s+)*(?:i|we|you)\s+(?:then\s+)?take\s+(?P<what>(?:the|both|all)\s+(?:\w+\s+)?\w+)\s*(?=:)",
    re.IGNORECASE,
)
"""What is taken up before its place is said: "Then I take the muzzle: in the middle of the face"."""
_OWN: Final = re.compile(
    rf"^{_LIST}(?P<what>(?:(?:the|both|all)\s+)?(?:[a-z]+\s+){{0,2}}[a-z]+)\s*:\s*(?:(?:the|their|its|with the)\s+)?"
    r"(?:closed|open|flat|folded|narrow|wide|pressed|upper|top|sewn)\s+(?:edge|end|side|rim)s?\s+(?=(?:on|at|to|in|between|over|against|under|below|behind|beside|along)\b)",
    re.IGNORECASE,
)
"""What of a part is sewn: "Legs: the closed edge at round 8"."""
_BARE: Final = re.compile(
    rf"^{_LIST}(?P<what>(?:(?:the|both|all|two|four)\s+)*(?:[a-z]+\s+){{1,3}}?)(?P<on>upon|onto|on|behind|around|evenly spaced around|half ?way (?:up|down))\s+(?=(?:the|its|his|her|this|that|[a-z]+\b))",
    re.IGNORECASE,
)
"""A part, and what it is on: "Ears upon the head"."""
_SAME: Final = re.compile(
    rf",?\s*[(]?\b({QUANTITY})(?:\s*(?:st|sts|stitches))?\s+(?:to|on|and|with)\s+\1(?:\s+(?:st|sts|stitches))?\b[)]?(?!\s*(?:stitches|sts|st|rounds?)\b)",
    re.IGNORECASE,
)
"""How many stitches meet: "24 to 24 stitches", "(24 on 24)"."""
_SEEN: Final = re.compile(
    r",\s*(?:(?:on )?the same side (?:as|like)|so that|it|this)\b[^.;]*?(?=[.;]|$)|,\s*[a-z]+\s+(?:to|looks? to|towards) the front(?=\W*$)|,\s*opposite (?:to|of) (?:the )?[a-z]+(?=\W*$)",
    re.IGNORECASE,
)
"""What is seen then: ", the same side as the bell will be", ", pink to the front"."""
_AFTER: Final = re.compile(
    r",\s*(?:then\s+(?:turn|bend|lay|curl|bring|wrap|lead)\s+it\b[^.;]*"
    r"|(?:fill|stuff)\w*\s+(?:it\s+)?(?:in\s+)?and\s+sew\s+(?:it\s+)?(?:all\s+)?a?round\b"
    r"|(?:join|close|tie|fasten|sew)\s+(?:it\s+)?(?:behind|(?:at|in|on) the back)\b(?! of))",
    re.IGNORECASE,
)
"""What hands do behind the place, which is none: ", filling in and sew around", ", join behind"."""
_COVERS: Final = re.compile(
    r"(?<=\beach side)(?P<low>(?:,\s*[a-z]+)?),\s*over (?:the )?(?:ends?|tops?|backs?) of (?:the )?[a-z]+(?: [a-z]+)?(?=[,.]|$)",
    re.IGNORECASE,
)
"""What of another part lies under one that is put elsewhere: "one on each side, low, over the end of the paw"."""
_TAKES: Final = re.compile(r",\s*it (?:takes|covers|fills)\s+(?:up\s+)?(?:the|all|about)\b[^.;]*", re.IGNORECASE)
"""How far a part reaches: ", it takes the whole height of the wall"."""
_SOLE: Final = re.compile(r"\bon (?:the|each|both|its) soles?\b(?: of (?:the|each|both) \w+)?", re.IGNORECASE)
_RING: Final = re.compile(
    r"\bin a (?:ring|circle) (?:all )?(?:around|round) (?:it|this|that|the \w+(?: \w+)?)\s*,?\s*(?:about\s+|at\s+|on\s+|over\s+)?(?=r(?:ounds?|nds?)?\s?\d)",
    re.IGNORECASE,
)
_DOWN: Final = re.compile(
    r"\bfrom\s+(r(?:nd|ound|ow)?\s?\d+)\s+(?:down|downwards)\b(?!\s+(?:to|till|until))", re.IGNORECASE
)
_FEATURE: Final = re.compile(
    rf"^{_LIST}(?=(?:(?:an?|one|two|the|small|little|tiny|short|big)\s+)*(?P<what>nose|mouth|smile|cheeks|brows|eyebrows)\s+(?P<hue>[a-z]+)\s*,)",
    re.IGNORECASE,
)
"""A feature and its yarn: "Nose brown, on the muzzle"."""
_FROM_NOSE: Final = re.compile(
    rf"^{_LIST}(?=(?:from|below|under|at) the nose\b[^.;]*\b(?:lines?|smile|mouth)\b)", re.IGNORECASE
)
_WHISKERS: Final = re.compile(
    rf"^{_LIST}whiskers?[ ,:]+(?:{QUANTITY})\s+and\s+(?:{QUANTITY})\s+(?:in|on|into)\s+", re.IGNORECASE
)
_LOWER: Final = re.compile(
    rf"^{_LIST}(?P<what>(?:an?\s+|the\s+)?(?:[a-z]+\s+){{0,3}}?(?:mouth|smile))\s*,?\s+(?P<far>(?:{QUANTITY})\s+(?:rounds?|rnds?|rows?|r))\s+lower\b(?!\s+than\b(?! (?:the |his |her )?nose\b))",
    re.IGNORECASE,
)
"""A mouth so many rounds lower than the nose that was spoken of before it."""
_ONES: Final = re.compile(rf"\b(?:the\s+)?(?:{QUANTITY}\s+)?(?P<sort>[a-z]+)\s+ones?\b", re.IGNORECASE)
_PULLED: Final = re.compile(
    rf"^{_LIST}(?:pull|draw|slip)\s+(?P<what>(?:the\s+)?(?:cap|wig|hat|hood|hair))\s+(?:over|on|onto|down over)\s+(?=(?:her|his|its|the)\s+head\b)",
    re.IGNORECASE,
)
"""A cap that is pulled over a head: what is said of its own edge then is no place of it."""
_VERBS: Final = re.compile(
    r"^\W*(?:[a-z]\)\s*)?(?:do|don't|can|may|be|see|use|cut|leave|keep|stuff|fill|turn|make|work)\b", re.IGNORECASE
)


_TELLS: Final = re.compile(r"\b(?:is|are|was|were|looks?|turned|came|mine|my|ours?)\b", re.IGNORECASE)
"""What is told of a part, and puts it nowhere: "The arms on mine are a bit crooked"."""


def fuller(text: str, names: list[str]) -> str:
    """A sentence as most say it; as it is where it is none of these. names : of the parts that are known."""
    if len(text) > _LONG or text.isupper() or text.rstrip().endswith(":") or SCATTERED.match(text):
        return text
    known = {w for name in names for w in Made(name, 1).words}
    said = _RING.sub("evenly spaced around ", _sorted(text, names))
    said = _TAKES.sub("", _COVERS.sub(r"\g<low>", said))
    if (feet := next((w for w in ("foot", "leg", "paw", "shoe") if w in known), "")) and "sole" not in known:
        said = _SOLE.sub(f"on the {feet}", said)
    if VERB.search(said.lower()) and not VERB.search((plain := _AFTER.sub("", said)).lower()):
        said = plain
    if (found := _TAKEN.match(said)) is not None and _part(found["what"], known):
        said = found["list"] + found["what"] + said[found.end() :]
    if (found := _OWN.match(said)) is not None and _part(found["what"], known):
        return f"{found['list']}Sew {found['what']} {_SAME.sub('', said[found.end() :])}"
    if (found := _PULLED.match(said)) is not None and not VERB.search(said[found.end() :].lower()):
        return f"{found['list']}Put {found['what']} on the head"
    drawn = _drawn(said, known)
    if drawn != said:
        return drawn
    plain = _DOWN.sub(r"at \1", _SEEN.sub("", _SAME.sub("", said)))
    found = _BARE.match(plain)
    if (
        found is None
        or ":" in plain
        or VERB.search(plain.lower())
        or _VERBS.match(plain)
        or _TELLS.search(plain, found.start("on"))
        or not _part(found["what"], known)
    ):
        return said
    behind = [one(w) for w in re.findall(r"[^\W\d_]+", plain[found.end() :].lower())]
    if not any(w in known or kind_of(w) for w in behind[:5]) and not where(plain[found.start("on") :].lower()).says:
        return said
    on = "on" if found["on"].lower() == "upon" else found["on"]
    return f"{found['list']}Sew {found['what']}{on} {plain[found.end() :]}"


def by_its_edge(text: str, names: list[str]) -> str:
    """A sentence that says by which of its edges a part is sewn, as most say it; "" for another."""
    full = fuller(text, names) if _OWN.match(text) else text
    return full if full != text else ""


def _part(words: str, known: set[str]) -> bool:
    """Whether words name a part, and nothing else."""
    said = [one(w) for w in re.findall(r"[^\W\d_]+", words.lower()) if w not in _ARTICLES]
    return (
        bool(said)
        and (said[-1] in known or bool(kind_of(said[-1])))
        and all(w in known or kind_of(w) or w in _SORTS for w in said)
    )


def _drawn(said: str, known: set[str]) -> str:
    """What is embroidered, with its verb."""
    if (found := _LOWER.match(said)) is not None and not face.motifs(said.lower())[1:]:
        return f"{found['list']}Embroider {found['what']} {found['far']} below the nose{said[found.end() :]}"
    if (found := _FEATURE.match(said)) is not None and not {one(found["what"].lower())} & known:
        return f"{found['list']}Embroider the {said[found.end() :]}"
    if (found := _FROM_NOSE.match(said)) is not None and not VERB.search(said.lower()):
        return f"{found['list']}Embroider {said[found.end() :]}"
    if (found := _WHISKERS.match(said)) is not None:
        return f"{found['list']}Embroider whiskers on {said[found.end() :]}"
    return said


def _sorted(text: str, names: list[str]) -> str:
    """A sentence with the name of a part in place of "the six small ones", where one part alone is called small."""
    found = _ONES.search(text)
    if found is None:
        return text
    called = [name for name in names if found["sort"].lower() in Made(name, 1).words]
    return text[: found.start()] + f"the {called[0].lower()}" + text[found.end() :] if len(called) == 1 else text


_ARTICLES: Final = frozenset("the both all two four six three and".split())
_SORTS: Final = frozenset("front back hind fore left right inner outer upper lower small big large little".split())
