"""Kernels: built, compiled by Numba and plain they are one function; what is stale never runs."""

from __future__ import annotations

import importlib.util
import os
import subprocess
import sys
import textwrap
from pathlib import Path

import pytest

KINDS = """
from __future__ import annotations
import numpy as np
from tambour.core.arrays import B1x1, F4x1, F4x2, F8x1, F8x2, F8x3, I1x1, I4x2, I8x1, I8x2, U1x1, U8x1
from typing import NamedTuple
from tambour.core.kernels import inner, kernel
from tambour.knit.solve.lanes import butterfly

SCALE = 3.0

@kernel
def arrays(a: F8x1, b: F8x2, c: F8x3, d: F4x2, e: I1x1, f: I4x2, g: I8x1, h: U1x1, i: U8x1, j: B1x1) -> float:
    total = a.sum() + b.sum() * 2 + c.sum() * 3 + d.sum() * 4 + e.sum() * 5 + f.sum() * 6 + g.sum() * 7 + h.sum() * 8
    for k in range(len(j)):
        total += i[k] if j[k] else 0.5
    b[0, 1], f[1, 0], j[0] = total, 9, not j[0]
    return total

@kernel
def numbers(x: float, i: int, k: np.uint64, t: bool, s: np.float32) -> tuple[float, int, int, bool]:
    return scaled(x + s), i - 1, k + np.uint64(1), not t

@kernel
def scaled(x):
    return SCALE * x

@kernel
def results(n: int) -> tuple[F8x2, I8x1, B1x1, float]:
    grown = [0]
    for k in range(n):
        grown.append(k * k)
    made = np.arange(2 * n).reshape(n, 2) * 0.5
    return made, np.array(grown), made[:, 0].copy() > 1.0, 0.25

@kernel
def one(n: int) -> I8x2:
    return np.full((n, 3), n)

@kernel
def nothing(a: F8x1) -> None:
    a[:] = np.sqrt(a)

class Sheet(NamedTuple):
    a: F8x1
    k: I8x1
    scale: float

@inner
def under(sheet: Sheet, by: float) -> float:
    return sheet.scale * by

@kernel
def record(x: float, sheet: Sheet, i: int) -> float:
    sheet.k[0] += i
    return under(sheet, x) + sheet.a.sum()

@kernel
def step(V: F4x1, W: F4x1, P: U1x1, U: F4x1, Z: F4x1, i: int, j: int, o: int, x: int, p: int, s: np.float32, t: np.float32) -> None:
    butterfly(V, W, P, U, Z, i, j, o, x, p, s, t)
"""

