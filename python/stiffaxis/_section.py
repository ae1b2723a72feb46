"""Cross sections along s."""

from __future__ import annotations

import ctypes
from dataclasses import dataclass
from typing import Any, Dict, Iterator, Tuple

import numpy as np

from ._handle import Handle
from ._library import Array, Settings, StationData, check, document, library, make, numbers, settings_arguments
from ._rod import Rod


@dataclass(frozen=True, eq=False)
class Station:
    """One cross section; the names are the keys of ``stiffaxis section --json``.

    Places are from the origin of the case's x and y (the geometric centre), angles from x. ``EA``, ``EI`` and ``GJ`` are those
    of a section that is free to shear and twist.

    s_m: arclength [m].
    area_m2: [m^2].
    EA_N: [N].
    stiffness_centre_m: (2,) where an axial force makes no curvature [m].
    principal_angle_rad: of the principal axis x' [rad].
    isotropic: no preferred axes: the angle is 0 by convention.
    EI_Nm2: (2,) about the principal axes x' and y' at the stiffness centre [N m^2].
    EI_centre_Nm2: (3,) EIxx, EIyy, EIxy about the stiffness centre [N m^2].
    GJ_Nm2: [N m^2].
    shear_centre_m: (2,) where a transverse force makes no twist [m].
    K: (6, 6) rows nx ny nz mx my mz at the geometric centre [N, N m, N m^2].
    relative_error: of K, an estimate: the largest of ``K_relative_error`` [-].
    K_relative_error: (6, 6) of |K - K_exact|_ij / sqrt(K_ii K_jj) [-].
    mass_kg_per_m: per length; 0 where no density is known [kg/m].
    mass_centre_m: (2,) [m].
    """

    s_m: float
    area_m2: float
    EA_N: float
    stiffness_centre_m: Array
    principal_angle_rad: float
    isotropic: bool
    EI_Nm2: Array
    EI_centre_Nm2: Array
    GJ_Nm2: float
    shear_centre_m: Array
    K: Array
    relative_error: float
    K_relative_error: Array
    mass_kg_per_m: float
    mass_centre_m: Array


def _station(d: StationData) -> Station:
    return Station(
        s_m=d.s, area_m2=d.area, EA_N=d.EA, stiffness_centre_m=np.array(d.stiffness_centre),
        principal_angle_rad=d.principal_angle, isotropic=bool(d.isotropic), EI_Nm2=np.array(d.EI),
        EI_centre_Nm2=np.array(d.EI_centre), GJ_Nm2=d.GJ, shear_centre_m=np.array(d.shear_centre),
        K=np.array(d.K).reshape(6, 6), relative_error=d.relative_error,
        K_relative_error=np.array(d.K_relative_error).reshape(6, 6), mass_kg_per_m=d.mass,
        mass_centre_m=np.array(d.mass_centre))


class Section(Handle):
    """The solved sections of a case: a sequence of ``Station``, and K(s) between them. Made by ``Case.section``."""

    def __init__(self, pointer: int) -> None:
        super().__init__(pointer, library.stiffaxis_section_free)
        count = library.stiffaxis_section_count(pointer)
        self._stations = tuple(self._read(i) for i in range(count))

    def _read(self, i: int) -> Station:
        data = StationData()
        check(library.stiffaxis_section_station(self._handle, i, ctypes.byref(data)))
        return _station(data)

    @property
    def stations(self) -> Tuple[Station, ...]:
        """The case's stations, else those between which K(s) is interpolated, in order of s."""
        return self._stations

    def __len__(self) -> int:
        return len(self._stations)

    def __getitem__(self, i: int) -> Station:
        return self._stations[i]

    def __iter__(self) -> Iterator[Station]:
        return iter(self._stations)

    @property
    def sections_solved(self) -> int:
        """How many sections were solved: turned or equal ones need not be."""
        return int(library.stiffaxis_section_solved(self._handle))

    @property
    def interpolation_relative_error(self) -> float:
        """Of K(s) between the stations, an estimate [-]."""
        return float(library.stiffaxis_section_interpolation_error(self._handle))

    def stiffness(self, s_m: Any) -> Array:
        """K at arclengths s_m [m]: (6, 6) for one, (n, 6, 6) for n of them [N, N m, N m^2]; clipped to the length."""
        return self._at(s_m, False)[0]

    def stiffness_and_slope(self, s_m: Any) -> Tuple[Array, Array]:
        """K and dK/ds at arclengths s_m [m]: two arrays as ``stiffness`` has them, (6, 6) or (n, 6, 6); the slope per metre."""
        return self._at(s_m, True)

    def _at(self, s_m: Any, slope: bool) -> Tuple[Array, Array]:
        single = np.ndim(s_m) == 0
        s = numbers([s_m] if single else s_m, (-1,), "s_m")
        K = np.empty((len(s), 6, 6))
        dK = np.empty((len(s), 6, 6))
        check(library.stiffaxis_section_at(self._handle, len(s), s.ctypes.data, K.ctypes.data, dK.ctypes.data if slope else None))
        return (K[0], dK[0]) if single else (K, dK)

    def document(self) -> Dict[str, Any]:
        """All that ``stiffaxis section --json`` tells, under its keys: besides the stations K in principal axes and about further
        points [N, N m, N m^2], shear stiffness [N], kern [m], warping constant [N m^4], mass matrix, and of each of the case's
        wrenches the largest strain [-] and stresses [Pa] per material. Solves once more for the warping."""
        told: Dict[str, Any] = document(library.stiffaxis_section_json, self._handle)
        return told

    def rod(self, settings: Settings = None) -> Rod:
        """The case's rod on these sections, with other values of its keys where there are settings: sections are solved again only
        where these touch them."""
        count, texts = settings_arguments(settings)
        return Rod(make(library.stiffaxis_rod_make, self._handle, count, texts))
