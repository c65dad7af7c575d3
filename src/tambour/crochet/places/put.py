"""Put: one part, one pair of eyes, one smile, on the fabric that it goes on: from what was said, else as is usual."""

from __future__ import annotations

import math
import re
from collections.abc import Sequence
from dataclasses import replace
from typing import Final

import numpy as np

from tambour.core.check import Array
from tambour.crochet.language.finishes import Placed, Spot
from tambour.crochet.places.beside import ABOVE, SIDE
from tambour.crochet.places.ends import two_ends
from tambour.crochet.places.hear import Copy, Put
from tambour.crochet.places.held import BESIDE, LAID
from tambour.crochet.places.masks import eye_on, is_mask
from tambour.crochet.places.names import SIDED, one
from tambour.crochet.places.paired import Pairer
from tambour.crochet.places.room import Seam, aside, spread, strewn, strewn_on
from tambour.crochet.places.rowed import in_rows
from tambour.crochet.places.snouts import BROW
from tambour.crochet.places.stand import Host, neck
from tambour.crochet.places.usual import DOLLS, SPREAD, UPRIGHT, Way, usual

_ROUGHLY: Final = 0.6
"""An end is on top that looks so nearly upwards, as a cosine, for what goes on top."""
_ON_TOP: Final = frozenset(("head", "body", "hat", "neck", "stem", "base", "inner"))
"""What goes on an end of what it is sewn to, without a word."""
_BELOW_EYES: Final = {"muzzle": 0.75, "nose": 0.4, "beak": 0.3}
"""How far below the eyes the middle of a thing is, in halves of its width, where nothing says it."""
_HANGS_BY: Final = 0.8
"""How far the middle of a muzzle that is sewn between the eyes is below them, in halves of its width."""
_DOWN: Final = 0.4
"""By how many stitches at a time a snout is moved down that would cover an eye."""
_STANDS: Final = re.compile(
    r"\b(?:bottom|lower|straight|flat|base)\s+(?:end|edge|side)\b[^.;]{0,25}\b(?:on|at|along|above)\s+(?:the\s+)?(?:top of\s+)?(?:rounds?|rnds?|rows?|r)\b"
)
"""A piece of which the lower edge is in the round that is said."""
_LOWER_EDGE: Final = re.compile(r"\blower edge on round \d")
"""The same of a round one that lies on the fabric, as :mod:`habits` puts it."""
_HANGS: Final = re.compile(
    r"\b(?:top|upper)\s+(?:edge\s+)?of\s+(?:the\s+)?(\w+)\s+(?:\w+\s+)?(?:just\s+)?(?:below|under|at|on|with|along)\s+(?:the\s+)?"
    r"(?:rounds?|rnds?|rows?|r|\d+(?:st|nd|rd|th))\b"
)
"""A piece of which the upper edge is at the round that is said."""
_ON_BACKS: Final = frozenset(("fin", "spike", "shell", "wing"))
"""What is said to be on the back of an animal that lies."""
_ASIDE: Final = frozenset(("fin", "arm", "wing", "flipper"))
"""What goes to the sides, and farther back where the eyes are."""
_OFF_EYES, _BACKWARDS = 0.9, 10
"""By how many stitches it stays clear of them, and how often it is moved."""
_LOWER: Final = 2.0
"""So many rounds from where arms are on a ball they are elsewhere."""
_NEAR_END: Final = 4
"""A head that is sewn to one of the last so many rounds of a body is on its end."""


