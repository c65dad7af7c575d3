"""Printed patterns: the text of a pattern as people write it → the same tree that tambour's own language gives."""

from __future__ import annotations

from typing import Final

from tambour.core.errors import Problem, Span, TambourError, Text, did_you_mean
from tambour.crochet.language.finishes import GUESSED, check_names
from tambour.crochet.language.source import Source
from tambour.crochet.language.tree import Action, Line, Pattern
from tambour.crochet.printed.assembly import UNPLACED, assembled, told, with_places
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.doubts import decided
from tambour.crochet.printed.heads import Head, heads
from tambour.crochet.printed.prose import WRAPPED, left_over, text_line
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.phrases import Phrases

NOTHING: Final = "this holds no crochet instructions"
_LINES = 100  # lines of other text to a round of one that is a pattern at all
_HINTED = 20  # errors that suggestions are looked for
_LONG = 50  # characters of a line that was broken


def read_printed(text: Text, *, max_stitches: int = 200_000, strict: bool = False, usual: bool = True) -> Pattern:
    """The pattern that a printed text says (docs/crochet-printed.md, "Patterns as people write them").

    usual : parts that no sentence places go where such parts usually do, which is told as a doubt

    Raises TambourError with every problem of the text; with one line when it holds no crochet instructions.
    """
    return Printed(Source(text, strict)).pattern(max_stitches, usual)


class Printed(State):
    """Goes through the lines of a text, top to bottom."""

    def pattern(self, max_stitches: int, usual: bool = True) -> Pattern:
        """The whole text read."""
        at = 0
        while at < len(self.rows):
            at = self._row(at)
        source = self.source
        worded = sum(bool(row.tokens) for row in self.rows)
        lost = self.failed > 3 * self.understood or (self.failed and worded > _LINES * self.understood)
        if not self.understood or lost:
            hint = "a round looks like this: Rnd 1: 6 sc in magic ring (6)"
            raise TambourError(NOTHING, hint=hint, where=source.text.name)
        if self.lead and self.parts:
            self.parts[-1].lines += self.lead
        if self.sentences and self.parts and not self.parts[0].name:
            taken = {draft.name.lower() for draft in self.parts}
            self.parts[0].name = "piece" if len(self.parts) == 1 or "body" in taken else "Body"  # sentences want a name
        sections = tuple(draft.section(source) for draft in self.parts)
        self._colors_told()
        if all(p.warning for p in source.problems):
            plain = Pattern(source.text, sections, source.stitches, max_stitches=max_stitches,
                            terms=self.language.code, stated=self.stated)  # fmt: skip
            sections = self._assemble(plain, usual).parts
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

    def _assemble(self, pattern: Pattern, usual: bool) -> Pattern:
        """The pattern with what the sentences of finishing say, now that the parts are there."""
        source = self.source
        copies = {part.name: part.copies for part in pattern.parts}
        phrases = Phrases(self.phrases.terms, copies, {k.upper(): rgb for k, rgb in self.palette.given.items()})
        found = assembled(pattern, self.sentences, phrases, self.palette, usual)
        if found is None:
            return pattern  # the build tells what is wrong with the rounds
        for span in found.lost:
            hint = "say the part and the round: sew the ears to the head between Rnds 5 and 6, 8 sts apart"
            source.doubt(UNPLACED, hint, span)
        if found.guessed:
            hint = "say the rounds, and how many stitches apart, to have them elsewhere"
            source.doubt(f"{GUESSED}: {told(found)}", hint, Span(0, 0))
        source.finish += found.finish
        check_names(source, copies, source.finish)
        return with_places(pattern, found)

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
            while end < len(self.rows) and end - at < WRAPPED and self._wrapped(self.rows[end - 1], self.rows[end]):
                tokens += self.vocabulary.read(self.rows[end].tokens)
                row = Row([*row.tokens, *self.rows[end].tokens], row.start, self.rows[end].end, row.marked)
                end += 1
            text_line(self, row, tokens)
            return end
        at += 1
        while at < len(self.rows) and (more := self._goes_on(tokens, self.rows[at])) is not None:
            tokens += more
            at += 1
        if not found[0][1].strong and not self._instructs(tokens[found[0][1].end :]):
            text_line(self, row, tokens)
            return at
        for k, (begin, head) in enumerate(found):
            if k == 0 and begin > 0:
                text_line(self, row, tokens[:begin])
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
        known = sum(t.kind in ("stitch", "number", "ordinal", "key") for t in words)
        return any(t.kind == "stitch" for t in words) and known * 3 >= len(words) * 2

    def _round(self, head: Head, tokens: list[Token], whole: list[Token]) -> None:
        """A round that has a head."""
        span = Span(whole[0].start, whole[-1].end)
        self.begin(head.numbers[0] == 1 if head.numbers else False, span)
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
            left_over(self, left, True)

    def _wrong(self, wrong: NotUnderstood) -> None:
        self.failed += 1
        hint = wrong.hint
        if wrong.token.kind == "word" and self.failed <= _HINTED:
            hint = did_you_mean(wrong.token.word, self.palette.known) or hint
        self.source.error(wrong.message, hint, wrong.token.span)


def _names(line: Line) -> list[str]:
    return [i.name for i in line.items if isinstance(i, Action)]


def _place(problem: Problem) -> int:
    return problem.span.start if problem.span else 0
