"""Checks of keyword arguments that a public function passes on."""
from __future__ import annotations

import difflib
import functools
import inspect
import sys
import warnings
from typing import Any, Callable, Iterable, Sequence

from . import _core
from ._core import Fault


def refuse_unknown(function: str, given: Iterable[str], known: Sequence[str]) -> None:
    """Raises TypeError for a name that a public function does not take."""
    for name in given:
        if name in known:
            continue
        if name in _core.reading_options():
            raise TypeError(f"{function}() has no argument '{name}', which belongs to the reading of files: pass "
                            f"Domain.read(file, {name}=...) as the domain")
        raise TypeError(f"{function}() has no argument '{name}'{_hint(name, known)}")


def _hint(name: str, known: Sequence[str]) -> str:
    nearest = difflib.get_close_matches(name, known, 1)
    if nearest:
        return f"; did you mean '{nearest[0]}'?"
    nearest = difflib.get_close_matches(name, _core.reading_options(), 1)
    if nearest:
        return f"; did you mean '{nearest[0]}' of Domain.read(), whose result is a domain?"
    return f"; expected one of {', '.join(known)}"


@functools.lru_cache(maxsize=None)
def names_of(function: Callable[..., Any]) -> Sequence[str]:
    """Returns the keyword arguments of a function."""
    return [name for name, parameter in inspect.signature(function).parameters.items()
            if parameter.kind == inspect.Parameter.KEYWORD_ONLY]


def warn_of(notes: Iterable[Fault]) -> None:
    """Gives Python's warnings for the warnings of a reader, at the line that called the package."""
    depth = 1
    while sys._getframe(depth).f_globals.get("__name__", "").startswith("forefront.") and sys._getframe(depth).f_back:
        depth += 1
    for note in notes:
        if note.severity == "warning":
            warnings.warn(str(note), UserWarning, stacklevel=depth + 1)
