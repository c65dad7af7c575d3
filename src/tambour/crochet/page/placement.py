"""Placement: charts of the parts that others are sewn to: their rounds, numbered, and every seam, pressed flat onto the paper."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from itertools import pairwise
from math import atan2, cos, pi, sin
from typing import TYPE_CHECKING, Final

import numpy as np
import shapely

from tambour.core.check import Array
from tambour.core.graph import SEWN
from tambour.core.rgb import RGB
from tambour.crochet.finish.sewing import end_of
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import Eye, Placed
from tambour.crochet.page.begin import paragraph
from tambour.crochet.page.flow import Atom, Chunk
from tambour.crochet.page.middle import lies, middles, named
from tambour.crochet.page.type import BODY, HAIR, INK, LEADING, SMALL, SOFT, width_of, wrap
from tambour.geometry.motion import dot, turned
from tambour.geometry.surface import vertex_normals

if TYPE_CHECKING:
    from tambour.crochet.page.book import Book
    from tambour.render.page import Page

_VIEWS: Final = {
    "front": (0.0, 0.0),
    "back": (pi, 0.0),
    "its left": (0.5 * pi, 0.0),
    "its right": (-0.5 * pi, 0.0),
    "above": (0.0, 0.5 * pi),
    "below": (0.0, -0.5 * pi),
}
"""From where a part is drawn: azimuth and elevation, by the page's words; the front before all others."""
_DASHED: Final = {"front": 0.0, "above": 0.0, "below": 0.0, "back": 0.5}
"""Sides on which a dashed line is the middle of the front, or so much of a round on from it."""
_DASHED_TOP: Final = {"above": 0.0, "front": 0.0, "back": 0.0, "below": 0.5}
"""The same of the middle of the top, of what lies."""
_FACING: Final = 0.02
"""What faces the eye less than this, as a cosine, is behind the edge."""
_WELL: Final = 0.7
"""A ring is seen for what it is where its fabric faces the eye so much; less, and it is a line."""
_SHOWN, _ENOUGH, _FACED = 0.3, 0.45, 0.8
"""A seam is shown where so much of it is on the side that is looked at, and shown well enough: of arms at the sides it is half, of a ring
more."""
_MORE: Final = 0.35
"""What a second side shows more of something than the first, to be worth a chart."""
_HIGH: Final = 38.0
"""How high a chart is at the most, mm."""
_LEAST: Final = (4, 18)
"""A part of fewer rounds, or of fewer stitches in the longest, needs no chart: there is little to count."""
_SMALL: Final = 30
"""A part with fewer stitches in its longest round is small."""
_EVEN: Final = 3
"""How often stitches are moved between their neighbours."""
_CUTS: Final = 3
"""How often the corners of a seam are cut: stitches are its corners, and yarn has none."""
_BOW: Final = 4
"""A seam of no more stitches is straight."""
_NUMBER: Final = 2.3
"""Type of the rounds' numbers, and the least way from one to the next, mm."""
_LEFT, _RIGHT = 0.3, 0.12
"""Room beside the part for the names of what is sewn to it, and for the rounds' numbers, of the column's width."""


@dataclass(frozen=True, eq=False, slots=True)
class _Mark:
    """Something on a part: its name ("" an eye), the points (P, 3) that it is sewn to and the fabric's normals there, its colour, whether
    it is sewn on all round it, the rounds that it takes, and those that its sentences name."""

    name: str
    points: Array
    normals: Array
    color: RGB
    ring: bool
    rounds: tuple[int, ...]
    named: tuple[int, ...] = ()


def placement(book: Book) -> list[Chunk]:
    """A chart for every part in rounds that others are sewn to, from the one or two sides that show most of their seams; before the
    first what the charts mean."""
    built, x = book.piece.built, book.piece.positions
    spots, made, done, dashed = Spots(built), list[Chunk](), set[int](), list[str]()
    for record in built.pattern.finish:
        host = spots.parts.get(record.spot.part, -1) if isinstance(record, Placed) else -1
        counts = [r.count for r in built.rounds if r.part == host and not r.aside]
        if host in done or _like_another(book, spots, host, done) or _by_eye(book, spots, host, max(counts, default=0)):
            continue
        if spots.in_rows[host] or len(counts) < _LEAST[0] or max(counts) < _LEAST[1]:
            continue
        done.add(host)
        normals = vertex_normals(x, spots.faces(host))
        marks = _marks(book, spots, host, normals)
        if any(mark.name for mark in marks):
            sides = _sides(marks, lies(book, host))
            if any(side in _DASHED for side in sides):
                dashed.append(book.own["placement top" if lies(book, host) else "placement middle"])
            made += [_chart(book, spots, host, side, marks, normals) for side in sides]
    if made:
        said = dict.fromkeys([book.own["placement"], *dashed])
        made[0].atoms[:0] = paragraph(book.marked(" ".join(said)), book.frame.width, BODY)
    return made


