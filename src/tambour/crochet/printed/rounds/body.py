"""Printed patterns, the body of a round: its words → items, by recursive descent."""

from __future__ import annotations

from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.rounds.asides import aside, things
from tambour.crochet.printed.rounds.counts import closing_count, count, ends_with_number, makes, slips
from tambour.crochet.printed.rounds.courses import FLATTENED
from tambour.crochet.printed.rounds.doings import BETWEEN, by_hand, closed_flat, doing, drawn_tight, until_stitches
from tambour.crochet.printed.rounds.marked import taken
from tambour.crochet.printed.rounds.motifs import as_they_come, begun, gathered
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.references import even_rounds
from tambour.crochet.printed.rounds.repeats import bracket, more_times, star
from tambour.crochet.printed.rounds.standing import turned
from tambour.crochet.printed.rounds.stitch import bump, room, spread, stitch
from tambour.crochet.printed.rounds.trade import ENDS, Trade
from tambour.crochet.printed.tokens import Token

_PHRASE = frozenset(",;.()[]{}*=")
_FACING: Final = frozenset(("right", "wrong", "rs", "ws", "facing"))
_PARTED: Final = frozenset(("break", "drop", "carry"))
_LAST: Final = frozenset(("end", "ending", "ends"))
_PUTS: Final = frozenset(("place", "put", "insert"))
_MEANWHILE: Final = frozenset("put place insert mark move remove replace keep tuck weave thread tie knot snip glue fold".split())  # fmt: skip
"""What hands do in the midst of a round, before it goes on as it was."""


_ENDS_OF_YARN: Final = frozenset(("tail", "tails", "strand", "strands", "end", "ends"))
_NEAR: Final = 8  # characters between a count and the bracket that ends it
_PULLED: Final = frozenset(("pull", "tighten", "draw", "cinch"))
_HOW: Final = frozenset(("loosely", "tightly", "firmly"))
_HOLES: Final = frozenset("buttonhole armhole underarm strap slit handle handles thumb opening loop hanger".split())
"""What chains and skipped stitches are for."""
_NEAR_BY: Final = 2  # characters between two words that nothing stands between
_TALL: Final = ("hdc", "dc", "tr")
_COURSED: Final = ("leave", "in", "begin", "make", "with", "over")


