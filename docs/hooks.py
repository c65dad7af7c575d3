"""What the book does besides: the examples of docstrings, ``>>> …`` down to an empty line, are shown as Python's own dialogue."""

from __future__ import annotations

from typing import Any

from markdown import Markdown
from markdown.extensions import Extension
from markdown.preprocessors import Preprocessor


class Dialogue(Preprocessor):
    """Fences round examples, which Markdown would take for quotations of quotations."""

    def run(self, lines: list[str]) -> list[str]:
        """The lines, fenced."""
        made: list[str] = []
        inside = fenced = False
        for line in [*lines, ""]:
            fenced ^= line.lstrip().startswith("```")
            if not inside and not fenced and line.startswith(">>> "):
                made.append("```pycon")
                inside = True
            elif inside and not line.strip():
                made.append("```")
                inside = False
            made.append(line)
        return made


class Examples(Extension):
    """Puts it before all that Markdown does."""

    def extendMarkdown(self, md: Markdown) -> None:
        """Markdown asks for this."""
        md.preprocessors.register(Dialogue(md), "dialogue", 40)


def on_config(config: Any) -> Any:
    """mkdocs asks for this, once."""
    config.markdown_extensions.append(Examples())
    return config
