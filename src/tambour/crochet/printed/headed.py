"""Printed patterns, a headed round: what its words say is worked, told as an edge that is not drawn, or taken for a gap."""

from __future__ import annotations

from dataclasses import replace
from typing import Final

from tambour.core.errors import Span, did_you_mean
from tambour.crochet.language.stitches import MOST, Stitch
from tambour.crochet.language.tree import Action, Group, Item, Line
from tambour.crochet.printed.between.beyond import again_made, another, edged_again, edging, not_drawn
from tambour.crochet.printed.between.conventions import convention, turned_always
from tambour.crochet.printed.between.put import ended, eyed, finishing, sews, stuffed
from tambour.crochet.printed.between.remarks import remark
from tambour.crochet.printed.between.unread import NOT_UNDERSTOOD, instructs
from tambour.crochet.printed.cursor import NotUnderstood
from tambour.crochet.printed.heads import Head
from tambour.crochet.printed.parts.alongside import bordered
from tambour.crochet.printed.parts.anew import anew
from tambour.crochet.printed.parts.bases import MOST as _MOST
from tambour.crochet.printed.parts.bases import base, based, elsewhere, frilled, is_first
from tambour.crochet.printed.parts.bridged import over_two
from tambour.crochet.printed.parts.counted import count_in
from tambour.crochet.printed.parts.crocheted import crocheted_in
from tambour.crochet.printed.parts.established import established
from tambour.crochet.printed.parts.formed import worked_in
from tambour.crochet.printed.parts.hung import on_loops
from tambour.crochet.printed.parts.lengthened import lengthened
from tambour.crochet.printed.parts.mend import is_start
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.parts.redyed import worn
from tambour.crochet.printed.parts.reworked import again, allotted
from tambour.crochet.printed.parts.stripes import lay, planned, unsaid, without
from tambour.crochet.printed.rounds.doings import works
from tambour.crochet.printed.rounds.doubts import decided, tried
from tambour.crochet.printed.rounds.items import EVENED, evens
from tambour.crochet.printed.rounds.items import works as works_some
from tambour.crochet.printed.rounds.motifs import chained
from tambour.crochet.printed.rounds.moved import Moved
from tambour.crochet.printed.rounds.otherwise import two_sided
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import worked as stitches_of
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token

_HINTED: Final = 20  # errors that suggestions are looked for


def _into_first(tokens: list[Token], chain: int | None) -> list[Token]:
    """A round into the first of two chains, "6 sc in first chain", as it is usually said: in the 2nd chain from the hook."""
    for k in range(len(tokens) - 2 if chain == 2 else 0):
        into, first, ch = tokens[k : k + 3]
        after = tokens[k + 3] if k + 3 < len(tokens) else None
        if into.value == "in" and first.value == 1 and ch.value == "ch" and (after is None or after.value != "from"):
            end = ch.end
            said = [
                replace(first, value=2),
                ch,
                Token("key", "from", end, end, "from"),
                Token("key", "hook", end, end, "hook"),
            ]
            return [*tokens[: k + 1], *said, *tokens[k + 3 :]]
    return tokens


def _risen(tokens: list[Token]) -> list[Token]:
    """A row without the chain that it turned with, which is skipped: "skip first ch from hook, 14 sc"."""
    for k in range(len(tokens) - 4):
        said = tokens[k : k + 5]
        if [t.value for t in said] == ["skip", 1, "ch", "from", "hook"]:
            comma = k + 5 < len(tokens) and tokens[k + 5].word == ","
            return [*tokens[:k], *tokens[k + 5 + comma :]]
    return tokens


