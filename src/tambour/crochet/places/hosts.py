"""Hosts: what a part is sewn to where no sentence says it, and where what it says would hide the part."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.places.hear import Put
from tambour.crochet.places.likely import Likely
from tambour.crochet.places.names import SIDED, Made
from tambour.crochet.places.stand import numbers_of
from tambour.crochet.places.usual import usual

LIMBS: Final = frozenset(("arm", "leg", "foot", "wing", "fin", "tail", "ear", "horn"))
DOMED: Final = frozenset(("muzzle", "nose"))
"""Kinds of parts that bulge, however flat they are worked: stuffing is put under them while they are sewn on."""
RIM, RIM_OFF = 16, 3
"""Rims of so many stitches or more meet where they differ by no more than this."""
SIZES: Final = frozenset(("large", "small", "big", "little", "mini", "medium"))
"""Words of parts of which one is for every size of a toy."""
_ABOVE_RIM: Final = 3
"""So many rounds above the rim of a shell its head is."""
_PATCHES: Final = frozenset(("belly", "face", "spot"))
"""Kinds of things that stand out from a toy, and of things that only lie on it, and bear none of them."""
_ON_FACES: Final = frozenset(("eye", "nose", "muzzle", "beak", "cheek"))
"""Kinds of parts that a face bears."""
_CROWNING: Final = frozenset(("bow", "leaf", "stem", "tuft"))
"""Kinds of things that are put on a head, and on the hat or the hair over it where it has one."""

_ENDS: Final = SIDED | frozenset("front back hind fore rear upper lower top bottom".split())
"""Words by which one pair of limbs is told from the other."""
_TRIMMINGS: Final = frozenset("edging trim ruffle strap tie lace band".split())
"""Words of what is worn that a cake may have too."""
_CLOTHES: Final = re.compile(r"\b(?:outfit|clothes|clothing|wardrobe|accessories|costume|cardigan|dress)\b")
"""What titles of patterns for clothes say."""
_OF_ROOF: Final = frozenset(("attic", "dormer", "skylight"))
"""Words of a window that is in a roof."""
_SMOKE: Final = frozenset(("smoke", "puff", "steam"))
"""What rises from a chimney."""
_OTHERS: Final = re.compile(r"\b(?:remaining|others?|rest|next|second|third|another|each)\b")
"""Words of a sentence that puts others of a part elsewhere."""


class Hosts(Likely):
    """Knows what every part of a toy is sewn to."""

    @property
    def bearer(self) -> Made:
        """What bears a face and what no sentence puts elsewhere: the main part, but of a plant in its pot the plant."""
        if not self.main.vessel:
            return self.main
        put = [c[0] for p in self.heard.puts for c in p.copies if not p.guess and c[0] != self.main]
        return max((m for m in put if m.single and not m.kind), key=self.size, default=self.main)

    def _between_rims(self) -> None:
        """A ring that is sewn to the rim of what stands on another part by its rim is between the two: gills are sewn to the cap outside and to the
        stem inside, and the cap is on them."""
        for ring in self.heard.puts:
            made, onto = ring.copies[0][0], ring.host
            if len(ring.copies) > 1 or onto is None or not onto[0].single or ring.where.says:
                continue
            begun, rim = len(self.spots.begun(self.spots.parts[made.copy(1)])), self.open(made.copy(1))
            under = next((p for p in self.heard.puts if p.copies == [onto] and p.host is not None), None)
            if (
                under is None
                or under.host is None
                or min(begun, rim) < RIM
                or abs(rim - self.open(onto[0].copy(1))) > RIM_OFF
            ):
                continue
            if abs(begun - self.open(under.host[0].copy(1))) <= RIM_OFF:
                ring.host, under.host, under.where = under.host, ring.copies[0], ring.where

    def _carapace(self) -> Made | None:
        """The shell that is the trunk of a toy with no other: its belly is sewn to it, however else that is said once more."""
        shell, bellies = self.of_kind("shell"), [p for p in self.heard.puts if p.kind == "belly"]
        if shell is None or not shell.single or shell not in [p.host[0] for p in bellies if p.host is not None]:
            return None
        for p in bellies:
            p.host = p.host or (shell, 1)
        return shell

    def _another(self, p: Put, puts: list[Put]) -> bool:
        """Whether limbs are of another version of the toy, or a piece of those that are there: a pair is at that place already."""
        made = p.copies[0][0]
        if made.hair and any(q.copies[0][0] != made and q.copies[0][0].words == made.words for q in puts):
            return True  # the girl's, where only the boy is made
        if self._of_other_size(made):
            return True
        if p.kind not in ("ear", "arm", "leg") or "inner" in made.words or p.where.rounds is not None or made.tipped:
            return False
        for q in puts:
            other = q.copies[0][0]
            apart = p.host is not None and q.host is not None and p.host != q.host
            if q.kind != p.kind or apart or "inner" in other.words or q.where.words != p.where.words:
                continue
            same = other.words == made.words or (p.guess and q.guess and not (_ENDS & {*made.words, *other.words}))
            if len(q.copies) == len(p.copies) == 2 and (p.kind == "ear" or same):
                if p.kind != "ear" and self.size(made) > self.size(other):
                    p.copies, q.copies = q.copies, p.copies  # a sleeve's end is the piece of an arm
                return True
        return False

    def _of_other_size(self, made: Made) -> bool:
        """Whether a limb is of another size of the toy, which has a body and such limbs for each size: "Small Arms" beside "Large Body"."""
        bodies = {frozenset(SIZES & set(m.words)) for m in self.parts if m.kind == "body" and m.single}
        mine, main = (frozenset(SIZES & set(m.words)) for m in (made, self.main))
        alike = {frozenset(SIZES & set(m.words)) for m in self.parts if m.kind == made.kind}
        return bool(made.kind in LIMBS and mine and main and mine != main and {mine, main} <= bodies & alike)

    def _goes_on_head(self, p: Put) -> bool:
        return p.region == "head" or (
            "button" not in p.copies[0][0].words and p.region != "body" and usual(p.kind, len(p.copies))[0].on == "head"
        )

    def _seat(self, p: Put, puts: list[Put]) -> None:
        """Gives a put its host: what was said, or what such parts are usually on; never what would hide it."""
        main, head = self.main, self.of_kind("head")
        kind, made, unsaid = p.kind, p.copies[0][0], p.host is None
        if p.host is not None and p.host[0] not in (main, head) and self._past(p):
            p.host = None  # "ears: either side of the horn, Round 19": of the head, a horn has eight
        if kind == "head" and "neck" in p.where.words:
            p.where = replace(p.where, rounds=None, stitch=None)  # those that are said are its own
        if (p.host is None or p.guess) and (after := self._named_after(made)) is not None:
            p.host = (after, 0 if after.copies == len(p.copies) else 1)  # the cup's handle is on the cup
        if p.host is None or p.host in p.copies:
            own = head in [c[0] for c in p.copies]
            p.host = (self.bearer if head is None or own or not self._goes_on_head(p) else head, 1)
        if p.host[0] == main and (onto := self._end_of(made)) is not None:
            p.host = (onto, 1)
            p.where = replace(p.where, words=p.where.words | {"tip"})
        every = [c[0] for q in puts for c in q.copies]
        mask = next((m for m in every if m.kind == "face" and m.single), None)
        if kind in _ON_FACES and mask is not None and p.where.rounds is None and made != mask:
            p.host = (mask, 1)  # on the face that is sewn on, and not behind it
        if kind in ("head", "neck") and p.host[0] == main and main.kind == "shell" and p.where.rounds is None:
            level = float(
                numbers_of(self.spots, self.spots.parts[main.copy(1)])[1] - _ABOVE_RIM
            )  # it looks out from under it
            p.where = replace(
                p.where, rounds=(level, level, False), words=p.where.words | {"front", "forwards"}, beside=()
            )
        if p.host[0].halved:  # of two halves the front one bears all
            p.host = (p.host[0], 1)
        self._off_what_hides(p)
        if kind == "wheel":
            p.host = (main, 1)
            p.where = replace(p.where, rounds=None, beside=(), words=p.where.words & {"front", "back"})
            whole = [c for c in p.copies if not c[0].half or c[1] % 2]
            self.made.apart += [made.name] if len(whole) < len(p.copies) else []
            p.copies = whole  # two halves make one; the inner ones are not seen
        hair = [m for m in every if m.kind == "hat" and m.hair]
        hats = [m for m in every if m.kind == "hat" and m.single and m != made]
        if kind == "hat" and hair and hair[0] != made and p.host[0] not in hair and not p.where.says:
            p.host = (hair[0], 1)  # over the hair, not inside of it
        crowned = p.host[0] == head or (head is None and p.host[0] == main and self._goes_on_head(p))
        if hats and _OF_ROOF & set(made.words) and (p.guess or not p.where.beside or p.host[0] == main):
            p.host = (hats[0], 1)  # an attic window, over the door
        stack = next((m for m in every if m.single and "chimney" in m.words and m != made), None)
        if stack is not None and _SMOKE & set(made.words) and (unsaid or p.host[0] == main):
            p.host = (stack, 1)  # it rises from the chimney, and from no wall
            p.where = replace(p.where, rounds=None, beside=(), words=frozenset(("tip",)))
        if kind == "spot" and main.kind == "stem" and hats and p.host[0] == main and (unsaid or not p.where.says):
            p.host = (hats[0], 1)  # a toadstool's are on its cap
        if kind in _CROWNING and crowned and hats and p.where.rounds is None and not p.where.beside:
            p.host = (next((m for m in hats if not m.hair), hats[0]), 1)
        if (made.shod or made.tipped) and p.host[0] == main and p.where.rounds is None:
            limb = "leg" if made.shod else "arm"
            limbs = [
                m for m in self.parts if m.kind == limb and m.copies == len(p.copies) and m != made and not m.tipped
            ]
            if limbs:  # shoes and hands are at the ends of its legs and arms
                p.host = (limbs[0], 0)
                p.where = replace(p.where, beside=(), words=frozenset(("tip",)))
        if kind == "head" and p.host[0].kind == "body" and (necks := self.of_kind("neck")) is not None:
            p.host = (necks, 1)
        if kind == "inner" or "inner" in made.words:
            ears = [m for m in every if m.kind == "ear" and m != made]
            singles = [m for m in dict.fromkeys(ears) if m.copies == 1]  # "one in A and one in B"
            if len(p.copies) == len(singles) == 2:
                puts.append(replace(p, copies=p.copies[1:], host=(singles[1], 1)))
                p.copies, p.host = p.copies[:1], (singles[0], 1)
            elif ears and ears[0].copies >= len(p.copies) and p.host[0] not in singles:
                p.host = (ears[0], 0)

    def _past(self, p: Put) -> bool:
        """Whether the rounds that are said lie beyond the last one of what a part is said to be put on."""
        assert p.host is not None
        part = self.spots.parts[p.host[0].copy(max(1, p.host[1]))]
        return p.where.rounds is not None and p.where.rounds[0] > numbers_of(self.spots, part)[1] + 1

    def _named_after(self, made: Made) -> Made | None:
        """The part by which another is called, that is neither worn nor a head or a body: "wheel flower", "cup handle"."""
        before = set(made.words[:-1])
        found = [m for m in self.parts if m != made and m.words and m.words[-1] in before and not m.worn]
        found = [m for m in found if m.kind not in ("head", "body") and m.words != made.words]
        return max(found, key=lambda m: len(before & set(m.words)), default=None)  # of two cups the one of its own name

    def _off_what_hides(self, p: Put) -> None:
        """Limbs off patches, a beard off the beak or the hat that it would hide: each on what these lie on."""
        assert p.host is not None
        kind, onto, head = p.kind, p.host[0], self.of_kind("head")
        above = (head if head is not None else self.main, 1)
        if kind in LIMBS and onto.kind in _PATCHES:
            p.host = above if kind in ("ear", "horn") else (self.main, 1)
            upper = frozenset(("upper",)) if p.where.words & {"top", "upper"} else frozenset[str]()
            p.where = replace(
                p.where, rounds=None, stitch=None, beside=(), words=upper
            )  # near the top of a belly is high on its body
        elif kind == "beard" and onto.kind in ("beak", "nose", "muzzle"):  # a wattle hangs below it
            p.where = replace(p.where, beside=(("below", onto.kind, None),), words=frozenset())
            p.host = above
        elif (kind == "beard" and onto.kind == "hat") or (kind == "hat" and p.copies[0][0].hair and onto.kind in LIMBS):
            # A beard is on the face under the hat, and hair grows on no arm.
            p.host = above
            p.where = replace(p.where, rounds=None, stitch=None, beside=(), words=frozenset())

    def _said_again(self, p: Put, puts: list[Put]) -> None:
        """Keeps a sentence of whose paragraph another says more of where its part goes: "Pin the bib under the chin. Its top touches the neck …"."""
        first = next((q for q in puts if q.copies == p.copies and not q.guess), None)
        if first is None or p.guess or p.where.rounds is not None or p.host not in (None, first.host):
            return
        if _OTHERS.search(self.text, p.span.start, p.span.end):
            return
        a, b = sorted((p.span, first.span), key=lambda span: span.start)
        known, new = first.where, p.where
        open_ = not any(v is not None for v in (known.apart, known.apart_mm, known.aside, known.pair, known.stitch))
        if open_ and (new.apart is not None or new.apart_mm is not None):  # "They sit 6 stitches apart", told behind it
            first.where = replace(known, apart=new.apart, apart_mm=new.apart_mm)
        if "\n" not in self.text[a.end : b.start]:
            self.made.more.append(p.span)

    def _outfit(self) -> bool:
        """Whether the parts are clothes for a doll that is not made here: no head, no face, and something worn, or a title that says so."""
        kinds = {kind for p in self.parts for kind in p.kinds}
        if self.heard.features or kinds & {"head", "face", "eye", "ear", "muzzle", "nose", "beak"}:
            return False
        clothes = any(p.worn and not _TRIMMINGS & set(p.words) for p in self.parts)
        limbs = {p.kind for p in self.parts} & {"arm", "tail", "wing", "fin", "horn"}
        return _CLOTHES.search(self.text.lstrip().split("\n")[0]) is not None or (clothes and not limbs)
