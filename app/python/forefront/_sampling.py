"""Size functions sampled on grids, so that meshing does not call Python for every node."""
from __future__ import annotations

from typing import Any, Callable, Optional, Tuple

import numpy as np

#: The interpolation may deviate from the function by this fraction of it.
TOLERANCE = 0.02
#: Numbers of cells along the longer side of the domain, coarse to fine.
LEVELS = (64, 128, 256, 512)


class Sampled:
    """Sizes at the nodes of a grid over a box, and how far their interpolation is from the function."""

    def __init__(self, function: Callable[[np.ndarray, np.ndarray], Any], bounds: Tuple[float, float, float, float],
                 cells: int) -> None:
        x0, y0, x1, y1 = bounds
        width, height = x1 - x0, y1 - y0
        margin = 1e-6 * max(width, height)
        self.function = function
        self.origin = (x0 - margin, y0 - margin)
        self.columns = max(2, round(cells * width / max(width, height))) + 1
        self.rows = max(2, round(cells * height / max(width, height))) + 1
        self.pitch = ((width + 2 * margin) / (self.columns - 1), (height + 2 * margin) / (self.rows - 1))
        x, y = np.meshgrid(self.origin[0] + self.pitch[0] * np.arange(self.columns),
                           self.origin[1] + self.pitch[1] * np.arange(self.rows))
        self.values = call(function, x.ravel(), y.ravel()).reshape(self.rows, self.columns)

    def interpolated(self, x: np.ndarray, y: np.ndarray) -> np.ndarray:
        u, v = (x - self.origin[0]) / self.pitch[0], (y - self.origin[1]) / self.pitch[1]
        i = np.clip(u.astype(np.int64), 0, self.columns - 2)
        j = np.clip(v.astype(np.int64), 0, self.rows - 2)
        u, v = u - i, v - j
        low = (1 - u) * self.values[j, i] + u * self.values[j, i + 1]
        high = (1 - u) * self.values[j + 1, i] + u * self.values[j + 1, i + 1]
        return (1 - v) * low + v * high

    def error(self, points: np.ndarray, sizes: Optional[np.ndarray] = None) -> float:
        """Returns the largest relative deviation at points (n, 2), whose sizes may be known."""
        if len(points) == 0:
            return 0.0
        x, y = np.ascontiguousarray(points[:, 0]), np.ascontiguousarray(points[:, 1])
        exact = call(self.function, x, y) if sizes is None else sizes
        return float(np.max(np.abs(self.interpolated(x, y) - exact) / exact))

    def nodes(self) -> np.ndarray:
        x, y = np.meshgrid(self.origin[0] + self.pitch[0] * np.arange(self.columns),
                           self.origin[1] + self.pitch[1] * np.arange(self.rows))
        return np.column_stack([x.ravel(), y.ravel()])

    @property
    def usable(self) -> bool:
        return bool(np.all(np.isfinite(self.values)) and np.all(self.values > 0.0))


def call(function: Callable[[np.ndarray, np.ndarray], Any], x: np.ndarray, y: np.ndarray) -> np.ndarray:
    """Returns the sizes at points as an array with one for each."""
    values = np.asarray(function(x, y), dtype=float)
    if values.ndim == 0:
        return np.full(len(x), float(values))
    if values.shape != x.shape:
        raise ValueError(f"size: expected the function to return one value for each of the {len(x)} points, or one "
                         f"number; got {values.size} values")
    return values


def sampled(function: Callable[[np.ndarray, np.ndarray], Any],
            bounds: Tuple[float, float, float, float]) -> Optional[Sampled]:
    """Returns the function on the coarsest grid on which it is interpolated to within the tolerance.

    None: no grid is fine enough, or the function is not positive all over the box; then it must be called itself.
    """
    if not (np.all(np.isfinite(bounds)) and bounds[2] > bounds[0] and bounds[3] > bounds[1]):
        return None
    coarse: Optional[Sampled] = None
    for cells in LEVELS:
        fine = Sampled(function, bounds, cells)
        if not fine.usable:
            return None
        if coarse is not None and coarse.error(fine.nodes(), fine.values.ravel()) <= TOLERANCE:
            return fine
        coarse = fine
    return None
