"""Printed patterns, the words of the trade: clauses that begin with one, and rounds that are named or end."""

from __future__ import annotations

from typing import Final

from tambour.crochet.language.tree import Action, Group, Item
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.rounds.clauses import where
from tambour.crochet.printed.rounds.counts import closing, counted_at, ends_with_number, makes
from tambour.crochet.printed.rounds.courses import FLATTENED, PIECES
from tambour.crochet.printed.rounds.curls import back_along
from tambour.crochet.printed.rounds.doings import closed_flat
from tambour.crochet.printed.rounds.dyes import Dyes
from tambour.crochet.printed.rounds.references import further, refers
from tambour.crochet.printed.rounds.repeats import again_said, between_stars, led, repeated
from tambour.crochet.printed.rounds.standing import standing, stands, turned
from tambour.crochet.printed.tokens import Token

_LOOPS = {"front loops": "flo", "back loops": "blo", "both loops": "bl"}
_COURSE: Final = frozenset("spiral spirals continuous joined pattern sequence rounds rows turned".split())
_ENDED_SO: Final = frozenset(("seam", "attach", "finish", "secure", "complete", "cover", "shape"))
_AS: Final = frozenset("you work needed desired shown pictured required progresses".split())
_WORKED: Final = ("turn", "join", "in", "color")  # what work goes on with behind "leaving a long tail, …"
ENDS: Final = frozenset((".", ";"))
"""Marks that end a sentence."""


