"""Machine files by pystitch, its faults guarded: PES, PEC, JEF, SEW, VP3, XXX, U01, TBF, and forty that are only read.

A plan is first brought into records (``files.records``) that mean the same in every format; threads are chosen from
the palette the format has; what pystitch would write wrong without a word is refused with one; and each file is read
back and compared before it is left. DST and EXP have codecs of their own (``files.dst``, ``files.exp``).
"""

from __future__ import annotations

import io
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.errors import TambourError
from tambour.core.thread import COLOR, END, JUMP, STITCH, STOP, TRIM, Thread, ThreadPlan
from tambour.files.headers import Watched, doubts
from tambour.files.records import Records, blocks, load, needle_points, plan_of, records, same, split, strange
from tambour.files.sink import Sink


@dataclass(frozen=True, slots=True)
class Form:
    """What a format can hold.

    limit : longest step, units · palette : pystitch's table of threads, or "" where colours are free
    colors : most blocks of colour, 0 for any · stops : has a stop of its own · needles : changes name a needle
    trims : "own" record, "jumps" (every jump is a trim), or "" (none)
    origin : coordinates come back as they were; else the design comes back centred
    exact : colours come back as they were
    """

    limit: int
    palette: str = ""
    colors: int = 0
    stops: bool = False
    needles: bool = False
    trims: str = "own"
    origin: bool = True
    exact: bool = False


FORMS: dict[str, Form] = {
    "pes": Form(2047, "Pec", 64, trims="jumps", origin=False),
    "pec": Form(2047, "Pec", 64, trims="jumps", origin=False),
    "jef": Form(127, "Jef", 0, stops=True, trims=""),
    "sew": Form(127, "Sew", 12, trims=""),
    "vp3": Form(255, "", 255, exact=True),
    "xxx": Form(123, "", 21, exact=True),
    "u01": Form(127, "", 14, stops=True, needles=True),
    "tbf": Form(127, "", 74, stops=True, needles=True, exact=True),
}

# The codes that a JEF file names its hoop by: inner size in units → code.
_JEF_HOOPS = (((500, 500), 1), ((1100, 1100), 0), ((1260, 1100), 3), ((1400, 2000), 2), ((2000, 2000), 4))
# JEF has a field for the date; the same design must give the same bytes, so the field holds this one.
_JEF_DATE = "20000101000000"
_PY = {STITCH: 0, JUMP: 1, TRIM: 2, STOP: 3, END: 4, COLOR: 5}
_OURS = {0: STITCH, 1: JUMP, 2: TRIM, 3: STOP, 4: END, 5: COLOR, 9: COLOR}


def table(name: str) -> list[Any]:
    """pystitch's threads of the palette ``name`` (Pec, Jef, Sew, Shv, Hus); None where an entry is empty."""
    from importlib import import_module

    return list(import_module(f"pystitch.EmbThread{name}").get_thread_set())


def matched(threads: list[Thread], name: str) -> list[int]:
    """For each thread the entry of the palette that stands for it: nearest in Oklab, one entry per thread while they
    last, so that two colours of a design stay two."""
    from tambour.color import nearest_distinct

    entries = [(k, t) for k, t in enumerate(table(name)) if t is not None]
    palette = np.array([[t.get_red(), t.get_green(), t.get_blue()] for _, t in entries], np.uint8)
    chosen = nearest_distinct(np.array([t.rgb for t in threads], np.uint8).reshape(-1, 3), palette)
    return [entries[k][0] for k in chosen.tolist()]


def write_plan(value: ThreadPlan, sink: Sink) -> None:
    """A machine file by the suffix of ``sink``, read back and compared.

    Raises TambourError for a design that the format cannot hold (colours, hoop).
    """
    kind = sink.suffix[1:]
    form = FORMS[kind]
    wanted = records(value)
    order = blocks(wanted, stops=not form.stops)
    used = sorted(set(order), key=order.index)
    if form.colors and max(len(used), 0 if kind in ("pes", "pec") else len(order) * (kind != "u01")) > form.colors:
        raise TambourError(
            f"{kind.upper()} files hold {form.colors} colours, the design has {max(len(used), len(order))}",
            hint="write PES 6, VP3 or DST, or use fewer colours",
            where=str(sink.path),
        )
    if kind in ("pes", "pec") and len(order) > 255:
        raise TambourError(
            f"{kind.upper()} files hold 255 blocks of colour, the design has {len(order)}", where=str(sink.path)
        )
    version = value.about.get("pes", "1")
    threads = _threads(value, used, form, kind, version)
    r = split(wanted, form.limit)
    pattern = _pattern(r, form, [threads[used.index(k)] for k in order], {k: i + 1 for i, k in enumerate(used)})
    pattern.metadata("name", value.about.get("title", "") or "tambour")
    raw = _write(pattern, kind, {"version": version, "trims": value.about.get("jef-trims") == "yes"})
    if kind == "jef":
        raw = _jef_hoop(raw, wanted, sink)
    trims = kind == "jef" and value.about.get("jef-trims") == "yes"
    _compare(wanted, form, _decode(raw, kind), kind, value, trims, version)
    sink.put(raw)


