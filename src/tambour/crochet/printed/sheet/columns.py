"""Printed patterns, columns: tables laid out by blanks, tabs or rules under a line of titles, with cells that run over several lines, and that of the
assembly, as lines: ``15   flo: (6 sc, inc) 6   48   #1`` as "rnd 15: with terracotta, flo: (6 sc, inc) 6 times (48)"."""

from __future__ import annotations

import re
from dataclasses import dataclass, field, replace
from itertools import pairwise
from typing import Final

from tambour.crochet.printed.sheet.leaves import is_foot
from tambour.crochet.printed.tokens import Row, Token
from tambour.crochet.printed.yarns.shades import dyed, shade

_ROUNDS: Final = frozenset("rnd rnds round rounds rd rds r row rows # no nr".split())
_BODIES: Final = frozenset(
    "instruction instructions pattern directions description stitches work working do what".split()
)
_COUNTS: Final = frozenset("sts st total totals count counts # number stitches = tot".split())
_YARNS: Final = frozenset("yarn yarns color colour colors colours col shade hue".split())
_WHAT: Final = frozenset("what piece part pieces parts item".split())
_ONTO: Final = frozenset("onto to on attach attached sewn".split())
_WHERE: Final = frozenset("where position place placement how location details".split())
_GAP: Final = re.compile(r"\t|\s{2,}|\.{4,}")
_RULE: Final = frozenset("|│┃║¦")
_BORDER: Final = re.compile(r"[\s|│┃║+\-─━═┌┐└┘├┤┬┴┼=:]*$")
_UNIT: Final = frozenset("st sts sc stitches stitch ( ) [ ] = total tot - :".split())
_SPAN: Final = re.compile(
    r"(?:(?:rnds?|rounds?|rds?|rows?|r) ?(?:\. ?)?)?(\d+)(?: ?(?:-|to|and|&|,|~|/) ?(?:r ?)?(\d+))?(?: ?[.:)])?$"
)
_MOST: Final = 400
_WORKS: Final = frozenset("sc hdc dc tr sl slst ch inc dec sts st stitch stitches around side sides".split())
_LETTERS: Final = 3  # of a yarn's letter: "MC", "CC1"
_TITLES: Final = 7  # columns
_LEGEND: Final = re.compile(r"#[ \t]?(\d{1,2})[ \t]*[:=–-]?[ \t]*([A-Z][a-z]+(?: [a-z]+)?)")


@dataclass
class _Table:
    """The columns of a table: what each holds, and where it begins on its line (blanks) or which it is (rules)."""

    kinds: list[str]
    begins: list[int]
    ruled: bool
    called: str
    last: int = 0
    yarn: str = ""
    entry: dict[str, list[Token]] | None = None
    """The row that is being collected."""
    at: int = 0
    led: bool = False
    """Whether a rule stands before the first column too."""
    notes: list[list[Token]] = field(default_factory=list)


def columned(text: str, rows: list[Row]) -> list[Row]:
    """``rows`` with those of tables under titles as lines of rounds, of notes and of sewing; titles and rules are empty."""
    hues = {f"#{m[1]}": m[2] for m in _LEGEND.finditer(text)}
    made = list(rows)
    table: _Table | None = None
    joined = False  # the line before this one is of the table
    for k, row in enumerate(rows):
        if not row.tokens:
            if text[row.start : row.end].strip() == "" and table is not None and table.kinds[0] == "what":
                joined = False
            continue
        titles = _titles(text, row)
        if titles is not None:
            _close(made, table, hues)
            if table is not None and titles.kinds[0] == "round" and titles.called == table.called:
                titles.last, titles.yarn, titles.at = table.last, table.yarn, table.at
            table, joined = titles, True
            made[k] = replace(row, tokens=[])
            continue
        if table is None:
            continue
        if _BORDER.match(text[row.start : row.end]):
            made[k] = replace(row, tokens=[])
            continue
        cells = _by_column(text, row, table)
        if not _begin(text, made, k, table, cells, hues) and not (joined and _go_on(made, k, table, cells)):
            _close(made, table, hues)
            joined = False
            if table.kinds[0] == "what":
                table = None
            continue
        joined = True
    _close(made, table, hues)
    return made


def _cells(text: str, row: Row) -> tuple[list[list[Token]], bool]:
    """The tokens of a line in its cells, and whether signs part them."""
    ruled = sum(t.word in _RULE for t in row.tokens) > 1 or any(t.word in _RULE for t in row.tokens[1:-1])
    cells: list[list[Token]] = [[]]
    for k, token in enumerate(row.tokens):
        if ruled and token.word in _RULE:
            cells.append([])
            continue
        if not ruled and k and _GAP.search(text[row.tokens[k - 1].end : token.start]):
            cells.append([])
        cells[-1].append(token)
    if ruled and row.tokens[0].word in _RULE:
        cells = cells[1:]
    if ruled and len(cells) > 1 and row.tokens[-1].word in _RULE:
        cells = cells[:-1]
    return cells, ruled