TRIED = """
import numpy as np, kinds

def same(a, b):
    assert type(a) is type(b) or np.isscalar(a), (a, b)
    if isinstance(a, tuple):
        assert len(a) == len(b)
        [same(x, y) for x, y in zip(a, b)]
    elif isinstance(a, np.ndarray):
        assert a.dtype == b.dtype and a.shape == b.shape and (a == b).all() and a.flags.writeable
    else:
        assert a == b, (a, b)

def both(kernel, *args):
    other = [a.copy() if isinstance(a, np.ndarray) else a for a in args]
    same(kernel(*args), kernel.function(*other))
    [same(a, b) for a, b in zip(args, other)]

kinds.scaled.run = kinds.scaled.function  # kernels alone call it: nothing of it is built by itself
for n in (2, 5):
    given = [np.arange(n) + 0.5, np.ones((n, 2)), np.ones((n, 1, 2)), np.ones((2, n), np.float32)]
    given += [np.arange(n).astype(np.int8), np.ones((2, n), np.int32), np.arange(n), np.arange(n).astype(np.uint8)]
    given += [np.arange(n).astype(np.uint64), np.arange(n) % 2 == 0]
    both(kinds.arrays, *given)
both(kinds.numbers, 2, np.int32(-4), 2**64 - 9, True, 0.5)
assert kinds.numbers(2, -4, 7, False, 0.1)[0] == 3.0 * (2 + float(np.float32(0.1)))
for n in (0, 3, 400):
    both(kinds.results, n)
    both(kinds.one, n)
both(kinds.nothing, np.arange(4.0))
kinds.under.run = kinds.under.function
sheet = kinds.Sheet(np.arange(3.0), np.arange(2), 2)
assert kinds.record(1.5, sheet, 4) == 6.0 and sheet.k[0] == 4
for bad in (sheet[:2], list(sheet), None, (sheet.a, sheet.a, 2.0)):
    try:
        kinds.record(1.5, bad, 4)
    except TypeError as error:
        assert "sheet" in str(error), error
    else:
        raise AssertionError(bad)
# What is written out for the processor by hand, against its plain twin.
kinds.butterfly.run = kinds.butterfly.function
rng = np.random.default_rng(1)
for _ in range(50):
    V, W, U, Z = (rng.choice([*rng.normal(size=6), 1.0, 1e30], n).astype(np.float32) for n in (32, 48, 16, 16))
    P = rng.integers(0, 256, 9).astype(np.uint8)
    both(kinds.step, V, W, P, U, Z, 8, 24, 16, 8, int(rng.integers(0, 8)), *rng.choice([0.0, 0.5, -0.25], 2).astype(np.float32))
kept = [kinds.one(500) for _ in range(200)]
assert all((k == 500).all() for k in kept)
for bad in (np.arange(4), np.ones((2, 2)), np.arange(8.0)[::2], np.arange(4.0, dtype=">f8"), [1.0], None):
    try:
        kinds.nothing(bad)
    except TypeError as error:
        assert "a must be an array of float64 with 1 axis" in str(error), error
    else:
        raise AssertionError(bad)
frozen = np.arange(4.0)
frozen.setflags(write=False)
for words, told in (((frozen,), "a must be an array of float64 with 1 axis, in C order and writable"), ((), "takes 1 arguments, not 0"),
                    ((frozen, 1), "takes 1 arguments, not 2")):
    try:
        kinds.nothing(*words)
    except TypeError as error:
        assert "kinds.nothing: " + told in str(error), error
        continue
    raise AssertionError(words)
# Each array: its type, its axes, its order in memory; each number: its kind. The error names it.
names = "abcdefghij"
for at, name in enumerate(names):
    for wrong in (given[at].astype(np.complex64), given[at][None], given[at][..., ::2], given[at].tolist()):
        if isinstance(wrong, np.ndarray) and wrong.ndim == given[at].ndim and wrong.flags.c_contiguous and wrong.dtype == given[at].dtype:
            continue  # a step over one element
        try:
            kinds.arrays(*[wrong if k == at else x for k, x in enumerate(given)])
        except TypeError as error:
            assert f"kinds.arrays: {name} must be an array of {given[at].dtype}" in str(error), error
        else:
            raise AssertionError((name, wrong))
for at, (name, wrong) in enumerate((("x", "one"), ("i", 0.5), ("k", -1), ("t", np.zeros(2)), ("s", None))):
    try:
        kinds.numbers(*[wrong if k == at else x for k, x in enumerate((2.0, 1, 1, True, 0.5))])
    except TypeError as error:
        assert f"kinds.numbers: {name} must be a " in str(error), error
    else:
        raise AssertionError(name)
from tambour.core.kernels import RAN
assert set(RAN.values()) == {"native"} and len(RAN) == 7, RAN
"""

BUILD = """
import os, sys
from pathlib import Path
root, folder = map(Path, sys.argv[1:])
os.environ |= {"NUMBA_CPU_NAME": "x86-64-v2", "NUMBA_CPU_FEATURES": "", "TAMBOUR_KERNELS": "numba"}
sys.path[:0] = [str(root), str(folder)]
import kinds
from kernels import build, compile
from kernels.glue import Entry
from tambour.core import kernels
kernels.OPTIONS |= compile.BARE
entries = []
for made in (kinds.arrays, kinds.numbers, kinds.results, kinds.one, kinds.nothing, kinds.record, kinds.step):
    code, told = compile.compiled(made)
    entries.append((compile.keep(made, code, told), Entry(digest=kernels.fingerprint(made), **told)))
build._link(entries, folder / "_native.abi3.so")
"""


def _python(code: str, *words: Path | str, **more: str) -> subprocess.CompletedProcess[str]:
    command = [sys.executable, "-c", textwrap.dedent(code), *map(str, words)]
    return subprocess.run(command, capture_output=True, text=True, env=os.environ | more)


