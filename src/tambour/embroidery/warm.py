"""One call of every kernel on a tiny drawing, so that no measured stage holds their loading."""

from __future__ import annotations

import numpy as np

from tambour.core.drawing import Drawing, Styles
from tambour.core.paths import Paths
from tambour.core.progress import Progress
from tambour.embroidery.facts import facts
from tambour.embroidery.make import make
from tambour.embroidery.params import EmbroideryParams


def warm() -> None:
    """Embroider a notched 12 mm square."""
    ring = np.array([[0, 0], [12, 0], [12, 12], [7, 12], [6, 3], [5, 12], [0, 12], [0, 0]], np.float64)
    drawing = Drawing(Paths.of([ring]), np.zeros(1), Styles.of(((0, 0, 0, 255), None, 0.0)), np.array([12.0, 12.0]))
    facts(make(drawing, EmbroideryParams(row_spacing=1), Progress()))
