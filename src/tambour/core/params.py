"""Params: what a craft can be told, declared once.

One frozen pydantic model per craft is the library's arguments, the command line's options, the web form's schema, the
cache key and the sweep's axes. Fields are flat: numbers, words, switches, lengths, files.
"""

from __future__ import annotations

import ast
import inspect
import itertools
import re
import textwrap
import types
from collections.abc import Iterable, Mapping
from dataclasses import dataclass
from functools import cache
from pathlib import Path
from typing import Annotated, Any, ClassVar, Literal, Union, get_args, get_origin

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, ValidationInfo, field_validator

from tambour.core.errors import Problem, TambourError, did_you_mean, option, unspeakable

_LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, '"': 25.4, "pt": 25.4 / 72}
_TIMES = {"s": 1.0, "min": 60.0, "m": 60.0, "h": 3600.0}
LONG = 100
"""Characters of a value that messages repeat."""
_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z\"]*)\s*$")


def measure(value: Any, units: dict[str, float], plain: float = 1.0) -> Any:
    """A number with a unit (``"2.5cm"``) in the base unit; a bare number counts ``plain``.

    >>> measure("2h", {"s": 1.0, "h": 3600.0})
    7200.0
    """
    if not isinstance(value, str):
        return value
    found = _NUMBER.match(value)
    if not found or (found[2] and found[2] not in units):
        raise ValueError(f"{value!r} is not a number with one of the units {', '.join(units)}")
    return float(found[1]) * (units[found[2]] if found[2] else plain)


def length(value: Any) -> Any:
    """A length in mm from a number or a text such as ``0.4mm``, ``2.5cm``, ``1in``.

    >>> length("2.5cm"), length(4)
    (25.0, 4)
    """
    return measure(value, _LENGTHS)


@dataclass(frozen=True)
class Unit:
    """In a number's annotations: the unit that a bare number counts."""

    name: str

    def __get_pydantic_json_schema__(self, core: Any, handler: Any) -> dict[str, Any]:
        """Pydantic's schema, with the unit."""
        return {**handler(core), "unit": self.name}


Length = Annotated[float, BeforeValidator(length), Field(allow_inf_nan=False), Unit("mm")]
"""A length in mm; at the surface ``mm``, ``cm``, ``m``, ``in`` and ``pt`` are understood."""

Duration = Annotated[float, BeforeValidator(lambda v: measure(v, _TIMES)), Field(allow_inf_nan=False), Unit("s")]
"""A time in seconds; ``90s``, ``20min`` and ``3h`` are understood."""

Degrees = Annotated[
    float, BeforeValidator(lambda v: measure(v, {"deg": 1.0})), Field(allow_inf_nan=False), Unit("degrees")
]
"""An angle in degrees, 0 along +x, counter-clockwise as one sees it."""


def file(value: str, help: str, words: tuple[str, ...] = ()) -> Any:
    """A field that names a file: ``run`` reads it as the value type ``value`` and ``make`` receives that value, or,
    where one of ``words`` is given, the word.

    Annotate it as ``Any``; the default is None.
    """
    return Field(default=None, description=help, json_schema_extra={"file": value, "words": list(words)})


def edited(default: tuple[str, ...] = ()) -> Any:
    """A field that is set by a craft's edits alone (:class:`tambour.craft.Change`): neither option nor form shows it."""
    return Field(default=default, json_schema_extra={"edited": True})


