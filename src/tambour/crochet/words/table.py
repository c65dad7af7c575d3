"""Table: the words of printed patterns, a file per language; the reader, the writer and the booklet share them."""

from __future__ import annotations

import string
from collections.abc import Iterator, Mapping
from dataclasses import dataclass, field
from pathlib import Path
from typing import Any, Final

from tambour.core.errors import Problem, TambourError
from tambour.crochet.words.numbers import NUMBERS
from tambour.crochet.words.spellings import meanings, stitches

FOLDER: Final = Path(__file__).parent

WHOLE: Final = "us"
"""The language whose file holds every key: what it has, every other has, or takes it from its base."""

SENTENCES: Final = {
    "terms": "",  # what the words are called in themselves
    # Within a round, between commas; on lines of their own they begin with a capital and end with a point.
    "ring": "count",
    "color": "color",
    "use color": "color",  # the one that a part begins with
    "both loops": "",
    "front loops": "",
    "back loops": "",
    "mark": "label",
    "goto": "label",
    "attach chain": "label count",
    "attach over": "label",
    "attach merge": "label",
    "turn": "",
    "join": "",
    "close": "",  # FO: draws the remaining stitches together
    "fasten off": "",  # only ends the yarn
    "sew": "one other",
    "oval": "count next",  # a chain, worked around both its sides from so many-th from the hook
    "foundation": "count",  # single crochets that make their own chain
    "fold": "",  # through both layers of the edge, folded
    "fold to": "label",
    "to space": "",  # a round begins in the next chain space, or in the middle of it
    "to space half": "",
    "edge all": "count",  # along the edge of what was worked, as so many stitches
    "edge side": "count",  # … down the ends of the rows
    "edge base": "count",  # … the other side of the chain that it began with
    "edge far": "count",  # … up the other ends of the rows
    "edge sides": "count",  # … both sides, up to the top and down again
    "again": "first last part",  # rounds that are written elsewhere
    "gap": "count",  # a round that nobody could read, and how many stitches it has
    # Stitches worked into one place.
    "one stitch": "items",
    "one space": "items",
    "one ring": "items",
    "one curl": "items",
    # Of a part.
    "stuff none": "",
    "stuff light": "",
    "stuff medium": "",
    "stuff firm": "",
    "stuff factor": "factor",
    "up start": "",
    "up end": "",
    "up side": "",
    "up back": "",
    "stands": "spot far",  # what is on top, and what in front
    # Finishing.
    "place": "part onto spot flat across tilt towards by through",
    "place said": "part onto where spot flat lean way about",  # the same as a person says it
    "eye": "part spot size color",
    "tie": "part spot far apart",
    "embroider": "part spots color width",
    "felt": "part spot shape width height turn color",
    "hair": "part spots count length color",
    # Pieces of sentences.
    "at round": "round stitch front",
    "at between": "round next stitch front",
    "shade": "letter",  # a colour by its letter in the list of materials
    "legend": "letter name hex",
    # How stitches are counted and repeated.
    "several": "count item",
    "group": "items count",
    "copies": "count",
}
"""What a table has sentences for → the fields each must have."""


@dataclass(frozen=True, slots=True)
class Heard:
    """What people write besides the words that a table prints.

    words : concept → spellings; stitches : standard name → spellings
    kinds : the same, of stitches whose ``increases`` and ``decreases`` the reader makes by itself
    said : what sentences are known by that tell no stitches → its words, which are no words of rounds
    colors : the English name of a colour of yarn → spellings
    gloss : words of the assembly in English → spellings, "#" a number (:mod:`tambour.crochet.words.gloss`)
    parts : English nouns of parts and faces → spellings
    fillers : words that carry no meaning; ordinals, numbers : first, second, …; one, two, …
    labels : words that number parts of a pattern, "Part 3: Pot"; steps : such that number other things too, "Step 3: Sew the ears"
    items : the same of headings alone, "Chapter 2: Body"; leads, trails : what stands before the name there, and behind it, and says nothing
    using, towards : words before the yarn of a part and before the part: "use brown for the head"
    copied : words that say how many of a part are made, beside the number; pairs : those that say two; sides : left and right, by turns
    counting : every word of a number, of ``numbers`` and of the gloss → that number
    others, made, again : words that have a part made again: "another"; "crochet", which need not name it; and what stands with them
    """

    words: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    stitches: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    kinds: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    said: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    colors: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    gloss: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    parts: Mapping[str, tuple[str, ...]] = field(default_factory=dict)
    increases: tuple[str, ...] = ()
    decreases: tuple[str, ...] = ()
    fillers: tuple[str, ...] = ()
    labels: tuple[str, ...] = ()
    steps: tuple[str, ...] = ()
    items: tuple[str, ...] = ()
    leads: tuple[str, ...] = ()
    trails: tuple[str, ...] = ()
    using: tuple[str, ...] = ()
    towards: tuple[str, ...] = ()
    copied: tuple[str, ...] = ()
    pairs: tuple[str, ...] = ()
    sides: tuple[str, ...] = ()
    others: tuple[str, ...] = ()
    made: tuple[str, ...] = ()
    again: tuple[str, ...] = ()
    ordinals: tuple[str, ...] = ()
    numbers: tuple[str, ...] = ()
    counting: Mapping[str, int] = field(init=False, repr=False, compare=False)

    def __post_init__(self) -> None:
        glossed = [(n, word) for english, n in NUMBERS.items() for word in self.gloss.get(english, ())]
        counting = {word: n for n, word in reversed([*enumerate(self.numbers, 1), *glossed])}
        object.__setattr__(self, "counting", counting)


