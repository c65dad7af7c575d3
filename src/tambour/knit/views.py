"""Views: what can be made of a solved piece, each a value for some file."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from tambour.craft import Lazy, View

if TYPE_CHECKING:
    from tambour.core.chart import Chart, Disk
    from tambour.core.drawing import Drawing
    from tambour.core.errors import Text
    from tambour.core.picture import Picture
    from tambour.knit.hands.yarn import Amount
    from tambour.knit.piece import Piece
    from tambour.knit.sheets.draw import Look


def stitches(piece: Piece) -> Chart:
    """The chart itself."""
    return piece.chart


def project(piece: Piece) -> dict[str, Any]:
    """Chart, masks and params: enough to open it again, or to solve it anew."""
    return {**piece.chart.plain(), "params": piece.params.plain()}


def anchored(piece: Piece) -> bool:
    """Both yarns go to both sides."""
    return not piece.free_edges


def title(piece: Piece) -> str:
    """What the pattern is called."""
    return piece.params.title or f"{piece.chart.technique.capitalize()} chart"


def look(piece: Piece, cell: float = 4.0) -> Look:
    """How the piece's chart is drawn, ``cell`` mm to the smaller side of a stitch."""
    from tambour.knit.sheets.draw import Look
    from tambour.knit.sheets.fabric import aspect_of

    aspect = aspect_of(piece.chart)
    wide = cell * max(1.0, aspect)
    return Look(
        cells=piece.params.cells,
        cell=(wide, wide / aspect),
        limit=(piece.params.catch or piece.limit) if piece.chart.technique == "stranded" else None,
        anchored=anchored(piece),
        repeat=piece.repeat[0] if piece.repeat else None,
        dominant=dominant(piece),
    )


def dominant(piece: Piece) -> int | None:
    """The yarn held below throughout; with more than two it changes from row to row."""
    from tambour.knit.hands.working import roles

    return piece.dominant if piece.chart.technique == "stranded" and len(roles(piece.chart)) == 2 else None


def yarn(piece: Piece) -> list[Amount]:
    """What each colour takes."""
    from tambour.knit.hands.yarn import amounts

    p = piece.params
    return amounts(piece.chart, p.yarn_weight, p.skein_metres, p.skein_grams, anchored(piece))


def chart(piece: Piece) -> Drawing:
    """The whole chart on one sheet."""
    from tambour.knit.sheets.draw import sheet_of

    return sheet_of(piece.chart, look(piece, 6.5 if piece.params.large_cells else 4.0), title(piece))


