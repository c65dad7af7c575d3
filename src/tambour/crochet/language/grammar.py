"""One line of a pattern → its syntax tree, and a sentence for what does not fit the grammar."""

from __future__ import annotations

import re

from tambour.core.errors import Problem, Span, Text
from tambour.crochet.language.lalr import END, DoesNotFit, Tree, grammar

DEEPEST = 24  # brackets within brackets
LONGEST = 9  # digits of a number

_HEX = re.compile(r"#(?:[0-9A-Fa-f]{3}|[0-9A-Fa-f]{6})\s*[,)]")
_TRAILING = re.compile(r",(?=\s*(\(\s*\d+\s*[a-z]*\s*\)\s*)?$)")

# What a terminal is called in a sentence, in the order they are offered.
_SAID = {
    "NAME": "a stitch or an action",
    "INT": "a number",
    "NUMBER": "a number",
    "VALUE": "a value (a number or a word)",
    "ARG": "an argument",
    "LSQB": '"["',
    "RSQB": '"]"',
    "RBRACE": '"}"',
    "CLOSE": '")"',
    "RPAR": '")"',
    "TIMES": '"x" and a number',
    "AROUND": '"around"',
    "COMMA": "a comma",
    "EQUAL": '"="',
    "COLON": '":"',
    "ROUNDS": '"rounds"',
    "MAKE": '"make" and a number',
    "HEIGHT": '"height" and a number',
}


def without_comment(line: str) -> str:
    """The line up to its comment; ``#`` before a colour's hex digits, as in ``color(#ff8800)``, begins none."""
    at = line.find("#")
    while at >= 0 and _HEX.match(line, at):
        before = at - 1
        while before >= 0 and line[before] in " \t":
            before -= 1
        if before < 0 or line[before] not in "(,=":
            break
        at = line.find("#", at + 1)
    return line if at < 0 else line[:at]


def read_line(line: str, start: int, text: Text) -> tuple[Tree | None, list[Problem]]:
    """The tree of one line (no comment in it) that begins at offset ``start`` of ``text``, and what is wrong.

    The tree is None when an error is among the problems; a trailing comma is only a warning.
    """
    problems: list[Problem] = []

    def report(message: str, hint: str, begin: int, end: int, warning: bool = False) -> None:
        problems.append(Problem(message, hint, Span(start + begin, start + end), text, warning=warning))

    comma = _TRAILING.search(line)
    if comma and line[: comma.start()].strip(" \t,"):
        report("a comma with nothing after it", "leave it out", comma.start(), comma.start() + 1, True)
        line = line[: comma.start()] + " " + line[comma.start() + 1 :]
    for number in re.finditer(rf"\d{{{LONGEST + 1},}}", line):
        report("this number is too large", f"numbers have at most {LONGEST} digits", number.start(), number.end())
    depth = 0
    for at, sign in enumerate(line):
        depth += (sign in "[({") - (sign in "])}")
        if depth > DEEPEST:
            report("brackets are nested too deep", f"at most {DEEPEST} levels", at, at + 1)
            break
    if any(not p.warning for p in problems):
        return None, problems
    try:
        return grammar().parse(line), problems
    except DoesNotFit as error:
        token, wanted = error.token, _wanted(error.wanted)
        if token.type == END:
            begin = len(line.rstrip())
            report("the line ends too early", wanted, begin, begin + 1)
        else:
            report(f'"{token}" does not fit here', wanted, token.start_pos, token.end_pos)
    return None, problems


def _wanted(terminals: set[str]) -> str:
    if {"$END", "NAME"} & terminals and "COMMA" in terminals:
        return "a comma goes between stitches; a comment begins with #"
    said = [words for name, words in _SAID.items() if name in terminals]
    return f"{' or '.join(dict.fromkeys(said))} is wanted here" if said else "a comment begins with #"
