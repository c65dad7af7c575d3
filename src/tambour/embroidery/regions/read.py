"""Drawing → regions: what is to be stitched, where, and how each part differs from what was asked for in general."""

from __future__ import annotations

import math
import re
from collections.abc import Mapping, Sequence
from typing import Any

import numpy as np

from tambour.core.check import Array
from tambour.core.drawing import Drawing
from tambour.core.errors import Problem, TambourError
from tambour.core.params import Params
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.embroidery.fabric import FABRICS
from tambour.embroidery.machines import MACHINES
from tambour.embroidery.motifs import figures
from tambour.embroidery.params import EmbroideryParams, hoop_size
from tambour.embroidery.piece import AUTO, Region
from tambour.embroidery.regions.flat import stroked
from tambour.embroidery.regions.inkstitch import flags as inkstitch_flags
from tambour.embroidery.regions.inkstitch import is_satin, overrides
from tambour.embroidery.regions.lettering import how_sewn
from tambour.geometry.areas import polygons

LINES = ("running", "bean", "motif", "manual")
FINE = 0.01  # mm that an outline may move for having fewer places: some files have hundreds in a millimetre
BOLD = 0.6  # mm: lines of this width and more that are no satin are sewn thrice
LARGEST = 4_000_000.0  # mm² of design
LEAST = 5.0  # mm of width below which nobody is told to make a design that small
REACH = 100_000.0  # mm from the hoop's centre
ALONE = re.compile(r"(?:shape |.*/)(\d+)(?: \(\d+\))?")
"""What reports call a shape without an id of its own: by its number in the drawing, after the group's id where it has one."""
HANDS = ("role", "start", "end", "trim", "stop", "rails", "rank")
"""What ``data-tambour-…`` say of a shape beside parameters: ``start``, ``end`` and ``rails`` as places in mm of the hoop."""


READ = 4.0
"""mm of capitals below which letters are told to be too small."""
ROOM = 5.0
"""mm between the design and its basting box."""
KNOCKED = 2.0
"""mm that a knockdown lies beyond the design."""


def place(drawing: Drawing, params: EmbroideryParams) -> tuple[float, Array]:
    """Scale and shift that bring the drawing's lines to millimetres round the hoop's centre; strokes count as thin."""
    shown = drawing.styles.fill[:, 3] + drawing.styles.stroke[:, 3].astype(int) > 0
    visible = np.repeat(shown[drawing.style], _points_per_shape(drawing.paths))
    coords = drawing.paths.coords[visible]
    if not len(coords):
        raise TambourError(
            "there is nothing to embroider in this drawing", hint="it needs shapes with a fill or a stroke"
        )
    low, high = coords.min(0), coords.max(0)
    scale = drawing.unit
    if params.width is not None and high[0] > low[0]:
        scale = params.width / float(high[0] - low[0])
    return scale, -(low + high) / 2 * scale


def extent(found: Sequence[Region], sewn: bool = False) -> tuple[Array, Array]:
    """The lowest and the highest place (2,), mm, of these regions: strokes have their width; ``sewn`` : and all thread
    is longer by its pull, as it is while the cloth has not yet drawn in."""
    import shapely

    boxes = []
    for r in found:
        low, high = r.paths.coords.min(0), r.paths.coords.max(0)
        if r.role == "line" and r.stitch == "satin":
            wide = r.width + sewn * 2 * max(0.0, r.params.pull)
            box = np.array(shapely.total_bounds(stroked(r, r.paths, wide)))
            low, high = np.fmin(low, box[:2]), np.fmax(high, box[2:])
        elif r.stitch == "motif":  # its figures stand out beside the line, and do not grow with it
            turns = [figures(line, r.params.motif, r.params.motif_size) for line in r.paths if len(line) > 1]
            sewn_at = np.concatenate(turns or [r.paths.coords])
            low, high = sewn_at.min(0), sewn_at.max(0)
        elif r.role == "area":
            low, high = low - sewn * max(0.0, r.params.pull), high + sewn * max(0.0, r.params.pull)
        boxes.append((low, high))
    return np.min([b[0] for b in boxes], axis=0), np.max([b[1] for b in boxes], axis=0)