class Params(BaseModel):
    r"""Base of every craft's parameters: frozen, unknown names refused, docstrings under fields are their help.

    >>> class Socks(Params):
    ...     size: int = 38
    >>> Socks(size="41").size
    41
    """

    model_config = ConfigDict(frozen=True, extra="forbid", arbitrary_types_allowed=True, allow_inf_nan=False)

    groups: ClassVar[Mapping[str, str]] = {}
    """What belongs together in a form: a heading → its fields, in order, parted by spaces."""
    first: ClassVar[str] = ""
    """The fields that most people want (tier "first"); all others but the rare ones are tier "more"."""
    rare: ClassVar[str] = "edition"
    """The fields that few ever need (tier "rare")."""
    widgets: ClassVar[Mapping[str, str]] = {}
    """Field → what it is set with, where its type does not say so: color, lines, box."""
    when: ClassVar[Mapping[str, Mapping[str, Any]]] = {}
    """Field → when it has an effect: other fields → True (given or on), False (not), or the values that they may have."""

    edition: int = Field(default=1, ge=1, le=1)
    """The generation of the algorithms that make the piece; old pieces keep theirs."""

    @classmethod
    def files(cls) -> dict[str, str]:
        """Fields that name a file → the value type they are read as.

        >>> from tambour.run import craft
        >>> craft("embroidery").params.files()["font"]
        'Font'
        """
        return dict(_files(cls))

    @classmethod
    def words(cls, name: str) -> tuple[str, ...]:
        """The words that the file field ``name`` takes in a file's place.

        >>> from tambour.run import craft
        >>> "wave" in craft("embroidery").params.words("cloth")
        True
        """
        extra = cls.model_fields[name].json_schema_extra
        listed = extra.get("words", []) if isinstance(extra, dict) else []
        return tuple(map(str, listed)) if isinstance(listed, list) else ()

    @field_validator("*", mode="before")
    @classmethod
    def _words(cls, value: Any, info: ValidationInfo) -> Any:
        if info.field_name in _files(cls) and isinstance(value, (bool, int, float, bytes, list, dict, tuple, set)):
            raise ValueError("a file's name is wanted")
        for text in value if isinstance(value, (tuple, list)) else (value,):
            if isinstance(text, (str, Path)) and (why := unspeakable(str(text))):
                raise ValueError(why)
        return value

    @classmethod
    def asked(cls) -> dict[str, Any]:
        """The fields that options and forms ask for: all but those that edits set.

        >>> from tambour.run import craft
        >>> "max_float" in craft("knit").params.asked()
        True
        """
        extras = {name: f.json_schema_extra for name, f in cls.model_fields.items()}
        edits = {name for name, e in extras.items() if isinstance(e, dict) and "edited" in e}
        return {name: f for name, f in cls.model_fields.items() if name not in edits}

    @classmethod
    def help(cls, name: str) -> str:
        """What the field ``name`` is for: the text that stands under it, in one line.

        >>> from tambour.run import craft
        >>> craft("ink").params.help("span") != ""
        True
        """
        said = cls.model_fields[name].description or _texts(cls).get(name, "")
        return said.strip().replace("\n", " ")

    @classmethod
    def form(cls) -> dict[str, dict[str, Any]]:
        """All that a form needs of each field: label, help, group, tier, widget, unit, minimum, maximum (or
        exclusiveMinimum, exclusiveMaximum), choices, file (the value type read from it), many, default, when.

        Help names other fields as ``{--max-float}``; see :func:`tambour.core.errors.spelt`.

        >>> from tambour.run import craft
        >>> craft("embroidery").params.form()["width"]["unit"]
        'mm'
        """
        of_group = {name: group for group, names in cls.groups.items() for name in names.split()}
        made = {}
        for name, f in cls.asked().items():
            kind, many = kind_of(f.annotation)
            extra = f.json_schema_extra if isinstance(f.json_schema_extra, dict) else {}
            listed = extra.get("choices", ())
            choices = [*cls.words(name), *(get_args(kind) if get_origin(kind) is Literal else ())]
            choices += listed if isinstance(listed, list) else []
            plain = {bool: "switch", int: "number", float: "number"}.get(kind, "text")
            widget = "file" if name in cls.files() else "choice" if choices else plain
            default = None if f.is_required() else f.get_default(call_default_factory=True)
            told: dict[str, Any] = {
                "label": name.rstrip("_").replace("_", " ").capitalize(),
                "help": cls.help(name),
                "group": of_group.get(name, "Making"),
                "tier": "first" if name in cls.first.split() else "rare" if name in cls.rare.split() else "more",
                "widget": cls.widgets.get(name, widget),
                "many": many,
                "default": list(default) if isinstance(default, tuple) else default,
                "when": {k: list(v) if isinstance(v, tuple) else v for k, v in cls.when.get(name, {}).items()},
            }
            found = {"unit": unit(f), "choices": choices, "file": cls.files().get(name), **bounds(f)}
            made[name] = {**told, **{k: v for k, v in found.items() if v not in ("", [], None)}}
        return made

    @classmethod
    def model_json_schema(cls, *args: Any, **options: Any) -> dict[str, Any]:
        """Pydantic's schema, and with each property what :meth:`form` knows of it.

        >>> from tambour.run import craft
        >>> craft("ink").params.model_json_schema()["properties"]["seed"]["type"]
        'string'
        """
        made = super().model_json_schema(*args, **options)
        for name, told in cls.form().items():
            for part in made["properties"][name].get("anyOf", ()):
                for word in ("gt", "ge", "lt", "le"):  # pydantic's own words, left there by bounds of what may be None
                    part.pop(word, None)
            made["properties"][name] |= {"description": told["help"], **told}
        return made

    def said(self, names: Iterable[str]) -> list[str]:
        """Those of the fields ``names`` that are not as usual.

        >>> from tambour.run import craft
        >>> craft("knit").params(stitches=24, rows="30").said(("stitches", "rows", "gauge"))
        ['stitches', 'rows']
        """
        usual = {name: type(self).model_fields[name] for name in names}
        return [n for n, f in usual.items() if getattr(self, n) != f.get_default(call_default_factory=True)]

    def idle(self) -> list[Problem]:
        """Warnings about the fields that are set and have no effect, by ``when``.

        >>> from tambour.run import craft
        >>> [p.where for p in craft("embroidery").params(place_group="hat").idle()]
        ['{--place-group}']
        """
        problems = []
        for name, needs in self.when.items():
            unmet = [(k, v) for k, v in needs.items() if not _holds(getattr(self, k), v)]
            if unmet and self.said((name,)):
                lacking = " and ".join(_needed(k, v) for k, v in unmet if v is not False)
                against = " and ".join(_needed(k, v) for k, v in unmet if v is False)
                why = [f"without {lacking}"] * bool(lacking) + [f"with {against}"] * bool(against)
                problems.append(Problem(f"has no effect {' and '.join(why)}", where=_needed(name), warning=True))
        return problems

    @classmethod
    def of(cls, values: dict[str, Any], spell: str = "{{--{}}}") -> Any:
        """Validated params; all that is wrong at once as a TambourError whose places are the fields.

        >>> from tambour.run import craft
        >>> try:
        ...     craft("embroidery").params.of({"width": "3 parsecs"})
        ... except TambourError as error:
        ...     print(error.problems[0].where)
        {--width}
        """
        try:
            return cls(**values)
        except ValidationError as error:
            raise TambourError(
                [
                    Problem(
                        _sentence(e),
                        _remedy(e, cls.asked()),
                        where=spell.format(option(str(e["loc"][0]))[2:]) if e["loc"] else "",
                    )
                    for e in error.errors()
                ]
            ) from None

    def plain(self) -> dict[str, Any]:
        """The values that differ from nothing: plain JSON, files by the name they were given by.

        >>> from tambour.run import craft
        >>> craft("knit").params(max_float="5").plain()["max_float"]
        '5'
        """
        return self.model_dump(mode="json", exclude=set(self.files()))

    def key(self) -> str:
        """Content hash: equal for equal params, whatever the files they came from are called.

        >>> from tambour.run import craft
        >>> knit = craft("knit").params
        >>> knit(max_float=5).key() == knit(max_float="5").key() != knit(max_float=7).key()
        True
        """
        from tambour.core.digest import digest

        return digest([type(self).__name__, self.plain(), {name: getattr(self, name) for name in self.files()}])


