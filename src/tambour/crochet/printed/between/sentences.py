"""Printed patterns, sentences: what stands between the rounds, a sentence at a time: yarns, stuffing, loose instructions, references."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.ends import MOST_AT_TIP
from tambour.crochet.graph.hook import LIFT
from tambour.crochet.language.stitches import STUFFING, UPS
from tambour.crochet.language.tree import Action, Group, Line
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.between.beyond import (
    again_made,
    along,
    edged_again,
    edging,
    marked,
    more_copies,
    once_again,
    repeats_for,
    twin_made,
)
from tambour.crochet.printed.between.conventions import convention, turned_always
from tambour.crochet.printed.between.headlines import dyed_first, dyed_last, dyed_lead, dyed_only
from tambour.crochet.printed.between.opening import as_chain, founding, founds, opening
from tambour.crochet.printed.between.put import beside_the_point, finishing, stuffed
from tambour.crochet.printed.between.remarks import chosen, remark
from tambour.crochet.printed.between.stops import founded, held, same_row, turned
from tambour.crochet.printed.between.unread import NOT_UNDERSTOOD, instructs, left_over, otherwise
from tambour.crochet.printed.cursor import OPEN, NotUnderstood
from tambour.crochet.printed.heads import STARS
from tambour.crochet.printed.parts.bridged import bridging, second_made, worked_on
from tambour.crochet.printed.parts.counted import counts_last
from tambour.crochet.printed.parts.established import established
from tambour.crochet.printed.parts.formed import complete, worked_in
from tambour.crochet.printed.parts.hung import joined_in_loops
from tambour.crochet.printed.parts.laid import laid
from tambour.crochet.printed.parts.part import Draft
from tambour.crochet.printed.parts.reworked import again
from tambour.crochet.printed.parts.stripes import Plan, blocks, lay, onward, planned, without
from tambour.crochet.printed.rounds.counts import makes
from tambour.crochet.printed.rounds.doings import by_hand, gathered_shut
from tambour.crochet.printed.rounds.doings import works as works_at
from tambour.crochet.printed.rounds.doubts import decided
from tambour.crochet.printed.rounds.items import (
    EVENED,
    bare_count,
    evens,
    flat,
    lifts,
    lifts_alone,
    rings,
    smooths,
    works,
)
from tambour.crochet.printed.rounds.reader import Body
from tambour.crochet.printed.rounds.reckoned import worked as reckoned
from tambour.crochet.printed.sheet.notes import Heading, copies_alone, copies_said
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Token, rows
from tambour.crochet.printed.yarns.colors import numbered
from tambour.crochet.words.phrases import stood
from tambour.crochet.words.table import TERMS

CHOICE: Final = "this is said for one case or version: it is kept as written, and the piece is made without it"

GONE: Final = (
    "the hook goes on elsewhere here, which is not followed: the next round is worked where the last one ended"
)

_PART: Final = {"stuff none": "none", "stuff light": "light", "stuff medium": "medium", "stuff firm": "firm"}


_GOES_ON: Final = ("repeat", "even", "until", "as", "same")
_STRIPES: Final = re.compile(r"\b(?:stripes?|striping|colou?r sequence)[ \t]*[:–-][ \t]*\Z", re.IGNORECASE)
_NEAR: Final = 24  # characters of what stands before the stripes of rows that are told already


def sentences(p: State, tokens: list[Token], lefts: list[list[Token]]) -> bool:
    """Reads what instructions a line of text holds; whether there were any. What was not read goes to ``lefts``."""
    any_read = False
    begin = 0
    ends = (".", "!", "?") if any(t.word == "*" for t in tokens) else (".", "!", "?", ";")
    depth = 0
    kept = held(tokens)
    for at in range(len(tokens) + 1):
        if at < len(tokens) and at in kept:
            continue
        if at < len(tokens):
            depth += (tokens[at].word in OPEN) - (tokens[at].word in ")]}>") if tokens[at].kind == "mark" else 0
        if at < len(tokens) and (tokens[at].word not in ends or depth > 0 or same_row(tokens, begin, at)):
            continue
        sentence = tokens[begin:at]
        while sentence and sentence[0].word in STARS:
            sentence = sentence[1:]
        while len(sentence) > 1 and sentence[-1].word in STARS and sentence[-2].word != "to":
            sentence = sentence[:-1]
        if (
            not sentence
            and at > begin
            and tokens[begin].word in STARS
            and any(t.kind != "mark" for t in tokens[:begin])
        ):
            if p.parts:
                p.parts[-1].marks.append((tokens[begin].word, len(p.parts[-1].lines)))
            begin = at + 1
            continue
        before = len(p.parts[-1].lines) if p.parts else 0
        count = len(p.parts)
        starred = [t.word in STARS for t in tokens[begin:at]]
        mark = tokens[begin].word if at > begin else ""
        last = tokens[at - 1].word if at > begin else ""
        begin = at + 1
        if starred and starred[0] and sentence:
            p.starred = mark
        if sentence and (opened := opening(p.source.text.text, sentence)) is not None:
            p.heading, sentence, p.mode, any_read = opened[0], sentence[opened[1] :], "", True
            p.title = p.title or (opened[0].name, opened[0].span)
        chained = p.heading is not None and any(t.value == "ch" for t in sentence)  # "5 Lm" below a heading is no count
        if chained and any(a.kind == "number" and b.value == "ch" for a, b in pairwise(sentence)) and founds(p, near=1):
            sentence = as_chain(p, sentence)  # "In brown, starting at the toe, 7 ch"
        if sentence and not lefts and not chained and p.parts and p.parts[-1].counted(sentence):
            any_read = True
        elif sentence and lefts and p.parts and p.parts[-1].last and bare_count(sentence) is not None:
            lefts.append(sentence)  # the count of what was not read
        elif sentence and (_shut(p, sentence) or sentence_read(p, sentence) or _chained(p, sentence)):
            any_read = True
            if p.starred and p.parts and len(p.parts[-1].lines) > (before if len(p.parts) == count else 0):
                p.parts[-1].marks.append((p.starred, before if len(p.parts) == count else 0))
                p.starred = ""
            if starred[-1] and p.parts and not (len(sentence) > 1 and sentence[-1].word in STARS):
                p.parts[-1].marks.append((last, len(p.parts[-1].lines)))
        elif sentence:
            lefts.append(sentence)
    return any_read


def _shut(p: State, tokens: list[Token]) -> bool:
    """Notes that the part under way is drawn together at its end, though a tail is left there; never goes past the sentence."""
    draft = p.parts[-1] if p.parts else None
    if draft is None or p.heading is not None or not draft.last or p.mode in ("materials", "abbreviations", "assembly"):
        return False
    text, end = p.source.text.text, tokens[-1].end
    small = draft.edge is not None and draft.edge <= MOST_AT_TIP
    if small and p.language.code in ("us", "uk") and gathered_shut(text[tokens[0].start : end]):
        draft.ends = "close"
    return False


def _chained(p: State, tokens: list[Token]) -> bool:
    """One sentence that was not understood, right above the first round, as the chain that it begins the piece with; whether it is such."""
    chained = as_chain(p, tokens) if founds(p, near=1) else tokens
    return chained is not tokens and sentence_read(p, chained)


def sentence_read(p: State, tokens: list[Token]) -> bool:
    """One sentence outside rounds, in the stripes that it plans; whether it was understood."""
    count = next((k for k, t in enumerate(tokens[:5]) if t.word == ")"), 0) if tokens[0].word == "(" else 0
    if p.edged and count and count + 1 < len(tokens) and any(t.kind == "number" for t in tokens[:count]):
        tokens = tokens[count + 1 :]  # "(54 sts) Sl st to join": the count of the edge before
    if cut := dyed_first(p, tokens):
        dyed = sentence_read(p, tokens[:cut])
        rest = tokens[cut + 1 :]
        while rest and (rest[0].word in ("then", "now", ",") or rest[0].value == "and"):
            rest = rest[1:]
        if rest and not sentence_read(p, rest):
            left_over(p, rest)
        return dyed
    if cut := dyed_lead(p, tokens):
        if not sentence_read(p, tokens[cut:]) and any(t.kind in ("number", "stitch") for t in tokens[cut:]):
            left_over(p, tokens[cut:])
        return True
    if cut := dyed_last(p, tokens):
        return sentence_read(p, tokens[cut:])
    if p.language.code in ("us", "uk") and turned_always(p.source.text.text, tokens):
        p.passed.append(Span(tokens[0].start, tokens[-1].end))
        return True
    tokens = turned(tokens, TERMS[p.language.code].heard.said.get("through", ()))
    if laid(p, tokens) or bridging(p, tokens) or second_made(p, tokens) or worked_on(p, tokens):
        return True
    draft = p.parts[-1] if p.parts else None
    begin, end = tokens[0].start, tokens[-1].end
    worked_in(p, begin, end)
    if joined_in_loops(p, tokens):
        return True
    if (
        draft is not None
        and draft.last
        and (made := blocks(p.source.text.text[begin:end], p.palette, draft.lines)) is not None
    ):
        return _in_blocks(p, draft, tokens, made)
    found = None
    if draft is not None and draft.last:
        plans = [d.plan[0] for d in p.parts if d.plan is not None]
        said = p.source.text.text[begin:end]
        found = planned(said, p.palette, draft.lines) or onward(said, p.palette, plans)
    if draft is not None and found is not None and _STRIPES.search(p.source.text.text, max(0, begin - _NEAR), begin):
        plan, (first, last) = found  # "Stripes: 4 rows red, 4 rows white", behind the rows
        if not any(t.kind in ("stitch", "number") for t in without(tokens, Span(begin + first, begin + last))):
            p.heading = None if p.heading is not None and p.heading.name.lower().startswith("stripe") else p.heading
            lay(draft, set(), plan, Span(begin + first, begin + last), False)
            return True
    if draft is None or found is None or p.heading is not None or p.mode in ("materials", "abbreviations", "assembly"):
        known = {id(line) for line in draft.lines} if draft is not None and draft.plan is not None else set()
        read = plainly(p, tokens)
        if draft is not None and draft.plan is not None and p.parts[-1] is draft and len(draft.lines) > len(known) > 0:
            lay(draft, known, *draft.plan, True)
        return read
    plan, (first, last) = found
    place = Span(begin + first, begin + last)
    rest = without(tokens, place)
    if not any(t.kind in ("stitch", "number", "ordinal") or t.value in _GOES_ON for t in rest):
        draft.plan = plan, place  # "Alternate A and B every 2 rows"
        return True
    known = {id(line) for line in draft.lines}
    if not plainly(p, rest):
        return False
    lay(draft, known, plan, place, False)
    return True


def _in_blocks(p: State, draft: Draft, tokens: list[Token], made: tuple[Plan, int, tuple[int, int]]) -> bool:
    """Rows that are repeated, in blocks of colour, until there are so many blocks; whether the repeat was understood."""
    plan, total, (first, last) = made
    place = Span(tokens[0].start + first, tokens[0].start + last)
    end = next(
        (k for k, t in enumerate(tokens) if t.word == "," or t.value == "until" or t.start >= place.start), len(tokens)
    )
    until = p.vocabulary.read(rows(f"until there are {total} rows")[0].tokens)
    known = {id(line) for line in draft.lines}
    if not end or not plainly(p, [*tokens[:end], *(replace(t, start=place.start, end=place.end) for t in until)]):
        return False
    lay(draft, known, plan, place, False)
    return True


def plainly(p: State, tokens: list[Token]) -> bool:
    """One sentence outside rounds; whether it was understood."""
    handed, p.handed = p.handed, True
    edged, p.edged = p.edged, p.edged and tokens[0].value == "fasten off"
    if len(tokens) > 2 and tokens[0].kind == "key" and tokens[0].value == "notes" and tokens[1].word in (":", "-"):
        tokens = tokens[2:]
        note = Span(tokens[0].start, tokens[-1].end)
        spoken = set(re.findall(r"\w+", p.source.text.text[note.start : note.end].lower()))
        foretells = tokens[0].kind == "stitch" and spoken & set(TERMS[p.language.code].heard.said.get("foretells", ()))
        stuffs = any(t.value == "stuff" for t in tokens)
        if foretells or (not stuffs and remark(p.source.text.text, tokens)):
            p.passed.append(note)
            return True  # "Note: Hdc in rnds below will cause Motif to cup"
    if p.parts and p.mode not in ("materials", "abbreviations") and (once_again(p, tokens) or counts_last(p, tokens)):
        return True
    close = next((k for k, t in enumerate(tokens) if t.word in (")", "]")), 0) if tokens[0].word in ("(", "[") else 0
    if 0 < close < len(tokens) - 1 and tokens[1].value == "make":  # "(make 2) With D, work as given for Outer Ear"
        taken = sentence_read(p, tokens[: close + 1])
        return sentence_read(p, tokens[close + 1 :]) and taken
    if p.mode == "assembly" and finishing(p, tokens):
        return True  # "Make two French knots on the snout" are no copies of what was made last
    alone = copies_alone(tokens)
    if (more := copies_said(tokens) or (None if alone is None else (*alone, False))) is not None:
        return more_copies(p, tokens, more)
    text = p.source.text.text[tokens[0].start : tokens[-1].end]
    span = Span(tokens[0].start, tokens[-1].end)
    if p.parts and beside_the_point(text) and not any(works_at(tokens, k) for k in range(len(tokens))):
        p.passed.append(span)
        return True
    chains = p.heading is not None and founding(tokens) and any(t.value == "ch" for t in tokens) and founds(p, near=1)
    if not chains and finishing(p, tokens):
        return True
    if p.mode in ("materials", "abbreviations") and convention(p, tokens):
        p.passed.append(span)  # "Every round here is worked in the back loop only"
        return True
    if p.mode not in ("materials", "abbreviations"):
        if twin_made(p, tokens):
            return True
        if by_hand(tokens) and otherwise(p, tokens):
            return False
        if by_hand(tokens) or convention(p, tokens) or complete(text) or (handed and _once_more(tokens)):
            p.passed.append(span)
            return True
        if edged_again(p, tokens, edged) or again_made(p, tokens) or _left_unworked(p, tokens):
            return True
        if chosen(tokens) and instructs(p, tokens):
            p.source.doubt(CHOICE, "say what is made, without an if", span)
            return True
    if established(p, tokens) or _joined_pieces(tokens):
        return True
    p.handed = False
    if numbered(p.palette, text):
        p.passed.append(span)
        return True
    said = p.phrases.read(text, (*_PART, "stuff factor", *(f"up {end}" for end in UPS), "stands"))
    draft = p.parts[-1] if p.parts else None
    tokens = founded(tokens) if founds(p, near=1) else tokens
    if said is not None:
        key, fields = said
        amount = STUFFING[_PART[key]] if key in _PART else fields.get("factor")
        name, value = ("up", key.removeprefix("up ")) if amount is None else ("stuffing", amount)
        if key == "stands":
            name, value = key, stood(fields)
        if draft is None or p.heading is not None:
            p.early[name] = value  # of the part that the heading begins
        else:
            setattr(draft, name, value)
        return True
    stands = p.source.text.text[tokens[0].start : tokens[-1].end]
    called = p.heading.name if p.heading is not None else draft.name if draft is not None else ""
    stuffing = stuffed(tokens, called, stands)
    if stuffing is not None and called:
        if stuffing >= 0 and p.heading is not None:
            p.early["stuffing"] = stuffing  # of the part that the heading begins
        elif stuffing >= 0 and draft is not None:
            draft.stuffing = stuffing
        else:
            p.passed.append(span)
        return True
    if draft is not None and draft.chain is not None and [t.value for t in tokens] == ["turn"]:
        return True  # "ch 6; turn"
    if p.mode in ("materials", "abbreviations", "notes", "assembly"):
        if not (founding(tokens) and (founds(p) or _refers_below(p))):
            return p.mode == "assembly" and edging(p, tokens)
        p.mode = ""  # the list ends where a piece begins
    if any(t.kind == "key" and t.value == "not" for t in tokens[:2]):
        comma = next((k for k, t in enumerate(tokens) if t.word == "," and k + 1 < len(tokens)), None)
        if comma is not None and (instructs(p, tokens[comma + 1 :]) or by_hand(tokens[comma + 1 :])):
            p.passed.append(Span(tokens[0].start, tokens[comma - 1].end))
            return sentence_read(p, tokens[comma + 1 :])  # "don't stuff, close with 3 sc"
        p.passed.append(span)
        return True  # "do not fasten off", "do not stuff"
    try:
        based = any(t.value == "ch" for t in tokens[:2]) or any(t.kind == "key" and t.value == "ring" for t in tokens)
        fresh = draft is None or (p.heading is not None and based)
        body = decided(p.source, tokens, p.palette, None if fresh or draft is None else draft.edge, p.phrases)
    except NotUnderstood:
        return edging(p, tokens)
    tied = [i for i in body.items if makes(i)]
    joins = tokens[0].value == "join" or any(t.word == "," and u.value == "join" for t, u in pairwise(tokens))
    single = joins and len(tied) == 1 and [i.name for i in flat(tied[0])] == ["sc"]
    chained = any(isinstance(i, Action) and i.name == "ch" and i.times > LIFT for i in body.items)
    if body.moved is not None and draft is not None and not body.left and (single or not tied) and not chained:
        p.moved = body.moved
        p.tied = Token("stitch", "sc", tied[0].span.start, tied[0].span.end, "sc") if tied else None
        p.lead += [
            Line((i,), Span(tokens[0].start, tokens[-1].end), False)
            for i in body.items
            if isinstance(i, Action) and i.name == "color"
        ]
        return True
    if body.left and edging(p, tokens):
        return True
    if body.curled and p.moved is not None and draft is not None and not body.left:
        p.heading = p.heading or Heading(f"{draft.name or 'piece'} edging", p.moved.span)
        p.moved = None
    elif body.moved is not None:
        return along(p, body, tokens)
    if body.refers is not None and draft is not None:
        return _referred(p, body, tokens)
    if body.pending:
        p.ringed = next((t for t in tokens if t.kind == "key" and t.value == "ring"), None) if not body.items else None
        for left in body.left:
            left_over(p, left)
        p.lead += [Line(tuple(body.items), Span(tokens[0].start, tokens[-1].end), False)] if body.items else []
        return True
    if body.doings and not body.items and not body.left:
        if p.parts and any(t.value == "eyes" for t in tokens) and sum(t.kind == "number" for t in tokens) > 1:
            p.tell(NOT_UNDERSTOOD, "say the rounds and the stitches between them in a sentence of its own", span)
        p.passed.append(span)
        return True
    if body.left or not (body.items or body.ends):
        return False
    if body.items and all(isinstance(i, Action) and i.name == "color" for i in body.items):
        asked = any(t.kind == "key" and t.value in ("color", "with", "begin", "in", "join") for t in tokens)
        if not asked and dyed_only(p, tokens) is None:
            return False
        p.lead.append(Line(tuple(body.items), Span(tokens[0].start, tokens[-1].end), False))
        return True
    if body.items and draft is not None and all(isinstance(i, Action) and i.name == "skip" for i in body.items):
        p.source.doubt(GONE, "say which round, and what is worked there", span)
        p.passed.append(span)
        return True  # "Skip next 5 ch of foundation chain."
    starts = body.curled or any((isinstance(i, Action) and i.name in ("mr", "ch")) or rings(i) for i in body.items)
    if draft is None and not starts:
        return False
    if lifts_alone(body.items) and not body.hook and (draft is None or p.heading is not None):
        return False  # "Strap: Ch 1, sc in each of the 35 ch": what it is worked into stands elsewhere
    anew = not (lifts(body.items) and not body.hook) and any(
        isinstance(i, Action) and (i.name == "mr" or (i.name == "ch" and i.times > 1) or rings(i)) for i in body.items
    )
    ended = (
        draft is not None and draft.off is not None and anew and not body.curled
    )  # "Fasten off" stands before another part
    if body.curled and draft is not None and _rooted_in(draft, body):
        p.heading, draft.off = (
            None,
            None,
        )  # "Tentacles: (ch 30, …, sl st in next st) 8 times": they hang off the round at the hook
    elif starts and (draft is None or p.heading is not None or ended):
        p.begin(True, span)
    elif draft is not None and p.lead:
        draft.lines += p.lead
        p.lead = []
    draft = p.parts[-1]
    if not body.items:
        p.passed.append(span)  # "Gather and tie"
    if draft.last and smooths(body.items):
        body.items = [Action("join", span)]  # one slip stitch at the end evens the edge, and is no round
    elif draft.last and (draft.edge or 0) > EVENED and evens(body.items):
        body.items = [Action("join", span), *(i for i in body.items if isinstance(i, Action) and i.name == "fo")]
    _added(p, draft, body, span)
    p.understood += any(t.kind == "stitch" for t in tokens) and len(tokens) > 1
    return True


def _refers_below(p: State) -> bool:
    """Whether the next line with words works rounds as those of another part, or the next ones: "Work from ** to ** as given for Head"."""
    below = next((row for row in p.rows[p.row_at + 1 : p.row_at + 4] if row.tokens), None)
    tokens = p.vocabulary.read(below.tokens[:8]) if below is not None else []
    if [t.value for t in tokens[:2]] in (["next", "round"], ["next", "row"]):
        return True  # "Next round: increase in every stitch"
    return (
        bool(tokens)
        and tokens[0].value in ("from", "as", "same")
        and any(t.value in ("as", "same", "to") for t in tokens)
    )


def _left_unworked(p: State, tokens: list[Token]) -> bool:
    """Takes "Leave rem sts unworked", a sentence of its own, for the row before it; whether it is such."""
    draft = p.parts[-1] if p.parts else None
    if draft is None or tokens[0].value != "leave" or tokens[-1].word != "unworked" or not draft.lines:
        return False
    said = next((t.value for t in tokens if t.kind == "number"), None)
    return draft.leaves_rest(p.source, said)


def _added(p: State, draft: Draft, body: Body, span: Span) -> None:
    """Adds the line of a sentence; where the one before it left stitches of its round and did not end it, both are one round: "1 sc in each of
    next 12 sc. Stuff lightly. 1 sc in each sc to end of rnd"."""
    line, edge, last = draft.loose if draft.loose is not None else (None, None, 0)
    if line is not None and draft.lines[-1] is line and any(map(works, body.items)):
        draft.lines.pop()
        draft.edge, draft.last = edge, last
        body.items, span = [*line.items, *body.items], Span(line.span.start, span.end)
    before, edge, last = len(draft.lines), draft.edge, draft.last
    draft.add(p.source, None, body, span)
    draft.loose = None
    ring = body.hook and edge is not None and edge <= LIFT  # "6 sc in 2nd ch from hook" leaves no stitches of its chain
    if len(draft.lines) == before + 1 and draft.lines[-1].in_round and edge is not None and not ring:
        ends = any(isinstance(i, Action) and i.name in ("join", "turn", "fo") for i in body.items)
        done = reckoned(body.items, edge, p.source.stitches)
        if not ends and body.stated is None and done is not None and done[0] and 0 < done[1] < edge:
            draft.loose = draft.lines[-1], edge, last


