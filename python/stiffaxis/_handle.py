"""What the library made and this module has to give back."""

from __future__ import annotations

import weakref
from typing import Any, Optional, TypeVar

Self = TypeVar("Self", bound="Handle")


class Handle:
    """Freed by ``close``, at the end of a ``with`` block, or with the object; what was made from it goes on living."""

    def __init__(self, handle: int, free: Any) -> None:
        self._pointer: Optional[int] = handle
        self._free = weakref.finalize(self, free, handle)

    @property
    def _handle(self) -> int:
        if self._pointer is None:
            raise ValueError("this %s is closed" % type(self).__name__)
        return self._pointer

    @property
    def closed(self) -> bool:
        return self._pointer is None

    def close(self) -> None:
        """Gives the memory back; any later use is a ValueError. Twice does no harm."""
        self._pointer = None
        self._free()

    def __enter__(self: Self) -> Self:
        self._handle
        return self

    def __exit__(self, *unused: Any) -> None:
        self.close()
