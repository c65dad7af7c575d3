"""What is lost in silence: words of a printed pattern that can be struck out, or changed, and nobody notices.

python bench/silent.py FOLDER [--half even|odd|all] [--first N] [--clauses N] [--only WORD] [--list]

FOLDER holds a published set as for bench/printed.py, or texts (tests/data/habits). Each text is read whole; then so many of its
instructive clauses, drawn by hash and no wording twice, are struck out one by one, and each of their numbers and colours changed, and
the text is read again. A clause is told when a doubt or an unread sentence stands at it, understood when any
change of it changes what a maker gets (rounds, counts, copies, yarns, places, faces, doubts), carried alone when only the booklet
has it, in its designer's words, and lost otherwise. Where only a number or a colour can be changed unseen, that is lost.
"""

from __future__ import annotations

import argparse
import hashlib
import re
import sys
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass, fields, is_dataclass
from functools import lru_cache
from pathlib import Path
from typing import Any

sys.path.insert(0, str(Path(__file__).parent))
from printed import patterns

from tambour.core.errors import Problem, Span, TambourError, Text
from tambour.crochet.language.tree import Pattern
from tambour.crochet.page.doubted import doubted
from tambour.crochet.page.hers import hers
from tambour.crochet.printed.choose import read

_CLAUSE = re.compile(r"[^\s,;.:()\[\]{}*!?\n–—|][^,;:()\[\]{}*!?\n–—|]*?(?=\.(?:\s|$)|[,;:()\[\]{}*!?\n–—|]|$)")
_HEAD = re.compile(r"\W*(?:(?:rnds?|rounds?|rows?|rd|r)\W*)?\d+(?:st|nd|rd|th)?(?:\W*(?:to|and|r|rnds?)?\W*\d+(?:st|nd|rd|th)?)*\W*(?:rnds?|rounds?|rows?)?\W*", re.IGNORECASE)  # fmt: skip
_NUMBER = re.compile(r"(?<![\w.])\d+(?![\w]*tog)|\b(?:two|three|four|five|six|seven|eight)\b", re.IGNORECASE)
_COLOR = re.compile(r"\b(?:white|black|red|blue|brown|pink|green|yellow|gr[ae]y|orange|beige|cream|purple)\b", re.IGNORECASE)  # fmt: skip
_ANYWAY = re.compile(
    r"(?:and |then )*(?:fasten|finish|bind|tie) off(?: yarn)?|fo|f/o|(?:\d+ )?sc (?:\d+ )?into (?:a )?magic ring|rep(?:eat)?(?: from)?(?: around)?|(?:and )?weave in (?:all )?(?:the |your )?(?:loose )?ends?|(?:and )?(?:cut|break) (?:the )?yarn"
    r"|(?:assembly|assembling|finishing|sewing(?: it)?(?: up)?|making up|to make up|embroidery|details|face)|.*\b(?:join(?:ed|ing)?|sl ?st|ss)\b(?: with)?(?: a)?(?: sl ?st)? (?:in|into|to) (?:the )?(?:1st|first|beg\w*|top)\b.*",
    re.IGNORECASE,
)  # fmt: skip
"""What striking out changes nothing of, since it is understood of itself."""
_INSTRUCTS = {
    "stitch": r"\b(?:\d*(?:sc|hdc|dc|tr|slst|ss|inc|dec|chs?)\d*|sl st|(?:hdc|sc|dc)\d?tog|chains?|crochet|increases?|decreases?|bobbles?|picots?|stitch(?:es)?|sts?|loops?|blo|flo)\b",
    "again": r"\b(?:rep(?:eat)?|same|as (?:for|in|rounds?|rnds?|given)|again|other|another|second|twice|both|each)\b",
    "doing": r"\b(?:make|work|turn|join|fasten|cut|leave|stuff|fill|sew|attach|embroider|change|switch|fold|insert|glue|pull|weave|close|flatten|pinch|place|skip|reverse|mark)(?:ing|ed|s|es|d)?\b",
    "color": _COLOR.pattern + r"|\bcolou?rs?\b|\b(?:with|in) [A-E]\b",
    "part": r"\b(?:head|body|ears?|arms?|legs?|tail|wings?|feet|foot|nose|muzzle|snout|beak|eyes?|mouth|hair|hat|fins?|horns?|petals?)\b",
    "number": r"\d",
}  # fmt: skip
_KINDS = {kind: re.compile(said, re.IGNORECASE) for kind, said in _INSTRUCTS.items()}


