"""Syntax trees of stitches and actions → checked items: names known, arguments right, each where it may stand."""

from __future__ import annotations

import re
from dataclasses import replace
from typing import Any, Final

from tambour.core.errors import Span, did_you_mean
from tambour.core.rgb import colored, css_colors
from tambour.crochet.language.source import Source
from tambour.crochet.language.stitches import EDGES, RULES, Place, Stitch, into_one, standard
from tambour.crochet.language.tree import Action, Group, Item

_COPY = re.compile(r"^(.*)\.(\d+)$")
MOST_IN_ONE: Final = 64
MOST_IN_CURL: Final = 400
"""The most chains of a curl, and the most stitches of a kind in a row back along it."""
"""Stitches in one place."""


def items(source: Source, tree: Any, in_round: bool, bracket: bool = False) -> tuple[Item, ...]:
    """The items of an ``items`` tree; what is wrong is told to ``source`` and left out.

    in_round : they stand in a round; bracket : they are repeated by brackets
    """
    found: list[Item] = []
    for child in tree.children:
        make = _group if child.data == "group" else _stitch
        item = make(source, child, in_round, bracket)
        if item is not None:
            found.append(item)
    return tuple(found)


def _group(source: Source, tree: Any, in_round: bool, bracket: bool) -> Item | None:
    times: int | None = 1
    at = Span(source.offset, source.offset)
    inner: tuple[Item, ...] = ()
    for child in tree.children:
        kind = getattr(child, "type", None) or child.data
        if kind == "before":
            times, at = source.number(child.children[0])
        elif kind == "items":
            inner = items(source, child, in_round, True)
        elif kind == "repeats" and child.children[0].type == "AROUND":
            times, at = None, source.span(child.children[0])
        elif kind == "repeats":
            times, at = source.number(child.children[1])
    numbers = [c for c in tree.children if getattr(c, "data", "") in ("before", "repeats")]
    if len(numbers) == 2:
        source.error("two numbers for one pair of brackets", "keep one of the two", at)
    if times == 0:
        source.error("brackets are repeated at least once", "leave the brackets out instead", at)
    if times is None and bracket:
        source.error("around stands within other brackets", "give the inner brackets a number", at)
    if times is None and not in_round:
        source.error("around needs a round", "begin the line with a colon", at)
    return Group(inner, times, at)


def _stitch(source: Source, tree: Any, in_round: bool, bracket: bool) -> Item | None:
    times, times_at, after, after_at, around = 1, None, None, None, None
    words = one = None
    for child in tree.children:
        kind = getattr(child, "type", None) or child.data
        if kind == "before":
            times, times_at = source.number(child.children[0])
        elif kind == "after":
            after, after_at = source.number(child.children[0])
        elif kind == "AROUND":
            around = source.span(child)
        elif kind == "words":
            words = child
        elif kind == "one":
            one = child
    if one is not None:
        return _in_one(source, one, (times, times_at), (after, after_at), around, in_round, bracket)
    names = [t for t in words.children if getattr(t, "type", "") == "NAME"]  # type: ignore[union-attr]
    given = [t for t in words.children if not hasattr(t, "type")]  # type: ignore[union-attr]
    span = source.span(names[0], names[-1])
    name = standard(" ".join(names))
    arguments = _arguments(source, given[0]) if given else None
    if name in RULES:
        if times_at is not None:
            source.error(f'"{" ".join(names)}" is not repeated', "take the number away", span)
        if after is not None and after_at is not None:
            if name == "mr" and arguments is None:
                arguments = ([(str(after), after_at)], after_at)
            else:
                source.error("this number belongs to nothing", "a comma goes between stitches", after_at)
        return _action(source, name, span, arguments, in_round, bracket)
    if name not in source.stitches:
        known = [*source.stitches, *(k for k in RULES)]
        hint = _nearest(name, known) or "docs/crochet-language.md lists the stitches; define makes new ones"
        if len(names) > 1 and all(standard(n) in known for n in names):
            hint = "a comma goes between stitches"
        source.error(f'there is no stitch or action "{" ".join(names)}"', hint, span)
        return None
    if arguments is not None:
        values, at = arguments
        if name == "ch" and len(values) == 1 and values[0][0].isdigit():
            after, after_at = int(values[0][0]), values[0][1]
        else:
            source.error("a stitch takes no parentheses", f"write 6 {name}; a count stands apart: {name} (6)", at)
    if after is not None:
        if times_at is not None and after_at is not None:
            source.error("two numbers for one stitch", "keep one of the two", after_at)
        times, times_at = after, after_at
    if not in_round and name != "ch":
        source.error(f'"{" ".join(names)}" stands outside a round', "begin the line with a colon", span)
    if times == 0 and times_at is not None:
        source.doubt("a stitch made no times is left out", "give it a number, or no number", times_at)
    action = Action(name, span, times, times_at)
    if around is not None:
        if bracket:
            source.error("around stands within other brackets", "give the stitch a number", around)
        return Group((action,), None, around)
    return action


