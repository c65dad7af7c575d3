"""Printed patterns, the lines between the rounds: headings, yarns, stuffing, loose instructions, and what is passed over."""

from __future__ import annotations

from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.stitches import STUFFING
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.places.hear import assembling
from tambour.crochet.printed.assembly import Said
from tambour.crochet.printed.cursor import OPEN, Cursor, NotUnderstood
from tambour.crochet.printed.doubts import decided
from tambour.crochet.printed.notes import MODES, Heading, definition, heading, plain_name, stated
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.words.special import explained

NOT_UNDERSTOOD: Final = "this looks like instructions, and was not understood"
WRAPPED: Final = 12  # lines of a paragraph
_PART: Final = {"stuff none": "none", "stuff light": "light", "stuff medium": "medium", "stuff firm": "firm"}


def text_line(p: State, row: Row, tokens: list[Token]) -> None:
    """A line that begins no round."""
    whole = Span(row.start, row.end)
    if not tokens:
        p.passed.append(whole)
        return
    text = p.source.text.text
    if _said(p, Span(row.tokens[0].start, row.tokens[-1].end)):
        return
    title = p.title is not None and p.heading is not None and p.heading.span == p.title[1]
    if title and p.heading is not None and p.heading.copies_span is None and tokens[0].word not in OPEN:
        p.heading = None  # what stands over the whole pattern names no part
    new = definition(tokens)
    if new is not None and new[1] in p.source.stitches:
        p.vocabulary.define(new[0].word, new[1])
        p.passed.append(whole)
        return
    line = text[row.tokens[0].start : row.tokens[-1].end]
    shade = _named_color(p, tokens)
    said = stated(text, row, tokens)
    for key, words, span in said:
        p.stated.setdefault(key, (words, span))
    if said or shade:
        return
    if p.parts and p.phrases.finishing(line) is not None:
        p.sentences.append(Said(tokens, p.parts[-1].name, Span(row.tokens[0].start, row.tokens[-1].end)))
        return
    first = tokens[0]
    names = [t for t in tokens if t.kind != "mark"]
    if len(names) <= 3 and first.kind == "key" and first.value in MODES:
        p.mode = MODES[first.value]
        p.heading = None
        p.passed.append(whole)
        return
    found = _copied(p, row, line) or heading(text, row, tokens)
    lefts: list[list[Token]] = []
    if (found is None or not found.marked) and _sentences(p, tokens, lefts):
        found = None
        for left in lefts:
            left_over(p, left, False)
        return
    if found is not None and (found.marked or found.strong or p.mode not in ("materials", "abbreviations", "notes")):
        p.mode = "" if found.marked else p.mode  # a marked heading ends the list that stands before it
        if p.title is None:
            p.title = (text[found.span.start : found.span.end], found.span)
            p.heading = found if found.strong else None
        else:
            p.heading = found
        if found.copies > 1 and found.name == "":
            p.heading = None
        return
    if p.title is None and names:
        end = next((t.start for t in row.tokens if t.word in (".", ":")), row.end)
        p.title = (text[row.tokens[0].start : end].strip(), Span(row.tokens[0].start, end))
    else:
        p.passed.append(whole)
    for left in lefts:
        left_over(p, left, False)


def _said(p: State, span: Span) -> bool:
    """A line that is one of the writer's own sentences: of colour, of seams, of the end."""
    text = p.source.text.text[span.start : span.end]
    own = explained(text, p.source.stitches, p.phrases.terms) if not p.parts else []
    for new in own:
        p.source.stitches[new.name], p.source.own[new.name] = new, span
        p.vocabulary.define(new.name, new.name)
    if own:
        return True
    item = p.phrases.item(text)
    if item is None:
        return False
    line = Line((Action(item[0], span, 1, None, item[1], item[2]),), span, False)
    if item[0] == "color":
        p.lead.append(line)
    elif item[0] in ("sew", "fo", "mark", "goto") and p.parts:
        draft = p.parts[-1]
        draft.lines += [*p.lead, line]
        p.lead = []
        draft.ends = "open" if item[0] == "fo" else draft.ends  # it is closed here already
        draft.edge = None if item[0] == "goto" else draft.edge
    else:
        return False
    return True


def _copied(p: State, row: Row, line: str) -> Heading | None:
    """A heading that says its copies as the table of terms does: ``Arm (make 2)``."""
    mark = line.rfind("(")
    said = p.phrases.read(line[mark:], ("copies",)) if mark > 0 else None
    name = plain_name(line[:mark].strip()) if said is not None else ""
    if said is None or not name:
        return None
    span = Span(row.tokens[0].start, row.tokens[-1].end)
    return Heading(name, span, max(1, said[1]["count"]), span, True, True)


def _named_color(p: State, tokens: list[Token]) -> bool:
    """``A = brown``, ``Color B: white``, ``Main color (MC): cream``; whether the line says such."""
    found = False
    for k in range(len(tokens) - 2):
        at = k + 1 + (tokens[k + 1].word == ")")
        if tokens[k].kind not in ("word", "key") or len(tokens[k].word) > 2 or at + 1 >= len(tokens):
            continue
        shade = p.palette.color(Cursor(tokens, at + 1)) if tokens[at].word in ("=", ":", "-") else None
        if shade is not None:
            p.palette.given.setdefault(tokens[k].word, shade[0])
            found = True
    return found


