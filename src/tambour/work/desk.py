"""Desk: what a worker that makes pieces can do: grow warm, and make pieces, by the function that each names."""

from __future__ import annotations

import traceback
from importlib import import_module
from pathlib import Path
from typing import Any

from tambour.core.errors import TambourError
from tambour.core.progress import Progress


class Pieces:
    """Makes pieces and keeps nothing."""

    def do(self, job: dict[str, Any], progress: Progress) -> dict[str, Any]:
        """Nothing, where it shall grow warm for ``job["craft"]``; else the piece of ``job["piece"]``: its report, the names of its files, and in "frames" their bytes."""
        from tambour.work.piece import Job
        from tambour.work.warm import warm

        if job["do"] == "warm":
            warm([job["craft"]])
            return {}

        made = Job(**job["piece"])
        module, _, name = made.how.partition(":")
        done = getattr(import_module(module), name)(
            made, {name: Path(at) for name, at in job["laid"].items()}, progress
        )
        frames = [*done.files.values(), done.thumb]
        return {"report": done.report, "names": list(done.files), "frames": frames}

    def failed(self, job: dict[str, Any], error: Exception) -> dict[str, Any]:
        """Why there is no piece."""
        if isinstance(error, TambourError):
            return {"reason": "\n".join(str(p) for p in error.problems), "fault": ""}
        if isinstance(error, MemoryError):
            return {"reason": "it needs more memory than a piece may take", "fault": ""}
        told = f"a fault of tambour's: {type(error).__name__}: {error}"
        return {"reason": told, "fault": "".join(traceback.format_exception(error))}