def _fits(design: Array, beyond: float, params: EmbroideryParams) -> None:
    """Raise TambourError for what is larger, with so many mm sewn beyond it, than the hoop, or than any machine."""
    size = design + 2 * beyond
    if size[0] * size[1] > LARGEST:
        raise TambourError(
            f"the design is {size[0]:.0f} x {size[1]:.0f} mm, more than any machine sews",
            hint="give its size: {--width} 100mm",
        )
    if params.hoop is None and params.machine is not None:
        machine = MACHINES[params.machine]
        field = machine.field
        if min(size) > min(field) + 0.05 or max(size) > max(field) + 0.05:
            fits = _fitting(design, sorted(field) if design[0] < design[1] else sorted(field)[::-1], beyond, params)
            raise TambourError(
                f"the design is {size[0]:.1f} x {size[1]:.1f} mm, the field of {params.machine} {field[0]:g} x {field[1]:g} mm ({machine.source})",
                hint=_fits_so(fits, size),
                where="{--machine}",
            )
    if params.hoop is None:
        return
    hoop = hoop_size(params.hoop)
    if size[0] > hoop[0] + 0.05 or size[1] > hoop[1] + 0.05:
        if size[1] <= hoop[0] + 0.05 and size[0] <= hoop[1] + 0.05:
            raise TambourError(
                f"the design is {size[0]:.1f} x {size[1]:.1f} mm, the hoop {hoop[0]:g} x {hoop[1]:g} mm",
                hint=f"a quarter turn fits: {{--hoop}} {hoop[1]:g}x{hoop[0]:g}, the hoop turned",
                where="{--hoop}",
            )
        fits = _fitting(design, hoop, beyond, params)
        raise TambourError(
            f"the design is {size[0]:.1f} x {size[1]:.1f} mm, the hoop {hoop[0]:g} x {hoop[1]:g} mm",
            hint=_fits_so(fits, size),
            where="{--hoop}",
        )


def _fitting(design: Array, field: Sequence[float], beyond: float, params: EmbroideryParams) -> float:
    """The ``--width`` with which a design fits into a field: what thread adds to it at its edges does not shrink with it."""
    thread = 2 * max(0.0, params.pull)
    room = np.array(field) - 2 * beyond - thread
    return float((room / (design - thread)).min() * (design[0] - thread))


def _fits_so(fits: float, size: Array) -> str:
    """The remedy for a design that is too large: a width that fits, or where none does the hoop that it needs."""
    if fits >= LEAST:
        return f"{{--width}} {math.floor(fits * 10) / 10:g}mm would fit"
    return f"a larger {{--hoop}}: {math.ceil(size[0])}x{math.ceil(size[1])} would take it"


def _points_per_shape(paths: Paths) -> Array:
    ends = paths.offsets if paths.parts is None else paths.offsets[paths.parts]
    return np.diff(ends)


def regions(drawing: Drawing, params: EmbroideryParams, progress: Progress) -> tuple[Region, ...]:
    """The areas and lines of a drawing, in painter's order, mm round the hoop's centre.

    A group's data (``tambour-angle``, …) hold for all in it, the innermost last; ``inkstitch-…`` for its own shape.
    The width asked for and the hoop are those of all thread: the scale is set anew until they agree (a stroke that is
    satin has its width, one that is too thin for that has none). Raises TambourError with all that is wrong.
    """
    scale, shift = place(drawing, params)
    found, tiny = _found(drawing, params, scale, shift)
    for _ in range(4):
        low, high = extent(found)
        if params.width is not None and not high[0] > low[0]:
            raise TambourError("the drawing has no width to scale", where="{--width}")
        grow = 1.0 if params.width is None else params.width / float(high[0] - low[0])
        middle = (low + high) / 2
        if abs(grow - 1) < 5e-4 and np.abs(middle).max() < 1e-3:
            break
        scale, shift = scale * grow, (shift - middle) * grow
        found, tiny = _found(drawing, params, scale, shift)
    beyond = max(ROOM if params.baste else 0.0, KNOCKED if params.knockdown else 0.0)
    _fits(np.subtract(*extent(found, sewn=True)[::-1]), beyond, params)
    if tiny:
        progress.warn(f"{tiny} shape(s) have no area and were left out")
    letters = [float(data["letters"]) for data in drawing.groups.data if "letters" in data]
    own = [params.text_size] if params.text is not None else []
    small = min([*letters, *own], default=math.inf)
    if small * scale < READ:
        progress.warn(
            f"capitals of {small * scale:.1f} mm: below {READ:g} mm few letters can be read once they are sewn",
            hint=_legible(small, scale, small in own, params),
        )
    return tuple(found)