def _shaped_last(tokens: list[Token]) -> tuple[list[Token], list[Token]] | None:
    """Rounds of which only the last is shaped, "sc in each sc around, decreasing 6 sts evenly in last round", as those before it and as that one."""
    for k in range(1, len(tokens) - 4):
        many = tokens[k + 2]
        if tokens[k].word != "," or tokens[k + 1].value not in ("inc", "dec") or many.kind != "number":
            continue
        at = k + 3 + (tokens[k + 3].value == "in")
        if [t.value for t in tokens[at : at + 2]] in (["last", "round"], ["last", "row"]):
            rest = tokens[at + 2 :]
            return tokens[:k], [*tokens[: k + 3], *rest]
    return None


def _sought(tokens: list[Token]) -> list[Token]:
    """A round without the clause that only says where hands look before they join, "locate last round of sc, join B in any st"; it stands beside."""
    at = next((k for k, t in enumerate(tokens) if t.word in ("locate", "find") and _begins(tokens, k)), None)
    if at is None:
        return tokens
    end = next((k for k in range(at, len(tokens)) if tokens[k].word in (",", ".", ";")), None)
    joins = end is not None and any(t.value == "join" for t in tokens[end:])
    return [*tokens[:at], *tokens[end + 1 :]] if joins and end is not None else tokens


def _begins(tokens: list[Token], k: int) -> bool:
    """Whether a clause begins at ``k``."""
    return k == 0 or tokens[k - 1].word in (",", ".", ";", ":")


def _amid(items: list[Item], stitches: dict[str, Stitch]) -> Action | None:
    """The ring that words of a round seem to make behind stitches worked into the one below: "7 sc, 1 sc in the same stitch as the last sc on
    the circle, (6 sc, inc) x 3"; None for none."""
    begun = False
    for item in items:
        ring = isinstance(item, Action) and (
            item.name == "mr" or (item.name in stitches and stitches[item.name].where == "ring")
        )
        if begun and ring and isinstance(item, Action):
            return item
        begun = begun or (works_some(item) > 0 and not ring)
    return None


