"""Printed patterns, united: a round that goes on over two pieces ("1 sc in each sc around First Leg, ch 3, …"): two legs become one body."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import worked
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_RANKS: Final = {"first": 1, "second": 2, "third": 3, "left": 1, "right": 2, "other": 0, "last": 2, "one": 1}
_MOST: Final = 30  # chains between two pieces
_GOING: Final = frozenset("continue continuing work working start starting begin beginning now next go".split())
"""Words before the piece that the hook goes on from."""
_OVER: Final = frozenset("go over to move cross change continue across now and on".split())
"""Words that take the hook to the other piece."""
_TIES: Final = frozenset(("attach", "connect", "attaching", "connecting"))


@dataclass
class Run:
    """Stitches of one piece, or of the chain between: ``piece`` 0 for the one at the hook, 1 for the other, 2 for the chain."""

    piece: int
    tokens: list[Token] = field(default_factory=list)


def united(
    p: State, draft: Draft, tokens: list[Token], read: Callable[[list[Token], int], Body], span: Span
) -> Body | None:
    """The body of a round that goes over two pieces, which from there are one: the other piece is taken into ``draft`` before it. None where
    the words name no two pieces, or say of them what is not understood.

    read : the body of tokens on so many stitches
    """
    if sum(t.kind == "stitch" for t in tokens) < 2:
        return None
    tokens = _plainly(p, _led(p, draft, tokens))
    twins = _twins(p, draft, tokens)
    if twins is None:
        return None
    here, other, noun = twins
    if here.edge is None or other.edge is None:
        return None
    found = _runs(tokens, noun, lambda rank: _which(rank, here, other))
    body = round_over(p, draft, (here, other, noun), found, read, span) if found is not None else None
    if body is None and (plain := _usual(tokens, here.edge, other.edge)) is not None:
        body = round_over(p, draft, (here, other, noun), plain, read, span)
        if body is not None:
            body.stated, body.stated_span, body.fit = body.edge, span, 2
            around = f"around one, {plain[1]} along the chain, around the other and {plain[1]} along the chain again"
            p.source.doubt(
                f"how the two are joined is not understood word by word; {around} makes its count, {body.edge}, and is taken",
                "say what is worked around each: ch 3, 12 sc around the first leg, 3 sc along the chain, …",
                span,
            )
    return body


def _led(p: State, draft: Draft, tokens: list[Token]) -> list[Token]:
    """A round without where the hook goes in before its colon ("Hook into the 7th st of the first leg and go on from there: …"), with the chain
    that a sentence above it makes, where its own words only go along one."""
    colon = next((k for k, t in enumerate(tokens) if t.word == ":"), 0)
    lead = tokens[:colon]
    if any(_rank(t) is not None for t in lead) and not any(t.kind == "stitch" for t in lead):
        tokens = tokens[colon + 1 :]
    chains = any(
        (a.value == "ch" and b.kind == "number") or (a.kind == "number" and b.value == "ch")
        for a, b in pairwise(tokens)
    )
    if chains or not draft.lines or not any(t.value == "ch" for t in tokens) or not tokens:
        return tokens
    above = p.source.text.text[draft.lines[-1].span.end : tokens[0].start].lower()
    said = re.findall(r"\bch(?:ain)?\s*(\d{1,2})\b|\b(\d{1,2})\s*ch(?:ains?)?\b", above)
    if len(said) != 1:
        return tokens
    at = tokens[0].start
    many = int(said[0][0] or said[0][1])
    return [
        Token("stitch", "ch", at, at, "ch"),
        Token("number", str(many), at, at, many),
        Token("mark", ",", at, at),
        *tokens,
    ]


def _usual(tokens: list[Token], here: int, other: int) -> tuple[list[Run], int] | None:
    """The usual round over two pieces, where the words chain as many as its count asks for; None where these do not make the count that ends
    the words."""
    numbers = [t.value for t in tokens if t.kind == "number" and isinstance(t.value, int)]
    chained = [
        b.value if a.value == "ch" else a.value
        for a, b in pairwise(tokens)
        if "ch" in (a.value, b.value) and isinstance(b.value if a.value == "ch" else a.value, int)
    ]
    chain = chained[0] if chained else 0
    if not numbers or not 0 < chain <= _MOST or numbers[-1] != here + other + 2 * chain:
        return None
    return usual(tokens[0], here, other, chain)


def usual(place: Token, here: int, other: int, chain: int) -> tuple[list[Run], int]:
    """The usual round over two pieces: around one, along the chain, around the other, and along the chain again."""

    def run(piece: int, many: int) -> Run:
        sc = Token("stitch", "sc", place.start, place.start, "sc")
        number = Token("number", str(many), place.start, place.start, many)
        return Run(piece, [number, sc, Token("mark", ".", place.start, place.start)])

    return [run(1, other), run(2, chain), run(0, here), run(2, chain)], chain


def round_over(
    p: State,
    draft: Draft,
    twins: tuple[Draft, Draft, str],
    found: tuple[list[Run], int],
    read: Callable[[list[Token], int], Body],
    span: Span,
) -> Body | None:
    """The body of a round of these runs, the other piece taken into ``draft``; None where they do not go around both."""
    here, other, noun = twins
    runs, chain = found
    assert here.edge is not None and other.edge is not None
    left, bodies = [here.edge, other.edge, chain], []
    for run in runs:
        try:
            body = read(run.tokens, left[run.piece])
        except NotUnderstood:
            return None
        if body.left or body.moved is not None or body.refers is not None:
            return None
        body.items = _counted(p, body.items, left[run.piece])
        done = worked(body.items, left[run.piece], p.source.stitches)
        if done is None or not done[1]:
            return None
        left[run.piece] = left[run.piece] - done[1] if run.piece < 2 else chain
        bodies.append((run.piece, body, done[0]))
    said = next((b.stated for _, b, _ in reversed(bodies) if b.stated is not None), None)
    fits = said is None or said == sum(many for _, _, many in bodies) or said != here.edge + other.edge + 2 * chain
    if left[0] or left[1] or not fits:
        return None  # the usual way around makes the count, and these words do not
    items = _items(p, bodies, chain, noun, span)
    if items is None:
        return None
    _taken_in(p, draft, here, other, noun, span)
    made = sum(many for _, _, many in bodies)
    stated = next((b for _, b, _ in reversed(bodies) if b.stated is not None), None)
    doings = [d for _, b, _ in bodies for d in b.doings]
    whole = Body(items, doings=doings, edge=made, ends=bodies[-1][1].ends)
    if stated is not None:
        whole.stated, whole.stated_span = stated.stated, stated.stated_span
        whole.fit = 2 if stated.stated == made else 0
    return whole


def _plainly(p: State, tokens: list[Token]) -> list[Token]:
    """The words of a round with "leg 1" as "first leg", without remarks in brackets, and "from the second leg ch 3 and join to the first"
    as what is done there: "ch 3, join to the first"."""
    nouns = {one(w) for d in p.parts if d.begun() and not d.merged for w in re.findall(r"[^\W\d_]+", d.name.lower())}
    tokens = _opened(tokens)
    nouns_said = {t.word for k, t in enumerate(tokens) if k and _rank(tokens[k - 1]) is not None and t.kind == "word"}
    if len(nouns_said) == 1:  # "18 sc around the second petal, go over to the first one"
        noun = nouns_said.pop()
        tokens = [replace(t, kind="word", word=noun, value=noun) if t.word == "one" and k and _rank(tokens[k - 1]) is not None else t
                  for k, t in enumerate(tokens)]  # fmt: skip
    made: list[Token] = []
    at = 0
    while at < len(tokens):
        token, after = tokens[at], tokens[at + 1] if at + 1 < len(tokens) else None
        end = next((k for k in range(at, len(tokens)) if tokens[k].word == ")"), at) if token.word == "(" else at
        if end > at and not any(t.kind in ("stitch", "number") for t in tokens[at:end]):
            at = end + 1  # "(this is the first stitch)"
        elif token.kind == "word" and one(token.word) in nouns and after is not None and after.value in (1, 2):
            made += [replace(after, kind="ordinal"), token]
            at += 2
        elif (chained := _chained_from(tokens, at)) > at:
            while made and made[-1].word in _GOING:
                made.pop()
            at = chained
        elif token.word in _TIES and token.kind == "word":
            made.append(replace(token, kind="key", value="join"))
            at += 1
        else:
            joins = token.word == "and" and after is not None and after.value == "join" and made
            made.append(Token("mark", ",", token.start, token.start) if joins else token)
            at += 1
    colon = next((k for k, t in enumerate(made[:4]) if t.word == ":"), 0)
    return made[colon + 1 :] if colon and made[0].value == "join" else made  # "join legs: sc 12 along leg 1"


def _chained_from(tokens: list[Token], at: int) -> int:
    """Where the chain stands that is worked from a piece named at ``at``, "on the second leg: ch 4"; ``at`` where none is."""
    if tokens[at].word not in ("from", "on") or at + 3 >= len(tokens) or _rank(tokens[at + 1]) is None:
        return at
    end = at + 3 + (tokens[at + 3].word in (":", ","))
    return end if end < len(tokens) and tokens[end].value == "ch" else at


def _opened(tokens: list[Token]) -> list[Token]:
    """A round without the brackets around what is chained and joined before its colon: "On the second leg ch 4, join to the first leg: 14 sc …"."""
    end = next((k for k, t in enumerate(tokens) if t.word == ")"), 0) if tokens and tokens[0].word == "(" else 0
    inner = tokens[1:end]
    joins = any(t.value == "join" or t.word in _TIES for t in inner) and any(_rank(t) is not None for t in inner)
    if not joins or not any(t.value == "ch" for t in inner):
        return tokens
    comma = [Token("mark", ",", tokens[end].start, tokens[end].end)]
    return [*inner, *(comma if tokens[end + 1 : end + 2] != [] else []), *tokens[end + 1 :]]


def _counted_alone(rest: list[Token], chained: bool) -> list[Token]:
    """So many stitches along a piece or a chain ("3 sc along the other side of the chain") as their number alone."""
    counted = next((k for k in range(len(rest)) if rest[k].word in ("(", "[") and _count(rest, k)), len(rest))
    if len(rest) > 2 and rest[-2].word == "=" and rest[-1].kind == "number":
        counted = min(counted, len(rest) - 2)  # "4 sc along the chain = 36"
    rest, behind = rest[:counted], rest[counted:]
    numbers = [t for t in rest if t.kind == "number" and isinstance(t.value, int)]
    made = [t for t in rest if t.kind == "stitch" and t.value != "ch"]
    said = [t.value for t in rest]
    if len(numbers) == len(made) == 1 and "each" in said[said.index(made[0].value) : said.index(numbers[0].value)]:
        return [numbers[0], made[0], *behind]  # "sc in each of the 12 sts of the first lobe"
    into = not chained and any(t.kind == "key" and t.value in ("in", "each", "next") for t in rest)
    return [*([numbers[0], made[0]] if len(numbers) == len(made) == 1 and not into else rest), *behind]


def _twins(p: State, draft: Draft, tokens: list[Token]) -> tuple[Draft, Draft, str] | None:
    """The piece at the hook, the other one, and the noun of both."""
    named = [
        (k, one(t.word)) for k, t in enumerate(tokens) if k and _rank(tokens[k - 1]) is not None and t.kind == "word"
    ]
    if len({noun for _, noun in named}) != 1 or len({_rank(tokens[k - 1]) for k, _ in named}) < 2:
        return None
    noun = named[0][1]
    kin = [
        d
        for d in p.parts
        if d.begun() and not d.merged and noun in [one(w) for w in d.name.lower().replace("_", " ").split()]
    ]
    alone = kin == [draft] and draft.copies == 1 and not draft.other_end
    if (not kin or alone) and _made_twice(p, draft, noun, tokens[0].start):
        draft.twin = noun
        return draft, draft, noun
    if draft.begun() and draft not in kin:
        return None
    if len(kin) == 1 and kin[0].copies == 2:
        return kin[0], kin[0], noun
    if len(kin) != 2 or any(d.copies > 1 for d in kin):
        return None
    ranks = [_called(d) for d in kin]
    if None in ranks or ranks[0] == ranks[1]:
        return None
    here = draft if draft in kin else next(d for d in kin if _called(d) == (_rank(tokens[named[0][0] - 1]) or 2))
    return here, kin[1 - kin.index(here)], noun


def _made_twice(p: State, draft: Draft, noun: str, begin: int) -> bool:
    """Whether the part under way has been one of two so far, as its words up to ``begin`` say: "First make two flukes", "on the second petal do
    not cut"."""
    if not draft.begun() or draft.copies > 2 or draft.merged or p.heading is not None:
        return False
    said = p.source.text.text[draft.span.start : begin].lower()
    many = rf"(?:two|2|both)\s+(?:[a-z]+\s+)?{re.escape(noun)}(?:s|es)|(?:second|other)\s+(?:one|{re.escape(noun)}|the\s+same)"
    return re.search(rf"\b(?:{many})\b", said) is not None


