"""Draws sampler.svg: a square of every family of stitches, with its name below.

python examples/embroidery/sampler.py > examples/embroidery/sampler.svg
"""

from __future__ import annotations

SIZE, GAP, COLUMNS = 24, 8, 5
PATCH = "M0 3C4-1 10 2 13 0S22 0 24 5C25 10 22 14 24 19S19 25 13 23S3 26 1 20S-2 8 0 3Z M9 9C11 7 15 8 15 11S11 16 9 14S7 11 9 9Z"
LEAF = "M1 22C-1 10 8 0 23 1C24 14 14 24 1 22Z"
LINES = "M0 4C6-2 12 10 24 4 M0 12C6 6 12 18 24 12 M0 20C6 14 12 26 24 20"
COLORS = ("#1f4e79", "#8c2f39", "#3f6b3a", "#b5651d", "#5b3a82")

AREAS = ("tatami", "contour", "spiral", "radial", "guided", "flow", "meander", "ripple", "gradient", "cross")
TUNED = {"meander": ' data-tambour-motif-size="1.4mm"', "cross": ' data-tambour-motif-size="3mm"'}


def group(name: str, number: int, body: str) -> str:
    """One labelled square."""
    x, y = GAP + number % COLUMNS * (SIZE + GAP), GAP + number // COLUMNS * (SIZE + GAP + 5)
    return f'<g id="{name}-square" transform="translate({x} {y})">{body}</g>'


def main() -> None:
    """Print the page."""
    squares = []
    for k, name in enumerate(AREAS):
        guide = (
            '<path data-tambour-role="guide" fill="none" stroke="#999" stroke-width=".2" d="M-2 18C4 4 10 26 26 6"/>'
            if name in ("guided", "flow")
            else ""
        )
        squares.append(
            (
                name,
                f'<path id="{name}" data-tambour-stitch="{name}"{TUNED.get(name, "")} fill-rule="evenodd" fill="{COLORS[k % 5]}" d="{PATCH}"/>{guide}',
            )
        )
    more = len(AREAS)
    line = 'fill="none" stroke="{}" stroke-width="{}"'
    squares += [
        (
            "satin",
            f'<path id="satin" data-tambour-stitch="satin" data-tambour-split="12mm" data-tambour-jagged="0.6mm" fill="{COLORS[0]}" d="{LEAF}"/>',
        ),
        ("column", f'<path id="column" d="{LINES}" {line.format(COLORS[1], 2.2)}/>'),
        ("running", f'<path id="running" d="{LINES}" {line.format(COLORS[2], 0.4)} data-tambour-length="2mm"/>'),
        (
            "bean",
            f'<path id="bean" d="{LINES}" {line.format(COLORS[3], 0.4)} data-tambour-stitch="bean" data-tambour-length="2mm"/>',
        ),
        (
            "motif",
            "".join(
                f'<path id="motif-{m}" d="M0 {4 + 8 * i}C6 {8 * i - 2} 12 {8 * i + 10} 24 {4 + 8 * i}" data-tambour-stitch="motif" data-tambour-motif="{m}" {line.format(COLORS[4], 0.4)}/>'
                for i, m in enumerate(("star", "leaf", "wave"))
            ),
        ),
    ]
    assert len(squares) == more + 5
    width, height = GAP + COLUMNS * (SIZE + GAP), GAP + (len(squares) + COLUMNS - 1) // COLUMNS * (SIZE + GAP + 5)
    print(
        f'<svg xmlns="http://www.w3.org/2000/svg" width="{width}mm" height="{height}mm" viewBox="0 0 {width} {height}">'
    )
    print("<title>Sampler: every family of stitches</title>")
    for k, (name, body) in enumerate(squares):
        print(group(name, k, body))
    print("</svg>")


if __name__ == "__main__":
    main()
