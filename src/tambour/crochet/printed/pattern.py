"""Printed patterns: the text of a pattern as people write it → the same tree that tambour's own language gives."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Problem, Span, TambourError, Text
from tambour.crochet.graph.built import Built
from tambour.crochet.language.finishes import ASIDE, GUESSED, check_names
from tambour.crochet.language.source import Source
from tambour.crochet.language.tree import Again, Line, Pattern
from tambour.crochet.places.empty import empty
from tambour.crochet.places.halves import joined as halved
from tambour.crochet.places.onward import joined, worked_on
from tambour.crochet.places.toy import Assembled
from tambour.crochet.places.tubes import closed
from tambour.crochet.printed.between.assembly import UNPLACED, assembled, eyes_listed, told, with_places
from tambour.crochet.printed.between.conventions import in_loops
from tambour.crochet.printed.between.dyed import colors_told, yarns_told
from tambour.crochet.printed.between.lines import goes_on, rounds, stop_between, wrapped
from tambour.crochet.printed.between.opening import alone, founds, opening
from tambour.crochet.printed.between.prose import WRAPPED, text_line
from tambour.crochet.printed.between.spoken_of import remedy, spoken_of
from tambour.crochet.printed.between.unseen import unseen_told
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.headed import Headed
from tambour.crochet.printed.heads import STARS, Head, heads
from tambour.crochet.printed.parts import pairs
from tambour.crochet.printed.parts.accounted import beside, headed
from tambour.crochet.printed.parts.bases import UNKNOWN
from tambour.crochet.printed.parts.crocheted import hang
from tambour.crochet.printed.parts.formed import complete
from tambour.crochet.printed.parts.hued import by_hue, layered
from tambour.crochet.printed.parts.hung import hang_on
from tambour.crochet.printed.parts.mend import Found, agreed, mended
from tambour.crochet.printed.parts.naming import nameless_is
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.parts.resumed import resume
from tambour.crochet.printed.sheet.notes import Heading, plain_name
from tambour.crochet.printed.state import Height, plain_height
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.unheaded import unheaded
from tambour.crochet.printed.yarns.colors import dyeing
from tambour.crochet.words.phrases import Phrases
from tambour.crochet.words.table import TERMS

NOTHING: Final = "this holds no crochet instructions"
_TAIL: Final = re.compile(r"\s*(?:[(\[][^()\[\]]{2,30}[)\]]|[-–—|]\s*\w+ \w+)\s*$")  # "(UK terms)", "- US terms"
_ELSEWHERE: Final = "say the rounds, and how many stitches apart, to have them elsewhere"
_ON: Final = frozenset("edging border trim ribbing ruffle hem shaping".split())
"""What a piece goes on with at its last round, unless it says another place."""
_WHICH: Final = frozenset("next last each first same rest other".split())
_LINES = 100  # lines of other text to a round of one that is a pattern at all
_HOPELESS = 12  # rounds that were not understood to one that was
_LAST: Final = dict.fromkeys(("previous", "prev", "preceding"), "last")  # "of previous rnd"


def read_printed(
    text: Text,
    *,
    max_stitches: int = 200_000,
    strict: bool = False,
    usual: bool = True,
    high: Height = plain_height,
) -> Pattern:
    """The pattern that a printed text says (docs/crochet-printed.md, "Patterns as people write them").

    usual : parts that no sentence places go where such parts usually do, which is told as a doubt

    Raises TambourError with every problem of the text; with one line when it holds no crochet instructions.
    """
    return Printed(Source(text, strict), high).pattern(max_stitches, usual)


class Printed(Headed):
    """Goes through the lines of a text, top to bottom."""

    def pattern(self, max_stitches: int, usual: bool = True) -> Pattern:
        """The whole text read."""
        at = 0
        while at < len(self.rows):
            at = self._row(at)
        source = self.source
        for said in source.text.told:
            source.doubt(said, "accept or reject the changes in the document to have it otherwise", Span(0, 0))
        worded = sum(bool(row.tokens) for row in self.rows)
        lost = self.failed > _HOPELESS * self.understood or (self.failed and worded > _LINES * self.understood)
        if not self.understood or lost:
            hint = "a round looks like this: Rnd 1: 6 sc in magic ring (6)"
            raise TambourError(NOTHING, hint=hint, where=source.text.name)
        if self.lead and self.parts:
            self.parts[-1].lines += self.lead
        self.parts = [draft for draft in self.parts if draft.begun() and not draft.merged]
        if (self.sentences or len(self.parts) > 1) and self.parts and not self.parts[0].name:
            words = [self.source.text.text[one.span.start : one.span.end] for one in self.sentences]
            nameless = self.parts[0]  # sentences want a name
            nameless.name, copies = nameless_is([draft.name for draft in self.parts[1:]], words)
            nameless.copies = max(nameless.copies, copies)
        for draft in pairs.alone(self.parts, source.text.text):
            draft.copies = 2
            source.doubt(f"{GUESSED}: two of {draft.name} are made", "say how many: (make 2), or (make 1)", draft.span)
        above: list[Line] = []
        for draft in self.parts:
            draft.lines = beside(self, draft)
            headed(self, draft)
            self.palette.wear(draft.worn)
            draft.lines[:0] = dyeing(draft.lines, draft.span, self.palette, self.source.text.text, above)
            above = draft.lines
        sections = tuple(
            one
            for draft in self.parts
            for one in by_hue(draft.section(source), self.hued.get(draft.span.start, ()) if draft.copies > 1 else ())
        )
        self.palette.wear(0)  # finishing, at the end of the text, speaks of all toys
        colors_told(self)
        pattern = Pattern(
            source.text,
            sections,
            source.stitches,
            max_stitches=max_stitches,
            terms=self.language.code,
            stated=self.stated,
        )
        built = None
        if all(p.warning for p in source.problems):
            found = Found(self.sound)
            pattern, built = mended(pattern, found)
            if built is not None:
                pattern, built = agreed(pattern, built, self.sound, self._not_read(), found)
            last = {
                problem.span: problem for problem in found.unread
            }  # of a round that is mended twice, what became of it
            for problem in [one for one in found.unread if one is last[one.span]]:
                self.tell(problem.message, problem.hint, problem.span or Span(0, 0))
            for problem in found.doubts:
                source.doubt(problem.message, problem.hint, problem.span or Span(0, 0))
            if built is not None:
                built = worked_on(halved(closed(built)))
                known = [line.span for k in joined(built) for line in pattern.parts[k].lines]
                source.problems = [  # an edge that is found after all
                    p for p in source.problems if not (p.message.startswith(UNKNOWN) and p.span in known)
                ]
                pattern = self._assemble(pattern, built, usual)
                yarns_told(self, pattern)
                unseen_told(self, pattern, tuple(source.finish), [*self.lost, *self.more])
        errors = [p for p in (*source.problems, *self.unread) if not p.warning]
        if errors:
            raise TambourError(sorted(errors, key=_place))
        if self.title is not None:
            self.stated.setdefault("title", (_untermed(self.title[0], self.language.code), self.title[1]))
        self.stated |= {key: told for key, told in self.hinted.items() if key not in self.stated}
        return replace(
            pattern,
            own=source.own,
            warnings=tuple(sorted(source.problems, key=_place)),
            finish=tuple(source.finish),
            stated=self.stated,
            passed=tuple(self.passed),
            unread=tuple(sorted(self.unread, key=_place)),
            left_out=tuple(self.left_out),
            letters=self.palette.letters,
            built=built,
        )

    def _not_read(self) -> list[Span]:
        """Where something that may work stitches was not understood."""
        return [*self.left_out, *(p.span for p in self.unread if p.span is not None)]

    def _assemble(self, pattern: Pattern, built: Built, usual: bool) -> Pattern:
        """The pattern with what the sentences of finishing say, now that the parts are there."""
        source = self.source
        copies = {part.name: part.copies for part in pattern.parts}
        given = {k.upper(): rgb for k, rgb in self.palette.given.items()}
        phrases = Phrases(self.phrases.terms, copies, given, self.phrases.hues)
        found = assembled(
            built,
            self.sentences,
            phrases,
            self.palette,
            usual,
            [*hang(built, self.held), *hang_on(built, self.hung), *layered(built)],
            {draft.name: draft.over for draft in self.parts},
        )
        if found is None:
            return with_places(pattern, Assembled(unstuffed=empty(built, ()))) if usual else pattern
        usually, found.finish = spoken_of(self, pattern, found.finish)
        self.lost = [s for s in found.lost if not any(s.start < at.end and at.start < s.end for at in usually.values())]
        self.more = found.more
        for span in self.lost:
            source.doubt(UNPLACED, remedy(pattern, span), span)
        for name, span in usually.items():
            where = [words for part, words in found.guessed if part == name]
            source.doubt(f"{GUESSED}: {'; '.join(dict.fromkeys(where)) or name}", _ELSEWHERE, span)
        found.guessed = [one for one in found.guessed if one[0] not in usually]
        if found.guessed:
            source.doubt(f"{GUESSED}: {told(found)}", _ELSEWHERE, self._named(found.guessed[0][0]))
        hint = "say where they are sewn: sew the part to the body between rounds 5 and 6"
        if found.apart:
            source.doubt(f"{ASIDE}: {', '.join(found.apart)}", hint, self._named(found.apart[0]))
        if found.behind:
            hidden = f"pieces that lie behind others like them are not shown: {', '.join(found.behind)}"
            hint = "they are worked and counted: work through both layers as the text says"
            source.doubt(hidden, hint, self._named(found.behind[0]))
        for record in found.finish:
            # What is guessed wrongly is told, and does not refuse the whole text.
            trial = Source(source.text, source.strict)
            check_names(trial, copies, [record])
            wrong = [p for p in trial.problems if not p.warning]
            for problem in wrong:
                self.tell(problem.message, problem.hint, problem.span or Span(0, 0))
            source.finish += [] if wrong else [record]
        found.unstuffed += empty(built, source.finish) if usual else []
        return with_places(pattern, found)

    def _named(self, name: str) -> Span:
        """Where the text speaks of what was guessed first: the heading of that part, or the list's eyes."""
        if listed := eyes_listed(self.source.text.text) if name == "eyes" else "":
            at = self.source.text.text.index(listed)
            return Span(at, at + len(listed))
        return next((draft.span for draft in self.parts if draft.name == name), Span(0, 0))

    # -- lines ------------------------------------------------------------------------------------------------------

    def _row(self, at: int) -> int:
        """One line, with those that go on with it; gives the next."""
        row = self.rows[at]
        self.row_at = at
        if not row.tokens:
            return at + 1
        tokens = self.vocabulary.read(row.tokens)
        found = heads(tokens, self.source.text.text)
        if not found or complete(self.source.text.text[row.start : row.end]):
            end = at + 1
            while end < len(self.rows) and end - at < WRAPPED and wrapped(self, self.rows[end - 1], self.rows[end]):
                tokens += self.vocabulary.read(self.rows[end].tokens)
                row = Row([*row.tokens, *self.rows[end].tokens], row.start, self.rows[end].end, row.marked)
                end += 1
            begin = unheaded(self, row, tokens)
            if begin:
                self._between(row, tokens[:begin])
            if begin is None:
                text_line(self, row, tokens)
            else:
                body = tokens[begin:]
                number = () if self.heading is None else (1,)
                self._round(Head(number, Span(body[0].start, body[0].end), 0, False, True), body, body)
            return end
        at += 1
        while at < len(self.rows) and (more := goes_on(self, tokens, at)) is not None:
            tokens += [*stop_between(self, tokens, at), *more]
            at += 1
        if not found[0][1].strong and not rounds(tokens[found[0][1].end :], self.mode == "assembly"):
            text_line(self, row, tokens)
            return at
        if not found[0][1].strong:
            self.mode = ""  # a bow that is made among the steps: "1. 6 sc in ring"
        ended = 0
        for k, (begin, head) in enumerate(found):
            name = tokens[ended:begin]
            if k and head.numbers[:1] == (1,) and alone(name):
                span = Span(name[0].start, name[-1].end)
                self.heading = Heading(
                    plain_name(self.source.text.text[span.start : span.end]), span, 1, None, True, True
                )
            elif name:
                self._between(row, name)
            end = found[k + 1][0] if k + 1 < len(found) else len(tokens)
            last = k + 1 == len(found)
            if founds(self, at) if last else found[k + 1][1].numbers[:1] == (1,):
                end = self._opens(tokens, head.end, end)
            ended = end
            self._round(head, tokens[head.end : end], tokens[begin:end])
        if ended < len(tokens):
            self._between(row, tokens[ended:])  # "… for sewing. EAR (make 2) With A, ch 2.", and a first round below it
        return at

    def _between(self, row: Row, tokens: list[Token]) -> None:
        """Words of a line before a round, or between two."""
        raw = [t for t in row.tokens if tokens[0].start <= t.start and t.end <= tokens[-1].end] or tokens
        text_line(self, Row(raw, raw[0].start, raw[-1].end, row.marked), tokens)

    def _opens(self, tokens: list[Token], begin: int, end: int) -> int:
        """Where in the body of a round the sentences begin that open the next part; its end where none do."""
        at = begin
        while at < end:
            sentence = tokens[at : self._stop(tokens, at, end)]
            if opening(self.source.text.text, sentence) is not None or (at > begin and alone(sentence)):
                return at
            at = self._stop(tokens, at, end) + 1
        return end

    def _stop(self, tokens: list[Token], at: int, end: int) -> int:
        """Where the sentence at ``at`` stops."""
        return next((k for k in range(at, end) if tokens[k].word in (".", "!")), end)

    def _round(self, head: Head, tokens: list[Token], whole: list[Token]) -> None:
        """A round that has a head."""
        if self.mode not in ("materials", "abbreviations") and in_loops(self, whole):
            self.passed.append(Span(whole[0].start, whole[-1].end))
            return  # "Rounds 3-5 are worked in back loops only"
        span = Span(whole[0].start, whole[-1].end)
        starred = whole[0].word if whole[0].word in STARS else ""
        ended = [t for k, t in enumerate(tokens) if t.word in STARS and _ends_line(tokens, k)]
        tokens = [t for t in tokens if t not in ended]
        if any(t.kind == "key" and t.value == "join" for t in whole[1:3]) and self.parts:
            head = replace(head, numbers=())  # "1st joining rnd" goes on with what is there
        tokens = _counted_off(head, tokens)
        resume(self, head, span.start)
        head = self._part_of(head, tokens, span)
        draft = self.parts[-1]
        wants = self.ringed is not None and head.numbers[:1] == (1,) and not draft.begun()
        if self.ringed is not None and wants and not any(t.value in ("ring", "hook", "loop") for t in tokens):
            if len(tokens) > 2 and tokens[1].kind == "stitch" and tokens[2].value == "around":
                tokens = [*tokens[:2], *tokens[3:]]  # "6 sc in the round"
            if len(tokens) > 2 and tokens[0].kind == "stitch" and tokens[1].word == "x" and tokens[2].kind == "number":
                tokens = [tokens[2], tokens[0], *tokens[3:]]  # "sc x 6"
            tokens = [
                self.ringed,
                Token("mark", ",", head.span.end, head.span.end),
                *tokens,
            ]  # "Magic ring" on its own line
        self.ringed = None
        if starred or self.starred:
            draft.marks.append((starred or self.starred, 0 if self.starred and not draft.last else len(draft.lines)))
            self.starred = ""
        if head.extra and all(t.kind == "word" for t in head.extra) and self._plain(head.extra):
            self.passed.append(Span(head.extra[0].start, head.extra[-1].end))
            head = replace(head, extra=())  # "Row 20 (Ruffle):"
        body = [*head.extra, Token("mark", ",", head.span.end, head.span.end), *tokens] if head.extra else tokens
        if self.tied is not None:
            body, self.tied = [self.tied, Token("mark", ",", span.start, span.start), *body], None
        self.source.last_number = draft.last or None
        self._others(draft, head)
        before = len(draft.lines)
        self.ended = [t.word for t in ended]
        self.worked(draft, head, body, span)
        if head.other and len(draft.lines) > before and head.numbers:
            draft.others = (head.numbers[-1], draft.lines[-1])
        self.end_marks(draft)

    def _plain(self, words: tuple[Token, ...]) -> bool:
        """Whether words name no yarn."""
        c = Cursor(list(words))
        return all(self.palette.color(c, k) is None and self.palette.letter(c, k) is None for k in range(len(words)))

    def _part_of(self, head: Head, tokens: list[Token], span: Span) -> Head:
        """Begins the part that a head begins; its numbers go on where they only begin at 1 again."""
        last = self.parts[-1] if self.parts else None
        first = head.numbers[:1] == (1,)
        ringed = last is not None and last.ringed()
        if (
            first
            and self.hanging is None
            and last is not None
            and last.last
            and (last.off is None or (self.heading is None and _rejoins(tokens, last.last - last.offset)))
            and (last.edge or 0) > 2
            and self.ringed is None  # "Start with a magic ring. R1: 8 sc" is another piece
            and not _starts(tokens, ringed, self.heading is None)
            and (self.heading is None or not _back_along(tokens) or _goes_on(self.heading))
            and (self.heading is None or not self.heading.marked or _goes_on(self.heading))
        ):
            self.heading = None
            last.offset, first = 0 if ringed else last.last, False
            last.last = 0 if ringed else last.last
        self.begin(first, span)
        draft = self.parts[-1]
        if (
            draft.offset
            and head.numbers
            and (head.numbers[0] <= draft.offset or head.numbers[0] + draft.offset == draft.last + 1)
            and head.numbers[0] + draft.offset > draft.last
        ):
            return replace(head, numbers=tuple(n + draft.offset for n in head.numbers))
        return head

    def _others(self, draft: Draft, head: Head) -> None:
        """Works the rounds that "and every other round" means, up to the one that comes next."""
        if draft.others is None or not head.numbers:
            return
        number, line = draft.others
        if head.numbers[0] == draft.last + 2 and (draft.last + 1 - number) % 2 == 0:
            again = Again((replace(line, times=1),), number, number, "", line.span)
            draft.lines.append(Line((), line.span, True, 1, None, draft.last + 1, None, None, again))
            draft.last += 1
        elif head.numbers[0] <= draft.last:
            draft.others = None