@dataclass(frozen=True, slots=True)
class Terms:
    """The words of one language of printed patterns. Case never tells two words apart.

    code, name : "us", "US terms"
    stitches : standard name (:mod:`tambour.crochet.language.stitches`) → its spellings; the writer prints the first
    meaning : the same, and some words → what it means in full, for the list of abbreviations
    words : every other word → its spellings; the writer prints the first
    sentences : :data:`SENTENCES` → a template (:mod:`tambour.crochet.words.phrases`), which fills and reads alike
    colors : CSS name of a colour → its spellings
    base : the code of the language that it is a kind of, else its own
    page : what the booklet says besides; yarns : a class of yarn → its name, where it has its own
    inches : its readers also want inches and yards; called : what texts call it ("american")
    """

    code: str
    name: str
    stitches: Mapping[str, tuple[str, ...]]
    meaning: Mapping[str, str]
    words: Mapping[str, tuple[str, ...]]
    sentences: Mapping[str, str]
    colors: Mapping[str, tuple[str, ...]]
    base: str = ""
    page: Mapping[str, str] = field(default_factory=dict)
    yarns: Mapping[str, str] = field(default_factory=dict)
    heard: Heard = field(default_factory=Heard)
    inches: bool = False
    called: tuple[str, ...] = ()

    def word(self, key: str) -> str:
        """The spelling of a stitch or word that the writer prints."""
        return (self.stitches.get(key) or self.words[key])[0]

    def prints(self, text: str) -> bool:
        """Whether a text was printed by tambour in this language, so that its words mean what they do in tambour's own."""
        return f"## {self._listed}" in text

    def sets(self, text: str) -> bool:
        """Whether tambour set a text in this language, with or without the marks of Markdown, of words that may be its designer's."""
        return f"\n{self._listed}\n" in text or self.prints(text)

    @property
    def _listed(self) -> str:
        return f"{self.word('abbreviations')} ({self.sentences['terms']})"


class Tables(Mapping[str, Terms]):
    """Code → Terms, of the files of a folder; each is read when it is first asked for."""

    def __init__(self, folder: Path = FOLDER) -> None:
        self._files = {path.stem: path for path in sorted(folder.glob("*.toml"))}
        self._read: dict[str, Terms] = {}
        self._whole: dict[str, dict[str, Any]] = {}

    def __iter__(self) -> Iterator[str]:
        return iter(self._files)

    def __len__(self) -> int:
        return len(self._files)

    def __getitem__(self, code: str) -> Terms:
        if code not in self._read:
            file = self._file(code)
            if wrong := self._lacks(code, file):
                raise TambourError([Problem(w, where=str(self._files[code])) for w in wrong])
            self._read[code] = _terms(code, file)
        return self._read[code]

    def _file(self, code: str) -> dict[str, Any]:
        """A language's file, filled up from its base."""
        import tomllib

        if code in self._whole:
            return self._whole[code]
        path = self._files[code]
        try:
            own = tomllib.loads(path.read_text(encoding="utf-8"))
        except ValueError as error:
            raise TambourError(f"this is no TOML: {error}", where=str(path)) from None
        base = own.get("base", "")
        self._whole[code] = _filled(self._file(base), own) if base else own
        return self._whole[code]

    def _lacks(self, code: str, file: dict[str, Any]) -> list[str]:
        """What a file does not say, and sentences whose fields are not those they must have."""
        if code == WHOLE:
            return []
        whole = self._file(WHOLE)
        wrong = [f'"{key}" is missing' for key in ("name", "standing") if key not in file]
        for table in ("kinds", "posts", "bumps", "stitches", "explained", "words", "sentences", "colors", "page"):
            said = file.get(table, {})
            wrong += [f'[{table}] "{key}" is missing' for key in whole[table] if not said.get(key)]
        for table in ("increase", "decrease"):
            wrong += [f'[{table}] "{k}" is missing' for k in ("2", "more") if not file.get(table, {}).get(k)]
        for key, fields in SENTENCES.items():
            said = file.get("sentences", {}).get(key)
            if said and sorted(_fields(said)) != sorted(fields.split()):
                wrong.append(f'[sentences] "{key}" wants the fields {fields or "none"}')
        for key, template in whole["page"].items():
            if not set(_fields(file.get("page", {}).get(key, ""))) <= set(_fields(template)):
                wrong.append(f'[page] "{key}" has no fields but {", ".join(_fields(template)) or "none"}')
        return wrong


def _fields(template: str) -> list[str]:
    return [name for _, name, _, _ in string.Formatter().parse(template) if name]


def _filled(base: dict[str, Any], own: dict[str, Any]) -> dict[str, Any]:
    """``own`` over ``base``, table by table and key by key."""
    made = dict(base)
    for key, said in own.items():
        made[key] = _filled(base.get(key, {}), said) if isinstance(said, dict) else said
    return made


def _terms(code: str, file: dict[str, Any]) -> Terms:
    def spelt(said: Mapping[str, list[str]]) -> dict[str, tuple[str, ...]]:
        return {key: tuple(spellings) for key, spellings in said.items()}

    heard: dict[str, Any] = {
        key: spelt(v) if isinstance(v, dict) else tuple(v) for key, v in file.get("heard", {}).items()
    }
    return Terms(
        code,
        file["name"],
        stitches(file),
        meanings({"meaning": {}, **file}),
        spelt(file["words"]),
        file["sentences"],
        spelt(file["colors"]),
        file.get("base", code),
        file["page"],
        file.get("yarns", {}),
        Heard(**heard),
        file.get("inches", False),
        tuple(file.get("called", ())),
    )


TERMS: Final = Tables()
"""Code → table."""