def _legible(small: float, scale: float, own: bool, params: EmbroideryParams) -> str:
    """How capitals of ``small``, sewn at a scale, come to ``READ`` mm; ``own`` : they are those of ``--text``."""
    if params.width is not None:  # letters grow with all the rest
        return f"{{--width}} {math.ceil(params.width * READ / (small * scale))}mm"
    return f"{{--text-size}} {math.ceil(READ / scale)}mm" if own else "a {--width}, or a larger font-size"


def _found(drawing: Drawing, params: EmbroideryParams, scale: float, shift: Array) -> tuple[list[Region], int]:
    """The regions at a scale, and how many shapes have no area."""
    paths = drawing.paths
    parts = np.arange(len(paths) + 1) if paths.parts is None else paths.parts
    fill, stroke = drawing.styles.fill, drawing.styles.stroke
    problems: list[Problem] = []
    cache: dict[int, tuple[EmbroideryParams, Mapping[str, str], str]] = {}
    found: list[Region] = []
    guides = _guides(drawing, parts, scale, shift)
    shared = _shared(drawing)
    tiny = 0
    for m, style in enumerate(drawing.style.tolist()):
        group = int(drawing.group[m])
        if group not in cache:
            cache[group] = _own(drawing, group, params, problems, scale)
        own, data, name = cache[group]
        if (
            data.get("tambour-role") in ("guide", "baseline")
            or data.get("inkstitch-marker")
            or "inkstitch-command-ignore_object" in data
        ):
            continue
        lines = [paths[i] * scale + shift for i in range(int(parts[m]), int(parts[m + 1]))]
        if own.stitch != "manual":
            lines = [_thinned(line) for line in lines]
        common = {
            "guide": guides.get(int(drawing.groups.parent[group]) if group >= 0 else -1),
            "start": _point(data, ("inkstitch-command-starting_point", "inkstitch-command-fill_start"), scale, shift),
            "end": _point(data, ("inkstitch-command-ending_point", "inkstitch-command-fill_end"), scale, shift),
            "flags": inkstitch_flags(data)
            | ({"whole"} if any(key.startswith("inkstitch-") for key in data) else set())
            | {word for word in ("letter",) if word in data},
        }
        name = f"{name}/{m + 1}" if name in shared else name or f"shape {m + 1}"
        common |= _by_hand(data, name, common, problems)
        if rails := _rails(data, name, problems):
            rgb = tuple(int(c) for c in (fill if fill[style, 3] else stroke)[style, :3])
            found.append(Region(name, rails, "satin", rgb, own, "rails", 0.0, **common))  # type: ignore[arg-type]
            continue
        if fill[style, 3] and not is_satin(data):
            area = polygons(lines, bool(drawing.styles.evenodd[style]))
            if area is None:
                tiny += 0 if stroke[style, 3] else 1
            else:
                family = str(own.stitch or AUTO)
                if family in LINES and "inkstitch-stroke_method" in data:
                    family = "tatami"  # that method was said of the stroke
                role = "line" if family in LINES else "area"
                made = area if role == "area" else Paths(area.coords, area.offsets)
                rgb = tuple(int(c) for c in fill[style, :3])
                alpha = float(fill[style, 3]) / 255
                found.append(Region(name, made, family, rgb, own, role, alpha=alpha, **common))  # type: ignore[arg-type]
        width = float(drawing.styles.width[style]) * scale
        if (stroke[style, 3] and width > 0) or is_satin(data):
            rgb = tuple(int(c) for c in (stroke if stroke[style, 3] else fill)[style, :3])
            role = "line"
            family = str(own.stitch or "")
            if is_satin(data) and len(lines) >= 2:
                role, family = "rails", "satin"
            elif family not in (*LINES, "satin"):
                satin = width >= own.satin_from and "inkstitch-stroke_method" not in data
                bold = width >= BOLD and "inkstitch-stroke_method" not in data
                family = "satin" if satin else "bean" if bold else "running"
            made = Paths.of([line for line in lines if len(line) > 1])
            if len(made):
                alpha = float(stroke[style, 3]) / 255 or 1.0
                ends = {"cap": int(drawing.styles.cap[style]), "join": int(drawing.styles.join[style])}
                found.append(Region(name, made, family, rgb, own, role, width, alpha=alpha, **ends, **common))  # type: ignore[arg-type]
    if problems:
        raise TambourError(problems)
    if not found:
        raise TambourError(
            "there is nothing to embroider in this drawing", hint="its shapes have no area and no stroke"
        )
    return found, tiny


