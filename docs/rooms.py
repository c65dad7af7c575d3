"""Write docs/rooms.md, every module with its first line: ``make docs``. A test refuses a list that is not true."""

from __future__ import annotations

import ast
from pathlib import Path

HERE = Path(__file__).parent
SOURCE = HERE.parent / "src" / "tambour"
FLOORS = [
    "core",
    "noise",
    "color",
    "geometry",
    "render",
    "craft",
    "crochet",
    "knit",
    "ink",
    "embroidery",
    "files",
    "run",
    "cli",
]


def text() -> str:
    """The page."""
    lines = [
        "# Rooms",
        "",
        "Every module and its one thought, floor by floor. `make docs` writes this page from the modules themselves.",
    ]
    for floor in FLOORS:
        folder = SOURCE / floor
        modules = sorted(folder.glob("*.py")) if folder.is_dir() else [SOURCE / f"{floor}.py"]
        lines += ["", f"## {floor}", "", "| module | what it holds |", "|---|---|"]
        for path in modules:
            said = ast.get_docstring(ast.parse(path.read_text())) or ""
            first = " ".join(said.split("\n\n")[0].split()).replace("|", "\\|")
            name = "" if path.name == "__init__.py" else f"/{path.name}" if folder.is_dir() else ".py"
            lines.append(f"| `{floor}{name}` | {first} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    (HERE / "rooms.md").write_text(text())
