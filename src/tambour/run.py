"""Run: read → make → view → write, with a report. The command line, the studio and batches are callers of it."""

from __future__ import annotations

import os
import tempfile
import time
from collections.abc import Mapping, Sequence
from contextlib import ExitStack
from dataclasses import dataclass, replace
from importlib import import_module
from pathlib import Path
from typing import TYPE_CHECKING, Any

from tambour import files
from tambour.core.digest import digest
from tambour.core.errors import Problem, TambourError, did_you_mean
from tambour.core.progress import Progress
from tambour.craft import Craft, View

if TYPE_CHECKING:
    from tambour.core.params import Params

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
    """The craft called ``name``; TambourError when there is none."""
    if name not in CRAFTS:
        raise TambourError(
            f'there is no craft "{name}"', hint=did_you_mean(name, CRAFTS) or f"known: {', '.join(CRAFTS)}"
        )
    module, attribute = CRAFTS[name][0].split(":")
    found: Craft = getattr(import_module(module), attribute)
    return found


@dataclass(frozen=True, slots=True)
class Output:
    """A file asked for: where, by which view, of which value type."""

    path: Path
    view: str
    suffix: str


def outputs(
    what: Craft, names: Sequence[str | Path], stem: str, prefer: Mapping[str, str] | None = None
) -> list[Output]:
    """The outputs that names such as ``toy.png``, ``toy.back.png``, ``.svg`` or ``folder/`` ask for.

    ``name.VIEW.suffix`` takes a view only when VIEW is one of the craft's; else ``prefer`` (suffix → view) comes
    before the views' own suffixes. All that is wrong is raised at once.
    """
    prefer = prefer or {}
    found: list[Output] = []
    problems: list[Problem] = []
    for name in names:
        path, text = Path(name), str(name)
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
        if any(path.absolute() == o.path.absolute() for o in found):
            problems.append(Problem("asked for twice", "name each file once", where=text))
        found.append(Output(path, view, suffix))
    if problems:
        raise TambourError(problems)
    return found


def load_files(params: Params) -> Params:
    """Params with every field that names a file replaced by the value read from it."""
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
                option = f"--{name.rstrip('_').replace('_', '-')}"
                for p in error.problems:
                    told = replace(p, hint=hint) if words and not Path(given).suffix else p
                    problems.append(replace(told, where=f"{option} {told.where}") if told.where else told)
    if problems:
        raise TambourError(problems)
    return params.model_copy(update=loaded) if loaded else params


def run(
    what: Craft | str,
    source: Any = None,
    params: Params | None = None,
    out: Sequence[str | Path] = (),
    progress: Progress | None = None,
    began: float | None = None,
) -> dict[str, Any]:
    """Make a piece of ``source`` and write the files ``out``; gives the report.

    what : a Craft or its name
    source : a path (read by its suffix), a value, or None
    params : the craft's Params (defaults when None); fields that name files are read here
    out : file names, see :func:`outputs`; all are written, or, on any error, none
    began : ``time.perf_counter()`` at the process's start, so that imports count to the stage "start"

    Raises TambourError for input that cannot be used. The report holds craft, version, edition, params, source, the
    craft's facts, warnings, files, and seconds per stage.
    """
    from tambour import __version__

    begin = time.perf_counter() if began is None else began
    what = craft(what) if isinstance(what, str) else what
    progress = progress or Progress()
    given = what.params() if params is None else params
    origin: dict[str, Any] = {}
    if source is None and what.reads and not what.optional_source:
        raise TambourError(f"{what.name} needs a source", hint=f"tambour {what.name} SOURCE -o OUT; --help tells more")
    if source is not None and not what.reads:
        raise TambourError(f"{what.name} takes no source", where=str(source))
    stem = what.stem(given)
    if isinstance(source, (str, Path)):
        stem = stem or Path(source).stem
    plan = outputs(what, out, stem, what.prefer(given))
    what.check(given, [item.view for item in plan])
    for item in plan:
        if isinstance(source, (str, Path)) and item.path.absolute() == Path(source).absolute():
            raise TambourError(
                "this is the source, it would be overwritten", hint="name another file", where=str(item.path)
            )
    progress.seconds["start"] = time.perf_counter() - begin

    with progress.stage("read"):
        if isinstance(source, (str, Path)):
            origin["path"] = str(source)
            source = files.read(source, what.reads)
        if source is not None:
            origin["sha256"] = digest(source)
        full = load_files(given)

    # After reading: what cannot be read is told at once, not when the kernels are loaded.
    with progress.stage("start"):
        what.warm()
    piece = what.make(source, full, progress)

    with ExitStack() as stack:
        made: list[tuple[Path, Path]] = []
        cache: dict[str, Any] = {}
        for k, item in enumerate(plan):
            view: View = what.views[item.view]
            if item.view not in cache:
                with progress.stage(view.stage):
                    cache[item.view] = view.make(piece)
            try:
                hidden_place = tempfile.TemporaryDirectory(prefix=".tambour-", dir=item.path.parent)
                beside = Path(stack.enter_context(hidden_place))
            except OSError as error:
                raise TambourError(f"cannot be written: {error.strerror}", where=str(item.path)) from None
            with progress.stage("write"):
                progress.step(k, len(plan))
                value = cache[item.view]
                if hasattr(value, "__next__"):
                    del cache[item.view]  # a stream can be written once
                try:
                    files.write(value, beside / item.path.name, view.value)
                except OSError as error:
                    raise TambourError(f"cannot be written: {error.strerror}", where=str(item.path)) from None
                except TambourError as error:
                    # Made beside its place: the place is what was asked for.
                    hidden, shown = str(beside), str(item.path.parent)
                    moved = [replace(p, where=p.where.replace(hidden, shown)) for p in error.problems]
                    raise TambourError(
                        [replace(p, where=os.path.normpath(p.where)) if p.where else p for p in moved]
                    ) from None
            made += [(p, item.path.parent / p.name) for p in sorted(beside.iterdir())]
        for temporary, final in made:
            os.replace(temporary, final)

    report: dict[str, Any] = {
        "craft": what.name,
        "version": __version__,
        "edition": given.edition,
        "params": {
            **given.plain(),
            **{n: str(getattr(given, n)) for n in given.files() if getattr(given, n) is not None},
        },
        "source": origin or None,
        **what.facts(piece),
        "warnings": [str(w) for w in progress.warnings],
        "files": [str(final) for _, final in made],
        "seconds": {stage: round(s, 6) for stage, s in progress.seconds.items()},
    }
    return report
