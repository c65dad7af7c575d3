"""Plan: the pieces of a sweep, one after the other: each with a name for people and a key of all that it is made of."""

from __future__ import annotations

import hashlib
import json
import re
from collections import Counter
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from pathlib import Path
from typing import Any

from tambour import __version__, files
from tambour.core.errors import Problem, TambourError, unspeakable
from tambour.craft import Craft, plain_edit
from tambour.sweep.axes import Axes, combinations
from tambour.work.piece import Job
from tambour.work.thumbs import SIDE

LONGEST = 120
"""Bytes of a piece's name: room is left for suffixes on every disk."""
_FORMULA = re.compile(r"^[=+@-]")
_AWKWARD = re.compile(r"[^\w=+.~ ()-]")


@dataclass(frozen=True, slots=True)
class Plan:
    """What is to be made.

    sources : path, label; (None, the craft's name) for a craft that starts from nothing ; out : suffixes, with or
    without a view ; edits : checked, as data
    """

    craft: Craft
    sources: Sequence[tuple[str | None, str]]
    axes: Axes
    out: Sequence[str]
    edits: Sequence[Mapping[str, Any]]
    thumbs: int

    def pieces(self) -> Iterator[Piece]:
        """Every piece, source by source; a source is read when its first piece is asked for."""
        shelf: dict[str, bytes | TambourError] = {}
        for path, label in self.sources:
            raw = None if path is None else _read(path)
            for chosen in combinations(self.axes):
                yield self._piece(path, label, raw, chosen, shelf)

    def _piece(
        self,
        path: str | None,
        label: str,
        raw: bytes | TambourError | None,
        chosen: Mapping[str, Any],
        shelf: dict[str, bytes | TambourError],
    ) -> Piece:
        params = self.craft.params.of(dict(chosen))
        blobs: dict[str, bytes] = {}
        named: dict[str, str] = {}
        reason = str(raw) if isinstance(raw, TambourError) else ""
        if path is not None and isinstance(raw, bytes):
            blobs[path] = raw
        for name in params.files():
            given = getattr(params, name)
            if given is not None and str(given) not in params.words(name):
                if str(given) not in shelf:
                    shelf[str(given)] = _read(str(given))
                found = shelf[str(given)]
                if isinstance(found, TambourError):
                    reason = reason or str(found)
                else:
                    blobs[str(given)] = found
                    named[name] = str(given)
        plain = {**params.plain(), **{n: str(getattr(params, n)) for n in params.files() if getattr(params, n)}}
        name = _name(label, chosen, self.craft.views)
        job = Job(
            self.craft.name, plain, [name + kind for kind in self.out], path, named, self.edits, self.thumbs, blobs
        )
        return Piece(key(job), name, dict(chosen), job, reason)


@dataclass(frozen=True, slots=True)
class Piece:
    """A piece to make: its key, its name, what was chosen for it; or why it cannot be (``reason``)."""

    key: str
    name: str
    chosen: Mapping[str, Any]
    job: Job
    reason: str = ""


def key(job: Job) -> str:
    """What the piece is made of, as one hash: craft, version, params, the bytes and last names of its files, edits.

    Which files are written of it is no part of it: any number can be.
    """

    def content(name: str) -> list[str]:
        return [Path(name).name, hashlib.sha256(job.blobs.get(name, b"")).hexdigest()]

    made_of = [
        job.craft,
        __version__,
        {name: content(str(v)) if name in job.files else v for name, v in job.params.items()},
        None if job.source is None else content(job.source),
        job.edits,
        job.how,
    ]
    return hashlib.sha256(json.dumps(made_of, sort_keys=True, ensure_ascii=False).encode()).hexdigest()


def plan(
    craft: Craft, given: Sequence[str], found: Axes, out: Sequence[str], edits: Sequence[Any], thumbs: int = SIDE
) -> tuple[Plan, list[Problem]]:
    """The plan of a sweep, and warnings: what is left out. TambourError with all that cannot be."""
    problems: list[Problem] = []
    doubts: list[Problem] = []
    checked = [plain_edit(kind, edit) for kind, edit in craft.edits(edits)]
    paths = _paths(craft, given, problems, doubts)
    for kind in out:
        if not kind.startswith(".") or "/" in kind:
            told = "name a kind of file, not a file: a sweep names its pieces itself"
            problems.append(Problem(told, f"such as -o {Path(kind).suffix or '.png'}", where=f"-o {kind}"))
    if problems:
        raise TambourError(problems)
    made = Plan(craft, _labelled(paths) or [(None, craft.name)], found, tuple(dict.fromkeys(out)), checked, thumbs)
    return made, doubts