def _like_another(book: Book, spots: Spots, host: int, done: set[int]) -> bool:
    """Whether a part is a copy of one that has its chart: the second thigh."""
    parts = spots.built.parts
    return any(parts[k].section == parts[host].section for k in done)


def _by_eye(book: Book, spots: Spots, host: int, most: int) -> bool:
    """Whether on a small part that is sewn on itself her sentences count nothing: a chart of it would be a blob."""
    placed = [r for r in spots.built.pattern.finish if isinstance(r, Placed)]
    if book.hers is None or most >= _SMALL or not any(spots.parts.get(r.part) == host for r in placed):
        return False
    return not any(book.taken.rounds(r) for r in placed if spots.parts.get(r.spot.part) == host)


def _marks(book: Book, spots: Spots, host: int, normals: Array) -> list[_Mark]:
    """What is sewn to a part away from its open end, and its eyes."""
    built, x = book.piece.built, book.piece.positions
    graph, made = built.graph, list[_Mark]()
    pairs = graph.edges[graph.edge_kind == SEWN]
    of = graph.part[pairs]
    rim = spots.sewn_rim(host)
    number = {int(n): spots.numbers[k] for k, r in enumerate(built.rounds) if r.part == host for n in spots.stitches(k)}
    for record in built.pattern.finish:
        if not isinstance(record, (Placed, Eye)) or spots.parts.get(record.spot.part, -1) != host:
            continue
        if isinstance(record, Eye):
            place = spots.place(record.spot)
            at, way = (np.average(v[list(place.nodes)], axis=0, weights=place.weights)[None] for v in (x, normals))
            between = (int(record.spot.round), int(np.ceil(record.spot.round)))
            made.append(_Mark("", at, way, record.color, True, between))
            continue
        part = spots.parts[record.part]
        mine = (of == (part, host)).all(1), (of == (host, part)).all(1)
        held = np.unique(np.concatenate([pairs[mine[0], 1], pairs[mine[1], 0]]))
        if record.through or len(held) < 2 or np.isin(held, rim).mean() > 0.5:
            continue
        name = built.pattern.parts[built.parts[part].section].name
        r, g, b = (int(v) for v in np.median(graph.color[graph.part == part], axis=0))
        rounds = tuple(sorted({number[n] for n in held.tolist() if n in number}))
        end = end_of(built, spots, record)
        made.append(
            _Mark(
                book.called(name),
                x[held],
                normals[held],
                (r, g, b),
                end.ring or end.laid,
                rounds,
                tuple(sorted(named(book, record))),
            )
        )
    return made


def _facing(side: str) -> Array:
    """The directions right, down and towards the eye of a view, the rows of a matrix (3, 3)."""
    a, e = _VIEWS[side]
    right = np.array([cos(a), 0.0, -sin(a)])
    back = np.array([cos(e) * sin(a), sin(e), cos(e) * cos(a)])
    return np.stack([right, np.cross(right, back), back])


def _share(marks: Sequence[_Mark], side: str) -> Array:
    """How much of each mark is on a side, and of a ring how well it faces the eye; copies of a part on the same rounds count together, as one
    sees them as a pair."""
    back = _facing(side)[2]
    faces = [dot(mark.normals, back) for mark in marks]
    ahead = np.array(
        [(np.clip(f / _WELL, 0.0, 1.0) if mark.ring else f > _FACING).mean() for f, mark in zip(faces, marks)]
    )
    pairs = [(mark.name, mark.rounds) for mark in marks]
    return np.array([ahead[[k for k, other in enumerate(pairs) if other == pair]].mean() for pair in pairs])


def _sides(marks: Sequence[_Mark], lying: bool = False) -> list[str]:
    """The side that shows most of what is sewn on, and the one that shows most of what is not seen there, where it is much of anything; in
    the order of the views."""
    some = [mark for mark in marks if mark.name]
    enough = np.where([mark.ring for mark in some], _FACED, _ENOUGH)
    whole = {side: _share(some, side) for side in _VIEWS}
    share = {side: np.minimum(whole[side], enough) for side in _VIEWS}

    def best(beside: str = "") -> str:
        # Of equals the first; of what lies, which has no end to look into from above, the one that shows all of it.
        more, all_of_it = (
            {side: round(float(np.maximum(of[side] - of.get(beside, 0.0), 0.0).sum()), 1) for side in _VIEWS}
            for of in (share, whole)
        )
        return max(_VIEWS, key=lambda side: (more[side], lying and all_of_it[side]))

    first = best()
    second = best(first)
    more = (share[second] - share[first]).max() >= _MORE
    return [side for side in _VIEWS if side == first or (side == second and more)]


