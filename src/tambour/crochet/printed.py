"""Printed patterns: the text of a pattern as people write it → the same tree that tambour's own language gives."""

from __future__ import annotations

from typing import Final

from tambour.core.errors import Problem, Span, TambourError, Text, did_you_mean
from tambour.crochet.build import build
from tambour.crochet.finish import check_names
from tambour.crochet.phrases import Phrases
from tambour.crochet.printed_clauses import Cursor, NotUnderstood
from tambour.crochet.printed_colors import Palette
from tambour.crochet.printed_doubts import decided
from tambour.crochet.printed_finish import Assembly, Made, Sentence, finishes
from tambour.crochet.printed_heads import Head, heads
from tambour.crochet.printed_notes import MODES, Heading, definition, heading, plain_name, stated
from tambour.crochet.printed_parts import Draft
from tambour.crochet.printed_repeats import OPEN
from tambour.crochet.printed_terms import recognised
from tambour.crochet.printed_tokens import Row, Token, rows
from tambour.crochet.printed_vocabulary import vocabulary
from tambour.crochet.restated import lettered
from tambour.crochet.source import Source
from tambour.crochet.special import explained
from tambour.crochet.spots import Spots
from tambour.crochet.stitches import STUFFING
from tambour.crochet.syntax import Action, Line, Pattern
from tambour.crochet.terms import TERMS

NOT_UNDERSTOOD: Final = "this looks like instructions, and was not understood"
NOTHING: Final = "this holds no crochet instructions"
_HINTED = 20  # errors that suggestions are looked for
_LONG = 50  # characters of a line that was broken
_WRAPPED = 12  # lines of a paragraph
_KNOWN = (
    "around",
    "next",
    "each",
    "stitches",
    "repeat",
    "times",
    "magic",
    "from",
    "turn",
    "join",
    "skip",
    "loops",
    "fasten",
)
_PART = {"stuff none": "none", "stuff light": "light", "stuff medium": "medium", "stuff firm": "firm"}


def read_printed(text: Text, *, max_stitches: int = 200_000, strict: bool = False) -> Pattern:
    """The pattern that a printed text says (docs/crochet.md, "Patterns as people write them").

    Raises TambourError with every problem of the text; with one line when it holds no crochet instructions.
    """
    return _Printed(Source(text, strict)).pattern(max_stitches)


