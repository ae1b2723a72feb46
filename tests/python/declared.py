"""What the module declares is what the library has, and what it offers is told: structs and functions against the header and
cmake/abi/, docstrings with shapes and units for every public name."""

import ctypes
import dataclasses
import inspect
import re
import sys

import stiffaxis
from stiffaxis import _library

source = sys.argv[1]

# --- structs, as cmake/abi/stiffaxis_layout.txt has them
structs = {"stiffaxis_station": _library.StationData, "stiffaxis_request": _library.RequestData,
           "stiffaxis_critical": _library.CriticalData, "stiffaxis_solution": _library.SolutionData,
           "stiffaxis_derivatives": _library.DerivativesData}
listed, constants = {}, {}
for line in open(source + "/cmake/abi/stiffaxis_layout.txt"):
    words = line.split()
    if words[0] == "#":
        continue
    if "=" in words:
        constants[words[0]] = int(words[2])
    elif line[0] == " ":
        members.append((words[0], int(words[1]), int(words[2])))
    else:
        members = listed[words[0]] = [int(words[1])]
assert set(listed) == set(structs), set(listed) ^ set(structs)
for name, struct in structs.items():
    ours = [ctypes.sizeof(struct)] + [(m, getattr(struct, m).offset, getattr(struct, m).size) for m, _ in struct._fields_]
    assert ours == listed[name], "%s: %s, wanted %s" % (name, ours, listed[name])
for kind in stiffaxis.InputError, stiffaxis.FileError, stiffaxis.NumericError, stiffaxis.ResourceError, stiffaxis.BugError:
    assert kind.code == constants["STIFFAXIS_" + kind.__name__[: -len("Error")].upper()], kind

# --- functions, as the header declares them
header = re.sub(r"//.*", "", open(source + "/api/stiffaxis.h").read())
KINDS = {"int": "int", "double": "double", "size_t": "size", "void": None}
FOUND = {ctypes.c_int: "int", ctypes.c_double: "double", ctypes.c_size_t: "size", None: None}


def kind(text):
    text = text.strip()
    if "*" in text or "[" in text:
        return "text" if re.match(r"const char \*\w*$|char \*name$", text) else "pointer"
    return KINDS[text.split()[0]]


def kind_of(ctype):
    return FOUND[ctype] if ctype in FOUND else "text" if ctype is ctypes.c_char_p else "pointer"


declared = re.findall(r"STIFFAXIS_API\s+([a-z_ ]+[ *])(stiffaxis_\w+)\(([^)]*)\)", header)
assert {"stiffaxis_" + name for name in _library._FUNCTIONS} == {name for _, name, _ in declared}
for result, name, arguments in declared:
    got, takes = _library._FUNCTIONS[name[len("stiffaxis_"):]]
    wanted = [kind(a) for a in arguments.split(",")] if arguments != "void" else []
    # "char *name" with room is a buffer of ours, which c_char_p takes, too
    assert [kind_of(t) for t in takes] == wanted and kind_of(got) == kind(result), name


# --- words
def own_names(cls):
    names = set(getattr(cls, "__annotations__", {})) | {n for n in vars(cls) if callable(getattr(cls, n)) or isinstance(
        inspect.getattr_static(cls, n), (property, classmethod))}
    return {n for n in names if not n.startswith("_")}


UNITS = {"m": "[m", "N": "[N", "rad": "[rad", "J": "[J]", "m2": "[m^2]", "Nm2": "[N m^2]", "per_N": "/N", "per_m": "/m", "m_per_N": "[m/N]"}
told = 0
for public in stiffaxis.__all__:
    thing = getattr(stiffaxis, public)
    if public == "__version__":
        continue
    assert thing.__doc__ and len(thing.__doc__) > 10 and "Alias for field" not in thing.__doc__, public
    for cls in inspect.getmro(thing) if inspect.isclass(thing) else ():
        if not cls.__module__.startswith("stiffaxis"):
            continue
        for name in own_names(cls):
            static = inspect.getattr_static(cls, name, None)
            told += 1
            if isinstance(static, (property, classmethod)) or inspect.isfunction(static):
                words = inspect.getdoc(getattr(cls, name) if not isinstance(static, property) else static)
                assert words and len(words) > 10, "%s.%s has no docstring" % (public, name)
                mentioned = list(inspect.signature(static).parameters) if inspect.isfunction(static) else []
                annotation = str(inspect.signature(static.fget).return_annotation) if isinstance(static, property) else ""
            else:  # a member: its line in the class's docstring
                found = re.search(r"^ *%s: ((?:.+\n)+?)(?= *\w+: |\n|\Z)" % name, inspect.getdoc(cls) + "\n", re.M)
                found = found or re.search(r"\b%s\b.*" % name, inspect.getdoc(cls))
                assert found, "%s does not tell of %s" % (public, name)
                words, mentioned, annotation = found.group(0), [], str(cls.__annotations__[name])
            if "Array" in annotation:
                assert re.search(r"\(\w+,( ?\w+(, \w+)*)?\)", words), "%s.%s tells no shape: %s" % (public, name, words)
            for what in [name] + mentioned:
                end = max((e for e in UNITS if what.endswith("_" + e)), key=len, default=None)
                assert end is None or UNITS[end] in words, "%s.%s: no unit of %s in: %s" % (public, name, what, words)
assert told > 80, told
print("declared: %d structs, %d functions, %d names told" % (len(structs), len(declared), told))