def _chart(book: Book, spots: Spots, host: int, side: str, marks: Sequence[_Mark], normals: Array) -> Chunk:
    """One side of a part, pale in its colour: its rounds as lines of stitches with their numbers, and what is sewn on in its own colour."""
    built, x, width = book.piece.built, book.piece.positions, book.frame.width
    view, faces = _facing(side), spots.faces(host)
    nodes = np.unique(faces)
    seen = turned(x[nodes], view)[:, :2]
    low, high = seen.min(0), seen.max(0)
    room = width * (1.0 - _LEFT - _RIGHT)
    scale = min(room / float(high[0] - low[0]), _HIGH / float(high[1] - low[1]))
    wide, tall = (scale * (high - low)).tolist()
    start = width * _LEFT + 0.5 * (room - wide)

    def on(points: Array) -> Array:
        return np.asarray((turned(points, view)[:, :2] - low) * scale + (start, 0.0))

    pale = tuple(round(0.3 * float(v) + 0.7 * 255) for v in np.median(built.graph.color[nodes], axis=0))
    flat, ahead = on(_evened(spots, host, x)), dot(normals, view[2]) > _FACING
    lines, numbers = _rounds(spots, host, flat, ahead, side in ("above", "below"))
    shown = [mark for mark, share in zip(marks, _share(marks, side)) if share >= _SHOWN]
    wanted = {n for mark in shown for n in mark.named or (*mark.rounds[:1], *mark.rounds[-1:])}
    name = built.pattern.parts[built.parts[host].section].name
    head = f"{book.called(name)}, {book.own[side]}"
    lying = lies(book, host)
    on_from = (_DASHED_TOP if lying else _DASHED).get(side)
    places = "; ".join(middles(book, spots, host, wanted, on_from or 0.0).values())
    which = book.own[("under at" if lying else "back at") if on_from else ("top at" if lying else "middle at")]
    said = which.format(places=places) if places else ""
    middle = wrap(f"{said[:1].upper()}{said[1:]}", SMALL, width)

    def draw(sheet: Page, x0: float, y0: float) -> None:
        at = np.array([x0, y0])
        sheet.rings(flat[faces[ahead[faces].any(1)]] + at, pale, pale, 0.15)
        for line in lines:
            sheet.shape(line + at, None, SOFT, 0.12)
        sheet.circles(np.concatenate(lines) + at, 0.3, SOFT)
        if on_from is not None:
            _middle(sheet, spots, host, flat + at, ahead, on_from)
        for mark in shown:
            _sewn(sheet, mark, on(mark.points) + at)
        for n, spot, high in _spaced(numbers, wanted):
            column, y = x0 + start + wide + 2.5, y0 + high
            sheet.line(x0 + float(spot[0]) + 0.5, y0 + float(spot[1]), column - 0.5, y, HAIR, 0.15)
            sheet.text(str(n), column, y + 0.36 * _NUMBER, _NUMBER, n in wanted, INK if n in wanted else SOFT)
        _names(sheet, [(mark.name, on(mark.points) + at) for mark in shown if mark.name], x0, start - 2.0, y0, tall)
        sheet.paragraph([head, *middle], x0, y0 + tall + SMALL + 1.8, SMALL, color=SOFT)

    return Chunk([Atom(tall + SMALL + 3.0 + SMALL * LEADING * len(middle), draw, 4.0)], head)


def _evened(spots: Spots, host: int, x: Array) -> Array:
    """The stitches (N, 3) with each round's as even as a chart has them: each between its neighbours, but for a round's first and last."""
    made = x.copy()
    for k, r in enumerate(spots.built.rounds):
        nodes = spots.stitches(k)
        if r.part == host and len(nodes) > 2:
            for _ in range(_EVEN):
                made[nodes[1:-1]] = 0.5 * made[nodes[1:-1]] + 0.25 * (made[nodes[:-2]] + made[nodes[2:]])
    return made


def _rounds(spots: Spots, host: int, flat: Array, ahead: Array, level: bool) -> tuple[list[Array], dict[int, Array]]:
    """The rounds of a part as far as they are ``ahead`` (N,), lines (P, 2) in order, and where each is furthest to the right, or down
    where they lie ``level``: by number."""
    lines, numbers = list[Array](), dict[int, Array]()
    for k, r in enumerate(spots.built.rounds):
        nodes = spots.stitches(k)
        if r.part != host or r.aside or not len(nodes) or not ahead[nodes].any():
            continue
        hidden = np.flatnonzero(~ahead[nodes])
        ring = np.roll(nodes, -int(hidden[0])) if len(hidden) else np.append(nodes, nodes[0])
        cuts = np.flatnonzero(np.diff(ahead[ring].astype(int))) + 1
        shown = [flat[run] for run in np.split(ring, cuts) if ahead[run[0]]]
        lines += shown
        points = np.concatenate(shown)
        numbers[spots.numbers[k]] = points[np.argmax(points[:, 1 if level else 0])]
    return lines, numbers