def _shared(drawing: Drawing) -> set[str]:
    """The ids of groups that hold several shapes: each of these is told by its number too, as in ``color/5``."""
    many = np.bincount(drawing.group[drawing.group >= 0], minlength=1) > 1
    ids = drawing.groups.ids
    return {ids[k] for k in np.flatnonzero(many).tolist()} | {i.rpartition("/")[0] for i in ids if ALONE.fullmatch(i)}


def _thinned(line: Array) -> Array:
    """A line without the places that no needle can tell from the straight way between the others."""
    import shapely

    return line if len(line) < 4 else shapely.get_coordinates(shapely.simplify(shapely.LineString(line), FINE))


def _own(
    drawing: Drawing, group: int, params: EmbroideryParams, problems: list[Problem], scale: float
) -> tuple[EmbroideryParams, Mapping[str, str], str]:
    """Parameters, data and id of a group: its surroundings' ``tambour-…``, then its own; small text of a drawing is sewn as
    ``--text`` of its size is, where nobody says otherwise."""
    chain: list[int] = []
    while group >= 0:
        chain.insert(0, group)
        group = int(drawing.groups.parent[group])
    if not chain or not drawing.groups.data:
        return params, {}, ""
    own = drawing.groups.data[chain[-1]]
    name = drawing.groups.ids[chain[-1]]
    given: dict[str, Any] = {}
    for g in chain:
        for key, value in drawing.groups.data[g].items():
            if key.startswith("tambour-") and key[8:] not in HANDS:
                given[key[8:].replace("-", "_")] = value
    role = [drawing.groups.data[g].get("tambour-role", "") for g in chain]
    data = {**own, "tambour-role": next(filter(None, reversed(role)), "")}
    try:
        given = {**_small(drawing, chain[-1], own, params, scale), **overrides(own, name), **given}
        if not given:
            return params, data, name
        files = set(EmbroideryParams.files()) & set(given)
        if files:
            raise TambourError(f"{min(files)} cannot stand on a region", where=name)
        new = {*EmbroideryParams.files(), *FABRICS.get(given.get("fabric", ""), ())}
        base = {k: v for k, v in params.model_dump().items() if k not in new}
        made = type(params).of({**base, **given}, spell=f"{name}: data-tambour-{{}}")
        return made.model_copy(update={k: getattr(params, k) for k in Params.files()}), data, name
    except TambourError as error:
        problems += error.problems
        return params, data, name


