"""Finds and opens libstiffaxis; its structs and functions (api/stiffaxis.h), declared once."""

from __future__ import annotations

import ctypes
import json
import os
import shutil
import sys
import sysconfig
from ctypes import POINTER, c_char_p, c_double, c_int, c_size_t, c_void_p
from ctypes.util import find_library
from pathlib import Path
from typing import Any, Iterator, Mapping, Optional, Sequence, Tuple, Union

try:
    import numpy as np
    from numpy.typing import NDArray
except ImportError as missing:
    raise ImportError(
        "stiffaxis needs numpy, which this Python (%s) does not have: on Debian apt-get install python3-numpy and use "
        "/usr/bin/python3, elsewhere pip install numpy" % sys.executable
    ) from missing

from ._errors import ERRORS, Error

VERSION = "0.1.0"
_NAME = "libstiffaxis.so"
_NUMBERED = _NAME + ".0"

MOST = 2**31 - 1  # places or rows of one call: the library counts them with an int

Array = NDArray[np.float64]
FilePath = Union[str, bytes, "os.PathLike[Any]"]
Settings = Union[Mapping[str, Any], Sequence[str], None]


class StationData(ctypes.Structure):
    _fields_ = [
        ("s", c_double), ("area", c_double), ("EA", c_double), ("stiffness_centre", c_double * 2),
        ("principal_angle", c_double), ("EI", c_double * 2), ("EI_centre", c_double * 3), ("GJ", c_double),
        ("shear_centre", c_double * 2), ("mass", c_double), ("mass_centre", c_double * 2),
        ("relative_error", c_double), ("K_relative_error", c_double * 36), ("K", c_double * 36), ("isotropic", c_int),
    ]


class RequestData(ctypes.Structure):
    _fields_ = [
        ("tension", c_void_p), ("pull", c_void_p), ("load", c_void_p), ("base", c_void_p),
        ("tip_space", c_double * 6), ("tip_body", c_double * 6), ("cold", c_int), ("past", c_int), ("stability", c_int),
    ]


class CriticalData(ctypes.Structure):
    _fields_ = [("fraction", c_double), ("kind", c_int), ("negative", c_int)]


class SolutionData(ctypes.Structure):
    _fields_ = [
        ("tendon_length", c_void_p), ("tension", c_void_p), ("tip_position", c_double * 3),
        ("tip_rotation", c_double * 9), ("relative_error", c_double), ("max_strain", c_double * 6),
        ("fraction", c_double), ("eigenvalue", c_double), ("energy", c_double), ("work", c_double),
        ("residual", c_double), ("iterations", c_int), ("stable", c_int), ("limited", c_int), ("ncritical", c_int),
        ("critical", CriticalData * 16),
    ]


class DerivativesData(ctypes.Structure):
    _fields_ = [(name, c_void_p) for name in
                ("tension", "pull", "load", "tip_space", "tip_body", "base", "length_by_tension")]


_TEXTS = POINTER(c_char_p)
_OUT = POINTER(c_void_p)
_FUNCTIONS = {  # name: what it returns, what it takes
    "version": (c_char_p, []),
    "error": (c_char_p, []),
    "case_open": (c_int, [c_char_p, c_int, _TEXTS, c_int, _OUT]),
    "case_read": (c_int, [c_char_p, c_char_p, c_int, _TEXTS, c_int, _OUT]),
    "case_free": (None, [c_void_p]),
    "case_title": (c_char_p, [c_void_p]),
    "case_length": (c_double, [c_void_p]),
    "case_has_section": (c_int, [c_void_p]),
    "case_has_rod": (c_int, [c_void_p]),
    "section_make": (c_int, [c_void_p, _OUT]),
    "section_free": (None, [c_void_p]),
    "section_count": (c_int, [c_void_p]),
    "section_station": (c_int, [c_void_p, c_int, POINTER(StationData)]),
    "section_at": (c_int, [c_void_p, c_int, c_void_p, c_void_p, c_void_p]),
    "section_solved": (c_int, [c_void_p]),
    "section_interpolation_error": (c_double, [c_void_p]),
    "section_json": (c_int, [c_void_p, _OUT]),
    "text_free": (None, [c_void_p]),
    "rod_make": (c_int, [c_void_p, c_int, _TEXTS, _OUT]),
    "rod_free": (None, [c_void_p]),
    "rod_length": (c_double, [c_void_p]),
    "rod_tendons": (c_int, [c_void_p]),
    "rod_loads": (c_int, [c_void_p]),
    "rod_tendon_name": (c_int, [c_void_p, c_int, c_char_p, c_size_t]),
    "rod_load_name": (c_int, [c_void_p, c_int, c_char_p, c_size_t]),
    "rod_critical_tension": (c_double, [c_void_p, c_int]),
    "rod_solutions": (c_int, [c_void_p]),
    "rod_points": (c_int, [c_void_p]),
    "rod_solution": (c_int, [c_void_p, c_int, c_void_p, c_void_p, c_void_p]),
    "state_make": (c_int, [c_void_p, _OUT]),
    "state_free": (None, [c_void_p]),
    "solve": (c_int, [c_void_p, c_void_p, c_void_p]),
    "batch": (c_int, [c_void_p, c_int, c_int, c_void_p, c_void_p, c_void_p, c_void_p, c_void_p]),
    "shape": (c_int, [c_void_p, c_int, c_void_p, c_void_p, c_void_p]),
    "along": (c_int, [c_void_p, c_int, c_void_p, c_void_p, c_void_p, c_void_p]),
    "derive": (c_int, [c_void_p, c_double, POINTER(DerivativesData)]),
}