def pattern(piece: Piece) -> tuple[Drawing, ...]:
    """The printed pattern; with ``swatch``, its page follows the cover."""
    from textwrap import wrap

    from tambour.knit.hands.openings import notes
    from tambour.knit.sheets.fabric import aspect_of, front, pixels
    from tambour.knit.sheets.pages import Words, booklet

    p = piece.params
    told = tuple(line for note in notes(piece.chart, p) for line in ("", *wrap(note, 52)))
    words = Words(title(piece), piece.limit, piece.figures["longest_float"], p.yarn_weight, anchored(piece), told)
    # The cover's picture is small: a quarter of the usual pixels will do.
    shown = front(piece.chart, max(1, pixels(piece.chart, aspect_of(piece.chart)) // 2))
    return booklet(piece.chart, look(piece), words, yarn(piece), shown, p.page, p.large_cells, p.swatch)


def swatch(piece: Piece) -> Drawing:
    """The swatch page."""
    from tambour.knit.sheets.swatch import page
    from tambour.render.page import PAPERS

    sheet = page(piece.chart, look(piece), title(piece), piece.params.yarn_weight, PAPERS[piece.params.page])
    return sheet.drawing(title=f"{title(piece)}: swatch")


def written(piece: Piece) -> Text:
    """Written rows."""
    from tambour.knit.hands.openings import notes
    from tambour.knit.hands.written import pattern as told

    p = piece.params
    return told(
        piece.chart,
        piece.limit,
        yarn(piece),
        p.yarn_weight,
        title(piece),
        anchored(piece),
        dominant(piece),
        piece.repeat[0] if piece.repeat else None,
        p.catch,
        notes(piece.chart, p),
    )


def fabric(piece: Piece) -> Picture:
    """The right side of the cloth."""
    from tambour.knit.sheets.fabric import front

    return front(piece.chart)


def back(piece: Piece) -> Picture:
    """The wrong side with its floats."""
    from tambour.knit.sheets.fabric import back as behind

    return behind(piece.chart, anchored(piece))


def worn(piece: Piece) -> Picture:
    """A yoke or a hat from above. Raises TambourError for a piece that is neither."""
    from tambour.core.errors import TambourError
    from tambour.knit.hands.sizes import GARMENTS
    from tambour.knit.sheets.worn import from_above

    shape = piece.params.shape
    kind = shape if shape in ("yoke", "hat") else "hat" if piece.chart.circular else ""
    if not kind:
        raise TambourError("only what is knitted round can be worn so", hint="{--shape} yoke or hat", where="{--shape}")
    if piece.repeat is None:
        round_ = piece.chart.shape[1] * (100 / piece.chart.gauge.stitches if piece.chart.gauge else 4.5)
    else:
        round_ = 10 * GARMENTS[kind][2][1]
    return from_above(piece.chart, round_, piece.params.yarn_weight, kind == "yoke")


def tiled(piece: Piece) -> Picture:
    """The motif as a hat, a mitten and a yoke would have it, tiled about each."""
    from tambour.knit.sheets.tiled import garments

    return garments(piece.chart, piece.repeat[0] if piece.repeat else None, piece.params.yarn_weight)


def distance(piece: Piece) -> Drawing:
    """Source, target and cloth, as seen from afar."""
    from tambour.knit.sheets.distance import distance as seen

    return seen(piece.chart, piece.picture, piece.tone, piece.params.light == "linear")


def floats(piece: Piece) -> Drawing:
    """The floats behind the stitches, the longer the redder."""
    from tambour.knit.sheets.draw import float_sheet

    return float_sheet(piece.chart, look(piece), title(piece))


def card(piece: Piece) -> Drawing:
    """The machine's card. Raises TambourError without ``machine``."""
    from tambour.core.errors import TambourError
    from tambour.knit.sheets.setup import card as printed

    if piece.params.machine is None:
        raise TambourError("the card is for a machine: say which", hint="{--machine} kh930-ayab", where="{--machine}")
    return printed(piece.chart, piece.params.machine, anchored(piece), title(piece), piece.params.catch or piece.limit)


def punchcard(piece: Piece) -> Drawing:
    """The 24-stitch card at true size."""
    from tambour.knit.sheets.punchcard import card as punched

    brand = piece.params.punch_card
    if piece.params.machine in ("brother-card", "silver-reed-card"):
        brand = "brother" if piece.params.machine == "brother-card" else "silver-reed"
    return punched(piece.chart, brand, piece.params.mirror_card)


def knitout(piece: Piece) -> Text:
    """Knitout; floats above the limit are tucked where hands would catch them."""
    from tambour.knit.hands.working import catches
    from tambour.knit.machines.knitout import DIALECTS, told

    machine = piece.params.machine if piece.params.machine in DIALECTS else ""
    marks = catches(piece.chart, piece.params.catch or piece.limit, anchored(piece))
    return told(piece.chart, machine or "", marks if marks.any() else None)


def hookups(piece: Piece) -> Text:
    """Where long floats are lifted onto needles."""
    from tambour.knit.machines.limits import hookups as listed

    return listed(piece.chart, piece.params.catch or piece.limit, anchored(piece), f"{title(piece)}: hook-ups")


def separated(piece: Piece) -> Chart:
    """A line for each yarn of each row."""
    from tambour.knit.machines.limits import separated as parted

    return parted(piece.chart)


def disk(piece: Piece) -> Disk:
    """A Brother machine's disk; jacquard with a line for each yarn of each row."""
    from tambour.core.chart import Disk
    from tambour.knit.machines.limits import separated as parted

    chart = parted(piece.chart) if piece.chart.technique == "jacquard" else piece.chart
    return Disk(chart, 2 if piece.params.machine == "kh930-disk" else 32)


def silverknit(piece: Piece) -> Text:
    """SilverKnit text."""
    from tambour.knit.machines.interchange import silverknit as told

    return told(piece.chart)


def dak(piece: Piece) -> Text:
    """DesignaKnit text."""
    from tambour.knit.machines.interchange import dak as told

    return told(piece.chart, title(piece), piece.params.yarn_weight)


VIEWS: dict[str, View] = {
    "stitches": View(
        stitches,
        "Chart",
        "one pixel per stitch, upright, unmirrored",
        (".png", ".csv"),
    ),
    "disk": View(
        disk, "Disk", "a Brother machine's disk: KH-940, or KH-930 where {--machine} says so", (".img", ".dat")
    ),
    "project": View(project, "dict", "everything, lossless: can be read back", (".json",)),
    "chart": View(chart, "Drawing", "the chart on one sheet, numbers and signs as knitters draw it", (".svg",)),
    "pattern": View(pattern, "Drawing", "the printed pattern: cover, chart in tiles, floats to catch", (".pdf",)),
    "written": View(written, "Text", "written rows", (".txt", ".md")),
    "fabric": View(fabric, "Picture", "the knitted right side", (".jpg", ".jpeg", ".webp")),
    "back": View(back, "Picture", "the wrong side with its floats"),
    "worn": View(worn, "Picture", "a yoke or a hat from above, the rounds laid about the neck"),
    "tiled": View(tiled, "Picture", "the motif tiled on a hat, a mitten and a yoke"),
    "distance": View(distance, "Drawing", "source and knitting side by side, as seen from afar"),
    "floats": View(floats, "Drawing", "the floats marked on the chart"),
    "swatch": View(swatch, "Drawing", "two windows to knit first, and the card to measure them"),
    "card": View(card, "Drawing", "how to set up {--machine}"),
    "punchcard": View(punchcard, "Drawing", "a 24-stitch punch card at true size"),
    "hookups": View(hookups, "Text", "where long floats are lifted onto a machine's needles, row by row"),
    "separated": View(separated, "Chart", "jacquard, a line for each yarn of each row"),
    "knitout": View(knitout, "Text", "knitout, in the dialect of {--machine}", (".k", ".knitout")),
    "silverknit": View(silverknit, "Text", "text for SilverKnit"),
    "dak": View(dak, "Text", "text for DesignaKnit and Kniterate"),
    "curves": View(
        Lazy("tambour.knit.curves:curves"),
        "Scene",
        "the stitches as loops of yarn in space, for look development",
        (".usdc", ".usda", ".usd"),
    ),
    "live": View(Lazy("tambour.knit.live:live"), "Packed", "the chart and its masks, for screens", (".pack",)),
    "steps": View(Lazy("tambour.knit.live:steps"), "dict", "the rows in the order of work, as data"),
}


def facts(piece: Piece) -> dict[str, Any]:
    """Yarn per colour, catches and ladders, or bobbins, for the report."""
    from tambour.knit.hands.bobbins import bobbins, most
    from tambour.knit.hands.sizes import table
    from tambour.knit.hands.working import catches, ladders, longest_span, roles
    from tambour.knit.hands.written import color_name

    names, catch = roles(piece.chart), piece.params.catch or piece.limit
    marks = catches(piece.chart, catch, anchored(piece))
    told: dict[str, Any] = {}
    if piece.repeat and piece.chart.gauge:
        told["sizes"] = {
            garment: {size: stitches for size, _, stitches, _ in rows}
            for garment, rows in table(piece.chart.gauge, piece.repeat).items()
        }
    if piece.chart.technique == "intarsia":
        told = {"bobbins": len(bobbins(piece.chart)), "most_bobbins": most(piece.chart)[0]}
    return {
        "yarn": [
            {
                "role": names[a.color],
                "name": color_name(piece.chart, a.color),
                "stitches": a.stitches,
                "metres": round(a.metres, 1),
                "yards": round(a.yards, 1),
                "grams": round(a.grams, 1),
                "skeins": a.skeins,
            }
            for a in yarn(piece)
        ],
        **told,
        "catches": int(marks.sum()),
        "longest_span": longest_span(piece.chart, catch, marks, anchored(piece)),
        "ladders": len(ladders(piece.chart, catch, anchored(piece))),
    }