def _threads(value: ThreadPlan, used: list[int], form: Form, kind: str, version: str) -> list[Any]:
    """pystitch's threads for those in use: of the format's palette, or as they are."""
    from pystitch import EmbThread

    ours = [value.threads[k] for k in used]
    if form.palette and not (kind == "pes" and version == "6"):
        palette = table(form.palette)
        made = []
        for k in matched(ours, form.palette):
            entry = palette[k]
            made.append(EmbThread(entry.color, entry.description, str(k), brand=entry.brand, chart=entry.chart))
        return made
    return [
        EmbThread((t.rgb[0] << 16) | (t.rgb[1] << 8) | t.rgb[2], t.name or "", t.code or "", brand=t.catalogue or "")
        for t in ours
    ]


def _pattern(r: Records, form: Form, threads: list[Any], needle: dict[int, int]) -> Any:
    """The pattern that pystitch writes, in commands it need not encode."""
    from pystitch import EmbPattern

    pattern = EmbPattern()
    pattern.threadlist = list(threads)
    code = np.array([_PY[k] for k in range(6)])[r.command]
    if not form.stops:
        code[r.command == STOP] = _PY[COLOR]
    xy = r.xy.tolist()
    stitches = [[x, y, c] for (x, y), c in zip(xy, code.tolist())]
    if form.needles:
        # 9 is NEEDLE_SET; the needle stands in the third byte, one above its number.
        first = int(r.thread[np.flatnonzero(r.command == STITCH)[0]])
        for k in np.flatnonzero(r.command == COLOR).tolist():
            stitches[k][2] = 9 | (needle[int(r.thread[k])] + 1) << 16
        stitches.insert(0, [0, 0, 9 | (needle[first] + 1) << 16])
    if form.trims == "jumps":
        # The trim is a flag on a jump: where none follows, one that leads nowhere carries it.
        kept = []
        for k, s in enumerate(stitches):
            if s[2] != _PY[TRIM]:
                kept.append(s)
            elif stitches[k + 1][2] not in (_PY[JUMP], _PY[COLOR]):
                kept.append([s[0], s[1], _PY[JUMP]])
        stitches = kept
    pattern.stitches = stitches
    return pattern


def _write(pattern: Any, kind: str, settings: dict[str, Any]) -> bytes:
    from importlib import import_module

    from pystitch import EmbPattern

    class Even(EmbPattern):  # type: ignore[misc]
        """VP3 halves its extents in whole units: odd ones would move later blocks by one."""

        def bounds(self) -> tuple[int, int, int, int]:
            left, top, right, bottom = (round(v) for v in super().bounds())
            return left, top, right + (left + right) % 2, bottom + (top + bottom) % 2

    made = Even(pattern)
    writer = import_module(f"pystitch.{kind.capitalize()}Writer")
    stream = io.BytesIO()
    given = {"encode": False, "date": _JEF_DATE, **settings}
    if kind not in ("pes", "jef"):
        given = {"encode": False}
    elif kind == "jef":
        del given["version"]
    EmbPattern.write_embroidery(writer, made, stream, given)
    return stream.getvalue()


def _jef_hoop(raw: bytes, r: Records, sink: Sink) -> bytes:
    """The file with the code of the smallest hoop that holds the design, measured from its centre."""
    size = r.xy.max(axis=0) - r.xy.min(axis=0)
    for (w, h), code in _JEF_HOOPS:
        if size[0] <= w and size[1] <= h:
            return raw[:32] + code.to_bytes(4, "little") + raw[36:]
    raise TambourError(
        f"the design is {size[0] / 10:g} x {size[1] / 10:g} mm, the largest hoop of a JEF file is 200 x 200 mm",
        hint="make it smaller with {--width}, or write another format",
        where=str(sink.path),
    )


def _compare(
    wanted: Records, form: Form, got: ThreadPlan, kind: str, value: ThreadPlan, jef_trims: bool, version: str
) -> None:
    """Raise AssertionError unless the file says what the records say."""
    a = needle_points(wanted.xy, wanted.command)
    b = needle_points(np.rint(got.xy * 10).astype(np.int64), got.command)
    if not form.trims and not jef_trims:
        a = (a[0], a[1], np.zeros_like(a[2]))
    if not form.origin and len(a[0]) == len(b[0]):
        b = (b[0] - b[0][0] + a[0][0], b[1], b[2])
    wrong = same(a, b)
    if "doubts" in got.about:
        wrong = wrong or got.about["doubts"]
    if not wrong and (form.exact or (kind == "pes" and version == "6")):
        back = [got.threads[int(k)].rgb for k in got.thread[got.command == STITCH]]
        here = [value.threads[int(k)].rgb for k in wanted.thread[wanted.command == STITCH]]
        wrong = "" if back == here else "colours changed"
    if wrong:
        raise AssertionError(f"the {kind.upper()} file read back differs from the design: {wrong}")