class Trade(Dyes):
    """Reads these clauses."""

    def end_of_sentence(self) -> int:
        """Where the sentence at the cursor ends: at its point, or before a count that follows a dash."""
        c, at = self.c, self.c.at
        depth = 0
        while at < len(c.tokens):
            token = c.tokens[at]
            if token.kind == "mark":
                if depth <= 0 and token.word in "-([{" and at > c.at and self.counted(at):
                    return at - 1 if c.tokens[at - 1].word in ENDS else at
                depth += (token.word in OPEN) - (token.word in ")]}>")
                if token.word in ENDS and depth <= 0:
                    return at
            at += 1
        return at

    def counted(self, at: int) -> bool:
        """Whether a count stands behind the dash, or in the bracket, at ``at``."""
        c, before = self.c, self.c.at
        if at > 1 and c.tokens[at].word == "-" and c.tokens[at - 1].kind == "number":
            named = c.tokens[at - 2]
            if named.kind == "key" and named.value in ("round", "row"):
                return False  # "sew edges of Rows 14-35 together"
        c.at = at
        depth, self.depth = self.depth, 0
        try:
            return ends_with_number(self, 1) if c.mark("-") else counted_at(self, closing(self))
        except NotUnderstood:
            return False
        finally:
            c.at, self.depth = before, depth

    def noted(self) -> bool:
        """Goes past a note behind the count, to its point: "(36) - the front loops are for the skirt"; whether one stands there."""
        c, end = self.c, self.end_of_sentence()
        said = c.tokens[c.at + 1 : end]
        if not any(t.word in ("is", "are", "will") for t in said) or any(t.kind == "number" for t in said):
            return False
        self.body.doings.append(said)
        c.at = end
        return True

    def closes_flat(self, found: list[Item], begin: int, layers: bool = False) -> bool:
        """Whether the sentence from token ``begin`` on, which is read then, closes the opening, pressed flat, by stitches: "flatten and close with 4 sc", "fold
        in half and sc the two sides together (6 sts)". layers : it may name both layers, as others do that are read elsewhere."""
        c = self.c
        said = c.tokens[begin : self.end_of_sentence()]
        worked = [t for t in said if t.kind == "stitch" and t.value in ("sc", "hdc", "dc")]
        keys = {t.value for t in said if t.kind == "key"}
        flat = bool(said) and (said[0].word in FLATTENED or said[0].value == "close" or _worked_shut(said))
        shut = keys & {"close", "together"} or (layers and "thicknesses" in keys)
        if not (worked and shut and flat) or self.edge is None or keys & {"ring", "round", "row"}:
            return False
        if "thicknesses" in keys and not layers:
            return False
        if said[0].value == "close" and any(t.word == "," for t in said[: said.index(worked[0])]):
            return False  # "Pull tight, sc in next 12 sts"
        found.append(Action("fold", said[0].span))
        c.at = begin + len(said)
        while (token := c.look()) is not None and token.word not in ENDS:
            c.at += 1  # "(9 sts)" behind it counts what closes it, and is none of the round's
        return True

    def key(self, found: list[Item], token: Token) -> None:
        """A clause that begins with a word of the pattern's own trade."""
        c, word = self.c, token.value
        c.at += 1
        if word == "close" and self.closes_flat(found, c.at - 1):
            return
        if word == "around" and c.key("side"):
            self.other_side(found)
        elif word == "in" and c.key("thicknesses"):
            self.folding(found, c.take())
        elif word == "ring":
            self.ring = token
            if c.mark("(") and c.whole(1) is not None and c.mark(")", ahead=2):
                del c.tokens[c.at + 2], c.tokens[c.at]
            while c.key("with", "in", "and") and (c.kind("number", 1) or c.kind("stitch", 1)):
                c.at += 1
        elif (
            word in ("in", "over", "with", "from", "around")
            and not any(makes(i) and not stands(i) for i in found)
            and self.elsewhere(found)
        ):
            pass
        elif word in ("in", "over") and (after := c.look()) is not None and after.word in ("these", "those"):
            self.by_the_way(c.at - 1)  # "Working in these 33 sts only"
        elif word in ("in", "over") and (
            c.key("bumps", "foundation")
            or (after := c.look()) is None
            or after.word in _COURSE
            or (c.key("round", "row") and c.whole(1) is None)
            or c.mark(",", ":", ";", ".")
        ):
            self.by_the_way(
                c.at - 1
            )  # "working in back bumps of foundation ch", "in continuous rounds", "in stripe pattern"
        elif word in ("in", "over", "each", "next", *_LOOPS):
            if c.key("side"):
                self.other_side(found)
                return
            c.at -= 1
            place = where(c)
            if place is None:
                raise NotUnderstood(token, f'"{token.word}" is not understood here', "say into which stitches")
            if place.loops and place.kind in ("around", "same") and c.key("same", "round", "row"):
                place.kind = "loops"  # "in rem back loops of same row"
            if place.kind == "loops":
                numbered = c.whole(1) is not None or (c.whole(2) is not None and not c.mark(",", ahead=1))
                if c.key("in", "same", "round", "row") and not numbered:
                    while c.key("in", "same", "round", "row"):
                        c.at += 1  # "in back loops on this rnd only"
                if (piece := c.look()) is not None and piece.kind == "word" and piece.word in PIECES:
                    self.body.both = True  # "in back loops only of both halves"
                    self.to_separator()
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
                self.before = None if place.kind == "hook" and back_along(self, found, place) else place
        elif word == "with" and c.key("ring"):
            pass  # "begin using magic ring method"
        elif word == "turn" and self.side_ahead():
            self.other_side(found)
        elif word == "turn":
            turned(self, found, Action("turn", token.span))
            if c.key("to") and c.look(1) is not None and c.look(1).word == "end":  # type: ignore[union-attr]
                self.to_separator()  # "Turn at end of Rnd 21"
        elif word == "join":
            self.joining(found, token)
        elif word == "form":
            if not any(isinstance(i, Action) and i.name == "join" for i in found):
                found.append(Action("join", token.span))
        elif word == "fasten off" and token.word not in ("fasten off", "fo") and self.palette.color(c) is not None:
            self.by_the_way(c.at - 1)  # "break off white" ends no piece
        elif word == "fasten off":
            found.append(Action("fo", token.span))
            self.ending()
        elif word in ("close", "open", "leave"):
            c.at -= 1
            begin = c.at
            self.ending()
            if word == "close" and self.body.items:
                self.body.doings.append(c.tokens[begin : c.at])  # "inc around, pull tight"
        elif word in ("stuff", "marker"):
            self.by_the_way(c.at - 1)
        elif word == "foundation":
            self.to_separator()
        elif word == "begin":
            if c.key("to", "in", "from") and not c.kind("ordinal", 1):  # "beginning at top of head with A"
                while c.look() is not None and not c.mark(",", ".", ";") and not c.key("with"):
                    c.at += 1
            hook = next((k for k in range(2, 7) if c.key("hook", ahead=k)), 0)
            first = c.look(1)
            if (
                hook
                and not found
                and first is not None
                and first.kind == "ordinal"
                and c.kind("stitch", 2)
                and c.mark(",", ":", ahead=hook + 1)
            ):
                self.body.hook = int(first.value)  # "Starting in 2nd ch from hook, sc in each ch across"
                c.at += hook + 2
        elif word == "even":
            self.even(found, token)
        elif word == "thicknesses":
            self.folding(found, token)
        elif word in ("round", "row") and c.at > 1 and c.tokens[c.at - 2].word == "end":
            end = c.tokens[c.at - 2]  # "2 dc in same end of Row 3" has no row worked again
            raise NotUnderstood(end, "where this is worked is not understood", "name the round, and the stitch of it")
        elif (
            word in ("repeat", "as", "same")
            or (word == "from" and c.mark("**", "***"))
            or (word in ("round", "row") and c.whole() is not None)
        ):
            c.at -= 1
            self.again(found, token)
        elif word == "for" and c.whole() is not None:
            self.body.rounds = (c.whole() or 0, c.take().span)
            c.at += 1
        elif (
            word == "to"
            and (name := c.look()) is not None
            and name.kind == "word"
            and name.capital
            and any(map(makes, found))
        ):
            self.to_separator()  # "48 sc evenly across to Lower Section"
        elif word == "to" and c.key("color"):
            self.to_separator()  # "and continue to change color every other row"
        elif word == "to" and (c.key("close", "join", "form") or (c.look() is not None and c.look().word in _ENDED_SO)):  # type: ignore[union-attr]
            self.to_separator()  # "to close lower edge", "to seam"
        elif word == "count" or (word == "not" and c.key("count")):
            if word == "count":
                standing(found)
            self.to_separator()
        elif word == "not" and (c.key("join", "turn", "fasten off", "color", "begin") or self._says_no_stitch()):
            self.by_the_way(c.at - 1)  # "do not join", "without turning", "do not cut white"
        elif word == "color" and (after := c.look()) is not None and after.word in _COURSE:
            self.by_the_way(c.at - 1)  # "continue in a spiral"
        elif word == "side" and (after := c.look()) is not None and after.word in ("edge", "edges"):
            c.at -= 1  # "sc along bottom edge of Wing"
            if not self.along(found):
                c.at += 1
                self.other_side(found)
        elif word == "side" or (word == "with" and c.key("side")):
            self.other_side(found)
        elif word == "around" and self.depth == 0 and found:
            lead, inner = led(found)
            found[:] = [*lead, Group(tuple(inner), None, token.span)]
        else:
            raise NotUnderstood(
                token, f'"{token.word}" is not understood here', "a stitch, a number or a repeat is wanted"
            )

    def _says_no_stitch(self) -> bool:
        """Whether no stitch and no number stands in what is left of the clause at the cursor."""
        c, begin = self.c, self.c.at
        self.to_separator()
        said, c.at = c.tokens[begin : c.at], begin
        return bool(said) and not any(t.kind in ("stitch", "number", "ordinal") for t in said)

    def by_the_way(self, begin: int) -> None:
        """Goes past a clause that makes no stitch, "place marker", "do not join", and keeps it with its round."""
        self.to_separator()
        self.body.doings.append(self.c.tokens[begin : self.c.at])

    def even(self, found: list[Item], token: Token) -> None:
        """``work even``, ``work even in hdc with A``: a stitch in each, in a yarn that is said behind it."""
        c = self.c
        c.skip_key("around")
        named, after = c.look(1), c.look(2)
        alone = after is None or after.kind == "mark" or after.value in ("with", "around", "color", "until", "for")
        kind = named.value if named is not None and named.kind == "stitch" and c.key("in") and alone else "sc"
        c.at += 2 if named is not None and c.key("in") and named.kind == "stitch" and alone else 0
        c.skip_key("around")
        if c.key("with"):
            self.color(found)
        found.append(Group((Action(kind, token.span),), None, token.span))

    def again(self, found: list[Item], token: Token) -> None:
        """``repeat Rnd 4``, ``as Rnds 2-3 of Head``, or a repeat of all that was said."""
        c = self.c
        lead, inner = led(found)
        if not self.depth and (said := refers(self)) is not None:
            if any(map(makes, inner)) or self.body.refers is not None:
                self.body.more.append(said)
            else:
                self.body.refers = said
            while (ahead := further(c)) > 0:
                c.at += ahead
                if (said := refers(self)) is not None:
                    self.body.more.append(said)
            return
        if self.starred and token.value == "repeat" and again_said(c.tokens[c.at :]):
            between_stars(self, found)
            return
        if token.value == "as" and ((after := c.look(1)) is None or after.kind == "mark" or after.word in _AS):
            self.to_separator()  # "stuffing lightly as you work"
            return
        if token.value != "repeat":
            raise NotUnderstood(token, f'"{token.word}" is not understood here', "say which rounds: as Rnds 2-4")
        starred = any(t.word == "*" for t in c.tokens[c.at : self.end_of_sentence()])
        elsewhere = c.key("for", "in", "with", ahead=1) or (c.key("around", ahead=1) and c.kind("word", 2))
        if not self.depth and elsewhere and not starred:
            raise NotUnderstood(token, "what is repeated here is not understood", "say which round: repeat Rnd 4")
        if not inner:
            raise NotUnderstood(token, "there is nothing to repeat here", "say which round: repeat Rnd 4")
        found[:] = lead
        repeated(self, found, inner, token.span, star=True)

    def ending(self) -> None:
        """How the end is left: closed, or open for sewing; to the end of the sentence."""
        c = self.c
        left = False
        while c.look() is not None and not c.mark("."):
            worked = c.kind("stitch", 1) or c.key(*_WORKED, ahead=1) or (c.kind("number", 1) and c.kind("stitch", 2))
            ahead = 1 + c.key("and", ahead=1)
            more = c.kind("stitch", ahead) or (c.kind("number", ahead) and c.kind("stitch", ahead + 1))
            if (
                (c.mark(",", ";") and worked)
                or (c.key("and") and more)
                or (c.mark("-", "=") and ends_with_number(self, 1))
            ):
                break
            if c.mark(*OPEN):
                end = closing(self)
                if counted_at(self, end):
                    break
                c.at = end
            if c.key("close"):
                flat = closed_flat(c.tokens[max(0, c.at - 3) : self.end_of_sentence()])
                self.body.ends = "open" if flat else "close"
            elif (c.key("open") or (left and c.tokens[c.at].word == "tail")) and self.body.ends != "close":
                self.body.ends = "open"
            left = left or (c.key("leave") and c.tokens[c.at].word.startswith("leav"))
            c.at += 1


def _worked_shut(said: list[Token]) -> bool:
    """Whether a sentence works an opening closed: "Single crochet the top of the arm closed"."""
    return said[0].kind == "stitch" and said[-1].word == "closed" and all(t.kind == "word" for t in said[1:-1])
