"""Printed patterns, the lines between the rounds: headings, lists, titles, and what is passed over."""

from __future__ import annotations

import re
from dataclasses import replace
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.places.names import kind_of, one
from tambour.crochet.printed.between.assembly import Said, eyes_listed
from tambour.crochet.printed.between.beyond import tallied
from tambour.crochet.printed.between.headlines import (
    bare,
    below,
    copied,
    dyed_only,
    headed,
    named_color,
    small,
    trailing,
)
from tambour.crochet.printed.between.lines import rounds
from tambour.crochet.printed.between.opening import founding, founds
from tambour.crochet.printed.between.preface import prefaced
from tambour.crochet.printed.between.put import finishing
from tambour.crochet.printed.between.sentences import sentences
from tambour.crochet.printed.between.unread import left_over
from tambour.crochet.printed.cursor import OPEN, Cursor
from tambour.crochet.printed.parts.copied import copies_of
from tambour.crochet.printed.parts.formed import forms
from tambour.crochet.printed.parts.hued import hued
from tambour.crochet.printed.parts.naming import family, over
from tambour.crochet.printed.sheet.notes import (
    BELOW,
    MODES,
    Heading,
    copies_alone,
    definition,
    heading,
    own_stitch,
    stated,
)
from tambour.crochet.printed.sheet.wrapping import step
from tambour.crochet.printed.state import State
from tambour.crochet.printed.tokens import Row, Token, rows
from tambour.crochet.printed.wordings.shells import means
from tambour.crochet.printed.yarns.colors import numbered
from tambour.crochet.printed.yarns.yarnlists import headed as headed_by
from tambour.crochet.printed.yarns.yarnlists import worn
from tambour.crochet.words.special import explained
from tambour.crochet.words.table import TERMS

WRAPPED: Final = 12  # lines of a paragraph


_EXPLAINED: Final = re.compile(r"(?:^|[;|,•])[ \t]*[\w./()]{1,10}[ \t]*(?:=|:|[-–](?=\s))[ \t]*[^\W\d]")
"""One abbreviation of a list that stands in a line: "ch - chain; sc - single crochet"."""


_LISTED: Final = re.compile(r"(?:^|;|[-–—:])[ \t]*[^\W\d][\w.]{0,9},[ \t]+[^\W\d][^,;]*(?=;|\.?$)")
"""The same between semicolons, as old booklets have it: "Ch., chain; d.c., double crochet; tr., treble"."""

