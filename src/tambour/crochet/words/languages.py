"""Terms: the words of printed patterns, a table per language; the reader and the writer share them."""

from __future__ import annotations

from typing import Final

from tambour.crochet.words.de import DE
from tambour.crochet.words.es import ES
from tambour.crochet.words.fr import FR
from tambour.crochet.words.letters import LETTERS
from tambour.crochet.words.nl import NL
from tambour.crochet.words.table import SENTENCES, WORDS, Terms
from tambour.crochet.words.uk import UK
from tambour.crochet.words.us import US

__all__ = ["SENTENCES", "TERMS", "WORDS", "Terms"]

TERMS: Final[dict[str, Terms]] = {t.code: t for t in (US, UK, ES, DE, FR, NL, LETTERS)}
"""Code → table."""
