"""Printed patterns, put: sentences that put a part or a face somewhere, and those that say how a part is stuffed."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.stitches import STUFFING
from tambour.crochet.places import face
from tambour.crochet.places.assembling import TO, assembling
from tambour.crochet.places.names import Made, kind_of, one
from tambour.crochet.places.terse import spoken, under
from tambour.crochet.places.topic import told_whole
from tambour.crochet.printed.between.assembly import Said, alike, eyes_meant
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token
from tambour.crochet.words.gloss import english

_SEWN: Final = re.compile(
    r"\bsew\b.{0,20}\b(?:in place|into place|behind|between|beneath|above|below|under)\b", re.IGNORECASE
)


_NEAR: Final = 6  # words from "stuff" on that say what, and how
_HOW: Final = re.compile(r"\b(?:posts?|shanks?)\b[^.;]*\bbetween\b[^.;]*\bstrands\b", re.IGNORECASE)
"""How eyes are fastened, wherever they are: "Push posts of eyes between strands of a stitch"."""

_OFF: Final = re.compile(r"\b(?:fasten|finish|cut|break|end)\w*\s+(?:off|yarn)\b[^.;\n]*", re.IGNORECASE)
"""What ends the yarn puts no part anywhere: "fasten off leaving a long tail for sewing"."""
_INNER: Final = re.compile(
    r"\b(?:put|place|insert|lay|slip|add|pop|use)\b[^.;]*\b(?:card|cardboard|jar|bottle|wire|beans?|pellets?|magnets?|rattle|bell|squeaker|"
    r"cotton bud|pipe cleaners?|dowel|chopstick|coins?|pebbles?|marbles?|weights?)\b",
    re.IGNORECASE,
)
"""What lies inside a toy, and is not seen."""
_SEWS: Final = re.compile(r"\b(?:sew|attach|embroider|stitch)\w*\b", re.IGNORECASE)
_SEWING: Final = ("sew", "attach", "stitch", "pin")
_CLOSES: Final = re.compile(r"\b(?:closed|shut|close|together|tog|marker)\b")
"""What is sewn up, and sewn to nothing else."""
_BEARS: Final = frozenset(
    ("head", "body", "face", "hat", "leg", "arm", "foot", "tail", "wing", "belly", "shell", "neck", "ear", "muzzle")
)
"""Kinds of parts that others are sewn to, also where they are written later."""
_TELLS: Final = re.compile(r"\W*(?:I|I'm|I've|we|we've)\s", re.IGNORECASE)
_YOUNG: Final = re.compile(
    r"\W*if\b.*\b(?:child|children|kids?|bab(?:y|ies)|infants?|toddlers?|under (?:3|three))\b",
    re.IGNORECASE | re.DOTALL,
)


_HOLDS: Final = re.compile(
    r"\W*(?:(?:then|now|also|and)\s+)?(?:fix|catch|tack|secure|hold)\b[^.;]*\b(?:with|by)\s+(?:a\s+few|some|a\s+couple\s+of|one|two|three|[1-5])\s+(?:(?:small|tiny|little)\s+)?stitch",
    re.IGNORECASE,
)
"""Stitches that only hold a part where it is: "Fix the inner side of each leg with a few stitches at R14"."""
_BEFORE_YOU: Final = re.compile(
    r"\W*before (?:you )?(?:fix|fixing|close|closing|push|press|lock|snap)\w* (?:the |their |its )?(?:washers?|backs?)\b[^.;]*\blook\b",
    re.IGNORECASE,
)
"""A look at the face before the eyes are fastened."""


def beside_the_point(text: str) -> bool:
    """Whether a sentence that names parts or eyes puts none anywhere: what lies inside, what its writer did herself, what is safe for whom."""
    if _YOUNG.match(text) or _BEFORE_YOU.match(text) or _HOLDS.match(text):
        return True
    if _TELLS.match(text):
        return not re.search(r"\b(?:rounds?|rnds?|rows?|R\d+)\b", text, re.IGNORECASE)
    return _INNER.search(text) is not None and not _SEWS.search(text)


_UNSAID: Final = re.compile(r"(?: [^\W\d_]+)+(?=[.;!\n]|$)")


_BEFORE: Final = re.compile(r"(?:^|[.!?:)\]*•-]\s+)((?:[^\W\d_]+ )+)$")
"""Words at the end and at the beginning of a sentence that are no tokens, since they work nothing: "The fins … spread evenly"."""


_PARTLY: Final = frozenset(
    (
        "last remaining rem rest top end over overstuff overstuffing overfill overfilling weighted pellets too rounds rnds "
        "trop excès überstopfen überfüllen demasiado exceso teveel overvullen"
    ).split()
)
"""Words of sentences that say how, or how far, a part is not stuffed."""


_ONLY: Final = re.compile(r"\b(?:just|only)\s+the\b", re.IGNORECASE)
_TIPS: Final = frozenset(
    ("tip", "tips", "end", "ends", "bottom", "toe", "toes", "paw", "paws", "hoof", "hooves", "hand", "hands")
)
"""Words of sentences that have a part's end stuffed, and no more."""


