"""Annotated: the designer's text as an editor gives it back: her words untouched, counts ticked, doubts under their lines, pictures beside the parts."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from functools import lru_cache, partial
from io import BytesIO
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Problem, Text
from tambour.crochet.graph.built import Built
from tambour.crochet.graph.check import size_edit, tech_edit
from tambour.crochet.language.finishes import GUESSED, UNSEEN

if TYPE_CHECKING:
    from tambour.crochet.page.album import Album
    from tambour.crochet.piece import Plush

TICK, DOUBT, NOTE = "✓", "✗", "?"
"""Signs in the margin: a count that holds, something wrong or doubtful, something that was guessed or not understood."""
_WIDE: Final = 2
_FEW: Final = 2
"""A part of no more stitches shows nothing."""
_PIXELS: Final = (480, 400)
"""Width and height of a picture beside the text."""
DOCUMENTS: Final = (".docx", ".odt", ".html", ".htm", ".pdf")
"""Files whose headings are no characters: those that stand before them in the text that was read are not hers."""
_MARKS: Final = re.compile(r"^#{1,6} ")


def view(piece: Plush) -> Text:
    """The text of the pattern, edited; see :func:`annotated`."""
    import numpy as np

    size = tuple(float(v) for v in np.ptp(piece.positions, axis=0)) if len(piece.positions) else (0.0, 0.0, 0.0)
    made = annotated(piece.built, size)
    return replace(made, beside=_beside(piece, made.text)) if len(piece.positions) else made


def _beside(piece: Plush, text: str) -> tuple[tuple[int, Callable[[], bytes]], ...]:
    """Pictures as computed, drawn when a file takes them: the whole beside the first line, each part beside its heading."""
    built, album = piece.built, lru_cache(maxsize=1)(partial(_album, piece))
    lines = [0, *(k + 1 for k, c in enumerate(text) if c == "\n")]
    found: list[tuple[int, Callable[[], bytes]]] = [(0, partial(_drawn, album, ()))]
    for number, section in enumerate(built.pattern.parts):
        parts = [k for k, part in enumerate(built.parts) if part.section == number]
        graph = [built.graph.parts[k] for k in parts]
        if len(built.pattern.parts) > 1 and parts and graph[0].end - graph[0].start > _FEW and section.name:
            source = built.pattern.whole or built.pattern.text
            head = source.line(section.span.start).strip()
            at = next((k for k in lines if text[k:].split("\n", 1)[0][_WIDE:].strip() == head), -1)
            found += [(at, partial(_drawn, album, tuple(parts[:1])))] if head and at >= 0 else []
    return tuple(found)


def _album(piece: Plush) -> Album:
    from tambour.crochet.page.album import Album

    return Album(piece)


def _drawn(album: Callable[[], Album], parts: tuple[int, ...]) -> bytes:
    """A small picture of some parts, of all for none, as the bytes of a file."""
    from PIL import Image

    from tambour.crochet.page.pictures import from_side, of_parts

    wide, high = _PIXELS
    picture = of_parts(album(), parts, wide, high) if parts else from_side(album(), "front", wide, high)
    made = BytesIO()
    Image.fromarray(picture.rgba).save(made, "PNG")
    return made.getvalue()


def annotated(built: Built, size_mm: tuple[float, ...]) -> Text:
    """Every line of the source as it stands, with her pictures, a sign before it in the margin, and under it what is to be said of it.

    size_mm : width, height, depth of the piece, against which a stated size is held
    """
    text = built.pattern.whole or built.pattern.text
    document = text.name.lower().endswith(DOCUMENTS)
    guesses = [p for p in built.warnings if p.message.startswith((GUESSED, UNSEEN))]
    found = [*tech_edit(built), *size_edit(built, size_mm)]
    told = {(p.message, p.span) for p in found}
    unread = [p for p in built.pattern.unread if (p.message, p.span) not in told]
    under: dict[int, list[tuple[str, Problem]]] = {}
    for sign, problems in ((DOUBT, found), (NOTE, [*unread, *guesses])):
        for problem in problems:
            at = text.place(problem.span.start)[0] if problem.span is not None else 1
            under.setdefault(at, []).append((sign, problem))
    wrong = {at for at, said in under.items() if any(sign == DOUBT for sign, _ in said)}
    asked = {text.place(p.span.start)[0] for p in (*unread, *guesses) if p.span is not None and p.span.end}
    where: dict[tuple[str, str | None], list[int]] = {}
    for row in sorted(under):
        for _, problem in under[row]:
            where.setdefault((problem.message, problem.hint), []).append(row)
    stated = {text.place(w.line.stated_span.start)[0] for w in built.worked if w.line.stated_span is not None}
    lines: list[str] = []
    photos = sorted(text.photos, key=lambda photo: photo[0])
    kept: list[tuple[int, bytes]] = []
    at = 0  # characters of the source so far
    for number, line in enumerate(text.text.rstrip("\n").split("\n"), 1):
        sign = DOUBT if number in wrong else NOTE if number in asked else TICK if number in stated else ""
        hers = _MARKS.sub("", line) if document else line
        lines.append(f"{sign:<{_WIDE}}{hers}".rstrip())
        at += len(line) + 1
        while photos and photos[0][0] < at:
            kept.append((sum(len(one) + 1 for one in lines) - 1, photos.pop(0)[1]))
        for mark, problem in under.get(number, []):
            first, *others = dict.fromkeys(where[problem.message, problem.hint])
            if number == first:  # what is the same elsewhere is said once
                said = problem.message + (f" ({problem.hint})" if problem.hint else "")
                also = f"; also at line {', '.join(map(str, others))}" if others else ""
                lines.append(f"{'':<{_WIDE}}    {mark} {said}{also}")
    counts = sum(w.line.stated is not None for w in built.worked)
    gaps = f", {len(unread)} place{'s' * (len(unread) > 1)} not understood" if unread else ""
    lines += [
        "",
        f"{sum(not r.aside for r in built.rounds)} rounds worked, {counts} stated counts checked, {len(found)} doubts{gaps}",
    ]
    return Text("\n".join(lines) + "\n", text.name, tuple(kept))