def _ends_line(tokens: list[Token], k: int) -> bool:
    """Whether asterisks at ``k`` stand between sentences, where a reference may name them."""
    before, after = tokens[k - 1] if k else None, tokens[k + 1] if k + 1 < len(tokens) else None
    named = before is not None and before.kind == "key" and before.value in ("from", "to", "as")
    words = " ".join(t.word for t in tokens[k + 1 :]) if not named and tokens[k].word == "**" else ""
    named = named or "* to **" in words.replace("** to **", "")  # "*… .** … rep from * twice, then from * to ** once"
    return not named and (after is None or before is None or before.word in (".", ")", "]"))


def _goes_on(heading: Heading) -> bool:
    """Whether a heading only names what the piece under way goes on with: "Top edging:", "Shape top:"."""
    words = re.findall(r"[^\W\d_]+", heading.name.lower())
    return heading.copies == 1 and bool(words) and (words[-1] in _ON or words[0] == "shape")


def _starts(tokens: list[Token], ringed: bool, unheaded: bool) -> bool:
    """Whether words begin a piece of work: in a ring, in a chain or, where no ring was ``ringed`` already, as another part; of work that is
    ``unheaded`` "same" may say where a stitch goes."""
    starts = ("ring", "loop", "hook", "foundation") if ringed else ("ring", "loop", "hook", "foundation", "as", "same")
    yarn = {
        k + 1 for k, t in enumerate(tokens) if t.kind == "key" and t.value in ("with", "join", "color")
    }  # "With MC"
    here = {k for k, t in enumerate(tokens[:-1]) if unheaded and t.value == "same" and _place_of_work(tokens[k + 1])}
    here |= {n for k in here for n in range(k + 2, k + 4) if n < len(tokens) and tokens[n].value == "as"}
    return any(t.kind == "key" and t.value in starts and k not in yarn | here for k, t in enumerate(tokens))


