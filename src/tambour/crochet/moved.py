"""Moved: a part that is sewn on is put over another stitch, and what says where it is sewn is written anew.

The words come from :mod:`tambour.crochet.page.placed` and are read back before they stand; where a person's words would
not put it there, those that say the stitch do.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Sequence
from dataclasses import dataclass, replace
from itertools import groupby

from tambour.core.errors import Span, TambourError, Text
from tambour.crochet.finish.placing import mirrored, off_middle
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Finish, Placed, Spot
from tambour.crochet.params import CrochetParams

NEAR = (0.6, 1.6)
"""Rounds and stitches that words may be off what the hand showed: they are said in whole and half rounds."""
LEVEL = 0.6
"""Rounds that the two of a pair may differ by, where a text says one of them and the other is in halves."""
MIDDLE, APART = 1 / 6, 2.0
"""Two are mirrored whose middle is no farther from the front's than this share of a round, and that are so many stitches apart or more."""
LEAN = 60.0
"""Degrees that a part may lean otherwise than it did, by words that do not say how far."""
_ROUNDS = re.compile(
    r"\b(?:rounds?|rnds?|rows?|r)\.?\s*\d+(?:\s*(?:and|to|&|-|–)\s*(?:(?:rounds?|rnds?|rows?|r)\.?\s*)?\d+)?", re.I
)
_FAR = re.compile(r",?\s*(?:about\s+)?\d+\s+(?:stitches|stitch|sts|st)\s+apart", re.IGNORECASE)
_BESIDE = re.compile(r",[^,.;]*?\b(?:of the front|of the back|left side|right side)\b")
_SEW = re.compile(r"(?:,[ \t]*)?\bsew[ \t]*\([^()\n]*\)", re.IGNORECASE)
_GONE = "\0"
_LEFT = re.compile(rf"^([ \t]*){_GONE}[{_GONE} \t]*,[ \t]*")
_COMMENT = re.compile(r"#[^\n]*")


@dataclass(frozen=True, slots=True)
class Moved:
    """The pattern's text, and the sentences in it that say where the part is now."""

    text: str
    sentence: str


def moved(source: Text, params: CrochetParams, part: str, onto: int) -> Moved:
    r"""The text with ``part`` (such as "Ear.1") sewn on with its middle over stitch ``onto``, a node of another part.

    Its other copy, where the two are mirrored, goes with it. Raises TambourError where it cannot be put there.

    >>> from tambour.core.errors import Text
    >>> words = "== Ball ==\nR1: MR(6) (6)\nR2: 6 inc (12)\nR3: 12 sc (12)\nR4: 12 sc (12)\nR5: 6 dec (6)\nFO\n"
    >>> words += "== Nose ==\nR1: MR(6) (6)\nR2: 6 sc (6)\nFO\nplace(Nose, Ball, round=3)\n"
    >>> moved(Text(words, "ball.acl"), CrochetParams(), "Nose", 31).sentence
    'place(Nose, Ball, round=4, stitch=1)'
    """
    from tambour.crochet.plush import worked

    built, _ = worked(source, params)
    known = Spots(built)
    k = known.parts.get(part)
    if k is None or not 0 <= onto < len(built.graph):
        raise TambourError("this part, or this stitch, is not in the pattern as it stands", hint="drag it once more")
    there = int(built.graph.part[onto])
    if there == k:
        raise TambourError("a part is not sewn to itself", hint="let it go over another part")
    old = next((r for r in built.pattern.finish if isinstance(r, Placed) and known.parts.get(r.part) == k), None)
    seams = [] if old else _seams(built, k)
    if old is None and not seams:
        hint = "write a sentence that sews it on, such as “Sew the ear to the head between rounds 4 and 5.”"
        raise TambourError("nothing in the words says where this part is sewn on", hint=hint)
    half = old is not None and old.spot.round % 1 == 0.5
    spot = _spot(known, onto, half)
    twin, skew = _twin(known, k, old)
    wanted = {k: replace(old, spot=spot) if old else Placed(_name(known, k), spot)}
    if twin is not None:
        other = next((r for r in built.pattern.finish if isinstance(r, Placed) and known.parts[r.part] == twin), None)
        across = mirrored(known, there, spot, skew)
        wanted[twin] = replace(other, spot=across) if other else Placed(_name(known, twin), across)
    if old is None:
        return _resewn(built, wanted, [*seams, *([] if twin is None else _seams(built, twin))])
    return _rewritten(built, params, wanted)


def _name(known: Spots, k: int) -> str:
    """What a part is called in the language: without a number where it is made once."""
    return min((n for n, at in known.parts.items() if at == k), key=len)


