"""Small faults, planted one at a time in a copy of the sources, each against the test files that should find it.

    python tests/planted.py [--jobs N] [words of a path …]

A fault that lives says that something is promised and nobody looks. Prints every fault that lived, and every one whose
text is no longer in the sources; leaves with 1 if there are any. Minutes, and no part of the suite.
"""

from __future__ import annotations

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from concurrent.futures import ThreadPoolExecutor
from pathlib import Path
from typing import NamedTuple

ROOT = Path(__file__).resolve().parent.parent


class Fault(NamedTuple):
    """In ``file`` (under src/tambour) the one place ``good`` becomes ``bad``; ``tests``: files and words for -k."""

    file: str
    good: str
    bad: str
    tests: str


P = "promises"
FAULTS = [
    # -- found alive by hand, once
    Fault("embroidery/columns/stroke.py", "width / 2, -float(turns[bounds[k]])", "width / 2, float(turns[bounds[k]])", P),
    Fault("embroidery/columns/stroke.py", "np.minimum(half, 1 / np", "np.minimum(half, 2 / np", P),
    Fault("embroidery/plan/order.py", "keep[pairs] = [", "keep[:] = [False] * len(keep); keep[pairs] = [", P),
    Fault("embroidery/plan/facts.py", "SLACK = 0.05", "SLACK = 0.5", P),
    Fault("files/svg/path.py", "1 if large != sweep else -1", "-1 if large != sweep else 1", "files_svg_read -k arcs"),
    Fault("files/svg/path.py", "elif not sweep and sweep_angle > 0:", "elif not sweep and sweep_angle > 9:",
          "files_svg_read -k arcs"),
    Fault("files/exp.py", "row[trim, 2] = 0x80, 0x07", "row[trim, 2] = 0x80, 0x00", P),
    Fault("core/params.py", '"pt": 25.4 / 72', '"pt": 25.4 / 96', P),
    Fault("crochet/graph/check.py", 'last.name in ("slst", "join", "fo")', 'last.name in ("fo",)', P),
    Fault("crochet/graph/check.py", "largest = max(said)", "largest = min(said)", P),
    Fault("crochet/page/flow.py", "(0.0 if chunk.first else AGAIN)", "0.0", P),
    Fault("crochet/finish/sewing.py", "math.sin(a) * np.cross(n, ahead)", "math.sin(a) * np.cross(ahead, n)", P),
    Fault("ink/plotter/sheet.py", " or height - params.margin > high:", ":", P),
    Fault("crochet/maker/materials.py", "ends = TAIL *", "ends = 0.0 *", P),
    Fault("crochet/printed/heads.py", "n > 100_000 for n", "n > 10**12 for n", P),
    Fault("color.py", "far = 0.25 * (lab[:, 0] - w[0]) ** 2 + (chroma - c) ** 2 + 4 * hue",
          "far = 4 * (lab[:, 0] - w[0]) ** 2 + (chroma - c) ** 2 + 0.25 * hue", P),
    Fault("render/light.py", "turn = azimuth - 0.75", "turn = azimuth + 0.75", P),
    # -- issue 20's items, one after the other: full disks, all or none, reports and streams, budgets, raw exceptions, terminals, idle options
    Fault("files/sink.py", "if os.fstat(number).st_size != self._end:", "if False:", "files_sink -k did_not_take_all"),
    Fault("files/picture.py", "sink.put(made.getvalue())", "sink.path.write_bytes(made.getvalue())", "house -k through_the_sink"),
    Fault("files/sink.py", "if f.moved:\n                        _back(f)", "if False:\n                        _back(f)", "files_sink -k puts_everything_back"),
    Fault("files/sink.py", "Path(os.path.realpath(path) if path.is_symlink() else path)", "Path(path)", "files_sink -k modes_links"),
    Fault("files/sink.py", "shutil.copymode(place, made)", "pass", "files_sink -k modes_links"),
    Fault("files/sink.py", "whole = stat.S_ISREG(mode)", "whole = True", "files_sink -k modes_links"),
    Fault("files/sink.py", "        sweep(parent)\n", "", "files_sink -k dead or changed_since"),
    Fault("files/sink.py", "if place.is_symlink():  # a ring of links", "if False:", "files_sink -k ring"),
    Fault("cli/process.py", 'for n in ("SIGTERM", "SIGHUP")', 'for n in ("SIGHUP",)', "files_sink -k kill_at"),
    Fault("run.py", "        if report is not None:\n            with refused", "        writing.commit()\n        if report is not None:\n            with refused", "run -k takes_the_files_with_it"),
    Fault("cli/process.py", 'if "-" in to or len(to) > 1:', "if False:", "cli -k standard_output"),
    Fault("cli/__init__.py", "told = \"cannot be printed\" if error.filename is None else", "told = \"\" if error.filename is None else", "cli -k streams"),
    Fault("files/gltf.py", "depth > 500 or visited > _MOST_NODES", "depth > 500", "files_bounds files_mesh"),
    Fault("files/gltf.py", "0 <= count <= _MOST_VALUES", "0 <= count", "files_bounds files_mesh"),
    Fault("files/svg/groups.py", "n = name, self.known.get(name, 0)", "n = name, 0", "files_svg_read -k small_files"),
    Fault("files/knitout.py", 'not re.fullmatch(r"[-+]?(\\d+\\.?\\d*|\\.\\d+)", arguments[0])', "False", "knit_knitout -k rack"),
    Fault("core/errors.py", 'return "holds a control character"', 'return ""', "params run -k bad_values or names_that"),
    Fault("core/errors.py", 'return "holds bytes that are no text"', 'return ""', "params run -k bad_values or names_that"),
    Fault("files/text.py", "lines = [escape(line", "lines = [str(line", "errors -k html"),
    Fault("sweep/folder.py", "if text[:1] in FORMULA", "if False", "sweep -k formula"),
    Fault("core/params.py", "if unmet and self.said((name,))", "if False and self.said((name,))", "params -k no_effect"),
    # -- the house
    Fault("color.py", "srgb <= 0.04045, srgb / 12.92", "srgb <= 0.04045, srgb / 12.0", "color"),
    Fault("color.py", "(1 / 2.4) - 0.055", "(1 / 2.2) - 0.055", "color"),
    Fault("core/params.py", '"min": 60.0', '"min": 6.0', P),
    Fault("core/errors.py", 'self.text.count("\\n", 0, offset) + 1', 'self.text.count("\\n", 0, offset)', "errors"),
    Fault("files/mesh.py", "if size < 0:", "if size < -9:", "files_bounds -k back"),
    Fault("files/sequence.py", "if size > MOVING:", "if size < 0:", "files_bounds -k npz"),
    Fault("files/document.py", "if self._shown > _MOST:", "if self._shown < 0:", "files_bounds -k shown"),
    Fault("files/document.py", "if _deeper(body):", "if not body:", "files_bounds -k odt"),
    Fault("files/document.py", 'text.rfind(">") + 1', "len(text)", "files_bounds -k open"),
    Fault("files/document.py", "found[1].decode(\"ascii\") if found and _CODES.fullmatch(found[1])", "found[1].decode(\"ascii\") if found", "files_bounds -k character"),
    Fault("files/printed_pdf.py", "and wide * tall <= _PIXELS", "", "files_bounds -k claims_any"),
    Fault("files/apart.py", "resource.setrlimit(what, (most", "(lambda *_: None)(what, (most", "files_bounds -k printed_pdf"),
    Fault("files/usd.py", "counts.sum(dtype=np.int64) != len(index)", "False", "files_bounds -k usd"),
    Fault("files/usd.py", "if size > MOVING:", "if size < 0:", "files_bounds -k usd"),
    Fault("files/sink.py", "if isinstance(error, BlockingIOError):", "if False:", "files_sink -k sweeping"),
    Fault("files/packed.py", "if held > len(raw):", "if held < 0:", "files_bounds -k pack"),
    Fault("files/records.py", "usual = float(np.quantile(long, 0.99))", "usual = float(long.max())", "files_machine"),
    Fault("files/headers.py", "NEAR = 2", "NEAR = 12", "files_machine -k aside or records"),
    Fault("files/dst.py", "if filled and not off", "if False and not off", "files_machine -k aside"),
    Fault("files/headers.py", "elif len(kept) == len(sewn) and (odd", "elif False and (odd", "files_machine -k changed_byte"),
    Fault("files/headers.py", "if max(map(abs, off)) > 1:", "if max(map(abs, off)) > 9:", "files_machine -k changed_byte"),
    Fault("files/headers.py", "_last(pattern, [x, y]) and _last(pattern, [x, -y])", "False", "files_machine -k changed_byte"),
    Fault("files/headers.py", 'if raw[at + 15 : at + 18] != b"\\x0a\\xf6\\0":', "if False:", "files_machine -k spoilt"),
    Fault("files/headers.py", "if any(raw[_SEW - 8 : _SEW]):", "if False:", "files_machine -k sew"),
    Fault("crochet/printed/parts/reworked.py", "if number + total > MOST_ROUNDS:", "if number < 0:", "crochet_bounds -k double"),
    Fault("crochet/printed/parts/reworked.py", "((line,) if line.again is None else line.rounds())", "(line,)", "crochet_bounds -k however_many"),
    Fault("crochet/language/finishes.py", "int(number) <= copies", "int(number) < copies", "crochet_places crochet_placing crochet_bounds"),
    Fault("core/errors.py", "cutoff=0.65", "cutoff=0.99", "errors cli"),
    Fault("core/chart.py", "return 100.0 / self.stitches", "return 10.0 / self.stitches", "values knit_yarns knit_craft"),
    Fault("core/check.py", "made[-1] != total or ", "", "values"),
    Fault("core/mesh.py", 'within("Mesh.vertices", vertices, -FARTHEST, FARTHEST + 1)', "pass", "values files_mesh"),
    Fault("core/graph.py", "self.edge_kind == YARN", "self.edge_kind != YARN", "promises"),
    Fault("geometry/surface.py", "where=length > 0", "where=length > 1", P),
    Fault("render/camera.py", "MARGIN = 0.86", "MARGIN = 1.3", "render_raster"),
    Fault("render/camera.py", "np.array([cos(azimuth), 0.0, -sin(azimuth)])",
          "np.array([cos(azimuth), 0.0, sin(azimuth)])", "promises render_raster"),
    # -- files
    Fault("files/hpgl.py", "(1.0, -1.0) + (0.0, float(drawing.size[1]))", "(1.0, 1.0)", "ink_files ink_plot files"),
    Fault("files/hpgl.py", "UNITS = 40.0", "UNITS = 39.0", "ink_files ink_plot files"),
    Fault("files/dst.py", "half = (weight - 1) // 2", "half = (weight + 1) // 2", "files_machine"),
    Fault("files/exp.py", "row[:, 3] = (-delta[:, 1])", "row[:, 3] = (delta[:, 1])", "promises"),
    Fault("files/svg/css.py", '"mm": 96 / 25.4', '"mm": 90 / 25.4', "files_svg_read"),
    Fault("files/svg/css.py", "value *= em / 2", "value *= em", "promises files_svg_read"),
    Fault("files/svg/css.py", 'way = above.here if compound.before == ">" else above.above', "way = above.above",
          "files_svg_read"),
    Fault("files/svg/css.py", "key=lambda r: r.weight", "key=lambda r: (0, 0, 0)", "files_svg_read"),
    Fault("files/svg/groups.py", "unique = f\"{name}-{n}\"", "unique = f\"{name}{n}\"", "files_svg_read"),
    Fault("files/svg/path.py", "sx = sy = max(sx, sy) if", "sx = sy = min(sx, sy) if", "promises files_svg_read"),
    Fault("knit/machines/knitout.py", "way = first if row % 2 == 0 else other(first)\n        columns", "way = first\n        columns", "knit_knitout"),
    Fault("files/mesh.py", 'f"{k / 255:.4f}"', 'f"{k / 256:.4f}"', "files_mesh"),
    # -- crochet
    Fault("crochet/yarn/course.py", "k = a + 1\n", "k = a + 2\n", "crochet_fabric"),
    Fault("crochet/yarn/course.py", "k = int(after[a])", "k = int(a)", "crochet_fabric"),
    Fault("crochet/yarn/course.py", "slip_of *= np.clip(", "slip_of *= 0 * np.clip(", "crochet_fabric"),
    Fault("crochet/yarn/loops.py", "(0.166, 0.021, 0.063)", "(0.166, 0.091, 0.063)", "crochet_fabric"),
    Fault("crochet/piece.py", "MIRROR: Final = (-1.0, 1.0, 1.0)", "MIRROR: Final = (-1.0, 1.0, -1.0)", "crochet_specimens"),
    Fault("crochet/plush.py", "faces=graph.faces[:, ::-1].copy()", "faces=graph.faces.copy()", "crochet_specimens"),
    Fault("crochet/yarns.py", "IN_A_STITCH: Final = 8.0", "IN_A_STITCH: Final = 9.0", "crochet_size"),
    Fault("crochet/yarns.py", "SQUARE: Final = 3.0 / math.pi", "SQUARE: Final = 1.0", P),
    Fault("crochet/yarns.py", "0.15 + 0.85 * hook / kind.hook", "0.85 * hook / kind.hook",
          "crochet_size -k yarn or hook or expected or gauge"),
    Fault("crochet/yarns.py", '"E": 3.5', '"E": 3.25', "crochet_size -k hook"),
    Fault("crochet/yarns.py", '"8-ply": "dk"', '"8-ply": "sport"', "promises crochet_size -k class or yarn or weight"),
    Fault("crochet/maker/materials.py", "grams = bought / metres_100_g * 100.0", "grams = bought / metres_100_g * 50.0",
          P),
    Fault("crochet/maker/materials.py", "max(1, ceil(grams / skein))", "max(1, int(grams / skein))",
          P),
    Fault("crochet/graph/check.py", "NEAR = 0.2", "NEAR = 0.6", "crochet_check promises -k size or sizes"),
    Fault("color.py", '(40, "orange")', '(40, "yellow")', "promises crochet_instructions -k hue or plain"),
    Fault("crochet/language/stitches.py", '"tr": 4, "dtr": 5', '"tr": 5, "dtr": 4', P),
    Fault("crochet/words/spellings.py", "'' if n == 2 else n", "n", "crochet_terms"),
    Fault("crochet/words/us.toml", 'skip = ["sk", "skip"]', 'skip = ["sc", "skip"]', "crochet_terms"),
    Fault("crochet/words/de.toml", "{count} fM in Fadenring", "{count} fM im Fadenring ({count})", "crochet_terms"),
    Fault("crochet/words/table.py", "made = dict(base)", "made = {}",
          "crochet_terms"),
    Fault("crochet/printed/rounds/counts.py", "return (2 if token.value", "return (3 if token.value", "crochet_reading promises"),
    Fault("crochet/printed/rounds/counts.py", 'raise NotUnderstood(token, "a repeat is worked at least once"',
          'return 1, token.span\n        raise NotUnderstood(token, "a repeat is worked at least once"', "promises crochet_reading"),
    Fault("crochet/printed/cursor.py", '"{": "}", ', "", "promises"),
    Fault("crochet/page/written.py", "times=before.times + 1", "times=before.times + 2", "crochet_write"),
    Fault("crochet/page/symbols.py", 'side = 0.22 if kind.startswith("fp")', 'side = -0.22 if kind.startswith("fp")',
          "promises crochet_diagram"),
    Fault("crochet/language/items.py", "if times == 0 and times_at is not None:", "if times == -1:", "crochet_parse"),
    Fault("crochet/looks.py", "DOUBT: Final = (206, 42, 38)", "DOUBT: Final = (228, 224, 216)",
          "promises crochet_check -k red or pale or view"),
    # -- the other crafts
    Fault("render/page.py", '"a3": (297.0, 420.0)', '"a3": (279.0, 420.0)', P),
    Fault("knit/hands/yarn.py", "metres / 0.9144", "metres * 0.9144", "promises knit_hand knit_yarns -k yard or amount or yarn"),
    Fault("knit/hands/yarn.py", "max(1, ceil(grams / skein_grams))", "max(1, int(grams / skein_grams))",
          "promises knit_hand -k skein or amount or yarn"),
    Fault("knit/solve/floats.py", "found = floor(length(params.max_float) / gauge.width + 1e-9)", "found = floor(length(params.max_float) / gauge.width + 1)", "promises knit_floats knit_craft -k limit or float"),
    Fault("knit/sheets/punchcard.py", "PITCH, ROW = 4.5, 5.0", "PITCH, ROW = 4.6, 5.0", "knit_formats -k card"),
    Fault("embroidery/plan/sequence.py", "TIE = 0.7", "TIE = 2.7", "promises embroidery_make embroidery_thread"),
    Fault("embroidery/plan/facts.py", "COLOR: 45.0, STOP", "COLOR: 450.0, STOP", "promises embroidery_make"),
]  # fmt: skip


