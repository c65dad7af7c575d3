"""Params: what a craft can be told, declared once.

One frozen pydantic model per craft is the library's arguments, the command line's options, the web form's schema, the
cache key and the sweep's axes. Fields are flat: numbers, words, switches, lengths, files.
"""

from __future__ import annotations

import re
from typing import Annotated, Any, ClassVar

from pydantic import BaseModel, BeforeValidator, ConfigDict, Field, ValidationError, WithJsonSchema

from tambour.core.errors import Problem, TambourError, did_you_mean

_LENGTHS = {"mm": 1.0, "cm": 10.0, "m": 1000.0, "in": 25.4, '"': 25.4, "pt": 25.4 / 72}
_TIMES = {"s": 1.0, "min": 60.0, "m": 60.0, "h": 3600.0}
_NUMBER = re.compile(r"\s*([-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?)\s*([a-zA-Z\"]*)\s*$")


def measure(value: Any, units: dict[str, float], plain: float = 1.0) -> Any:
    """A number with a unit (``"2.5cm"``) in the base unit; a bare number counts ``plain``."""
    if not isinstance(value, str):
        return value
    found = _NUMBER.match(value)
    if not found or (found[2] and found[2] not in units):
        raise ValueError(f"{value!r} is not a number with one of the units {', '.join(units)}")
    return float(found[1]) * (units[found[2]] if found[2] else plain)


def length(value: Any) -> Any:
    """A length in mm from a number or a text such as ``0.4mm``, ``2.5cm``, ``1in``."""
    return measure(value, _LENGTHS)


Length = Annotated[
    float,
    BeforeValidator(length),
    Field(allow_inf_nan=False),
    WithJsonSchema({"type": "number", "unit": "mm"}),
]
"""A length in mm; at the surface ``mm``, ``cm``, ``m``, ``in`` and ``pt`` are understood."""

Duration = Annotated[
    float,
    BeforeValidator(lambda v: measure(v, _TIMES)),
    Field(allow_inf_nan=False),
    WithJsonSchema({"type": "number", "unit": "s"}),
]
"""A time in seconds; ``90s``, ``20min`` and ``3h`` are understood."""

Degrees = Annotated[
    float,
    BeforeValidator(lambda v: measure(v, {"deg": 1.0})),
    Field(allow_inf_nan=False),
    WithJsonSchema({"type": "number", "unit": "degrees"}),
]
"""An angle in degrees, 0 along +x, counter-clockwise as one sees it."""


def file(value: str, help: str, words: tuple[str, ...] = ()) -> Any:
    """A field that names a file: ``run`` reads it as the value type ``value`` and ``make`` receives that value, or,
    where one of ``words`` is given, the word.

    Annotate it as ``Any``; the default is None.
    """
    return Field(default=None, description=help, json_schema_extra={"file": value, "words": list(words)})


class Params(BaseModel):
    """Base of every craft's parameters: frozen, unknown names refused, docstrings under fields are their help."""

    model_config = ConfigDict(
        frozen=True, extra="forbid", use_attribute_docstrings=True, arbitrary_types_allowed=True, allow_inf_nan=False
    )

    sources: ClassVar[tuple[str, ...]] = ()

    edition: int = Field(default=1, ge=1, le=1)
    """The generation of the algorithms that make the piece; old pieces keep theirs."""

    @classmethod
    def files(cls) -> dict[str, str]:
        """Fields that name a file → the value type they are read as."""
        extras = {name: f.json_schema_extra for name, f in cls.model_fields.items()}
        return {name: str(e["file"]) for name, e in extras.items() if isinstance(e, dict) and "file" in e}

    @classmethod
    def words(cls, name: str) -> tuple[str, ...]:
        """The words that the file field ``name`` takes in a file's place."""
        extra = cls.model_fields[name].json_schema_extra
        listed = extra.get("words", []) if isinstance(extra, dict) else []
        return tuple(map(str, listed)) if isinstance(listed, list) else ()

    @classmethod
    def of(cls, values: dict[str, Any], spell: str = "{{--{}}}") -> Any:
        """Validated params; all that is wrong at once as a TambourError whose places are the fields."""
        try:
            return cls(**values)
        except ValidationError as error:
            raise TambourError(
                [
                    Problem(
                        _sentence(e),
                        _remedy(e),
                        where=spell.format(str(e["loc"][0]).rstrip("_").replace("_", "-")) if e["loc"] else "",
                    )
                    for e in error.errors()
                ]
            ) from None

    def plain(self) -> dict[str, Any]:
        """The values that differ from nothing: plain JSON, files by the name they were given by."""
        return self.model_dump(mode="json", exclude=set(self.files()))

    def key(self) -> str:
        """Content hash: equal for equal params, whatever the files they came from are called."""
        from tambour.core.digest import digest

        return digest([type(self).__name__, self.plain(), {name: getattr(self, name) for name in self.files()}])


def _remedy(error: Any) -> str:
    if error["type"] != "literal_error" or not isinstance(error["input"], str):
        return ""
    return did_you_mean(error["input"].lower(), re.findall(r"'([^']+)'", error["ctx"]["expected"]))


def _sentence(error: Any) -> str:
    text = str(error["msg"]).removeprefix("Value error, ")
    given = error.get("input")
    text = text[:1].lower() + text[1:]
    if error["type"] == "extra_forbidden":
        return "there is no such parameter"
    return text if isinstance(given, dict) or repr(given) in text else f"{text} (got {given!r})"
