"""Printed patterns, titled: a line that heads a part, in whatever words, as the part's name and its copies alone: ``Part 2 - now the body:``, ``3) Ears
x2 (pink)``, ``For the arms, use brown.``; what it says besides follows on lines of its own."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass, field, replace
from typing import Final

from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.parts.copied import copies_of, number_of
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.wordings.vocabulary import Vocabulary
from tambour.crochet.printed.yarns.shades import shade, spoken
from tambour.crochet.words.table import TERMS

_LONGEST: Final = 24  # tokens of a line that heads a part
_NAME: Final = 4  # words of a name
_SIDED: Final = 3  # words of "left and right"
_ASIDE: Final = 7  # words of a remark beside it
_NEAR: Final = 2  # lines from a heading to its first round
_NUMBER: Final = 40  # of a part
_LETTERS: Final = 3  # of a yarn's short name
_CLOSES: Final = {"(": ")", "[": "]", "{": "}", "<": ">", "«": "»", '"': '"', "'": "'", "„": '"', "‘": "’"}
_DOTS: Final = frozenset(("•", "·", "●", "∙", "→", "»", "…"))
_PARTS: Final = frozenset(
    (",", ":", "-", "–", ";", "|", "/", ".", "=", "~", "*", "**", "!", "--", "---", "...", *_DOTS)
)
"""Marks that part what a heading says."""
_ROMAN: Final = frozenset("i ii iii iv v vi vii viii ix x".split())
_JOINS: Final = frozenset(("and", "&", "+", "/", "-", "of", "'", "und", "et", "y", "en", "le", "la", "les", "the", "l"))
"""What may stand between the words of a name."""
_ARTICLES: Final = frozenset("the a der die das den le la les el los las de het".split())
_UNITS: Final = frozenset("mm cm m g oz inch inches ply".split())
_BUSY: Final = (
    "round",
    "row",
    "ring",
    "join",
    "repeat",
    "next",
    "around",
    "fasten off",
    "turn",
    "skip",
    "each",
    "close",
)
"""What no remark beside a name says, and a sentence may."""
_BEGUN: Final = ("from", "begin")
"""What says where a part begins: "BODY, from the bottom"."""


@dataclass
class _Piece:
    """What stands between two marks of a heading; ``bracketed``: in brackets; ``mark``: what stands before it."""

    tokens: list[Token] = field(default_factory=list)
    bracketed: bool = False
    mark: str = ""


@dataclass
class _Title:
    """What a heading says, while it is taken apart."""

    name: list[Token] = field(default_factory=list)
    copies: int = 0
    said: list[Token] = field(default_factory=list)  # what says the copies
    asides: list[list[Token]] = field(default_factory=list)
    framed: bool = False  # numbered or framed: it is a heading whatever it names
    led: bool = False  # words lead up to it
    dressed: bool = False  # it says more than a name and its copies as everybody writes them


class _Words:
    """The words of one language that stand in headings."""

    def __init__(self, vocabulary: Vocabulary) -> None:
        terms = TERMS[vocabulary.code]
        self.heard, self.read, self.heads = terms.heard, vocabulary.read, vocabulary.heads
        self.make = terms.words["make"][0]
        self.makes = frozenset((*terms.words["make"], *self.heard.words.get("make", ())))
        self.numbering = frozenset((*self.heard.labels, *self.heard.steps, *self.heard.items))
        self.articles = frozenset(t for t in self.heard.leads if len(t) <= 3) & _ARTICLES
        self.hues = spoken(terms.code)
        self.noun = 0 if terms.base in ("fr", "es") else -1
        """Which word of a name says what it is: "patte avant", "front leg"."""


def titled(rows: list[Row], vocabulary: Vocabulary) -> list[Row]:
    """``rows`` with the headings that stand over first rounds put plainly; what stands over the whole text may be more than a heading."""
    words = _Words(vocabulary)
    rows = [_onward(row) for row in rows]
    rows = [part for row in rows for part in _founded(row, words)]
    made: list[Row] = []
    top = next((k for k, row in enumerate(rows) if row.tokens), 0)
    founded: dict[int, bool] = {}
    for k, row in enumerate(rows):
        short = 0 < len(row.tokens) <= _LONGEST
        title = _title(row.tokens, words) if short and any(_near(rows, k, words, founded)) else None
        above = next((line.tokens for line in reversed(rows[max(0, k - 3) : k]) if line.tokens), [])
        if (
            title is None
            or not title.dressed
            or not any(_near(rows, k, words, founded)[: None if _known(title.name) else 1])
            or (title.led and _stands(above, words))
            or (k == top and not all(_hue(aside, words) for aside in title.asides))  # "Slipper sole (US terms)"
        ):
            made.append(row)
            continue
        made.append(Row([*title.name, *_made(title, words)], row.start, row.end, max(row.marked, 1)))
        made += [Row(_yarn(aside, words), aside[0].start, aside[-1].end) for aside in title.asides]
    return made


_ONWARD: Final = re.compile(
    r"(?:[,:(-] (?:no cutting|without (?:cutting|cut)(?: the (?:yarn|thread))?|(?:just )?(?:go|going|carry) on|continu(?:e|ed|ing|ation)|"
    r"(?:do not|don't) cut(?: (?:it|the (?:yarn|thread)))?|in one piece) ?[)]? ?)+"
)


def _onward(row: Row) -> Row:
    """The heading of what a piece goes on with as its name alone: "HEAD, no cutting, go on"."""
    tokens = row.tokens
    end = next((k for k, t in enumerate(tokens[: _NAME + 1]) if t.kind != "word"), 0)
    if not end or not tokens[0].capital or not kind_of(one(tokens[end - 1].word)):
        return row
    goes_on = _ONWARD.fullmatch(" ".join(t.word for t in tokens[end:]))
    return row if goes_on is None else replace(row, tokens=tokens[:end])


def _founded(row: Row, words: _Words) -> list[Row]:
    """A heading with its copies or its yarn and the chain behind it on lines of their own: "PAWS (make 2), start with red. Ch 5, begin in second ch."."""
    tokens = row.tokens
    ends = [k for k, t in enumerate(tokens[:_LONGEST]) if t.word == "." and k]
    at = next((k for k in ends if [t.word for t in tokens[k + 1 : k + 2]] in (["ch"], ["chain"])), 0)
    if not at or not tokens[0].capital or not _known(tokens[:at]):
        return [row]
    behind = words.read(tokens[at + 1 :])[:2]
    chains = [t.kind for t in behind] == ["stitch", "number"] and behind[0].value == "ch"
    title = _title(tokens[:at], words) if chains else None
    if (
        title is None
        or not title.dressed
        or title.led
        or not (title.copies or any(_hue(a, words) for a in title.asides))
    ):
        return [row]
    rest = tokens[at + 1 :]
    head = Row([*title.name, *_made(title, words)], row.start, tokens[at].end, max(row.marked, 1))
    asides = [Row(_yarn(aside, words), aside[0].start, aside[-1].end) for aside in title.asides if _hue(aside, words)]
    return [head, *asides, Row(rest, rest[0].start, row.end)]


def _stands(above: list[Token], words: _Words) -> bool:
    """Whether the line above is a heading already: what leads on to a part below it tells how that begins, "Start with orange, top of the head"."""
    title = _title(above, words) if 0 < len(above) <= _LONGEST else None
    return title is not None and not words.heads(above)


def _yarn(aside: list[Token], words: _Words) -> list[Token]:
    """What a heading says besides name and copies, as a line of its own: yarn behind "with", the size of a hook behind its name."""
    place, rest = aside[0].start, _hue(aside, words)
    if rest:
        return [Token("word", words.heard.using[0], place, place, capital=True), *rest]
    hook = next((t for t in words.read(aside) if t.value == "hook"), None)
    if hook is not None and hook.end == aside[-1].end:
        return [
            replace(hook, kind="word"),
            Token("mark", ":", place, place),
            *(t for t in aside if t.start < hook.start),
        ]
    return aside


def _hue(aside: list[Token], words: _Words) -> list[Token]:
    """The words that name a yarn alone, behind those that lead up to it: "in brown yarn", "Color: A", "MC"; none where they say another thing."""
    at = 0
    while at < len(aside) - 1 and (
        aside[at].word in words.heard.using
        or aside[at].word in words.heard.leads
        or aside[at].word in (":", "=")
        or any(t.value in ("yarn", "color", "begin") for t in words.read(aside[at : at + 1]))
    ):
        at += 1
    rest = aside[at:]
    plain = [t for t in rest if t.kind == "word" and not any(w.value == "yarn" for w in words.read([t]))]
    if not plain or len(plain) > _LETTERS or any(t.kind == "mark" and t.word != "-" for t in rest):
        return []
    letter = plain[0].capital or plain[0].word in ("mc", "cc")  # "main color" is put so
    lettered = len(plain) == 1 and letter and len(plain[0].word) <= _LETTERS and len(rest) <= 2
    said = " ".join(t.word for t in plain)
    return (
        rest if lettered or shade(said) is not None or said in words.hues or shade(plain[-1].word) is not None else []
    )


def _made(title: _Title, words: _Words) -> Iterable[Token]:
    """The copies as "(make 2)", where the words stand that say them."""
    if not title.copies:
        return ()
    begin, end = title.said[0].start, title.said[-1].end
    return (
        Token("mark", "(", begin, begin),
        Token("word", words.make, begin, begin),
        Token("number", str(title.copies), begin, end, title.copies),
        Token("mark", ")", end, end),
    )


def _near(rows: list[Row], k: int, words: _Words, founded: dict[int, bool]) -> list[bool]:
    """Of the next lines below line ``k``, whether a first round begins in them; ``founded`` : of those that are known."""
    near = [n for n in range(k + 1, min(k + 8, len(rows))) if rows[n].tokens][:_NEAR]
    for n in near:
        if n not in founded:
            said = words.read(rows[n].tokens)
            ring = any(t.value == "ring" for t in said)
            founded[n] = ring or any(head.numbers[:1] == (1,) for _, head in words.heads(rows[n].tokens))
    return [founded[n] for n in near]


def _title(tokens: list[Token], words: _Words) -> _Title | None:
    """What a line says as a heading; None where it can be none."""
    begun = next((t for t in tokens if t.kind == "word"), None)
    if begun is None:
        return None
    small = not (begun.capital or begun.start > tokens[0].start)
    left, framed = _unframed(tokens)
    at = _numbered(left, words)
    made = _Title(framed=framed or at > 0, dressed=at > 0 or len(left) < len(tokens))
    pieces = _pieces(left[at:])
    first = next((k for k, piece in enumerate(pieces) if _known(piece.tokens) and not (k and piece.bracketed)), 0)
    for k, piece in enumerate(pieces):
        if k == first:
            read = _names(made, piece.tokens, words)
        else:
            read = _leads(made, piece.tokens, words) if k < first else _counts(made, piece, words)
        if not read:
            return None
    if small and (made.led or not _known(made.name) or not all(_hue(aside, words) for aside in made.asides)):
        return None  # "ears (cream)" in small letters heads a part, "stuff the ears" does not
    return made if made.name and _plain(made, words) else None


def _leads(made: _Title, tokens: list[Token], words: _Words) -> bool:
    """Takes what stands before the piece with the name: words that lead up to it, or a yarn."""
    made.dressed = made.led = True
    if all(t.word in words.heard.leads or t.kind == "ordinal" or t.word in words.heard.ordinals for t in tokens):
        return True
    made.asides.append(tokens)
    own = len(tokens) == 1 and len(tokens[0].word) == _LETTERS  # "PUP – wings"
    return not own and bool(_hue(tokens, words))


def _counts(made: _Title, piece: _Piece, words: _Words) -> bool:
    """Takes what stands behind a name: copies, a number among the parts, a yarn, a remark; False where it may be more."""
    made.dressed = True
    said, name = piece.tokens, _spelt(made.name)
    if _numbers(said, words):
        return True
    if any(t.word != "all" and (t.value == "each" or t.word == "per") for t in words.read(said)):
        return False  # "make 2 each with A, B and C"
    if said[0].word in words.makes and one(said[-1].word) in name and any(t.word in words.heard.ordinals for t in said):
        return True  # "TAIL FLUKES - make the first fluke:"
    using = next((k for k, t in enumerate(said) if k and t.word in words.heard.using), 0)
    if using and _known(said[:using]) and _hue(said[using:], words):
        said = said[using:]  # "LEGS, 2x, foot in beige"
    if _known(said) and not _hue(said, words):
        if made.copies > 1 and piece.mark in (",", "+", "&"):
            return True  # "Legs (2), Body and Head": what the second goes on with
        if not piece.bracketed and piece.mark not in _DOTS and words.read(said)[0].value not in _BEGUN:
            return False  # "SNOUT, HEAD & TAIL" is one part
    many = copies_of(said, words.heard, name) or (
        number_of(said[0], words.heard) if len(said) == 1 and piece.mark != "/" else 0
    )
    if many:
        made.copies, made.said = many, [*made.said, *said]
        return True
    yarn = _copied(made, said, name, words)
    parting = sum(t.word in (",", "&", "+") or t.value == "and" for t in words.read(yarn))
    if yarn and parting and parting + 1 == made.copies:
        return False  # "make 2 in pink and purple": one of each
    if yarn:
        said = yarn
    elif any(number_of(t, words.heard) > 1 for t in said if t.kind == "number") and not any(
        t.value == "hook" for t in words.read(said)
    ):
        return False  # "make 6: 2 each with A, B and C"
    if said[0].word == "always" and made.asides and any(t.value == "turn" for t in words.read(said)):
        made.asides[-1] = [*made.asides[-1], *said]  # "in rows, always ch 1 and turn"
        return True
    flat = [t.value for t in words.read(said)] in (["in", "row"], ["in", "round"], ["around"])  # "Wings (x2), in rows"
    aside = piece.bracketed or piece.mark in _DOTS or flat
    if any(t.kind == "stitch" or (t.kind == "key" and t.value in _BUSY and not aside) for t in words.read(said)):
        return False
    if piece.bracketed and made.asides and all(any(t.word == "for" for t in some) for some in (made.asides[-1], said)):
        made.asides[-1] = [
            *made.asides[-1],
            *said,
        ]  # "A for Kitty, B for Puppy": one list, of which no yarn heads a part
        return True
    if piece.mark == "," and made.asides and not _hue(said, words) and not _hue(made.asides[-1], words):
        made.asides[-1] = [*made.asides[-1], *said]  # "worked flat, in rows"
    else:
        made.asides.append(said)
    return bool(_hue(said, words)) or (
        len(said) <= _ASIDE
        and piece.mark not in (".", "/", "|")
        and (piece.bracketed or len(said) > 1 or piece.mark in _DOTS)
    )


def _copied(made: _Title, said: list[Token], name: frozenset[str], words: _Words) -> list[Token]:
    """Takes the copies before a yarn, "2x in dark brown": the yarn's words; none where it is not said so."""
    ahead = next((k for k in range(len(said) - 1, 0, -1) if copies_of(said[:k], words.heard, name)), 0)
    if not ahead or made.copies or not _hue(said[ahead:], words) or any(t.kind == "number" for t in said[ahead:]):
        return []
    made.copies, made.said = copies_of(said[:ahead], words.heard, name), said[:ahead]
    return said[ahead:]


