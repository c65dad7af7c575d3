"""Printed patterns, the yarn's colours: names as people write them, and letters that a pattern gives them."""

from __future__ import annotations

import re
from collections.abc import Mapping
from typing import Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB, css_colors, unhexed
from tambour.crochet.language.tree import Action, Line
from tambour.crochet.printed.cursor import Cursor
from tambour.crochet.printed.rounds.items import works
from tambour.crochet.printed.yarns.shades import dyed, listed, said, shade
from tambour.crochet.printed.yarns.shelf import shelf
from tambour.crochet.printed.yarns.yarnlists import YarnList, enter

_HEADING: Final = 400
"""Letters of a part's heading that may name its yarn."""
# Letters without a meaning of their own get these, one after the other.
LETTERS: Final = ("mc", "cc", "a", "b", "c", "d", "e", "f", "g", "h", "i", "j", "k", "ca", "cb", "cd", "ce", "c1", "c2")
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


class Palette:
    """The colours of a pattern. ``given``: letters and names of its own; ``told``: those without a colour that were used;
    ``known``: words for suggestions; ``foreign``: what the language of the text calls colours; ``pure``: names mean what they do in tambour's own language, which printed the text."""

    def __init__(self, known: list[str], pure: bool = False, foreign: Mapping[str, RGB] | None = None) -> None:
        self.known, self.pure, self.foreign = known, pure, foreign or {}
        self.given: dict[str, RGB] = {}
        self.told: list[str] = []
        self.named: dict[str, str] = {}  # what the yarns of the letters are called
        self.yarns: dict[
            str, tuple[RGB, str, Span]
        ] = {}  # what the list of materials calls its yarns, as it is written there
        self.owned: set[str] = set()  # the words of lists of yarn, some of which are colours there and things elsewhere
        self.lists: list[YarnList] = []  # of several toys, each with its letters
        self.worn = self.toy = 0  # the list whose yarns the letters name, and that of the toy under way
        self.wore: set[int] = set()  # those that headings turned to
        self.meant: dict[str, str] = {}  # colours that mean the one yarn of the list whose name they are part of

    def name(self, words: str) -> RGB | None:
        """The colour of a name, None when it is none."""
        if self.pure:
            return self.given.get(words) or css_colors().get(words.replace(" ", "")) or said(words)
        owned = shade(words) if words.split()[-1:] and words.split()[-1] in self.owned else None
        return self.given.get(words) or self.foreign.get(words) or self.on_shelf(words) or said(words) or owned

    def _only(self, word: str) -> RGB | None:
        """The yarn of a list that has one for all its letters: "1 ball 9872 Llama"."""
        return self.given.get("") if word in ("a", "mc") else None

    def on_shelf(self, words: str) -> RGB | None:
        """The colour of the yarn that the list calls so, or of the only one whose name has these words: "grey" where "Light Grey" is."""
        words = words.replace("gray", "grey")
        if words in self.yarns:
            return self.yarns[words][0]
        if not self.yarns or said(words) is None:
            return None
        fits = {
            hue: name for hue, name, _ in self.yarns.values() if words in name.lower().replace("gray", "grey").split()
        }
        if len(fits) != 1:
            return None
        ((hue, name),) = fits.items()
        if shade(words) != hue:  # "sage" is no other colour than "Sage Green"
            self.meant.setdefault(words, name)
        return hue

    def listed(self, line: str, begin: int = 0) -> None:
        """Takes the yarns that a line of the materials names, ``begin`` its place in the text, and the letters that it gives them."""
        self.owned.update(w.lower() for w in _SAID.findall(line) if len(w) > 2 and w.lower() != "aran")
        for name, also, at in shelf(line):
            hue = dyed(name)
            span = Span(begin + at, begin + at + len(name))
            for called in (name, also) if hue is not None else ():
                if called and hue is not None:
                    self.yarns.setdefault(called.lower().replace("gray", "grey"), (hue, name, span))
        letters: dict[str, str] = {letter: name for letter, name in listed(line).items() if not letter}
        for row in re.finditer(r"[^\n]+", line):  # a list of letters is one line each
            own = {letter: (name, dyed(name)) for letter, name in listed(row[0]).items() if letter}
            enter(self.lists, row[0], begin + row.start(), own)
            letters |= {letter: name for letter, (name, _) in own.items() if letter not in letters}
        if not letters.keys() - {""}:
            letters |= listed(line)
        for letter, name in letters.items():
            self.named.setdefault(letter, name)
            first = not self.lists or self.lists[0].named.get(letter, name) == name
            if (hue := dyed(name)) is not None and (first or not letter):
                self.given.setdefault(letter, hue)

    def wear(self, k: int) -> None:
        """Gives the letters the yarns of list ``k``."""
        if k != self.worn:
            self.wore.add(k)
            self.worn = k
            own = self.lists[k].named
            self.given = {w: hue for w, hue in self.given.items() if w not in own}
            self.given |= {w: hue for w, hue in self.lists[0].given.items() if w not in own} | self.lists[k].given

    @property
    def letters(self) -> dict[str, RGB]:
        """The letters that the text gives its yarns, those without a colour of their own as they are shown."""
        chosen = {w: self._only(w) or _SHADES[_index(w) % len(_SHADES)] for w in self.told if _lettered(w)}
        return {word.upper(): hue for word, hue in (chosen | self.given).items() if _lettered(word)}

    @property
    def main(self) -> RGB | None:
        """The yarn of what says none: the main one, the first, or the only one; None where no yarn is named."""
        hue = next((self.given[k] for k in ("mc", "a", "") if k in self.given), None)
        only = {rgb for rgb, _, _ in self.yarns.values()}
        return hue if hue is not None or len(only) != 1 else only.pop()

    def first(self, words: str) -> RGB | None:
        """The first yarn that a heading asks for: "Make 1 with B and 1 with C", "Head (cream)", "Ears (blue yarn, make 2)",
        "Fins, make 2, in blue", "HEAD – Caramel, 3.5 mm hook"."""
        asked = ((m[1] or m[2]).lower() for m in _WITH.finditer(words))
        lettered = next((hue for word in asked if (hue := self._said(word)) is not None), None)
        found = sorted(
            (m for said in (_BESIDE, _OF_YARN, _YARNED, _DASHED) for m in said.finditer(words)), key=lambda m: m.start()
        )
        named = (self.name(" ".join(m[1].lower().split())) for m in found)
        return lettered or next((hue for hue in named if hue is not None), None) or self._aside(words)

    def _said(self, word: str) -> RGB | None:
        """The yarn of a letter that a heading asks for; in a text that gives its letters no colours, the one it is shown in."""
        if word in self.given or not any(map(_lettered, self.told)):
            return self.given.get(word)
        self.told.append(word)
        return self._only(word) or _SHADES[_index(word) % len(_SHADES)]

    def _aside(self, words: str) -> RGB | None:
        """The first yarn that stands behind a heading's name, however it is said: "Wings (W)", "Pads x4, yellow", "OREILLES (x2, commencer en
        brun)"."""
        line = words.strip().split("\n")[0]
        begin = _PARTING.search(line)
        if begin is None or len(line) > _HEADED:
            return None
        for aside in _ASIDES.finditer(line, begin.start()):
            said = [w.lower() for w in _SAID.findall(aside[0])]
            if said and len(said[0]) == 1 and aside[0].strip()[:1].isupper():
                return self.given.get(said[0])
            if any(w in _OTHERS for w in said):
                continue
            for at in range(len(said)):
                for length in (3, 2, 1):
                    hue = self.name(" ".join(said[at : at + length])) if at + length <= len(said) else None
                    if hue is not None:
                        return hue
        return None

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
                return unhexed(wide), count
        end = at  # behind the words that a name may be of
        while end < min(at + 3, len(tokens)) and (tokens[end].kind == "word" or tokens[end].word in ("-", "light")):
            end += 1
        for length in range(end - at, 0, -1):
            words = [t.word for t in tokens[at : at + length] if t.word != "-"]
            shade = self.name(" ".join(words)) if words else None
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
            return (self.given[word], 1) if len(word) == 1 and word in self.given else None
        if word not in self.given:
            self.told.append(word)
        index = _index(word)
        return self.given.get(word) or self._only(word) or _SHADES[index % len(_SHADES)], length