def _in_one(
    source: Source,
    tree: Any,
    before: tuple[int, Span | None],
    after: tuple[int | None, Span | None],
    around: Span | None,
    in_round: bool,
    bracket: bool,
) -> Item | None:
    """Stitches in braces: worked into one anchor, chain space or ring; the new stitch becomes known."""
    kinds = [getattr(child, "type", "") for child in tree.children]
    where: Place = "sp" if "SPACE" in kinds else "ring" if "RING" in kinds else "curl" if "CURL" in kinds else ""
    inner = next(child for child in tree.children if not hasattr(child, "type"))
    span = source.span(*_ends(inner))
    text = source.text.text
    span = Span(
        source.span(tree.children[0]).start if where else text.rfind("{", 0, span.start), text.find("}", span.end) + 1
    )
    problems = len(source.problems)
    made: list[tuple[Stitch, int]] = []
    for item in items(source, inner, True, True):
        _flat(source, item, 1, made)
    if any(not p.warning for p in source.problems[problems:]):
        return None
    try:
        stitch = into_one(made, where)
    except ValueError as error:
        source.error(
            str(error),
            "braces hold stitches that are worked into one place" if where != "curl" else "curl{21 ch, 20 sc}",
            span,
        )
        return None
    times, at = before
    if after[0] is not None and at is not None and after[1] is not None:
        source.error("two numbers for one stitch", "keep one of the two", after[1])
    if after[0] is not None:
        times, at = after[0], after[1]
    most = MOST_IN_CURL if where == "curl" else MOST_IN_ONE
    if max(times for _, times in made) > most or (where != "curl" and sum(times for _, times in made) > most):
        source.error(f"more than {most} stitches in one place", "work some of them elsewhere", span)
    if where == "ring" and (at is not None or bracket):
        source.error("a ring is not repeated", "take it out of the brackets", span)
    if where == "ring":
        source.last_number = None
    if not in_round:
        source.error("stitches stand outside a round", "begin the line with a colon", span)
    if stitch.name in source.own and stitch.inner == ():  # an increase that the pattern has defined anew
        stitch = replace(stitch, name=f"{{{stitch.name}}}")
    source.stitches.setdefault(stitch.name, stitch)
    action = Action(stitch.name, span, times, at)
    if around is not None and bracket:
        source.error("around stands within other brackets", "give the stitch a number", around)
    return Group((action,), None, around) if around is not None else action


def _flat(source: Source, item: Item, times: int, made: list[tuple[Stitch, int]]) -> None:
    """The stitches of an item, one after another; what does not belong in braces is told."""
    if isinstance(item, Group):
        for _ in range(min(item.times or 1, MOST_IN_CURL + 1)):
            for inner in item.items:
                if len(made) <= MOST_IN_CURL:
                    _flat(source, inner, times, made)
    elif item.name in source.stitches:
        made.append((source.stitches[item.name], min(item.times * times, MOST_IN_CURL + 1)))
    else:
        source.error("only stitches stand in braces", "put it before them", item.span)


def _ends(tree: Any) -> tuple[Any, Any]:
    """The first and the last token of a tree."""
    tokens = list(tree.tokens())
    return tokens[0], tokens[-1]


def _arguments(source: Source, tree: Any) -> tuple[list[tuple[str, Span]], Span]:
    tokens = tree.children
    values = [(str(t), source.span(t)) for t in tokens if t.type == "ARG"]
    return values, source.span(tokens[0], tokens[-1])


def _action(
    source: Source,
    name: str,
    span: Span,
    arguments: tuple[list[tuple[str, Span]], Span] | None,
    in_round: bool,
    bracket: bool,
) -> Action | None:
    rule, word = RULES[name], source.text.text[span.start : span.end]
    values, at = arguments if arguments is not None else ([], span)
    if arguments is not None and rule.most == 0:
        source.error(f'"{word}" takes no parentheses', f"write {rule.usage}", at)
        return None
    if not rule.fewest <= len(values) <= rule.most or (name == "color" and len(values) == 2):
        few = "too few" if len(values) < rule.most else "too many"
        source.error(f'{few} arguments for "{word}"', f"write {rule.usage}", at)
        return None
    if in_round and not rule.in_round:
        source.error(f'"{word}" stands within a round', "give it a line of its own, without a colon", span)
    if not in_round and not rule.outside:
        source.error(f'"{word}" stands outside a round', "begin the line with a colon", span)
    if bracket and not rule.in_brackets:
        source.error(f'"{word}" is not repeated', "take it out of the brackets", span)
    if name == "bl" and not source.told_of_bl:
        source.told_of_bl = True
        hint = "write BLO for the back loop; here BL ends FLO or BLO"
        source.doubt("BL means both loops here, though printed patterns mean the back loop", hint, span)
    if name in ("mr", "goto", "oval", "fsc"):
        source.last_number = None  # another piece of work, with its own numbers
    labels = tuple(value for value, _ in values[: rule.labels])
    numbers = _numbers(source, name, values, rule.labels)
    if numbers is None:
        return None
    _label_rules(source, name, labels, span)
    return Action(name, span, 1, None, numbers, labels)


