"""What a piece can be looked at as, and made into: views, each loading its room on first use."""

from __future__ import annotations

from tambour.craft import Lazy, View

_MACHINE = (".dst", ".pes", ".pec", ".exp", ".jef", ".vp3", ".xxx", ".u01", ".tbf", ".sew")

VIEWS: dict[str, View] = {
    "machine": View(
        Lazy("tambour.embroidery.looks.scene:machine"), "ThreadPlan", "for the embroidery machine", _MACHINE
    ),
    "preview": View(
        Lazy("tambour.embroidery.looks.scene:preview"),
        "Picture",
        "thread on cloth, from above",
        (".png", ".jpg", ".jpeg", ".webp"),
    ),
    "lines": View(
        Lazy("tambour.embroidery.looks.draw:stitch_lines"), "Drawing", "the needle's way as lines", (".svg",)
    ),
    "worksheet": View(
        Lazy("tambour.embroidery.looks.worksheet:worksheet"),
        "Drawing",
        "pages to work from: true size, colours, stops",
        (".pdf",),
    ),
    "cloth": View(
        Lazy("tambour.embroidery.looks.scene:scene"),
        "Scene",
        "thread in space on its cloth",
        (".glb", ".usdc", ".usda", ".usd", ".obj", ".npz"),
        "bind",
    ),
    "check": View(Lazy("tambour.embroidery.looks.scene:check"), "Picture", "the preview, red where it is too full"),
    "density": View(Lazy("tambour.embroidery.looks.scene:density"), "Picture", "how much thread lies where"),
    "simulate": View(Lazy("tambour.embroidery.looks.scene:simulate"), "Pictures", "the needle at work", (".gif",)),
    "stitches": View(
        Lazy("tambour.embroidery.looks.draw:stitch_table"), "dict", "every needle point as data", (".json",)
    ),
    "live": View(
        Lazy("tambour.embroidery.live:live"), "Packed", "the thread in the order of sewing, for screens", (".pack",)
    ),
    "steps": View(Lazy("tambour.embroidery.live:steps"), "dict", "what is sewn between two stops, as data"),
}
