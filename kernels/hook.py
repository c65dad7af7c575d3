"""Hook: what hatchling asks when it builds a wheel, or installs this folder to be worked on."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from kernels import build


class KernelsHook(BuildHookInterface):  # type: ignore[type-arg,misc]
    """Builds the kernels and puts them into the wheel."""

    def dependencies(self) -> list[str]:
        """Numba, when something is to be compiled."""
        return build.needs()

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build, and name the wheel for its platform."""
        if not build.here():
            return
        build.build()
        build_data["artifacts"].append(f"/{build.BUILT.relative_to(self.root)}")
        build_data["pure_python"] = False
        build_data["tag"] = "cp311-abi3-linux_x86_64"