class Walk(Trade):
    """Reads one body, clause after clause."""

    def read(self) -> Body:
        """The body; NotUnderstood when none of its sentences is understood."""
        body, c = self.body, self.c
        while c.look() is not None:
            at, made = c.at, len(body.items)
            self.begun = at
            if (many := things(c)) == 2 and body.items and (c.look(many) is None or c.mark(".", ahead=many)):
                c.at += many + 1  # "4 shells."
                continue
            if self.shuts(at):
                c.at += 1
                continue
            if self.hands():
                c.at += c.at == at or c.mark(*ENDS, ",", ":")  # a count behind it is the round's
                continue
            if any(map(makes, body.items)) and (even := even_rounds(c.tokens[at : self.end_of_sentence()])) is not None:
                body.plain.append(even)
                c.at = self.end_of_sentence() + 1
                continue
            before = (body.stated, body.stated_span, body.rounds, body.sides)
            more = len(body.more)
            self.edging, there = False, body.moved is not None
            try:
                self.items(body.items, ENDS)
                if self._evens(body.items[made:]):
                    del body.items[made:]
                    body.doings.append(c.tokens[at : c.at])
                if self.edging and not there and any(map(makes, body.items[:made])):
                    del body.items[made:]  # "Work 1 rnd of sc evenly around Ear": along another edge
                    body.stated, body.stated_span, body.rounds, body.sides = before
                    body.moved = None
                    body.edged.append(Span(c.tokens[at].start, c.tokens[c.at - 1].end))
                if more and not any(isinstance(i, Group) or i.name not in ("color", "join") for i in body.items[made:]):
                    body.between += [
                        (more, i) for i in body.items[made:] if isinstance(i, Action) and i.name == "color"
                    ]
                    del body.items[made:]
                if self.before is not None:
                    raise NotUnderstood(c.tokens[c.at - 1], "what goes in this place is not said", "say which stitches")
            except NotUnderstood as wrong:
                body.wrong = body.wrong or wrong
                del body.items[made:], body.more[more:]
                body.stated, body.stated_span, body.rounds, body.sides = before
                self.depth = self.stars = 0
                self.before = None
                c.at = at
                c.at = self.end_of_sentence()
                if c.at > at:  # else all of it was read
                    body.left.append(c.tokens[at : c.at])
            if c.at == at or c.mark(*ENDS):
                c.at += 1
            self._idle(at, made)
        if body.rings:
            body.items = gathered(body.items, self.stitches, c.tokens[0])
        body.items = as_they_come(begun(body.items, self.stitches), self.stitches)
        body.pending = self.ring is not None
        idle = not any(makes(i) or slips(i) for i in body.items)
        if body.wrong is not None and idle and body.refers is None:
            raise body.wrong
        return body

    def _evens(self, items: list[Item]) -> bool:
        """Whether a sentence only evens the end of rounds that are repeated before it: "Slip st in next st"."""
        again = bool(self.body.more) or self.body.refers is not None
        one = items[0] if len(items) == 1 else None
        return again and isinstance(one, Action) and one.name == "slst" and one.times == 1

    def _idle(self, at: int, made: int) -> None:
        """Keeps a sentence that was read and works nothing ("Now work in rows"), so that it stands with its round."""
        body, said = self.body, self.c.tokens[at : self.c.at]
        words = [t for t in said if t.kind != "mark"]
        works = (
            len(body.items) > made
            or body.stated_span in [t.span for t in said]
            or any(said[0] in left for left in body.left)
        )
        kept = any(d and said[0].start <= d[0].start < said[-1].end for d in body.doings)
        if words and not works and not kept and words[0].kind == "key" and words[0].value in _COURSED[1:]:
            body.doings.append(said)

    def shuts(self, at: int) -> bool:
        """Goes past a sentence behind those of a round that closes the opening flat; whether it is one: "Don't stuff, close with 6 sc"."""
        c, end = self.c, self.end_of_sentence()
        begins = [at, *(k + 1 for k in range(at, end) if c.tokens[k].word == "," and k + 1 < end)]
        if not any(map(makes, self.body.items)) or not any(self.closes_flat([], k, True) for k in begins):
            return False
        self.body.shut = Span(c.tokens[at].start, c.tokens[end - 1].end)
        if begins[1:]:
            self.body.doings.append(c.tokens[at : begins[1] - 1])
        c.at += closing_count(c, c.tokens[at:end], self.body.stated is not None)
        return True

    def hands(self) -> bool:
        """Goes past what hands do here, up to its point, and keeps it; whether the sentence is such a doing."""
        at, end = self.c.at, self.end_of_sentence()
        end = at + until_stitches(self.c.tokens[at:end])
        if end == at or not (doing(self.c) or by_hand(self.c.tokens[at:end])):
            return False
        self.c.at = end
        self.body.doings.append(self.c.tokens[at:end])
        said = self.body.doings[-1]
        self.body.ends = "open" if closed_flat(said) else "close" if drawn_tight(said) else self.body.ends
        return True

    # -- clauses ----------------------------------------------------------------------------------------------------

    def items(self, found: list[Item], closers: frozenset[str]) -> None:
        """Clauses into ``found`` up to a closing mark, which is left at the cursor."""
        c = self.c
        while (token := c.look()) is not None:
            if token.kind == "mark" and token.word in closers:
                return
            opens = token.capital or (token.kind == "key" and token.value in _COURSED)
            if closers is ENDS and opens and self._behind_count():
                return  # "(12) Stuff lightly."
            if closers is ENDS and token.word == "-" and self._behind_count() and self.noted():
                return
            if not self.between(token):
                self.clause(found, token)

    def _behind_count(self) -> bool:
        """Whether the cursor stands right behind the bracket that held the count of the round: a sentence of its own begins."""
        stated, before = self.body.stated_span, self.c.look(-1)
        if self.c.at == self.begun:
            return False
        return (
            before is not None
            and before.word in (")", "]", "}")
            and stated is not None
            and 0 <= before.start - stated.end < _NEAR
        )

    def between(self, token: Token) -> bool:
        """Goes past what only stands between clauses."""
        c = self.c
        if aside(c):
            self.to_separator()
            return True
        if self._clause_by_hand(token):
            return True
        after = c.look(1)
        if (
            token.kind == "key"
            and token.value == "with"
            and after is not None
            and (after.word in _FACING or self.held())
        ):
            self.to_separator()  # "with right side facing"
            return True
        if token.kind == "key" and token.value == "over" and self._over_ends():
            self.to_separator()
            return True
        if token.kind == "mark" and token.word in BETWEEN:
            counts = token.word == "-" or (token.word == ":" and any(map(makes, self.body.items)))
            if (counts and ends_with_number(self, 1)) or (token.word == "<" and c.whole(1) is not None):
                return False  # "- 18 sts", "<18>"
            c.at += 1
            if token.word == "-" and (many := things(c)):
                c.at += many  # "- 5 petals"
            return True
        if self._of_round(token):
            return True
        long, chain = c.look(-1), c.look(-2)
        made = long is not None and (
            long.kind == "stitch"
            or long.word in (",", "around")
            or (long.kind == "number" and chain is not None and chain.value == "ch")
        )
        if token.word in _HOW and made:
            c.at += 1  # "ch 14 loosely", "5 chs very tightly"
            return True
        if token.kind == "key" and token.value in ("and", "begin", "make", "times", "for", "more"):
            if token.value == "begin" and c.key("from", "in", "to", ahead=1):
                return False
            if token.value == "for" and c.kind("number", 1) and c.key("round", "row", ahead=2):
                return False
            if token.value in ("times", "more"):
                raise NotUnderstood(token, "this repeats nothing", "put what is repeated in brackets before it")
            ahead = 1 + (c.kind("ordinal", 1) or c.key("last", "other", ahead=1))
            hole = c.look(ahead)
            c.at += 1 + ahead if token.value == "for" and hole is not None and hole.word in _HOLES else 1
            return True
        return False

    def _clause_by_hand(self, token: Token) -> bool:
        """Goes past a clause that only says what hands do, "put a marker here", and keeps it; whether the cursor stands at one."""
        c, begin = self.c, self.c.at
        if token.kind != "word" or token.word not in _MEANWHILE or token.word in FLATTENED:
            return False
        self.to_separator()
        said = c.tokens[begin : c.at]
        counts = any(a.kind == "number" and b.value == "stitch" for a, b in pairwise(said))  # "keep going for 6 sts"
        if by_hand(said) and not counts and not any(self.palette.color(c, k) is not None for k in range(begin, c.at)):
            self.body.doings.append(said)
            self.body.ends = "close" if drawn_tight(said) else self.body.ends
            return True
        c.at = begin
        return False

    def _of_round(self, token: Token) -> bool:
        """Goes past "of Round 1" and "from previous round" behind the stitch that they are said of: "skip next sc of Round 1"; whether they stand
        here."""
        c = self.c
        before, after = c.look(-1), c.look(1)
        if before is None or token.kind != "key" or not (before.kind == "stitch" or before.value == "stitch"):
            return False
        named = token.value == "round" or token.value == "row"
        if named and (number := c.whole(1)) is not None and after is not None and token.start - before.end > _NEAR_BY:
            self.body.below = number, Span(token.start, after.end)
            c.at += 2
            return True
        if (
            token.value == "from"
            and after is not None
            and after.word in ("previous", "last")
            and c.key("round", "row", ahead=2)
        ):
            c.at += 3
            return True
        return False

    def _over_ends(self) -> bool:
        """Whether the clause at the cursor only says what is caught in: "working over yarn tail", "over the A strand"."""
        ahead, caught = 1, False
        while (token := self.c.look(ahead)) is not None and not (token.kind == "mark" and token.word in ",.;:([-)]"):
            if token.kind in ("stitch", "number"):
                return False
            caught = caught or token.word in _ENDS_OF_YARN
            ahead += 1
        return caught

    def clause(self, found: list[Item], token: Token) -> None:
        """One clause at the cursor."""
        c = self.c
        if token.kind == "mark" and token.word in OPEN:
            bracket(self, found, token)
        elif token.kind == "mark" and token.word in ("*", "**"):
            star(self, found, token)
        elif self.body.refers is not None and self.versions():
            return  # "same as papa's legs, using A for shoe and D for legs"
        elif more_times(self, found) or self.phrase(found, token) or count(self, found) or self.color(found):
            return
        elif token.kind == "number" and isinstance(token.value, int):
            self.number(found, token)
        elif token.kind == "stitch":
            if not spread(self, found):
                stitch(self, found, None)
        elif token.kind == "key":
            self.key(found, token)
        elif token.word in ("attach", "draw", "add") and not any(map(makes, found)) and self.yarn_ahead():
            c.at += 1
            while c.look() is not None and c.look().word in ("loop", "up"):  # type: ignore[union-attr]
                c.at += 1
            self.joining(found, token)  # "Attach A in first free loop", "draw up a loop of B in same st"
        elif token.word in _PUTS and (c.kind("stitch", 1) or (c.kind("number", 1) and c.kind("stitch", 2))):
            c.at += 1  # "Place 2 sc in each st around"
        elif token.word in ("rotate", "flip"):
            chained = any(t.value in ("ch", "foundation", "side") for t in c.tokens[c.at : c.at + 14])
            if chained:
                self.other_side(found)
            else:
                self.to_separator()
        elif (token.word in FLATTENED and self.closed_flat(found, token)) or self.closes_flat(found, c.at):
            return
        elif token.word in FLATTENED:
            while c.look() is not None and not c.mark(",", ".", ";") and not c.key("thicknesses"):
                c.at += 1  # "flatten piece and work through both thicknesses"
        elif token.word in _PARTED:
            self.to_separator("and")  # "Break B", "Drop MC": what comes next says the yarn that goes on
        elif token.word == "pick" and self.palette.letter(c, c.at + 1) is not None:
            c.tokens[c.at] = Token("key", "with", token.start, token.end, "with")  # "Pick up A"
            self.color(found)
        elif token.word in _LAST and (found or self._evens_again()):
            self.ends_with(found)
        elif token.word in _PULLED and self._pulls():
            self.to_separator()
        elif not self.along(found):
            message = f'"{token.word}" is not understood here'
            raise NotUnderstood(token, message, "a stitch, a number or a repeat is wanted here")

    def _pulls(self) -> bool:
        """Whether the clause at the cursor only pulls yarn: "pull tail to close ring"."""
        ahead = 1
        while (token := self.c.look(ahead)) is not None and not (token.kind == "mark" and token.word in ",.;:([)]"):
            if token.kind in ("stitch", "number") or token.word in ("loop", "loops"):
                return False
            ahead += 1
        return ahead > 1

    def _evens_again(self) -> bool:
        """Whether a slip stitch ends rounds that are worked again, at the cursor: "Repeat round 3, end with sl st in next st"."""
        c, again = self.c, self.body.refers is not None or bool(self.body.more)
        first = c.look(1 + c.key("with", ahead=1))
        return again and first is not None and first.value == "slst"

    def ends_with(self, found: list[Item]) -> None:
        """``rep from * around, end sc``: stitches that the repeat before them leaves room for."""
        c = self.c
        c.at += 1
        if (
            (self.body.refers is not None or self.body.more)
            and c.key("with")
            and c.whole(1) is not None
            and (c.look(3) is None or c.mark(".", ";", "(", ahead=3))
        ):
            c.at += 3  # "Rep last row 3 times more, ending with 18 sc": the count of the last of them
            return
        if not found:
            c.skip_key("with")  # "Repeat round 3, end with sl st in next st": that evens the last of them
            return
        whole = not (c.key("last") and c.key("repeat", ahead=1))
        c.at += 0 if whole else 2  # "ending last rep with 1 sc in last 8 sc": in place of the end of that repeat
        c.skip_key("with", "in")
        inner: list[Item] = []
        while (token := c.look()) is not None and not c.mark(".", ";", "(", "[", "-", "=", "*", "**"):
            if not self.between(token):
                self.clause(inner, token)
        last = found[-1] if found else None
        if not whole and isinstance(last, Group) and last.times is None and inner:
            once, lead = taken(list(last.items), 0, self.stitches), list(last.items[:-1])
            while lead and taken([*lead, *inner], 0, self.stitches) > once:
                lead.pop()
            inner = [*lead, *inner]
        room(self, found, inner)
        found += inner

    def phrase(self, found: list[Item], token: Token) -> bool:
        """A sentence that the writer prints for marks, forks and loops."""
        c = self.c
        if self.phrases is None or token.kind not in ("key", "word", "stitch", "number"):
            return False
        end = c.at
        while end < len(c.tokens) and not (c.tokens[end].kind == "mark" and c.tokens[end].word in _PHRASE):
            end += 1
        before = c.look(-1)
        begin = before.end if before is not None and before.kind == "mark" else token.start  # fillers stand between
        action = self.phrases(begin, c.tokens[end - 1].end) if end > c.at else None
        if action is None:
            return False
        if action.name == "fold" and not action.labels:
            self.folded(found, action)
        elif action.name == "turn":
            turned(self, found, action)
        else:
            found.append(action)
        c.at = end
        return True

    def _all_of_it(self, found: list[Item], token: Token) -> bool:
        """Works a sentence so many times as its end says, without a bracket: "One sc and an increase, six times (18)"; whether it does."""
        c = self.c
        after = c.look(2)
        ends = (
            after is None
            or after.word in (".", ";", "!")
            or (after.word in ("(", "[") and c.whole(3) is not None and c.mark(")", "]", ahead=4))
        )
        if self.depth or self.stars or not c.key("times", ahead=1) or not c.mark(",", ahead=-1) or not ends:
            return False
        begin = c.tokens[self.begun].start
        at = next((k for k, i in enumerate(found) if makes(i) and _first(i).span.start >= begin), None)
        if at is None or token.value < 2:
            return False
        found[at:] = [Group(tuple(found[at:]), token.value, token.span)]
        c.at += 2
        return True

    def number(self, found: list[Item], token: Token) -> None:
        """A number: of stitches, of repeats, or of rounds."""
        c = self.c
        if self._all_of_it(found, token):
            return
        if (
            c.mark("-", ahead=1)
            and c.kind("stitch", 2)
            and c.kind("stitch", 3)
            and (named := bump(c.look(3), token.value))
        ):
            c.at += 3  # "3-hdc popcorn"
            c.tokens[c.at] = Token("stitch", named, token.start, c.tokens[c.at].end, named)
            stitch(self, found, None)
            return
        tall, heap = c.look(1), c.look(2)
        named = bump(heap, token.value) if tall is not None and tall.value in _TALL else ""
        if heap is not None and named:
            c.at += 2  # "3 dc cluster"
            c.tokens[c.at] = Token("stitch", named, token.start, heap.end, named)
            stitch(self, found, None)
            return
        hue = self.palette.color(c, c.at + 1)
        if hue is not None and c.kind("stitch", 1 + hue[1]):  # "6 white sc"
            words = c.tokens[c.at + 1 : c.at + 1 + hue[1]]
            found.append(Action("color", Span(words[0].start, words[-1].end), numbers=hue[0]))
            del c.tokens[c.at + 1 : c.at + 1 + hue[1]]
        ahead = 1
        while c.mark("x", "*", ahead=ahead) or c.key("times", ahead=ahead):
            ahead += 1
        after = c.look(ahead)
        if self.ring is not None and ahead == 1 and (after is None or after.kind != "stitch"):
            self.plain(found, token)
        elif after is not None and after.kind == "mark" and after.word in OPEN:
            begin = c.at
            c.at += ahead
            inner: list[Item] = []
            bracket(self, inner, after)
            one = inner[0] if len(inner) == 1 else None
            items = one.items if isinstance(one, Group) and one.times == 1 else tuple(inner)
            self.body.asked.pop("once", None)
            if items:
                found.append(Group(items, max(token.value, 1), token.span))
            else:  # "crochet 12 (12)": the bracket was a count
                c.at = begin
                self.plain(found, token)
        elif after is not None and after.kind == "stitch":
            c.at += ahead
            stitch(self, found, token)
        elif c.key("round", "row", ahead=1 + c.key("more", ahead=1)):
            c.at += 2 + c.key("more", ahead=1)
            self.body.rounds = (token.value, token.span)
            plain = c.look(1)
            if (
                not self.depth
                and c.key("in")
                and plain is not None
                and plain.kind == "stitch"
                and (c.look(2) is None or c.mark(".", ",", ";", ahead=2))
            ):
                found.append(
                    Group((Action(plain.value, plain.span),), None, token.span)
                )  # "6 more rounds evenly in sc"
                c.at += 2
        elif c.key("stitch", "in", ahead=1):
            self.plain(found, token)
        elif after is not None and after.kind == "word":
            raise NotUnderstood(after, f'"{after.word}" is not understood here', "a stitch is wanted after a number")
        else:
            raise NotUnderstood(token, "this number belongs to nothing", "a stitch is wanted after it")

    def plain(self, found: list[Item], token: Token) -> None:
        """A number of stitches that are not named: single crochets."""
        c = self.c
        c.at += 1
        c.tokens = [*c.tokens[: c.at], Token("stitch", "sc", token.start, token.end, "sc"), *c.tokens[c.at :]]
        if c.key("stitch", ahead=1):
            del c.tokens[c.at + 1]
        stitch(self, found, token)


def _first(item: Item) -> Action:
    """The first of what an item works."""
    while isinstance(item, Group):
        item = item.items[0]
    return item
