"""Terms: the words of printed patterns, a table per language; the reader and the writer share them."""

from __future__ import annotations

from typing import Final

from tambour.crochet.terms_de import DE
from tambour.crochet.terms_es import ES
from tambour.crochet.terms_fr import FR
from tambour.crochet.terms_letters import LETTERS
from tambour.crochet.terms_nl import NL
from tambour.crochet.terms_uk import UK
from tambour.crochet.terms_us import US
from tambour.crochet.wording import SENTENCES, WORDS, Terms

__all__ = ["SENTENCES", "TERMS", "WORDS", "Terms"]

TERMS: Final[dict[str, Terms]] = {t.code: t for t in (US, UK, ES, DE, FR, NL, LETTERS)}
"""Code → table."""
