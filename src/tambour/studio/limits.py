"""Limits: every number that bounds what a page can ask for."""

from __future__ import annotations

from typing import Final

MB: Final = 1 << 20

UPLOAD: Final = 64 * MB
"""Bytes of a file that is given."""
TEXT: Final = 1_000_000
"""Characters of a text that is given."""
BODY: Final = 4 * MB
"""Bytes of a request that is no file: a text, escaped as JSON may, and what stands around it."""
PARAMS: Final = 64_000
"""Characters of parameters, as JSON."""
EDITS: Final = 100_000
"""Edits of a piece."""
TITLE: Final = 200
"""Characters of a title."""
NAME: Final = 120
"""Characters of a file's name."""
TARGET: Final = 8_000
"""Bytes of an address."""
HEADERS: Final = 16_000
"""Bytes of a request's head."""

PAUSE: Final = 10.0
"""Seconds that a request's body may make one wait for its next bytes."""
CONNECTIONS: Final = 300
"""Connections at once, requests and sockets together."""
SOCKETS: Final = 32
"""Sockets at once, of all pages."""
SOCKETS_EACH: Final = 8
"""Sockets at once of one browser (of one cookie)."""
SOCKETS_RATE: Final = 60
"""Sockets that may be opened in ten seconds."""
MESSAGE: Final = 64_000
"""Bytes of a message on a socket."""
FRAMES: Final = 60
"""States a second that a page can ask for."""

WORDS: Final = 200
"""Words of a hand on a piece that wait to be heard."""
QUIET: Final = 60.0
"""Seconds after its last word that a hand is taken from a piece."""

QUEUE: Final = 16
"""Jobs that wait for a worker."""
MAKE_SECONDS: Final = 600.0
"""Time of one job."""
CHECK_SECONDS: Final = 30.0
"""Time to check a text."""
MEMORY: Final = 2048 * MB
"""Bytes of a worker."""
CACHE: Final = 512 * MB
"""Bytes of what was made and may be asked for again."""

LISTED: Final = 50
"""Pieces on a page of the list."""
MERGED: Final = 2_000
"""Milliseconds in which typing makes one revision."""
BINNED_DAYS: Final = 30
"""Days that a piece stays in the bin."""
PAIR_SECONDS: Final = 120
"""Time that a code for a phone is good for."""
PAIRS: Final = 8
"""Codes that are good at once."""
