"""Printed patterns, courses: clauses that say where the work goes on: joined, along an edge, through both layers, round the other side."""

from __future__ import annotations

from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.rounds.counts import makes
from tambour.crochet.printed.rounds.motifs import spaced
from tambour.crochet.printed.rounds.moved import Moved, moved
from tambour.crochet.printed.rounds.reader import Reader
from tambour.crochet.printed.tokens import Token
from tambour.crochet.printed.yarns.colors import LETTERS

_ALONG: Final = frozenset(
    ("behind", "along", "from", "using", "across", "through", "down", "inside", "into", "right", "left")
)
_CLOSES: Final = frozenset(("close", "closed", "shut", "across"))
_STANDING: Final = frozenset(("a", "an", "one", "1", "standing", "starting", "initial", "beg", "beginning", "-"))
_HAVING: Final = frozenset(("having", "increasing", "decreasing", "easing", "spacing", "keeping"))
FLATTENED: Final = frozenset(("flatten", "flattening", "fold", "folding", "pinch", "press"))
PIECES: Final = frozenset(
    ("pieces", "halves", "both pieces", "front", "inner", "outer", "sleeve", "cuff", "motifs", "first", "second")
)
"""Words for what is held together."""
"""Words for what is held together."""


_HELD: Final = frozenset(
    (
        "attached",
        "matching",
        "facing",
        "together",
        "tog",
        "aligned",
        "tail",
        "held",
        "remaining",
        "outside",
        "outwards",
        "top",
    )
)