_SUPPLY: Final = re.compile(
    r"\W*(?:(?:safety|plastic) (?:eyes?|noses?)|embroidery (?:thread|floss)|(?:tapestry|yarn|darning) needle|needles? (?:for|to) |stitch markers?|thread (?:to|for) )",
    re.IGNORECASE,
)
"""What begins a thing of a list, whether the list has a heading or none."""
_SHOWN: Final = re.compile(r"[(\[]\s*see\b[^()\[\]]*[)\]]\W*$", re.IGNORECASE)
"""What stands behind a name that a picture shows: "Neck Flange (see diagram on page 3)."."""
_COLOURING: Final = re.compile(
    r"^(?:(?:version|variation|option|variant|colou?rway) (?:[2-9]|two|three|four|B|C)\b|(?:second|third|other) (?:version|variation|colou?rway))[^\n]*",
    re.IGNORECASE | re.MULTILINE,
)
"""A list of yarns for another toy than the first: "Version 2: White as Color 1, Grey as Color 2"."""
_ALL: Final = r"(?:it|them|him|her|this|everything|all|it all|(?:all )?(?:the |your )?(?:pieces|parts))"
_TOGETHER: Final = re.compile(
    r"[\W\d_]*(?:(?:let['’]?s|how|to|time|now|it['’]?s|the|and|for|of|steps?|final|last|toy) ){0,4}(?:assembl\w*|"
    rf"(?:sewing|putting|joining|piecing|attaching|stitching) (?:[\w'’]+ ){{0,3}}?(?:together|up|pieces|parts|everything)|(?:sew|put|join|piece|stitch) {_ALL}(?: together| up)|"
    r"mak(?:e|ing) up|finishing(?: (?:touches|off|up|it|steps?|instructions))?|(?:final|last) (?:steps?|touches|details|assembly)|construction|to finish|together(?=\W*$))"
    r"(?: [\w'’]+){0,3}[^\w.]*",
    re.IGNORECASE,
)
"""A line that heads the steps by which parts become a toy: "Let's put him together!", "How to assemble your bear"."""
_ADVICE: Final = re.compile(
    r"\W*(?:(?:an?|some|few|more|my|our|useful|helpful|handy|final|extra|general|and|&) )*(?:(?:tips?|tricks?|hints?)(?: (?:and|&|\+) (?:tips?|tricks?|hints?))?|advice|"
    r"(?:washing(?: and care)?|care|safety)(?: (?:instructions|guide|notes?|tips))?|copyright(?: notice)?|licen[cs]e|terms of use|about the (?:designer|author|pattern)|thank(?:s| you))\W*",
    re.IGNORECASE,
)
"""A line that heads what is advised when the toy is made: "A few tips"."""
_ADVISED: Final = re.compile(
    r"\W*(?:(?:washing|care|laundry)(?: (?:instructions|guide|notes?|tips))?[ \t]*[:–—-]|(?:author|designer|licen[cs]e)[ \t]*[:–—-]|(?:copyright|all rights)\b)",
    re.IGNORECASE,
)
"""How a line begins that says of care or of rights, and nothing that is made: "CARE: Sponge clean"."""
_TIP: Final = re.compile(
    r"\W*(?:top |handy |small )?(?:tips?(?: (?:and|&) tricks)?|hints?|advice)[ \t]*[:–—-]", re.IGNORECASE
)
"""How a line begins that advises: "TIPS - Curls too floppy? Go down a hook size."."""
_NEAR: Final = 40  # characters between a heading and another under it
_PLANS: Final = frozenset(("pat", "pattern", "patt", "sequence", "chart", "diagram"))
_PLANNED: Final = frozenset(
    "stripe stripes striped striping color colour stitch loop chevron main basic written free crochet".split()
)
"""Before "pattern": what is no part."""
_FOUNDED: Final = re.compile(
    r"(?:base|foundation|start|set[ -]up|(?:base|foundation|starting) chain)[ \t]*:[ \t]*(?:ch|chain)\b", re.IGNORECASE
)
"""What a chain is called, in its own line, that a part begins with: below the part's own name it is no other part."""
_END_OF: Final = re.compile(r"(?:end|tip|top|bottom|middle|centre|center|front|back) of (?:the )?\w+$")
"""Where a part begins, which is none itself."""
_JOININGS: Final = frozenset(("joining", "join", "assembling"))
_SHAPING: Final = frozenset(("shape", "shaping", "continue", "cont", "proceed", "divide", "dividing", "separate"))