def _numbers(source: Source, name: str, values: list[tuple[str, Span]], labels: int) -> tuple[int, ...] | None:
    """The arguments that are no labels, as numbers; None when they are wrong."""
    if name == "color":
        return _color(source, values)
    if name == "attach":
        if len(values) == 1:
            return (0,)
        value, at = values[1]
        if value.lower() == "merge" or value == "997":  # the older dialect's number for it
            return (-1,)
        if not value.isdigit():
            source.error(f'"{value}" is no length of a chain', f"write {RULES[name].usage}", at)
            return None
        return (int(value),)
    if name in ("mr", "gap"):
        value, at = values[0]
        if not value.isdigit() or int(value) == 0:
            source.error(f'"{value}" is no number of stitches', f"write {RULES[name].usage}", at)
            return None
        return (int(value), len(values) - 1) if name == "mr" else (int(value),)
    if name == "tospace":
        if values and values[0][0].lower() != "half":
            source.error(f'"{values[0][0]}" is no part of a space', f"write {RULES[name].usage}", values[0][1])
            return None
        return (len(values),)
    if name == "edge":
        (which, at), *more = values
        if which.lower() not in EDGES:
            source.error(f'"{which}" is no edge', f"write {RULES[name].usage}", at)
            return None
        if more and (not more[0][0].isdigit() or int(more[0][0]) == 0):
            source.error(f'"{more[0][0]}" is no number of stitches', f"write {RULES[name].usage}", more[0][1])
            return None
        return (int(more[0][0]) if more else 0, EDGES.index(which.lower()))
    if name in ("oval", "fsc"):
        for value, at in values:
            if not value.isdigit() or int(value) < (1 if name == "fsc" else 2):
                source.error(f'"{value}" is no number of chains', f"write {RULES[name].usage}", at)
                return None
        return (int(values[0][0]), *([int(values[1][0]) if len(values) > 1 else 2] if name == "oval" else []))
    return ()


def _color(source: Source, values: list[tuple[str, Span]]) -> tuple[int, ...] | None:
    if len(values) == 3:
        found = []
        for value, at in values:
            if not value.isdigit() or int(value) > 255:
                source.error(f'"{value}" is no part of a colour', "red, green and blue are numbers 0 to 255", at)
            else:
                found.append(int(value))
        return tuple(found) if len(found) == 3 else None
    value, at = values[0]
    try:
        return colored(value)
    except ValueError:
        near = did_you_mean(value.lower(), css_colors())
        source.error(f'there is no colour "{value}"', near or RULES["color"].usage, at)
        return None


def _label_rules(source: Source, name: str, labels: tuple[str, ...], span: Span) -> None:
    if name == "mark":
        if labels[0] in source.labels:
            source.error(f'there is a mark "{labels[0]}" already', "give each mark its own name", span)
        elif _COPY.match(labels[0]):
            source.error("a mark's name has no point", "copies of a part get .1, .2 … by themselves", span)
        source.labels[labels[0]] = (source.copies, source.part)
        return
    for label in labels:
        base = label if label in source.labels else (found[1] if (found := _COPY.match(label)) else label)
        copies, part = source.labels.get(base, (0, 0))
        if not copies:
            hint = did_you_mean(label, source.labels) or f"set it first: mark({label})"
            source.error(f'there is no mark "{label}" before this', hint, span)
        elif base == label and copies > 1 and part != source.part:
            source.error(f'the mark "{label}" is in a part made {copies} times', f"{label}.1 is the first copy's", span)
        elif base != label and not 1 <= int(label.rsplit(".", 1)[1]) <= copies:
            source.error(f'"{label}" is not there: the part is made {copies} times', f"up to {base}.{copies}", span)


def _nearest(word: str, known: list[str]) -> str:
    """The house's hint, also for words of two or three letters, where one letter wrong is half the word."""
    near = [k for k in known if len(k) == len(word) < 4 and sum(a != b for a, b in zip(k, word)) == 1]
    if not near:
        return did_you_mean(word, known)
    return "did you mean " + " or ".join(f'"{k}"' for k in near[:2]) + "?"