@cache
def _files(cls: type[Params]) -> Mapping[str, str]:
    """See :meth:`Params.files`; asked for every field of every piece."""
    extras = {name: f.json_schema_extra for name, f in cls.model_fields.items()}
    return {name: str(e["file"]) for name, e in extras.items() if isinstance(e, dict) and "file" in e}


@cache
def _texts(cls: type) -> dict[str, str]:
    """Field → the text under it, of a class and those it comes from.

    Read only for help and forms: pydantic's own ``use_attribute_docstrings`` reads the source whenever a class is made.
    """
    made: dict[str, str] = {}
    for made_by in reversed(cls.__mro__):
        if issubclass(made_by, Params):
            found = ast.parse(textwrap.dedent(inspect.getsource(made_by))).body[0]
            body = found.body if isinstance(found, ast.ClassDef) else []
            for field, text in itertools.pairwise(body):
                match field, text:
                    case ast.AnnAssign(target=ast.Name(id=name)), ast.Expr(value=ast.Constant(value=str(said))):
                        made[name] = inspect.cleandoc(said)
    return made


def _holds(value: Any, wanted: Any) -> bool:
    if isinstance(wanted, bool):
        return (value not in (None, "", (), False)) == wanted
    return value in wanted


def _needed(name: str, wanted: Any = True) -> str:
    """A field, and the values that are wanted of it where not any will do, as messages name them."""
    values = "" if isinstance(wanted, bool) else " or ".join(str(w) for w in wanted if w is not None)
    return f"{{{option(name)}}} {values}".strip()