def _titles(text: str, row: Row) -> _Table | None:
    """The columns that a line of titles opens."""
    line = text[row.start : row.end]
    if not (_GAP.search(line.strip()) or any(c in _RULE for c in line)) or len(row.tokens) > 24:
        return None
    cells, ruled = _cells(text, row)
    if not 1 < len(cells) <= _TITLES or not all(cells[k] for k in range(len(cells))):
        return None
    if any(t.kind == "number" for c in cells for t in c):
        return None
    kinds: list[str] = []
    for cell in cells:
        words = [t.word for t in cell]
        head = words[0]
        if head in _ROUNDS and "round" not in kinds and (len(words) == 1 or words[1] in (".", "#", "no", "/")):
            kinds.append("round")
        elif head in _WHAT and "round" not in kinds and not kinds:
            kinds.append("what")
        elif head in _ONTO and "what" in kinds:
            kinds.append("onto")
        elif head in _WHERE and "what" in kinds:
            kinds.append("where")
        elif head in _YARNS:
            kinds.append("yarn")
        elif (
            head in _BODIES
            and "body" not in kinds
            and not (
                "count" not in kinds
                and head == "stitches"
                and len(cells) > 2
                and any(c[0].word in _BODIES - {"stitches"} for c in cells)
            )
        ):
            kinds.append("body")
        elif any(w in _COUNTS for w in words) and len(words) <= 3:
            kinds.append("count")
        else:
            kinds.append("note")
    rounds = "round" in kinds and "body" in kinds
    if not rounds and not ("what" in kinds and "onto" in kinds):
        return None
    called = (
        "row"
        if any(c[0].word in ("row", "rows") for c, kind in zip(cells, kinds, strict=True) if kind == "round")
        else "rnd"
    )
    at = text.rfind("\n", 0, row.tokens[0].start) + 1
    led = row.tokens[0].word in _RULE or text[at : row.tokens[0].start].strip() in _RULE
    return _Table(kinds, [c[0].start - row.start for c in cells], ruled, called, led=led)


def _by_column(text: str, row: Row, table: _Table) -> dict[str, list[Token]]:
    """What a line has of each column; those of blanks by where they begin."""
    cells, ruled = _cells(text, row)
    line = text.rfind("\n", 0, row.tokens[0].start) + 1
    led = row.tokens[0].word in _RULE or text[line : row.tokens[0].start].strip() in _RULE
    if ruled and table.ruled and not table.led and led:
        cells = [[], *cells]  # the first column is empty here
    found: dict[str, list[Token]] = {}
    for k, cell in enumerate(cells):
        if not cell:
            continue
        column = k if ruled and table.ruled else _column(text, row, cell[0], table)
        if column >= len(table.kinds):
            column = len(table.kinds) - 1
        found.setdefault(table.kinds[column], []).extend(cell)
    return found


def _column(text: str, row: Row, token: Token, table: _Table) -> int:
    if "\t" in text[row.start : row.end]:
        return text[row.start : token.start].count("\t")
    at = token.start - row.start
    return max((k for k, begin in enumerate(table.begins) if begin <= at + 1), default=0)


def _begin(
    text: str, made: list[Row], at: int, table: _Table, cells: dict[str, list[Token]], hues: dict[str, str]
) -> bool:
    """Whether a line begins an entry of the table, which then is the one collected."""
    first = "round" if "round" in table.kinds else "what"
    key = cells.get(first)
    if not key:
        return False
    if first == "what":
        if not cells.get("onto") and not cells.get("where"):
            return False
    else:
        said = _SPAN.match(" ".join(t.word for t in key))
        if said is None or len(cells) < 2:
            return False
        begin, end = int(said[1]), int(said[2] or said[1])
        if not begin <= end < _MOST or begin not in (1, table.last + 1):
            return False
        if begin == 1:
            table.yarn = ""
        table.last = end
    _close(made, table, hues)
    if first == "round" and table.last > 1 and table.at and begin > 1:
        for k in range(table.at + 1, at):
            if made[k].tokens and is_foot(text[made[k].start : made[k].end]):
                made[k] = replace(made[k], tokens=[])
    table.entry, table.at = {k: list(v) for k, v in cells.items()}, at
    return True


def _go_on(made: list[Row], at: int, table: _Table, cells: dict[str, list[Token]]) -> bool:
    """Whether a line goes on with the cells of the one above; what begins anew there is a note of its own."""
    first = "round" if "round" in table.kinds else "what"
    if first in cells or not cells:
        return False
    main = "body" if first == "round" else "where"
    said = cells.get(main, [])
    if table.notes and not set(cells) - {main} and not said[0].capital:
        table.notes[-1].extend(said)
        made[at] = replace(made[at], tokens=[])
        return True
    told = table.entry is not None and table.entry.get("count") and set(cells) == {main}
    if told and not any(t.kind == "number" or t.word in _WORKS for t in said):
        table.notes.append(said)  # "cut W, go on in B", below a round that is whole
        made[at] = replace(made[at], tokens=said)
        return True
    if table.entry is not None and (
        not said or not said[0].capital or _open(table.entry.get(main, [])) or first == "what"
    ):
        for kind, tokens in cells.items():
            table.entry.setdefault(kind, []).extend(tokens)
        made[at] = replace(made[at], tokens=[])
        return True
    if set(cells) - {main}:
        return False
    if table.entry is None:
        return False
    table.notes.append(said)
    made[at] = replace(made[at], tokens=said)
    return True