def read_plan(path: Path) -> ThreadPlan:
    """The design in a machine file, by its suffix.

    Raises TambourError when it is not such a file; what its header and its stitches disagree on, and an end that is
    missing, are said in ``about["doubts"]``.
    """
    kind = path.suffix.lower()[1:]
    raw = load(path)
    try:
        made = _decode(raw, kind)
        said = strange(np.rint(made.xy * 10), made.command)
        if not said:
            return made
        about = {**made.about, "doubts": "\n".join(filter(None, (made.about.get("doubts", ""), said)))}
        return replace(made, about=about)
    except TambourError as error:
        raise TambourError(
            f"this is not a {kind.upper()} design: {error.problems[0].message}", where=str(path)
        ) from None


def _decode(raw: bytes, kind: str) -> ThreadPlan:
    pattern, stream = _read(raw, kind)
    made, said = _plan(pattern, kind), doubts(kind, raw, stream, pattern)
    about = {**made.about, "format": kind.upper()}
    if said:
        about["doubts"] = "\n".join(said)
    return ThreadPlan(made.xy, made.command, made.thread, made.threads, None, about)


def _read(raw: bytes, kind: str) -> tuple[Any, Watched]:
    """pystitch's pattern; whatever it raises on a damaged file becomes a TambourError."""
    import pystitch

    reader = next(f["reader"] for f in pystitch.supported_formats() if kind in _suffixes(f))
    pattern, stream = pystitch.EmbPattern(), Watched(raw)
    settings = {"trims": True, "trim_distance": None, "clipping": False} if kind == "jef" else {}
    try:
        reader.read(stream, pattern, settings)
    except RecursionError:
        raise TambourError("its parts contain each other") from None
    except MemoryError:
        raise TambourError("it declares more than fits into memory") from None
    except Exception as error:  # noqa: BLE001 - the library raises whatever Python does on bytes it did not expect
        raise TambourError(f"its bytes break off or make no sense ({type(error).__name__})") from None
    return pattern, stream


def _suffixes(form: dict[str, Any]) -> tuple[str, ...]:
    listed = form.get("extensions") or (form["extension"],)
    return (listed,) if isinstance(listed, str) else tuple(listed)


def _plan(pattern: Any, kind: str) -> ThreadPlan:
    """The plan of a pattern as pystitch has read it."""
    rows = [(s[0], s[1], int(s[2])) for s in pattern.stitches]
    if not rows:
        raise TambourError("the file holds no stitch")
    xy = np.array([(x, y) for x, y, _ in rows], np.float64)
    if not np.isfinite(xy).all() or np.abs(xy).max() > 1e9:
        raise TambourError("its coordinates make no sense")
    units = np.rint(xy).astype(np.int64)
    low = np.array([c & 0xFF for _, _, c in rows])
    known = np.isin(low, list(_OURS))
    if not known.any():
        raise TambourError("the file holds no stitch")
    units, low = units[known], low[known]
    command = np.array([_OURS.get(k, 0) for k in range(256)], np.uint8)[low]
    past = np.flatnonzero(command == END)
    if len(past):
        units, command = units[: past[0] + 1], command[: past[0] + 1]
    if kind in ("pes", "pec") and (command == STITCH).any():
        sewn = units[command == STITCH]
        units = units - (sewn.min(axis=0) + sewn.max(axis=0)) // 2
    about: dict[str, str] = {}
    name = pattern.extras.get("name") or pattern.extras.get("Name")
    if isinstance(name, str) and name.strip().isprintable():
        about["title"] = name.strip()
    threads = [_thread(t) for t in pattern.threadlist if t is not None]
    which = _needles(rows, known, len(command), threads) if kind in ("u01", "tbf") else None
    return plan_of(units, command, threads, about, which)


def _needles(rows: list[tuple[Any, Any, int]], known: Array, n: int, threads: list[Thread]) -> Array | None:
    """Which thread (N,) is on, where changes name needles; None where they do not."""
    codes = np.array([c for _, _, c in rows])[known][:n]
    sets = (codes & 0xFF) == 9
    needle = (codes >> 16 & 0xFF) - 1
    if not sets.any():
        return None
    at = np.maximum.accumulate(np.where(sets, np.arange(n), -1))
    on = np.where(at >= 0, needle[at.clip(0)], needle[np.flatnonzero(sets)[0]]) - 1
    if (on < 0).any() or (threads and on.max() >= len(threads)):
        return None
    return on


def _thread(t: Any) -> Thread:
    def word(value: Any) -> str:
        return value.strip() if isinstance(value, str) and value.isprintable() else ""

    rgb = (int(t.get_red()), int(t.get_green()), int(t.get_blue()))
    return Thread(rgb, word(t.description), word(t.brand), word(t.catalog_number))
