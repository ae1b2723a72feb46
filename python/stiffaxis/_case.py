"""A case file."""

from __future__ import annotations

import os
from typing import Optional, Union

from ._handle import Handle
from ._library import Settings, encode, library, make, settings_arguments
from ._rod import Rod
from ._section import Section


class Case(Handle):
    """A case, read and checked: ``InputError`` with file, line and column where something is wrong with it.

    path: of the case file. settings: other values of its keys, as ``--set`` takes them: ``{"rod.length_mm": 100}`` or
    ``["rod.length_mm=100"]``. allow_scripts: a ``geo:`` section may run its script.
    """

    def __init__(self, path: Union[str, os.PathLike], settings: Settings = None, *, allow_scripts: bool = False) -> None:
        count, texts = settings_arguments(settings)
        handle = make(library.stiffaxis_case_open, encode(path), count, texts, int(allow_scripts))
        super().__init__(handle, library.stiffaxis_case_free)

    @classmethod
    def from_text(cls, text: str, settings: Settings = None, *, name: str = "case.yaml", allow_scripts: bool = False) -> Case:
        """A case that no file holds. name: what messages call it; its folder is where the case's own files are looked for."""
        count, texts = settings_arguments(settings)
        handle = make(library.stiffaxis_case_read, encode(text), encode(name), count, texts, int(allow_scripts))
        case = cls.__new__(cls)
        Handle.__init__(case, handle, library.stiffaxis_case_free)
        return case

    @property
    def title(self) -> Optional[str]:
        """As the case has it; None where it has none."""
        title = library.stiffaxis_case_title(self._handle)
        return None if title is None else title.decode("utf-8", "replace")

    @property
    def length_m(self) -> float:
        """Of the rod, else of the segment, else up to the last station [m]."""
        return library.stiffaxis_case_length(self._handle)

    @property
    def has_section(self) -> bool:
        return bool(library.stiffaxis_case_has_section(self._handle))

    @property
    def has_rod(self) -> bool:
        return bool(library.stiffaxis_case_has_rod(self._handle))

    def section(self) -> Section:
        """Solves the sections that the case and its rod need, as ``stiffaxis section`` does."""
        return Section(make(library.stiffaxis_section_make, self._handle))

    def rod(self, settings: Settings = None) -> Rod:
        """The sections and the rod on them, in one go; ``Section.rod`` where more rods share their sections."""
        with self.section() as section:
            return section.rod(settings)
