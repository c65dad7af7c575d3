"""Glue: the C between Python and compiled kernels, one function for each, and the module that holds them."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path

CTYPE = {"float64": "double", "float32": "float", "int64": "int64_t", "int32": "int32_t", "int16": "int16_t",
         "int8": "int8_t", "uint64": "uint64_t", "uint32": "uint32_t", "uint16": "uint16_t", "uint8": "uint8_t",
         "bool": "uint8_t"}  # fmt: skip
FORMAT = {"float64": "d", "float32": "f", "int64": "lq", "int32": "i", "int16": "h", "int8": "b", "uint64": "LQ",
          "uint32": "I", "uint16": "H", "uint8": "B", "bool": "?"}  # fmt: skip
TAKE = {"f": ("double", "double"), "i": ("int64_t", "int"), "u": ("uint64_t", "unsigned"), "b": ("uint8_t", "truth")}
GIVE = {"float64": "PyFloat_FromDouble", "float32": "PyFloat_FromDouble", "bool": "PyBool_FromLong"}


@dataclass(frozen=True)
class Entry:
    """A kernel that Python calls: ``kinds`` and ``result`` are (element type, axes), a result () for nothing, or many.

    The arguments are those of the native function; ``records`` tells which of them Python gives in one tuple: (first, how many).
    """

    name: str
    symbol: str
    digest: str
    arguments: list[str]
    kinds: list[tuple[str, int]]
    records: list[tuple[int, int]]
    result: list[tuple[str, int]]
    single: bool  # the result is one value, not a tuple of them


def source(entries: list[Entry]) -> str:
    """The C source of the whole module."""
    text = [(Path(__file__).parent / "runtime.c").read_text()]
    text += [_function(k, entry) for k, entry in enumerate(entries)]
    text.append("\nstatic PyMethodDef methods[] = {")
    text += [f'    {{"{e.name}", call_{k}, METH_FASTCALL, "{e.digest}"}},' for k, e in enumerate(entries)]
    text.append(_MODULE)
    return "\n".join(text)


def _slot(kind: tuple[str, int], name: str) -> str:
    element, axes = kind
    if not axes:
        return f"{CTYPE[element]} {name};"
    return (
        f"struct {{ Memory *memory; void *parent; int64_t items, item; void *data;"
        f" intptr_t shape[{axes}], strides[{axes}]; }} {name};"
    )


def _function(k: int, entry: Entry) -> str:
    many = [(i, kind) for i, kind in enumerate(entry.kinds) if kind[1]]
    types, passed, taken = ["void *", "void **"], ["&out", "&error"], []
    for i, ((element, axes), name) in enumerate(zip(entry.kinds, entry.arguments)):
        where = f'"{entry.name}", "{name}"'
        if not axes:
            ctype = CTYPE[element]
            types.append(ctype)
            passed.append(f"({ctype})a{i}")
            taken.append(f"    if (take_{TAKE[element[0]][1]}(&a{i}, args[{i}], {where})) goto end;")
            continue
        b = next(j for j, (at, _) in enumerate(many) if at == i)
        wanted = f'"an array of {element} with {axes} {"axis" if axes == 1 else "axes"}, in C order and writable"'
        taken.append(
            f'    if (take(&b[{b}], args[{i}], "{FORMAT[element]}", {axes}, {where}, {wanted})) goto end;\n    held++;'
        )
        types += ["void *", "void *", "int64_t", "int64_t", "void *"] + ["int64_t"] * (2 * axes)
        size = f"(int64_t)sizeof({CTYPE[element]})"
        passed += ["NULL", "NULL", f"b[{b}].len / {size}", size, f"b[{b}].buf"]
        passed += [f"b[{b}].shape[{d}]" for d in range(axes)]
        passed += [" * ".join([size, *(f"b[{b}].shape[{e}]" for e in range(d + 1, axes))]) for d in range(axes)]
    slots = " ".join(_slot(kind, f"r{j}") for j, kind in enumerate(entry.result)) or "void *nothing;"
    n, given = _given(entry)
    lines = [
        f"\nextern int32_t {entry.symbol}({', '.join(types)});\n",
        f"static PyObject *call_{k}(PyObject *self, PyObject *const *args, Py_ssize_t n) {{",
        f'    if (n != {n}) return count("{entry.name}", {n}, n);',
        *given,
        f"    Py_buffer b[{max(1, len(many))}];",
        "    PyObject *made = NULL;",
        "    void *error = NULL;",
        "    int held = 0;",
        f"    struct {{ {slots} }} out;",
        *(f"    {TAKE[e[0]][0]} a{i};" for i, (e, axes) in enumerate(entry.kinds) if not axes),
        "    (void)self;",
        *taken,
        "    PyThreadState *state = PyEval_SaveThread();",
        f"    int32_t status = {entry.symbol}({', '.join(passed)});",
        "    PyEval_RestoreThread(state);",
        "    if (status != 0 && status != -2) {",
        "        PyErr_NoMemory();  /* kernels raise nothing else */",
        "        goto end;",
        "    }",
        *_result(entry),
        "end:",
        "    while (held) PyBuffer_Release(&b[--held]);",
        "    return made;",
        "}",
    ]
    return "\n".join(lines)


def _given(entry: Entry) -> tuple[int, list[str]]:
    """How many arguments Python gives, and the lines that spread the records among them."""
    if not entry.records:
        return len(entry.kinds), []
    records, lines, i, n = dict(entry.records), [f"    PyObject *all[{len(entry.kinds)}];"], 0, 0
    while i < len(entry.kinds):
        fields = records.get(i, 0)
        name = entry.arguments[i].partition(".")[0]
        if fields:
            lines.append(f'    if (spread(all + {i}, args[{n}], {fields}, "{entry.name}", "{name}")) return NULL;')
        else:
            lines.append(f"    all[{i}] = args[{n}];")
        i, n = i + max(1, fields), n + 1
    return n, [*lines, "    args = all;"]


def _result(entry: Entry) -> list[str]:
    if not entry.result:
        return ["    Py_IncRef(&_Py_NoneStruct);", "    made = &_Py_NoneStruct;"]
    values = []
    for j, (element, axes) in enumerate(entry.result):
        r = f"out.r{j}"
        if axes:
            values.append(
                f'array({r}.memory, {r}.data, {axes}, "{FORMAT[element][0]}", {r}.item, {r}.shape, {r}.strides)'
            )
        elif element in GIVE:
            values.append(f"{GIVE[element]}({r})")
        else:
            values.append(f"PyLong_From{'Unsigned' if element[0] == 'u' else ''}LongLong({r})")
    if entry.single:
        return [f"    made = {values[0]};"]
    n = len(values)
    lines = [f"    PyObject *v[{n}] = {{{', '.join(values)}}};"]
    whole = " && ".join(f"v[{j}]" for j in range(n))
    lines.append(f"    if ({whole}) made = PyTuple_Pack({n}, {', '.join(f'v[{j}]' for j in range(n))});")
    return lines + [f"    if (v[{j}]) Py_DecRef(v[{j}]);" for j in range(n)]


_MODULE = """    {NULL, NULL, 0, NULL},
};

static PyModuleDef module = {{1, NULL}, NULL, 0, NULL, "_native", NULL, -1, methods, NULL, NULL, NULL, NULL};

PyMODINIT_FUNC PyInit__native(void) {
    PyObject *numpy = PyImport_ImportModule("numpy");
    asarray = numpy ? PyObject_GetAttrString(numpy, "asarray") : NULL;
    if (numpy) Py_DecRef(numpy);
    block_type = asarray ? PyType_FromSpec(&block_spec) : NULL;
    return block_type ? PyModule_Create2(&module, 3) : NULL;
}
"""