def text_line(p: State, row: Row, tokens: list[Token]) -> None:
    """A line that begins no round."""
    whole = Span(row.start, row.end)
    if not tokens or ([t.kind for t in tokens] == ["stitch", "mark"] and tokens[1].word == ":"):
        p.passed.append(whole)  # "Sc2tog:", above how it is made
        return
    if means(row):
        p.passed.append(whole)  # it is put where its name stands
        return
    text = p.source.text.text
    if p.mode == "assembly" and (labelled := step(text, row)):
        p.passed.append(Span(row.tokens[0].start, labelled))
        raw = [t for t in row.tokens if t.start >= labelled]
        row, tokens = replace(row, tokens=raw), [t for t in tokens if t.start >= labelled]
        if not raw or not tokens:
            return
    tokens, hues = hued(p, tokens)
    if hues:
        p.hued[row.tokens[0].start] = hues
    if _said(p, Span(row.tokens[0].start, row.tokens[-1].end)):
        return
    line = text[row.tokens[0].start : row.tokens[-1].end]
    worn(p, line)
    prefaced(p, row, tokens)
    if forms(p, line, whole) or tallied(p, line, whole):
        return
    works = any(a.kind == "number" and b.kind == "stitch" for a, b in pairwise(tokens))
    if p.parts and (
        _ADVISED.match(line)
        or (p.mode in ("assembly", "notes") and _TIP.match(line) and not works)
        or (_ADVICE.fullmatch(line) and not founds(p, near=2))
    ):
        if _ADVICE.fullmatch(line):
            p.mode, p.advised, p.heading = "notes", True, None
        p.advice.append(whole)
        p.passed.append(whole)
        return
    if p.advised and p.mode == "notes" and not founds(p, near=2):
        p.advice.append(whole)
        if heading(text, row, bare(p, tokens)) is None:
            p.passed.append(whole)
            return
    title = p.title is not None and p.heading is not None and p.heading.span == p.title[1]
    bare_title = p.heading is not None and p.heading.copies_span is None and copies_alone(tokens) is None
    if title and bare_title and tokens[0].word not in OPEN and not _yarn_of(p, tokens):
        p.heading = None  # what stands over the whole pattern names no part
    if " as " in line and numbered(p.palette, line) and not any(t.kind == "stitch" for t in tokens):
        for m in _COLOURING.finditer(line):
            at = row.tokens[0].start + m.start()
            hint = "leave only the one that you want in the text"
            p.source.doubt("this is another colouring: the first is shown", hint, Span(at, at + len(m[0])))
        p.passed.append(whole)  # "Version 3: C as Color 1, B as Color 2"
        return
    if p.mode not in ("materials", "abbreviations") and (at := headed(p, row, tokens) or trailing(p, row, tokens)):
        cut = tokens[at].end
        for part, some in ((tokens[: at + 1], True), (tokens[at + 1 :], False)):
            raw = [t for t in row.tokens if (t.end <= cut) == some]
            if not raw:
                continue  # the line was put in other words that all stand before it
            text_line(p, Row(raw, raw[0].start, raw[-1].end, row.marked if some else 0), part)
        return
    listed = tokens[0].value == "abbreviations" or p.mode == "abbreviations"
    if (listed and len(_LISTED.findall(line)) > 1) or (p.mode == "abbreviations" and len(_EXPLAINED.findall(line)) > 1):
        p.mode = "abbreviations"
        p.passed.append(whole)  # several in one line
        return
    if p.mode == "abbreviations" and (mine := own_stitch(tokens)) is not None:
        for spelling in mine[0]:
            p.vocabulary.define(spelling, mine[1])
        _nearest(p, mine[0][0], mine[1], whole)
        p.passed.append(whole)
        return
    if _defines(tokens):
        p.passed.append(whole)  # "ch - chain", outside every list
        return
    if _hooked(p, tokens):
        return
    new = definition(tokens)
    if new is not None and new[1] in p.source.stitches:
        p.vocabulary.define(new[0].word, new[1])
        p.passed.append(whole)
        return
    shade = named_color(p, tokens)
    if numbered(p.palette, line) and not any(t.kind == "stitch" and t.value == "ch" for t in tokens):
        p.passed.append(whole)
        return
    if p.mode == "materials":
        p.palette.listed(text[row.start : row.end], row.start)  # with the letter that numbers it: "A: Soft Cotton, red"
    said = stated(text, row, tokens) or below(p, row, tokens)
    if p.parts and p.mode != "materials":
        said = [
            one for one in said if one[0] not in ("eyes", "yarn")
        ]  # "Eyes: embroider …", "Green Yarn - Leaves" instruct
    for key, words, span in said:
        p.stated.setdefault(key, (words, span))
    if said or shade:
        return
    if p.parts and p.phrases.finishing(line) is not None:
        p.sentences.append(Said(tokens, p.parts[-1].name, Span(row.tokens[0].start, row.tokens[-1].end)))
        return
    first = tokens[0]
    names = [t for t in tokens if t.kind != "mark"]
    listed = first.value != "eyes" or (p.mode in ("materials", "abbreviations") and not founds(p))
    listed = listed and not (first.word == "face" and _rounds_below(p))
    tipped = MODES.get(str(first.value)) == "notes" and any(kind_of(one(t.word)) for t in names[1:])  # "Tip of Nose"
    steps = bool(p.parts) and _TOGETHER.fullmatch(line) is not None
    if steps or (len(names) <= 3 and first.kind == "key" and first.value in MODES and listed and not tipped):
        p.mode, p.advised = "assembly" if steps else MODES[str(first.value)], False
        p.below = BELOW.get(str(first.value), "")
        p.heading = None
        p.passed.append(whole)
        return
    if row.marked and not p.parts and [t.word for t in names] == ["stitches"]:
        p.mode, p.heading = "abbreviations", None  # a list of those that are used, and no part
        p.passed.append(whole)
        return
    if p.heading is not None and (cut := _dyed_copies(p, tokens)):
        for part, some in ((tokens[:cut], True), (tokens[cut + 1 :], False)):
            raw = [t for t in row.tokens if (t.end <= tokens[cut].start) == some and t.start != tokens[cut].start]
            text_line(p, Row(raw, raw[0].start, raw[-1].end), part)
        return
    if p.heading is not None and (more := copies_alone(tokens) or _copies(p, row)) is not None:
        p.heading = replace(p.heading, copies=more[0], copies_span=more[1], strong=True, marked=True)
        return
    if (hue := dyed_only(p, tokens)) is not None:
        p.lead.append(Line((Action("color", whole, numbers=hue),), whole, False))
        return
    found = (
        copied(p, row, line) or heading(text, row, bare(p, tokens)) or heading(text, row, tokens) or small(p, row, line)
    )
    if found is not None and (_SUPPLY.match(line) or (p.mode == "materials" and eyes_listed(line))):
        p.passed.append(whole)  # "Safety eyes, 8 mm (2)" heads no part
        return
    if found is not None and first.value == "eyes" and len(names) == 1 and p.mode != "materials" and founds(p, near=3):
        found = replace(found, strong=True, marked=True)  # "Eyes", "Make 2" and their rounds
    lefts: list[list[Token]] = []
    shown = found is not None and found.strong and _SHOWN.search(line) is not None
    if (found is None or not (found.marked or shown)) and sentences(p, tokens, lefts):
        found = None
        for left in lefts:
            left_over(p, left)
        return
    if found is not None and p.heading is not None and p.heading.strong and _END_OF.match(found.name.lower()):
        p.passed.append(whole)  # "You begin with the end of the trunk", under "HEAD WITH TRUNK"
        return
    under = found is not None and over(p.heading, found) != "" and p.heading is not None and p.heading.strong
    apart = p.row_at > 0 and not p.rows[p.row_at - 1].tokens
    heads = apart and p.title is not None and founds(p, near=2)  # "Pot", "In Copper." and its rounds end a list
    if found is not None and (
        found.marked or found.strong or under or heads or p.mode not in ("materials", "abbreviations", "notes")
    ):
        # A marked heading ends the list that stands before it, and notes end where a part is headed.
        shaping = found.copies_span is None and p.mode == "" and names[0].word in _SHAPING
        if shaping and p.parts and p.parts[-1].last and p.parts[-1].off is None:
            p.passed.append(whole)  # "Shape Face and Head:" is no part
            return
        called = found.name.lower().split()
        titled = p.title is not None and called[-1] == "pattern" and len(called) > 1 and called[0] not in _PLANNED
        if titled and _begun_below(p):
            called = called[:-1]
            found = replace(found, name=" ".join(found.name.split()[:-1]), strong=True)  # "DIRT PATTERN"
        if called[0] in _JOININGS and len(called) > 2 and finishing(p, tokens):
            p.mode, p.heading = "assembly", None  # "JOINING CAP AND GILLS"
            return
        plan = called[-1] in _PLANS or (p.heading is not None and called[0] in _JOININGS)
        plan = plan or (p.heading is not None and _FOUNDED.match(text, found.span.start) is not None)
        if plan and found.copies_span is None and p.title is not None:
            p.passed.append(whole)  # "Stripe Pattern", "Joining legs:" and "Base: Ch 3" under BODY are no parts
            return
        # Without a blank line too, where its rounds follow: "8 mm eyes", "HEAD", "Use mint yarn", "R1: …".
        parted = apart or (bool(called and kind_of(one(called[-1]))) and founds(p, near=2))
        alone = (found.strong and parted) or heads
        p.mode = "" if found.marked or p.mode == "notes" or alone or under else p.mode
        if p.title is None:
            p.title = (text[found.span.start : found.span.end], found.span)
            named = bool(found.name and kind_of(one(found.name.lower().split()[-1])))
            pasted = named and (founds(p, near=1) or (_yarn_below(p) and founds(p, near=2)))
            p.heading = found if found.strong or (pasted and _close(p)) else None  # "Head", and its rounds below
        elif p.heading is None or p.heading.copies_span is None or found.copies_span is not None or _far(p, found):
            p.over = over(p.heading, found) or p.over
            p.early["family"] = family(p.heading, found)
            p.heading = found
            headed_by(p)
        else:
            p.pair = p.heading  # "Ears (make 2)" stays over "Inside Ear:", which "Outside Ear:" may follow
        if found.copies > 1 and found.name == "":
            p.heading = None
        return
    if p.title is None and names:
        end = next((t.start for t in row.tokens if t.word in (".", ":")), row.end)
        p.title = (text[row.tokens[0].start : end].strip(), Span(row.tokens[0].start, end))
    else:
        p.passed.append(whole)
    for left in lefts:
        left_over(p, left)