@dataclass
class Clause:
    """Some words of a text: where they stand, what they instruct by, and what became of them."""

    span: Span
    kind: str
    where: str
    fate: str = ""


def value(one: Any) -> Any:
    """A record as plain values, without its places."""
    if isinstance(one, Problem | Span):
        return None
    if is_dataclass(one):
        return (type(one).__name__, *(value(getattr(one, f.name)) for f in fields(one) if f.name != "notes"))
    if isinstance(one, list | tuple):
        return [value(x) for x in one]
    if hasattr(one, "items"):
        return [(k, value(v)) for k, v in sorted(one.items())]
    return one


@lru_cache(maxsize=64)
def got(words: str, name: str) -> Any:
    """What a maker gets of a text: what is worked and put together and what is told; and the notes that stand beside it."""
    try:
        p = read(Text(words, name))
    except TambourError as error:
        return str(error)
    except Exception as fault:  # noqa: BLE001 - a traceback is told in the table
        return f"TRACEBACK {fault!r}"
    told = [(q.message, words[q.span.start : q.span.end].split() if q.span else ()) for q in (*p.unread, *p.warnings)]
    notes = [words[n.start : n.end].split() for part in p.parts for line in part.lines for n in line.notes]
    return (value([p.parts, p.finish, p.worn, {k: v[0] for k, v in p.stated.items()}, list(p.own)]), told), notes


def fates(p: Pattern, words: str) -> tuple[list[Span], list[Span], str]:
    """What of a text is told with its place, what its booklet carries, and the words that it carries at the end."""
    told = [q.span for q in (*p.unread, *p.warnings) if q.span is not None and q.span.end > q.span.start]
    mine = hers(p, p.terms)
    carried = [span for said in mine.inside.values() for _, span in said] if mine is not None else []
    carried += [n for part in p.parts for line in part.lines for n in line.notes]
    carried += [span for key, (_, span) in p.stated.items() if key != "title"]
    carried += [span for f in p.finish if (span := getattr(f, "span", None)) is not None]
    closing = " ".join([*mine.closing, *mine.sentences, *mine.intro, *mine.materials]) if mine is not None else ""
    return [*told, *doubted(p)], carried, " ".join(re.findall(r"\w+", closing.lower()))


def clauses(words: str, begin: int, p: Pattern) -> Iterator[Clause]:
    """The instructive clauses of a text's body."""
    rounds = [line.span for part in p.parts for line in part.lines if line.in_round]
    named = [part.span for part in p.parts]
    for m in _CLAUSE.finditer(words, begin):
        kind = next((k for k, said in _KINDS.items() if said.search(m[0])), None)
        if kind is None or _HEAD.fullmatch(m[0]) or _ANYWAY.fullmatch(m[0].strip()):
            continue
        span = Span(m.start(), m.end())
        inside = any(s.start <= span.start < s.end for s in rounds)
        where = "round" if inside else "heading" if any(s.start <= span.start < s.end for s in named) else "between"
        yield Clause(span, kind, where)


def changed(words: str, span: Span) -> Iterator[tuple[str, str]]:
    """A text with a clause struck out, then with each of its numbers and its colours changed."""
    said = words[span.start : span.end]

    def put(what: str) -> str:
        return words[: span.start] + what + words[span.end :]

    yield "clause", put(" ")
    for m in _NUMBER.finditer(said):
        other = str(int(m[0]) + 1) if m[0].isdigit() else "nine"
        yield "number", put(said[: m.start()] + other + said[m.end() :])
    for m in _COLOR.finditer(said):
        yield "color", put(said[: m.start()] + ("teal" if m[0] != "teal" else "red") + said[m.end() :])


