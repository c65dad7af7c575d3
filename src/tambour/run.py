"""Run: read → make → view → write, with a report. Every caller goes through it."""

from __future__ import annotations

import os
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, replace
from importlib import import_module
from itertools import groupby
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tambour import files
from tambour.core.digest import digest
from tambour.core.errors import Problem, TambourError, did_you_mean, option, unspeakable
from tambour.core.progress import Progress
from tambour.craft import Craft, Edit, View, plain_edit

if TYPE_CHECKING:
    from tambour.core.params import Params
    from tambour.files.sink import Writing

# Name → (where its CRAFT is, one line): the line stands here so that help need not load the crafts.
CRAFTS: dict[str, tuple[str, str]] = {
    "crochet": (
        "tambour.crochet:CRAFT",
        "an amigurumi pattern → the stuffed plush in 3-D, its size, yarn and mistakes",
    ),
    "knit": ("tambour.knit:CRAFT", "a picture → a stranded (Fair-Isle) chart that keeps its floats short"),
    "ink": ("tambour.ink:CRAFT", "a seed → an endless shan-shui hand scroll, as vectors"),
    "embroidery": ("tambour.embroidery:CRAFT", "a drawing → thread: for a machine, and lying on cloth that moves"),
}


def craft(name: str) -> Craft:
    """The craft called ``name``; TambourError when there is none.

    >>> craft("ink").reads
    ()
    """
    if name not in CRAFTS:
        raise TambourError(
            f'there is no craft "{name}"', hint=did_you_mean(name, CRAFTS) or f"known: {', '.join(CRAFTS)}"
        )
    module, attribute = CRAFTS[name][0].split(":")
    found: Craft = getattr(import_module(module), attribute)
    return found


@dataclass(frozen=True, slots=True)
class Output:
    """A file asked for: where, by which view, of which value type.

    >>> outputs(craft("ink"), ["hill.png"], "")[0].suffix
    '.png'
    """

    path: Path
    view: str
    suffix: str


def outputs(
    what: Craft, names: Sequence[str | Path], stem: str, prefer: Mapping[str, str] | None = None
) -> list[Output]:
    """The outputs that names such as ``toy.png``, ``toy.back.png``, ``.svg`` or ``folder/`` ask for.

    ``name.VIEW.suffix`` takes a view only when VIEW is one of the craft's; else ``prefer`` (suffix → view) comes
    before the views' own suffixes. All that is wrong is raised at once.

    >>> [(o.view, o.suffix) for o in outputs(craft("knit"), ["rose.chart.pdf", "rose.k"], "rose")]
    [('chart', '.pdf'), ('knitout', '.k')]
    """
    prefer = prefer or {}
    found: list[Output] = []
    problems: list[Problem] = []
    for name in names:
        path, text = Path(name), str(name)
        if why := unspeakable(text):
            problems.append(Problem(f"the name of an output {why}", where=text[:80]))
            continue
        if text.startswith(".") and "/" not in text and path.stem.startswith("."):
            path = Path((stem or what.name) + text)
        suffix = path.suffix.lower()
        asked = Path(path.stem).suffix[1:]
        if asked in what.views:
            view, rest = asked, what.views[asked]
            if not files.can_write(suffix, rest.value):
                can = sorted(s for s, kind in files.WRITE if kind == rest.value)
                problems.append(
                    Problem(f'the view "{asked}" has no "{suffix}" form', f"it can be {' '.join(can)}", where=text)
                )
                continue
        else:
            choice = [prefer[suffix]] if suffix in prefer else []
            choice += [v for v, it in what.views.items() if suffix in it.suffixes]
            if not choice:
                can = sorted({s for it in what.views.values() for s in it.suffixes})
                problems.append(
                    Problem(f'{what.name} makes no "{suffix}" files', f"it makes {' '.join(can)}", where=text)
                )
                continue
            view = choice[0]
        if os.path.exists(path.parent) and not os.path.isdir(path.parent):
            problems.append(Problem("what should be its folder is a file", where=text))
        elif not os.path.exists(path.parent):
            problems.append(Problem("its folder does not exist", f"make it first: mkdir -p {path.parent}", where=text))
        elif os.path.isdir(path):  # as os.path asks: a name that no disk can hold is simply no folder
            problems.append(Problem("this is a folder, name a file in it", where=text))
        if any(_same(path, o.path) for o in found):
            problems.append(Problem("asked for twice", "name each file once", where=text))
        found.append(Output(path, view, suffix))
    if problems:
        raise TambourError(problems)
    return found