def _copies(p: State, row: Row) -> tuple[int, Span] | None:
    """The copies that a line below a heading says, and nothing else: "x2", "You need two of these."."""
    name = p.heading.name.lower().split() if p.heading is not None else []
    many = copies_of(row.tokens, TERMS[p.language.code].heard, frozenset(w for word in name for w in (word, one(word))))
    return (many, Span(row.tokens[0].start, row.tokens[-1].end)) if many else None


def _dyed_copies(p: State, tokens: list[Token]) -> int:
    """Where the comma stands between copies and a yarn, of a line that says both and nothing else: "Make 2, with white yarn"; 0 for others."""
    cut = 2 if len(tokens) > 3 and tokens[2].word == "," else 0
    return cut if cut and copies_alone(tokens[:cut]) and dyed_only(p, tokens[cut + 1 :]) is not None else 0


def _begun_below(p: State) -> bool:
    """Whether a piece is begun in the next lines: with a first round, or with a sentence that founds it."""
    row = next((row for row in p.rows[p.row_at + 1 : p.row_at + 4] if row.tokens), None)
    said = p.vocabulary.read(row.tokens) if row is not None else []
    return founds(p, near=2) or founding(said) or any(t.kind == "key" and t.value == "ring" for t in said)


def _rounds_below(p: State) -> bool:
    """Whether a first round stands right below, and no first step of the assembly: "Face and body:", "1. 6 sc in MR"."""
    some = [row for row in p.rows[p.row_at + 1 : p.row_at + 4] if row.tokens][:2]  # below its yarn, or right below
    row = next((row for row in some if (h := p.vocabulary.heads(row.tokens)) and h[0][1].numbers[:1] == (1,)), None)
    if row is None:
        return False
    found = p.vocabulary.heads(row.tokens)
    return found[0][1].strong or rounds(p.vocabulary.read(row.tokens)[found[0][1].end :], True)


