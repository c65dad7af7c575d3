"""Printed patterns, lists of yarn: a text for two toys, each with a list of its own in which the same letters name other yarns."""

from __future__ import annotations

import re
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Final

from tambour.core.errors import Span
from tambour.core.rgb import RGB

if TYPE_CHECKING:
    from tambour.crochet.printed.state import State

_OWNER: Final = re.compile(
    r"^\W*(?:for )?(?:the )?([^\W\d_][^\W\d_’']*(?: [^\W\d_][\w’'-]*){0,2}?)(?: version)?\s*(?::|\s[-–—]\s|(?=(?:main|contrast) ))",
    re.IGNORECASE,
)
"""What a line of a list says first: whose yarns these are, "GOOD WITCH: …", "Bear Version - Contrast A …"."""
_LISTS: Final = frozenset(
    "yarn yarns materials main contrast color colour colors colours solid solids you need version approx".split()
)
_KINDS: Final = r"(?: (?:puppet|doll|toy|version|instructions|pattern|only|figure))?"
_LONG: Final = 5  # words of a heading that names an owner and a part


@dataclass
class YarnList:
    """One list of a text: whose it is, "" where nothing says it, the colours and names of its letters, and where it begins."""

    owner: str
    span: Span
    given: dict[str, RGB] = field(default_factory=dict)
    named: dict[str, str] = field(default_factory=dict)


def enter(lists: list[YarnList], line: str, begin: int, letters: dict[str, tuple[str, RGB | None]]) -> None:
    """Enters the ``letters`` of a ``line`` that stands at ``begin`` into the list under way, or into another where one of them has a yarn already or
    the line is another owner's."""
    letters = {letter: said for letter, said in letters.items() if len(said[0]) > 2}  # "1 ball of A, B, C"
    if not letters:
        return
    found = _OWNER.match(line)
    owner = found[1].lower() if found is not None else ""
    owner = "" if _LISTS & set(owner.split()) or len(owner) < 3 else owner
    last = lists[-1] if lists else None
    twice = last is not None and any(k in last.named and last.named[k] != name for k, (name, _) in letters.items())
    if last is None or twice or (owner and last.owner and owner != last.owner):
        lists.append(last := YarnList(owner, Span(begin, begin + len(line))))
    for letter, (name, hue) in letters.items():
        last.named.setdefault(letter, name)
        if hue is not None and last.named[letter] == name:
            last.given.setdefault(letter, hue)


def worn(p: State, line: str) -> None:
    """Turns to the list of the toy that a heading names, "GOOD WITCH", "Good Witch Puppet", and for one part where it names that too, "BEAR NOSE"."""
    lists = p.palette.lists
    if len(lists) < 2 or p.mode == "materials" or not all(one.owner for one in lists) or not line[:1].isupper():
        return
    said = re.sub(r"\W+", " ", line).strip().lower()
    for k, one in enumerate(lists):
        if re.fullmatch(rf"(?:the )?{re.escape(one.owner)}{_KINDS}", said):
            p.palette.wear(k)
            p.palette.toy = k
            return
    part = next((k for k, one in enumerate(lists) if said.startswith(f"{one.owner} ")), None)
    if part is not None and len(said.split()) <= _LONG:
        p.palette.wear(part)


def headed(p: State) -> None:
    """Turns back to the list of the toy under way, where a heading names no owner of one."""
    if len(p.palette.lists) > 1 and p.heading is not None:
        said = p.heading.name.lower()
        if not any(one.owner and said.startswith(f"{one.owner} ") for one in p.palette.lists):
            p.palette.wear(p.palette.toy)


def twice_told(p: State) -> None:
    """Tells of letters that a further list gives other yarns, where no heading turned to it."""
    first = p.palette.lists[0] if p.palette.lists else None
    for k, one in enumerate(p.palette.lists[1:], 1):
        other = [w.upper() for w, name in one.named.items() if first is not None and first.named.get(w, name) != name]
        if other and k not in p.palette.wore:
            said = f"this list gives {', '.join(other)} other yarns than the first: what is written for it is shown in those of the first"
            p.source.doubt(said, "leave only the list and the rounds of one of them in the text", one.span)


def unnamed(p: State) -> dict[str, str]:
    """What the lists call the yarns of letters whose colour none of their words tells: "Rosie, Night-Night"."""
    found: dict[str, str] = dict(p.palette.named)
    for letter in p.palette.told:
        names = [one.named[letter] for one in p.palette.lists if letter in one.named and letter not in one.given]
        if names:
            found[letter] = ", ".join(dict.fromkeys(names))
    return found