def _spelt(name: list[Token]) -> frozenset[str]:
    return frozenset(word for t in name for word in (t.word, one(t.word)))


def _known(name: list[Token]) -> bool:
    return any(kind_of(one(t.word)) for t in name)


def _unframed(tokens: list[Token]) -> tuple[list[Token], bool]:
    """``tokens`` without what stands around them, rules, pictures, quotes, brackets around the name or the whole; and whether such stands before them."""
    left = list(tokens)
    while left and left[0].kind == "mark" and left[0].word != "#":
        closes = _CLOSES.get(left[0].word)
        left = left[1:]
        if closes is not None:
            end = _closing(left, closes)
            left = left[:end] + left[end + 1 :]
    framed = left[:1] != tokens[:1]
    while (
        left
        and left[-1].kind == "mark"
        and not (left[-1].word in _CLOSES.values() and any(_CLOSES.get(t.word) == left[-1].word for t in left[:-1]))
    ):
        left = left[:-1]
    return left, framed


def _closing(tokens: list[Token], closes: str) -> int:
    """Where a bracket closes that was opened before ``tokens``; behind them where it does not."""
    depth = 0
    opens = next((o for o, c in _CLOSES.items() if c == closes), "")
    for k, token in enumerate(tokens):
        if token.word == closes and not depth:
            return k
        depth += (token.word == opens != closes) - (token.word == closes)
    return len(tokens)