def _joined_pieces(tokens: list[Token]) -> bool:
    """Whether a sentence only heads the round that joins two pieces: "Join Legs", "Joining the legs"."""
    plain = all(t.kind in ("word", "ordinal") or t.value == "and" for t in tokens[1:])
    return tokens[0].value == "join" and 1 < len(tokens) <= 5 and plain and bool(kind_of(one(tokens[-1].word)))


def _once_more(tokens: list[Token]) -> bool:
    """Whether a sentence has what hands just did done again: "Repeat for second ear"."""
    return repeats_for(tokens, ("for", "in", "with", "as", "once", "twice", "other", "until"))


def _referred(p: State, body: Body, tokens: list[Token]) -> bool:
    """A sentence between the rounds that works rounds once more: "Rep last rnd 3 times more."."""
    span = Span(tokens[0].start, tokens[-1].end)
    assert body.refers is not None
    body.refers = marked(p, body.refers)
    if p.heading is not None and (body.refers.part or body.refers.numbers or body.refers.marks):
        p.begin(True, span)
    draft = p.parts[-1]
    if p.lead and draft.last:
        draft.lines += p.lead  # "… change to B. Rep Row 2 until …"
        p.lead = []
    if again(p, draft, None, body, span):
        p.understood += 1
        for left in body.left:
            left_over(p, left)
        for more in body.more:
            if not again(p, draft, None, Body(refers=more), more.span):
                p.tell(NOT_UNDERSTOOD, "name rounds that stand before this", more.span)
        return True
    return False


def _rooted_in(draft: Draft, body: Body) -> bool:
    """Whether strands are worked on the round at the hook: between them stitches of it are taken, and no more than it has."""
    if draft.off is not None or not draft.edge or draft.chain is not None:
        return False
    flat_out = [i for item in body.items for i in (item.items if isinstance(item, Group) else (item,))]
    return any(isinstance(i, Action) and i.name in ("slst", "skip", "sc", "hdc") for i in flat_out) and any(
        isinstance(i, Action) and i.name.startswith("curl{") for i in flat_out
    )