def planted(fault: Fault, tree: Path) -> str:
    """ "killed", "alive" or "gone": what became of a fault in the copy ``tree``."""
    path = tree / "src" / "tambour" / fault.file
    text = path.read_text(encoding="utf-8")
    if text.count(fault.good) != 1:
        return "gone"
    names, _, words = fault.tests.partition(" -k ")
    files = [f"tests/test_{name}.py" for name in names.split()]
    chosen = ["-k", words] if words else []
    before = path.stat()
    path.write_text(text.replace(fault.good, fault.bad), encoding="utf-8")
    try:
        env = os.environ | {"PYTHONPATH": str(tree / "src"), "PYTHONDONTWRITEBYTECODE": "1"}
        # Every file by itself: a word for -k that fits one of them need not fit the others. Slow tests only where the quick ones say nothing.
        for file, kind in [(file, kind) for kind in ("not slow", "slow") for file in files]:
            command = [
                sys.executable,
                "-m",
                "pytest",
                "-x",
                "-q",
                "-p",
                "no:cacheprovider",
                "-m",
                kind,
                file,
                *chosen,
            ]
            made = subprocess.run(command, cwd=tree, env=env, capture_output=True, text=True)
            if made.returncode not in (0, 5):
                return "killed"
        return "alive"
    finally:
        path.write_text(text, encoding="utf-8")
        os.utime(path, ns=(before.st_atime_ns, before.st_mtime_ns))  # kernels are kept by the time of their source