def _paths(craft: Craft, given: Sequence[str], problems: list[Problem], doubts: list[Problem]) -> list[str]:
    """The sources: files, and of folders all that the craft can read."""
    if given and not craft.reads:
        problems.append(Problem(f"{craft.name} takes no source", where=str(given[0])))
        return []
    if not given and craft.reads and not craft.optional_source:
        problems.append(Problem(f"{craft.name} needs sources", f"tambour sweep {craft.name} SOURCES… -o .png"))
    readable = {s for s, kinds in files.READ.items() if set(kinds) & set(craft.reads)}
    found: dict[str, None] = {}
    for word in given:
        if why := unspeakable(word):
            problems.append(Problem(f"the name of a source {why}", where=word[:80]))
        elif Path(word).is_dir():
            inside = sorted(p for p in Path(word).iterdir() if p.is_file() and not p.name.startswith("."))
            odd = [p for p in inside if unspeakable(p.name)]
            fit = [p for p in inside if p.suffix.lower() in readable and p not in odd]
            left = len(inside) - len(fit)
            if not fit:
                can = f"these can be read: {' '.join(sorted(readable))}"
                problems.append(Problem(f"nothing in this folder is a source of {craft.name}", can, where=word))
            elif left:
                told = f"{left} of {len(inside)} files are left out"
                told += f", {len(odd)} for their names: one {unspeakable(odd[0].name)}" if odd else ""
                doubts.append(Problem(told, where=word, warning=True))
            found.update(dict.fromkeys(map(str, fit)))
        elif not Path(word).exists():
            problems.append(Problem("there is no such file", where=word))
        elif Path(word).suffix.lower() not in readable:
            can = f"these can: {' '.join(sorted(readable))}"
            problems.append(Problem(f'"{Path(word).suffix or word}" files cannot be read here', can, where=word))
        else:
            # A table must not take the name for a formula.
            plain = f"./{word}" if word[0] in "=+-@" else word
            if plain in found:
                doubts.append(Problem("is named twice, and made once", where=word, warning=True))
            found[plain] = None
    return list(found)


def _labelled(paths: Sequence[str]) -> list[tuple[str | None, str]]:
    """Each path with what its pieces' names begin with: its stem, and more where two are alike."""
    stems = Counter(_label(Path(p).stem).casefold() for p in paths)
    names = Counter(_label(Path(p).name.replace(".", "-")).casefold() for p in paths)
    made: list[tuple[str | None, str]] = []
    for path in paths:
        stem, name = _label(Path(path).stem), _label(Path(path).name.replace(".", "-"))
        if stems[stem.casefold()] > 1:
            stem = name if names[name.casefold()] == 1 else f"{name}~{hashlib.sha256(path.encode()).hexdigest()[:6]}"
        made.append((path, stem))
    return made


def _label(text: str) -> str:
    """A text as the beginning of a file's name, which no table takes for a formula, and no command for an option."""
    return _plain(text, _FORMULA.sub("_", text))


def _plain(text: str, made: str = "") -> str:
    """A text as a part of a file's name: what had to be changed keeps a name of its own by six letters of its hash."""
    made = _AWKWARD.sub("_", made or text).strip(" .") or "_"
    short = made.encode()[:LONGEST].decode(errors="ignore")
    return short if short == text else f"{short[: LONGEST - 30]}~{hashlib.sha256(text.encode()).hexdigest()[:6]}"


def _name(label: str, chosen: Mapping[str, Any], views: Mapping[str, Any]) -> str:
    parts = [label, *(f"{n.rstrip('_')}={_plain(_word(v))}" for n, v in chosen.items())]
    name = "-".join(parts)
    if len(name.encode()) > LONGEST:
        short = name.encode()[: LONGEST - 10].decode(errors="ignore")
        name = f"{short}~{hashlib.sha256(name.encode()).hexdigest()[:8]}"
    return f"{name}_" if Path(name).suffix[1:] in views else name  # else ".back.png" would be a view of it


def _word(value: Any) -> str:
    return value if isinstance(value, str) else json.dumps(value) if isinstance(value, (list, dict)) else str(value)


def _read(path: str) -> bytes | TambourError:
    """A file's bytes, or why they are not to be had."""
    try:
        return Path(path).read_bytes()
    except OSError as error:
        return TambourError(f"cannot be read: {error.strerror or error}", where=path)