@pytest.fixture(scope="module")
def built(root: Path, tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A folder with kernels of every kind of argument and result, and these built."""
    return _built(root, tmp_path_factory.mktemp("kinds"))


def _built(root: Path, folder: Path) -> Path:
    (folder / "kinds.py").write_text(KINDS)
    (folder / "tambour" / "kernels").mkdir(parents=True)
    made = _python(BUILD, root, folder, XDG_CACHE_HOME=str(folder), PYTHONHASHSEED="0")
    assert made.returncode == 0, made.stderr
    return folder


def _tried(built: Path, code: str, **more: str) -> str:
    """What Python says of a program for which the built kernels are those of ``built``."""
    take = f"""
import importlib.util, sys
sys.path.insert(0, {str(built)!r})
from tambour.core import kernels
spec = importlib.util.spec_from_file_location("_native", {str(built / "_native.abi3.so")!r})
native = importlib.util.module_from_spec(spec)
spec.loader.exec_module(native)
kernels._native = lambda: native
"""
    made = _python(take + code, **more)
    return "" if made.returncode == 0 else made.stderr


@pytest.mark.slow
def test_every_kind_of_argument_and_result(built: Path) -> None:
    assert _tried(built, TRIED, TAMBOUR_KERNELS="native") == ""


@pytest.mark.slow
def test_two_builds_give_the_same_bytes(built: Path, root: Path, tmp_path: Path) -> None:
    again = _built(root, tmp_path)
    objects = [sorted((folder / "tambour" / "kernels").glob("*.o")) for folder in (built, again)]
    assert [o.name for o in objects[0]] == [o.name for o in objects[1]] and len(objects[0]) == 7
    for one, other in zip(*objects):
        assert one.read_bytes() == other.read_bytes(), one.name
    assert (built / "_native.abi3.so").read_bytes() == (again / "_native.abi3.so").read_bytes()


@pytest.mark.slow
@pytest.mark.parametrize(
    ("old", "new"),
    [("SCALE = 3.0", "SCALE = 2.0"), ("return SCALE * x", "return x * SCALE"), ("return scaled(x", "return -scaled(x")],
    ids=["a constant", "a kernel that it calls", "itself"],
)
def test_what_is_stale_never_runs(built: Path, tmp_path: Path, old: str, new: str) -> None:
    assert KINDS.count(old) == 1
    (tmp_path / "kinds.py").write_text("\n\n" + KINDS.replace(old, new))
    (tmp_path / "_native.abi3.so").symlink_to(built / "_native.abi3.so")
    code = "import kinds, numpy as np\nkinds.nothing(np.arange(3.0))\nkinds.numbers(1.0, 1, 1, True, 1.0)"
    assert "kinds.numbers was built from another source: run `make kernels`" in _tried(
        tmp_path, code, TAMBOUR_KERNELS="native"
    )
    code += "\nassert kernels.RAN == {'kinds.nothing': 'native', 'kinds.numbers': 'numba'}, kernels.RAN"
    assert _tried(tmp_path, code, TAMBOUR_KERNELS="") == ""


@pytest.mark.slow
def test_a_record_of_other_fields_makes_another_kernel(built: Path, tmp_path: Path) -> None:
    (tmp_path / "kinds.py").write_text(KINDS.replace("    a: F8x1\n    k: I8x1", "    k: I8x1\n    a: F8x1"))
    (tmp_path / "_native.abi3.so").symlink_to(built / "_native.abi3.so")
    code = "import kinds\nkinds.record(1.0, None, 1)"
    said = _tried(tmp_path, code, TAMBOUR_KERNELS="native")
    assert "kinds.record was built from another source: run `make kernels`" in said


@pytest.mark.slow
def test_kernels_as_plain_functions() -> None:
    code = "from tambour.noise import close, uniform; print(type(close).__name__, uniform(3, 5))"
    plain, compiled = (_python(code, TAMBOUR_KERNELS=way).stdout.split() for way in ("python", "numba"))
    assert plain == ["function", compiled[1]] and compiled[0] == "Kernel"


COMMANDS = {
    "crochet examples/crochet/heart.acl --check": {"scipy", "shapely", "skia", "pystitch", "PIL"},
    "crochet examples/crochet/y.acl -o {out}/y.glb": {"scipy", "shapely", "skia", "pystitch", "PIL"},
    "crochet examples/crochet/bear.txt --check": {"scipy", "shapely", "skia", "pystitch", "PIL"},
    "knit examples/knit/rose.png --stitches 30 -o {out}/k.png": {
        "scipy.optimize",
        "shapely",
        "skia",
        "pystitch",
    },
    "ink --seed 7 --span 200 -o {out}/i.svg": {"scipy", "shapely", "skia", "pystitch"},
    "embroidery examples/embroidery/heart.svg -o {out}/e.dst": {"scipy.optimize", "skia"},
}
"""Small commands, and what they have no use for."""


@pytest.mark.parametrize("words", COMMANDS, ids=lambda words: words.partition(" -")[0].replace("examples/", ""))
@pytest.mark.slow
def test_commands_load_neither_the_compiler_nor_what_they_have_no_use_for(
    words: str, root: Path, tmp_path: Path
) -> None:
    if importlib.util.find_spec("tambour.core._native") is None:
        pytest.skip("kernels are not built here")
    code = """
    import sys
    from tambour.cli import main
    try:
        main(sys.argv[1:])
    except SystemExit as end:
        assert not end.code, end.code
    from tambour.core.kernels import RAN
    print("ways", *sorted(set(RAN.values())))
    print("loaded", *sys.modules)
    """
    given = words.replace("examples/", f"{root}/examples/").format(out=tmp_path).split()
    made = _python(code, *given, TAMBOUR_KERNELS="")
    assert made.returncode == 0, made.stderr
    said = {line.split()[0]: set(line.split()[1:]) for line in made.stdout.splitlines()[-2:]}
    assert said["ways"] == {"native"}, "kernels are stale: run `make kernels`"
    assert not said["loaded"] & {"numba", "llvmlite", "rich", *COMMANDS[words]}


def test_one_thread_at_a_time_looks_for_what_was_built() -> None:
    # Python's search for a module fails when another thread is half way through loading it.
    code = """
        import importlib.util, threading, time
        from tambour.core import kernels
        inside, most = [], []
        found = importlib.util.find_spec
        def slow(name):
            inside.append(name)
            most.append(len(inside))
            time.sleep(0.05)
            inside.pop()
            return found(name)
        importlib.util.find_spec = slow
        threads = [threading.Thread(target=kernels._native) for _ in range(6)]
        [t.start() for t in threads]
        [t.join() for t in threads]
        print(max(most), len(most))
    """
    assert _python(textwrap.dedent(code)).stdout.split() == ["1", "1"]


def test_what_was_not_used_for_long_leaves_the_cache(root: Path, tmp_path: Path) -> None:
    folder = tmp_path / "tambour" / "kernels"
    (folder / "tmp-left").mkdir(parents=True)
    (folder / "tmp-left" / "native.c").write_text("")
    for name in ("native-old.so", "a.b-old.o", "native-new.so", "a.b-new.o"):
        (folder / name).write_text("")
    for path in (folder / "native-old.so", folder / "a.b-old.o", folder / "tmp-left"):
        os.utime(path, (1e9, 1e9))
    before = sorted(os.listdir(folder))
    code = f"""
        import sys; sys.path.insert(0, {str(root)!r})
        from kernels import build
    """
    held = "with build._cache_held(): build.sweep()"  # as if another process were building
    for more, left in ((held, [*before, "lock"]), ("build.sweep()", ["a.b-new.o", "lock", "native-new.so"])):
        ran = _python(textwrap.dedent(code) + more, XDG_CACHE_HOME=str(tmp_path))
        assert ran.returncode == 0, ran.stderr
        assert sorted(os.listdir(folder)) == sorted(left)
    # What is used stays.
    os.utime(folder / "native-new.so", (1e9, 1e9))
    again = (
        "assert build._used(build.cache() / 'native-new.so') and not build._used(build.cache() / 'gone'); build.sweep()"
    )
    assert _python(textwrap.dedent(code) + again, XDG_CACHE_HOME=str(tmp_path)).returncode == 0
    assert (folder / "native-new.so").exists()
