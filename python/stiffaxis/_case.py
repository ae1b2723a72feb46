"""A case file."""

from __future__ import annotations

from typing import Any, Mapping, Optional

from ._handle import Handle
from ._library import FilePath, Settings, encode, encode_path, library, make, settings_arguments, yaml_of
from ._rod import Rod
from ._section import Section


class Case(Handle):
    """A case, read and checked: ``InputError`` with file, line and column where something is wrong with it.

    path: of the case file. settings: other values of its keys, as ``--set`` takes them: ``{"rod.length_mm": 100}`` or
    ``["rod.length_mm=100"]``. allow_scripts: a ``geo:`` section may run its script.
    """

    def __init__(self, path: FilePath, settings: Settings = None, *, allow_scripts: bool = False) -> None:
        count, texts = settings_arguments(settings)
        pointer = make(library.stiffaxis_case_open, encode_path(path), count, texts, int(allow_scripts))
        super().__init__(pointer, library.stiffaxis_case_free)

    @classmethod
    def from_text(cls, text: str, settings: Settings = None, *, name: FilePath = "case.yaml",
                  allow_scripts: bool = False) -> Case:
        """A case that no file holds. name: what messages call it; its folder is where the case's own files are looked for."""
        count, texts = settings_arguments(settings)
        pointer = make(library.stiffaxis_case_read, encode(text), encode_path(name), count, texts, int(allow_scripts))
        case = cls.__new__(cls)
        Handle.__init__(case, pointer, library.stiffaxis_case_free)
        return case

    @classmethod
    def from_dict(cls, case: Mapping[str, Any], settings: Settings = None, *, name: FilePath = "case.yaml",
                  allow_scripts: bool = False) -> Case:
        """A case made in Python: the keys of a case file with numbers, texts, lists and numpy arrays as values,
        ``{"format": 1, "materials": {"soft": {"E_MPa": 0.66, "nu": 0.3}}, "section": {"shapes": [...]}}``; all else as
        ``from_text``."""
        return cls.from_text(yaml_of(case), settings, name=name, allow_scripts=allow_scripts)

    @property
    def title(self) -> Optional[str]:
        """As the case has it; None where it has none."""
        title = library.stiffaxis_case_title(self._handle)
        return None if title is None else title.decode("utf-8", "replace")

    @property
    def length_m(self) -> float:
        """Of the rod, else of the segment, else up to the last station [m]."""
        return float(library.stiffaxis_case_length(self._handle))

    @property
    def has_section(self) -> bool:
        """Whether ``section`` has something to solve."""
        return bool(library.stiffaxis_case_has_section(self._handle))

    @property
    def has_rod(self) -> bool:
        """Whether ``rod`` has something to make."""
        return bool(library.stiffaxis_case_has_rod(self._handle))

    def section(self) -> Section:
        """Solves the sections that the case and its rod need, as ``stiffaxis section`` does."""
        return Section(make(library.stiffaxis_section_make, self._handle))

    def rod(self, settings: Settings = None) -> Rod:
        """The sections and the rod on them, in one go; ``Section.rod`` where more rods share their sections."""
        with self.section() as section:
            return section.rod(settings)
