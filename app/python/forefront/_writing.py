"""What files get beyond the mesh: the arguments of Mesh.write()."""
from __future__ import annotations

import os
from pathlib import Path
from typing import TYPE_CHECKING, Any, Dict, List, Optional, Sequence, Tuple, Union

import numpy as np

from ._core import Fault

if TYPE_CHECKING:
    from ._mesh import Mesh

_RASTERS = (".asc", ".tif", ".tiff")


def form_of(mesh: "Mesh", *, inner_edges: Optional[bool] = None, numbering: str = "creation", elevation: Any = None,
            extrude: Union[None, float, Tuple[float, int]] = None, open: Union[str, int, Sequence[Union[str, int]]] = (),
            tags: str = "apart", unit: Optional[str] = None) -> Tuple[Dict[str, Any], List[Fault]]:
    """Returns the arguments of :meth:`Mesh.write` as the core takes them, and notes on the elevations."""
    heights, notes = _elevations(mesh, elevation)
    parts = [open] if isinstance(open, (str, int)) else list(open)
    form = {
        "inner_edges": inner_edges, "numbering": numbering, "elevation": heights, "tags": tags, "unit": unit,
        "open": [mesh._tag(part, mesh.boundary_names, "boundary part") for part in parts],
        "extrude": extrude if extrude is None or np.ndim(extrude) == 1 else (float(extrude), 1),
    }
    return form, notes


def _elevations(mesh: "Mesh", elevation: Any) -> Tuple[Optional[np.ndarray], List[Fault]]:
    if elevation is None:
        return None, []
    if callable(elevation):
        x, y = mesh.nodes.T
        return np.broadcast_to(np.asarray(elevation(x, y), float), len(mesh.nodes)), []
    if hasattr(elevation, "__fspath__") or (isinstance(elevation, str) and _names_file(elevation)):
        return mesh._raster_elevations(os.fspath(elevation))
    if isinstance(elevation, str):
        return mesh._expression_elevations(elevation), []
    return np.asarray(elevation, float), []


def _names_file(text: str) -> bool:
    """Returns whether a text is a file rather than an expression, as for ``--elevation``."""
    return Path(text).suffix.lower() in _RASTERS or os.path.exists(text)
