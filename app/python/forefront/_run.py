"""Runs that are stepped, forward and back."""
from __future__ import annotations

import html
import json
import os
from dataclasses import dataclass
from typing import Any, Dict, Iterator, List, Optional

import numpy as np

from . import _core
from ._arguments import names_of, refuse_unknown
from ._errors import MeshError
from ._mesh import Mesh
from ._sizes import Job, job_of


@dataclass(frozen=True)
class Moment:
    """A run after an advance of the front."""

    position: int  #: number of advances done
    front: np.ndarray  #: (s, 2, 2): segment, end, coordinate; the unmeshed part is on the left
    base: np.ndarray  #: (2, 2): the segment that the advance started from
    ideal: np.ndarray  #: (2,): the ideal point
    candidates: List[Dict[str, Any]]  #: at, node, alpha, score, rho, verdict; the best first
    made: List[np.ndarray]  #: (3, 2): the corners of each new element
    caption: str  #: what happened, in a sentence


class Run:
    """A run that moves one advance of the front at a time. Use each run from one thread at a time.

    Iterating moves it forward and gives a :class:`Moment` after each advance. The state at a position does not depend on
    the way there, and :meth:`finish` gives the mesh of :func:`mesh`. Ctrl-C ends a move at the position reached, from where
    the run can go on; in :meth:`finish`, it ends the run.
    """

    def __init__(self, job: Job, progress: Any = None) -> None:
        self._job = job
        self._stepper = _core.Stepper(*job.arguments, progress)

    @property
    def position(self) -> int:
        """The number of advances done."""
        return self._stepper.position

    @property
    def at_end(self) -> bool:
        """Whether the front is empty."""
        return self._stepper.at_end

    def advance(self, count: int = 1) -> int:
        """Moves forward, and returns by how many advances: fewer at the end."""
        return self._stepper.advance(count)

    def retreat(self, count: int = 1) -> int:
        """Moves back, and returns by how many advances: fewer at the start."""
        return self._stepper.retreat(count)

    def seek(self, position: int) -> None:
        """Moves to a position, or to the end if that comes first."""
        self._stepper.seek(position)

    def finish(self, progress: Any = None) -> Mesh:
        """Moves to the end, improves the mesh and returns it."""
        self._stepper.finish(progress)
        return self.mesh

    @property
    def front(self) -> np.ndarray:
        """The segments of the front: shape (s, 2, 2)."""
        return self._stepper.front()

    @property
    def mesh(self) -> Mesh:
        """The mesh at this position. A partial mesh has all nodes and edges of the boundary."""
        return Mesh(self._stepper.mesh(self._job.domain))

    def explanation(self) -> Optional[Dict[str, Any]]:
        """Returns everything about the last advance as a dict; None before the first."""
        return self._stepper.explanation()

    def moment(self) -> Moment:
        """Returns the last advance with the front that it left."""
        told = self.explanation()
        if told is None:
            raise ValueError("the run has not advanced yet")
        return Moment(self.position, self.front, told["base"], np.array(told["ideal"]), told["candidates"],
                      told["made"], told["caption"])

    def __iter__(self) -> Iterator[Moment]:
        while self.advance() == 1:
            yield self.moment()

    def page(self, title: str = "", start: int = 0, steps: Optional[int] = None, progress: Any = None) -> str:
        """Returns an HTML page that plays the run in a browser without a network.

        start: number of advances done when the page opens. steps: number of advances after those; None: to the end.
        """
        return _core.run_page(*self._job.arguments, title, start, steps, progress)

    def film(self, path: Any, *, start: int = 0, steps: Optional[int] = None, frames: int = 120, width: int = 800,
             speed: float = 10.0, layers: Optional[List[str]] = None, progress: Any = None) -> int:
        """Writes a film of the run from its beginning, and returns the number of frames.

        path: FILE.gif, an animation; NAME-%d.png, .svg or .pdf, a picture for each frame; FILE.png, .svg or .pdf, the last
        moment; FILE.html, a page. start: number of advances done at the first frame. steps: number of advances shown; None: to
        the end. frames: at most. width: pixels. speed: frames per second of an animation. layers: of 'mesh', 'boundary',
        'front', 'candidates', 'grid', 'caption', 'labels'.
        """
        given = {"start": start, "steps": steps, "frames": frames, "width": width, "speed": speed, "layers": layers}
        return _core.run_film(*self._job.arguments, os.fspath(path), given, progress)[0]

    def trace(self, steps: Optional[int] = None) -> Dict[str, Any]:
        """Returns the boundary and every advance from the beginning, as ``forefront trace`` writes them."""
        return json.loads(_core.run_trace(*self._job.arguments, steps))

    def _repr_html_(self) -> Optional[str]:
        try:
            page = self.page()
        except MeshError:  # too long for a page: the picture stands for it
            return None
        return f'<iframe srcdoc="{html.escape(page)}" width="100%" height="640" style="border:0"></iframe>'

    def _repr_svg_(self) -> str:
        return self.mesh._repr_svg_()


def run(domain: Any, size: Any = None, *, progress: Any = None, **options: Any) -> Run:
    """Prepares a run before its first advance. Arguments: as for :func:`mesh`; elements must be triangles.

    method='classic' makes one element per advance by S. H. Lo's ten steps; 'fast' up to three.
    """
    refuse_unknown("run", options, names_of(job_of))
    return Run(job_of(domain, size, progress=progress, **options), progress)
