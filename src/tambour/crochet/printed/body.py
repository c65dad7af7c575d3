"""Printed patterns, the body of a round: its words → items, by recursive descent."""

from __future__ import annotations

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.clauses import where
from tambour.crochet.printed.counts import count, ends_with_number
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.reader import Body, Reader
from tambour.crochet.printed.repeats import bracket, led, repeated, star
from tambour.crochet.printed.stitch import standing, stitch
from tambour.crochet.printed.tokens import Token

_BETWEEN = frozenset(",;:.-/+!&~|><·")
_LOOPS = {"front loops": "flo", "back loops": "blo", "both loops": "bl"}
_PHRASE = frozenset(",;.()[]{}*=")
_ENDS = frozenset((".", ";"))


class Walk(Reader):
    """Reads one body, clause after clause."""

    def read(self) -> Body:
        """The body; NotUnderstood when its first sentence is not understood."""
        body, c = self.body, self.c
        while c.look() is not None:
            at, made = c.at, len(body.items)
            try:
                self.items(body.items, _ENDS)
            except NotUnderstood:
                if not body.items[:made]:
                    raise
                del body.items[made:]
                self.depth = self.stars = 0
                self.before = None
                c.at = at
                while c.look() is not None and not c.mark(*_ENDS):
                    c.at += 1
                body.left.append(c.tokens[at : c.at])
            if c.look() is not None:
                c.at += 1
        if self.ring is not None:
            raise NotUnderstood(self.ring, "the ring has no stitches", "say how many: 6 sc in magic ring")
        return body

    # -- clauses ----------------------------------------------------------------------------------------------------

    def items(self, found: list[Item], closers: frozenset[str]) -> None:
        """Clauses into ``found`` up to a closing mark, which is left at the cursor."""
        c = self.c
        while (token := c.look()) is not None:
            if token.kind == "mark" and token.word in closers:
                return
            if not self.between(token):
                self.clause(found, token)

    def between(self, token: Token) -> bool:
        """Goes past what only stands between clauses."""
        c = self.c
        if token.kind == "mark" and token.word in _BETWEEN:
            if token.word in "-:" and ends_with_number(self, 1):
                return False
            c.at += 1
            return True
        if token.kind == "key" and token.value in ("and", "begin", "make", "times", "for", "more"):
            if token.value == "begin" and c.key("from", "in", ahead=1):
                return False
            if token.value == "for" and c.kind("number", 1) and c.key("round", "row", ahead=2):
                return False
            if token.value in ("times", "more"):
                raise NotUnderstood(token, "this repeats nothing", "put what is repeated in brackets before it")
            c.at += 1
            return True
        return False

    def clause(self, found: list[Item], token: Token) -> None:
        """One clause at the cursor."""
        if token.kind == "mark" and token.word in OPEN:
            bracket(self, found, token)
        elif token.kind == "mark" and token.word in ("*", "**"):
            star(self, found, token)
        elif self.phrase(found, token) or count(self, found) or self.color(found):
            return
        elif token.kind == "number" and isinstance(token.value, int):
            self.number(found, token)
        elif token.kind == "stitch":
            stitch(self, found, None)
        elif token.kind == "key":
            self.key(found, token)
        else:
            message = f'"{token.word}" is not understood here'
            raise NotUnderstood(token, message, "a stitch, a number or a repeat is wanted here")

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
        found.append(action)
        c.at = end
        return True

    def number(self, found: list[Item], token: Token) -> None:
        """A number: of stitches, of repeats, or of rounds."""
        c = self.c
        ahead = 1
        while c.mark("x", "*", ahead=ahead) or c.key("times", ahead=ahead):
            ahead += 1
        after = c.look(ahead)
        if self.ring is not None and ahead == 1 and (after is None or after.kind != "stitch"):
            self.plain(found, token)
        elif after is not None and after.kind == "mark" and after.word in OPEN:
            c.at += ahead
            inner: list[Item] = []
            bracket(self, inner, after)
            one = inner[0] if len(inner) == 1 else None
            items = one.items if isinstance(one, Group) and one.times == 1 else tuple(inner)
            self.body.asked.pop("once", None)
            found.append(Group(items, max(token.value, 1), token.span))
        elif after is not None and after.kind == "stitch":
            c.at += ahead
            stitch(self, found, token)
        elif c.key("round", "row", ahead=1):
            c.at += 2
            self.body.rounds = (token.value, token.span)
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

    def key(self, found: list[Item], token: Token) -> None:
        """A clause that begins with a word of the pattern's own trade."""
        c, word = self.c, token.value
        c.at += 1
        if word == "ring":
            self.ring = token
            if c.mark("(") and c.whole(1) is not None and c.mark(")", ahead=2):
                del c.tokens[c.at + 2], c.tokens[c.at]
            while c.key("with", "in", "and") and (c.kind("number", 1) or c.kind("stitch", 1)):
                c.at += 1
        elif word in ("in", "over", "each", "next", *_LOOPS):
            if c.key("side"):
                self.body.sides = True
                self.to_separator()
                return
            c.at -= 1
            place = where(c)
            if place is None:
                raise NotUnderstood(token, f'"{token.word}" is not understood here', "say into which stitches")
            if place.kind == "loops":
                loop = Action(place.loops, place.span)
                after = c.look()
                whole = after is None or (after.kind == "mark" and after.word in (".", "(", "[", "{", "=", "-", ";"))
                at = 0
                if whole and found:  # said last, it holds for all that was said
                    at = len(led(found)[0])
                found.insert(at if whole and found else len(found), loop)
            elif place.kind == "ring":
                self.ring = token
            else:
                if place.loops:
                    found.append(Action(place.loops, place.span))
                    place.loops = ""
                self.before = place
        elif word == "turn" and (c.key("side") or c.key("side", ahead=1)):
            self.body.sides = True
            self.to_separator()
        elif word == "turn":
            found.append(Action("turn", token.span))
        elif word == "join":
            self.to_separator("turn", "fasten off", "and", "form")
            found.append(Action("join", token.span))
        elif word == "form":
            if not any(isinstance(i, Action) and i.name == "join" for i in found):
                found.append(Action("join", token.span))
        elif word == "fasten off":
            found.append(Action("fo", token.span))
            self.ending()
        elif word in ("close", "open", "leave"):
            c.at -= 1
            self.ending()
        elif word in ("stuff", "marker", "foundation"):
            self.to_separator()
        elif word == "begin":
            pass
        elif word == "even":
            c.skip_key("around")
            found.append(Group((Action("sc", token.span),), None, token.span))
        elif word == "repeat" or (word == "as" and c.key("round", "row")):
            self.again(found, token)
        elif word == "for" and c.whole() is not None:
            self.body.rounds = (c.whole() or 0, c.take().span)
            c.at += 1
        elif word == "count" or (word == "not" and c.key("count")):
            if word == "count":
                standing(found)
            self.to_separator()
        elif word == "side" or (word == "with" and c.key("side")):
            self.body.sides = True
            self.to_separator()
        elif word == "around" and self.depth == 0 and found:
            lead, inner = led(found)
            found[:] = [*lead, Group(tuple(inner), None, token.span)]
        else:
            raise NotUnderstood(
                token, f'"{token.word}" is not understood here', "a stitch, a number or a repeat is wanted"
            )

    def again(self, found: list[Item], token: Token) -> None:
        """``repeat Rnd 4``, ``rep Rnds 2-3``, or a repeat of all that was said."""
        c = self.c
        if c.key("round", "row"):
            c.at += 1
            first = last = c.whole()
            if first is None:
                raise NotUnderstood(token, "the number of the round is missing", "say which: repeat Rnd 4")
            end = c.take()
            while (c.mark("-", ",") or c.key("to", "and")) and (
                c.whole(1) is not None or (c.key("round", "row", ahead=1) and c.whole(2) is not None)
            ):
                c.at += 1 + c.key("round", "row", ahead=1)
                last, end = c.whole(), c.take()
            self.body.refers = (first, last or first, Span(token.start, end.end))
            return
        lead, inner = led(found)
        if not inner:
            raise NotUnderstood(token, "there is nothing to repeat here", "say which round: repeat Rnd 4")
        c.at -= 1
        found[:] = lead
        repeated(self, found, inner, token.span, star=True)

    def ending(self) -> None:
        """How the end is left: closed, or open for sewing; to the end of the sentence."""
        c = self.c
        left = False
        while c.look() is not None and not c.mark(".", "(", "["):
            if c.key("close"):
                self.body.ends = "close"
            elif (c.key("open") or (left and c.tokens[c.at].word == "tail")) and self.body.ends != "close":
                self.body.ends = "open"
            left = left or (c.key("leave") and c.tokens[c.at].word.startswith("leav"))
            c.at += 1

    def color(self, found: list[Item]) -> bool:
        """A change of colour at the cursor: ``change to brown``, ``with white yarn``, ``in Brown``, ``White:``."""
        c = self.c
        at = c.at
        asked = False
        while at < len(c.tokens) and at - c.at < 4:
            token = c.tokens[at]
            if token.kind == "key" and token.value in ("color", "with", "in", "join", "yarn", "to", "begin"):
                asked = asked or token.value in ("color", "with", "yarn")
                at += 1
            elif token.word in ("color", "colour", "new") and at + 1 < len(c.tokens):
                asked = True
                at += 1
            else:
                break
        shade = self.palette.color(c, at) or (self.palette.letter(c, at) if asked else None)
        if shade is None:
            return False
        rgb, length = shade
        found.append(Action("color", Span(c.tokens[at].start, c.tokens[at + length - 1].end), numbers=rgb))
        c.at = at + length
        c.skip_key("yarn")
        return True
