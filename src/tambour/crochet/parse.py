"""Pattern text → Pattern: line by line, so that all mistakes of a file are found at once."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from typing import Any

from tambour.core.errors import Problem, Span, TambourError, Text, did_you_mean
from tambour.crochet.lines import read_line, without_comment
from tambour.crochet.stitches import MOVES, NEXT, OVER, RULES, STARTS, STITCHES, STUFFING, Move, Stitch, standard
from tambour.crochet.syntax import Action, Group, Item, Line, Pattern, Section

_BLOCK = re.compile(r"[ \t]*[A-Za-z_]\w*[ \t]*\{[ \t]*$")
_PLACE = re.compile(r"[ \t]*[A-Za-z_]\w*[ \t]*=[ \t]*-?[\w.]+[ \t]*,?[ \t]*$")
_PROSE = re.compile(r"[ \t]*[A-Za-z][A-Za-z'-]*(?:[ \t]+[A-Za-z][A-Za-z'-]*){3,}[ \t]*[.!]?[ \t]*$")
_COPY = re.compile(r"^(.*)\.(\d+)$")
_TRUTH = {"true": True, "yes": True, "1": True, "false": False, "no": False, "0": False}
# A definition may use others before it; its moves may not grow without end.
_MOST_MOVES = 200


def parse(text: Text, *, max_stitches: int = 200_000, strict: bool = False) -> Pattern:
    """The pattern that ``text`` says (docs/crochet.md, "Language").

    max_stitches : the most nodes it may make; checked when it is built
    strict : doubts about stated numbers are errors

    Raises TambourError with every problem of the text.
    """
    reader = _Reader(text, strict)
    reader.read()
    reader.finish()
    errors = [p for p in reader.problems if not p.warning]
    if errors:
        raise TambourError(sorted(errors, key=lambda p: p.span.start if p.span else 0))
    return Pattern(
        text,
        tuple(reader.sections),
        reader.stitches,
        tuple(reader.own),
        tuple(p for p in reader.problems if p.warning),
        max_stitches,
    )


@dataclass
class _Reader:
    """The state of reading one text: the part under way, the labels so far, what was wrong."""

    text: Text
    strict: bool
    problems: list[Problem] = field(default_factory=list)
    sections: list[Section] = field(default_factory=list)
    stitches: dict[str, Stitch] = field(default_factory=lambda: dict(STITCHES))
    own: list[str] = field(default_factory=list)
    labels: dict[str, int] = field(default_factory=dict)  # → copies of its part
    lines: list[Line] = field(default_factory=list)
    parameters: dict[str, tuple[str, Span, Span]] = field(default_factory=dict)
    header: tuple[str, Span, int, Span | None] = ("", Span(0, 0), 1, None)
    last_number: int | None = None
    said_bl: bool = False

    def error(self, message: str, hint: str, span: Span) -> None:
        self.problems.append(Problem(message, hint, span, self.text))

    def doubt(self, message: str, hint: str, span: Span, number: bool = False) -> None:
        self.problems.append(Problem(message, hint, span, self.text, warning=not (number and self.strict)))

    # -- lines ------------------------------------------------------------------------------------------------------

    def read(self) -> None:
        """Every line of the text, into parts."""
        start, commented, block = 0, False, False
        for whole in self.text.text.split("\n"):
            line = without_comment(whole.rstrip("\r"))
            span = Span(start, start + len(line.rstrip()))
            blank = not line.strip()
            if block:
                block = line.strip() != "}"
                if block and not blank and not _PLACE.match(line):
                    self.error(
                        "this does not fit in a block of places", "lines such as x = 7, and a } after them", span
                    )
            elif _BLOCK.match(line):
                block = True
                hint = "a ring finds its own place: the block can be left out"
                self.doubt("places of rings are not used", hint, span)
            elif commented and _PROSE.match(line) and not self._words_known(line):
                self.doubt("this reads as the comment above, continued", "begin it with #", span)
            elif not blank:
                tree, problems = read_line(line, start, self.text)
                self.problems += problems
                if tree is not None:
                    getattr(self, "_" + tree.children[0].data)(tree.children[0], start, span)
            commented = bool(whole.lstrip().startswith("#")) or (commented and not blank)
            start += len(whole) + 1
        if block:
            end = len(self.text.text.rstrip())
            self.error("a block of places is not closed", "a line with } ends it", Span(max(0, end - 1), end))
        self._end_part(last=True)

    def finish(self) -> None:
        """Doubts that only the whole text shows."""
        if not any(line.items for section in self.sections for line in section.lines):
            self.doubt("the pattern is empty", "begin with a magic ring: a line such as : MR(6)", Span(0, 0))

    def _words_known(self, line: str) -> bool:
        words = [standard(w) for w in re.findall(r"[A-Za-z]+", line)]
        return all(w in self.stitches or w in RULES for w in words)

    def _end_part(self, last: bool = False) -> None:
        name, at, copies, copies_span = self.header
        if name or self.lines or self.parameters or (last and not self.sections):
            self.sections.append(self._section(Section(name, at, tuple(self.lines), copies, copies_span)))
        self.lines, self.parameters, self.last_number = [], {}, None

    def _header(self, tree: Any, start: int, span: Span) -> None:
        self._end_part()
        names = [t for t in tree.children if t.type == "NAME"]
        name, at = " ".join(names), Span(start + names[0].start_pos, start + names[-1].end_pos)
        if any(section.name == name for section in self.sections):
            self.error(f'there is a part "{name}" already', "give each part its own name; (make 2) makes copies", at)
        copies, copies_span = 1, None
        for token in tree.children:
            if token.type == "INT":
                copies, copies_span = int(token), Span(start + token.start_pos, start + token.end_pos)
                if copies == 0:
                    self.error("a part is made at least once", "leave the part out instead", copies_span)
        self.header = (name, at, max(copies, 1), copies_span)

    def _parameter(self, tree: Any, start: int, span: Span) -> None:
        key, value = tree.children
        at = Span(start + key.start_pos, start + key.end_pos)
        if key.lower() in self.parameters:
            self.error(f'"{key}" is given twice in this part', "keep one of the two", at)
        self.parameters[key.lower()] = (str(value), Span(start + value.start_pos, start + value.end_pos), at)

    def _section(self, plain: Section) -> Section:
        """The section with its parameters understood."""
        other: dict[str, str] = {}
        found: dict[str, Any] = {}
        for key, (value, at, name) in self.parameters.items():
            word = value.lower()
            if key == "centroids":
                if not re.fullmatch(r"\d{1,6}", value):
                    self.error(f'"{value}" is no number of centroids', "a whole number, 0 or more", at)
                else:
                    found[key] = int(value)
            elif key == "stuffing":
                if word in STUFFING:
                    found[key] = STUFFING[word]
                elif re.fullmatch(r"\d{1,3}(\.\d+)?", value):
                    found[key] = float(value)
                else:
                    self.error(f'"{value}" is no amount of stuffing', f"one of {', '.join(STUFFING)}, or a factor", at)
            elif key == "initializer":
                if word not in STARTS:
                    known = did_you_mean(word, STARTS) or "rounds or one-by-one"
                    self.error(f'"{value}" is no way to begin', known, at)
                else:
                    found[key] = STARTS[word]
            elif key == "tip_from_fo":
                if word not in _TRUTH:
                    self.error(
                        f'"{value}" is neither true nor false', "true: FO closes the edge; false: it does not", at
                    )
                else:
                    found[key] = _TRUTH[word]
            else:
                other[key] = value
                self.doubt(f'the parameter "{key}" has no effect', "known: centroids, stuffing, initializer", name)
        return replace(plain, other=other, **found)

    # -- rounds -----------------------------------------------------------------------------------------------------

    def _round(self, tree: Any, start: int, span: Span) -> None:
        times, at, number, stated, stated_at, note = 1, None, None, None, None, None
        items: tuple[Item, ...] = ()
        for child in tree.children:
            kind = getattr(child, "type", None) or child.data
            if kind == "RANGE":
                at = Span(start + child.start_pos, start + child.end_pos)
                number, times = self._range(str(child), at)
            elif kind == "before":
                times, at = self._number(child.children[0], start)
                if times == 0:
                    self.doubt("a round worked no times is left out", "give it a number, or no number", at)
            elif kind == "items":
                items = self._items(child, start, True, False)
            elif kind == "count":
                stated, stated_at = self._number(child.children[0], start)
            elif kind == "note":
                note = self._number(child.children[1], start)
        if note and note[0] != times:
            self.doubt(f"{note[0]} rounds are said here, {times} at the line's start", "make them agree", note[1], True)
        self.lines.append(Line(items, span, True, times, at, number, stated, stated_at))

    def _range(self, word: str, at: Span) -> tuple[int, int]:
        numbers = [int(n) for n in re.findall(r"\d+", word)]
        first, last = numbers[0], numbers[-1]
        if len(numbers) == 2 and last <= first:
            self.error(
                f"the range {word} does not rise", f"write R{min(numbers)}-R{max(numbers) + (first == last)}", at
            )
            return first, 1
        before, self.last_number = self.last_number, last
        if before is not None and first != before + 1:
            said = "is there already" if first <= before else "leaves rounds out"
            self.doubt(f"round {first} {said}: the one before is {before}", f"{before + 1} would follow", at)
        return first, last - first + 1

    def _number(self, token: Any, start: int) -> tuple[int, Span]:
        return int(token), Span(start + token.start_pos, start + token.end_pos)

    def _control(self, tree: Any, start: int, span: Span) -> None:
        self.lines.append(Line(self._items(tree.children[0], start, False, False), span, False))

    # -- items ------------------------------------------------------------------------------------------------------

    def _items(self, tree: Any, start: int, in_round: bool, bracket: bool) -> tuple[Item, ...]:
        found: list[Item] = []
        for child in tree.children:
            make = self._group if child.data == "group" else self._stitch
            item = make(child, start, in_round, bracket)
            if item is not None:
                found.append(item)
        return tuple(found)

    def _group(self, tree: Any, start: int, in_round: bool, bracket: bool) -> Item | None:
        times: int | None = 1
        at = Span(start, start)
        items: tuple[Item, ...] = ()
        for child in tree.children:
            kind = getattr(child, "type", None) or child.data
            if kind == "before":
                times, at = self._number(child.children[0], start)
            elif kind == "items":
                items = self._items(child, start, in_round, True)
            elif kind == "repeats" and child.children[0].type == "AROUND":
                times, at = None, Span(start + child.children[0].start_pos, start + child.children[0].end_pos)
            elif kind == "repeats":
                times, at = self._number(child.children[1], start)
        if times == 0:
            self.error("brackets are repeated at least once", "leave the brackets out instead", at)
        if times is None and bracket:
            self.error("around stands within other brackets", "give the inner brackets a number", at)
        if times is None and not in_round:
            self.error("around needs a round", "begin the line with a colon", at)
        return Group(items, times, at)

    def _stitch(self, tree: Any, start: int, in_round: bool, bracket: bool) -> Item | None:
        times, times_at, after, after_at, around = 1, None, None, None, None
        words = None
        for child in tree.children:
            kind = getattr(child, "type", None) or child.data
            if kind == "before":
                times, times_at = self._number(child.children[0], start)
            elif kind == "after":
                after, after_at = self._number(child.children[0], start)
            elif kind == "AROUND":
                around = Span(start + child.start_pos, start + child.end_pos)
            else:
                words = child
        names = [t for t in words.children if getattr(t, "type", "") == "NAME"]  # type: ignore[union-attr]
        given = [t for t in words.children if not hasattr(t, "type")]  # type: ignore[union-attr]
        span = Span(start + names[0].start_pos, start + names[-1].end_pos)
        name = standard(" ".join(names))
        arguments = self._arguments(given[0], start) if given else None
        if name in RULES:
            if times_at is not None:
                self.error(f'"{" ".join(names)}" is not repeated', "take the number away", span)
            if after is not None and after_at is not None:
                if name == "mr" and arguments is None:
                    arguments = ([(str(after), after_at)], after_at)
                else:
                    self.error("this number belongs to nothing", "a comma goes between stitches", after_at)
            return self._action(name, span, arguments, in_round, bracket)
        if name not in self.stitches:
            known = [*self.stitches, *(k for k in RULES)]
            hint = did_you_mean(name, known) or "docs/crochet.md lists the stitches; define makes new ones"
            if len(names) > 1 and all(standard(n) in known for n in names):
                hint = "a comma goes between stitches"
            self.error(f'there is no stitch or action "{" ".join(names)}"', hint, span)
            return None
        if arguments is not None:
            values, at = arguments
            if name == "ch" and len(values) == 1 and values[0][0].isdigit():
                after, after_at = int(values[0][0]), values[0][1]
            else:
                self.error("a stitch takes no parentheses", f"write 6 {name}; a count stands apart: {name} (6)", at)
        if after is not None:
            if times_at is not None and after_at is not None:
                self.error("two numbers for one stitch", "keep one of the two", after_at)
            times, times_at = after, after_at
        if not in_round and name != "ch":
            self.error(f'"{" ".join(names)}" stands outside a round', "begin the line with a colon", span)
        if times == 0 and times_at is not None:
            self.doubt("a stitch made no times is left out", "give it a number, or no number", times_at)
        action = Action(name, span, times, times_at)
        if around is not None:
            if bracket:
                self.error("around stands within other brackets", "give the stitch a number", around)
            return Group((action,), None, around)
        return action

    def _arguments(self, tree: Any, start: int) -> tuple[list[tuple[str, Span]], Span]:
        tokens = tree.children
        values = [(str(t), Span(start + t.start_pos, start + t.end_pos)) for t in tokens if t.type == "ARG"]
        return values, Span(start + tokens[0].start_pos, start + tokens[-1].end_pos)

    def _action(
        self,
        name: str,
        span: Span,
        arguments: tuple[list[tuple[str, Span]], Span] | None,
        in_round: bool,
        bracket: bool,
    ) -> Action | None:
        rule, word = RULES[name], self.text.text[span.start : span.end]
        values, at = arguments if arguments is not None else ([], span)
        if arguments is not None and rule.most == 0:
            self.error(f'"{word}" takes no parentheses', f"write {rule.usage}", at)
            return None
        if not rule.fewest <= len(values) <= rule.most or (name == "color" and len(values) == 2):
            few = "too few" if len(values) < rule.most else "too many"
            self.error(f'{few} arguments for "{word}"', f"write {rule.usage}", at)
            return None
        if in_round and not rule.in_round:
            self.error(f'"{word}" stands within a round', "give it a line of its own, without a colon", span)
        if not in_round and not rule.outside:
            self.error(f'"{word}" stands outside a round', "begin the line with a colon", span)
        if bracket and not rule.in_brackets:
            self.error(f'"{word}" is not repeated', "take it out of the brackets", span)
        if name == "bl" and not self.said_bl:
            self.said_bl = True
            hint = "write BLO for the back loop; here BL ends FLO or BLO"
            self.doubt("BL means both loops here, though printed patterns mean the back loop", hint, span)
        if name in ("mr", "goto"):
            self.last_number = None  # another piece of work, with its own numbers
        labels = tuple(value for value, _ in values[: rule.labels])
        numbers = self._numbers(name, values, rule.labels)
        if numbers is None:
            return None
        self._label_rules(name, labels, span)
        return Action(name, span, 1, None, numbers, labels)

    def _numbers(self, name: str, values: list[tuple[str, Span]], labels: int) -> tuple[int, ...] | None:
        """The arguments that are no labels, as numbers; None when they are wrong."""
        if name == "color":
            return self._color(values)
        if name == "attach":
            if len(values) == 1:
                return (0,)
            value, at = values[1]
            if value.lower() == "merge" or value == "997":  # the older dialect's number for it
                return (-1,)
            if not value.isdigit():
                self.error(f'"{value}" is no length of a chain', f"write {RULES[name].usage}", at)
                return None
            return (int(value),)
        if name == "mr":
            value, at = values[0]
            if not value.isdigit() or int(value) == 0:
                self.error(f'"{value}" is no number of stitches', f"write {RULES[name].usage}", at)
                return None
            return (int(value), len(values) - 1)
        return ()

    def _color(self, values: list[tuple[str, Span]]) -> tuple[int, ...] | None:
        if len(values) == 3:
            found = []
            for value, at in values:
                if not value.isdigit() or int(value) > 255:
                    self.error(f'"{value}" is no part of a colour', "red, green and blue are numbers 0 to 255", at)
                else:
                    found.append(int(value))
            return tuple(found) if len(found) == 3 else None
        from PIL import ImageColor

        value, at = values[0]
        try:
            return ImageColor.getrgb(value)[:3]
        except ValueError:
            near = did_you_mean(value.lower(), ImageColor.colormap)
            self.error(f'there is no colour "{value}"', near or RULES["color"].usage, at)
            return None

    def _label_rules(self, name: str, labels: tuple[str, ...], span: Span) -> None:
        if name == "mark":
            if labels[0] in self.labels:
                self.error(f'there is a mark "{labels[0]}" already', "give each mark its own name", span)
            elif _COPY.match(labels[0]):
                self.error("a mark's name has no point", "copies of a part get .1, .2 … by themselves", span)
            self.labels[labels[0]] = self.header[2]
            return
        for label in labels:
            base = label if label in self.labels else (found[1] if (found := _COPY.match(label)) else label)
            copies = self.labels.get(base)
            if copies is None:
                hint = did_you_mean(label, self.labels) or f"set it first: mark({label})"
                self.error(f'there is no mark "{label}" before this', hint, span)
            elif base == label and copies > 1 and (name == "sew" or self.header[2] == 1):
                self.error(
                    f'the mark "{label}" is in a part made {copies} times', f"{label}.1 is the first copy's", span
                )
            elif base != label and not 1 <= int(label.rsplit(".", 1)[1]) <= copies:
                self.error(f'"{label}" is not there: the part is made {copies} times', f"up to {base}.{copies}", span)

    # -- definitions ------------------------------------------------------------------------------------------------

    def _definition(self, tree: Any, start: int, span: Span) -> None:
        tokens = [t for t in tree.children if hasattr(t, "type")]
        name_token = next(t for t in tokens if t.type == "NAME")
        name, at = standard(name_token), Span(start + name_token.start_pos, start + name_token.end_pos)
        height = next((float(t) for t in tokens if t.type == "NUMBER"), 0.0)
        if height > 10:
            self.error("a stitch is at most 10 single crochets high", "give a smaller height", at)
            return
        if name in RULES or name in self.stitches or name in MOVES:
            self.error(f'"{name_token}" is there already', "give the new stitch its own name", at)
            return
        before = len(self.problems)
        moves = self._moves(tree.children[-1], start, name, height)
        if any(not p.warning for p in self.problems[before:]):
            return
        if len(moves) > _MOST_MOVES:
            self.error(f"a stitch of {len(moves)} moves is too long", f"at most {_MOST_MOVES}", at)
            return
        if not any(m.what in (OVER, NEXT, "join") for m in moves):
            self.error("this stitch does nothing", "pull over makes it; next anchor goes on", at)
            return
        if moves[-1].what == "through":
            self.error("yarn is pulled through and left on the hook", "end with pull over", at)
            return
        self.stitches[name] = Stitch(name, moves)
        self.own.append(name)

    def _moves(self, tree: Any, start: int, own: str, height: float) -> tuple[Move, ...]:
        made: list[Move] = []
        for child in tree.children:
            if len(made) > _MOST_MOVES:
                break
            if child.data == "group":
                times = 1
                inner: tuple[Move, ...] = ()
                for part in child.children:
                    kind = getattr(part, "type", None) or part.data
                    if kind == "items":
                        inner = self._moves(part, start, own, height)
                    elif kind == "before":
                        times, _ = self._number(part.children[0], start)
                    elif kind == "repeats" and part.children[0].type == "AROUND":
                        token = part.children[0]
                        at = Span(start + token.start_pos, start + token.end_pos)
                        self.error("a stitch does not go around", "give the brackets a number", at)
                    elif kind == "repeats":
                        times, _ = self._number(part.children[1], start)
                made += inner * min(times, _MOST_MOVES + 1)
                continue
            times, tokens = 1, []
            for part in child.children:
                if getattr(part, "type", "") == "AROUND" or (part.data == "words" and len(part.children) == 0):
                    self.error("a stitch does not go around", "give it a number", Span(start, start + 1))
                elif part.data in ("before", "after"):
                    times, _ = self._number(part.children[0], start)
                else:
                    tokens = part.children
            names = [t for t in tokens if getattr(t, "type", "") == "NAME"]
            at = Span(start + names[0].start_pos, start + names[-1].end_pos)
            word = standard(" ".join(names))
            if len(names) != len(tokens):
                self.error("moves take no parentheses", "define name(height 2) sets the height", at)
            elif word in MOVES:
                move = MOVES[word]
                made += [replace(move, kind=own, height=height or 1.0) if move.what == OVER else move] * min(
                    times, _MOST_MOVES + 1
                )
            elif word in self.stitches:
                moves = self.stitches[word].moves
                if height:
                    moves = tuple(replace(m, height=height) if m.what == OVER else m for m in moves)
                made += moves * min(times, _MOST_MOVES + 1)
            else:
                known = ["pull through", "pull over", "next anchor", "join", *self.stitches]
                hint = (
                    did_you_mean(" ".join(names).lower(), known) or "pull through, pull over, next anchor, or a stitch"
                )
                self.error(f'there is no move or stitch "{" ".join(names)}"', hint, at)
        return tuple(made)