def _back_along(tokens: list[Token]) -> bool:
    """Whether words make a chain and work back along it: "ch 6, 5 sc (5)" makes as many as a chain of six gives."""
    said = [t for t in tokens if t.kind != "mark" or t.word not in ",.;"]
    if len(said) == 2 and any(t.value == "ch" for t in said):
        return any(t.kind == "number" and t.value > 3 for t in said)  # "Rnd 1: ch 6"
    begun = next((k for k, t in enumerate(said) if t.kind == "stitch"), 0)
    said = said[begun - (begun > 0 and said[begun - 1].kind == "number") :]  # behind "With red yarn,"
    if len(said) < 5 or (
        {said[0].value, said[1].kind} != {"ch", "number"} and {said[1].value, said[0].kind} != {"ch", "number"}
    ):
        return False
    many = said[0].value if said[0].kind == "number" else said[1].value
    if many > 3 and any(t.value == "ch" and _into(said, k) for k, t in enumerate(said) if k > 1):
        return True  # "ch 10, sl st in next 3 ch, …", "… along the other side of the ch"
    last = said[-2] if said[-1].word in (")", "]") else said[-1]
    return many > 3 and last.kind == "number" and many - 2 <= last.value < many


def _into(tokens: list[Token], k: int) -> bool:
    """Whether the chain at ``k`` is what is worked into, or along: "in next 3 ch", "in last ch", "other side of ch"."""
    at = k - 1
    while at > 0 and (
        tokens[at].kind in ("number", "ordinal") or tokens[at].value in _WHICH or tokens[at].word == "of"
    ):
        at -= 1
    return tokens[at].value in ("in", "side") and not any(t.value == "space" for t in tokens[k + 1 : k + 3])


