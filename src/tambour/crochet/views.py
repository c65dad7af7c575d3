"""Views: what can be made of a piece, a table; nothing is loaded before its view is asked for."""

from __future__ import annotations

from tambour.craft import Lazy, View

VIEWS: dict[str, View] = {
    "yarn": View(
        Lazy("tambour.crochet.looks:yarn"),
        "Mesh",
        "the piece in its yarn",
        (".glb", ".obj", ".ply", ".stl"),
        "fabric",
    ),
    "curves": View(
        Lazy("tambour.crochet.curves:curves"),
        "Scene",
        "the yarn as curves, for look development",
        (".usdc", ".usda", ".usd"),
        "fabric",
    ),
    "toy": View(
        Lazy("tambour.crochet.handed:whole"),
        "Picture",
        "the toy put together, in its yarn, as one looks at it; what belongs nowhere on it left out",
        (".png", ".jpg"),
        "fabric",
    ),
    "check": View(
        Lazy("tambour.crochet.looks:checked"),
        "Mesh",
        "the piece in pale yarn, in red what {--check} would doubt",
        stage="fabric",
    ),
    "photo": View(
        Lazy("tambour.crochet.handed:photo"),
        "Picture",
        "the toy as a camera would take it: soft light, every fibre; slow",
        stage="photo",
    ),
    **{
        side: View(
            Lazy(f"tambour.crochet.handed:{side}"),
            "Picture",
            f"the piece in its yarn, from {side if side == 'below' else f'the {side}'}",
        )
        for side in ("front", "back", "left", "right", "top", "below")
    },
    "surface": View(
        Lazy("tambour.crochet.looks:surface"),
        "Mesh",
        "the fabric as a surface, closed where the piece is",
        stage="fabric",
    ),
    "compare": View(
        Lazy("tambour.crochet.model.compare:compare"),
        "Picture",
        "of a model's pattern: the plush coloured by how far it lies from the model, and the model as a ghost about it",
        stage="fabric",
    ),
    "making": View(
        Lazy("tambour.crochet.making:making"),
        "Pictures",
        "the piece growing stitch by stitch in its yarn: a film (.mp4 needs PyAV: pip install av), or its pictures",
        (".mp4", ".gif", ".png"),
        "film",
    ),
    "specimens": View(
        Lazy("tambour.crochet.swatches:sheet"),
        "Drawing",
        "a sheet of stitches, each a small piece with its name",
    ),
    "diagram": View(Lazy("tambour.crochet.page.diagram:view"), "Drawing", "a chart in the usual symbols", (".svg",)),
    "page": View(
        Lazy("tambour.crochet.page.booklet:pages"), "Drawing", "the pattern as a booklet to sell", (".pdf",), "page"
    ),
    "pattern": View(
        Lazy("tambour.crochet.page.own:view"), "Text", "the pattern written back in tambour's own language", (".acl",)
    ),
    "instructions": View(
        Lazy("tambour.crochet.page.instructions:view"),
        "Text",
        "the pattern as makers print it, in the words of {--terms}",
        (".md",),
    ),
    "plain": View(Lazy("tambour.crochet.page.instructions:plain"), "Text", "the same as plain text", (".txt",)),
    "source": View(
        Lazy("tambour.crochet.model.reshape:source"),
        "Text",
        "the pattern's own text, with what was redrawn ({--reshape})",
    ),
    "outline": View(
        Lazy("tambour.crochet.model.profile:view"),
        "Drawing",
        "half the outline of every part, to be redrawn for {--reshape}",
    ),
    "annotated": View(
        Lazy("tambour.crochet.page.annotated:view"),
        "Text",
        "the pattern's own text with its counts ticked, doubts under their lines, pictures beside the parts",
    ),
    "graph": View(Lazy("tambour.crochet.looks:graph"), "dict", "the stitch graph and its shape as data", (".json",)),
    "live": View(
        Lazy("tambour.crochet.live:live"), "Packed", "the yarn in the order of work, for screens", (".pack",), "fabric"
    ),
    "steps": View(Lazy("tambour.crochet.live:steps"), "dict", "the rounds in the order of work, as data"),
}