def _spot(known: Spots, node: int, half: bool) -> Spot:
    """The place of a stitch; ``half``: between its round and the next, where there is one."""
    built = known.built
    part = int(built.graph.part[node])
    rounds = [k for k, r in enumerate(built.rounds) if r.part == part]
    if not rounds:
        raise TambourError("this part has no rounds to sew to")
    k = min(rounds, key=lambda k: max(built.rounds[k].first - node, node - built.rounds[k].last, 0))
    number, nodes = known.numbers[k], known.stitches(k).tolist()
    stitch = min(range(len(nodes)), key=lambda i: abs(nodes[i] - node)) + 1.0
    between = half and known.round_at(part, number + 1) is not None
    return Spot(_name(known, part), number + 0.5 if between else float(number), stitch)


def _twin(known: Spots, k: int, old: Placed | None) -> tuple[int | None, float]:
    """The other copy of a part that is made twice, where the two are sewn on as in a mirror, and the sum of their offs:
    rounds in a spiral lean, so that patterns count a few stitches beside the middle."""
    built = known.built
    copies = [j for j, fact in enumerate(built.parts) if fact.section == built.parts[k].section]
    if old is not None and len(copies) > 2:  # two pairs of feet, or ears of two layers: the one that stands opposite
        placed = {known.parts[r.part]: r.spot for r in built.pattern.finish if isinstance(r, Placed)}
        near = [j for j in copies if j == k or (j in placed and abs(placed[j].round - old.spot.round) <= LEVEL)]
        copies = near if len(near) == 2 else copies
    if len(copies) != 2:
        return None, 0.0
    twin = copies[1 - copies.index(k)]
    if old is None:
        spots = [_sewn_at(known, j) for j in (k, twin)]
    else:
        found = {known.parts[r.part]: r.spot for r in built.pattern.finish if isinstance(r, Placed)}
        spots = [found.get(k), found.get(twin)]
    one, other = spots
    if one is None or other is None or one.part != other.part or abs(one.round - other.round) > LEVEL:
        return None, 0.0
    (a, n), (b, _) = (off_middle(known, known.parts[one.part], s) for s in (one, other))
    return (twin, a + b) if abs(a + b) <= MIDDLE * n and a * b < 0.0 and abs(a - b) > APART else (None, 0.0)


# -- written in tambour's own language: lines, and marks that are sewn ------------------------------------------------


def _calls(text: str) -> list[re.Match[str]]:
    """Every ``sew(…)`` of a text, those in comments left out."""
    comments = [m.span() for m in _COMMENT.finditer(text)]
    return [m for m in _SEW.finditer(text) if not any(a <= m.start() < b for a, b in comments)]


def _pairs(built: Built, k: int) -> list[tuple[int, int]]:
    """Which pairs of ``built.sewn`` sew part ``k`` on, as (index, the stitch of the part it hangs on)."""
    part, found = built.graph.part, []
    for i, (a, b) in enumerate(built.sewn.tolist()):
        if k in (part[a], part[b]) and part[a] != part[b]:
            other = b if part[a] == k else a
            if part[other] < k:
                found.append((i, other))
    return found


def _seams(built: Built, k: int) -> list[Span]:
    """Where the text sews the marks of part ``k`` to those of a part before it; empty where it does not."""
    calls = _calls(built.pattern.text.text)
    if len(calls) != len(built.sewn):  # a line that is worked several times: its sews cannot be told apart
        return []
    return [Span(*calls[i].span()) for i, _ in _pairs(built, k)]