class Headed(State):
    """Reads one round that has a head."""

    def end_marks(self, draft: Draft) -> None:
        """Puts the asterisks that end a round behind what it works."""
        draft.marks += [(stars, len(draft.lines)) for stars in self.ended]
        self.ended = []

    def worked(self, draft: Draft, head: Head, tokens: list[Token], span: Span) -> None:
        """The round as its words say, in the stripes that they or a sentence before them plan."""
        worked_in(self, span.start, span.end)
        words = self.source.text.text[span.start : span.end]
        found = planned(
            words, self.palette, draft.lines, max(len(head.numbers), head.many), head.numbers[0] if head.numbers else 0
        )
        if found is not None:
            plan, (begin, end) = found
            place = Span(span.start + begin, span.start + end)
            tokens = without(tokens, place)
            if "alternat" in words[begin:end].lower() and len(head.numbers) < 2 and head.many < 2:
                self.tell(NOT_UNDERSTOOD, "say which stitches are worked in which yarn", place)
        elif draft.plan is not None:
            plan, place = draft.plan
            tokens = unsaid(words, tokens, span.start)
        else:
            self._said(draft, head, tokens, span)
            return
        known = {id(line) for line in draft.lines}
        self._said(draft, head, tokens, span)
        lay(draft, known, plan, place, found is None)

    def _said(self, draft: Draft, head: Head, tokens: list[Token], span: Span) -> None:
        """The round as its words say, or as a gap."""
        several = len(head.numbers) if len(head.numbers) > 1 else head.many
        tokens = self._of_one(_sought(tokens))
        if several > 1 and (cut := _shaped_last(tokens)) is not None:
            those = replace(head, numbers=head.numbers[:-1], many=several - 1 if head.many > 1 else head.many)
            self._said(draft, those, cut[0], Span(span.start, cut[0][-1].end))
            shaped = replace(head, numbers=head.numbers[-1:], many=1 if head.many > 1 else head.many)
            self._said(draft, shaped, cut[1], span)
            return
        first = tokens[0] if tokens else Token("mark", "", head.span.start, head.span.end)
        times = len(head.numbers) if len(head.numbers) > 1 else head.many
        chain = (
            next((i.times for i in draft.lines[draft.chain].items if isinstance(i, Action) and i.name == "ch"), None)
            if draft.chain is not None
            else None
        )
        self.source.marked = draft.ahead()
        self.source.solid = any(one.in_round for one in draft.lines[-1:]) and not chained(
            draft.lines[-1], self.source.stitches
        )
        both = over_two(
            self, draft, tokens, lambda some, edge: decided(self.source, some, self.palette, edge, self.phrases), span
        )
        if both is None:
            tokens, held = crocheted_in(self, draft, tokens, span)
            self.held += held
        if both is not None and head.numbers and head.numbers[0] <= draft.last:
            draft.offset = draft.last
            head = replace(head, numbers=tuple(n + draft.offset for n in head.numbers))
        if (
            draft.last
            and draft.lines
            and any(t.word in ("these", "those") for t in tokens[:3])
            and tokens[0].value == "in"
        ):
            draft.leaves_rest(self.source)  # "Working in these 33 sts only"
        if both is None and established(self, tokens, head):
            return
        tokens = _risen(tokens) if chain is None and draft.flat and draft.last else tokens
        tokens = lengthened(self.source, draft, _into_first(tokens, chain))
        try:
            stands = not draft.flat or any(
                t.value in ("skip", "slst") for t in tokens
            )  # a row may go on along its chain
            lying = chain is None and stands and draft.last > 0 and bool(draft.edge)
            hung = on_loops(self, draft, tokens, times) if self.hanging is not None and not draft.begun() else None
            read = (
                both
                or hung
                or decided(self.source, tokens, self.palette, draft.edge, self.phrases, times, chain, lying)
            )
        except NotUnderstood as wrong:
            self._gap(draft, head, tokens, span, wrong)
            return
        if not read.fit and draft.other is not None:
            # The round before does not make its own count: this one may stand on either.
            second = tried(self.source, tokens, self.palette, draft.other, self.phrases, times)
            read, draft.edge = (second, draft.other) if second is not None and second.fit else (read, draft.edge)
        if both is None and not read.fit and read.refers is None:
            read = frilled(self, draft, tokens, times) or read
        if both is None and read.pending and not any(is_start(i, self.source.stitches) for i in read.items):
            ring = next((t for t in tokens if t.kind == "key" and t.value == "ring"), first)
            self._gap(
                draft,
                head,
                tokens,
                span,
                NotUnderstood(ring, "the ring has no stitches", "say how many: 6 sc in magic ring"),
            )
            return
        if both is None and draft.last and (amid := _amid(read.items, self.source.stitches)) is not None:
            at = Token("mark", "", amid.span.start, amid.span.end)
            self._gap(draft, head, tokens, span, NotUnderstood(at, "a ring in the midst of a round is not understood"))
            return
        nothing = not (read.items or read.refers or read.edged or read.plain or read.more or read.moved)
        if nothing and head.numbers and any(t.kind == "stitch" and t.value not in ("slst", "ch") for t in tokens):
            self._gap(draft, head, tokens, span, NotUnderstood(first, "no stitch of this was read"))
            return
        hues = [i for i in read.items if isinstance(i, Action) and i.name == "color"]
        if hues and hues == read.items and head.numbers and head.numbers[-1] <= draft.last and not read.left:
            dyed = worn(draft.lines, head.numbers, hues[0])  # "Round 9: white" of rounds that are worked already
            if dyed is not None:
                draft.lines = [*dyed, *(Line((hue,), hue.span, False) for hue in hues[1:])]
                return
        place, self.moved = read.moved or self.moved, None
        if self._along(draft, read, place):
            self._edged(draft, read, span)
            return
        along = self._bordered(draft, head, read, place, (tokens, times, span))
        if along is not None:
            draft, head, read = along
        elif place is not None and not is_first(read, self.source.stitches):
            draft, head, read = elsewhere(self, draft, head, read, place, (tokens, times, span))
        elif (
            not draft.started(self.source)
            and read.refers is None
            and (len(self.parts) > 1 or first.value == "join")
            and (read.both or sum(map(works_some, read.items)) > 1)
        ):
            read = based(self, draft, head, read, (tokens, times)) or read
        unread = []
        handed = bool(read.doings)
        for left in read.left:
            put = finishing(self, left)
            edged, self.edged = self.edged, False
            known = put or edging(self, left) or edged_again(self, left, edged) or again_made(self, left)
            known = known or convention(self, left) or turned_always(self.source.text.text, left)
            if not known and not (handed and another(left)):
                unread.append(left)
            handed = handed or put
        instructive = [left for left in unread if instructs(self, left) and not remark(self.source.text.text, left)]
        notes = tuple(Span(d[0].start, ended(self.source.text.text, d[-1].end)) for d in read.doings if d)
        for done in filter(None, read.doings):
            amount = None if (sews(self, done) or eyed(done)) and finishing(self, done) else stuffed(done)
            if amount is not None and amount >= 0:
                draft.stuffing = amount
        if read.refers is not None:
            if draft.offset and read.refers.numbers and read.refers.numbers[0] + draft.offset <= draft.last:
                numbers = tuple(n + draft.offset for n in read.refers.numbers)
                read.refers = replace(read.refers, numbers=numbers)
            shared = allotted(draft, head, [read.refers, *read.more])
            if not (again(self, draft, shared[0] or head, read, span) or anew(self, draft, head, read, span)):
                at = Token("mark", "", read.refers.span.start, read.refers.span.end)
                lacking = NotUnderstood(
                    at, "these rounds are not there to be repeated", "name rounds that stand before this"
                )
                self._gap(draft, head, tokens, span, lacking)
                return
        elif (not read.fit and (instructive or not draft.sure)) or (
            read.stated is None and any(works(left, k) for left in instructive for k in range(len(left)))
        ):
            self._gap(
                draft, head, tokens, span, read.wrong or NotUnderstood(first, "these words do not make the count")
            )
            return
        else:
            if (draft.edge or 0) > EVENED and read.stated is None and evens(read.items):
                read.items = [
                    Action("join", span),
                    *(i for i in read.items if isinstance(i, Action) and i.name == "fo"),
                ]
            before, edge, last = len(draft.lines), draft.edge, draft.last
            draft.spoken[span.start] = tokens
            draft.add(self.source, head, read, span, notes)
            if not draft.started(self.source):
                del draft.lines[before:]
                draft.edge, draft.last = edge, last
                read = based(self, draft, head, read, (tokens, times)) or read
                if draft.started(self.source):
                    draft.add(self.source, head, read, span, notes)
            if not draft.started(self.source):
                self._gap(draft, head, tokens, span, NotUnderstood(first, "what this is worked on is not known"))
                hues = [i for i in read.items[:1] if isinstance(i, Action) and i.name == "color"]
                self.lead += [Line((hue,), span, False) for hue in hues]  # what follows is of its yarn
                return
            joined = any(isinstance(i, Action) and i.name == "join" for i in read.items[:-1])
            used = stitches_of(read.items, edge or 0, self.source.stitches) if read.fit == 1 and not joined else None
            if read.stated is not None and read.fit and (used is None or used[0] == read.stated):
                draft.sure = True
                self.sound.add(span.start)
        self.understood += 1
        if read.shut is not None:
            draft.add(self.source, None, Body([Action("fold", read.shut)]), read.shut)
        for where in read.edged:
            not_drawn(self, where)
        for many, where in read.plain:
            even = Body([Group((Action("sc", where),), None, where)], rounds=(many, where))
            draft.add(self.source, None, even, where)
        if read.more:
            self.end_marks(draft)
        for k, more in enumerate(read.more):
            behind = Body([hue for at, hue in read.between if at == k], refers=more)
            if not again(self, draft, shared[k + 1] if read.refers is not None else None, behind, more.span):
                self.tell(NOT_UNDERSTOOD, "name rounds that stand before this", more.span)
                draft.sure = False
        draft.lines += [Line((hue,), span, False) for at, hue in read.between if at == len(read.more)]
        for left in instructive:
            self.tell(
                NOT_UNDERSTOOD, "say it as in the other rounds, or leave it out", Span(left[0].start, left[-1].end)
            )
            draft.sure = False
        self.passed += [Span(left[0].start, left[-1].end) for left in unread if left not in instructive]

    def _of_one(self, tokens: list[Token]) -> list[Token]:
        """A round that two pieces end otherwise, "For the right leg: 7 sc, fasten off; for the left leg: 14 sc", as that of the first; what is said of the
        other is told."""
        found = two_sided(tokens)
        if found is None:
            return tokens
        mine, other = found
        span = Span(other[0].start, other[-1].end)
        self.tell(
            "the pieces of this part differ here, and both are made like the first",
            "give each a heading of its own",
            span,
        )
        return mine

    def _bordered(
        self, draft: Draft, head: Head, read: Body, place: Moved | None, what: tuple[list[Token], int, Span]
    ) -> tuple[Draft, Head, Body] | None:
        """A round that goes on along an edge of a piece, where its words say which; None where they do not."""
        known = place is not None and (place.number or place.before or place.free)
        if known or not (place is not None or read.sides or not draft.begun()):
            return None
        return bordered(self, draft, head, read, place.span.start if place is not None else what[2].start, what)

    def _along(self, draft: Draft, read: Body, place: Moved | None) -> bool:
        """Whether a round goes along an edge that is no round's, as many stitches as fit it, or on from such a one."""
        if read.refers is not None or read.left or is_first(read, self.source.stitches) or not self.parts[0].begun():
            return False
        if read.edged and not any(map(works_some, read.items)):
            return True
        edge = place is not None and not (place.number or place.before or place.free)
        if draft.bordered:
            return place is None or edge
        return (
            edge
            and draft.chain is None
            and read.stated is None
            and base(read.items, None, self.source.stitches) is None
        )

    def _edged(self, draft: Draft, read: Body, span: Span) -> None:
        """A round along an edge which is no round's: it is told as not drawn, and stands with its part in its own words."""
        for where in read.edged or (span,):
            not_drawn(self, where)
        notes: tuple[Span, ...] = (span,)
        if not draft.begun() and len(self.parts) > 1:
            notes = (draft.span, span) if draft.span.end <= span.start else notes
            self.parts.remove(draft)
            draft = self.parts[-1]
        draft.bordered = True
        draft.lines.append(Line((), span, False, notes=notes))
        self.understood += 1

    def _gap(self, draft: Draft, head: Head, tokens: list[Token], span: Span, wrong: NotUnderstood) -> None:
        """A round that was not understood takes its count, or else that of the round below."""
        self.failed += 1
        hint = wrong.hint
        if wrong.token.kind == "word" and self.failed <= _HINTED:
            hint = did_you_mean(wrong.token.word, self.palette.known) or hint
        count = count_in(tokens, self.source.stitches, self.palette)
        many = count.value if count is not None else draft.edge if draft.chain is None else None
        on = draft.started(self.source) or count is not None
        if (
            not on
            or not many
            or many > _MOST
            or (draft.edge and not draft.edge <= MOST * many <= MOST * MOST * draft.edge)
        ):
            self.left_out.append(span)
            self.tell(f"{wrong.message}: this round is left out", hint, wrong.token.span)
            draft.last = max(head.numbers) if head.numbers else draft.last + 1
            draft.sure = False
            return
        said = (
            "taken from its stated count" if count is not None else "taken to have as many stitches as the one before"
        )
        self.tell(f"{wrong.message}: this round is {said}, {many}", hint, wrong.token.span)
        draft.gap(self.source, head, many, span, count.span if count is not None else head.span)
        draft.sure = count is not None
