"""Printed patterns, headlines: what a line says as a whole: a part's name and copies, a colour of its own, a value below its heading."""

from __future__ import annotations

import re
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.between.opening import founds
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.rounds.doings import by_hand
from tambour.crochet.printed.sheet.notes import MODES, Heading, heading, plain_name
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.yarns.colors import spare
from tambour.crochet.printed.yarns.shades import dyed, shade
from tambour.crochet.yarns import class_of, hook_of

_YARN: Final = re.compile(
    r"^(?![^\n]*\b(?:hooks?|needles?|eyes?)\b)[^\n]*\b(?:yarn|cotton|wool|acrylic|dk|worsted|aran|sport|fingering|bulky|chunky)\b",
    re.IGNORECASE,
)
"""A line of a list that is of yarn."""
_LITTLE: Final = re.compile(
    r"\b(?:embroider\w*|floss)\b|\bfor (?:the |his |her |its )?(?:face|cheeks?|nose|mouth|eyes?|smile|whiskers|details?|features)\b",
    re.IGNORECASE,
)
"""One of yarn that only details are made of: "Small amount of black worsted weight yarn for embroidery"."""


def below(p: State, row: Row, tokens: list[Token]) -> list[tuple[str, str, Span]]:
    """What a line states of gauge and size below a heading that says only which, and of the hook in a list of materials."""
    span = Span(row.tokens[0].start, row.tokens[-1].end)
    words = p.source.text.text[span.start : span.end]
    below, p.below = p.below, ""
    main = "yarn" not in p.stated and _YARN.search(words) is not None and _LITTLE.search(words) is None
    if p.mode == "materials" and not below and main and class_of(words):
        return [("yarn", words, span)]
    if p.mode != "materials" or not any(t.kind == "number" for t in tokens):
        return []
    if below:
        return [(below, words, span)]
    hook = next((t for t in tokens if t.kind == "key" and t.value == "hook" and "hook" not in p.stated), None)
    if hook is None:
        return []
    whole = p.source.text.text  # the one line that names it, of those that are read together
    begin = max(span.start, whole.rfind("\n", 0, hook.start) + 1)
    end = whole.find("\n", hook.start)
    span = Span(begin, span.end if end < 0 else min(span.end, end))
    words = whole[span.start : span.end].lstrip(" \t•*-–")
    return [("hook", words, span)] if hook_of(words) is not None else []


def headed(p: State, row: Row, tokens: list[Token]) -> int:
    """Where the colon stands behind the name of a part that a line begins with and goes on; 0 where it does not."""
    at = next((k for k, t in enumerate(tokens[:12]) if t.word == ":"), 0)
    if (
        not at
        or at + 1 >= len(tokens)
        or tokens[0].kind == "stitch"
        or tokens[0].value in (*MODES, "round", "row", "repeat")
    ):
        return 0
    if tokens[at + 1].word not in ("see", "fold") and not any(
        t.kind == "stitch" or (t.kind == "key" and t.value in ("ring", "make", "with", "begin", "as", "join"))
        for t in tokens[at + 1 :]
    ):
        return 0
    raw = [t for t in row.tokens if t.end <= tokens[at].end]
    line = Row(raw, row.start, raw[-1].end, row.marked)
    text, name = p.source.text.text, tokens[: at + 1]
    found = heading(text, line, name) or heading(text, line, [*bare(p, name[:-1]), name[-1]])  # "STRAP, red: ch 9"
    return at if found is not None and found.strong else 0


def trailing(p: State, row: Row, tokens: list[Token]) -> int:
    """Where the sentences of a line end that the heading of the next part stands behind: "Fasten off. Ties (make 2)"; 0 where none does."""
    line = p.source.text.text[row.tokens[0].start : row.tokens[-1].end]
    if "(" not in line or copied(p, row, line) is None:
        return 0
    bracket = max(k for k, t in enumerate(tokens) if t.word == "(") if any(t.word == "(" for t in tokens) else 0
    return next((k for k in range(bracket - 2, 1, -1) if tokens[k].word in (".", "!") and not tokens[k + 1].glued), 0)


def copied(p: State, row: Row, line: str) -> Heading | None:
    """A heading that says its copies as the table of terms does: ``Arm (make 2)``."""
    mark = line.rfind("(")
    said = p.phrases.read(line[mark:], ("copies",)) if mark > 0 else None
    name = plain_name(line[:mark].strip()) if said is not None else ""
    if said is None or not name:
        return None
    span = Span(row.tokens[0].start, row.tokens[-1].end)
    return Heading(name, span, max(1, said[1]["count"]), span, True, True)


_SMALL: Final = re.compile(r"[a-z]+(?: [a-z]+){0,2}")