def _sentences(p: State, tokens: list[Token], lefts: list[list[Token]]) -> bool:
    """Reads what instructions a line of text holds; whether there were any. What was not read goes to ``lefts``."""
    any_read = False
    begin = 0
    ends = (".", "!", "?") if any(t.word == "*" for t in tokens) else (".", "!", "?", ";")
    for at in range(len(tokens) + 1):
        if at < len(tokens) and tokens[at].word not in ends:
            continue
        sentence = tokens[begin:at]
        begin = at + 1
        if sentence and _sentence(p, sentence):
            any_read = True
        elif sentence:
            lefts.append(sentence)
    return any_read


def _sentence(p: State, tokens: list[Token]) -> bool:
    """One sentence outside rounds; whether it was understood."""
    if _finishes(p, tokens):
        return True
    text = p.source.text.text[tokens[0].start : tokens[-1].end]
    said = p.phrases.read(text, (*_PART, "stuff factor", "up start", "up end", "up side"))
    draft = p.parts[-1] if p.parts else None
    if said is not None:
        key, fields = said
        amount = STUFFING[_PART[key]] if key in _PART else fields.get("factor")
        name, value = ("up", key.removeprefix("up ")) if amount is None else ("stuffing", amount)
        if draft is None or p.heading is not None:
            p.early[name] = value  # of the part that the heading begins
        else:
            setattr(draft, name, value)
        return True
    stuffing = _stuffing(p, tokens)
    if stuffing is not None and draft is not None:
        if stuffing >= 0:
            draft.stuffing = stuffing
        return True
    if p.mode in ("materials", "abbreviations", "notes", "assembly"):
        return False
    if any(t.kind == "key" and t.value == "not" for t in tokens):
        return False
    try:
        body = decided(p.source, tokens, p.palette, draft.edge if draft else None, p.phrases)
    except NotUnderstood:
        return False
    if body.left or not (body.items or body.ends or body.refers):
        return False
    if body.items and all(isinstance(i, Action) and i.name == "color" for i in body.items):
        if not any(t.kind == "key" and t.value in ("color", "with", "begin", "in", "join") for t in tokens):
            return False
        p.lead.append(Line(tuple(body.items), Span(tokens[0].start, tokens[-1].end), False))
        return True
    span = Span(tokens[0].start, tokens[-1].end)
    starts = any((isinstance(i, Action) and i.name in ("mr", "ch")) or _ring(i) for i in body.items)
    if draft is None and not starts:
        return False
    if starts and (draft is None or p.heading is not None):
        p.begin(True, span)
    elif draft is not None and p.lead:
        draft.lines += p.lead
        p.lead = []
    draft = p.parts[-1]
    draft.add(p.source, None, body, span)
    p.understood += any(t.kind == "stitch" for t in tokens) and len(tokens) > 1
    return True


def _finishes(p: State, tokens: list[Token]) -> bool:
    """Whether a sentence puts a part or a face somewhere; it is kept until all parts are known."""
    if not p.parts or p.mode in ("materials", "abbreviations"):
        return False
    text = p.source.text.text[tokens[0].start : tokens[-1].end]
    if not assembling(text, [draft.name for draft in p.parts]):
        return False
    p.sentences.append(Said(tokens, p.parts[-1].name, Span(tokens[0].start, tokens[-1].end)))
    return True


def _stuffing(p: State, tokens: list[Token]) -> float | None:
    """How much a sentence wants the part stuffed; -1 when it says only that it is."""
    if not any(t.kind == "key" and t.value == "stuff" for t in tokens) or len(tokens) > 14:
        return None
    if any(t.kind == "stitch" for t in tokens):
        return None
    for word, amount in (("not", "none"), ("light", "light"), ("medium", "medium"), ("firm", "firm")):
        if any(t.kind == "key" and t.value == word for t in tokens):
            return STUFFING[amount]
    return -1.0


def left_over(p: State, tokens: list[Token], in_round: bool) -> None:
    """A sentence that was not read: kept when it puts something somewhere, a doubt when it looks like instructions."""
    if in_round and _finishes(p, tokens):
        return
    span = Span(tokens[0].start, tokens[-1].end)
    words = [t for t in tokens if t.kind != "mark"] or tokens
    known = sum(t.kind in ("stitch", "number", "ordinal", "key") for t in words)
    stitches = sum(t.kind == "stitch" for t in words)
    blocked = p.mode in ("materials", "abbreviations", "notes")
    begins = words[0].kind == "stitch" or (words[0].kind == "number" and len(words) > 1 and words[1].kind == "stitch")
    likely = known * 2 >= len(words) if begins else known * 4 >= len(words) * 3
    if stitches and known >= 3 and likely and p.parts and not blocked:
        p.source.doubt(NOT_UNDERSTOOD, "say it as in the other rounds, or leave it out", span)
    elif in_round:
        p.passed.append(span)


def _ring(item: object) -> bool:
    return isinstance(item, Action) and item.name.startswith("MR{")