def _defines(tokens: list[Token]) -> bool:
    """Whether a line only says a word of the trade in full: "ch - chain", "Sc: (Single Crochet)", "BLO - back loops only", "Slip stitch (sl st)"."""
    if len(tokens) > 3 and tokens[-3].word == "(" and tokens[-1].word == ")":
        short, said = tokens[-2], [t for t in tokens[:-3] if t.word != "or"]
        alike = all((t.kind, t.value) == (short.kind, short.value) and t.word != short.word for t in said)
        return alike and short.kind in ("stitch", "key")
    plain = [t for t in tokens if t.word not in ("(", ")", ",", ".")]
    if len(plain) < 3 or plain[1].word not in ("-", ":", "=") or any(t.kind == "number" for t in plain[:3]):
        return False
    said = [t for t in (plain[0], plain[2]) if t.kind in ("stitch", "key")]
    return len(said) == 2 and said[0].value == said[1].value and said[0].word != said[1].word


_PLAIN: Final = ("sc", "hdc", "dc", "tr")


def _nearest(p: State, name: str, kind: str, span: Span) -> None:
    """Tells of a stitch of the pattern's own that is worked and drawn as a usual one, where the text has it: "cross sc" as sc."""
    if "-" not in name or not (kind in _PLAIN or kind.startswith("dec")):
        return
    said = re.compile(rf"\b{re.escape(name).replace(re.escape('-'), '[- ]')}", re.IGNORECASE)
    if len(said.findall(p.source.text.text)) > 1:
        shown = TERMS[p.language.code].word(kind)
        p.source.doubt(f"approximated: {name.replace('-', ' ')}", f"it is worked and drawn as {shown}", span)