# --- where the library is


def _folders() -> Iterator[Path]:
    here = Path(__file__).resolve().parent
    yield here
    for above in here.parents:  # a source tree's build, or a prefix that holds both
        yield above / "build" / "release" / "bin"
        yield above / "lib"
        yield above / "lib" / str(sysconfig.get_config_var("MULTIARCH") or "")
    program = shutil.which("stiffaxis")
    if program:
        beside = Path(program).resolve().parent
        yield beside
        yield beside.parent / "lib"
    yield Path(sys.prefix) / "lib"


def _candidates() -> Iterator[str]:
    for folder in _folders():
        for name in (_NUMBERED, _NAME):
            if (folder / name).is_file():
                yield str(folder / name)
    found = find_library("stiffaxis")
    if found:
        yield found


def _open() -> ctypes.CDLL:
    told = os.environ.get("STIFFAXIS_LIBRARY")
    path: Optional[str] = told or next(_candidates(), None)
    if not path:
        raise ImportError(
            "%s was not found: build stiffaxis (./run setup) or install it (./run install), or name the file in "
            "STIFFAXIS_LIBRARY" % _NAME
        )
    try:
        opened = ctypes.CDLL(path)
        opened.stiffaxis_version.restype = c_char_p
        version = opened.stiffaxis_version().decode()
        if version.split(".")[:2] != VERSION.split(".")[:2]:
            raise ImportError("%s is version %s, this module %s" % (path, version, VERSION))
        for name, (result, arguments) in _FUNCTIONS.items():
            function = getattr(opened, "stiffaxis_" + name)
            function.restype, function.argtypes = result, arguments
    except (OSError, AttributeError) as why:
        raise ImportError("%s cannot be used: %s" % (path, why)) from why
    return opened


library = _open()


def library_path() -> str:
    """The file of the C library that is in use."""
    return str(library._name)


# --- what all calls need


def failed(code: int) -> Error:
    message = library.stiffaxis_error().decode("utf-8", "replace")
    return ERRORS.get(code, Error)(message)


def check(code: int) -> None:
    if code:
        raise failed(code)


def make(function: Any, *arguments: Any) -> int:
    """The handle that a `_make` or `_open` function gives."""
    out = c_void_p()
    check(function(*arguments, ctypes.byref(out)))
    assert out.value
    return out.value


def document(function: Any, handle: Any) -> Any:
    """The JSON document that a function writes."""
    text = make(function, handle)
    try:
        return json.loads(ctypes.string_at(text))
    finally:
        library.stiffaxis_text_free(text)


def encode_path(path: FilePath) -> bytes:
    """As the file system has it."""
    return _without_nul(os.fsencode(path))


def encode(text: str) -> bytes:
    """Words of a case, which are UTF-8 whatever the locale is."""
    if not isinstance(text, str):
        raise TypeError("wanted a str, got a %s" % type(text).__name__)
    return _without_nul(text.encode("utf-8", "surrogateescape"))


def _without_nul(data: bytes) -> bytes:
    if b"\0" in data:
        raise ValueError("a NUL character in %r" % data[:80])
    return data


def _plain(value: Any) -> Any:
    if isinstance(value, (np.ndarray, np.generic)):
        return value.tolist()
    if isinstance(value, os.PathLike):
        return os.fspath(value)
    raise TypeError("no value of a case: %r is a %s" % (value, type(value).__name__))


def yaml_of(value: Any) -> str:
    """Mappings, sequences, arrays, numbers with all their digits, texts: as YAML, which JSON is."""
    return json.dumps(value, default=_plain, ensure_ascii=False, indent=1)


def settings_arguments(settings: Settings) -> Tuple[int, Any]:
    """(count, array) as the library takes KEY=VALUE texts."""
    if isinstance(settings, (str, bytes)):
        raise TypeError("settings are a mapping {key: value} or a list of 'key=value', not one text")
    if isinstance(settings, Mapping):
        texts = ["%s=%s" % (key, value if isinstance(value, str) else yaml_of(value)) for key, value in settings.items()]
    else:
        texts = list(settings or [])
    return len(texts), (c_char_p * max(len(texts), 1))(*map(encode, texts))


def numbers(values: Any, shape: Tuple[int, ...], what: str) -> Array:
    """A C-contiguous float64 array of this shape, in this machine's byte order; -1: any length."""
    array = np.asarray(values)
    if array.dtype.kind not in "biufO":
        raise TypeError("%s: wanted real numbers, got %s" % (what, array.dtype))
    floats: Array = np.require(array, np.float64, "C")
    if floats.ndim != len(shape) or any(w not in (-1, n) for n, w in zip(floats.shape, shape)):
        wanted = ", ".join("n" if w == -1 else str(w) for w in shape) + ("," if len(shape) == 1 else "")
        raise ValueError("%s has the shape %s, wanted (%s)" % (what, floats.shape, wanted))
    if len(floats) > MOST:
        raise ValueError("%s: more than %d" % (what, MOST))
    return floats
