"""Arrays: short names for an element type and a number of axes, as kernels declare them: F8x2 is float64 (N, M)."""

from __future__ import annotations

from typing import Annotated

import numpy as np
from numpy.typing import NDArray

F8x1 = Annotated[NDArray[np.float64], 1]
F8x2 = Annotated[NDArray[np.float64], 2]
F8x3 = Annotated[NDArray[np.float64], 3]
F4x1 = Annotated[NDArray[np.float32], 1]
F4x2 = Annotated[NDArray[np.float32], 2]
F4x3 = Annotated[NDArray[np.float32], 3]
I8x1 = Annotated[NDArray[np.int64], 1]
I8x2 = Annotated[NDArray[np.int64], 2]
I4x1 = Annotated[NDArray[np.int32], 1]
I4x2 = Annotated[NDArray[np.int32], 2]
I1x1 = Annotated[NDArray[np.int8], 1]
U1x1 = Annotated[NDArray[np.uint8], 1]
U1x2 = Annotated[NDArray[np.uint8], 2]
U8x1 = Annotated[NDArray[np.uint64], 1]
B1x1 = Annotated[NDArray[np.bool_], 1]
B1x2 = Annotated[NDArray[np.bool_], 2]
