"""Paths, open files and bytes as the core reads them."""
from __future__ import annotations

import os
from typing import Any, Tuple


def source_of(file: Any, file_format: str | None) -> Tuple[Any, str]:
    """Returns a path or bytes, and the id of the format; empty: by content and name."""
    if isinstance(file, (bytes, bytearray, memoryview)):
        return bytes(file), file_format or ""
    if hasattr(file, "read"):
        content = file.read()
        return content.encode() if isinstance(content, str) else content, file_format or ""
    return os.fspath(file), file_format or ""
