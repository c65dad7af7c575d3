"""Flow: pieces of text and pictures, set into columns and pages; what belongs together stays together."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field, replace

from tambour.crochet.page.type import HAIR, SMALL, SOFT
from tambour.render.page import Page


@dataclass(frozen=True, slots=True)
class Atom:
    """Something that is not broken: ``draw(sheet, x, y)`` sets it from its top left corner.

    space : mm above it, left out at the top of a column; keep : it stays with what comes next
    """

    height: float
    draw: Callable[[Page, float, float], None]
    space: float = 0.0
    keep: bool = False


@dataclass(slots=True)
class Chunk:
    """Atoms that stay together. ``title`` : the section they continue, said again at the top of a column when they are
    not its beginning (``first``)."""

    atoms: list[Atom] = field(default_factory=list)
    title: str = ""
    first: bool = True

    @property
    def height(self) -> float:
        """Its height at the top of a column."""
        return sum(a.height + a.space for a in self.atoms) - (self.atoms[0].space if self.atoms else 0.0)

    @property
    def above(self) -> float:
        """Space above it within a column."""
        return self.atoms[0].space if self.atoms else 0.0


_LAST = 4
"""Rows at the end of a section that stay together: two alone in the next column read as a part of their own."""


def together(heads: list[Atom], rows: list[Atom], title: str) -> list[Chunk]:
    """A section's chunks: the heading with its first three rows, the last four rows, and each row between by itself."""
    if len(rows) <= 3 + _LAST:
        return [Chunk([*heads, *rows], title)]
    made = [Chunk([*heads, *rows[:3]], title)]
    for row in rows[3:-_LAST]:
        if made[-1].atoms[-1].keep:
            made[-1].atoms.append(row)
        else:
            made.append(Chunk([row], title, False))
    if made[-1].atoms[-1].keep:
        made[-1].atoms += rows[-_LAST:]
    else:
        made.append(Chunk(rows[-_LAST:], title, False))
    return made


AGAIN = 6.5
"""Height of a section's title said again, mm."""


@dataclass(frozen=True, slots=True)
class Frame:
    """Where columns stand on a page: left edges, their width, top and bottom, mm."""

    lefts: tuple[float, ...]
    width: float
    top: float
    bottom: float


def _pack(chunks: list[Chunk], room: float) -> list[list[Chunk]]:
    """Chunks in columns of height ``room``."""
    columns: list[list[Chunk]] = []
    used = room + 1.0
    for chunk in chunks:
        if columns and used + chunk.above + chunk.height <= room:
            columns[-1].append(chunk)
            used += chunk.above + chunk.height
            continue
        columns.append([chunk])
        used = chunk.height + (0.0 if chunk.first else AGAIN)
    return columns


def flow(
    chunks: list[Chunk],
    frame: Frame,
    page: Callable[[], Page],
    again: str,
    below: tuple[Page, float] | None = None,
    head: Atom | None = None,
) -> None:
    """Set chunks into columns on as many pages as they take; the last page's columns are made equally high.

    page : begins a page; again : the word for "continued"
    below : a page that is begun and how far, for chunks that fit on the rest of it, under ``head``
    """
    under = frame.bottom if below is None else below[1] + (head.height if head else 0.0)
    first, rest = plan(chunks, frame, under)
    if below is not None and first:
        if head is not None:
            head.draw(below[0], frame.lefts[0], below[1])
        _set(first, replace(frame, top=under), below[0], again)
    for k in range(0, len(rest), len(frame.lefts)):
        _set(rest[k : k + len(frame.lefts)], frame, page(), again)


def plan(chunks: list[Chunk], frame: Frame, under: float) -> tuple[list[list[Chunk]], list[list[Chunk]]]:
    """The columns on a page that is begun, below ``under``, none where nothing fits there; and those of the pages after it."""
    many, full, room = len(frame.lefts), frame.bottom - frame.top, frame.bottom - under
    packed = _pack(chunks, room)
    if room > _LEAST * full and len(packed) <= many and all(c.height <= room for c in chunks):
        return _columns(chunks, room, many), []
    some = [chunk for column in packed[:many] for chunk in column]
    if room > _BEGIN * full and len(packed) >= many and all(c.height <= room for c in some):
        return _columns(some, room, many), _columns(chunks[len(some) :], full, many)
    return [], _columns(chunks, full, many)


def _columns(chunks: list[Chunk], full: float, many: int) -> list[list[Chunk]]:
    """Chunks in columns; those of the last page, ``many`` of them, are made equally high."""
    if not chunks:
        return []
    # A chunk that no column holds is let go row by row.
    whole: list[Chunk] = []
    for chunk in chunks:
        if chunk.height <= full - AGAIN:
            whole.append(chunk)
        else:
            whole += [Chunk([atom], chunk.title, chunk.first and k == 0) for k, atom in enumerate(chunk.atoms)]
    columns = _pack(whole, full)
    last = (len(columns) - 1) // many * many
    rest = [chunk for column in columns[last:] for chunk in column]
    if last == 0 and len(columns) < many and sum(c.height for c in rest) < 0.25 * full:
        low = full
    else:
        low = next((h for h in _heights(full) if len(_pack(rest, h)) <= many), full)
    columns[last:] = _pack(rest, low)
    return columns


def _set(columns: list[list[Chunk]], frame: Frame, sheet: Page, again: str) -> None:
    """Draw the columns of one page."""
    for x, column in zip(frame.lefts, columns):
        y = frame.top
        if not column[0].first:
            sheet.text(f"{column[0].title}, {again}", x, y + SMALL, SMALL, color=SOFT)
            sheet.line(x, y + SMALL + 1.4, x + frame.width, y + SMALL + 1.4, HAIR)
            y += AGAIN
        for k, chunk in enumerate(column):
            for j, atom in enumerate(chunk.atoms):
                y += atom.space if (k or j) else 0.0
                atom.draw(sheet, x, y)
                y += atom.height


_LEAST = 0.2
"""The rest of a page is begun on if so much of it is white and all fits there."""
_BEGIN = 0.28
"""What does not fit on the rest of a page begins there if so much of it is white."""


def _heights(full: float) -> list[float]:
    return [full * k / 40 for k in range(8, 41)]