def main() -> int:
    """All faults, or those whose file holds one of the words."""
    asked = argparse.ArgumentParser(description=__doc__)
    asked.add_argument("--jobs", type=int, default=1, help="copies that are worked at once")
    asked.add_argument("words", nargs="*")
    args = asked.parse_args()
    faults = [f for f in FAULTS if not args.words or any(w in f.file for w in args.words)]
    with tempfile.TemporaryDirectory() as place:
        trees = [Path(place) / str(k) for k in range(args.jobs)]
        for tree in trees:
            for name in ("src", "tests", "examples", "docs"):
                shutil.copytree(ROOT / name, tree / name)
            for name in ("pyproject.toml", "README.md"):
                shutil.copy2(ROOT / name, tree / name)

        def work(k: int) -> list[tuple[str, Fault]]:
            made = []
            for fault in faults[k :: args.jobs]:
                made.append((planted(fault, trees[k]), fault))
                print(f"{made[-1][0]:7} {fault.file}: {fault.good.strip()[:70]}", flush=True)
            return made

        with ThreadPoolExecutor(args.jobs) as pool:
            found = [one for made in pool.map(work, range(args.jobs)) for one in made]
    left = [(how, fault) for how, fault in found if how != "killed"]
    print(f"{len(found)} faults planted, {len(found) - len(left)} found out")
    for how, fault in left:
        print(f"{how}: {fault.file}: {fault.good!r} -> {fault.bad!r} ({fault.tests})")
    return 1 if left else 0


if __name__ == "__main__":
    sys.exit(main())
