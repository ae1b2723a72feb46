"""How a call of the library says that it failed."""

from __future__ import annotations

import re
from typing import Any, Optional

_PLACE = re.compile(r"^(?P<file>[^\n]*?):(?P<line>\d+):(?P<column>\d+): ")


class Error(Exception):
    """What stiffaxis says failed; ``str`` of it is the program's own line, ``FILE:LINE:COL: error: ...`` for a case.

    file, line, column: the place, counted from 1; None where the message has none. code: the program's exit code.
    """

    code = 0

    def __init__(self, message: str) -> None:
        super().__init__(message)
        place = _PLACE.match(message)
        self.message: str = message
        self.file: Optional[str] = place["file"] if place else None
        self.line: Optional[int] = int(place["line"]) if place else None
        self.column: Optional[int] = int(place["column"]) if place else None


class InputError(Error, ValueError):
    """A mistake in the case, in a setting or in a request."""

    code = 2


class FileError(Error):
    """An input file is damaged or of an unsupported kind."""

    code = 3


class NumericError(Error, ArithmeticError):
    """No convergence."""

    code = 4


class LimitPoint(NumericError):
    """The rod snaps on the way to the request. solution: the answer there, with ``fraction`` < 1; the state is at it."""

    def __init__(self, message: str, solution: Any) -> None:
        super().__init__(message)
        self.solution = solution

    def __reduce__(self) -> Any:  # out of another process it comes whole
        return type(self), (self.message, self.solution)


class ResourceError(Error):
    """Out of memory, disk or time, or a module of stiffaxis is missing."""

    code = 5


class BugError(Error):
    """A mistake of stiffaxis itself."""

    code = 6


ERRORS = {kind.code: kind for kind in (InputError, FileError, NumericError, ResourceError, BugError)}