def _called(draft: Draft) -> int | None:
    """Which of its kind a part is called: "FIRST LEG", "Leg 2", "Right leg"."""
    found = [_RANKS[w] for w in draft.name.lower().replace("_", " ").split() if w in _RANKS]
    return next(iter([*found, *(int(c) for c in draft.name if c.isdigit())]), None)


def _rank(token: Token) -> int | None:
    """Which of its kind a word says: "first", "2nd", "other"."""
    return token.value if token.kind == "ordinal" and isinstance(token.value, int) else _RANKS.get(token.word)


def _which(rank: int, here: Draft, other: Draft) -> int:
    """Whether the piece of that rank is the one at the hook (0) or the other (1)."""
    if here is other:
        return 0 if rank == 2 else 1
    return 0 if rank and rank == _called(here) else 1


def _runs(tokens: list[Token], noun: str, which: Callable[[int], int]) -> tuple[list[Run], int] | None:
    """The round as runs over one piece each, and the chains between the pieces; None where a clause names both."""
    starred = any(t.word in ("*", "(", "[") and not _count(tokens, k) for k, t in enumerate(tokens))
    ends = (".", ";") if starred else (".", ";", ",")
    clauses: list[list[Token]] = [[]]
    for token in tokens:
        if (token.kind == "mark" and token.word in ends) or token.word == "then":
            clauses.append([])
        else:
            clauses[-1].append(token)
    runs: list[Run] = []
    waiting: list[Token] = []  # what comes before the first piece is named
    chain = 0
    over: set[int] = set()
    moved = False  # the hook goes on around that one
    under = False  # "along the other side of the chain" was said before the stitches that are worked there
    for clause in clauses:
        at = [k for k in range(len(clause) - 1) if _rank(clause[k]) is not None and one(clause[k + 1].word) == noun]
        pieces = {which(_rank(clause[k]) or 0) for k in at}
        stitches = [t for t in clause if t.kind == "stitch"]
        if any(t.value == "count" for t in clause) and not pieces:
            continue  # "this sc counts as the first"
        if len(pieces) > 1:
            if stitches:
                return None
            continue  # "Hold first leg and second leg together"
        rest = [t for k, t in enumerate(clause) if k not in at and k - 1 not in at]
        if not stitches and rest and rest[0].value == "with" and rest[-1].value == "hook":
            continue  # "with the second leg still on your hook"
        if stitches and all(t.value == "ch" for t in stitches) and not pieces:
            many = next((t.value for t in rest if isinstance(t.value, int)), 0)
            if len(rest) <= 3 and rest[0].value == "ch" and (many > 1 or runs):
                if chain or many > _MOST:
                    return None
                chain = many
                continue
        if not rest:
            continue
        if chain and not pieces and len(rest) == 1 and rest[0].value == "side":
            under = True
            continue
        slipped = rest[0].value == "slst" and not any(t.kind == "number" for t in rest)
        if slipped and pieces and runs and pieces != {runs[-1].piece}:
            over = pieces  # "Sl st in first sc of First Leg": the yarn goes over to it
            continue
        if pieces and not stitches and runs and rest and all(t.word in _OVER for t in rest):
            over, moved = pieces, True  # "go over to the first petal"
            continue
        if over and not pieces and len(stitches) > 0 and (moved or any(t.value == "same" for t in rest)):
            pieces, rest = over, rest if moved else [stitches[0]]  # "1 sc in same sp as sl st" is its first stitch
        over, moved = set(), False
        joins = pieces and chain and rest[0].value == "join" and all(t.value == "slst" for t in stitches)
        if joins and not any(t.kind == "number" for t in rest):
            over = pieces  # "join to the first leg"
            continue
        if pieces and rest[0].value == "join" and stitches and stitches[-1].value != "slst":
            rest = [stitches[-1]]  # "join to first leg with a sc"
        spaces = (
            under
            or any(t.value == "ch" and k and rest[k - 1].value != "ch" for k, t in enumerate(rest) if k)
            or any(t.value in ("foundation", "side") for t in rest)
        )
        under = False
        rest = _counted_alone(rest, not pieces) if pieces or (spaces and chain) else rest
        stop = [Token("mark", ".", rest[-1].end, rest[-1].end)]
        if pieces or (spaces and chain and stitches):
            piece = pieces.pop() if pieces else 2
            if runs and runs[-1].piece == piece and piece < 2:
                runs[-1].tokens += [*rest, *stop]
            else:
                runs.append(Run(piece, [*waiting, *rest, *stop]))
                waiting = []
        elif runs:
            runs[-1].tokens += [*rest, *stop]
        else:
            waiting += [*rest, *stop]
    order = [run.piece for run in runs]
    if chain and order in (
        [1, 0, 2],
        [0, 1, 2],
    ):  # the chains are stitches of this round, and their other side is worked into
        side = runs[-1].tokens[:2]
        if [t.kind for t in side] in (["number", "stitch"], ["stitch", "number"]):
            runs.insert(1, Run(2, [*side, Token("mark", ".", side[-1].end, side[-1].end)]))
            order.insert(1, 2)
    fair = order in ([0, 1, 0], [0, 1], [1, 0]) if not chain else order in ([1, 2, 0, 2], [0, 2, 1, 2])
    return (runs, chain) if fair else None