def _numbered(tokens: list[Token], words: _Words) -> int:
    """Where the words begin behind what numbers a part: "2.", "B)", "Part Two -", "Step 3:", "1/3", "12:05"."""
    at = 0
    labelled = bool(tokens) and (tokens[0].word in words.numbering or tokens[0].word == "#")
    if labelled:
        at = 1
        while at < len(tokens) and tokens[at].word in (".", "#"):
            at += 1
    if at >= len(tokens) - 1:
        return 0
    token, after = tokens[at], tokens[at + 1]
    letter = token.kind == "word" and (len(token.word) == 1 or token.word in _ROMAN) and token.capital
    counted = token.kind == "number" and (not isinstance(token.value, int) or token.value <= _NUMBER)
    if not (letter or counted or (labelled and number_of(token, words.heard))):
        return 0
    parted = after.kind == "mark" and after.word not in (*_CLOSES, "x", "&", "+")
    single = (
        counted
        and after.kind == "word"
        and (one(after.word) == after.word or token.word[0] == "0")
        and after.word not in (*words.heard.copied, *_UNITS)
    )
    if not (labelled or parted or single) or (letter and not labelled and after.word == "/"):
        return 0
    at += 1
    while at + 1 < len(tokens) and tokens[at].word in ("/", ":") and tokens[at + 1].kind == "number":
        at += 2
    while at < len(tokens) and tokens[at].kind == "mark" and tokens[at].word in (*_PARTS, ")"):
        at += 1
    return at