def kind_of(annotation: Any) -> tuple[Any, bool]:
    """The type of a field's values, None left out, and whether it takes many."""
    if get_origin(annotation) in (Union, types.UnionType):
        annotation = next(k for k in get_args(annotation) if k is not type(None))
    if get_origin(annotation) is Annotated:
        annotation = get_args(annotation)[0]
    if get_origin(annotation) is tuple and get_args(annotation)[-1] is Ellipsis:
        return kind_of(get_args(annotation)[0])[0], True
    return annotation, False


def _marks(f: Any) -> list[Any]:
    """The annotations of a field, and those of the type in ``Length | None``."""
    inner = [get_args(k) for k in get_args(f.annotation) if get_origin(k) is Annotated]
    marks = [*(m for found in inner for m in found[1:]), *f.metadata]
    return [m for mark in marks for m in (mark, *(getattr(mark, "metadata", None) or ()))]


def unit(f: Any) -> str:
    """The unit of a pydantic field's numbers, or an empty string."""
    return next((m.name for m in _marks(f) if isinstance(m, Unit)), "")


def bounds(f: Any) -> dict[str, Any]:
    """minimum, maximum, exclusiveMinimum, exclusiveMaximum and maxLength of a pydantic field, where it has them."""
    words = {"ge": "minimum", "le": "maximum", "gt": "exclusiveMinimum", "lt": "exclusiveMaximum"}
    words["max_length"] = "maxLength"
    return {w: v for m in _marks(f) for k, w in words.items() if (v := getattr(m, k, None)) is not None}


def _remedy(error: Any, fields: Iterable[str]) -> str:
    if error["type"] == "extra_forbidden":
        return did_you_mean(str(error["loc"][0]), fields)
    if error["type"] != "literal_error" or not isinstance(error["input"], str):
        return ""
    return did_you_mean(error["input"].lower(), re.findall(r"'([^']+)'", error["ctx"]["expected"]))


def _sentence(error: Any) -> str:
    text = str(error["msg"]).removeprefix("Value error, ")
    given = error.get("input")
    text = text[:1].lower() + text[1:]
    said = repr(given) if len(repr(given)) <= LONG else f"{repr(given)[:LONG]}…"
    if error["type"] == "extra_forbidden":
        return "there is no such parameter"
    return (
        text if isinstance(given, dict) or (isinstance(given, str) and repr(given) in text) else f"{text} (got {said})"
    )
