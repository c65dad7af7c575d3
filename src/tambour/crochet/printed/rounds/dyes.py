"""Printed patterns, dyes: changes of the yarn's colour within a round: "change to brown", "with white yarn", "White:"."""

from __future__ import annotations

from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB
from tambour.crochet.language.tree import Action, Item
from tambour.crochet.printed.rounds.counts import last_worked
from tambour.crochet.printed.rounds.courses import Courses
from tambour.crochet.printed.yarns.colors import LETTERS

_STOPPED: Final = (",", ".", ";", "(", "[", ")", "]")
_STRANDS: Final = frozenset(("strand", "strands", "length", "lengths", "double", "separate"))
_HOOKS: Final = frozenset("smaller smallest larger largest medium size small large hook".split())


class Dyes(Courses):
    """Reads changes of colour."""

    def _other_yarn(self) -> None:
        """Passes the yarn of another version: "with A (B)", "with A or B"."""
        c = self.c
        words = [t.word if t is not None else "" for t in (c.look(0), c.look(1), c.look(2))]
        if words[0] == "(" and words[1] in LETTERS and words[2] == ")":
            c.at += 3
        elif words[0] == "or" and words[1] in LETTERS:
            c.at += 2

    def later(self, found: list[Item]) -> None:
        """Goes past "at end of Row 4", behind a change of colour: it is made when these rounds are worked."""
        c, begin = self.c, self.c.at
        self.to_separator()
        number = next((t.value for t in c.tokens[begin : c.at] if isinstance(t.value, int)), 0)
        self.body.later.append((found.pop(), number))

    def versions(self) -> bool:
        """Takes the yarns of another version, "A for shoe and D for legs" or "with D", in their order; whether they are said at the cursor."""
        c, begin = self.c, self.c.at
        hues: list[RGB] = []
        said = self.body.refers.span.end if self.body.refers is not None else 0
        parted = any(t.word in (".", ";") for t in c.tokens[: c.at] if t.start >= said)
        whole = not parted and self.yarned()
        if not c.skip_key("with", "over"):
            return False
        while (shade := self.palette.color(c) or self.palette.letter(c, c.at)) is not None:
            c.at += shade[1]
            if whole:
                hues.append(shade[0])
            if not c.key("for"):
                break
            hues.append(shade[0])
            while c.look() is not None and not c.mark(*_STOPPED) and not (c.key("and") and self._yarn_next()):
                c.at += 1
            if c.mark("(", "["):
                c.at = next(
                    (k + 1 for k in range(c.at, len(c.tokens)) if c.tokens[k].word in (")", "]")), len(c.tokens)
                )
            c.at += c.mark(",") and (self._yarn_next() or (c.key("and", ahead=1)))
            c.skip_key("and")
        if not hues:
            c.at = begin
            return False
        self.body.hues = hues
        return True

    def _yarn_next(self) -> bool:
        """Whether the token behind the one at the cursor is a yarn."""
        return self.palette.color(self.c, self.c.at + 1) is not None or (
            (token := self.c.look(1)) is not None and token.word in LETTERS
        )

    def _of_yarn(self) -> bool:
        """Goes past the yarn that stitches of the round below were worked in; whether it stands at the cursor."""
        c = self.c
        shade = self.palette.color(c, c.at + 1) or self.palette.letter(c, c.at + 1)
        if shade is None or (not self.depth and not any(t.kind == "stitch" for t in c.tokens[max(0, c.at - 6) : c.at])):
            return False
        c.at += 1 + shade[1]
        return True

    def _behind(self) -> bool:
        """Whether the yarn at the cursor is that of the stitches before it: "6 sc in red", "sc around with A"."""
        c, k = self.c, self.c.at
        while (k and c.tokens[k - 1].kind == "number") or (k and c.tokens[k - 1].word in ("x", ")", "]")):
            k -= 1  # "sc 6 with red", "(sc, inc) x 9 in red"
        before = c.tokens[k - 1] if k else None
        stitches = before is not None and (before.kind == "stitch" or before.value in ("stitch", "around", "times"))
        if not stitches or c.key("with", "in"):
            return stitches
        shade = self.palette.color(c)
        return shade is not None and (
            c.look(shade[1]) is None or c.mark(",", ".", ")", "(", ahead=shade[1])
        )  # "6 sc red"

    def _undyed(self) -> bool:
        """Goes past a change of yarn that names none, "change color", "color change", at the end of a clause; whether one stands at the cursor."""
        c, first, second = self.c, self.c.look(), self.c.look(1)
        if first is None:
            return False
        turned = first.word in ("color", "colour") and second is not None and second.word in ("change", "changes")
        changed = first.value == "color" and first.word.split()[0] in ("change", "switch", "changing")
        ahead = 1 + turned
        if not (turned or changed) or not (
            c.look(ahead) is None or c.mark(",", ".", ";", "(", "[", "-", "=", ahead=ahead)
        ):
            return False
        self.body.undyed = Span(first.start, c.tokens[c.at + ahead - 1].end)
        c.at += ahead
        return True

    def _labels(self, at: int, length: int) -> bool:
        """Whether the yarn at ``at`` is told of the whole round, behind its count: "sc around (18) - red"."""
        counted = self.body.stated_span
        behind = self.c.tokens[at + length :]
        return (
            counted is not None
            and counted.end <= self.c.tokens[at].start
            and all(t.kind == "mark" or t.value == "yarn" for t in behind)
        )

    def color(self, found: list[Item]) -> bool:
        """A change of colour at the cursor: ``change to brown``, ``with white yarn``, ``in Brown``, ``White:``."""
        c = self.c
        at = c.at
        if (
            c.key("with", "in")
            and (worked := c.look(-1)) is not None
            and worked.word in ("made", "worked")
            and self._of_yarn()
        ):
            return True  # "2 dc in each of first 2 sc made with A" tells those stitches
        if self._undyed():
            return True
        if c.key("join"):
            return False  # "Join B with sl st to first sc": joins the round, if there is one
        words = [t.word if (t := c.look(k)) is not None else "" for k in range(14)]
        if words[1] == "same" and {"color", "colour"} & set(words[2:4]) and "," in words:
            c.at += words.index(",")  # "With same color as for Body, ch 12"
            return True
        asked = hooked = False
        if c.tokens[at].word == "back" and c.key("to", "in", ahead=1):
            asked, at = True, at + 2  # "back to B, sc around"
        elif c.mark(",", ":", ahead=1) and not found and c.kind("word") and c.tokens[at].capital and len(words[0]) <= 2:
            asked = words[0] in self.palette.given  # "C, sc around"
        while at < len(c.tokens) and at - c.at < 8:
            token = c.tokens[at]
            after = c.look(at - c.at + 1)
            if (
                token.word in ("color", "contrast")
                and after is not None
                and (after.word in LETTERS or after.word.isdigit())
            ):
                asked = True
                break
            if token.kind == "key" and token.value in ("color", "with", "in", "join", "yarn", "to", "begin"):
                asked = asked or token.value in ("color", "with", "yarn")
                at += 1
            elif asked and (token.word in _HOOKS or (token.kind == "key" and token.value in ("hook", "and"))):
                hooked = hooked or token.word in _HOOKS
                at += 1  # "with smaller hook and A"
            elif asked and (
                token.word in _STRANDS or (token.kind == "number" and after is not None and after.word in _STRANDS)
            ):
                at += 1  # "with 2 strands of A"
            elif hooked and after is not None and after.kind == "key" and after.value == "hook":
                at += 1  # "with size F hook"
            elif token.word in ("color", "colour", "new") and at + 1 < len(c.tokens):
                asked = True
                at += 1
            else:
                break
        shade = self.palette.color(c, at) or (self.palette.letter(c, at) if asked else None)
        if shade is None and hooked:
            c.at = at
            return True
        if shade is None:
            return False
        rgb, length = shade
        after = c.look(at + length - c.at + 1) if c.mark(",", ahead=at + length - c.at) else None
        if after is not None and after.word.startswith("embroider"):
            return False  # "On underside of nose, with D, embroider a smile": no round changes to it
        dyed = Action("color", Span(c.tokens[at].start, c.tokens[at + length - 1].end), numbers=rgb)
        label = at == c.at and self._labels(at, length)
        found.insert(0 if label else last_worked(found) if self._behind() else len(found), dyed)
        c.at = at + length
        self._other_yarn()
        c.skip_key("yarn")
        if c.look() is not None and c.look().word == "held":  # type: ignore[union-attr]
            c.at += 1
            c.skip_key("together")  # "With 2 strands of B held tog"
        while c.key("and") and c.look(1) is not None and (c.look(1).word in _HOOKS):  # type: ignore[union-attr]
            c.at += 2
            if c.key("hook", ahead=1):
                c.at += 1  # "with A and size F hook"
            c.skip_key("hook")
        if c.key("to") and (end := c.look(1)) is not None and end.word == "end":
            self.later(found)
        elif c.key("in", "to") and c.key("last", ahead=1):  # "change to B in last st of Row 8"
            self.to_separator()
        return True
