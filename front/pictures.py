"""Pictures of the shelf's examples: what is seen before they move. Run ``python front/pictures.py`` when they look otherwise."""

import io
from pathlib import Path

from PIL import Image

from tambour.run import craft, make
from tambour.studio.pieces import EXAMPLES
from tambour.work.thumbs import thumb

TO = Path(__file__).parents[1] / "src" / "tambour" / "studio" / "web" / "pictures"
EXAMPLE_FILES = Path(__file__).parents[1] / "examples"


def main() -> None:
    """One for each craft, of the example that stands first."""
    for name, listed in EXAMPLES.items():
        _, called, values = listed[0]
        what = craft(name)
        given = {"seed": called, **values} if name == "ink" else values
        source = None if name == "ink" else EXAMPLE_FILES / name / called
        raw = thumb(name, make(what, source, what.params.of(given)).piece)
        small = TO / f"{name}.webp"
        Image.open(io.BytesIO(raw)).save(small, quality=50, method=6)  # the page is to weigh little
        print(f"{name}: {small.stat().st_size:,} bytes")


if __name__ == "__main__":
    main()