def load_files(params: Params) -> Params:
    """Params with every field that names a file replaced by the value read from it.

    >>> given = craft("embroidery").params(cloth="wave")
    >>> load_files(given).cloth
    'wave'
    """
    loaded: dict[str, Any] = {}
    problems: list[Problem] = []
    for name, kind in params.files().items():
        given = getattr(params, name)
        if isinstance(given, (str, Path)) and str(given) not in params.words(name):
            try:
                loaded[name] = files.read(given, (kind,))
            except TambourError as error:
                words = params.words(name)
                near = did_you_mean(str(given), words) if words and not Path(given).suffix else ""
                hint = near or f"{', '.join(words)}, or a file"
                for p in error.problems:
                    told = replace(p, hint=hint) if words and not Path(given).suffix else p
                    problems.append(replace(told, where=f"{{{option(name)}}} {told.where}") if told.where else told)
    if problems:
        raise TambourError(problems)
    return params.model_copy(update=loaded) if loaded else params


@dataclass(frozen=True, slots=True)
class Made:
    """A piece, and all that a report says of its making; any number of files can be written of it.

    params : as given, fields that name files still naming them
    edits : what was changed by hand, as data
    source : path (where it was read from one) and sha256 of the source, or None
    stem : the name of files that are asked for by suffix alone
    progress : the stages' seconds and the warnings of the making

    >>> made = make("knit", "examples/knit/rose.png", craft("knit").params(stitches=24))
    >>> made.stem, sorted(made.source)
    ('rose', ['path', 'sha256'])
    """

    craft: Craft
    piece: Any
    params: Params
    edits: Sequence[Edit]
    source: Mapping[str, str] | None
    stem: str
    progress: Progress


def make(
    what: Craft | str,
    source: Any = None,
    params: Params | None = None,
    edits: Sequence[Edit | str] = (),
    progress: Progress | None = None,
) -> Made:
    """Make a piece of ``source``.

    what : a Craft or its name
    source : a path (read by its suffix), a value, or None
    params : the craft's Params (defaults when None); fields that name files are read here
    edits : what is changed by hand, in this order; see :meth:`tambour.craft.Craft.edits`

    Raises TambourError for input that cannot be used.

    >>> chart = make("knit", "examples/knit/rose.png", craft("knit").params(stitches=24)).piece.chart
    >>> chart.shape[1]
    24
    """
    what = craft(what) if isinstance(what, str) else what
    progress = progress or Progress()
    given = what.params() if params is None else params
    changed = what.edits(edits)
    for problem in given.idle():
        progress.warn(problem)
    if source is None and what.reads and not what.optional_source:
        raise TambourError(f"{what.name} needs a source", hint=f"tambour {what.name} SOURCE -o OUT; --help tells more")
    if source is not None and not what.reads:
        raise TambourError(f"{what.name} takes no source", where=str(source))
    if isinstance(source, (str, Path)) and (why := unspeakable(str(source))):
        raise TambourError(f"the name of the source {why}", where=str(source)[:80])
    origin: dict[str, str] = {}
    stem = _stem(what, source, given)
    with progress.stage("read"):
        if isinstance(source, (str, Path)):
            origin["path"] = str(source)
            source = files.read(source, what.reads)
        if source is not None:
            origin["sha256"] = digest(source)
        full = load_files(given)
        for value in (source, *(getattr(full, name) for name in given.files())):
            for doubt in getattr(value, "doubts", ()):
                progress.warn(doubt)
    for kind, values in _runs(changed):
        if (before := what.changes[kind].before) is not None:
            source, full = before(source, full, values)
    piece = what.make(source, full, progress)
    return edited(Made(what, piece, given, (), origin or None, stem, progress), edits, progress)


def edited(made: Made, edits: Sequence[Edit | str], progress: Progress | None = None) -> Made:
    """A piece with all of ``edits``: those of kinds that come before the making it was made with; the others are made on it.

    Raises TambourError for edits that cannot be made.

    >>> made = make("knit", "examples/knit/rose.png", craft("knit").params(stitches=24))
    >>> [int(edited(made, [f"stitch:1,1={yarn}"]).piece.chart.cells[0, -1]) for yarn in ("MC", "CC")]
    [1, 0]
    """
    what, progress = made.craft, progress or made.progress
    changed, piece = what.edits(edits), made.piece
    for kind, values in _runs(changed):
        if (after := what.changes[kind].after) is not None:
            piece = after(piece, values, progress)
    told = [plain_edit(kind, edit) for kind, edit in changed]
    return replace(made, piece=piece, edits=told, progress=progress)


def _runs(edits: Sequence[tuple[str, Params]]) -> Iterator[tuple[str, list[Params]]]:
    """Edits of one kind that follow each other, together."""
    for kind, group in groupby(edits, key=lambda edit: edit[0]):
        yield kind, [edit for _, edit in group]


def _stem(what: Craft, source: Any, params: Params) -> str:
    return what.stem(params) or (Path(source).stem if isinstance(source, (str, Path)) else "")


