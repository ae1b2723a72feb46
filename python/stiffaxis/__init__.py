"""Sections and rods of stiffaxis from Python: its C library, numpy arrays, SI units.

    import stiffaxis

    with stiffaxis.Case("cases/constant_nc.yaml") as case:
        section = case.section()
        section[0].stiffness_centre_m      # (2,) [m]
        section[0].K                       # (6, 6) rows nx ny nz mx my mz [N, N m, N m^2]
        rod = section.rod()
        rod.solve([0.49, 0]).tip_position_m  # (3,) [m]
        rod.shape(61).position_m           # (61, 3) [m]

Everything is SI and names end with their unit, as the keys of ``stiffaxis section --json`` and ``rod --json`` do. Matrices are
in the order nx ny nz mx my mz at the geometric centre; wrenches are (force, moment), twists and strains (v, w).
"""

from ._errors import BugError, Error, FileError, InputError, LimitPoint, NumericError, ResourceError
from ._case import Case
from ._library import VERSION as __version__
from ._library import library_path
from ._rod import Along, Critical, Derivatives, Rod, Shape, Solution, State
from ._section import Section, Station

__all__ = [
    "Along", "BugError", "Case", "Critical", "Derivatives", "Error", "FileError", "InputError", "LimitPoint", "NumericError",
    "ResourceError", "Rod", "Section", "Shape", "Solution", "State", "Station", "__version__", "library_path",
]

for _name in __all__:  # errors and help tell the name that one imports
    if isinstance(globals()[_name], type):
        globals()[_name].__module__ = __name__
del _name
