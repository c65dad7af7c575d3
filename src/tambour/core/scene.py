"""Scene: surfaces and strands in one space that move together."""

from __future__ import annotations

from dataclasses import dataclass

from tambour.core.errors import LawError
from tambour.core.mesh import Mesh
from tambour.core.strands import Strands


@dataclass(frozen=True, eq=False, slots=True)
class Scene:
    """Named surfaces and strands; those that move have equally many frames.

    meshes, strands : tuples; ``names`` : one for each, meshes first; ``root`` : what files call all of it
    """

    meshes: tuple[Mesh, ...]
    strands: tuple[Strands, ...]
    names: tuple[str, ...]
    root: str = "embroidery"

    def __post_init__(self) -> None:
        if len(self.names) != len(self.meshes) + len(self.strands) or len(set(self.names)) != len(self.names):
            raise LawError("Scene.names: one for each mesh and each set of strands, all different")
        counts = {it.frame_count for it in self.things if it.frame_count > 1}
        if len(counts) > 1:
            raise LawError(f"Scene: things with {sorted(counts)} frames cannot move together")

    @property
    def things(self) -> list[Mesh | Strands]:
        """Meshes, then strands: in the order of ``names``."""
        return [*self.meshes, *self.strands]

    @property
    def frame_count(self) -> int:
        """Frames of the things that move, 1 when none does."""
        return max((it.frame_count for it in self.things), default=1)

    @property
    def seconds_per_frame(self) -> float:
        """Time between frames."""
        moving = [it for it in self.things if it.frame_count > 1]
        return moving[0].seconds_per_frame if moving else 1 / 24
