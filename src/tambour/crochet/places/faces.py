"""Faces put on: eyes and what is embroidered, on the part that bears the face, from what was said, else as is usual."""

from __future__ import annotations

import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.language.finishes import Embroidery, Eye, Felt, Finish, Hair, Placed, Spot
from tambour.crochet.places import face, lines
from tambour.crochet.places.beside import BELOW
from tambour.crochet.places.habits import ST
from tambour.crochet.places.hairdo import before, hairs, mane
from tambour.crochet.places.hear import Feature, Put
from tambour.crochet.places.masks import eye_on, is_mask
from tambour.crochet.places.put import Putter
from tambour.crochet.places.said import size
from tambour.crochet.places.snouts import BROW, CHEEKS
from tambour.crochet.places.stand import Host
from tambour.crochet.places.usual import Way, usual
from tambour.crochet.words.numbers import QUANTITY, quantity

_FACE: Final = 16.0
"""How many stitches a face is wide for which the usual sizes of motifs are."""
_OF_A_HEAD: Final = 0.12
"""An eye's size as a share of the width of what it is on, where nothing says it."""
_BAND: Final = 5
"""So many rounds of one colour or more are a face, fewer a stripe."""
_INSIDE: Final = 2.0
"""How many rounds eyes stay away from where another colour begins."""
_CLEAR: Final = 0.6
"""Eyes stay so many stitches clear of a snout, and are moved up by as many at a time."""
_AHEAD: Final = -0.7
"""A head that is worked from its nose runs back from it by so much, as a cosine."""
_UNDER_NOSE: Final = 0.4
"""How far below its middle the mouth of such a head is, in halves of its height."""
_NOSE: Final = 1.2
"""How far below the eyes' lower edge a nose is, in stitches."""
_CROWN: Final = 3  # rounds of a head that bear no nose
_BELOW, _FAN, _STANDS = 0.2, (0.45, 0.8), 0.7
"""Whiskers stay so many stitches below the eyes; how far apart they begin and end, in rounds; a head stands whose axis is so upright."""
_ONE: Final = 0.5
"""A pair that is nearer to each other, in stitches, lies in one place, and its distance says nothing of its size."""
_BESIDE_EACH: Final = 0.8
"""Two cheeks are no wider than this share of the way from the one to the other."""
_WIDELY: Final = 0.2
"""How far off the middle of the front eyes are at the most that make room for a beak, as a share of the round."""
_OVER_BACK: Final = re.compile(
    rf"\b({QUANTITY})\s*{ST}\s+(?:in\s+)?between\s+(?:(?:the|both)\s+)?(?:eyes|them|two)\s+(?:going\s+|counted\s+|measured\s+)?(?:over|across|along)\s+(?:the|his|her|its)\s+(?:back|top|head)\b"
)
_BEHIND: Final = 300
"""So many letters behind a sentence of the eyes another may say how far apart they are."""
_HANGS, _DEEP = 0.24, 1.5
"""How far a smile as wide as is said hangs, for its width, and in rounds at the most."""
_TINY: Final = 0.7
"""How large something is that is called tiny, little or small."""
_LED: Final = 400
"""So many letters before a sentence of hair its heading stands."""
_KNOT: Final = 1.4
"""Eyes of knots are so many stitches wide at the most, and three quarters of what satin stitch would fill."""


