"""Spellings: of stitches that belong together (their increases, decreases, posts, bumps) from a few templates."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from typing import Any

from tambour.crochet.language.stitches import BUMPS, CHAINS, MOST, PICOTS

Spellings = dict[str, tuple[str, ...]]


def stitches(file: Mapping[str, Any]) -> Spellings:
    """Standard name of a stitch → its spellings, of a language's file."""
    return {
        **{name: tuple(said) for name, said in file["stitches"].items()},
        **{f"picot{n}": tuple(f"{s}{n}" for s in file["stitches"]["picot"]) for n in PICOTS if n != 3},
        **_families(_kinds(file), file["increase"], file["decrease"]),
        **_bumps(file["bumps"]),
        **_standing(file["kinds"], file["standing"]),
    }


def meanings(file: Mapping[str, Any]) -> dict[str, str]:
    """The same → what it means in full; and some words."""
    kinds, say = _kinds(file), file["explained"]
    made = {kind: said[-1] if len(said) < 2 else said[1] for kind, said in kinds.items()}
    for kind, said in kinds.items():
        plain = kind == "sc"
        for n in range(2, MOST + 1):
            for what in ("increase", "decrease"):
                template = say[what if plain and n == 2 else f"{what}s"]
                made[_named(kind, what[:3], n)] = template.format(k=said[0], n=n)
    for kind, said in file["bumps"].items():
        for n in range(2, MOST + 1):
            made[_bump(kind, n)] = say["bump"].format(k=said[-1], n=n)
    made |= {name: said[0] for name, said in _standing(file["kinds"], say["standing"]).items()}
    made |= {f"picot{n}": file["meaning"]["picot"].replace("3", str(n)) for n in PICOTS if n != 3}
    return made | dict(file["meaning"])


def _kinds(file: Mapping[str, Any]) -> dict[str, Sequence[str]]:
    """The plain kinds, and those around the post: the first template for the short spelling, then for the full one."""
    plain: dict[str, Sequence[str]] = file["kinds"]
    posts = {
        end + kind: [template.format(k=said) for template, said in zip(file["posts"][side], plain[kind])]
        for end, side in (("fp", "front"), ("bp", "back"))
        for kind in CHAINS
    }
    return {**plain, **posts}


def _named(kind: str, what: str, n: int) -> str:
    """``inc``, ``dcdec3``."""
    return f"{'' if kind == 'sc' else kind}{what}{'' if n == 2 else n}"


def _families(
    kinds: Mapping[str, Sequence[str]], inc: Mapping[str, Sequence[str]], dec: Mapping[str, Sequence[str]]
) -> Spellings:
    """The kinds, with all increases and decreases of each.

    inc, dec : number of stitches, or "more" → templates; ``{k}`` is a kind's short spelling, then its full one, ``{p}``
    the short one, and nothing for the single crochet; those with neither are of the single crochet alone
    """
    made: Spellings = {kind: tuple(said) for kind, said in kinds.items()}
    for what, templates in (("inc", inc), ("dec", dec)):
        for kind, said in kinds.items():
            plain = kind == "sc"
            for n in range(2, MOST + 1):
                spelt = [
                    t.format(k=k, n=n, p="" if plain else k)
                    for t in templates.get(str(n), templates["more"])
                    for k in (said[:2] if "{k}" in t else said[:1])
                    if plain or "{k}" in t or "{p}" in t
                ]
                made[_named(kind, what, n)] = tuple(dict.fromkeys(spelt))
    return made


def _bump(kind: str, n: int) -> str:
    return kind if n == BUMPS[kind][0] else f"{kind}{n}"


def _bumps(kinds: Mapping[str, Sequence[str]]) -> Spellings:
    """The spellings of bumps, with the number of their loops behind where it is not the usual one."""
    return {
        _bump(kind, n): tuple(said) if n == BUMPS[kind][0] else tuple(f"{s}{n}" for s in said)
        for kind, said in kinds.items()
        for n in range(2, MOST + 1)
    }


def _standing(kinds: Mapping[str, Sequence[str]], template: str) -> Spellings:
    """The spellings of chains that count as a stitch."""
    return {f"ch{n}{kind}": (template.format(n=n, k=kinds[kind][0]),) for kind, n in CHAINS.items()}
