"""Printed patterns, what stands around the rounds: headings of parts, the pattern's own abbreviations, yarn and hook."""

from __future__ import annotations

import re
import unicodedata
from dataclasses import dataclass, replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.tokens import Row, Token

MODES: Final = {
    "materials": "materials",
    "abbreviations": "abbreviations",
    "special stitches": "abbreviations",
    "gauge": "materials",
    "finished size": "materials",
    "yarn": "materials",
    "hook": "materials",
    "eyes": "materials",
    "notes": "notes",
    "instructions": "",
    "assembly": "assembly",
}
"""A heading's concept → what its lines are about."""

STATED: Final = {
    "yarn": "yarn",
    "hook": "hook",
    "gauge": "gauge",
    "finished size": "size",
    "eyes": "eyes",
    "materials": "yarn",
}
"""A word before a colon → what the pattern states after it."""

BELOW: Final = {key: STATED[key] for key in ("gauge", "finished size", "hook")}
"""A heading's concept → what the line below it states."""

_WORDS: Final = 6  # of a heading
_LEVELS: Final = frozenset(
    "very easy medium hard beginner intermediate advanced experienced skill level difficulty / - to and + .".split()
)
"""Words of a line that says how hard a pattern is: "EASY/MEDIUM"."""


@dataclass(frozen=True)
class Heading:
    """A line that may name a part. ``strong``: it looks like a heading whatever follows."""

    name: str
    span: Span
    copies: int = 1
    copies_span: Span | None = None
    strong: bool = False
    marked: bool = False


_LISTED: Final = re.compile(r"^\W*\d{1,2}\s*(?:[.):–—-]+\s*|\s)(?=[^\W\d_]{3})")
"""The number of a heading in a list: "1. CARROT"."""


def plain_name(words: str) -> str:
    """A part's name as tambour's own language can write it: words of plain letters, numbers joined to them."""
    words = words.replace("&", " and ").replace("+", " and ").replace(",", " and ")
    flat = unicodedata.normalize("NFKD", words.replace("ß", "ss").replace("ø", "o").replace("æ", "ae"))
    flat = "".join(c for c in flat if not unicodedata.combining(c))
    made: list[str] = []
    flat = _LISTED.sub("", flat)
    for word in re.findall(r"[A-Za-z0-9_]+", flat):
        if word[0].isdigit():
            made = [*made[:-1], f"{made[-1]}_{word}"] if made else [f"part_{word}"]
        else:
            made.append(word)
    return " ".join(made)


_RANKS: Final = re.compile(r"(\d+)(?:st|nd|rd|th)\s*(?:to|through|-|–)\s*(\d+)(?:st|nd|rd|th)\b", re.IGNORECASE)


_HUED: Final = frozenset("color colour colors colours yarn cotton wool acrylic".split())


