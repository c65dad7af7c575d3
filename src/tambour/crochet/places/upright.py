"""Upright: which way the main part of a toy stands, from what is said of its ends, its face, its legs and its tail."""

from __future__ import annotations

import re
from typing import Final

import numpy as np

from tambour.crochet.places.hear import Feature, Heard
from tambour.crochet.places.names import Made, one
from tambour.crochet.places.onward import limbs
from tambour.crochet.places.stand import numbers_of
from tambour.crochet.places.toy import Toy

_TOP: Final = re.compile(
    r"\b(?:begin|start|work)\w*\s+(?:at|from|with)\s+(?:the\s+)?(?:very\s+)?(?:top|crown)|from (?:the )?top (?:to|down|of)|top[- ]down\b"
)
_REAR: Final = re.compile(
    r"\b(?:beg(?:in(?:ning)?)?|start(?:ing)?|work(?:ed|ing)?)\.?\s+(?:at|from|with)\s+(?:the\s+)?"
    r"(?:bottom,?\s+(?:or\s+|at\s+)?(?:the\s+)?)?(?:rear|back|hind|tail|bum|bottom) end\b(?! of)|\b(?:beg(?:in(?:ning)?)?|start(?:ing)?)\.?\s+(?:at|from)\s+(?:the\s+)?(?:rear|rump|tail|bum)\b"
)
"""What lies and begins so has its end ahead."""
_SEAT: Final = re.compile(
    r"\b(?:beg(?:ins?|in(?:ning)?)?|starts?|starting|work(?:ed|ing)?)\.?\s+(?:at|from|with|under|underneath|beneath|in)\s+(?:the\s+|her\s+|his\s+|its\s+)?(?:very\s+)?(?:(?:middle|cent(?:er|re))\s+of\s+the\s+)?(?:bottom|base|seat|floor)\b"
    r"(?! (?:end|of (?:the )?(?:head|leg)))(?!,? (?:at |or )?(?:the |his |her |its )?(?:tail|rear|hind|back)\b)"
)
"""A body that begins so stands on it, or sits, though it has four legs."""
_SITS: Final = re.compile(
    r"\bsits\s+(?:about|approx\w*\.?|around|roughly|at)?\s*\d(?!\d*\s*(?:r(?:n?d|ound|ow)?s?|st|sts|stitch\w*)\b)|\b(?:measures?|tall|high|height|size)\b[^.\n]{0,40}\b(?:sitting|seated)\b|\bproper sitting\b"
    r"|\b(?:sitting|seated)\b[^.\n]{0,30}\b(?:\d+(?:[.,]\d+)?\s*(?:cm|mm|in\b|inch|\")|tall|high(?! (?:on|up|at)\b)|height)"
)
"""A toy of which is told how tall it is when it sits."""
_CM: Final = re.compile(r"\d\s*(?:cm|mm|in\b|inch|\"|”|'')")
_NEAR: Final = 24
"""A length is told within so many letters of that."""
_TOYS: Final = 2
"""Where so many things are measured, it may be another that sits."""
_UPWARDS: Final = re.compile(
    r"\bbottom[- ](?:to[- ])?(?:the )?(?:up|top|neck)\b|\b(?:up )?from (?:the |its |his |her )?(?:bottom|ground|base|floor|feet|toes|hem|seat|lower edge) up(?:wards?)?\b"
)
"""What is worked from its lower end to its upper one."""
_NECK: Final = 0.7
"""A long neck: the first quarter of a body's rounds stays narrower than this share of the widest."""
_MEASURED: Final = re.compile(r"(?:^|\n)(?P<of>[^\n.]*)\bmeasure(?:s|ments?)\b[^\n]*\n?[^\n]*")
"""What a toy is said to measure, and what is said to."""
_ELSE: Final = re.compile(r"\b(?:gauge|tension|swatch|sample|square|circle|hook|case|needle|skein|ball|yarn|eyes?)\b")
"""What is measured too, and is no toy."""
_SHAPED: Final = re.compile(
    r"(?:^|\n)\s*(?:shap(?:e|ing) (?:the )?)?(head|body|tail)(?: shap\w+)?\s*:\s*(?:\d|rnd|round|next)"
)
"""Where in one piece another end of the toy begins."""
_OPEN: Final = 8
"""An end of so many stitches is an opening that a head is sewn to."""
_RIM_OFF: Final = 3
"""Rims that differ by so many stitches or fewer fit on each other."""
_MUZZLE, _BEHIND, _NARROWER = (0.2, 0.6), 5, 0.85
"""A muzzle is so much of a head's rounds; eyes are in the first so many rounds behind it, which have so much of its stitches."""
_EGG: Final = (0.45, 0.55, 0.75)
"""A head that is an egg has so many rounds to a stitch of its widest, which is no earlier than this share of them; at a quarter of
them it has no more than this share of its stitches."""
_BASES: Final = frozenset(("base", "bottom", "boden", "fondo", "fond", "bodem"))
"""What such a piece stands on is called so."""
_BELOW: Final = re.compile(r"\b(?:lower|bottom)\s+(?:edge|edging|end|opening)s?\b")
"""What the last round of a piece is called that is worked downwards, where it is closed."""
_RING: Final = 8
"""What begins with so many stitches begins at a tip."""
_SNOUT: Final = (7, 2, 0.5)
"""A head has a snout whose first rounds, so many or more and so many times those of its other end, have less than this share of its widest."""
_LOW: Final = 0.45
"""A face in this first part of a piece's rounds says that the piece is worked from its top."""
_LATER: Final = 0.6
"""Strands behind this part of a piece's rounds hang off its end."""
_CRAWLS: Final = frozenset(
    "caterpillar worm inchworm bookworm snake serpent slug eel raupe wurm schlange oruga gusano serpiente chenille rups slang".split()
)
"""Animals that lie on their bellies, all length."""
_PEAR: Final = 0.51
"""A pear's rounds have their middle, each weighed by its stitches, behind this share of them where its narrow end is worked first."""
_FACES: Final = frozenset(("eye", "muzzle", "nose", "beak"))
"""Parts that make a body a head as well."""
_TITLE: Final = 9
"""A title of fewer words speaks of one toy."""
_HIND: Final = 0.75
"""A tail before this part of a piece's rounds says that they are not its hind end."""