def _count(tokens: list[Token], at: int) -> bool:
    """Whether the bracket at ``at`` holds no more than a number: a count."""
    end = next((k for k in range(at, len(tokens)) if tokens[k].word in (")", "]")), len(tokens))
    return end - at <= 3 and any(t.kind == "number" for t in tokens[at:end])


def _counted(p: State, items: list[Item], edge: int) -> list[Item]:
    """``items`` with a number of times in place of "around", on an edge of so many stitches."""
    made: list[Item] = []
    for item in items:
        if isinstance(item, Group) and item.times is None:
            before, once = worked(made, edge, p.source.stitches), worked(item.items, edge, p.source.stitches)
            if before is not None and once is not None and once[1]:
                item = replace(item, times=max(0, edge - before[1] - item.leaves) // once[1])
        made.append(item)
    return [i for i in made if not (isinstance(i, Action) and i.name == "join")]


def _items(p: State, bodies: list[tuple[int, Body, int]], chain: int, noun: str, span: Span) -> list[Item] | None:
    """What the hook does: it goes over to the other piece, around it, and on around its own."""
    order = [piece for piece, _, _ in bodies]
    other = next(b.items for piece, b, _ in bodies if piece == 1)
    lead = [i for i in bodies[0][1].items if isinstance(i, Action) and i.name in ("color", "flo", "blo")]
    clean = {
        id(b): [i for i in b.items if not (isinstance(i, Action) and i.name in ("ch", "color", "join", "turn"))]
        for _, b, _ in bodies
    }
    if chain:
        at = order.index(1)
        turned = [*bodies[at:], *bodies[:at]]
        return [
            *lead,
            Action("attach", span, numbers=(chain,), labels=(_label(p, noun, 1),)),
            *(i for _, b, _ in turned for i in clean[id(b)]),
        ]
    tied = _tied(p, clean[id(next(b for piece, b, _ in bodies if piece == 1))])
    if tied is None or not other:
        return None
    own = [clean[id(b)] for piece, b, _ in bodies if piece == 0]
    first, rest = (own[0], own[1]) if len(own) == 2 else ([], own[0])
    return [
        *lead,
        *first,
        Action("mark", span, labels=(_label(p, noun, 2),)),
        Action("attach", span, numbers=(0,), labels=(_label(p, noun, 1),)),
        *tied,
        Action("attach", span, numbers=(-1,), labels=(_label(p, noun, 2),)),
        *rest,
    ]


def _tied(p: State, items: list[Item]) -> list[Item] | None:
    """The stitches of the other piece, the first of them being the one that ties the yarn to it."""
    first = items[0] if items else None
    if isinstance(first, Group) and first.times:
        rest = [Group(first.items, first.times - 1, first.span)] if first.times > 1 else []
        return None if (inner := _tied(p, list(first.items))) is None else [*inner, *rest, *items[1:]]
    if not isinstance(first, Action) or first.name not in p.source.stitches:
        return None
    kind = p.source.stitches[first.name]
    more: list[Item] = [replace(first, times=first.times - 1)] if first.times > 1 else []
    if kind.takes != 1 or kind.makes not in (1, 2):
        return None
    tie: Item = Action("skip", first.span) if kind.makes == 1 else Action("sc", first.span)
    return [tie, *more, *items[1:]]


def _yarn_of(p: State, draft: Draft) -> Line | None:
    """The yarn that a part's heading names for its first rounds, which name none; None where there is no such."""
    first = next((i for n in draft.lines for i in n.items if isinstance(i, Action)), None)
    if first is None or first.name == "color":
        return None
    begin = next((n.span.start for n in draft.lines), draft.span.end)
    hue = p.palette.first(p.source.text.text[draft.span.start : max(begin, draft.span.end)])
    return None if hue is None else Line((Action("color", draft.span, numbers=hue),), draft.span, False)


def _label(p: State, noun: str, rank: int) -> str:
    """The mark on the first piece or the second."""
    return f"{noun}_{sum(d.merged for d in p.parts) + rank}"


def _taken_in(p: State, draft: Draft, here: Draft, other: Draft, noun: str, span: Span) -> None:
    """Puts the rounds of the other piece before those of ``draft``, which hold both from now on."""
    label = _label(p, noun, 1)  # before either of them counts as taken in
    lines = [replace(one, number=None) for line in other.lines for one in line.rounds()] if other is not here else []
    own = [one for line in here.lines for one in line.rounds()]
    lines = lines or [replace(one, number=None) for one in own]
    if other is here and here.other_end:
        own = [*(line for line in own if line not in here.end), *here.other_end]
    if draft is not here:
        draft.lines += own
        draft.last = here.last
        here.merged = True
    else:
        draft.lines = own
    mark = Line((Action("mark", span, labels=(label,)),), span, False)
    begun = (
        [_yarn_of(p, here)] if other is here else []
    )  # the second leg begins in the yarn of the heading as the first does
    draft.lines = [*lines, mark, *(line for line in begun if line is not None), *draft.lines]
    draft.marks = []
    if other is not here:
        other.merged = True
    draft.also = tuple(sorted({*draft.also, *(d.span for d in (here, other) if d is not draft)}, key=lambda s: s.start))
    draft.copies, draft.off, draft.chain, draft.ends = 1, None, None, ""
    draft.copies_span = None
    family = here.family or other.family
    draft.name = (
        family
        if family
        else draft.name
        if draft is not here or draft.twin or kind_of(one(noun)) not in ("", "leg", "foot")
        else f"{noun}s and body".upper()
        if here.name.isupper()
        else f"{noun.capitalize()}s and body"
    )