def _place_of_work(token: Token) -> bool:
    """Whether "same" before a word says where a stitch goes, and names nothing that is worked again: "in same sp as sl st", "of same row"."""
    return (
        token.kind == "stitch"
        or token.value in ("stitch", "space", "row", "round", "loop", "ch")
        or token.word == "place"
    )


def _rejoins(tokens: list[Token], number: int) -> bool:
    """Whether words join yarn to the round that was fastened off, the last one or its ``number``: "Join A to back loop of 9th sc of last rnd",
    "Join A in any st"."""
    end = next((k for k, t in enumerate(tokens) if t.word in (".", ";")), len(tokens))
    said = [_LAST.get(t.word, t.value) for t in tokens[:end]]
    if "join" not in said:
        return False
    named = {("last", r) for r in ("round", "row")} | {
        ("round", number),
        ("row", number),
        (number, "round"),
        (number, "row"),
    }
    if not named.isdisjoint(pairwise(said)):
        return True
    at = next((k for k in range(end) if tokens[k].word == "any"), end)
    clause = tokens[at : next((k for k in range(at, end) if tokens[k].word == ","), end)]
    return len(clause) == 2 and (clause[1].kind == "stitch" or clause[1].value == "stitch")


def _counted_off(head: Head, tokens: list[Token]) -> list[Token]:
    """The body of a round without words that only say again how many rounds its head numbers: "Rnds 6-8 - sc around (24) - repeat 3 rows"."""
    said = [t for t in tokens if t.kind != "mark" or t.word not in ".;"][-3:]
    again = (
        len(said) == 3 and said[0].value == "repeat" and said[2].value in ("round", "row") and said[1].kind == "number"
    )
    if not again or said[1].value != len(head.numbers) or len(head.numbers) < 2:
        return tokens
    at = tokens.index(said[0])
    return tokens[: at - (at > 0 and tokens[at - 1].word in ("-", ","))]


def _untermed(title: str, code: str) -> str:
    """A title without the terms that it is written in, which are no name: "Pete (UK terms)"."""
    tail = _TAIL.search(title)
    if tail is None or not {*TERMS[code].called, code} & set(re.findall(r"\w+", tail[0].lower())):
        return title
    return title[: tail.start()] or title


def _place(problem: Problem) -> int:
    return problem.span.start if problem.span else 0