def heading(text: str, row: Row, tokens: list[Token]) -> Heading | None:
    """The heading that a line is, None when it cannot be one."""
    shown, tokens = tokens, _unseen(text, tokens)
    diagram = len(tokens) < len(shown) and any(t.word == "see" for t in shown[1:])
    c = Cursor(tokens)
    name: list[Token] = []
    copies, at = 1, None
    if c.key("make") and _part(tokens):  # "Make the ears (2)."
        inner = [t for t in tokens[1:] if t is not tokens[-1] or t.word not in (".", ":")]
        cut = replace(row, tokens=[t for t in row.tokens if t.start >= inner[0].start])
        made = heading(text, cut, inner)
        return made if made is None else replace(made, strong=True, marked=True)
    if c.key("make") and c.whole(1) is not None and len(tokens) <= 5:
        # "Make 2 ears"
        copies, at = c.whole(1) or 1, tokens[1].span
        c.at = 2
    while (token := c.look()) is not None:
        if token.kind == "mark" and token.word not in (",", "-", "/", "&", "'", '"', "#", ".", "+"):
            break
        if token.word == "," and name and all(kind_of(one(t.word)) or t.value == "and" for t in name):
            c.at += 1  # "SNOUT, HEAD & BODY"
            continue
        if token.word == ",":
            break
        if token.kind == "mark" and token.word == "-" and (c.key("make", ahead=1) or c.whole(1) is not None):
            break
        if (token.word == "." and not token.glued) or (token.kind == "key" and token.value == "make"):
            break
        if (token.kind == "mark" and token.word == "x") or (c.whole() is not None and c.mark("x", ahead=1)):
            break
        name.append(token)
        c.at += 1
    if not name or len([t for t in name if t.kind != "mark"]) > _WORDS or name[-1].word == ".":
        return None
    found = _copies(c)
    if name[0].word == "by" or (found is None and all(t.word in _LEVELS for t in name)):
        return None  # who made it, and how hard it is
    if found is not None:
        copies, at = found
    elif (ranks := _RANKS.match(text, name[0].start)) and int(ranks[1]) < int(ranks[2]):
        copies = int(ranks[2]) - int(ranks[1]) + 1  # "2nd to 8th Tentacles"
    of_it = " of " in text[name[0].start : name[-1].end].lower()  # "Ball of yarn"
    if name[0].word in ("use", "using", "with") or (name[-1].word in _HUED and not of_it):
        return None  # "Use colour of your choice", "LIGHT COLOUR"
    colon = c.mark(":")
    c.at += colon
    if row.marked and at is not None and c.mark(",") and len(tokens) - c.at < _WORDS:
        c.at = len(tokens)  # "make 2, in blue": whose color is read with the part
    if c.look() is not None and not (c.mark(".", "-", "*") and c.look(1) is None):
        return None
    begin, end = name[0].start, name[-1].end
    lettered = next((t for t in row.tokens if t.start >= end), None)
    if lettered is not None and lettered.value == "A" and not text[end : lettered.start].strip():
        end = lettered.end  # "Half A": the article that was left out is its letter
    words = text[max(begin, row.start) : end]
    # What was left out as a filler still belongs to the name.
    words = text[row.tokens[0].start : end] if at is None or at.start > end else words
    if any(t.start == t.end for t in name):
        words = " ".join(t.word for t in name)  # a noun that stands in the heading above: "Six small, each:"
    if any(t.kind == "key" and t.value == "hook" for t in name):
        return None  # "Crochet hook C in white"
    if any(a.kind == "number" and b.kind == "stitch" for a, b in pairwise(name)):
        return None  # "Then two sc and an increase, six times."
    if not any(ch.isalpha() for ch in words) or any(isinstance(t.value, float) for t in name):
        return None
    capitals = words.isupper()
    strong = bool(row.marked) or at is not None or colon or capitals or diagram
    if not strong and (len(name) > 4 or not words[0].isupper() or any(t.kind == "number" for t in name[:-1])):
        return None
    stitches = any(t.kind == "stitch" and not (t.capital and t.value in _NAMING and t is not name[0]) for t in name)
    if stitches and (name[0].kind in ("number", "stitch") or not (at is not None or row.marked)):
        return None
    clean = plain_name(words)
    if not clean:
        return None
    return Heading(clean, Span(row.tokens[0].start, end), copies, at, strong, bool(row.marked) or at is not None)


def _part(tokens: list[Token]) -> bool:
    """Whether words behind "Make the" are no more than names of parts, and their copies."""
    end = next((k for k, t in enumerate(tokens) if t.word in ("(", "[", ".", ":")), len(tokens))
    words = [t for t in tokens[1:end] if not (t.kind == "key" and t.value == "and")]
    return 0 < len(words) <= _WORDS and all(kind_of(one(t.word)) for t in words)


def _unseen(text: str, tokens: list[Token]) -> list[Token]:
    """``tokens`` without "(see diagram on page 3)"; behind capitals, without any words in brackets that say no copies."""

    def aside(k: int) -> bool:
        return _aside(tokens[k + 1 : k + 24]) or (
            k > 0 and text[tokens[0].start : tokens[k - 1].end].isupper() and _plain(tokens[k + 1 :])
        )

    begin = next((k for k, t in enumerate(tokens[:-1]) if t.word in ("(", "[") and aside(k)), None)
    if begin is None:
        return tokens
    end = next((k for k in range(begin, len(tokens)) if tokens[k].word in (")", "]")), len(tokens) - 1)
    return [*tokens[:begin], *(replace(t, glued=False) for t in tokens[end + 1 : end + 2]), *tokens[end + 2 :]]


_NAMING: Final = frozenset(("fur", "loopst", "spike", "picot", "cl", "bobble"))  # words of names too: "Facial Fur"


def _aside(tokens: list[Token]) -> bool:
    """Whether words behind a bracket say no copies: "(see page 3)", "(Make with A for Bear, with B for Puppy)",
    "(start with blue, at the nose)", "(for headband)", "(optional)"."""
    if tokens[0].word in ("see", "optional"):
        return True
    if tokens[0].value not in ("begin", "work", "with", "for", "make"):
        return False
    inner = tokens[: next((k for k, t in enumerate(tokens) if t.word in (")", "]")), len(tokens))]
    if tokens[0].value == "make":
        return len(inner) > 2 and not any(t.kind in ("number", "stitch", "ordinal") for t in inner)
    return not any(t.kind in ("stitch", "number") for t in inner)