class Upright(Toy):
    """A toy of which is heard how it stands.

    heard : what its sentences say
    """

    heard: Heard

    def ahead(self, made: Made) -> bool:
        """Whether a part is worked from its nose: by its words, by a muzzle of another colour with the eyes behind it, or by its shape."""
        return super().ahead(made) or self._muzzled(made) or self._pointed(made) or self._snouted(made)

    def _snouted(self, made: Made) -> bool:
        """Whether a head begins with a long snout, of which its other end has nothing: as narrow for many rounds, before it widens to a ball."""
        part = self.spots.parts.get(made.copy(1))
        head = made.kind == "head" and made.single and "body" not in made.kinds and part is not None
        if not head or self.spots.in_rows[part] or self.of_kind("muzzle", "nose", "beak", "hat"):
            return False
        counts = [r.count for r in self.built.rounds if r.part == part and not r.aside]
        if not counts or counts[0] > _RING:
            return False
        many, times, narrow = _SNOUT
        wide = [k for k, count in enumerate(counts) if count >= narrow * max(counts)]
        return wide[0] >= max(many, times * (len(counts) - 1 - wide[-1]))

    def _pointed(self, made: Made) -> bool:
        """Whether a closed head without a muzzle, of what goes on four legs, is an egg that widens slowly: its narrow end is its nose."""
        part = self.spots.parts.get(made.copy(1))
        legs = sum(p.copies for p in self.parts if p.kind in ("leg", "foot"))
        goes = legs == 4 and not any(p.kind == "arm" for p in self.parts) and self.of_kind("body") is not None
        head = made.kind == "head" and made.single and "body" not in made.kinds and part is not None
        if not (goes and head) or self.open(made.copy(1)) or self.of_kind("muzzle", "nose", "beak"):
            return False
        counts = [r.count for r in self.built.rounds if r.part == part and not r.aside]
        widest = max(counts, default=0)
        return (
            len(counts) > _EGG[0] * widest
            and counts.index(widest) >= _EGG[1] * len(counts)
            and counts[len(counts) // 4] <= _EGG[2] * widest
        )

    def _muzzled(self, made: Made) -> bool:
        """Whether a head begins with a muzzle: its first rounds have a colour of their own and are its widest, and its eyes are
        close behind them, where it is narrower; a cap or hair is no wider than what is under it."""
        part = self.spots.parts.get(made.copy(1))
        head = made.kind == "head" and made.single and "body" not in made.kinds and part is not None
        heard = getattr(self, "heard", None)
        if not head or part is None or heard is None or self.spots.in_rows[part] or self.of_kind("muzzle", "nose"):
            return False
        low, high = numbers_of(self.spots, part)
        rounds = [k for n in range(low, high + 1) if (k := self.spots.round_at(part, n)) is not None]
        counts = [len(self.spots.stitches(k)) for k in rounds]
        colors = [
            self.built.graph.color[self.spots.stitches(k)[0]].tolist() for k in rounds if self.spots.stitches(k).size
        ]
        eyes = [0.5 * (f.where.rounds[0] + f.where.rounds[1]) - low for f in heard.features
                if f.where.rounds and f.what.endswith("eyes") and self._is_on(f, made)]  # fmt: skip
        if len(colors) != len(counts) or not eyes:
            return False
        band = next((k for k, c in enumerate(colors) if c != colors[0]), 0)
        at = round(float(np.mean(eyes)))
        widest = max(counts)
        return (
            _MUZZLE[0] * len(counts) <= band <= _MUZZLE[1] * len(counts)
            and max(counts[:band]) == widest
            and band <= at <= band + _BEHIND
            and counts[min(at, len(counts) - 1)] <= _NARROWER * widest
        )

    def _stand_up(self) -> None:
        """Which way parts stand that others stand on."""
        main = self.main
        part = self.spots.parts[f"{main.name}.1"]
        if self.up.get(main.name) is None:
            up = self._upright(main, part)
            if up == "side" and self._begins(main, _REAR):
                up = "back"
            if up != "end":
                self.made.ups[main.name] = up
        self.stand.set_up(part, self.made.ups.get(main.name) or self.up.get(main.name) or "end")

    def _fringed(self, part: int) -> bool:
        """Whether strands hang off one of a piece's later rounds: arms of an octopus, which it stands on."""
        rounds = [r for r in self.built.rounds if r.part == part]
        whole = [r for r in rounds if not r.aside]
        return any(r.aside and sum(w.first < r.first for w in whole) > _LATER * len(whole) for r in rounds)

    def _upright(self, main: Made, part: int) -> str:
        low, high = numbers_of(self.spots, part)
        legs = sum(p.copies for p in self.parts if p.kind in ("leg",))
        legs = (
            2 if any(p.kind == "arm" for p in self.parts) else legs
        )  # it has arms: four are legs and the trousers on them
        swims = any(p.kind == "fluke" or "fluke" in p.words for p in self.parts)
        head = self.of_kind("head")
        faces = [f.where.rounds[0] for f in self.heard.features if f.where.rounds and self._is_on(f, main)]
        faces += [
            p.where.rounds[0]
            for p in self.heard.puts
            if p.where.rounds
            and p.host
            and p.host[0] == main
            and p.copies[0][0].kind in ("eye", "muzzle", "nose", "beak")
        ]
        early = bool(faces) and (np.mean(faces) - low + 1) / (high - low + 1) < _LOW
        mine = [p for p in self.heard.puts if p.host is not None and p.host[0] == main]
        tails = [p.where.rounds for p in mine if p.kind in ("tail", "fluke") and p.where.rounds]
        # What goes on four legs is worked from its nose or its neck to its tail, and its head is not on top.
        stands = any((0.5 * (a + b) - low + 1) / (high - low + 1) < _HIND for a, b, _ in tails) or (
            self.open(f"{main.name}.1") > 8 and any(p.kind == "head" and "top" in p.where.words for p in mine)
        )
        if main.kind == "shell" and any(p.kind == "belly" for p in mine):
            return "start"  # a dome over the belly
        if self.ahead(main):
            return "side"
        if self._begins(main, _UPWARDS):
            return "end"
        if any(self.built.graph.part[gap[0]] == part for _, gap in limbs(self.built, self.spots)):
            return "start"  # its last rounds are shared out between two legs
        if any(p.kind == "leg" and "front" in p.where.words and p.where.words & {"upper", "lower"} for p in mine):
            legs = 2  # it sits: its front legs are above its hind legs, and all are in front
        if main.vessel and self.open(f"{main.name}.1") and not self.spots.in_rows[part]:
            return "end" if len(self.spots.rim(part)) else "start"
        counts = [r.count for r in self.built.rounds if r.part == part and not r.aside]
        necked = max(counts[: max(1, len(counts) // 4)], default=0) < _NECK * max(counts, default=1)
        if self._from_top(main) and (head in (None, main) or necked):
            return "start"  # what begins at its neck, and widens at once, may go on four legs
        arms = any(p.kind == "arm" for p in self.parts)
        if sum(p.copies for p in self.parts if p.kind in ("leg", "foot")) == 4 and not arms and head is None:
            measured = next((m for m in _MEASURED.finditer(self.text) if not _ELSE.search(m["of"])), None)
            if measured and "long" in measured[0] and not re.search(r"\b(?:tall|high)\b", measured[0]):
                return "side"
        if not self.spots.in_rows[part] and (said := self._shapes(main)) is not None:
            return said
        if not arms and legs != 2 and not self.open(f"{main.name}.1") and self._crawls(main) and (early or not faces):
            return "side"
        if not self.spots.in_rows[part] and self._ends_below(main):
            return "start"
        sits = self._seated() and len(re.findall(r"\bmeasures?\b", self.text)) < _TOYS
        if head not in (None, main) and (sits or self._begins(main, _SEAT)):
            return "end"
        if main.kind == "stem" and self._begins(main, _SEAT):
            return "end"
        if head in (None, main) and self._based(main, part):
            return "start"
        if not stands and (swims or (legs == 4 and main.kind != "head")) and (early or not faces):
            return "side"
        if head is not None and head != main:
            # What begins at an open neck and is closed below was worked downwards.
            down = len(self.spots.begun(part)) >= _OPEN and not len(self.spots.rim(part))
            return "start" if down and not self.spots.in_rows[part] else "end"
        if (below := self._mouth_below(main)) is not None:
            return "end" if below else "start"
        if main.kind == "hat":
            return "start"
        if main.kind == "head" and "body" not in main.kinds and legs:
            return "start"
        if (
            early
            or any(p.kind == "tentacle" for p in self.parts)
            or self._fringed(part)
            or self._top_said(main)
            or self._named_top(main)
        ):
            return "start"
        if len(counts) > 4 and counts[-1] >= 2 * counts[-2] > 20:
            return "start"  # a ruffle hangs
        wide = self.open(f"{main.name}.1")
        single = [
            p for p in self.heard.puts if main.kind in ("", "stem") and len(p.copies) == 1 and p.copies[0][0] != main
        ]
        lids = [
            p for p in single if (p in mine and p.kind == "hat") or (p.host is None and not p.kind and not p.where.says)
        ]
        if any(abs(self.open(p.copies[0][0].copy(1)) - wide) <= _RIM_OFF for p in lids):
            return "end"  # a roof that closes it
        hung = any(p.host and p.host[0] == main and "top" in p.where.words for p in self.heard.puts)
        late = bool(faces) and (np.mean(faces) - low + 1) / (high - low + 1) > 0.5  # its face is on its upper half
        if main.kind == "body" and head is None and not wide and not late and self._pear(part, counts):
            return "start"
        return (
            "start"
            if wide >= 12 and not self.spots.in_rows[part] and (hung or main.kind in ("hat", "head", ""))
            else "end"
        )

    def _based(self, main: Made, part: int) -> bool:
        """Whether a base closes the open end of a piece that is closed where it begins: it stands on that."""
        wide = self.open(f"{main.name}.1")
        if not wide or self.spots.in_rows[part] or len(self.spots.begun(part)):
            return False
        bases = [p for p in self.parts if p.single and p != main and p.words and p.words[-1] in _BASES]
        return any(abs(self.open(p.copy(1)) - wide) <= _RIM_OFF for p in bases)

    def _pear(self, part: int, counts: list[int]) -> bool:
        """Whether a closed piece that is head and body in one is narrower where it begins: it sits on its broad end."""
        if self.spots.in_rows[part] or len(counts) < 4 or not any(p.kind in _FACES for p in self.parts):
            return False
        n = np.array(counts, float)
        return float((n * np.arange(len(n))).sum()) > _PEAR * (len(n) - 1) * float(n.sum())

    def _crawls(self, main: Made) -> bool:
        """Whether it is an animal that is all length and lies on its belly, by its name or its title."""
        title = {one(w) for w in re.findall(r"[^\W\d_]+", self.text.strip().split("\n")[0])}
        return bool(_CRAWLS & set(main.words) or (_CRAWLS & title and len(title) < _TITLE))

    def _seated(self) -> bool:
        """Whether the words tell how tall the toy is when it sits, and not of a tail that sits so many rounds above a seam."""
        return any(_CM.search(self.text, max(0, m.start() - _NEAR), m.end() + _NEAR) for m in _SITS.finditer(self.text))

    def _top_said(self, main: Made) -> bool:
        """Whether words before the parts, or those of the main one, begin at the top; what another part says of itself is none of these."""
        starts = sorted(p.span.start for p in self.built.pattern.parts)
        own = next(p.span.start for p in self.built.pattern.parts if p.name == main.name)
        end = next((k for k in starts if k > own), len(self.text))
        said = (m.start() for m in _TOP.finditer(self.text, 0, 4000))
        return any(at < starts[0] or own <= at < end for at in said)

    def _from_top(self, main: Made) -> bool:
        """Whether the main part's own first words begin it at the top."""
        return self._begins(main, _TOP)

    def _ends_below(self, main: Made) -> bool:
        """Whether the last round of the main part says that it closes the lower edge."""
        part = next(p for p in self.built.pattern.parts if p.name == main.name)
        last = next((line.span for line in reversed(part.lines) if line.in_round), None)
        return last is not None and _BELOW.search(self.text[last.start : last.end]) is not None

    def _begins(self, main: Made, where: re.Pattern[str]) -> bool:
        """Whether the main part's own first words begin it ``where``."""
        part = next(p for p in self.built.pattern.parts if p.name == main.name)
        first = part.lines[0].span.start if part.lines else part.span.end
        return where.search(self.text[part.span.start : max(first, part.span.start) + 60]) is not None

    def _shapes(self, main: Made) -> str | None:
        """Which end of one piece is up where its text shapes the head behind the body, or the body, or a tail, behind the head."""
        part = next(p for p in self.built.pattern.parts if p.name == main.name)
        after = (p.span.start for p in self.built.pattern.parts if p.span.start > part.span.start)
        said = self.text[part.span.start : min(after, default=len(self.text))]
        found = [m for m in _SHAPED.finditer(said) if said[: m.start()].strip()]
        return {"head": "end", "body": "start", "tail": "side"}[found[0][1]] if found else None

    def _mouth_below(self, main: Made) -> bool | None:
        """Whether the mouth is in earlier rounds than the eyes, so that the first rounds are below; None where it is not said."""
        at: dict[bool, list[float]] = {True: [], False: []}
        for f in self.heard.features:
            if f.where.rounds and self._is_on(f, main) and f.what.split()[-1] in ("eyes", "mouth", "smile"):
                at[f.what.split()[-1] == "eyes"].append(0.5 * (f.where.rounds[0] + f.where.rounds[1]))
        eyes, mouth = at[True], at[False]
        return (
            None if not eyes or not mouth or np.mean(eyes) == np.mean(mouth) else bool(np.mean(mouth) < np.mean(eyes))
        )

    def _named_top(self, main: Made) -> bool:
        return [w for w in main.words if w in ("head", "body")][:2] == ["head", "body"]

    def _is_on(self, feature: Feature, main: Made) -> bool:
        head = self.of_kind("head")
        return head in (None, main) if feature.host is None else feature.host[0] == main