def small(p: State, row: Row, line: str) -> Heading | None:
    """A heading in small letters that names a part, on a line of its own before what founds it or names its rounds: "hair", "left leg"."""
    if not _SMALL.fullmatch(line) or not kind_of(one(line.split()[-1])) or p.mode in ("materials", "abbreviations"):
        return None
    text = p.source.text.text
    before = text[: row.start].rstrip(" \t")
    after = text[row.end :].lstrip()
    ended = before.rstrip("\n*")[-1:] in (".", ")", "]", "") or before.endswith("\n\n")
    if not (ended or p.heading is not None):
        return None
    if not after[:1].isupper():
        return None
    return Heading(plain_name(line), Span(row.tokens[0].start, row.tokens[-1].end), 1, None, True, False)


def bare(p: State, tokens: list[Token]) -> list[Token]:
    """A heading without what it says of yarn and hook behind its name: "Head (cream)", "Ears (blue yarn, make 2)", "HEAD – Caramel,
    3.5 mm hook", "ARMS – make 2 – start with Caramel"."""
    made, at = list(tokens), 1
    while at < len(made):
        end = _aside(p, made, at + 1) if made[at].word in _PARTED else 0
        opened = made[at].word in ("(", "[")
        closed = end < len(made) and made[end].word in (")", "]")
        if not end or not (end == len(made) or made[end].word in _PARTED or closed or made[end].value == "make"):
            at += 1
            continue
        whole = opened and closed
        between = opened and end < len(made) and made[end].word in (",", ";")
        made = made[: at + (opened and not whole)] + made[end + (whole or between) :]
    return made


def dyed_only(p: State, tokens: list[Token]) -> RGB | None:
    """The yarn that words name which say nothing else, where a piece is under way or headed: "BLACK", "dark green", "Color A", "in white";
    None where they say more, or may name a piece."""
    idle = p.mode in ("materials", "abbreviations") or not (p.parts or p.heading is not None)
    apart = p.row_at > 0 and not p.rows[p.row_at - 1].tokens
    begins = tokens[0].value in ("with", "in") or (apart and len(tokens) <= _SHADE and tokens[-1].value == "yarn")
    if idle and not (begins and founds(p, near=1)):  # "In white", "Yellow yarn", right above the first round
        return None
    if (shown := _shown(tokens)) is not None:
        return dyed(shown) or p.palette.given.get(shown) or _ours(p, shown)
    some = [t for k, t in enumerate(tokens) if not _passes(tokens, k)]
    if not some or len(some) > _SHADE:
        return None
    asked = len(some) < len([t for t in tokens if t.kind != "mark"])
    found = p.palette.color(Cursor(some))
    if found is None and asked:
        hue = shade(" ".join(t.word for t in some))
        found = (hue, len(some)) if hue is not None else p.palette.letter(Cursor(some), 0) if len(some) == 1 else None
    if found is not None and len(some) > found[1] + 1 and some[found[1]].word == "or":
        some = some[: found[1]]  # "Using yellow or orange yarn": the first of them
    if found is None or found[1] != len(some):
        return None
    return found[0] if asked or p.heading is not None or not some[0].capital or _goes_on(p) else None


def _passes(tokens: list[Token], k: int) -> bool:
    """Whether a word around a yarn's name names none: "All in", "Crochet hook C in", a mark."""
    token, before = tokens[k], tokens[k - 1] if k else None
    if token.word in (".", ":", ",", "[", "]", "(", ")", "all", "attach", "swap"):
        return True
    if token.kind == "key":
        return token.value in (*_OF_YARN, "hook") or (
            token.value == "to" and k > 0 and before is not None and before.word == "swap"
        )
    return before is not None and before.value == "hook" and len(token.word) == 1


def _ours(p: State, name: str) -> RGB:
    """A colour of our choice for a yarn whose name tells none, which is told."""
    hue = p.palette.given[name] = spare(len(p.palette.told))
    p.palette.told.append(name)
    return hue


def _shown(tokens: list[Token]) -> str | None:
    """The shade that a brand's name and number stand before: "Change to Soft yarn #7684 (Porcelain)"; None for other words."""
    while tokens and tokens[-1].word in (".", ":", ","):
        tokens = tokens[:-1]
    opens = next((k for k, t in enumerate(tokens) if t.word == "("), 0)
    if not 0 < opens <= _BRAND or tokens[-1].word != ")" or not (tokens[0].kind == "key" and tokens[0].value in _ASKS):
        return None
    if any(t.kind == "stitch" or t.word in (",", ";", ".") for t in tokens):
        return None
    name, brand = tokens[opens + 1 : -1], tokens[1:opens]
    if not any(t.kind == "number" or t.value == "yarn" for t in brand) or any(t.kind != "word" for t in name):
        return None
    return " ".join(t.word for t in name) if 0 < len(name) <= _SHADE else None


_BRAND: Final = 8  # words before a shade's name: "Change to Soft yarn #7684"
_ASKS: Final = ("color", "with", "begin", "join", "in")


def _goes_on(p: State) -> bool:
    """Whether the next line begins a round that is not the first of a piece."""
    after = next((row for row in p.rows[p.row_at + 1 : p.row_at + 4] if row.tokens), None)
    found = p.vocabulary.heads(after.tokens) if after is not None else []
    return bool(found) and found[0][1].numbers[:1] > (1,)


