"""What the library made and this module has to give back."""

from __future__ import annotations

import weakref
from typing import Any, Optional, TypeVar

Self = TypeVar("Self", bound="Handle")


class Owned:
    """One pointer of the library's. A call that is given it holds on to it, so that what another thread closes meanwhile is freed
    after the call."""

    __slots__ = ("_as_parameter_", "__weakref__")

    def __init__(self, pointer: int, free: Any) -> None:
        self._as_parameter_ = pointer
        # not at the end of the program: other threads may still be in the library
        weakref.finalize(self, free, pointer).atexit = False


class Handle:
    """Freed by ``close``, at the end of a ``with`` block, or with the object; what was made from it goes on living."""

    def __init__(self, pointer: int, free: Any) -> None:
        self._owned: Optional[Owned] = Owned(pointer, free)

    @property
    def _handle(self) -> Owned:
        owned = self._owned
        if owned is None:
            raise ValueError("this %s is closed" % type(self).__name__)
        return owned

    @property
    def closed(self) -> bool:
        """Whether ``close`` was called."""
        return self._owned is None

    def close(self) -> None:
        """Gives the memory back, after the calls that other threads are in; any later use is a ValueError. Twice does no harm."""
        self._owned = None

    def __enter__(self: Self) -> Self:
        self._handle
        return self

    def __exit__(self, *unused: Any) -> None:
        self.close()

    def __reduce__(self) -> Any:
        raise TypeError(
            "a %s lives in this process alone and is neither copied nor pickled: make another one from its case; solutions, shapes "
            "and stations may be" % type(self).__name__)