def _pieces(tokens: list[Token]) -> list[_Piece]:
    """What a heading says, one piece after the other: what stands between its marks, and in its brackets."""
    made = [_Piece()]
    inside = ""
    for k, token in enumerate(tokens):
        within = 0 < k < len(tokens) - 1 and token.glued and tokens[k + 1].glued and token.word in ("-", "/", ".", "'")
        if token.word == inside:
            made, inside = [*made, _Piece()], ""
        elif not inside and token.word in _CLOSES:
            made, inside = [*made, _Piece(bracketed=True)], _CLOSES[token.word]
        elif token.word in (",", ";") or (not inside and token.word in _PARTS and not within):
            mark = made[-1].mark if token.word == "," and made[-1].mark in _DOTS else token.word
            made.append(_Piece(bracketed=bool(inside), mark=mark))
        else:
            made[-1].tokens.append(token)
    return [piece for piece in made if piece.tokens]


def _names(made: _Title, tokens: list[Token], words: _Words) -> bool:
    """Takes the part's name out of a piece of its heading, with the words before and behind it that say copies or yarn."""
    heard, at = words.heard, 0
    while at < len(tokens) and (
        tokens[at].word in heard.leads or tokens[at].word in ("x", *heard.pairs) or _many(tokens[at], words) > 1
    ):
        at += 1
    while at and (tokens[at - 1].word in heard.ordinals or tokens[at - 1].word == "last"):
        at -= 1  # "First leg" is not any leg
    towards = next((k for k in range(at, len(tokens)) if tokens[k].word in heard.towards), 0)
    if towards and tokens[0].word in heard.using and _hue(tokens[:towards], words):  # "Use brown yarn for the head"
        made.asides.append(tokens[:towards])
        made.dressed = made.led = True
        return _names(made, tokens[towards + 1 :], words)
    end = next((k for k in range(at, len(tokens)) if _behind(tokens[k], words)), len(tokens))
    name, rest = tokens[at:end], tokens[end:]
    while len(name) > 1 and name[-1].word in heard.trails and kind_of(one(name[-2].word)) != "eye":
        name = name[:-1]
    if len(name) > _SIDED and copies_of(name[:-1], heard) > 1:  # "LEFT AND RIGHT EAR"
        made.copies, made.said, name = copies_of(name[:-1], heard), name[:-1], name[-1:]
    made.led = made.led or at > 0
    made.dressed = made.dressed or at > 0 or len(name) < len(tokens)
    made.name = name
    if said := [t for t in tokens[:at] if _many(t, words) > 1 or t.word in heard.pairs]:
        made.copies, made.said = max(_many(t, words) or 2 for t in said), said
    if not rest:
        return True
    if many := copies_of(rest, heard, _spelt(name)):
        made.copies, made.said = many, rest
        return True
    rest = _copied(made, rest, _spelt(name), words) or rest
    made.asides.append(rest)
    return bool(_hue(rest, words))  # "Leg 2" is one of several, "Head with trunk" one thing