_SHADE: Final = 3  # words that name a yarn
_PARTED: Final = frozenset(("(", "[", "-", ",", ";", ":", "|", "/"))
_OF_YARN: Final = frozenset(("with", "in", "begin", "color", "yarn", "join", "work", "and"))


def _aside(p: State, tokens: list[Token], at: int) -> int:
    """Where words from ``at`` end that only name yarns or a hook; 0 where they say anything else."""
    c, begin, named, told = Cursor(tokens, at), at, False, len(p.palette.told)
    while at < len(tokens):
        hue = p.palette.color(c, at) or (
            p.palette.letter(c, at) if tokens[at].word.isalpha() and named is False and at > begin else None
        )
        sized = tokens[at].kind == "number" and at + 1 < len(tokens) and tokens[at + 1].word == "mm"
        if hue is not None:
            at, named = at + hue[1], True
        elif sized:
            at, named = at + 2 + (at + 2 < len(tokens) and tokens[at + 2].value == "hook"), True
        elif (tokens[at].kind == "key" and tokens[at].value in _OF_YARN) or (
            named and tokens[at].word in ("then", "&", "+")
        ):
            at += 1
        else:
            break
    ends = named and (at == len(tokens) or tokens[at].word in (*_PARTED, ")", "]") or tokens[at].value == "make")
    del p.palette.told[told:]  # a letter is told where it is worked with
    return at if ends else 0


_TWINS: Final = frozenset(("half", "side", "panel", "piece", "square", "part", "layer"))


def named_color(p: State, tokens: list[Token]) -> bool:
    """``A = brown``, ``Color B: white``, ``Main color (MC): cream``; whether the line says such."""
    found = False
    for k in range(len(tokens) - 2):
        at = k + 1 + (tokens[k + 1].word == ")")
        if tokens[k].kind not in ("word", "key") or len(tokens[k].word) > 2 or at + 1 >= len(tokens):
            continue
        if k and tokens[k - 1].kind == "word" and tokens[k - 1].word in _TWINS:
            continue  # "Half B - green" heads a piece
        shade = p.palette.color(Cursor(tokens, at + 1)) if tokens[at].word in ("=", ":", "-") else None
        if shade is not None:
            p.palette.given.setdefault(tokens[k].word, shade[0])
            found = True
    return found


def dyed_first(p: State, tokens: list[Token]) -> int:
    """Where a sentence's first clause ends that only changes the yarn, before one that hands do: "Change color to white, fill the body"; 0 where
    it does not."""
    cut = next((k for k, t in enumerate(tokens[:6]) if t.word in (",", "then") or t.value == "and"), 0)
    if not cut or tokens[0].value != "color" or p.mode in ("materials", "abbreviations"):
        return 0
    rest = [t for t in tokens[cut + 1 :] if t.word not in ("then", "now") and t.value != "and"]
    hue = p.palette.color(Cursor(tokens, 1)) or p.palette.letter(Cursor(tokens, 1), 1)
    handed = bool(rest) and (rest[0].value in ("stuff", "eyes", "marker", "close") or by_hand(rest))
    return cut if handed and hue is not None and 1 + hue[1] == cut else 0


def dyed_lead(p: State, tokens: list[Token]) -> int:
    """Where the yarn ends that a part's first sentence begins with, "Oatmeal, starting at the nose", "Begin in black, at the crown", and that is put
    before its rounds; 0 where none does."""
    led = 2 if len(tokens) > 2 and tokens[0].value == "begin" and tokens[1].value in ("in", "with") else 0
    led = led or int(len(tokens) > 1 and tokens[0].value in ("in", "with") and p.heading is not None)
    hue = p.palette.color(Cursor(tokens, led)) if p.heading is not None and p.mode == "" else None
    end = led + hue[1] if hue is not None else len(tokens)
    if hue is None or len(tokens) < end + 2 or tokens[end].word != ",":
        return 0
    if (tokens[end + 1].value != "begin" or led == 1) and not (led and tokens[end + 1].word in ("at", "from")):
        return 0
    span = Span(tokens[led].start, tokens[end - 1].end)
    p.lead.append(Line((Action("color", span, numbers=hue[0]),), span, False))
    return end + 1


def dyed_last(p: State, tokens: list[Token]) -> int:
    """Where the clause begins that only changes the yarn, behind one that hands do: "Cut the yarn and change to white"; 0 where none does."""
    cut = next((k for k in range(len(tokens) - 1, 0, -1) if tokens[k].value == "color"), 0)
    if not cut or tokens[0].value == "color" or p.mode in ("materials", "abbreviations"):
        return 0
    first = tokens[:cut]
    while first and (first[-1].word in (",", "then", "and") or first[-1].value == "and"):
        first = first[:-1]
    hue = p.palette.color(Cursor(tokens, cut + 1)) if cut + 1 < len(tokens) else None
    if hue is None or cut + 1 + hue[1] != len(tokens) or len(first) == cut or not by_hand(first):
        return 0
    return cut if not any(t.kind in ("stitch", "number") for t in first) else 0
