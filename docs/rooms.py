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
    "weights",
    "render",
    "craft",
    "crochet",
    "knit",
    "ink",
    "embroidery",
    "files",
    "run",
    "examples",
    "work",
    "sweep",
    "tiles",
    "studio",
    "cli",
]


def _inside(folder: Path) -> list[Path]:
    """The modules of a folder, then its rooms, each followed by what is in it."""
    modules = [p for p in sorted(folder.glob("*.py")) if p.name != "__init__.py"]
    rooms = sorted(p.parent for p in folder.glob("*/__init__.py"))
    return modules + [p for room in rooms for p in (room, *_inside(room))]


def _thought(path: Path) -> str:
    """The first paragraph of what a module, or a room, says of itself."""
    said = ast.get_docstring(ast.parse((path / "__init__.py" if path.is_dir() else path).read_text())) or ""
    return " ".join(said.split("\n\n")[0].split()).replace("|", "\\|")


def text() -> str:
    """The page."""
    lines = [
        "# Rooms",
        "",
        "Every module and its one thought, floor by floor. `make docs` writes this page from the modules themselves.",
    ]
    for floor in FLOORS:
        folder = SOURCE / floor
        lines += ["", f"## {floor}", "", "| module | what it holds |", "|---|---|"]
        for path in [folder, *_inside(folder)] if folder.is_dir() else [SOURCE / f"{floor}.py"]:
            name = path.relative_to(SOURCE).as_posix()
            lines.append(f"| `{name}{'/' if path.is_dir() else ''}` | {_thought(path)} |")
    return "\n".join(lines) + "\n"


if __name__ == "__main__":
    (HERE / "rooms.md").write_text(text())