def _open(tokens: list[Token]) -> bool:
    """Whether a bracket is still open, or the words end where a sentence cannot."""
    words = [t.word for t in tokens]
    return words.count("(") > words.count(")") or words.count("[") > words.count("]") or (words[-1:] in (["-"], [","]))


def _close(made: list[Row], table: _Table | None, hues: dict[str, str]) -> None:
    """Puts the entry that was collected on its line."""
    if table is None or table.entry is None:
        return
    entry, row = table.entry, made[table.at]
    table.entry = None
    for notes in table.notes:
        for k in range(table.at + 1, len(made)):
            if made[k].tokens and notes and made[k].tokens[0] is notes[0]:
                made[k] = replace(made[k], tokens=notes, end=notes[-1].end)
    table.notes = []
    if "what" in table.kinds:
        made[table.at] = replace(row, tokens=_sewn(entry))
        return
    key, body = entry["round"], entry.get("body", [])
    said_as = _SPAN.match(" ".join(t.word for t in key))
    assert said_as is not None
    head = [_word(table.called, key[0], capital=True), _number(said_as[1], key[0])]
    if said_as[2]:
        head += [_word("-", key[-1]), _number(said_as[2], key[-1])]
    head.append(_word(":", key[-1]))
    yarn = entry.get("yarn", [])
    said = "".join(t.word for t in yarn)
    notes = entry.get("note", [])
    if notes and not yarn and shade(" ".join(t.word for t in notes)) is not None:
        yarn, notes, said = notes, [], "".join(t.word for t in notes)  # under a title that is a sign
    led: list[Token] = []
    rest: list[Token] = []
    if yarn and said != table.yarn and any(t.kind != "mark" for t in yarn):
        table.yarn = said
        named = [_word(w, yarn[0]) for w in hues[said].lower().split()] if said in hues else yarn
        words = " ".join(t.word for t in named)
        known = shade(words) is not None or dyed(words) is not None or len(words) <= _LETTERS
        dyes = [_word("with", yarn[0]), *named]
        led, rest = ([*dyes, _word(",", yarn[-1])], []) if known else ([], [_word(".", yarn[0]), *dyes])
    tail: list[Token] = []
    if count := entry.get("count", []):
        values = [t for t in count if t.kind == "number"]
        if len(values) == 1 and all(t is values[0] or t.word in _UNIT for t in count):
            tail = [_word("(", count[0]), replace(values[0], glued=True), _word(")", count[-1])]
        elif any(t.kind != "mark" for t in count):
            tail = [_word("(", count[0]), *count, _word(")", count[-1])]
    if notes:
        rest = [*rest, _word(".", notes[0]), *notes]
    while body and body[-1].word in (".", ","):
        body = body[:-1]
    body = _last_capital(body, tail)
    end = max(t.end for tokens in entry.values() for t in tokens)
    stop = [_word(".", (rest or body or head)[-1])]  # a note below is none of it
    made[table.at] = replace(row, tokens=[*head, *led, *body, *rest, *stop], end=max(row.end, end))


def _last_capital(body: list[Token], tail: list[Token]) -> list[Token]:
    """The words of a round with its count behind what is worked, and before a sentence about it: ``(6 sc, inc) 6 times. This makes …``."""
    at = next((k + 1 for k, (a, b) in enumerate(pairwise(body)) if a.word == "." and b.capital), None)
    return [*body, *tail] if at is None else [*body[: at - 1], *tail, *body[at - 1 :]]


def _sewn(entry: dict[str, list[Token]]) -> list[Token]:
    """A line of a table of the assembly as a sentence."""
    what, onto, where = (entry.get(kind, []) for kind in ("what", "onto", "where"))
    what = [t for k, t in enumerate(what) if t.word != "no" and not (t.word == "." and k and what[k - 1].word == "no")]
    words = {t.word for t in where}
    if not onto or not any(t.kind == "word" for t in onto) or "not" in words:
        return [*what, _word(":", what[-1]), *onto, *([_word(",", where[0])] if where and onto else []), *where]
    begin = what[0]
    lead = [_word("sew", begin, capital=True), *([] if begin.word in ("the", "both") else [_word("the", begin)])]
    mid = [_word("to", onto[0]), *([] if onto[0].word == "the" else [_word("the", onto[0])])]
    tail = [_word(",", where[0]), *where] if where else []
    return [*lead, *what, *mid, *onto, *tail, _word(".", (where or onto)[-1])]


def _word(word: str, at: Token, *, capital: bool = False) -> Token:
    return Token("word" if word[0].isalpha() else "mark", word, at.start, at.start, None, False, capital)


def _number(word: str, at: Token) -> Token:
    return Token("number", word, at.start, at.end, int(word))