def write(
    made: Made,
    out: Sequence[str | Path] = (),
    report: str | Path | None = None,
    progress: Progress | None = None,
    into: Writing | None = None,
) -> dict[str, Any]:
    """Write files of a piece, and the report beside them; gives the report.

    out : file names, see :func:`outputs`
    report : where the report is written as JSON
    progress : for this writing (the making's own when None)
    into : where the files go, such as :class:`tambour.files.sink.Kept` (the disk when None)

    All files appear, or, on any error, none. Raises TambourError. The report holds craft, version, edition, params,
    source, edits, the craft's facts, warnings, files, how its kernels ran, and seconds per stage.

    >>> made = make("knit", "examples/knit/rose.png", craft("knit").params(stitches=24))
    >>> write(made, ["rose.csv"])["files"]
    ['rose.csv']
    """
    from tambour import __version__
    from tambour.core.kernels import ways
    from tambour.files.sink import Writing, refused
    from tambour.files.text import write_json

    what, progress = made.craft, progress or made.progress
    plan = outputs(what, out, made.stem, what.prefer(made.params))
    guard(plan, (made.source or {}).get("path"), report)
    what.check(made.params, [item.view for item in plan])
    cache: dict[str, Any] = {}
    with into or Writing() as writing:
        for k, item in enumerate(plan):
            view: View = what.views[item.view]
            if item.view not in cache:
                with progress.stage(view.stage):
                    cache[item.view] = view.make(made.piece)
            with progress.stage("write"):
                progress.step(k, len(plan))
                value = cache[item.view]
                if hasattr(value, "__next__"):
                    del cache[item.view]  # a stream can be written once
                files.leave(value, writing.sink(item.path), view.value)
        told: dict[str, Any] = {
            "craft": what.name,
            "version": __version__,
            "edition": made.params.edition,
            "params": {
                **made.params.plain(),
                **{n: str(getattr(made.params, n)) for n in made.params.files() if getattr(made.params, n) is not None},
            },
            "source": made.source,
            "edits": list(made.edits),
            **what.facts(made.piece),
            "warnings": [str(w) for w in progress.warnings],
            "problems": [w.plain() for w in progress.warnings],
            "files": [str(path) for path in writing.paths],
            "kernels": ways(),
            "seconds": {stage: round(s, 6) for stage, s in progress.seconds.items()},
        }
        if report is not None:
            with refused(Path(report)):
                write_json(told, writing.sink(report))
        writing.commit()
    return told


def guard(plan: Sequence[Output], source: str | Path | None, report: str | Path | None) -> None:
    """Refuse files that would overwrite the source or each other; TambourError.

    >>> try:
    ...     guard(outputs(craft("knit"), ["rose.png"], ""), "rose.png", None)
    ... except TambourError as error:
    ...     print(error)
    rose.png: this is the source, it would be overwritten
      name another file
    """
    problems = [
        Problem("this is the source, it would be overwritten", "name another file", where=str(item.path))
        for item in plan
        if source is not None and _same(item.path, Path(source))
    ]
    if report is not None:
        at = Path(report)
        if why := unspeakable(str(report)):
            problems.append(Problem(f"the name of the report {why}", where=str(report)[:80]))
        elif not at.parent.is_dir():
            problems.append(Problem("its folder does not exist", where=str(report)))
        elif at.is_dir():
            problems.append(Problem("this is a folder, name a file in it", where=str(report)))
        elif any(_same(at, other) for other in (*(i.path for i in plan), *([Path(source)] if source else []))):
            problems.append(
                Problem("the report would overwrite another file", "name it differently", where=str(report))
            )
    if problems:
        raise TambourError(problems)


def _same(a: Path, b: Path) -> bool:
    """Whether two names are one file."""
    return a.absolute() == b.absolute() or os.path.realpath(a) == os.path.realpath(b)


def run(
    what: Craft | str,
    source: Any = None,
    params: Params | None = None,
    out: Sequence[str | Path] = (),
    progress: Progress | None = None,
    began: float | None = None,
    report: str | Path | None = None,
    edits: Sequence[Edit | str] = (),
) -> dict[str, Any]:
    """:func:`make` and :func:`write` in one; what cannot be written is told before anything is made.

    began : ``time.perf_counter()`` at the process's start, so that imports count to the stage "start"

    >>> report = run("ink", params=craft("ink").params(seed="7", span=200), out=["hills.svg"])
    >>> report["files"], report["craft"]
    (['hills.svg'], 'ink')
    """
    begin = time.perf_counter() if began is None else began
    what = craft(what) if isinstance(what, str) else what
    progress = progress or Progress()
    given = what.params() if params is None else params
    plan = outputs(what, out, _stem(what, source, given), what.prefer(given))
    guard(plan, source if isinstance(source, (str, Path)) else None, report)
    what.check(given, [item.view for item in plan])
    what.edits(edits)
    progress.seconds["start"] = time.perf_counter() - begin
    return write(make(what, source, given, edits, progress), out, report)