class _Printed:
    """Goes through the lines of a text, top to bottom."""

    def __init__(self, source: Source) -> None:
        self.source = source
        self.rows = rows(source.text.text)
        self.language = recognised(source, self.rows)
        self.vocabulary = vocabulary(self.language.code)
        self.palette = Palette([*self.vocabulary.stitches(), *_KNOWN])
        self.phrases = Phrases(TERMS[self.language.code], {}, lettered(source.text.text, TERMS[self.language.code]))
        self.palette.given.update((letter.lower(), hue) for letter, hue in self.phrases.legend.items())
        self.parts: list[Draft] = []
        self.lead: list[Line] = []  # colours said before the part that they begin
        self.heading: Heading | None = None
        self.mode = ""
        self.title: tuple[str, Span] | None = None
        self.stated: dict[str, tuple[str, Span]] = {}
        self.passed: list[Span] = []
        self.understood = self.failed = self.row_at = 0
        self.sentences: list[Sentence] = []  # of finishing, read once the parts are known

    def pattern(self, max_stitches: int) -> Pattern:
        """The whole text read."""
        at = 0
        while at < len(self.rows):
            at = self._row(at)
        source = self.source
        if not self.understood or self.failed > 3 * self.understood:
            hint = "a round looks like this: Rnd 1: 6 sc in magic ring (6)"
            raise TambourError(NOTHING, hint=hint, where=source.text.name)
        if self.lead and self.parts:
            self.parts[-1].lines += self.lead
        sections = tuple(draft.section(source) for draft in self.parts)
        self._colors_told()
        if self.sentences and all(p.warning for p in source.problems):
            self._assemble(Pattern(source.text, sections, source.stitches, max_stitches=max_stitches))
        errors = [p for p in source.problems if not p.warning]
        if errors:
            raise TambourError(sorted(errors, key=_place))
        if self.title is not None:
            self.stated.setdefault("title", self.title)
        return Pattern(
            source.text,
            sections,
            source.stitches,
            source.own,
            tuple(sorted(source.problems, key=_place)),
            max_stitches,
            tuple(source.finish),
            self.language.code,
            self.stated,
            tuple(self.passed),
        )

    def _assemble(self, pattern: Pattern) -> None:
        """Reads the sentences of finishing, now that the parts are there."""
        source = self.source
        copies = {part.name: part.copies for part in pattern.parts}
        phrases = Phrases(self.phrases.terms, copies, {k.upper(): rgb for k, rgb in self.palette.given.items()})
        try:
            spots = Spots(build(pattern))
        except TambourError:
            return  # the build tells what is wrong with the rounds
        made = [
            Made(draft.name, part.copies, draft.edge, any(i == "fo" for line in part.lines for i in _names(line)))
            for draft, part in zip(self.parts, pattern.parts)
        ]
        assembly = Assembly(made, spots, self.palette)
        for sentence in self.sentences:
            span = sentence.span
            exact = phrases.finishing(source.text.text[span.start : span.end], span)
            found = [exact] if exact is not None else assembly.read(sentence)
            if found is None:
                hint = "say the part and the round: sew the ears to the head between Rnds 5 and 6, 8 sts apart"
                source.doubt("where this goes is not understood", hint, span)
            else:
                source.finish += found
        check_names(source, copies, source.finish)

    def _colors_told(self) -> None:
        if self.palette.told:
            letters = ", ".join(dict.fromkeys(w.upper() for w in self.palette.told))
            hint = "say which colours they are: A = brown"
            self.source.doubt(f"the yarns {letters} are given colours of our choice", hint, Span(0, 0))

    # -- lines ------------------------------------------------------------------------------------------------------

    def _row(self, at: int) -> int:
        """One line, with those that go on with it; gives the next."""
        row = self.rows[at]
        self.row_at = at
        if not row.tokens:
            return at + 1
        tokens = self.vocabulary.read(row.tokens)
        found = heads(tokens)
        if not found:
            end = at + 1
            while end < len(self.rows) and end - at < _WRAPPED and self._wrapped(self.rows[end - 1], self.rows[end]):
                tokens += self.vocabulary.read(self.rows[end].tokens)
                row = Row([*row.tokens, *self.rows[end].tokens], row.start, self.rows[end].end, row.marked)
                end += 1
            self._text(row, tokens)
            return end
        at += 1
        while at < len(self.rows) and (more := self._goes_on(tokens, self.rows[at])) is not None:
            tokens += more
            at += 1
        if not found[0][1].strong and not self._instructs(tokens[found[0][1].end :]):
            self._text(row, tokens)
            return at
        for k, (begin, head) in enumerate(found):
            if k == 0 and begin > 0:
                self._text(row, tokens[:begin])
            end = found[k + 1][0] if k + 1 < len(found) else len(tokens)
            self._round(head, tokens[head.end : end], tokens[begin:end])
        return at

    def _wrapped(self, row: Row, after: Row) -> bool:
        """Whether a sentence of a long line goes on in the next."""
        if not after.tokens or row.marked or row.tokens[-1].word in (".", ":", "!", "?"):
            return False
        if row.tokens[-1].word in ("and", "the", "to", "of", "in", "with"):
            return not heads(self.vocabulary.read(after.tokens))
        if row.end - row.start < _LONG:
            return False
        first = self.source.text.text[after.tokens[0].start]
        return (first.islower() or first.isdigit()) and not heads(self.vocabulary.read(after.tokens))

    def _goes_on(self, before: list[Token], row: Row) -> list[Token] | None:
        """The tokens of a line that goes on with the round before it, None when it does not."""
        if not row.tokens:
            return None
        tokens = self.vocabulary.read(row.tokens)
        if not tokens or heads(tokens):
            return None
        depth = sum((t.word in OPEN) - (t.word in ")]}>") for t in before if t.kind == "mark")
        last, first = before[-1], tokens[0]
        if (
            depth > 0
            or last.word in (",", "+", "&")
            or (last.kind == "key" and last.value in ("and", "in", "next", "to"))
        ):
            return tokens
        if first.kind == "mark" and first.word in "([{*=":
            return tokens
        plain = self.source.text.text[first.start].islower() or first.kind == "number"
        if plain and last.word not in (".", ")", "]", "}") and first.kind in ("stitch", "key", "number"):
            return tokens
        return None

    def _instructs(self, tokens: list[Token]) -> bool:
        """Whether the text after a bare number is a round's."""
        words = [t for t in tokens if t.kind != "mark"]
        known = sum(t.kind in ("stitch", "number") or (t.kind == "key" and t.value == "ring") for t in words)
        return any(t.kind == "stitch" for t in words) and known * 2 >= len(words)

    def _round(self, head: Head, tokens: list[Token], whole: list[Token]) -> None:
        """A round that has a head."""
        span = Span(whole[0].start, whole[-1].end)
        self._begin(head.numbers[0] == 1 if head.numbers else False, span)
        draft = self.parts[-1]
        body = [*head.extra, Token("mark", ",", head.span.end, head.span.end), *tokens] if head.extra else tokens
        self.source.last_number = draft.last or None
        try:
            read = decided(self.source, body, self.palette, draft.edge, self.phrases)
        except NotUnderstood as wrong:
            self._wrong(wrong)
            draft.last = max(head.numbers) if head.numbers else draft.last + 1
            draft.edge = None
            return
        before = len(draft.lines)
        draft.add(self.source, head, read, span)
        self.understood += len(draft.lines) > before
        for left in read.left:
            self._left(left, True)

    def _wrong(self, wrong: NotUnderstood) -> None:
        self.failed += 1
        hint = wrong.hint
        if wrong.token.kind == "word" and self.failed <= _HINTED:
            hint = did_you_mean(wrong.token.word, self.palette.known) or hint
        self.source.error(wrong.message, hint, wrong.token.span)

    def _begin(self, first: bool, span: Span) -> None:
        """Goes on with the part, or begins another."""
        last = self.parts[-1] if self.parts else None
        title = self.heading is not None and self.title is not None and self.heading.span == self.title[1]
        if last is not None and last.begun() and not (first and (last.last or self.heading)):
            if self.heading is not None and not title:
                self.passed.append(self.heading.span)
                self.heading = None
            last.lines += self.lead
            self.lead = []
            return
        if last is not None and not last.begun():
            self.lead = [*last.lines, *self.lead]
            self.parts.pop()
        found, self.heading, self.mode = self.heading, None, ""
        name = found.name if found is not None else ""
        if not name and self.parts:
            name = f"part_{len(self.parts) + 1}"
            self.source.doubt("rounds begin at 1 again: this is taken for another part", "give it a heading", span)
        taken = {draft.name for draft in self.parts}
        if name in taken:
            name = next(f"{name}_{k}" for k in range(2, len(taken) + 3) if f"{name}_{k}" not in taken)
        draft = Draft(name, found.span if found is not None else span)
        if found is not None:
            draft.copies, draft.copies_span = found.copies, found.copies_span
        draft.lines, self.lead = self.lead, []
        self.parts.append(draft)

    # -- everything else --------------------------------------------------------------------------------------------

    def _text(self, row: Row, tokens: list[Token]) -> None:
        """A line that begins no round."""
        whole = Span(row.start, row.end)
        if not tokens:
            self.passed.append(whole)
            return
        text = self.source.text.text
        if self._said(Span(row.tokens[0].start, row.tokens[-1].end)):
            return
        title = self.title is not None and self.heading is not None and self.heading.span == self.title[1]
        if title and self.heading is not None and self.heading.copies_span is None and tokens[0].word not in OPEN:
            self.heading = None  # what stands over the whole pattern names no part
        new = definition(tokens)
        if new is not None and new[1] in self.source.stitches:
            self.vocabulary.define(new[0].word, new[1])
            self.passed.append(whole)
            return
        line = text[row.tokens[0].start : row.tokens[-1].end]
        shade = self._named_color(tokens)
        said = stated(text, row, tokens)
        for key, words, span in said:
            self.stated.setdefault(key, (words, span))
        if said or shade:
            return
        if self.parts and self.phrases.finishing(line) is not None:
            self.sentences.append(Sentence(row.tokens, tokens, self.parts[-1].name))
            return
        first = tokens[0]
        names = [t for t in tokens if t.kind != "mark"]
        if len(names) <= 3 and first.kind == "key" and first.value in MODES:
            self.mode = MODES[first.value]
            self.heading = None
            self.passed.append(whole)
            return
        found = self._copied(row, line) or heading(text, row, tokens)
        lefts: list[list[Token]] = []
        if (found is None or not found.marked) and self._sentences(tokens, lefts):
            found = None
            for left in lefts:
                self._left(left, False)
            return
        if found is not None and not (self.mode in ("materials", "abbreviations", "notes") and not found.strong):
            if self.title is None:
                self.title = (text[found.span.start : found.span.end], found.span)
                self.heading = found if found.strong else None
            else:
                self.heading = found
            if found.copies > 1 and found.name == "":
                self.heading = None
            return
        if self.title is None and names:
            end = next((t.start for t in row.tokens if t.word in (".", ":")), row.end)
            self.title = (text[row.tokens[0].start : end].strip(), Span(row.tokens[0].start, end))
        else:
            self.passed.append(whole)
        for left in lefts:
            self._left(left, False)

    def _said(self, span: Span) -> bool:
        """A line that is one of the writer's own sentences: of colour, of seams, of the end."""
        text = self.source.text.text[span.start : span.end]
        own = explained(text, self.source.stitches, self.phrases.terms) if not self.parts else []
        for new in own:
            self.source.stitches[new.name], self.source.own[new.name] = new, span
            self.vocabulary.define(new.name, new.name)
        if own:
            return True
        item = self.phrases.item(text)
        if item is None:
            return False
        line = Line((Action(item[0], span, 1, None, item[1], item[2]),), span, False)
        if item[0] == "color":
            self.lead.append(line)
        elif item[0] in ("sew", "fo", "mark", "goto") and self.parts:
            draft = self.parts[-1]
            draft.lines += [*self.lead, line]
            self.lead = []
            draft.ends = "open" if item[0] == "fo" else draft.ends  # it is closed here already
            draft.edge = None if item[0] == "goto" else draft.edge
        else:
            return False
        return True

    def _copied(self, row: Row, line: str) -> Heading | None:
        """A heading that says its copies as the table of terms does: ``Arm (make 2)``."""
        mark = line.rfind("(")
        said = self.phrases.read(line[mark:], ("copies",)) if mark > 0 else None
        name = plain_name(line[:mark].strip()) if said is not None else ""
        if said is None or not name:
            return None
        span = Span(row.tokens[0].start, row.tokens[-1].end)
        return Heading(name, span, max(1, said[1]["count"]), span, True, True)

    def _named_color(self, tokens: list[Token]) -> bool:
        """``A = brown``, ``Color B: white``, ``Main color (MC): cream``; whether the line says such."""
        found = False
        for k in range(len(tokens) - 2):
            at = k + 1 + (tokens[k + 1].word == ")")
            if tokens[k].kind not in ("word", "key") or len(tokens[k].word) > 2 or at + 1 >= len(tokens):
                continue
            shade = self.palette.color(Cursor(tokens, at + 1)) if tokens[at].word in ("=", ":", "-") else None
            if shade is not None:
                self.palette.given.setdefault(tokens[k].word, shade[0])
                found = True
        return found

    def _sentences(self, tokens: list[Token], lefts: list[list[Token]]) -> bool:
        """Reads what instructions a line of text holds; whether there were any. What was not read goes to ``lefts``."""
        any_read = False
        begin = 0
        for at in range(len(tokens) + 1):
            if at < len(tokens) and tokens[at].word not in (".", "!", "?", ";"):
                continue
            sentence = tokens[begin:at]
            begin = at + 1
            if sentence and self._sentence(sentence):
                any_read = True
            elif sentence:
                lefts.append(sentence)
        return any_read

    def _sentence(self, tokens: list[Token]) -> bool:
        """One sentence outside rounds; whether it was understood."""
        if self.parts and finishes(raw := self._raw(tokens), tokens):
            self.sentences.append(Sentence(raw, tokens, self.parts[-1].name))
            return True
        text = self.source.text.text[tokens[0].start : tokens[-1].end]
        said = self.phrases.read(text, (*_PART, "stuff factor", "up start", "up end"))
        draft = self.parts[-1] if self.parts else None
        if said is not None and draft is not None:
            key, fields = said
            if key in _PART:
                draft.stuffing = STUFFING[_PART[key]]
            elif key == "stuff factor":
                draft.stuffing = fields["factor"]
            else:
                draft.up = key.removeprefix("up ")
            return True
        stuffing = self._stuffing(tokens)
        if stuffing is not None and draft is not None:
            if stuffing >= 0:
                draft.stuffing = stuffing
            return True
        if self.mode in ("materials", "abbreviations", "notes", "assembly"):
            return False
        if any(t.kind == "key" and t.value == "not" for t in tokens):
            return False
        try:
            body = decided(self.source, tokens, self.palette, draft.edge if draft else None, self.phrases)
        except NotUnderstood:
            return False
        if body.left or not (body.items or body.ends or body.refers):
            return False
        if body.items and all(isinstance(i, Action) and i.name == "color" for i in body.items):
            if not any(t.kind == "key" and t.value in ("color", "with", "begin", "in", "join") for t in tokens):
                return False
            self.lead.append(Line(tuple(body.items), Span(tokens[0].start, tokens[-1].end), False))
            return True
        span = Span(tokens[0].start, tokens[-1].end)
        starts = any((isinstance(i, Action) and i.name in ("mr", "ch")) or _ring(i) for i in body.items)
        if draft is None and not starts:
            return False
        if starts and (draft is None or self.heading is not None):
            self._begin(True, span)
        elif draft is not None and self.lead:
            draft.lines += self.lead
            self.lead = []
        draft = self.parts[-1]
        draft.add(self.source, None, body, span)
        self.understood += any(t.kind == "stitch" for t in tokens) and len(tokens) > 1
        return True

    def _raw(self, tokens: list[Token]) -> list[Token]:
        """The same words as they were written."""
        begin, end = tokens[0].start, tokens[-1].end
        first = self.row_at
        return [
            t for row in self.rows[first : first + _WRAPPED] for t in row.tokens if begin <= t.start and t.end <= end
        ]

    def _stuffing(self, tokens: list[Token]) -> float | None:
        """How much a sentence wants the part stuffed; -1 when it says only that it is."""
        if not any(t.kind == "key" and t.value == "stuff" for t in tokens) or len(tokens) > 14:
            return None
        if any(t.kind == "stitch" for t in tokens):
            return None
        for word, amount in (("not", "none"), ("light", "light"), ("medium", "medium"), ("firm", "firm")):
            if any(t.kind == "key" and t.value == word for t in tokens):
                return STUFFING[amount]
        return -1.0

    def _left(self, tokens: list[Token], in_round: bool) -> None:
        """A sentence that was not read: a doubt when it looks like instructions, else it is passed over."""
        span = Span(tokens[0].start, tokens[-1].end)
        words = [t for t in tokens if t.kind != "mark"] or tokens
        known = sum(t.kind in ("stitch", "number", "ordinal", "key") for t in words)
        stitches = sum(t.kind == "stitch" for t in words)
        blocked = self.mode in ("materials", "abbreviations", "notes")
        begins = words[0].kind == "stitch" or (
            words[0].kind == "number" and len(words) > 1 and words[1].kind == "stitch"
        )
        likely = known * 2 >= len(words) if begins else known * 4 >= len(words) * 3
        if stitches and known >= 3 and likely and self.parts and not blocked:
            self.source.doubt(NOT_UNDERSTOOD, "say it as in the other rounds, or leave it out", span)
        elif in_round:
            self.passed.append(span)


def _names(line: Line) -> list[str]:
    return [i.name for i in line.items if isinstance(i, Action)]


def _ring(item: object) -> bool:
    return isinstance(item, Action) and item.name.startswith("MR{")


def _place(problem: Problem) -> int:
    return problem.span.start if problem.span else 0