def _lettered(word: str) -> bool:
    return word in LETTERS or (word.isdigit() and len(word) == 1)


def _index(word: str) -> int:
    return LETTERS.index(word) if word in LETTERS else int(word)


def spare(k: int) -> RGB:
    """The colour of our choice for the ``k``-th yarn that tells none."""
    return _SHADES[k % len(_SHADES)]


_PARTING: Final = re.compile(
    r"[(\[,:|/]|[x×]\s?\d|\d\s?[x×]|\s[-–—]\s|[–—]|(?<=[A-Z]{2})\s+(?=[a-z])|(?<=\w)\s+(?=[\u2600-\u27bf\U0001f300-\U0001faff])"
)
_ASIDES: Final = re.compile(r"[^()\[\],;:|/–—]+")
_SAID: Final = re.compile(r"[^\W\d_]+")
_HEADED: Final = 80  # letters of a line that may be a heading
_OTHERS: Final = frozenset(("eyes", "eye", "hook", "nose", "see", "page", "photo", "picture", "sts", "stitches", "rnds", "rounds", "like", "patch"))  # fmt: skip
"""What is named beside a colour that is no yarn of the whole piece."""
_WITH: Final = re.compile(
    r"\b(?:[Ww]ith|[Ii]n|[Uu]sing|[Jj]oin(?:ing)?)\s+(?:[Cc]olou?r\s+([1-9])\b|(?:[Cc]olou?r\s+)?(MC|C[A-E]|[A-K])\b)"
)
_BESIDE: Final = re.compile(
    r"(?:[(\[]|\bColou?r:)[ \t]*([A-Za-z]{3,}(?:[ -](?!yarn\b)[a-z]+)?)(?=[ \t]*(?:yarn\b[ \t]*)?(?:[),;\]\n]|$))"
)
_OF_YARN: Final = re.compile(
    r"(?:\bwith|,[ \t]*in|\d[ \t]*,?[ \t]*in|\b[Mm]ake[ \t]+\w+[ \t]*,)[ \t]+([A-Za-z]{3,}(?:[ -](?:blue|green|brown|pink|gr[ae]y|red))?)\b"
)
_DASHED: Final = re.compile(
    r"[ \t][–—-][ \t]*([A-Za-z]{3,}(?:[ -](?!yarn\b)[a-z]+)?)(?=[ \t]*(?:(?:yarn|[Cc]olou?r)\b[ \t]*)?(?:[,;\n]|$))"
)
_YARNED: Final = re.compile(r"^([A-Za-z]{3,}(?: [a-z]+)?)[ \t]+[Yy]arn\b")
_NUMBERED: Final = re.compile(r"(?:^|[,:;]|\b(?:and|using|with))\s*([A-Z][A-Za-z ]{0,30}?)\s+as\s+Colou?r\s+(\d)\b")

