"""Printed patterns, the assembly: sentences such as "Sew the ears to the head between Rnds 5 and 10" → finishing records."""

from __future__ import annotations

from dataclasses import dataclass
from itertools import pairwise
from typing import Final

from tambour.core.errors import Span
from tambour.crochet.graph.spots import Spots
from tambour.crochet.language.finishes import RGB, Embroidery, Eye, Felt, Finish, Placed, Spot
from tambour.crochet.printed.colors import Palette
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.tokens import Token

_SEWS: Final = frozenset(
    ("sew", "attach", "stitch", "pin", "position", "place", "sewing", "join", "fix", "glue", "fasten")
)
_EYED: Final = frozenset(("insert", "place", "attach", "add", "put", "position", "secure", "fix", "sew", "glue"))
_DRAWN: Final = frozenset(("embroider", "stitch", "sew", "embroidered", "make"))
_DRAWING: Final = {
    "nose": 4.0,
    "mouth": 6.0,
    "smile": 6.0,
    "line": 4.0,
    "brow": 4.0,
    "eyebrow": 4.0,
    "dot": 0.0,
    "cheek": 0.0,
}
_EYE: Final = Eye(Spot("", 0.0, None)).color
_YARN: Final = Embroidery(()).color
_SIDES: Final = frozenset(("left", "first", "right", "second", "other"))
_PUTS: Final = frozenset(
    ("insert", "place", "attach", "add", "put", "position", "secure", "fix", "sew", "embroider", "pin", "glue")
)


@dataclass(frozen=True)
class Made:
    """A part that is there to be sewn: its name, its copies, the stitches on its open edge, whether its end is closed."""

    name: str
    copies: int
    edge: int | None
    closed: bool


@dataclass(frozen=True)
class Sentence:
    """A sentence of finishing: its tokens, raw (words as written) and read; ``part``: the part that it stands in."""

    raw: list[Token]
    read: list[Token]
    part: str

    @property
    def span(self) -> Span:
        """Its place."""
        return Span(self.raw[0].start, self.raw[-1].end)


def finishes(raw: list[Token], read: list[Token]) -> bool:
    """Whether a sentence says where something goes: a verb near its beginning, and what it puts."""
    verbs = {t.word for t in raw[:3]}
    words = {t.word for t in raw}
    if not verbs & _PUTS:
        return False
    eyes = any(t.kind == "key" and t.value == "eyes" for t in read) or words & {"eye", "eyes"}
    rounds = any(t.kind == "key" and t.value in ("round", "row") for t in read)
    return bool(
        eyes or rounds or (verbs & {"sew", "attach", "pin", "embroider"} and words & {"to", "on", "onto", "over"})
    )


