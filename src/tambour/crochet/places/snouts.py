"""Snouts: heads that are worked from their noses and look ahead, and the round at which such a snout becomes the head."""

from __future__ import annotations

import math
import re
from typing import Final

import numpy as np

from tambour.crochet.places.beside import Beside
from tambour.crochet.places.stand import Host, numbers_of

_FACE_FIRST: Final = re.compile(
    r"\b(?:beg\w*|start\w*|work\w*)\.?\s+(?:at|from|in)\s+(?:the\s+)?(?:cent(?:er|re)|middle) of (?:the )?face\b"
)
"""That a head is worked from the middle of its face."""
_SNOUT, _FULL, _BLUNT = 0.6, (0.6, 0.9), 0.3
"""A snout ends in this first part of a head's rounds, where they have more than the first of these shares of the widest one's
stitches; one that is blunt at the second of them, or behind this part of the rounds."""
BROW, CHEEKS = np.array([0.75, 0.45, 0.0]), np.array([0.8, -0.25, 0.0])
"""Where eyes are about a head that lies, seen from its nose, and what is below them."""


class Snouts(Beside):
    """Knows which heads look ahead."""

    def _ahead(self, host: Host) -> bool:
        """Whether a part is a head, or head and body, that is worked from its nose and looks ahead."""
        made = next(p for p in self.work.parts if host.name in {p.copy(k) for k in range(1, p.copies + 1)})
        lies = self._lies((self.work.main, 1)) and not self._swims() and (made == self.work.main or made.kind == "head")
        return (lies and host.axis[2] < -0.7) or self.work.nose_first(made)

    def _begins_at_face(self, host: Host) -> bool:
        """Whether a head is worked from the middle of its face, a disc that bears the eyes, and not from a nose."""
        made = next(p for p in self.work.parts if host.name in {p.copy(k) for k in range(1, p.copies + 1)})
        part = next(p for p in self.work.built.pattern.parts if p.name == made.name)
        first = part.lines[0].span.start if part.lines else part.span.end
        return _FACE_FIRST.search(self.work.text, part.span.start, max(first, part.span.start) + 60) is not None

    def _swims(self) -> bool:
        return any(p.kind in ("fluke", "fin") for p in self.work.parts)

    def _behind_snout(self, host: Host) -> float:
        """The round in which a snout becomes the head: the first that is nearly as wide as the widest, and stays so."""
        low, high = numbers_of(self.stand.spots, host.part)
        counts = [len(ring) for _, ring in host.levels]
        some = counts[: max(1, math.ceil(_SNOUT * len(counts)))]
        ends = [max((k + 1 for k, c in enumerate(some) if c < share * max(counts)), default=0) for share in _FULL]
        level = ends[0]
        if level <= 0.2 * (high - low + 1):
            level = max(level, min(ends[1], round(_BLUNT * (high - low + 1))))  # a blunt one has its eyes at its sides
        return float(host.levels[min(level, len(counts) - 1)][0])