def audit(name: str, words: str, most: int) -> list[Clause]:
    """The clauses of one text that are drawn, with their fates."""
    try:
        pattern = read(Text(words, name))
    except TambourError:
        return []
    body = words.find("INSTRUCTIONS\n")
    begin = body + len("INSTRUCTIONS\n") if body >= 0 else min((s.span.start for s in pattern.parts), default=0)
    drawn: dict[str, Clause] = {}
    for one in clauses(words, begin, pattern):
        drawn.setdefault(re.sub(r"\W+|\d+", " ", words[one.span.start : one.span.end].lower()), one)
    order = sorted(drawn, key=lambda said: hashlib.sha256(f"{name}{said}".encode()).digest())
    told, carried, closing = fates(pattern, words)
    for said in order[:most]:
        one = drawn[said]
        plain = " ".join(re.findall(r"\w+", words[one.span.start : one.span.end].lower()))
        if any(s.start < one.span.end and one.span.start < s.end for s in told):
            one.fate = "told"
            continue
        kept = any(s.start <= one.span.start and one.span.end <= s.end for s in carried)
        kept = kept or (one.where == "between" and f" {plain} " in f" {closing} ")
        less, off = piece(words, one, pattern)
        near = Clause(Span(one.span.start - off, one.span.end - off), one.kind, one.where)
        one.fate = probed(name, less, near, kept) if less != words else ""
        if one.fate != "understood":  # seen in the whole text too
            one.fate = probed(name, words, one, kept)
    return [drawn[said] for said in order[:most]]


def piece(words: str, one: Clause, p: Pattern) -> tuple[str, int]:
    """What of a text is enough to see a change of a clause within a part: what stands before the parts, and that part; and where it begins."""
    begins = sorted({words.rfind("\n", 0, s.span.start) + 1 for s in p.parts} | {len(words)})
    k = max((k for k, at in enumerate(begins) if at <= one.span.start), default=-1)
    if one.where == "between" or k < 0 or k + 1 >= len(begins):
        return words, 0
    before = words[: begins[0]]
    return before + words[begins[k] : begins[k + 1]], begins[k] - len(before)


def probed(name: str, words: str, one: Clause, kept: bool) -> str:
    """What becomes of a clause: lost where nothing of it can be struck or changed so that it shows, or one of its words cannot; only carried
    where the booklet has it all the same."""
    silent, shown = [], 0
    whole = got(words, name)
    at = 0 if kept else slice(None)
    for kind, other in changed(words, one.span):
        again = got(other, name)
        if isinstance(again, str) and again.startswith("TRACEBACK"):
            return again
        if not isinstance(again, str) and again[at] == whole[at]:
            silent.append(kind)
        else:
            shown += 1
        if kept:
            return "carried alone" if silent else "understood"
    if "clause" in silent:
        return "understood" if shown and not {"number", "color"} & set(silent) else "lost clause"
    return f"lost {silent[0]}" if silent else "understood"


def texts(folder: Path, half: str) -> list[tuple[str, str]]:
    """The texts of a folder: published ones in files of JSON, or plain ones."""
    plain = sorted(p for p in folder.iterdir() if p.suffix in (".txt", ".md"))
    return [(p.name, p.read_text(encoding="utf-8")) for p in plain] or patterns(folder, half)


def main() -> None:
    """Prints the shares, and where asked what is lost."""
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("folder", type=Path, nargs="?")
    arguments.add_argument("--half", choices=("even", "odd", "all"), default="even")
    arguments.add_argument("--first", type=int, default=10_000, help="so many texts, drawn by hash")
    arguments.add_argument("--clauses", type=int, default=25)
    arguments.add_argument("--only", default="")
    arguments.add_argument("--list", action="store_true")
    asked = arguments.parse_args()
    if asked.folder is None:
        print("python bench/silent.py FOLDER: give the folder of a published set, or of texts")
        return
    some = sorted(texts(asked.folder, asked.half), key=lambda one: hashlib.sha256(one[0].encode()).digest())
    found: list[Clause] = []
    for name, words in [one for one in some if asked.only in one[0]][: asked.first]:
        mine = audit(name, words, asked.clauses)
        found += mine
        for one in mine if asked.list else ():
            if not one.fate.startswith(("told", "understood")):
                line = words.count("\n", 0, one.span.start) + 1
                around = words[max(0, one.span.start - 40) : one.span.start].replace("\n", "¶")
                after = words[one.span.end : one.span.end + 30].replace("\n", "¶")
                print(f"{name}:{line} {one.fate}, {one.kind} in {one.where}: {around}«{words[one.span.start : one.span.end]}»{after}", flush=True)  # fmt: skip
    print(f"clauses {len(found)}")
    for fate, many in Counter(one.fate for one in found).most_common():
        print(f"{fate:16} {many:5} ({100 * many / max(len(found), 1):.1f} %)")
    for what, many in Counter(
        f"{one.fate}, {one.kind} in {one.where}"
        for one in found
        if not one.fate.startswith(("told", "carried", "understood"))
    ).most_common():
        print(f"    {many:4} {what}")


if __name__ == "__main__":
    main()