def _sewn_at(known: Spots, k: int) -> Spot | None:
    """The middle of the stitches that part ``k`` is sewn to by marks."""
    nodes = [node for _, node in _pairs(known.built, k)]
    spots = [_spot(known, node, False) for node in nodes]
    if not spots or len({s.part for s in spots}) > 1:
        return None
    middle = sorted(s.round for s in spots)[len(spots) // 2]
    return Spot(spots[0].part, middle, sum(s.stitch or 0.0 for s in spots) / len(spots))


def _resewn(built: Built, wanted: dict[int, Placed], seams: Sequence[Span]) -> Moved:
    """Marks that were sewn are sewn no more: a line for each part says where it goes."""
    text = built.pattern.text.text
    said = [_line(record) for record in wanted.values()]
    first = min(seams, key=lambda s: s.start)
    for span in sorted(seams, key=lambda s: -s.start):
        text = text[: span.start] + _GONE + text[span.end :]
    line = text.rfind("\n", 0, first.start) + 1
    rows = (text[:line] + "\n".join(said) + "\n" + text[line:]).split("\n")
    kept = [row for row in rows if _GONE not in row or row.replace(_GONE, "").strip(" \t,")]
    return Moved("\n".join(_LEFT.sub(r"\1", row).replace(_GONE, "") for row in kept), "; ".join(said))


def _line(record: Placed) -> str:
    """A placed part as a line of the language."""
    from tambour.crochet.words.phrases import number

    told = [record.part, record.spot.part, f"round={number(record.spot.round)}"]
    told += [] if record.spot.stitch is None else [f"stitch={number(round(record.spot.stitch, 1))}"]
    told += [f"{n}={number(getattr(record, n))}" for n in ("across", "tilt", "towards") if getattr(record, n)]
    told += ["flat"] * record.flat + ([] if record.by is None else [f"by={number(record.by)}"])
    return f"place({', '.join(told)})"


# -- written as people write ------------------------------------------------------------------------------------------


def _rewritten(built: Built, params: CrochetParams, wanted: dict[int, Placed]) -> Moved:
    """The sentences that the moved parts were read from, with other numbers; else said anew, as people say it; else by
    the stitch. The first that is read as it is meant."""
    pattern, known = built.pattern, Spots(built)
    text = pattern.text
    records = [
        wanted.get(known.parts[r.part], r) if isinstance(r, Placed) and r.part in known.parts else r
        for r in pattern.finish
    ]
    touched = {r.span for r in records if isinstance(r, Placed) and known.parts.get(r.part) in wanted}
    groups = [(span, list(of)) for span, of in groupby(records, lambda r: r.span) if span in touched]
    if not pattern.terms:
        return _put(text.text, [(span, "\n".join(map(_line_of, of))) for span, of in groups])
    old = next(r for r in pattern.finish if isinstance(r, Placed) and known.parts[r.part] in wanted)
    moved = [r for r in records if isinstance(r, Placed) and known.parts.get(r.part) in wanted]
    ways: list[Callable[[Span, list[Finish], float | None], str | None]] = [
        lambda span, of, apart: _renumbered(
            text.text[span.start : span.end], old, wanted[known.parts[old.part]], apart
        ),
        lambda span, of, apart: (
            None
            if apart is not None or len(wanted) != 1
            else _aside(text.text[span.start : span.end], old, wanted[known.parts[old.part]], built)
        ),
        lambda span, of, apart: _apart(". ".join(s.rstrip(".") for s in _people(built)(of)), apart),
        lambda span, of, apart: None if apart is not None else ". ".join(_exactly(built, wanted)(of)),
    ]
    for say in ways:
        apart: float | None = None
        for _ in range(3):
            said = [(span, say(span, of, apart)) for span, of in groups]
            if any(words is None for _, words in said):
                break
            # What was guessed, as nothing is said of it, is said at the end.
            end = Span(len(text.text), len(text.text))
            made = _put(
                text.text, [(span, words or "") if span.end else (end, f"\n\n{words}.\n") for span, words in said]
            )
            found = _heard(Text(made.text, text.name), params)
            if found is None:
                break
            if _agree(found, records):
                return made
            # Words say how far two parts stand from each other between their edges: as far as they are heard to.
            if len(wanted) != 2:
                break
            wide, heard = _between(known, list(wanted.values())), _between(found, _now(found, wanted))
            if apart is None:
                apart = wide
            elif round(apart + wide - heard) == round(apart):
                break
            else:
                apart = max(0.0, apart + wide - heard)
    # Her words stay, and the last word on the part, to the stitch, stands at the end: and on its like, and on all others,
    # where its place was theirs too ("sew the legs as shown").
    placed = [r for r in records if isinstance(r, Placed) and r.part in known.parts]
    section = {built.parts[k].section for k in wanted}
    alike = [r for r in placed if built.parts[known.parts[r.part]].section in section]
    last = ""
    for told in (moved, alike, placed):
        sure = ". ".join(_exactly(built, {known.parts[r.part] for r in told})(told))
        last = last or sure
        made = Moved(f"{text.text.rstrip()}\n\n{sure}.\n", last)
        found = _heard(Text(made.text, text.name), params)
        if found is not None and _agree(found, records):
            return made
    raise TambourError(
        "these words, written anew, would say another place", hint=f"write where it is sewn by hand, such as “{last}.”"
    )


def _renumbered(sentence: str, old: Placed, new: Placed, apart: float | None) -> str | None:
    """A sentence with the rounds of its part's place, and how far apart it stands, in other numbers."""
    if new.spot.part != old.spot.part:
        return None
    found = _round_said(sentence, old.part)
    if found is None:
        return None
    by = round(new.spot.round - old.spot.round)
    said = "".join(str(int(w) + by) if w.isdecimal() else w for w in re.split(r"(\d+)", found[0]))
    far = "" if apart is None else _so_far(apart)
    rest = sentence[found.end() :] if apart is None else _FAR.sub("", sentence[found.end() :])
    return sentence[: found.start()] + said + far + rest


def _aside(sentence: str, old: Placed, new: Placed, built: Built) -> str | None:
    """A sentence with its part's place in other numbers, and how far that is from the middle of the front."""
    from tambour.crochet.page.placed import Spoken
    from tambour.crochet.words.table import TERMS

    said = _renumbered(sentence, old, new, None)
    found = None if said is None else _round_said(said, old.part)
    if said is None or found is None or "," in found[0]:
        return None
    words = Spoken(built, TERMS[built.pattern.terms]).where([new.spot])[1:]
    beside = _BESIDE.match(said, found.end())
    rest = said[beside.end() if beside else found.end() :]
    return f"{said[: found.end()]}, {words[0]}{rest}" if words else None


def _round_said(sentence: str, part: str) -> re.Match[str] | None:
    """Where a sentence says the rounds that a part is sewn to."""
    begin = sentence.lower().find(part.rpartition(".")[0].lower() or part.lower())
    return _ROUNDS.search(sentence, max(0, begin)) or _ROUNDS.search(sentence)


def _apart(sentence: str, apart: float | None) -> str | None:
    """A sentence with another number of stitches apart; None where it says none."""
    if apart is None:
        return sentence
    return _FAR.sub(_so_far(apart), sentence) if _FAR.search(sentence) else None


def _so_far(apart: float) -> str:
    return f", {round(apart)} {'stitch' if round(apart) == 1 else 'stitches'} apart"


def _between(known: Spots, records: Sequence[Placed]) -> float:
    """How many stitches two parts' middles stand from each other, over the front, as words have it."""
    if len(records) != 2 or records[0].spot.part not in known.parts:
        return 0.0
    part = known.parts[records[0].spot.part]
    (a, _), (b, _) = (off_middle(known, part, r.spot) for r in records)
    return abs(a - b)


def _now(known: Spots, wanted: dict[int, Placed]) -> list[Placed]:
    """The records of these parts as they stand in another reading."""
    found = known.built.pattern.finish
    return [r for r in found if isinstance(r, Placed) and known.parts.get(r.part) in wanted]


def _line_of(record: Finish) -> str:
    assert isinstance(record, Placed)  # a line of the language says one record
    return _line(record)


def _put(text: str, said: Sequence[tuple[Span, str]]) -> Moved:
    for span, words in sorted(said, key=lambda one: -one[0].start):
        text = text[: span.start] + words + text[span.end :]
    return Moved(text, ". ".join(words.strip().rstrip(".") for _, words in said))


def _people(built: Built) -> Callable[[Sequence[Finish]], list[str]]:
    from tambour.crochet.page.placed import Spoken
    from tambour.crochet.words.table import TERMS

    return Spoken(built, TERMS[built.pattern.terms])


def _exactly(built: Built, wanted: Container[int]) -> Callable[[Sequence[Finish]], list[str]]:
    """What says the stitch of the parts ``wanted``, and of the others what people say."""
    from tambour.crochet.words.phrases import Phrases
    from tambour.crochet.words.table import TERMS

    copies = {section.name: section.copies for section in built.pattern.parts}
    phrases, people, known = Phrases(TERMS[built.pattern.terms], copies, {}), _people(built), Spots(built)

    def say(records: Sequence[Finish]) -> list[str]:
        moved = [r for r in records if isinstance(r, Placed) and known.parts.get(r.part) in wanted]
        said = [phrases.finish(_counted(known, r)) for r in moved if isinstance(r, Placed)]
        others = people([r for r in records if r not in moved])
        return [*(s.rstrip(".") for s in others), *(s[:1].upper() + s[1:] for s in said)]

    return say


def _counted(known: Spots, record: Placed) -> Placed:
    """A place in whole stitches, as makers count them."""
    spot = record.spot
    if spot.stitch is None:
        return record
    n = off_middle(known, known.parts[spot.part], spot)[1]
    return replace(record, spot=replace(spot, stitch=(round(spot.stitch) - 1) % n + 1.0))


def _heard(text: Text, params: CrochetParams) -> Spots | None:
    """A text read anew; None where it cannot be."""
    from tambour.crochet.plush import worked

    try:
        return Spots(worked(text, params)[0])
    except TambourError:
        return None


def _agree(known: Spots, wanted: Sequence[Finish]) -> bool:
    """Whether a text is read as these records: every part where it is wanted, nothing lost, nothing more."""
    found = known.built.pattern.finish
    if len(found) != len(wanted):
        return False
    at = {known.parts.get(r.part): r for r in found if isinstance(r, Placed)}
    for record in wanted:
        if not isinstance(record, Placed):
            continue
        now = at.get(known.parts.get(record.part))
        if now is None or now.spot.part != record.spot.part or abs(now.spot.round - record.spot.round) > NEAR[0]:
            return False
        part = known.parts[record.spot.part]
        (a, n), (b, _) = off_middle(known, part, record.spot), off_middle(known, part, now.spot)
        if abs((a - b + n / 2) % n - n / 2) > NEAR[1]:
            return False
        if record.flat != now.flat or abs(record.tilt - now.tilt) > LEAN:
            return False
    return True