class Putter(Pairer):
    """Puts parts on a toy's parts, one after the other.

    waiting : all that is put
    """

    waiting: Sequence[Put] = ()

    # -- parts ------------------------------------------------------------------------------------------------------

    def part(self, put: Put) -> list[Placed]:
        """The records of a part, or of all its copies."""
        assert put.host is not None
        work, made = self.work, put.copies[0][0]
        kind = put.kind
        if kind in ("head", "neck") and self._lies((work.main, 1)) and "neck" in (kind, put.host[0].kind):
            # What is said of rounds is said of the head, or of the body's opening.
            put = replace(put, where=replace(put.where, rounds=None, stitch=None, beside=(), words=frozenset()))
        assert put.host is not None
        first = kind == "head" and self._lies(put.host) and work.nose_first(made) and put.where.rounds is None
        if first or (kind == "head" and put.host[0].kind == "neck" and self._lies((work.main, 1))):
            return [self._ahead_on_neck(put, put.host)]
        at_end = put.where.rounds is None or (
            work.nose_first(made) and put.where.rounds[0] > work.host(put.host).high - _NEAR_END
        )
        if kind in ("head", "body") and put.host[0].kind in ("head", "body", "neck", "") and at_end:
            joined = self._joint(put)
            if joined is not None:
                return joined
        if (rims := self._rims(put)) is not None:
            return rims
        if put.host[1] == 0:  # one on each copy of something
            found: list[Placed] = []
            on, many = put.host[0], len(put.copies)
            for k in range(on.copies):
                own = [c for i, c in enumerate(put.copies) if i * on.copies // many == k]
                found += self.part(replace(put, copies=own, host=(on, k + 1))) if own else []
            return found
        onto = put.host
        lies = self._lies(onto)
        wanted = frozenset(w for c in put.copies for w in c[0].words) | (
            frozenset(put.where.text.split()) - {"front", "fore"}
        )
        wanted |= frozenset(one(w) for w in re.findall(r"[^\W\d_]+", work.text[:200])) & (
            SPREAD | BESIDE | DOLLS | UPRIGHT
        )
        if kind == "leaf" and len(put.copies) > 8:  # they stand in rings, whatever round the first of them is in
            put = replace(put, where=replace(put.where, rounds=None, beside=(), words=frozenset()))
        if kind == "ear" and len(put.copies) == 4:  # two layers each: of the inner ones nothing is seen
            put = replace(put, copies=put.copies[:2])
            work.made.behind.append(made.name)
        if made.copies == 4 and len(put.copies) == 2:
            wanted |= {"front"} if put.copies[0][1] == 1 else {"hind"}
        if kind == "ear" and work.dog and "upwards" not in put.where.words:
            wanted |= {"floppy"}
        if kind == "leg" and len(put.copies) == 2 and SIDED & set(made.words):
            # Two pairs that are told apart by their numbers are front and hind legs.
            alike = [m for m in work.parts if m.kind == kind and m.copies == 2 and SIDED & set(m.words)]
            wanted |= {"front" if made == alike[0] else "hind"} if len(alike) == 2 else frozenset()
        if kind == "spike" and work.of_kind("tail") is not None:
            wanted |= {"tail"}
        if lies and "back" in put.where.words and kind in _ON_BACKS:  # the back of what lies is on top
            put = replace(put, where=replace(put.where, words=put.where.words - {"back", "middle"} | {"top"}))
        long, headed = self._long(put.copies[0]), self._headed(put)
        ways = usual(kind, len(put.copies), lying=lies, long=long, words=wanted, headed=headed)
        if "spout" in made.words:  # across from the handle
            ways = [replace(way.mirrored(), axis=(-1.0, 0.6, 0.0)) for way in ways]
        behind = "back" in put.where.words and "sides" not in put.where.words and "rear" not in made.words
        if kind == "wing" and len(ways) == 2 and behind:
            ways = [replace(way, at=(0.45 * math.copysign(1.0, way.at[0]), *way.at[1:])) for way in ways]
        # The same noun on several parts ("left ear", "right ear"), or one copy of several.
        two = made.copies == 2 and made not in work.layered  # two layers are one thing
        if len(put.copies) == 1 and (two or {"left", "right"} & set(made.words)):
            pair = usual(kind, 2, lying=lies, long=long, words=wanted)
            right = "right" in made.words or "right" in put.where.words or (two and put.copies[0][1] == 2)
            if put.where.through and put.where.rounds is not None:  # on the side that its stitches are on
                at = Spot(work.host(onto).name, put.where.rounds[0], put.where.stitch)
                x = float(self.stand.frame(at).points[0][0] - work.host(onto).box[0][0])
                right = (x >= 0.0) != (pair[0].at[0] >= 0.0)
            ways = [pair[1] if right else pair[0]]
        if (
            kind in ("leg", "foot")
            and made.copies == len(put.copies) == 1
            and re.search(r"(?:legs|feet|pants|trousers)$", made.name.lower())
        ):
            ways = [Way((0.0, -1.0, 0.0), (0.0, -1.0, 0.0), flat=False)]  # both in one piece: the lower end of the body
        if "inner" in made.words and onto[0].kind == "ear" and put.where.rounds is None:
            ways = [Way((0.0, -0.1, 1.0), None)] * len(ways)
        if kind == "tuft" and "mane" in made.words and len(put.copies) == 1 and self._strip(put.copies[0]):
            ways = usual("spike", 1, lying=lies)  # along the nape, by its long edge
        if self._all_in_one(onto, lies) and kind in ("arm", "foot", "wing", "") and put.where.rounds is None:
            ways = [self._below_face(way) for way in ways]
        # Only of what is head and body in one a sentence says which of the two it means.
        within = work.sections.get(onto[0].name, {})
        two = {"head", "body"} <= set(work.main.kinds) or put.region == "head" or bool(within)
        region = (put.region if two else "") or (ways[0].on if onto[0] == work.main else "")
        if kind in ("leg", "foot") and "leg" in within:
            region = ""  # under its legs, and not under the body that goes on from them
        if kind == "belly" and region == "head":
            region = "body"  # "sew the facial fur and the chest fur to head and body"
        if kind == "spot" and onto[0].kind in within:
            region = onto[0].kind  # of the cap, and not of the legs
        host = work.host(onto, region)
        if lies and kind in ("leg", "foot", "wing") and put.where.rounds is None:
            host = self._trunk(host)
        put = replace(put, where=self._counted(put.where, host))
        if (rows := in_rows(put, host, lies, work.text)) is not None:
            put, ways = rows
        else:
            put = replace(put, where=replace(put.where, each=(), stacked=False))
        lined = put.where.stacked and kind == "spike"  # in a row, which says all of it
        told = ways if lined else [self._told(way, put.where, len(put.copies), kind) for way in ways]
        records = self._sewn(put, host, told)
        if not all(self.stand.there(r.spot) for r in records):
            if put.where.rounds is not None and not put.guess:  # one that was not read: where such parts usually are
                unsaid = replace(put.where, rounds=None, stitch=None, beside=())
                return self.part(replace(put, where=unsaid, guess=True))
            return [Placed(r.part, r.spot, span=put.span) for r in records]
        seams = self.room.seams(records, kind)
        end = len(records) == 1 and records[0].spot.stitch is None  # what is on an end stays there
        if not self.room.free(seams) and not self._exactly(put) and kind != "fluke" and not end:
            for others in aside(told):
                found_ = self._sewn(put, host, others)
                if all(self.stand.there(r.spot) for r in found_) and self.room.free(
                    there := self.room.seams(found_, kind)
                ):
                    records, seams = found_, there
                    break
        if kind in _ASIDE and self._over_eyes(records, seams):
            for k in range(1, _BACKWARDS + 1):
                back = [replace(w, at=(w.at[0], w.at[1], w.at[2] - 0.15 * k)) for w in told]
                found_ = self._sewn(put, host, back)
                there = self.room.seams(found_, kind)
                if not self._over_eyes(found_, there):
                    records, seams = found_, there
                    break
        if (
            kind == "ear"
            and "inner" not in made.words
            and any(
                p.kind == "ear" and "inner" in p.words and self.work.spots.in_rows[self.work.spots.parts[p.copy(1)]]
                for p in work.parts
            )
        ):
            records = [self._right_side_ahead(c, r) for c, r in zip(put.copies, records)]
        said = work.text[put.span.start : put.span.end]
        records = two_ends(put, host, records, self._length(put.copies[0]), said)
        self.room.take(seams)
        if kind in _BELOW_EYES or kind == "eye":
            self.deep[kind] = self._bulge(put.copies[0])
        for record in records:
            self.stand.place(record)
        thing = made.kind or made.words[-1] if made.words else ""
        self._note(thing, host, [r.spot for r in records])
        if self.work.spots.in_rows[self.work.spots.parts[made.copy(1)]]:
            self.deep[thing] = 0.5 * max(len(ring) for _, ring in self.work.host((made, 1)).levels)
        silent = not put.where.says and not (kind in _ON_TOP and len(put.copies) == 1)
        if put.guess or put.strange or silent:
            self.work.made.guessed.append((made.name, f"{made.name} on {onto[0].name}"))
        return records

    def _over_eyes(self, records: list[Placed], seams: list[Seam]) -> bool:
        """Whether limbs whose stitch is not said are sewn where the eyes are."""
        known = self.known.get("eye")
        if known is None or any(seam.host != known[0] for seam in seams) or not records:
            return False
        eyes, least = np.array(known[1]), self.deep.get("eye", 0.5) + _OFF_EYES
        return any(float(((s.points[:, None] - eyes) ** 2).sum(2).min()) < least * least for s in seams)

    def _all_in_one(self, onto: Copy, lies: bool) -> bool:
        """Whether a part is a toy's head and body without a neck: a ball with a face and limbs."""
        work = self.work
        whole = work.host(onto)
        return (
            onto[0] == work.main
            and not lies
            and work.of_kind("head") in (None, work.main)
            and work.host(onto, "body").high - work.host(onto, "body").low == whole.high - whole.low
        )

    def _sewn(self, put: Put, host: Host, ways: list[Way]) -> list[Placed]:
        """The records of a part's copies, each put on its way."""
        made = [(c, self._spotted(put, host, way, k)) for k, (c, way) in enumerate(zip(put.copies, ways))]
        if len(made) == 2 and put.copies[0][0] == put.copies[1][0] and put.where.pair is None and not put.where.stacked:
            made = self._paired(put, host, made)
        if len(made) == 4 and len({c[0] for c, _ in made}) == 1 and not self.work.spots.in_rows[host.part]:
            made = self._evened(host, made)
        if put.where.stitch is None:
            own = self._strewn(put, host, len(made)) if self._loose(put) else []
            places = own or spread([spot for _, (spot, _) in made], host, 2.0 * self._half(put.copies[0]))
            made = [(c, (host.within(spot), way)) for (c, (_, way)), spot in zip(made, places)]
        if not all(self.stand.there(spot) for _, (spot, _) in made):
            return [Placed(c[0].copy(c[1]), spot, span=put.span) for c, (spot, _) in made]
        records = [self._placed(put, c, spot, way, host) for c, (spot, way) in made]
        if (
            len(records) == 2
            and put.copies[0][0] == put.copies[1][0]
            and records[0].spot.round == records[1].spot.round
        ):
            records[1] = _mirrored(records[0], records[1])
        if len(records) == 4 and len({c[0] for c in put.copies}) == 1:
            for k in (0, 2):
                if records[k].spot.round == records[k + 1].spot.round and ways[k].at[0] * ways[k + 1].at[0] < 0.0:
                    records[k + 1] = _mirrored(records[k], records[k + 1])
        return records

    def _strewn(self, put: Put, host: Host, many: int) -> list[Spot]:
        """Places for spots all over a part, or on the one side of it that is said."""
        said = put.where.words & {"front", "back", "top", "sides"}
        lies = self._lies_name(host)
        if len(said) == 1 and said <= {"front", "back"} and not lies:
            return strewn_on(put.kind, many, host, (0.0, 0.0, 1.0 if "front" in said else -1.0))
        if said in ({"back"}, {"top"}) and lies:
            return strewn_on(put.kind, many, host, (0.0, 1.0, 0.0))
        return strewn(put.kind, many, host, *self._sorts(put))

    def _loose(self, put: Put) -> bool:
        """Whether nothing says where on its host a part goes."""
        return put.where.rounds is None and not self._exactly(put)

    def _sorts(self, put: Put) -> tuple[int, int]:
        """Of spots that are strewn over a host in several sorts: how many come before these, and how many there are."""
        own = put.copies[0][0]
        alike = [p for p in self.waiting if p.kind == put.kind and p.host == put.host and self._loose(p)]
        alike = [p for p in alike if p.copies == put.copies or p.copies[0][0] != own]  # other sorts, and these
        at = next((k for k, p in enumerate(alike) if p.copies == put.copies), -1)
        return (sum(len(p.copies) for p in alike[:at]), sum(len(p.copies) for p in alike)) if at >= 0 else (0, 0)

    def _exactly(self, put: Put) -> bool:
        """Whether a place is said so that nothing of it is left to choose."""
        at = put.where
        exact = (at.stitch, at.pair, at.aside, self._apart(at))
        return any(said is not None for said in exact) or bool(at.beside)

    def _long(self, copy: Copy) -> bool:
        """Whether a part is much longer than wide."""
        h = self.work.host((copy[0], 1))
        widest = max((len(p) for _, p in h.levels), default=1)
        return len(h.levels) > 0.62 * widest

    def _length(self, copy: Copy) -> float:
        """How long a part in rows is, along its rows or across them, in stitches; 0 of what is worked in rounds."""
        part = self.work.spots.parts[copy[0].copy(copy[1])]
        at = self.work.spots.layout[self.stand.nodes(part)]
        return float(np.ptp(at, axis=0).max()) if self.work.spots.in_rows[part] else 0.0

    def _spotted(self, put: Put, host: Host, way: Way, k: int) -> tuple[Spot, Way]:
        """Where one copy goes."""
        at, direction = put.where, way.direction
        if at.each:
            own = at.each[k * len(at.each) // len(put.copies)]
            at = replace(at, rounds=(own, own, False))
        if (
            at.rounds is not None
            and put.region == "body"
            and host.low > 1
            and at.rounds[1] < host.low
            and neck(self.work.spots, host.part) is not None
        ):
            # Rounds of a body that is worked on from the head, and numbered from 1 again.
            low, high, between = at.rounds
            at = replace(at, rounds=(low + host.low - 1, high + host.low - 1, between))
        beside = self._beside(put.where, host, way, self._half(put.copies[k]))
        if at.rounds is not None:
            level = 0.5 * (at.rounds[0] + at.rounds[1])
            part = self.work.spots.parts[put.copies[k][0].copy(put.copies[k][1])]
            if self.work.spots.in_rows[part] and _STANDS.search(at.text):
                level += 0.5 * (
                    len(self.work.host(put.copies[k]).levels) - 1
                )  # the middle of what stands on that round
            if put.kind in LAID and not self.work.spots.in_rows[part] and _LOWER_EDGE.search(at.text):
                tall = 0.5 * float(np.ptp(self.work.spots.layout[self.stand.nodes(part)], axis=0).max())
                above = level + math.copysign(round(tall), float(host.axis[1]))
                level = above if host.low <= above <= host.high else level
            if (hangs := _HANGS.search(at.text)) and one(hangs[1]) not in host.name.lower().split():
                half = self._half(put.copies[k])
                both = [n for n in (level - half, level + half) if host.low <= n <= host.high]
                level = min(
                    both,
                    default=level,
                    key=lambda n: min((p[:, 1].mean() for i, p in host.levels if i == int(n)), default=0.0),
                )
            if at.stitch is not None and len(put.copies) == 1:
                return Spot(host.name, level, at.stitch, put.span), way
            if at.pair is not None and len(put.copies) == 2:
                return Spot(host.name, level, sorted(at.pair)[k], put.span), way
            end = Spot(host.name, level, None, put.span)
            if len(put.copies) == 1 and put.kind not in LAID and self._lids(put.copies[0], end):
                return end, way
            if at.aside is not None and len(put.copies) == 1:
                return Spot(host.name, level, host.aside(level, at.aside), put.span), way
            stitch = host.in_round(level, direction)
            side_by = any(b[0] in SIDE or (b[0] in ABOVE and b[2] is None) for b in at.beside)
            if beside is not None and len(put.copies) == 2 and side_by and self._apart(at) is None:
                return Spot(host.name, level, host.in_round(level, beside - host.box[0]), put.span), way
            if len(put.copies) == 1 and (abs(way.at[0]) > 0.2 or way.at[2] < 0.2):
                stitch = round(2.0 * stitch) / 2.0
            if len(put.copies) == 1 and abs(way.at[0]) < 0.05 and way.at[1] < -0.5 and self._lies_name(host):
                half = 0.5 * host.count(level)  # in the middle of the underside, across from that of the top
                stitch = (host.middle(level) + half - 1.0) % (2.0 * half) + 1.0
            if len(put.copies) == 1 and abs(way.at[0]) < 0.2 and abs(way.at[2]) > 0.2:
                stitch = host.middle(level) if way.at[2] > 0 or self._lies_name(host) else stitch
            return Spot(host.name, level, round(stitch, 3), put.span), way
        if beside is not None:
            if put.kind == "muzzle" and any(b[:2] == ("between", "eye") for b in at.beside):
                # What begins between the eyes hangs below them.
                level = float(np.array(self.known["eye"][1]).mean(0)[1])
                beside = np.array([beside[0], level - _HANGS_BY * self._bulge(put.copies[k]), beside[2]])
            return replace(host.near(self._off_the_eyes(put, host, beside, k)), span=put.span), way
        eyes = self.known.get("eye")
        if put.kind in _BELOW_EYES and eyes is not None and eyes[0] == host.name and not at.says:
            middle, deep = np.array(eyes[1]).mean(0), self.deep.get("eye", 0.5)
            drop = deep + _BELOW_EYES[put.kind] * self._half(put.copies[k])
            there = self._off_the_eyes(put, host, host.ahead(middle[0], middle[1] - drop), k)
            return replace(host.near(there), span=put.span), way
        if "middle" in at.words and len(put.copies) == 1 and (begun := host.begun) is not None:
            return replace(begun, span=put.span), way
        if "tip" in at.words and len(put.copies) == 1:
            pole = self._far_end(host)
            if pole is not None:
                return replace(pole, span=put.span), way
        roughly = put.kind in _ON_TOP and not (put.kind == "neck" and self._lies_name(host))
        off = (bool(at.words & {"left", "right"}) and "top" not in at.words) or "chimney" in put.copies[0][0].words
        pole = host.pole(direction, _ROUGHLY if roughly else 0.9) if len(put.copies) == 1 and not off else None
        if pole is not None and put.host is not None and put.host[0].kind == "hat" and pole.round > host.high:
            pole = host.begun or pole  # the top of a cap is where it begins, not its opening
        if pole is not None:
            return replace(pole, span=put.span), way
        if put.kind == "eye" and len(put.copies) == 2 and is_mask(self.work, host):
            return replace(host.near(eye_on(host, math.copysign(1.0, way.at[0]))), span=put.span), way
        there = self._on_wall(put.copies[k], host, host.towards(direction))
        near = host.near(self._off_the_eyes(put, host, there, k))
        shoulder = self._shoulder(put, host, way)
        if shoulder is not None and abs(shoulder - near.round) >= _LOWER:
            near = Spot(host.name, shoulder, host.in_round(shoulder, direction))
        if (brow := self._brow(put, host)) is not None:
            about = np.where(direction[0] > 0.0, BROW, BROW * (-1.0, 1.0, 1.0))
            near = Spot(host.name, brow, host.in_round(brow, about))
        if put.kind in ("ear", "horn", "hat"):
            near = self._behind_face(put, host, near, direction, self._half(put.copies[k]))
        if (
            len(put.copies) == 1
            and near.stitch is not None
            and (x_ := abs(way.at[0])) >= 0.0
            and not (x_ < 0.2 and way.at[2] > 0.2)
        ):
            near = replace(near, stitch=round(2.0 * near.stitch) / 2.0)
        return replace(near, span=put.span), way

    def _off_the_eyes(self, put: Put, host: Host, point: Array, k: int) -> Array:
        """A snout's place moved down its head until it covers no eye."""
        eyes = self.known.get("eye")
        if put.kind not in _BELOW_EYES or eyes is None or eyes[0] != host.name or self._lies_name(host):
            return point
        least = self._bulge(put.copies[k]) + self.deep.get("eye", 0.5)
        x, y = float(point[0]), float(point[1])
        low = float(host.box[0][1] - 0.6 * host.box[1][1])
        while y > low and min(float(np.sqrt(((point - eye) ** 2).sum())) for eye in eyes[1]) < least:
            y -= _DOWN
            point = host.ahead(x, y)
        return point


def _mirrored(one: Placed, other: Placed) -> Placed:
    """The other of a pair held as the mirror image of the one: rounds that spiral lean a little, hands make up for it."""
    towards = (360.0 - one.towards) % 360.0
    points = None if one.points is None else (-one.points[0], *one.points[1:])
    return replace(
        other,
        points=points,
        tilt=one.tilt,
        towards=towards,
        across=-one.across if one.across else 0.0,
        flat=one.flat,
        by=one.by,
    )
