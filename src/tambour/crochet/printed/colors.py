"""Printed patterns, the yarn's colours: names as people write them, and letters that a pattern gives them."""

from __future__ import annotations

from functools import lru_cache
from typing import Final

from tambour.crochet.language.finishes import RGB
from tambour.crochet.printed.cursor import Cursor

_MORE: Final[dict[str, RGB]] = {
    "cream": (245, 235, 210),
    "ecru": (236, 224, 200),
    "off white": (246, 240, 228),
    "offwhite": (246, 240, 228),
    "natural": (236, 224, 200),
    "mustard": (208, 160, 48),
    "peach": (250, 205, 170),
    "apricot": (246, 190, 140),
    "rust": (176, 82, 42),
    "burgundy": (116, 28, 48),
    "wine": (116, 28, 48),
    "rose": (226, 136, 150),
    "mint": (168, 220, 190),
    "sage": (156, 175, 136),
    "lilac": (196, 166, 206),
    "charcoal": (62, 62, 66),
    "camel": (186, 144, 96),
    "caramel": (186, 122, 62),
    "denim": (74, 104, 146),
    "petrol": (20, 92, 104),
    "skin": (240, 206, 176),
    "flesh": (240, 206, 176),
    "light brown": (176, 134, 92),
    "dark brown": (84, 54, 32),
    "medium brown": (128, 84, 48),
    "light grey": (211, 211, 211),
    "light gray": (211, 211, 211),
    "baby pink": (250, 204, 214),
    "baby blue": (176, 210, 236),
    "pale pink": (250, 218, 221),
    "dusty pink": (206, 152, 156),
    "bright pink": (240, 80, 150),
    "bright red": (222, 30, 38),
    "dark red": (139, 0, 0),
    "light yellow": (255, 250, 190),
    "pale yellow": (252, 244, 180),
    "light orange": (250, 186, 110),
    "light purple": (190, 160, 216),
    "dark purple": (76, 34, 100),
    "dark pink": (200, 70, 120),
    "black": (0, 0, 0),
}
# Letters without a meaning of their own get these, one after the other.
LETTERS: Final = ("mc", "cc", "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k")
_SHADES: Final[tuple[RGB, ...]] = (
    (176, 134, 92),
    (245, 235, 210),
    (120, 160, 180),
    (208, 120, 110),
    (150, 175, 120),
    (220, 180, 80),
    (160, 130, 180),
    (90, 90, 100),
    (240, 206, 176),
)


@lru_cache(maxsize=1)
def _css() -> dict[str, RGB]:
    from PIL import ImageColor

    return {name: ImageColor.getrgb(name)[:3] for name in ImageColor.colormap}


class Palette:
    """The colours of a pattern. ``given``: letters and names of its own; ``told``: those without a colour that were used;
    ``known``: words for suggestions."""

    def __init__(self, known: list[str]) -> None:
        self.known = known
        self.given: dict[str, RGB] = {}
        self.told: list[str] = []
        self._css = _css()

    def name(self, words: str) -> RGB | None:
        """The colour of a name, None when it is none."""
        return self.given.get(words) or _MORE.get(words) or self._css.get(words.replace(" ", ""))

    def color(self, c: Cursor, at: int | None = None) -> tuple[RGB, int] | None:
        """The colour that stands at token ``at`` (else at the cursor), and how many tokens it takes."""
        at = c.at if at is None else at
        tokens = c.tokens
        if at < len(tokens) and tokens[at].word == "#" and at + 1 < len(tokens):
            digits = "".join(t.word for t in tokens[at + 1 : at + 4] if t is tokens[at + 1] or t.glued)[:6]
            count, length = 1, 0
            while length < len(digits) and at + count < len(tokens):
                length += len(tokens[at + count].word)
                count += 1
            if length == len(digits) in (3, 6) and all(d in "0123456789abcdef" for d in digits):
                wide = digits if length == 6 else "".join(d + d for d in digits)
                return (int(wide[:2], 16), int(wide[2:4], 16), int(wide[4:], 16)), count
        for length in (3, 2, 1):
            if at + length > len(tokens):
                continue
            words = [t.word for t in tokens[at : at + length] if t.word != "-"]
            if not words or any(t.kind not in ("word",) and t.word != "-" for t in tokens[at : at + length]):
                continue
            shade = self.name(" ".join(words))
            if shade is not None:
                return shade, length
        return None

    def letter(self, c: Cursor, at: int) -> tuple[RGB, int] | None:
        """The same for a letter, which means a colour only after words that ask for one ("change to B")."""
        word = c.tokens[at].word if at < len(c.tokens) else ""
        length = 1
        if word in ("color", "colour", "contrast", "yarn") and at + 1 < len(c.tokens):
            after = c.tokens[at + 1].word
            if after in LETTERS or (after.isdigit() and len(after) == 1):
                word, length = after, 2
        if word not in LETTERS and length == 1:
            return None
        if word not in self.given:
            self.told.append(word)
        index = LETTERS.index(word) if word in LETTERS else int(word)
        return self.given.get(word) or _SHADES[index % len(_SHADES)], length