def _many(token: Token, words: _Words) -> int:
    """The number that a word is, "2", "two", "x2", "2x"; 0 for another."""
    return copies_of([token], words.heard) or number_of(token, words.heard)


def _behind(token: Token, words: _Words) -> bool:
    """Whether a word is none of the name before it."""
    return (
        token.word in words.heard.using
        or token.word in ("x", "#")
        or token.word in words.makes
        or _many(token, words) > 0
    )


def _numbers(said: list[Token], words: _Words) -> bool:
    """Whether a piece of a heading only says which of the parts it heads, or leads on: "part 2", "2/3", "begin", "see photo 3"."""
    small = (*words.heard.trails, *words.numbering)
    begins = said[0].word in small or any(t.word == "/" for t in said)
    return begins and all(t.word in small or t.word in ("of", "/", ".") or number_of(t, words.heard) for t in said)


def _plain(made: _Title, words: _Words) -> bool:
    """Whether the name that was found can be one."""
    name = made.name
    if (
        len(name) > _NAME
        or not all(t.kind in ("word", "ordinal") or t.word in _JOINS for t in name)
        or name[0].word in _UNITS
    ):
        return False
    if any(t.word in words.articles and name[k - 1].word not in _JOINS for k, t in enumerate(name) if k):
        return False  # "top the head"
    read = words.read(name)
    shaped = len(read) > 1 and read[0].word == "round" and (made.framed or made.copies > 1)  # "5. ROUND WINDOW (2 pcs)"
    if any(
        t.kind == "stitch" or (t.kind == "key" and t.value not in ("and", "eyes", "side", "other", "face"))
        for t in read[shaped:]
    ):
        return False
    if kind_of(one(name[words.noun].word)):
        return True
    dyed = all(_hue(aside, words) for aside in made.asides)
    return made.framed and not made.led and dyed and name[0].capital and not _known(name[:-1])