def _plain(tokens: list[Token]) -> bool:
    """Whether words in a bracket that only ends a line are no copies, counts or stitches: "(one piece, from the top down)"."""
    end = next((k for k, t in enumerate(tokens) if t.word in (")", "]")), len(tokens))
    said = any(t.kind in ("stitch", "ordinal") or t.word == "x" or isinstance(t.value, float) for t in tokens[:end])
    counted = any(t.kind == "number" and t.word != "one" for t in tokens[:end]) or any(
        t.value == "make" for t in tokens[:end]
    )
    return 1 < end == len(tokens) - 1 and not said and not counted


def copies_alone(tokens: list[Token]) -> tuple[int, Span] | None:
    """The copies that a line of its own says: "(make 2)" below a heading."""
    if not any(t.kind == "key" and t.value == "make" for t in tokens[:2]) or any(t.kind == "word" for t in tokens):
        return None
    c = Cursor(tokens)
    found = _copies(c)
    return found if found is not None and (c.look() is None or c.mark(".", ":")) else None


def copies_in(tokens: list[Token]) -> tuple[int, Span] | None:
    """The copies that a bracket says: "(make 2 alike)"."""
    if not any(t.kind == "key" and t.value == "make" for t in tokens[:2]):
        return None
    return _copies(Cursor(tokens))


def copies_said(tokens: list[Token]) -> tuple[int, Span, bool] | None:
    """How many copies a sentence says that names yarns or versions: "(Make 1 with A and 1 with B)", "Make 2 each with A, B, C"; and whether
    they come to those already made ("Make 1 more with D"). None for another sentence."""
    tokens = [t for t in tokens if t.word not in ("(", ")", "[", "]")]
    c = Cursor(tokens)
    numbers = [k for k, t in enumerate(tokens) if isinstance(t.value, int) and t.kind == "number" and _counts(c, k)]
    if (
        not tokens
        or not (tokens[0].kind == "key" and tokens[0].value == "make" and tokens[0].word != "cut")
        or numbers[:1] != [1]
        or len(tokens) > 40
    ):
        return None
    if any(
        t.kind == "stitch"
        or (t.kind == "key" and t.value in _WORKED)
        or (t.word in ("small", "tight") and not t.capital)
        for t in tokens[1:4]
    ):
        return None
    if any(
        t.kind == "stitch"
        or (t.kind == "key" and t.value in ("round", "row", "ring", "hook", "repeat") and t.word != "mc")
        for t in tokens
    ):
        return None
    if not any(t.word in _ALIKE or (t.kind == "key" and t.value in ("with", "for", "each", "in")) for t in tokens[2:]):
        return None
    total, versions = 0, False
    parts = [int(tokens[k].value) for k in numbers]
    each = any(t.value == "each" for t in tokens[numbers[-1] :])
    if len(parts) > 1 and tokens[2].word == "," and parts[0] > 1 and (each or parts[0] == sum(parts[1:])):
        return parts[0], tokens[1].span, False  # "make 4, 2 in each color"
    for k in numbers:
        after = tokens[k + 1 : k + 16]
        end = next((n for n, t in enumerate(after) if t.kind == "number"), len(after))
        each = any(t.kind == "key" and t.value == "each" for t in after[:end])
        letters = sum(
            1
            for t in after[:end]
            if (t.kind == "word" and len(t.word) == 1) or t.word in ("mc", "cc", "ca", "cb", "cd", "ce")
        )
        total += int(tokens[k].value) * (letters if each and letters else 1)
        rest = tokens[k + 1 :]
        name = next((n for n, t in enumerate(rest) if t.kind == "key" and t.value == "for"), None)
        if name is not None and any(t.kind == "key" and t.value == "make" for t in rest[name:]):
            versions = versions or not any(t.kind == "number" for t in rest[:name])
        if versions or (k + 1 < len(tokens) and tokens[k + 1].word in ("-", ":")):
            break  # the copies of the first version; "3 - 1 each with B, C, D"
    more = any(t.kind == "key" and t.value == "more" for t in tokens[:4])
    return (total, tokens[numbers[0]].span, more) if 1 <= total <= 1000 else None