def ended(text: str, at: int) -> int:
    """Where the sentence ends of which the last words may be no tokens, since they work nothing."""
    rest = _UNSAID.match(text, at)
    return at if rest is None else rest.end()


def finishing(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence puts a part or a face somewhere; it is kept until all parts are known."""
    if not p.parts or p.mode in ("materials", "abbreviations"):
        return False
    if tokens[0].value == "repeat" and any(t.value in ("round", "row") for t in tokens[1:4]):
        return False  # "Rep last rnd until Body measures 6 ins from Leg join"
    text = p.source.text.text[tokens[0].start : tokens[-1].end]
    if _HOW.search(text):
        return False
    names = [draft.name for draft in p.parts]
    text = eyes_meant(p.source.text.text, tokens[0].start, text)
    heard = english(text, p.language.code).text
    if heard is not text:
        named = any(kind_of(one(w)) for w in re.findall(r"[^\W\d_]+", heard)) or face.motifs(heard)
        stitches = any(t.kind == "stitch" for t in tokens) and not re.search(
            r"\b(?:sew|place|embroider)\b", spoken(heard, names)
        )
        if not named or stitches:
            return False
    heard = told_whole(p.source.text.text, tokens[0].start, heard, names, p.parts[-1].name)
    part, headed = p.parts[-1].name, p.heading.name if p.heading is not None else ""
    led = under(english(headed.lower(), p.language.code).text, heard, names)
    if not (
        assembling(spoken(_OFF.sub(" ", heard), names), names)
        or _SEWN.search(text)
        or (led and assembling(spoken(led, names), names))
    ):
        return False
    _filled(p, tokens)
    whole = p.source.text.text
    line = whole.rfind("\n", 0, tokens[0].start) + 1
    before, rest = _BEFORE.search(whole[line : tokens[0].start]), _UNSAID.match(whole, tokens[-1].end)
    begin = tokens[0].start if before is None else line + before.start(1)
    span = Span(begin, tokens[-1].end if rest is None else rest.end())
    p.sentences.append(Said(tokens, alike(headed, names) or part if headed else part, span, headed))
    return True


def sews(p: State, tokens: list[Token]) -> bool:
    """Whether what hands do while a round is worked, or behind its last, sews a part on: "Sew on the snout, stuffing lightly as you work", and the
    part itself to another: "Fasten off. Sew Wings to sides of Body", "Using photograph as a guide, sew ears to head"."""
    first = tokens[0].word in _SEWING
    named = _named(p, tokens[1:])
    if first and named is not None and named is not p.parts[-1]:
        return True
    verb = next((k for k, t in enumerate(tokens) if t.word in _SEWING), None)
    if verb is None:
        return False
    said = p.source.text.text[tokens[verb].start : tokens[-1].end].lower()
    to = TO.search(said)
    if to is None or _CLOSES.search(said):
        return False
    own = Made(p.parts[-1].name, 1)
    others = {w for draft in p.parts[:-1] for w in Made(draft.name, 1).words} - set(own.words)
    words = [one(w) for w in re.findall(r"[^\W\d_]+", said[to.end() :])]
    return any(w in others or kind_of(w) in _BEARS - set(own.kinds) for w in words)


def eyed(tokens: list[Token]) -> bool:
    """Whether what hands do while a round is worked says between which rounds eyes are put in."""
    values = [t.value for t in tokens]
    numbers = sum(t.kind in ("number", "ordinal") for t in tokens)
    return "eyes" in values and "between" in values and ("round" in values or "row" in values) and numbers > 1


_ITSELF: Final = frozenset("the this piece part well very quite just only rather".split())


def _filled(p: State, tokens: list[Token]) -> None:
    """Takes how a part is stuffed from the sentence that sews it on: "Stuff the muzzle lightly and sew it to the head", "Sew on the snout,
    stuffing lightly as you work"; where it names only what it is sewn to, "Stuff lightly and sew to the head", the part itself is meant."""
    at = next((k for k, t in enumerate(tokens) if t.kind == "key" and t.value == "stuff"), None)
    if at is None or any(t.value == "not" for t in tokens[max(0, at - 3) : at]):
        return
    near = tokens[at : at + _NEAR]
    amount = next((word for word in ("light", "medium", "firm") if any(t.value == word for t in near)), None)
    part = _named(p, _sewn_on(near)) or _named(p, _sewn_on(tokens[:at]))
    joined = next((k for k, t in enumerate(near) if t.value == "and"), 0)
    named = any(t.kind == "word" and len(t.word) > 2 and t.word not in _ITSELF for t in near[1:joined])
    if (
        part is None and p.mode != "assembly" and not named
    ):  # "Stuff the neck firmly and sew on to the head" names another
        part = p.parts[-1]
    if amount is not None and part is not None and part.stuffing is None:
        part.stuffing = STUFFING[amount]


def _sewn_on(tokens: list[Token]) -> list[Token]:
    """The words before those that say to what something is sewn."""
    words = [t.word for t in tokens]
    sewn = next((k for k, word in enumerate(words) if word in _SEWING), 0)
    return tokens[: next((k for k in range(sewn, len(words)) if words[k] in ("to", "onto")), len(words))]


_BINDS: Final = frozenset("and or of the a an for with to in on und et y en".split())
"""Words of a part's name that name nothing: the "and" of "stuff lightly and sew in place" is not HEAD AND BODY."""


def _named(p: State, tokens: list[Token]) -> Draft | None:
    """The first part that words name."""
    words = [one(t.word) for t in tokens]
    kinds = {draft.name: {one(w) for w in draft.name.lower().split()} - _BINDS for draft in p.parts}
    return next((draft for word in words for draft in p.parts if len(word) > 1 and word in kinds[draft.name]), None)


def stuffed(tokens: list[Token], part: str = "", said: str = "") -> float | None:
    """How much a sentence wants the part stuffed; -1 when it says only that it is.

    part : the name of the part that it stands in; said : its words as they stand in the text. "Do not stuff ears", in a note under the legs, is not said of them; "do not
    overstuff", "do not stuff the last rounds", "do not use pellets to stuff" leave no part empty.
    """
    if not any(t.kind == "key" and t.value == "stuff" for t in tokens) or len(tokens) > 14:
        return None
    if any(t.kind == "stitch" for t in tokens):
        return None
    words = [t.word for t in tokens]
    if any(t.kind == "key" and t.value == "not" for t in tokens) and (
        _PARTLY & set(words) or any(kind_of(one(w)) not in ("", *Made(part, 1).kinds) for w in words)
    ):
        return -1.0
    if _ONLY.search(said) and any(kind_of(one(w)) or w in _TIPS for w in words):
        return STUFFING["light"]  # "stuff just the paw": the rest stays soft
    for word, amount in (("not", "none"), ("light", "light"), ("medium", "medium"), ("firm", "firm")):
        if any(t.kind == "key" and t.value == word for t in tokens):
            return STUFFING[amount]
    return -1.0