class Assembly:
    """Reads sentences of finishing. ``parts``: those of the pattern; ``spots``: their rounds, worked."""

    def __init__(self, parts: list[Made], spots: Spots, palette: Palette) -> None:
        self.parts, self.spots, self.palette = parts, spots, palette

    def read(self, sentence: Sentence) -> list[Finish] | None:
        """The records of a sentence; None when it does not say enough."""
        words = [t.word for t in sentence.raw]
        drawn = next((w.rstrip("s") for w in words if w.rstrip("s") in _DRAWING), None)
        eyes = any(t.kind == "key" and t.value == "eyes" for t in sentence.read) or {"eye", "eyes"} & set(words)
        if drawn is not None and _DRAWN & set(words[:3]):
            return self._drawn(sentence, drawn)
        if eyes and _EYED & set(words[:3]):
            return self._eyes(sentence)
        return self._sewn(sentence)

    # -- what a sentence names --------------------------------------------------------------------------------------

    def _named(self, sentence: Sentence) -> list[tuple[Made, int, int]]:
        """Parts in the order in which they are named, with the copy that is meant (0: all) and the token."""
        words = [t.word for t in sentence.raw]
        found: list[tuple[Made, int, int]] = []
        at = 0
        while at < len(words):
            best: tuple[int, Made] | None = None
            for part in self.parts:
                name = [w for w in part.name.lower().replace("_", " ").split(" ") if w]
                n = len(name)
                if (
                    name
                    and [_one(w) for w in words[at : at + n]] == [_one(w) for w in name]
                    and (not best or n > best[0])
                ):
                    best = (n, part)
            if best is None:
                at += 1
                continue
            before = set(words[max(0, at - 2) : at])
            copy = 0
            if best[1].copies > 1 and before & _SIDES:
                copy = 2 if before & {"right", "second", "other"} else 1
            found.append((best[1], copy, at))
            at += best[0]
        return found

    def _rounds(self, tokens: list[Token]) -> tuple[float, float, bool] | None:
        """The rounds that are named: first, last, and whether "between" stood before them."""
        for k, token in enumerate(tokens):
            if token.kind != "key" or token.value not in ("round", "row"):
                continue
            c = Cursor(tokens, k + 1)
            if c.mark("."):
                c.at += 1
            first = c.look()
            if first is None or first.kind != "number":
                continue
            c.at += 1
            last = first
            while c.mark("-", "/", "&") or c.key("and", "to"):
                ahead = 1 + c.key("round", "row", ahead=1)
                later = c.look(ahead)
                if later is None or later.kind != "number":
                    break
                last = later
                c.at += ahead + 1
            between = any(t.kind == "key" and t.value == "between" for t in tokens[max(0, k - 3) : k])
            return float(first.value), float(last.value), between
        return None

    def _apart(self, tokens: list[Token]) -> float | None:
        """``6 sts apart``, ``with 6 stitches between them``."""
        for k, token in enumerate(tokens):
            if token.kind == "number" and k + 1 < len(tokens):
                after = tokens[k + 1 : k + 5]
                if after[0].kind == "key" and after[0].value == "stitch":
                    if any(t.word == "apart" for t in after):
                        return float(token.value)
                    if any(t.kind == "key" and t.value == "between" for t in after):
                        return float(token.value) + 1.0
        return None

    def _number(self, tokens: list[Token], *units: str) -> float | None:
        for a, b in pairwise(tokens):
            if a.kind == "number" and b.word in units:
                return float(a.value)
        return None

    def _stitch(self, tokens: list[Token]) -> float | None:
        """``at st 12``."""
        for a, b in pairwise(tokens):
            if a.kind == "key" and a.value == "stitch" and b.kind == "number":
                return float(b.value)
        return None

    def _shade(self, tokens: list[Token]) -> RGB | None:
        for k in range(len(tokens)):
            found = self.palette.color(Cursor(tokens, k))
            if found is not None:
                return found[0]
        return None

    def _middle(self, part: str, round_: float) -> tuple[float, int] | None:
        """The stitch in the middle of the front of a round, and how many stitches it has."""
        index = self.spots.parts.get(part)
        k = self.spots.round_at(index, int(round_)) if index is not None else None
        if k is None or index is None:
            return None
        nodes = self.spots.stitches(k).tolist()
        place = self.spots.place(Spot(part, float(int(round_)), None))
        at = [(nodes.index(n), w) for n, w in zip(place.nodes, place.weights) if n in nodes]
        if not at:
            return None
        if len(at) == 2 and abs(at[0][0] - at[1][0]) > 1:
            return float(len(nodes)), len(nodes)
        return 1.0 + sum(n * w for n, w in at), len(nodes)

    # -- records ----------------------------------------------------------------------------------------------------

    def _host(self, sentence: Sentence) -> str | None:
        """The part that something is put on: one that is named and made once, else the one under way, else a head."""
        for part, copy, _ in self._named(sentence):
            if part.copies == 1 or copy:
                return part.name if part.copies == 1 else f"{part.name}.{copy}"
        if sentence.part:
            known = next((p for p in self.parts if p.name == sentence.part), None)
            if known is not None and known.copies == 1:
                return known.name
        single = [p for p in self.parts if p.copies == 1]
        head = next((p for p in single if "head" in p.name.lower() or "face" in p.name.lower()), None)
        if head is None and len(single) == 1:
            head = single[0]
        return head.name if head is not None else None

    def _pair(self, sentence: Sentence, part: str, usual: float) -> tuple[float, list[float]] | None:
        """The round and the stitches of two things side by side about the middle of the front."""
        rounds = self._rounds(sentence.read)
        if rounds is None:
            return None
        level = 0.5 * (rounds[0] + rounds[1])
        middle = self._middle(part, level)
        if middle is None:
            return None
        apart = self._apart(sentence.read)
        half = 0.5 * (apart if apart is not None else usual * middle[1])
        return level, [round(middle[0] - half, 3), round(middle[0] + half, 3)]

    def _eyes(self, sentence: Sentence) -> list[Finish] | None:
        part = self._host(sentence)
        if part is None:
            return None
        size = self._number(sentence.raw, "mm") or 9.0
        color = self._shade(sentence.read) or _EYE
        rounds, stitch = self._rounds(sentence.read), self._stitch(sentence.read)
        words = [t.word for t in sentence.raw]
        if rounds is not None and (stitch is not None or ("eye" in words and "eyes" not in words)):
            level = 0.5 * (rounds[0] + rounds[1])
            return [Eye(Spot(part, level, stitch, sentence.span), size, color, sentence.span)]
        pair = self._pair(sentence, part, 0.17)
        if pair is None:
            return None
        return [Eye(Spot(part, pair[0], s, sentence.span), size, color, sentence.span) for s in pair[1]]

    def _drawn(self, sentence: Sentence, what: str) -> list[Finish] | None:
        """Embroidery: a nose, a mouth, brows, dots; cheeks of felt."""
        part, rounds = self._host(sentence), self._rounds(sentence.read)
        if part is None or rounds is None:
            return None
        span = sentence.span
        color = self._shade(sentence.read) or _YARN
        top, low = rounds[0], rounds[1]
        words = {t.word for t in sentence.raw}
        middle = self._middle(part, 0.5 * (top + low) if rounds[2] else top)
        if middle is None:
            return None
        wide = self._wide(sentence.read)
        half = 0.5 * (wide if wide is not None else min(_DRAWING[what], middle[1] / 4))
        centre = self._stitch(sentence.read) or middle[0]
        if rounds[2]:
            top = low = 0.5 * (top + low)

        def spot(level: float, stitch: float) -> Spot:
            return Spot(part, level, round(stitch, 3), span)

        if what in ("cheek", "brow", "eyebrow") or (what == "dot" and "dots" in words):
            pair = self._pair(sentence, part, 0.25)
            if pair is None:
                return None
            if what == "cheek" and "felt" in words:
                width = self._number(sentence.raw, "mm") or 12.0
                return [Felt(Spot(part, pair[0], s, span), "circle", width, width, 0.0, color, span) for s in pair[1]]
            if what in ("cheek", "dot"):
                return [Embroidery((spot(pair[0], s),), color, span=span) for s in pair[1]]
            return [Embroidery((spot(top, s - half / 2), spot(low, s + half / 2)), color, span=span) for s in pair[1]]
        if what == "dot":
            return [Embroidery((spot(top, centre),), color, span=span)]
        left, right = spot(top, centre - half), spot(top, centre + half)
        if what == "nose" and top != low:
            return [Embroidery((left, right, spot(low, centre), left), color, span=span)]
        if what in ("mouth", "smile") and top != low:
            return [Embroidery((left, spot(low, centre), right), color, span=span)]
        return [Embroidery((left, right), color, span=span)]

    def _wide(self, tokens: list[Token]) -> float | None:
        for a, b, c in zip(tokens, tokens[1:], tokens[2:]):
            if a.kind == "number" and b.kind == "key" and b.value == "stitch" and c.word in ("wide", "long", "across"):
                return float(a.value)
        return None

    def _sewn(self, sentence: Sentence) -> list[Finish] | None:
        """A part, or every copy of it, sewn onto another."""
        named = self._named(sentence)
        if len(named) < 2:
            return None
        (part, copy, _), host = named[0], next(((p, k) for p, k, _ in named[1:] if p is not named[0][0]), None)
        if host is None or (host[0].copies > 1 and not host[1]):
            return None
        onto = host[0].name if host[0].copies == 1 else f"{host[0].name}.{host[1]}"
        span, words = sentence.span, {t.word for t in sentence.raw}
        rounds, stitch = self._rounds(sentence.read), self._stitch(sentence.read)
        if rounds is None:
            return self._on_top(part, host[0], onto, span)
        level = 0.5 * (rounds[0] + rounds[1])
        middle = self._middle(onto, level)
        if middle is None:
            return None
        edge = part.edge or 0
        reach = abs(rounds[1] - rounds[0])
        # Over so many rounds it stands pinched flat, or lies open as a ring: whichever is nearer to its size.
        flat = bool(words & {"flat", "pinched", "flattened", "folded"})
        flat = flat or (reach >= 3 and abs(reach - edge / 2) < abs(reach - edge / 3.1416))
        upright = 90.0 if flat and reach >= 2 else 0.0
        tilt, towards = (55.0, 180.0) if words & {"down", "downwards", "downward", "hanging"} else (0.0, 0.0)
        if part.copies == 1 or copy:
            side = self._side(words, middle) if part.copies == 1 else None
            if copy and stitch is None:
                side = middle[0] + (0.25 if copy == 2 else -0.25) * middle[1]
            name = part.name if part.copies == 1 else f"{part.name}.{copy}"
            at = stitch if stitch is not None else side
            return [Placed(name, Spot(onto, level, at, span), flat, upright, tilt, towards, None, span)]
        apart = self._apart(sentence.read)
        wide = 0.0 if upright else edge / 4 if flat else edge / 6.2832
        half = middle[1] / 4 if apart is None else 0.5 * apart + wide
        made: list[Finish] = []
        for k in range(part.copies):
            if part.copies == 2:
                at = middle[0] + (half if k else -half)
            else:
                at = middle[0] + middle[1] * (k + 0.5 - part.copies / 2) / part.copies
            across = -upright if k and upright else upright
            spot = Spot(onto, level, round(at, 3), span)
            made.append(Placed(f"{part.name}.{k + 1}", spot, flat, across, tilt, towards, None, span))
        return made

    def _side(self, words: set[str], middle: tuple[float, int]) -> float | None:
        """Of one part: the middle of the front, or the back when that is said."""
        if words & {"back", "behind", "rear"}:
            return middle[0] + middle[1] / 2 if middle[0] <= middle[1] / 2 else middle[0] - middle[1] / 2
        return None

    def _on_top(self, part: Made, host: Made, onto: str, span: Span) -> list[Finish] | None:
        """``Sew the head to the body``: onto the tip of a body that is closed, or the body onto a closed head."""
        if part.copies > 1:
            return None
        if host.closed:
            return [Placed(part.name, Spot(onto, self._tip(onto), None, span), span=span)]
        if part.closed and host.copies == 1:
            return [Placed(host.name, Spot(part.name, self._tip(part.name), None, span), span=span)]
        return None

    def _tip(self, part: str) -> float:
        index = self.spots.parts[part]
        return float(self.spots.numbers[self.spots.last(index)] + 1)


def _one(word: str) -> str:
    """A word as its singular, roughly."""
    return word[:-1] if word.endswith("s") and len(word) > 3 else word