def _hooked(p: State, tokens: list[Token]) -> bool:
    """Takes the yarn of a line that names it beside the hook, and works nothing: "Crochet hook C in green"."""
    if not any(t.value == "hook" for t in tokens) or any(t.kind == "stitch" for t in tokens) or p.mode == "materials":
        return False
    for k, token in enumerate(tokens[:-1]):
        hue = p.palette.color(Cursor(tokens, k + 1)) if token.value in ("in", "with") else None
        if hue is not None and k + 1 + hue[1] == len(tokens):
            span = Span(tokens[k + 1].start, tokens[-1].end)
            p.lead.append(Line((Action("color", span, numbers=hue[0]),), span, False))
            return True
    return False


def _yarn_of(p: State, tokens: list[Token]) -> bool:
    """Whether a line right below the name of a part that stands over the text only says its yarn, and its first round follows: "Head", "With
    white yarn", "Rnd 1: …"."""
    part = p.heading is not None and kind_of(one(p.heading.name.lower().split()[-1]))
    return bool(part) and _only_yarn(tokens) and founds(p, near=1)


def _yarn_below(p: State) -> bool:
    """Whether the next line only says a yarn."""
    below = p.rows[p.row_at + 1].tokens if p.row_at + 1 < len(p.rows) else []
    return bool(below) and _only_yarn(p.vocabulary.read(below))


def _only_yarn(tokens: list[Token]) -> bool:
    """Whether words name no more than a yarn: "With white yarn", "Begin in dark brown."."""
    begins = tokens[0].kind == "key" and tokens[0].value in ("with", "in", "begin")
    return begins and len(tokens) <= _YARN and not any(t.kind in ("stitch", "number") for t in tokens)


_YARN: Final = 7  # words of a line that only says a yarn


def _close(p: State) -> bool:
    """Whether the next line stands right below, as it does below no title."""
    return p.row_at + 1 < len(p.rows) and bool(p.rows[p.row_at + 1].tokens)


def _far(p: State, found: Heading) -> bool:
    """Whether sentences stand between the heading at hand and the one that was found, so that the first names no part that is worked: "EYES
    (make 2) Cut two circles from felt. …"."""
    return (
        p.heading is not None
        and len(p.source.text.text[p.heading.span.end : found.span.start].strip(" \t\n():.")) > _NEAR
    )


def _said(p: State, span: Span) -> bool:
    """A line that is one of the writer's own sentences: of colour, of seams, of the end."""
    text = p.source.text.text[span.start : span.end]
    own = explained(text, p.source.stitches, p.phrases.terms) if not p.parts else []
    for new in own:
        known = p.vocabulary.read(rows(new.name)[0].tokens)[0]
        if known.kind == "stitch" and p.source.stitches[known.value].moves == new.moves:
            continue  # "SL = Slip Stitch": it joins rounds still
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