def _small(
    drawing: Drawing, group: int, own: Mapping[str, str], params: EmbroideryParams, scale: float
) -> dict[str, Any]:
    """How a group is sewn that is text with capitals of 10 mm and less."""
    size = float(own.get("letters", "inf")) * scale
    if size > 10 or params.stitch is not None:
        return {}
    parts = np.arange(len(drawing.paths) + 1) if drawing.paths.parts is None else drawing.paths.parts
    shapes = np.flatnonzero(drawing.group == group).tolist()
    rings = [drawing.paths[i] * scale for m in shapes for i in range(int(parts[m]), int(parts[m + 1]))]
    return {k[8:].replace("-", "_"): v for k, v in how_sewn(rings, size).items()} if rings else {}


def _guides(drawing: Drawing, parts: Array, scale: float, shift: Array) -> dict[int, Paths]:
    """Guide lines by the group they stand in."""
    found: dict[int, list[Array]] = {}
    for m, group in enumerate(drawing.group.tolist()):
        if group < 0 or not drawing.groups.data:
            continue
        data = drawing.groups.data[group]
        if data.get("tambour-role") == "guide" or data.get("inkstitch-marker") == "guide-line":
            lines = [drawing.paths[i] * scale + shift for i in range(int(parts[m]), int(parts[m + 1]))]
            found.setdefault(int(drawing.groups.parent[group]), []).extend(lines)
    return {g: Paths.of([line for line in lines if len(line) > 1]) for g, lines in found.items()}


def _numbers(data: Mapping[str, str], key: str, name: str, problems: list[Problem]) -> list[list[tuple[float, float]]]:
    """Lines of points, mm from the hoop's centre, as ``x,y x,y; x,y`` says them; none where they are wrong or not there."""
    said = data.get(f"tambour-{key}", "").strip()
    try:
        lines = [
            [tuple(float(v) for v in at.split(",")) for at in line.split()] for line in said.split(";") if line.strip()
        ]
        if any(len(at) != 2 or not all(abs(v) < REACH for v in at) for line in lines for at in line):
            raise ValueError
    except ValueError:
        hint = "x,y in mm from the hoop's centre, such as 12.5,-4"
        problems.append(Problem(f"data-tambour-{key}={said[:60]!r} is no place", hint, where=name))
        return []
    return lines  # type: ignore[return-value]


def _by_hand(data: Mapping[str, str], name: str, known: Mapping[str, Any], problems: list[Problem]) -> dict[str, Any]:
    """Where a region is begun and ended, what is done after it, and its place in the order, as ``tambour-…`` say."""
    made: dict[str, Any] = {}
    for key in ("start", "end"):
        if lines := _numbers(data, key, name, problems):
            made[key] = lines[0][0]
    for key in ("trim", "stop"):
        if f"tambour-{key}" in data:
            on = data[f"tambour-{key}"].strip().lower() in ("true", "yes", "1", "on")
            made["flags"] = (made.get("flags", known["flags"]) - {key}) | ({key} if on else set())
    if "tambour-rank" in data:
        rank = data["tambour-rank"].strip()
        if rank.isdecimal() and len(rank) < 9:
            made["rank"] = int(rank)
        else:
            problems.append(Problem(f"data-tambour-rank={rank[:60]!r} is no number", "such as 3", where=name))
    return made


def _rails(data: Mapping[str, str], name: str, problems: list[Problem]) -> Paths | None:
    """The two rails of a satin column that were laid by hand."""
    lines = [line for line in _numbers(data, "rails", name, problems) if len(line) > 1]
    if "tambour-rails" not in data or not lines:
        return None
    if len(lines) != 2:
        problems.append(Problem("a satin column has two rails, each of two places and more", where=name))
        return None
    return Paths.of([np.array(line, np.float64) for line in lines])


def _point(data: Mapping[str, str], names: tuple[str, ...], scale: float, shift: Array) -> tuple[float, float] | None:
    for name in names:
        if name in data:
            x, y = (float(v) for v in data[name].split())
            return x * scale + float(shift[0]), y * scale + float(shift[1])
    return None