_PIECES: Final = frozenset(
    "pieces parts pcs pc piece part stück stk piezas iguales pièces stuks delen details detail elements".split()
)
_WORKED: Final = ("ring", "stitch", "hook", "loop", "round", "row")
_ALIKE: Final = frozenset(("alike", "pieces", "the same", "per"))


def _copies(c: Cursor) -> tuple[int, Span] | None:
    """``(make 2)``, ``x2``, ``- make two``, ``(2x)``, ``(2)`` at the cursor."""
    begin = c.at
    if c.mark("(", "["):
        end = next((k for k in range(c.at, len(c.tokens)) if c.tokens[k].word in (")", "]")), len(c.tokens) - 1)
        ranged = c.whole(2) is not None and _ranged(Cursor(c.tokens, c.at + 3))
        listed = None if ranged else copies_said(c.tokens[c.at + 1 : end])
        if listed is not None:
            c.at = end + 1
            return listed[:2]
    while c.mark("(", "[", "-", ",", ":", "."):
        c.at += 1
    worded = c.skip_key("make")
    if c.mark("x"):
        c.at += 1
        worded = True
    number = c.look()
    count = c.whole()
    if count is None or number is None:
        c.at = begin
        return None
    c.at += 1
    if worded and _ranged(c):
        c.at += 2  # "(make 5-7)": the fewest that she asks for
    if c.mark("x") or c.key("times", "make") or (c.look() is not None and c.look().word in _PIECES):  # type: ignore[union-attr]
        c.at += 1
        worded = True
    ahead = next((k for k in range(6) if c.mark(")", "]", ahead=k)), 0)
    if worded and ahead and not any(c.kind("stitch", k) or _counts(c, k) for k in range(ahead)):
        c.at += ahead  # "(make 2 with C)", "(make 2, Color 3)"
    bracketed = c.mark(")", "]")
    c.at += bracketed
    if not worded and not (bracketed and c.look() is None):
        c.at = begin
        return None
    if not 1 <= count <= 1000:
        c.at = begin
        return None
    return count, number.span


def _ranged(c: Cursor) -> bool:
    """Whether the larger number of a range stands at the cursor: "-7", "to 7", "or 7", and the range ends there."""
    low, high, end = c.whole(-1), c.whole(1), c.look(2)
    parted = (sign := c.look()) is not None and sign.word in ("-", "to", "or")
    return parted and low is not None and high is not None and low < high and (end is None or end.kind != "stitch")


def _counts(c: Cursor, ahead: int) -> bool:
    """Whether a number there says how many, and is none that names a yarn, a hook or a page: "Color 3"."""
    before = c.look(ahead - 1)
    named = before is not None and (before.value in ("color", "yarn", "hook") or before.word in _NAMED_BY_NUMBER)
    return c.whole(ahead) is not None and not named


_NAMED_BY_NUMBER: Final = frozenset("color colour yarn shade size page diagram chart figure no # step".split())


def stated(text: str, row: Row, tokens: list[Token]) -> list[tuple[str, str, Span]]:
    """What a line says of yarn, hook, gauge, size and eyes: ``Hook: 3.5 mm``."""
    found = []
    for k, token in enumerate(tokens[:-1]):
        if token.kind != "key" or token.value not in STATED or tokens[k + 1].word not in (":", "-", "="):
            continue
        if k and tokens[k - 1].word not in (".", ";", ",", "|", "-", "+", "/") and k > 2:
            continue
        if k and any(t.kind == "key" and t.value == "not" for t in tokens[:k]):
            continue  # "No safety eyes - all is embroidered"
        end = row.end
        for later in range(k + 2, len(tokens)):
            ends = (tokens[later].word in (".", ";") and not tokens[later].glued) or tokens[later].word == "."
            if (
                ends
                and later + 1 < len(tokens)
                and tokens[later + 1].kind == "key"
                and tokens[later + 1].value in STATED
            ):
                end = tokens[later].start
                break
        begin = tokens[k + 1].end
        words = text[begin:end].strip().rstrip(".").strip("*| ")
        if words:
            found.append((STATED[token.value], words, Span(begin, end)))
    return found


