"""Likely: what parts are whose names do not say it, or say it wrongly: by their shapes, and by what is said of the others."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Final

from tambour.crochet.places.names import SIDED, Made
from tambour.crochet.places.upright import Upright

_HALVES: Final = re.compile(r"\bhal(?:f|ves)\b[^.\n]{0,40}\btog(?:ether)?\b|\b(?:join|sew)\b[^.\n]{0,20}\bhalves\b")
_CUT: Final = frozenset("front back left right upper lower side section half".split())
"""Words of pieces that clothes are sewn together from."""
NAMELESS: Final = re.compile(r"(?:part|piece)_\d+$")
"""What parts are called that no heading names."""


class Likely(Upright):
    """A toy of which more is known than what its parts are called."""

    def _undressed(self) -> None:
        """Trousers of a doll that has legs, and their legs, are none of its limbs."""
        if any(p.kind == "leg" and p.copies > 1 and not p.clad for p in self.parts):
            clad = [p for p in self.parts if p.kind == "leg" and p.copies == 1 and (p.clad or SIDED & set(p.words))]
            self.made.apart += [p.name for p in clad]
            self.parts = [p for p in self.parts if p not in clad]

    def _tailored(self) -> None:
        """Fronts and backs that follow clothes are pieces of these."""
        before: Made | None = None
        for part in list(self.parts):
            if before is not None and before.worn and part.words and set(part.words) <= _CUT:
                self._likely(part, "worn")
                part = replace(part, likely="worn")
            before = part

    def _shaped(self) -> None:
        """Parts whose names do not say what they are: a leg that goes on into the body; a large one beside the body; a bird's claws."""
        kinds = {p.kind for p in self.parts}
        for claws in [p for p in self.parts if p.kind == "claw" and p.copies == 2]:
            if "beak" in kinds and not kinds & {"leg", "foot"}:
                self._likely(claws, "foot")
        bare = [p for p in self.parts if p.single and not p.worn]
        if not bare:
            return
        tops = [p for p in bare if not p.kind and p.words[-1:] in (["top"], ["dome"])]
        if self.of_kind("stem") is not None and self.of_kind("hat") is None and tops:
            self._likely(tops[0], "hat")  # the top of a mushroom that has a stem
        legs = sorted((p for p in bare if p.kind == "leg"), key=self.size)
        if self.of_kind("body") is None and len(legs) > 1 and 2 * self.size(legs[-1]) > 3 * self.size(legs[-2]):
            self._likely(legs[-1], "body")  # the leg that goes on into the body
            return
        body = self.of_kind("body")
        whole = any(
            "body" in within for within in self.sections.values()
        )  # a doll of which the head goes on into the body
        goes_on = [p for p in bare if not p.kind and "body" in self.sections.get(p.name, {})]
        if body is None and goes_on and self.of_kind("head") not in (None, goes_on[0]):
            self._likely(goes_on[0], "body")  # breeches that go on as the body
            return
        if body is None and not whole and self.of_kind("head") is not None and (clad := self._clad()) is not None:
            self._likely(clad, "body")
            return
        if body is None or self.of_kind("head") is not None or "head" in body.kinds:
            return
        nose = self.of_kind("muzzle", "nose")
        if nose is not None and 4 * self.size(nose) > self.size(body) and re.search(r"\bhead\b", self.text):
            self._likely(nose, "head")  # worked from its nose, and called so
            return
        neck = self.of_kind("neck")
        if neck is not None and re.search(
            r"\b(?:ears?|eyes?|face)\b[^.\n]{0,30}\b(?:to|on) (?:the )?head\b", self.text
        ):
            self._likely(neck, "head")  # neck and head in one
            return
        others = [p for p in bare if not p.kind and not self.spots.in_rows[self.spots.parts[p.copy(1)]]]
        large = max(others, key=self.size, default=None)
        if large is not None and 3 * self.size(large) > self.size(body):
            self._likely(large, "head")

    def _clad(self) -> Made | None:
        """The clothes that are a doll's body, of one that has no other: the head is sewn to the tunic, or limbs to a "body"."""
        worn = [p for p in self.parts if p.single and p.worn]
        for p in reversed(worn):
            to = rf"\bhead\s+to\s+(?:the\s+)?(?:(?:top|neck)\s+of\s+)?(?:the\s+)?(?:\w+\s+)?{re.escape(p.words[-1])}\b"
            if re.search(rf"{to}|\b{re.escape(p.words[-1])}\s+to\s+(?:the\s+)?head\b", self.text):
                return p
        if not re.search(r"\b(?:head|arms|legs|tail)\b[^.]{0,30}\b(?:of|to) (?:the )?body\b", self.text):
            return None
        bare = [p for p in self.parts if p.single and p.kind == "" and not NAMELESS.match(p.name)]
        large = max([*worn, *bare], key=self.size, default=None)
        head = self.of_kind("head")
        return large if large is not None and head is not None and 3 * self.size(large) > self.size(head) else None

    def _likely(self, part: Made, kind: str) -> None:
        self.parts[self.parts.index(part)] = replace(part, likely=kind)

    def _other_half(self, part: Made) -> Made | None:
        """The other of two halves worked in rounds that are held together, where ``part`` is one of them."""
        if part.kind or "half" not in part.words:
            return None
        others = [m for m in self.parts if m != part and m.single and "half" in m.words and not m.kind]
        same = [m for m in others if self.open(m.copy(1)) == self.open(part.copy(1)) > 0]
        return same[0] if len(same) == 1 and _HALVES.search(self.text) else None

    def _end_of(self, part: Made) -> Made | None:
        """The part of which another's name says that it is its end: "End of tail"."""
        if not part.words or part.words[0] not in ("end", "tip") or part.noun == len(part.words):
            return None
        return next((m for m in self.parts if m.single and m != part and m.words == part.words[part.noun :]), None)
