"""The exception of the package."""
from __future__ import annotations

from typing import Sequence

from ._core import Fault


class MeshError(ValueError):
    """Invalid input, or a file that cannot be read or written.

    ``faults`` lists everything that is wrong: each fault has ``code``, ``message``, ``advice`` and, where it is
    known, the place ``at`` as (x, y) and the ``parts`` of the domain.
    """

    def __init__(self, faults: Sequence[Fault]) -> None:
        self.faults = list(faults)
        super().__init__("\n".join(str(fault) for fault in self.faults))

    def __reduce__(self):
        return MeshError, (self.faults,)
