"""Compile: every kernel that Python calls becomes an object file, by Numba, for any processor of the kind.

``python kernels/compile.py objects SHARE FOLDER`` compiles into the cache what it lacks, beside another share, and needs Numba;
``python kernels/compile.py keys`` tells where each kernel lies there, and its fingerprint. How native functions are called
(see ``runtime.c``) is Numba's own affair, not promised by it: so Numba is pinned, and a test calls a kernel of each kind of
argument and result. Should it change, ``numba.cfunc`` with ``carray`` is the public way.
"""

from __future__ import annotations

import gc
import hashlib
import importlib
import inspect
import json
import os
import re
import sys
from pathlib import Path
from typing import Any

PROCESSOR = "x86-64-v2"
"""One kind for all. With the vectors of v3 knit's eight rows at a time run 1.57 times as fast (1.30 with free edges; EPYC, v2
against v3 in one process each), and nothing else gains: but they are .08 of the 1.27 s that 400 stitches in tones take, and
.01 of .62 s at 120. A second copy, chosen when it is loaded, would save 2 % of a large piece, and is not made."""
NUMBA = "numba==0.68.1"
BESIDE = "tambour.crochet.settle."
"""Kernels in which numbers that stand side by side in the text are reckoned side by side, in the order written: the bytes stay the
same. Numba does so only when told, and then compiles longer."""
BARE = {"cache": False, "no_cpython_wrapper": True, "no_cfunc_wrapper": True}  # the native function alone
TIDY = 24
"""Kernels after which memory is tidied: some 400 MB a process."""
SOURCE = Path(__file__).resolve().parent.parent / "src"


def cache() -> Path:
    """The folder of the user's cache where objects lie, one for each state of a kernel."""
    base = os.environ.get("XDG_CACHE_HOME") or Path.home() / ".cache"
    return Path(base) / "tambour" / "kernels"


def modules() -> list[str]:
    """The modules that hold kernels."""
    paths = [
        p for p in (SOURCE / "tambour").rglob("*.py") if re.search(r"^@(kernel|inner)$", p.read_text("utf-8"), re.M)
    ]
    return sorted(".".join(p.relative_to(SOURCE).with_suffix("").parts) for p in paths)


def entries() -> list[Any]:
    """The kernels that declare what each argument is."""
    from tambour.core.kernels import Kernel, signature

    found = [v for m in modules() for v in vars(importlib.import_module(m)).values() if isinstance(v, Kernel)]
    unique = {k.name: k for k in found if not k.place and signature(k) is not None}
    return [unique[name] for name in sorted(unique)]


def key(kernel: Any) -> str:
    """The name of a kernel's object in the cache."""
    from tambour.core.kernels import fingerprint

    made = hashlib.sha256(f"{fingerprint(kernel)} {NUMBA} {PROCESSOR}".encode())
    made.update(f"{BARE}{inspect.getsource(compiled)}".encode())
    if kernel.name.startswith(BESIDE):
        made.update(b"side by side")
    return f"{kernel.name}-{made.hexdigest()[:32]}"


def compiled(kernel: Any) -> tuple[bytes, dict[str, Any]]:
    """A kernel's object code, and what the glue must know of it."""
    import llvmlite.binding as llvm

    from tambour.core.kernels import numba_types, signature

    made = kernel.twin()
    made.compile(numba_types(kernel.function))
    result = made.overloads[numba_types(kernel.function)]
    symbol = "tambour_" + re.sub(r"\W", "_", kernel.name)
    code = llvm.parse_assembly(str(result.library._final_module))
    for function in code.functions:
        if function.name == result.fndesc.llvm_func_name:
            function.name = symbol
            function.visibility = "hidden"
        elif not function.is_declaration:
            function.linkage = "internal"
    for number, variable in enumerate(code.global_variables):
        if not variable.is_declaration:  # Numba names some by where they lay in its memory
            variable.linkage, variable.name = "internal", f"data_{number}"
    machine = llvm.Target.from_triple(llvm.get_process_triple()).create_target_machine(
        cpu=PROCESSOR, opt=3, reloc="pic", codemodel="default"
    )
    # What nobody calls any more goes: the copies of callees that were inlined.
    passes = llvm.create_new_module_pass_manager()
    passes.add_global_dead_code_eliminate_pass()
    passes.run(code, llvm.create_pass_builder(machine, llvm.create_pipeline_tuning_options()))
    returned = result.signature.return_type
    parts = list(returned) if hasattr(returned, "types") else [] if str(returned) == "none" else [returned]
    arguments: list[str] = []
    kinds: list[tuple[str, int]] = []
    records: list[tuple[int, int]] = []
    for name, (what, how) in zip(kernel.function.__code__.co_varnames, signature(kernel) or ()):
        if isinstance(what, type):  # a record is handed over field by field
            records.append((len(kinds), len(how)))
            arguments += [f"{name}.{field}" for field in what._fields]
            kinds += how
        else:
            arguments.append(name)
            kinds.append((what, how))
    told = {
        "name": kernel.name,
        "symbol": symbol,
        "arguments": arguments,
        "kinds": kinds,
        "records": records,
        "result": [(str(p.dtype), p.ndim) if hasattr(p, "ndim") else (str(p), 0) for p in parts],
        "single": not hasattr(returned, "types"),
    }
    return machine.emit_object(code), told


def keep(kernel: Any, code: bytes, told: dict[str, Any]) -> str:
    """Put a kernel's object into the cache; gives its name there."""
    path = cache() / key(kernel)
    for suffix, content in ((".o", code), (".json", json.dumps(told).encode())):
        half = path.with_name(f"{path.name}.{os.getpid()}")
        half.write_bytes(content)
        half.replace(path.with_name(path.name + suffix))
    return path.name


def objects(share: int, claims: Path) -> None:
    """Compile what the cache lacks: share 0 from the first kernel on, share 1 from the last one back, until they meet.

    claims : a folder that both know, where each puts a file of the kernel's name before it begins
    """
    from numba import config
    from numba.core.codegen import JITCodeLibrary

    from tambour.core import kernels

    kernels.OPTIONS |= BARE
    gc.disable()  # a fifth of the time goes into looking for what Numba has left; it is looked for now and then
    JITCodeLibrary._finalize_specific = lambda library: None  # a seventh into code for this very processor, never run
    missing = [k for k in entries() if not (cache() / f"{key(k)}.json").exists()]
    for number, kernel in enumerate(missing if share == 0 else reversed(missing)):
        try:
            (claims / kernel.name).touch(exist_ok=False)
        except FileExistsError:
            return
        config.SLP_VECTORIZE = int(kernel.name.startswith(BESIDE))
        keep(kernel, *compiled(kernel))
        print("kernel", kernel.name, flush=True)
        if number % TIDY == TIDY - 1:
            gc.collect()


if __name__ == "__main__":
    # Set before Numba is loaded: code for every processor of the kind, the same wherever it is built.
    os.environ |= {"NUMBA_CPU_NAME": PROCESSOR, "NUMBA_CPU_FEATURES": "", "TAMBOUR_KERNELS": "numba"}
    sys.path.insert(0, str(SOURCE))
    if sys.argv[1] == "keys":
        from tambour.core.kernels import fingerprint

        print(json.dumps([(key(kernel), fingerprint(kernel)) for kernel in entries()]))
    else:
        objects(int(sys.argv[2]), Path(sys.argv[3]))