class Facer(Putter):
    """Puts eyes, noses, smiles on a toy's parts."""

    asleep = False  # its lids are down, and its lashes hang
    snouts: Sequence[Put] = ()  # those that are said to be between the eyes
    pupil = 0.0  # half the width, in stitches, of the eyes that are being put

    def eyes(self, f: Feature) -> list[Finish]:
        """Safety eyes, one or two."""
        if (pupils := self._pupils(f)) is not None:
            return pupils
        if f.guess and any("eye" in p.kinds for p in self.work.parts):
            return []  # that it is crocheted with
        host = self._faced(f, "eye")
        f = self._over_back(f, host)
        way = self._told(
            usual("eye", 2, lying=self._lies((self.work.main, 1)) and host.name == self.work.main.name)[0], f.where, 2
        )
        if "sides" in f.where.words:
            way = replace(way, at=(0.85, way.at[1] if abs(way.at[1]) < 0.5 else 0.15, 0.5))
        single = "eyes" not in f.text and "eye" in f.text and not {"pair", "two", "each", "both"} & set(f.text.split())
        big = size(f.text) if size(f.text) and (size(f.text) or 0) < 45 else self.work.eye
        wide = 2.0 * float(host.box[1][0]) * self.work.stitch
        big = big or float(min(18.0, max(5.0, round(2.0 * _OF_A_HEAD * wide) / 2.0)))
        color = f.color or Eye(Spot("", 0.0, None)).color
        self.pupil = 0.5 * big / self.work.stitch
        single = single and f.where.pair is None and not re.search(r"\b(?:other|second|right) (?:eye|one)\b", f.text)
        # "on one side of the face", and then on the other: they are two
        single = single and not (f.where.stitch is None and re.search(r"\bside\b", f.text))
        if single and f.where.rounds is not None:
            level = 0.5 * (f.where.rounds[0] + f.where.rounds[1])
            spots = [Spot(host.name, level, f.where.stitch, f.span)]
        else:
            spots = self._two(f, host, way)
        if all(map(self.stand.there, spots)):
            self._note("eye", host, spots)
            self.deep["eye"] = self.pupil
        if not f.where.says:
            self.work.made.guessed.append(("eyes", f"eyes on {host.name}"))
        return [Eye(s, big, color, f.span) for s in spots]

    def _over_back(self, f: Feature, host: Host) -> Feature:
        """Eyes of what lies as far apart as a sentence behind theirs says: "You should have 26 stitches between the eyes over the back"."""
        lies = host.name == self.work.main.copy(1) and self._lies((self.work.main, 1))
        said = _OVER_BACK.search(self.work.text, f.span.end, f.span.end + _BEHIND) if f.span.end else None
        if not lies or said is None or f.where.apart is not None or f.where.pair is not None:
            return f
        return replace(f, where=replace(f.where, apart=quantity(said[1]) + 1.0))

    def _pupils(self, f: Feature) -> list[Finish] | None:
        """Safety eyes in the middle of the eyes that were crocheted, where they are sewn on and nothing says another place."""
        placed = {r.part for _, r in self.work.out if isinstance(r, Placed)}
        whites = [p for p in self.work.parts if p.kind == "eye" and p.copies == 2 and p.copy(1) in placed]
        if not whites or f.where.rounds is not None or f.where.beside:
            return None
        hosts = [self.work.host((whites[0], k)) for k in (1, 2)]
        spots = [Spot(h.name, float(h.low - 1), None, f.span) for h in hosts]
        if all(self.work.spots.in_rows[h.part] for h in hosts):
            spots = [replace(h.near(h.box[0]), span=f.span) for h in hosts]
        if not all(map(self.stand.there, spots)):
            return None
        wide = 2.0 * float(max(hosts[0].box[1][0], hosts[0].box[1][2])) * self.work.stitch
        big = size(f.text) if size(f.text) and (size(f.text) or 0) < 45 else self.work.eye
        big = min(big or 0.5 * wide, 0.8 * wide)
        return [Eye(s, round(2.0 * big) / 2.0, f.color or Eye(s).color, f.span) for s in spots]

    def _two(self, f: Feature, host: Host, way: Way) -> list[Spot]:
        """The places of two things, mirrored about the middle of the front, the lower stitch first."""
        f = replace(f, where=self._counted(f.where, host))
        if f.where.rounds is not None:
            level = 0.5 * (f.where.rounds[0] + f.where.rounds[1])
            if f.where.pair is not None:
                return [host.within(Spot(host.name, level, s, f.span)) for s in sorted(f.where.pair)]
            stitch = host.in_round(level, way.direction)
        else:
            aside = tuple(b for b in f.where.beside if "between" not in b[0])  # two are not in the middle of anything
            point = self._beside(replace(f.where, beside=aside), host, way, 0.5)
            there = host.towards(way.direction) if point is None else point
            if point is None and is_mask(self.work, host):
                apart = self._apart(f.where)
                return [replace(host.near(eye_on(host, side, apart)), span=f.span) for side in (-1.0, 1.0)]
            there = self._off_the_snout(f, host, there)
            if self.work.spots.in_rows[host.part]:  # its rows may run upwards
                apart = self._apart(f.where)
                beside = abs(float(there[0] - host.box[0][0])) if apart is None else 0.5 * apart
                sides = [host.ahead(float(host.box[0][0]) + s * beside, float(there[1])) for s in (-1.0, 1.0)]
                return [replace(host.near(p), span=f.span) for p in sides]
            near = host.near(there)
            level, stitch = near.round, near.stitch or 1.0
            level = self._in_one_color(host, level) if point is None else level  # what is said stays
            snout = self._ahead(host) and not self._begins_at_face(host)
            if point is None and snout and not f.where.words - {"sides", "front"}:
                level = self._behind_snout(host)
                stitch = host.in_round(level, CHEEKS if "cheek" in f.what else BROW)
        middle, count = host.middle(level), host.count(level)
        apart = self._apart(f.where)
        off = abs((stitch - middle + count / 2) % count - count / 2) if apart is None else 0.5 * apart
        if apart is None and (between := self._between_eyes(f)) > off:
            off = min(between, _WIDELY * count)
        return [host.within(Spot(host.name, level, round(middle + s * off, 3), f.span)) for s in (-1.0, 1.0)]

    def _between_eyes(self, f: Feature) -> float:
        """How far off the middle eyes are, or more, that leave room for a beak or a snout that is said to be between them; 0 where none is."""
        wide = [self._bulge(p.copies[0]) for p in self.snouts] if f.what == "safety eyes" else []
        return max(wide) + self.pupil + _CLEAR if wide else 0.0

    def _off_the_snout(self, f: Feature, host: Host, point: Array) -> Array:
        """An eye's place moved up its head until no snout covers it."""
        if f.what not in ("safety eyes", "eyes", "closed eyes"):
            return point
        high = float(host.box[0][1] + 0.75 * host.box[1][1])
        for kind in ("muzzle", "nose", "beak"):
            known = self.known.get(kind)
            if known is None or known[0] != host.name or kind not in self.deep:
                continue
            middle, least = np.array(known[1]).mean(0), self.deep[kind] + _CLEAR + self.pupil
            x, y = float(point[0]), float(point[1])
            while y < high and float(np.sqrt(((point - middle) ** 2).sum())) < least:
                y += _CLEAR
                point = host.ahead(x, y)
        return point

    def _in_one_color(self, host: Host, level: float) -> float:
        """A level moved off the rounds where one colour of a head meets another: a cap, a collar."""
        graph, spots = self.work.built.graph, self.stand.spots
        numbers = [n for n, _ in host.levels]
        rounds = [spots.round_at(host.part, n) for n in numbers]
        shades = [tuple(graph.color[spots.stitches(k)[0]].tolist()) for k in rounds if k is not None]
        begins = [i for i, c in enumerate(shades) if i == 0 or c != shades[i - 1]]
        bands = [(numbers[a], numbers[b - 1]) for a, b in zip(begins, [*begins[1:], len(shades)]) if b - a >= _BAND]
        near = [min(max(level, low + _INSIDE), high - _INSIDE) for low, high in bands]
        moved = min(near, key=lambda n: abs(n - level), default=level)
        return moved if len(begins) > 1 and abs(moved - level) <= _INSIDE + 1.0 else level

    def _faced(self, f: Feature, what: str) -> Host:
        """What a face is on: what is named, else a muzzle for noses and mouths, else the head."""
        work = self.work
        mask = work.of_kind("face") or work.of_kind("eye")
        placed = {r.part for _, r in work.out if isinstance(r, Placed)}
        masked = mask is not None and mask.name in placed and f.where.rounds is None
        if masked and mask is not None and (f.host is None or f.host[0].kind in ("head", "face")):
            return work.host((mask, 1))  # in front of the head
        muzzle = work.of_kind("muzzle")
        snouted = muzzle is not None and muzzle.name in placed and what == "nostrils" and f.where.rounds is None
        if snouted and muzzle is not None and (f.host is None or f.host[0].kind in ("head", "body")):
            return work.host((muzzle, 1))  # "make nostrils in the snout, and tack them to the head"
        if f.host is not None and not (what == "eye" and self._too_small(f)):
            two = {"head", "body"} <= set(work.main.kinds)
            region = (f.region if two else "head") if f.host[0] == work.main else ""
            return work.host((f.host[0], max(1, f.host[1])), "" if what in ("navel", "claws") and not two else region)
        if (
            what in ("nose", "v nose", "y nose", "mouth", "smile", "nostrils")
            and muzzle is not None
            and muzzle.name in placed
            and (f.where.rounds is None or self._on_snout(f.where.rounds[1], what, work.host((muzzle, 1)).high))
        ):
            return work.host((muzzle, 1))
        head = work.of_kind("head")
        if work.bearer != work.main:
            return work.host((work.bearer, 1))
        return work.host((head, 1)) if head is not None and head != work.main else work.host((work.main, 1), "head")

    @staticmethod
    def _on_snout(last: float, what: str, high: int) -> bool:
        """Whether rounds up to ``last`` are those of a snout, and not of the head behind it: a head's first are its crown."""
        return last <= high and (what == "nostrils" or last <= _CROWN)

    def _too_small(self, f: Feature) -> bool:
        """Whether eyes are only near the part that is named: a snout bears none, nor a part without that round."""
        assert f.host is not None
        if f.host[0].kind in ("muzzle", "nose", "beak"):
            return True
        high = self.work.host((f.host[0], max(1, f.host[1]))).high
        return f.where.rounds is not None and f.where.rounds[0] > high

    def feature(self, f: Feature) -> list[Finish]:
        """Something that is embroidered, or cheeks of felt."""
        work, name = self.work, f.what
        if name in ("lines", "cross"):
            return self._lines(f)
        host = self._faced(f, name)
        f = replace(f, where=self._counted(f.where, host))
        if name == "hair":
            bare = work.of_kind("head") if host.name in {p.copy(1) for p in work.parts if p.kind == "hat"} else None
            return self._hair(host if bare is None else work.host((bare, 1)), f)  # not on the crown of a princess
        if f.where.rounds is not None and not self.stand.there(Spot(host.name, 0.5 * sum(f.where.rounds[:2]), None)):
            return [Embroidery((Spot(host.name, f.where.rounds[0], None, f.span),), span=f.span, motif=name)]
        tall = None
        if f.where.rounds is not None and not f.where.rounds[2] and f.where.rounds[1] > f.where.rounds[0]:
            tall = f.where.rounds[1] - f.where.rounds[0]
        if tall is None and f.where.rounds is not None and name == "smile" and f.where.wide:
            tall = min(_HANGS * f.where.wide, _DEEP)  # about the round that is said
        large = min(2.2, max(0.7, 2.0 * float(host.box[1][0]) / _FACE))
        wide = min(f.where.wide or large * face.USUAL[name], 0.6 * host.count(host.levels[len(host.levels) // 2][0]))
        if re.search(rf"\b(?:tiny|little|small)\s+(?:\w+\s+)?{name.split()[-1]}", f.text) and not f.where.wide:
            wide *= _TINY
        if name == "eyes" and not f.where.wide and "french knot" in f.text:
            wide = min(0.75 * wide, _KNOT)
        color = f.color or (face.PINK if name == "cheeks" else face.DARK)
        self.deep[name.split()[-1]] = 0.35 * wide
        if name == "claws" and f.host is not None and f.host[0].copies > 1:
            hosts = [self.work.host((f.host[0], k)) for k in range(1, f.host[0].copies + 1)]
            made: list[Finish] = []
            for h in hosts:
                made += face.embroidered(
                    h,
                    name,
                    h.levels[min(2, len(h.levels) - 1)][1].mean(0) + np.array([0.0, 1.0, 6.0]),
                    wide,
                    False,
                    color,
                    f.span,
                    stitch=self.work.stitch,
                )
            return made
        if name in face.PAIRED:
            spots = self._two(f, host, self._usual_pair(name, host, f))
            if "felt" in f.text and name == "cheeks":
                big = size(f.text) or 12.0
                return [Felt(s, "circle", big, big, 0.0, color, f.span) for s in spots]
            points = [self.stand.frame(s).points[0] for s in spots]
            if name in ("cheeks", "eyes", "closed eyes") and len(points) == 2 and not f.where.wide:
                between = float(np.sqrt(((points[0] - points[1]) ** 2).sum()))
                wide = min(wide, _BESIDE_EACH * between) if between > _ONE else wide
            if name == "whiskers":
                points = self._beside_snout(host, f) or points
            if name in ("eyes", "closed eyes"):
                self.asleep = name == "closed eyes"
                self._note("eye", host, spots)
                self.deep["eye"] = 0.6 * wide
            made = []
            for p in points:
                mirror = bool(p[0] < host.box[0][0])
                drawn = "lashes down" if name == "lashes" and self.asleep else name
                many = face.of_whiskers(f.text)
                made += face.embroidered(host, drawn, p, wide, mirror, color, f.span, None, self.work.stitch, many)
            return self._by_rounds(host, made, wide) if name == "whiskers" and f.where.rounds is None else made
        point = self._single(f, host, name, wide)
        if name == "nose" and re.search(r"\bfelt\b", f.text):
            self._note("nose", host, [on := host.near(point, 0.1)])
            big = size(f.text) or round(wide * work.stitch)
            form = next((s for s in ("triangle", "heart", "circle") if s in f.text), "oval")
            return [Felt(on, form, big, round(0.75 * big, 1), 0.0, color, f.span)]
        self.known[{"smile": "mouth"}.get(name, name.split()[-1])] = (host.name, [point])
        return [*face.embroidered(host, name, point, wide, False, color, f.span, tall, self.work.stitch)]

    def _lines(self, f: Feature) -> list[Finish]:
        """Straight stitches on what is named, on all its copies; none where nothing is."""
        if f.host is None:
            return []
        made: list[Finish] = []
        for k in range(1, f.host[0].copies + 1):
            host = self.work.host((f.host[0], k), f.region if f.host[0] == self.work.main else "")
            own = replace(f, where=self._counted(f.where, host))
            if own.where.rounds is not None and not all(
                self.stand.there(Spot(host.name, n, None)) for n in own.where.rounds[:2]
            ):
                return []
            middle = self._single(own, host, f.what, 3.0) if own.where.says else None
            made += lines.drawn(host, f.what, middle, f.text, own.where, f.color or face.DARK, f.span)
        return made

    def _by_rounds(self, host: Host, made: list[Finish], wide: float) -> list[Finish]:
        """Whiskers of a head that stands, by its rounds and stitches: alike on both sides, and below the eyes."""
        lines = [r for r in made if isinstance(r, Embroidery) and r.spots[0].stitch is not None]
        if abs(float(host.axis[1])) < _STANDS or len(lines) < 2 or len(lines) % 2:
            return made
        each = len(lines) // 2
        mid = [lines[k] for side in (0, each) for k in {side + (each - 1) // 2, side + each // 2}]
        middle = host.middle(mid[0].spots[0].round)
        level = float(np.mean([r.spots[0].round for r in mid]))
        off = float(np.mean([abs((r.spots[0].stitch or 0.0) - middle) for r in mid]))
        eyes = self.known.get("eye")
        if eyes is not None and eyes[0] == host.name:
            eye, down = host.near(eyes[1][0]).round, 1.0 if host.axis[1] < 0.0 else -1.0
            level = eye + down * max(down * (level - eye), self.deep.get("eye", 0.5) + _BELOW + _FAN[1])
        found = []
        for side in (-1.0, 1.0):
            for k in np.linspace(-1.0, 1.0, each).tolist():
                ends = ((level + _FAN[0] * k, off), (level + _FAN[1] * k, off + wide))
                spots = [Spot(host.name, n, round(host.middle(n) + side * o, 3), lines[0].span) for n, o in ends]
                found.append(replace(lines[0], spots=tuple(map(host.within, spots))))
        return [*found]

    def _hair(self, host: Host, f: Feature) -> list[Finish]:
        """Strands on a head as far as is said, else as is usual, which is told."""
        at = f.where.rounds
        said = at is not None and all(self.stand.there(Spot(host.name, n, None)) for n in at[:2])
        if not said:
            self.work.made.guessed.append(("hair", f"hair on {host.name}"))
        words = before(self.work.text, f.span.start) + f.text
        necks = [p for p in self.work.parts if p.kind == "neck" and p.single]
        if not said and re.search(r"\n\s*mane\b", self.work.text[max(0, f.span.start - _LED) : f.span.start]):
            hosts = [host, *(self.work.host((p, 1)) for p in necks)]
            return [*mane(hosts, self.stand.there, words, self.work.stitch, f.color or Hair(()).color, f.span)]
        rounds = (at[0], at[1]) if said and at is not None else None
        color = f.color or Hair(()).color
        return [*hairs(host, self.stand.there, words, rounds, self.work.stitch, color, [f.span, *f.also])]

    def _beside_snout(self, host: Host, f: Feature) -> list[Array]:
        """Where whiskers begin: on both sides of a snout that is sewn on; nowhere where there is none."""
        snout = self.known.get("muzzle")
        if snout is None or snout[0] != host.name or f.where.rounds is not None:
            return []
        x, y, _ = np.array(snout[1]).mean(0)
        wide = self.deep.get("muzzle", 1.0) + _CLEAR
        return [host.ahead(float(x - wide), float(y)), host.ahead(float(x + wide), float(y))]

    def _usual_pair(self, name: str, host: Host, f: Feature) -> Way:
        eyes = self.known.get("eye")
        at = {
            "cheeks": (0.62, -0.22, 0.75),
            "brows": (0.44, 0.5, 0.8),
            "whiskers": (0.42, -0.2, 0.9),
            "freckles": (0.5, -0.15, 0.85),
            "nostrils": (0.24, 0.22 if self._snouted(host) else -0.12, 0.95),
        }
        lies = host.name == self.work.main.copy(1) and self._lies((self.work.main, 1))
        x, y, z = at.get(name, usual("eye", 2, lying=lies)[0].at)
        if (
            eyes is not None
            and eyes[0] == host.name
            and f.where.rounds is None
            and not f.where.beside
            and name != "eyes"
        ):
            middle, half = host.box
            eye = max(eyes[1], key=lambda p: p[0])
            v = (eye - middle) / half
            shift = {
                "cheeks": (0.18, -0.38),
                "brows": (0.0, 0.36),
                "lashes": (0.0, -0.06) if self.asleep else (0.12, 0.05),
                "whiskers": (0.05, -0.4),
                "freckles": (0.05, -0.34),
                "nostrils": (0.2 - float(v[0]), -0.4),
            }
            dx, dy = shift.get(name, (0.0, 0.0))
            return Way((float(v[0]) + dx, float(v[1]) + dy, max(float(v[2]), 0.3)))
        return self._told(Way((x, y, z)), f.where, 2)

    def _rounds_below_eyes(self, f: Feature, host: Host) -> Spot | None:
        """The middle of the round that is said to be so many below the eyes' own; None where none is, and on what does not stand."""
        eyes = self.known.get("eye")
        many = next((n for relation, thing, n in f.where.beside if thing == "eye" and relation in BELOW and n), None)
        stands = abs(float(host.axis[1])) >= _STANDS and not self.work.spots.in_rows[host.part]
        if many is None or eyes is None or eyes[0] != host.name or not stands:
            return None
        level = host.near(eyes[1][0]).round + (many if host.axis[1] < 0.0 else -many)
        return Spot(host.name, level, host.middle(level)) if host.low <= level <= host.high else None

    def _snouted(self, host: Host) -> bool:
        muzzle = self.work.of_kind("muzzle")
        return muzzle is not None and muzzle.name == host.name

    def _single(self, f: Feature, host: Host, name: str, wide: float) -> Array:
        """The middle of something that is there once: a nose, a mouth."""
        if f.where.rounds is not None:
            low, high = f.where.rounds[:2]
            level = 0.5 * (low + high)
            if f.where.stitch is not None:
                return np.asarray(self.stand.frame(Spot(host.name, level, f.where.stitch)).points[0])
            if "back" in f.where.words:
                return np.asarray(
                    self.stand.frame(Spot(host.name, level, host.in_round(level, np.array([0.0, 0.0, -1.0])))).points[0]
                )
            lies = (host.name == self.work.main.copy(1) and self._lies((self.work.main, 1))) or host.axis[2] < -0.7
            if lies and name.split()[-1] in ("mouth", "smile"):  # its front is on top: a mouth is below
                below = host.in_round(level, np.array([0.0, -1.0, 0.3]))
                return np.asarray(self.stand.frame(Spot(host.name, level, below)).points[0])
            return np.asarray(self.stand.frame(Spot(host.name, level, host.middle(level))).points[0])
        y = {"mouth": -0.42, "smile": -0.38, "nose": -0.08, "navel": -0.25}.get(name.split()[-1], 0.0)
        if (f.host is not None and f.host[0].kind in ("muzzle",)) or host.name == getattr(
            self.work.of_kind("muzzle"), "name", None
        ):
            y = {"nose": 0.32, "mouth": -0.32, "smile": -0.3}.get(name.split()[-1], 0.0)
        if (counted := self._rounds_below_eyes(f, host)) is not None:
            return np.asarray(self.stand.frame(counted).points[0])
        way = self._told(Way((0.0, y, 1.0)), f.where, 1)
        beside = self._beside(f.where, host, way, 0.4 * wide)
        if beside is not None:
            return beside
        if name.split()[-1] in ("mouth", "smile") and host.axis[2] < _AHEAD:
            middle, half = host.box  # its eyes are above and beside its nose, which is in the middle
            return host.ahead(float(middle[0]), float(middle[1] - _UNDER_NOSE * half[1]))
        for thing, down in (("nose", 1.6), ("muzzle", 0.0), ("eye", 2.4)):
            there = self.known.get(thing)
            if (
                there is not None
                and there[0] == host.name
                and name.split()[-1] in ("mouth", "smile", "nose")
                and thing != name.split()[-1]
            ):
                middle = np.array(there[1]).mean(0)
                if thing == "muzzle":
                    continue
                fall = (_NOSE if name.split()[-1] == "nose" else down) + (
                    self.deep.get(thing, 0.5) if thing == "eye" else 0.0
                )
                return host.ahead(middle[0], middle[1] - fall)
        return host.towards(way.direction)