def _spaced(numbers: dict[int, Array], wanted: set[int]) -> list[tuple[int, Array, float]]:
    """The numbers that find room above each other, with the heights that they stand at: those that are ``wanted``, all of them, moved apart
    where rounds lie closer than type; then fives, then the others."""
    first = sorted((n for n in numbers if n in wanted), key=lambda n: float(numbers[n][1]))
    high = np.array([float(numbers[n][1]) for n in first])
    for _ in range(100):  # neighbours that are too near share the way that they are moved
        short = np.maximum(_NUMBER - np.diff(high), 0.0)
        if not (short > 1e-3).any():
            break
        high[:-1] -= 0.5 * short
        high[1:] += 0.5 * short
    made = [(n, numbers[n], float(y)) for n, y in zip(first, high)]
    for n in sorted(set(numbers) - wanted, key=lambda n: (n % 5 != 0, n)):
        if all(abs(float(numbers[n][1]) - y) >= _NUMBER for *_, y in made):
            made.append((n, numbers[n], float(numbers[n][1])))
    return made


def _middle(sheet: Page, spots: Spots, host: int, flat: Array, ahead: Array, on: float) -> None:
    """The middle of the front, or what is so much of a round ``on`` from it, a dashed line from round to round."""
    line = list[Array]()
    for k, r in enumerate(spots.built.rounds):
        nodes = spots.stitches(k)
        if r.part != host or r.aside or len(nodes) < 3:
            continue
        i, share = divmod(spots.front(k) + on * len(nodes), 1.0)
        a, b = (int(nodes[int(i + j) % len(nodes)]) for j in (0, 1))
        if ahead[a] and ahead[b]:
            line.append((1.0 - share) * flat[a] + share * flat[b])
    for start, end in pairwise(line):
        sheet.shape([start, 0.5 * (start + end)], None, INK, 0.3)


def _sewn(sheet: Page, mark: _Mark, points: Array) -> None:
    """An eye as a dot; a ring as the outline of its stitches; an end that is pressed flat as the line that they lie along."""
    if not mark.name:
        sheet.circles(points, 1.3, mark.color, INK)
        return
    if mark.ring:
        ring = _rounded(shapely.get_coordinates(shapely.convex_hull(shapely.multipoints(points))))
        sheet.shape(ring, (*mark.color, 150), None)
        sheet.shape(ring, None, INK, 0.35)
        return
    x, y = (points - points.mean(0)).T
    along = 0.5 * atan2(2.0 * float((x * y).sum()), float((x * x - y * y).sum()))
    # Stitches of two rounds, one side of the end on each, are one seam: the bow between them.
    way, off = x * cos(along) + y * sin(along), y * cos(along) - x * sin(along)
    bend = np.polyfit(way, off, 2 if len(np.unique(way)) > _BOW else 0)
    t = np.linspace(way.min(), way.max(), 12)
    bow = np.polyval(bend, t)
    line = points.mean(0) + np.stack([t * cos(along) - bow * sin(along), t * sin(along) + bow * cos(along)], axis=1)
    sheet.shape(line, None, INK, 1.6)
    sheet.shape(line, None, mark.color, 1.0)


def _rounded(ring: Array) -> Array:
    """A closed line (P, 2), its corners cut, and what is left of them again (Chaikin 1974)."""
    line = ring[:-1]
    for _ in range(_CUTS):
        after = np.roll(line, -1, axis=0)
        line = np.stack([0.75 * line + 0.25 * after, 0.25 * line + 0.75 * after], axis=1).reshape(-1, 2)
    return np.concatenate([line, line[:1]])


def _names(sheet: Page, named: Sequence[tuple[str, Array]], x: float, room: float, y: float, tall: float) -> None:
    """The names in a column at the left, each with a line to the leftmost of what bears it."""
    least: dict[str, Array] = {}
    for name, points in named:
        middle = points.mean(0)
        if name not in least or middle[0] < least[name][0]:
            least[name] = middle
    down = y
    for name in sorted(least, key=lambda name: float(least[name][1])):
        words = wrap(name, SMALL, 0.82 * room)[:2]
        high = 1.25 * SMALL * len(words)
        at = min(max(down, float(least[name][1]) - 0.5 * high), y + tall - high)
        sheet.paragraph(words, x, at + SMALL, SMALL, color=INK, leading=1.25)
        ends = x + max(width_of(line, SMALL) for line in words) + 0.8
        sheet.shape(np.array([(ends, at + 0.62 * high), least[name]]), None, SOFT, 0.2)
        down = at + high + 0.8