class Courses(Reader):
    """Reads these clauses."""

    def along(self, found: list[Item]) -> bool:
        """Words that say along which edge stitches go that were just read ("8 sc evenly up right side of Ear"), or that come before
        them ("behind petals, into free loops of Rnd 1"); whether the clause at the cursor is such."""
        c, begin = self.c, self.c.at
        first = c.tokens[begin]
        if self.edging and first.word in _HAVING:
            self.to_separator()  # "sc evenly around, having 3 sc in each corner"
            return True
        led_by = first.word in _ALONG
        self.to_separator()
        clause = c.tokens[begin : c.at]
        if self.edge is not None and found and any(t.value == "thicknesses" for t in clause):
            self.folded(found, Action("fold", first.span))  # "sc 4 across the top through both layers"
            return True
        found_at = moved(clause)
        before = c.tokens[begin - 1] if begin else None
        tail = before is not None and (
            before.kind == "stitch" or before.value in ("around", "in", "next", "each", "stitch", "over")
        )
        fits = found_at is not None or (tail and first.capital)
        if (
            not fits
            or not clause
            or not (led_by or (tail and found))
            or any(t.kind == "stitch" and t.value != "ch" for t in clause[1:])
        ):
            c.at = begin
            return False
        if any(map(makes, found)):
            self.edging = True
        if self.body.moved is None:
            self.body.moved = found_at or Moved(Span(clause[0].start, clause[-1].end))
        return True

    def elsewhere(self, found: list[Item]) -> bool:
        """Goes past "in unused loops of rnd before last", said before stitches; whether that stands at the cursor."""
        c, begin = self.c, self.c.at
        self.to_separator()
        clause = c.tokens[begin : c.at]
        place = moved(clause) if c.look() is not None else None
        plain = any(t.kind == "stitch" and t.value != "ch" for t in clause) or any(
            t.kind == "key" and t.value == "side" for t in clause
        )
        if (
            place is None
            or plain
            or not (place.number or place.before or place.free or c.tokens[begin - 1].word in ("along", "across"))
        ):
            c.at = begin
            return False
        self.body.moved = self.body.moved or place
        if place.loops:
            found.append(Action(place.loops, place.span))
        return True

    def held(self) -> bool:
        """Whether the clause at the cursor only says how pieces are held: "With yarn still attached to base", "with sts matching"."""
        c, ahead, said = self.c, 1, False
        first, how = c.look(1), c.look(2)
        dyed = first is not None and (first.word in LETTERS or self.palette.color(c, c.at + 1) is not None)
        if dyed and how is not None and how.word == "held":
            return False  # "With B held together": a yarn, and two strands of it
        while (token := c.look(ahead)) is not None and not (token.kind == "mark" and token.word in ",.;:(["):
            if token.kind in ("stitch", "number"):
                return False
            said = said or token.word in _HELD
            ahead += 1
        return said

    def yarn_ahead(self) -> bool:
        """Whether the clause at the cursor brings in yarn: "Attach A in …", "draw up a loop of B"."""
        c = self.c
        ahead = 1
        while c.look(ahead) is not None and c.look(ahead).word in ("loop", "up", "new"):  # type: ignore[union-attr]
            ahead += 1
        return (
            self.palette.letter(c, c.at + ahead) is not None
            or self.palette.color(c, c.at + ahead) is not None
            or c.key("yarn", ahead=ahead)
            or c.key("next", ahead=ahead)
        )

    def folding(self, found: list[Item], token: Token) -> None:
        """Stitches go through both layers of the edge, which lies flat: they close it."""
        round_all = any(t.word == "around" for t in self.c.tokens[self.c.at :])  # what is folded flat is worked across
        if self.edge is None or round_all or any(self._piece(k) for k in range(len(self.c.tokens))):
            self.body.both = True
            self.to_separator()
            return
        self.folded(found, Action("fold", token.span))
        while self.c.look() is not None and not self.c.mark(",", ".", ";") and not self.c.kind("stitch"):
            self.c.at += 1

    @staticmethod
    def folded(found: list[Item], fold: Action) -> None:
        """Puts a fold into what is done, once: before the stitches that it is said behind, "sc 4 through both layers"."""
        if not any(isinstance(i, Action) and i.name == "fold" for i in found):
            last = found[-1] if found else None
            found.insert(len(found) - (isinstance(last, Action) and makes(last)), fold)

    def closed_flat(self, found: list[Item], token: Token) -> bool:
        """Whether the sentence at the cursor folds the edge and closes it with so many stitches: "Press flat and work 7 sc through both sides
        to close"; it is read then."""
        c = self.c
        end = next((k for k in range(c.at, len(c.tokens)) if c.mark(".", ";", "(", "[", ahead=k - c.at)), len(c.tokens))
        some = c.tokens[c.at : end]
        closes = any(t.value == "thicknesses" or t.word in _CLOSES for t in some)
        if self.edge is None or not closes or any(t.word == "around" or t.word in PIECES for t in some):
            return False
        for k in range(c.at, end):
            if c.tokens[k].kind != "stitch" or c.tokens[k].value not in ("sc", "slst", "hdc"):
                continue
            for many in (c.tokens[k - 1], *c.tokens[k + 1 : k + 2]):
                if many.kind == "number" and isinstance(many.value, int):
                    self.folded(found, Action("fold", token.span))
                    found.append(Action(str(c.tokens[k].value), c.tokens[k].span, many.value, many.span))
                    c.at = end
                    return True
        return False

    def _piece(self, at: int) -> bool:
        """Whether the word at ``at`` is one for a piece that is held; "first st" is none."""
        after = self.c.tokens[at + 1] if at + 1 < len(self.c.tokens) else None
        counts = after is not None and (after.kind in ("stitch", "number") or after.value in ("stitch", "space"))
        return self.c.tokens[at].word in PIECES and not (self.c.tokens[at].kind == "ordinal" or counts)

    def side_ahead(self) -> bool:
        """Whether the clause at the cursor speaks of the other side: "turn to work along opposite side of chain"."""
        ahead = 0
        while self.c.look(ahead) is not None and not self.c.mark(",", ".", ";", "(", "[", ahead=ahead):
            if self.c.key("side", ahead=ahead):
                return True
            ahead += 1
        return False

    def other_side(self, found: list[Item]) -> None:
        """The work goes on along the other side of the foundation chain."""
        first = self.c.look()
        if first is not None and first.word.startswith("back") and not any(map(makes, found)):
            self.to_separator()  # "Working in back loops of foundation ch, sc in 2nd ch from hook"
            return
        self.body.sides, self.body.turned = True, len(found)
        while (token := self.c.look()) is not None and not self.c.mark(",", ".", ";", ":", "(", "[", "-"):
            after, before = self.c.look(1), self.c.look(-1)
            behind = before is not None and (before.value in ("side", "ch") or before.word in ("chain", "side"))
            works = token.kind == "stitch" and token.value != "ch" and behind
            if works or (
                token.kind == "number" and after is not None and after.kind == "stitch" and after.value != "ch"
            ):
                return  # "on the other side of the chain 3 sc"
            self.c.at += 1

    def joining(self, found: list[Item], token: Token) -> None:
        """``join``, ``join with sl st in first sc``, ``join B with sl st``; without stitches before it, yarn that is joined."""
        c, said = self.c, self.c.at
        by = next((k for k in range(14) if c.look(k) is not None and c.look(k).word == "by"), None)  # type: ignore[union-attr]
        if by is not None and not any(c.mark(".", ";", ahead=k) for k in range(by)) and c.kind("stitch", by + 1):
            c.at += by + 1  # "join Top and Stem by working a sc through each st"
            self.body.both = True
            return
        if c.whole() is not None and (strands := c.look(1)) is not None and strands.word in ("strands", "strand"):
            c.at += 2  # "Join 2 strands of MC"
        goes_on = (
            c.key("with") and bool(found) and _lifts(found)
        )  # "Break A. Join with B": joined as all its rounds are
        c.skip_key("with", "color", "yarn")
        if c.key("next") and c.look(1) is not None and c.look(1).word in ("color", "colour"):  # type: ignore[union-attr]
            c.at += 2
        if c.whole() is not None and c.look(-1) is not None and c.look(-1).word in ("color", "colour"):  # type: ignore[union-attr]
            c.at -= 1  # "Join Color 1"
            c.tokens[c.at] = Token("word", "color", c.tokens[c.at].start, c.tokens[c.at].end)
        shade = self.palette.color(c) or self.palette.letter(c, c.at)
        if shade is None and c.kind("word") and c.tokens[c.at].capital and c.look(1) is not None:
            named = self.palette.color(c, c.at + 1)  # "Join Egg Yellow yarn": a yarn by the colour in its name
            shade = None if named is None else (named[0], named[1] + 1)
        worked = any(not isinstance(i, Action) or i.name not in ("color", "flo", "blo", "turn") for i in found)
        if shade is not None:
            span = Span(c.tokens[c.at].start, c.tokens[c.at + shade[1] - 1].end)
            c.at += shade[1]
            begin = c.at
            self.to_separator("turn", "fasten off", "and", "form")
            clause = c.tokens[begin : c.at]
            last = any(t.value == "last" or t.word == "last" for t in clause)  # "joining B in last sc": only its colour
            tied = any(t.kind == "stitch" and (t.value == "slst" or (t.value == "sc" and not last)) for t in clause)
            in_space = not worked and spaced(c.tokens[begin : c.at])
            if not worked and not in_space:
                self.body.moved = self.body.moved or moved(c.tokens[begin : c.at])
            if worked and (tied or goes_on):
                found.append(Action("join", token.span))
                self._joined_at(found, clause)
            found.append(Action("color", span, numbers=shade[0]))
            found += [Action("tospace", span, numbers=(0,))] if in_space else []
            found += [] if worked else _joining_stitch(c.tokens[begin : c.at])
            return
        begin = c.at
        self.to_separator("turn", "fasten off", "and", "form")
        if c.mark("(") and c.kind("stitch", 1) and c.mark(")", ahead=2):
            c.at += 3  # "slip stitch (sl st) to first ch"
            self.to_separator("turn", "fasten off", "and", "form")
        if not worked and spaced(c.tokens[begin : c.at]):  # "Join with sl st in any ch-2 sp"
            found += [Action("tospace", token.span, numbers=(0,)), *_joining_stitch(c.tokens[begin : c.at])]
            return
        if not worked and (elsewhere := moved(c.tokens[begin : c.at])) is not None:
            self.body.moved = self.body.moved or elsewhere
            found += _joining_stitch(c.tokens[begin : c.at])
            return
        by_sc = next((t for t in c.tokens[begin : c.at] if t.value == "sc"), None)
        if worked and by_sc is not None and any(t.value == "next" for t in c.tokens[begin : c.at]):
            found.append(
                Action("sc", by_sc.span)
            )  # "join to next st with sc through all layers": another piece is tied in
            self.body.both = True
            return
        found += (not worked and _joining_stitch(c.tokens[said : c.at])) or [Action("join", token.span)]
        self._joined_at(found, c.tokens[begin : c.at])

    def _joined_at(self, found: list[Item], clause: list[Token]) -> None:
        """Takes a join for the end of the round that its clause names, "join with sl st to first sc at end of last rnd", of the rounds that are worked alike."""
        at = next((k + 1 for k, t in enumerate(clause) if t.word == "end"), 0)
        named = next((t for t in clause[at:] if t.value == "last" or type(t.value) is int), None) if at else None
        spiral = any(map(makes, found)) and not _lifts(found)  # else each of them is joined, as its chain says
        if named is not None and spiral and isinstance(found[-1], Action) and found[-1].name == "join":
            self.body.later.append((found.pop(), named.value if type(named.value) is int else 0))


def _lifts(found: list[Item]) -> bool:
    """Whether a round begins with a chain that lifts the yarn, as joined rounds do."""
    first = next((i for i in found if not isinstance(i, Action) or i.name not in ("color", "flo", "blo")), None)
    return isinstance(first, Action) and first.name == "ch"


def _joining_stitch(clause: list[Token]) -> list[Item]:
    """The stitch that yarn is joined with, "with sc in first unworked sc", "with a standing dc", which is the first of the round."""
    at = next((k + 1 for k, t in enumerate(clause) if t.kind == "key" and t.value == "with"), len(clause))
    while at < len(clause) and (clause[at].word in _STANDING or clause[at].value == "begin"):
        at += 1
    if at < len(clause) and clause[at].kind == "stitch" and clause[at].value in ("sc", "hdc", "dc", "tr"):
        return [Action(str(clause[at].value), clause[at].span)]
    return []