_IS: Final = re.compile(
    r"(?:^|[.,;:]\s*)(?:[Tt]he )?([A-Z]?[a-z]+(?: [a-z]+){0,2}?)(?: fur| yarn| wool)? is [Cc]olou?r (\d)\b"
)
"""The same in sentences: "Dark gray is Color 1. Pink is Color 2."."""
_AS: Final = re.compile(r"[a-z]\s+as\s+(?:MC|C[A-E]|[A-K])\b")


def numbered(palette: Palette, line: str) -> bool:
    """Takes "Purple as Color 1, Blue as Color 2", or "White as A", of several versions of a toy the first; whether a line
    says such."""
    found = _NUMBERED.findall(line) or (_IS.findall(line) if " is " in line else [])
    for name, number in found:
        hue = palette.given.get(name.lower()) if len(name) <= 2 else dyed(name)
        palette.named.setdefault(number, name)
        if hue is not None:
            palette.given.setdefault(number, hue)
    lettered = listed(line) if _AS.search(line) else {}
    for letter, name in lettered.items():
        if (hue := dyed(name)) is not None:
            palette.given.setdefault(letter, hue)
    return bool(found or lettered)


_HELD_ON: Final = re.compile(r"\bdo not (?:fasten off|cut|break|finish off)\b[^.;\n]*[.;]?[\s*_#]*$", re.IGNORECASE)


def dyeing(lines: list[Line], heading: Span, palette: Palette, text: str, before: list[Line]) -> list[Line]:
    """The line that gives rounds which name no yarn that of their heading, else the one of the part ``before`` whose yarn is not cut above it,
    else the pattern's main one; none where one is named."""
    first = next((i for n in lines for i in n.items if works(i) or (isinstance(i, Action) and i.name == "color")), None)
    if isinstance(first, Action) and first.name == "color":
        return []
    begin = lines[0].span.start if lines else heading.end
    hue = palette.first(text[heading.start : max(begin, heading.end)][:_HEADING])
    if hue is None and _HELD_ON.search(text, max(0, heading.start - _HEADING), heading.start):
        last = next(
            (i for n in reversed(before) for i in reversed(n.items) if isinstance(i, Action) and i.name == "color"),
            None,
        )
        hue = None if last is None else (last.numbers[0], last.numbers[1], last.numbers[2])
    hue = hue or palette.main
    return [] if hue is None else [Line((Action("color", heading, numbers=hue),), heading, False)]


def yarns_named(text: str) -> dict[RGB, str]:
    """What a pattern's list of materials calls its yarns, by their colours: ``{(236, 224, 200): "Ecru"}``, with the letter
    that it gives them, ``"Adobe (A)"``."""
    found: dict[RGB, str] = {}
    for line in text.splitlines():
        for letter, name in listed(line).items():
            hue = dyed(name)
            if hue is None and letter:
                hue = _SHADES[(LETTERS.index(letter) if letter in LETTERS else 0) % len(_SHADES)]
            if hue is not None:
                found.setdefault(hue, f"{name} ({letter.upper()})" if letter else name)
    return found