def own_stitch(tokens: list[Token]) -> tuple[list[str], str] | None:
    """A stitch of the pattern's own, explained in its abbreviations: ``Cross sc = …``, ``Scbl = single crochet in back loop``.

    Gives its spellings and the usual stitch that it is nearest to: the one that its name ends with, or that its
    explanation names first.
    """
    at = next((k for k, t in enumerate(tokens[:9]) if t.word in ("=", ":")), 0)
    name, said = tokens[:at], tokens[at + 1 :]
    opened = next((k for k, t in enumerate(name) if k and t.word in ("(", "[")), 0)
    if opened and _grown(said):
        name = name[:opened]  # "h-inc (hdc increase) = 2 hdc in next st"
    if len(name) == 1 and name[0].kind == "stitch" and said and name[0].word.endswith("st"):
        return [name[0].word.replace(" - ", "-") + "s"], name[0].value  # its plural
    if not name or not said or len(name) > 6 or (len(name) == 1 and name[0].kind == "stitch"):
        return None
    if any(t.kind in ("number", "ordinal") or t.word in "()[]" for t in name):
        return None
    whole = "-".join(t.word for t in name if t.word != "-")
    if grown := _grown(said):
        return [whole, f"{whole}s"], grown
    if len(name) > 1 and name[-1].value in _LOOPED:  # "shaggy loop stitch = …"
        return [whole, f"{whole}s"], name[-1].value
    stitch = any(t.kind == "stitch" or (t.kind == "key" and t.value == "stitch") for t in name)
    kinds = [t.value for t in said if t.kind == "stitch" and t.value in _KINDS]
    named = [t.value for t in name if t.kind == "stitch" and t.value in _KINDS]
    bare = re.sub(r"^[bf]lo?(?=[shdt])", "", name[0].word)  # "blsc"
    glued = next((k for k in _KINDS if bare.startswith(k) and len(name) == 1), "")
    together = re.fullmatch(r"(sc|hdc|dc|tr)([2-6])tog\w+", name[0].word) if len(name) == 1 else None
    if together is not None:  # "sc2togtbl"
        return [whole], f"{together[1].removeprefix('sc')}dec{together[2] if together[2] != '2' else ''}"
    if not (stitch or glued) or not (kinds or named):
        return None
    if said[0].word in ("(", "{") and sum(t.kind == "stitch" for t in said[: _close(said)]) > 1:
        return None  # "V-st = (dc, ch 1, dc) in same space": no usual stitch is near to it
    drawn = _TOGETHER.fullmatch(name[-1].word)
    if drawn is not None:  # "loop-st2tog"
        return [whole], f"dec{drawn[1] if drawn[1] != '2' else ''}"
    if len(name) > 1 and name[-1].value == "stitch" and name[-2 - (name[-2].word == "-")].value == "loop":
        return [whole, f"{whole}s"], "loopst"
    kind = (named[-1:] or [glued] if named or glued else kinds[:1])[0]
    return [whole, f"{whole}s", whole.replace("-st", "-sts")], kind


def _grown(said: list[Token]) -> str:
    """The increase that an explanation says, "2 hdc in next st"; "" for none."""
    if len(said) < 3 or said[0].kind != "number" or said[0].value not in (2, 3) or said[2].value != "in":
        return ""
    kind = said[1].value if said[1].value in _KINDS else ""
    many = "" if said[0].value == 2 else said[0].value
    return f"{'' if kind == 'sc' else kind}inc{many}" if kind else ""


def _close(tokens: list[Token]) -> int:
    """Where the bracket that tokens begin with closes."""
    return next((k for k, t in enumerate(tokens) if t.word in (")", "}")), len(tokens))


_TOGETHER: Final = re.compile(r"(?:sts?|loops?|lps?)([2-6])tog")
_KINDS: Final = ("sc", "hdc", "dc", "tr")
_LOOPED: Final = ("loopst", "fur")


def definition(tokens: list[Token]) -> tuple[Token, str] | None:
    """A word that the pattern gives to a stitch: ``bo = bobble``, ``Bobble (bo): …``, ``pc - popcorn stitch``.

    Gives the word's token and the standard name of the stitch.
    """
    c = Cursor(tokens)
    first = c.look()
    if first is None or first.kind not in ("word", "stitch"):
        return None
    if c.mark("(", ahead=1) and c.kind("word", 2) and c.mark(")", ahead=3) and first.kind == "stitch":
        return tokens[2], first.value
    if c.mark("(", ahead=1) and c.kind("stitch", 2) and c.mark(")", ahead=3) and first.kind == "word":
        return first, tokens[2].value
    if first.kind != "word" or not (c.mark("=", ":", "-", ahead=1) and c.kind("stitch", 2)):
        return None
    after = tokens[3] if len(tokens) > 3 else None
    if after is None or after.word in (",", ".", ";", ":", "(", "=", "-"):
        return first, tokens[2].value
    return None
