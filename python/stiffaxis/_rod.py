"""The rod: made once, solved many times."""

from __future__ import annotations

import ctypes
import threading
from dataclasses import dataclass
from operator import index
from typing import Any, Dict, List, NamedTuple, Optional, Tuple

import numpy as np
from numpy.typing import NDArray

from ._errors import LimitPoint
from ._handle import Handle
from ._library import MOST, Array, DerivativesData, RequestData, SolutionData, check, failed, library, make, numbers

_solve = library.stiffaxis_solve
_NAME_ROOM = 256


class Critical(NamedTuple):
    """A limit point or a bifurcation on the way to a request.

    kind: "limit_point" or "bifurcation".
    fraction: of the way, from 0 to 1 [-].
    negative_directions: of the second variation behind it; None: no potential.
    """

    kind: str
    fraction: float
    negative_directions: Optional[int]


class Solution:
    """One answer of the rod; the names are the keys of ``stiffaxis rod --json``. Arrays are the solution's own.

    tip_position_m: (3,) of the geometric centre, in the world [m].
    tip_rotation: (3, 3) columns: the section's axes, in the world [-].
    tendon_length_m: (ntendon,) inside the body [m].
    tensions_N: (ntendon,) at the base, as given or found; 0: slack [N].
    relative_error: of the tip, |p - p_exact| / L: an estimate [-].
    iterations: Newton steps.
    fraction: of the request that was reached: 1, or less at a limit point [-].
    limited: whether a limit point stands in the way, and this is the answer there.
    stable: True, False, or None: not known.
    eigenvalue: the smallest of the second variation: 1 at rest, 0 critical; nan: not asked for, or no potential [-].
    energy_J: stored by the strains [J].
    work_J: of loads and tendons on the way from rest; nan: not known [J].
    residual: misfit of the balance, over the largest strain [-].
    critical_points: list of ``Critical``, in the order met.
    """

    __slots__ = ("tip_position_m", "tip_rotation", "tendon_length_m", "tensions_N", "relative_error", "iterations", "fraction",
                 "limited", "stable", "eigenvalue", "energy_J", "work_J", "residual", "critical_points")

    tip_position_m: Array
    tip_rotation: Array
    tendon_length_m: Array
    tensions_N: Array
    relative_error: float
    iterations: int
    fraction: float
    limited: bool
    stable: Optional[bool]
    eigenvalue: float
    energy_J: float
    work_J: float
    residual: float
    critical_points: List[Critical]

    def __repr__(self) -> str:
        return "Solution(tip_position_m=%s, relative_error=%.2g)" % (self.tip_position_m, self.relative_error)


class Shape(NamedTuple):
    """The geometric centreline in the world.

    s_m: (n,) arclengths [m], before they are clipped.
    position_m: (n, 3) [m].
    rotation: (n, 3, 3) columns: the section's axes [-].
    """

    s_m: Array
    position_m: Array
    rotation: Array


class Along(NamedTuple):
    """What the rod's sections feel.

    s_m: (n,) arclengths [m], before they are clipped.
    strain: (n, 6) shear x, shear y, stretch (1: none) [-]; curvature x, y, twist [1/m].
    wrench: (n, 6) of the section alone: force [N], moment [N m], in its own axes.
    tension_N: (n, ntendon) of the tendons there; 0 past their ends [N].
    """

    s_m: Array
    strain: Array
    wrench: Array
    tension_N: Array


@dataclass(frozen=True, eq=False)
class Derivatives:
    """Derivatives of the pose at s as body twists (g^-1 dg/dx)^vee, linear part first [m/.., rad/..].

    by_tension_per_N: (ntendon, 6) by tensions [m/N, rad/N]; 0 where the pulled length is given.
    by_pull_per_m: (ntendon, 6) by pulled lengths [m/m, rad/m]; 0 where the tension is given.
    by_load_factor: (nload, 6) by the factors of loads [m, rad].
    compliance_space: (6, 6) column j: by entry j of the tip's wrench, fixed in space [m, rad per N, N m].
    compliance_body: (6, 6) the same, turning with the tip [m, rad per N, N m].
    by_base: (6, 6) by the base's body twist [m, rad per m, rad].
    length_by_tension_m_per_N: (ntendon, ntendon) of tendons' lengths by tensions [m/N].
    """

    by_tension_per_N: Array
    by_pull_per_m: Array
    by_load_factor: Array
    compliance_space: Array
    compliance_body: Array
    by_base: Array
    length_by_tension_m_per_N: Array


class State(Handle):
    """One thread's place in a rod: the last answer, and all room that a solve needs. Made by ``Rod.state``.

    Calls from several threads wait for each other; for solves side by side take one state per thread.
    """

    def __init__(self, rod: Rod) -> None:
        super().__init__(make(library.stiffaxis_state_make, rod._handle), library.stiffaxis_state_free)
        n, m = rod.ntendon, rod.nload
        self._shapes: Dict[str, Tuple[int, ...]] = {"tension_N": (n,), "pull_m": (n,), "load": (m,), "base": (4, 4)}
        self._rows = {name: np.zeros(shape) for name, shape in self._shapes.items()}
        self._length, self._found = np.zeros(n), np.zeros(n)
        room = bytearray(ctypes.sizeof(SolutionData))
        self._request, self._answer = RequestData(), SolutionData.from_buffer(room)
        self._answer.tendon_length, self._answer.tension = self._length.ctypes.data, self._found.ctypes.data
        self._addresses = {name: row.ctypes.data for name, row in self._rows.items()}
        self._request_at, self._answer_at = ctypes.addressof(self._request), ctypes.addressof(self._answer)
        self._position = np.frombuffer(room, np.float64, 3, SolutionData.tip_position.offset)
        self._rotation = np.frombuffer(room, np.float64, 9, SolutionData.tip_rotation.offset).reshape(3, 3)
        self._lock = threading.Lock()
        self._ntendon, self._nload, self._points, self._length_m = n, m, rod.points, rod.length_m

    def _put(self, name: str, values: Any) -> Optional[int]:
        """Copies what a request gives to where the library reads it; its address."""
        if values is None:
            return None
        array = np.asarray(values)
        if array.dtype.kind != "f" or array.shape != self._shapes[name]:
            array = numbers(values, self._shapes[name], name)
        self._rows[name][...] = array  # from any layout and byte order
        return self._addresses[name]

    def solve(self, tension_N: Any = None, *, pull_m: Any = None, load: Any = None, tip_wrench: Any = None,
              tip_wrench_body: Any = None, base: Any = None, cold: bool = False, past_limit_points: bool = False,
              stability: bool = False) -> Solution:
        """The rod's equilibrium, from the state's last answer on.

        tension_N: (ntendon,) at the base, >= 0 [N]; None: none. pull_m: (ntendon,) lengths drawn out of the base, nan where the
        tension is given [m]. load: (nload,) factors of the case's loads; None: 1 each. tip_wrench, tip_wrench_body: (6,) on the
        tip's centre, directions fixed in the world or turning with the tip [N, N m]. base: (4, 4) pose of the base; None: the
        case's. cold: from rest, the same bits for the same request whatever came before. past_limit_points: follow the
        equilibria past them. stability: tell eigenvalue, stable and work too.

        ``InputError`` for a negative tension or a number that is not finite, ``LimitPoint`` where the rod snaps,
        ``NumericError`` without convergence.
        """
        with self._lock:
            request = self._request
            request.tension = self._put("tension_N", tension_N)
            request.pull = self._put("pull_m", pull_m)
            request.load = self._put("load", load)
            request.base = self._put("base", base)
            request.cold, request.past, request.stability = bool(cold), bool(past_limit_points), bool(stability)
            request.tip_space[:] = (0.0,) * 6 if tip_wrench is None else numbers(tip_wrench, (6,), "tip_wrench").tolist()
            request.tip_body[:] = (
                (0.0,) * 6 if tip_wrench_body is None else numbers(tip_wrench_body, (6,), "tip_wrench_body").tolist())
            code = _solve(self._handle, self._request_at, self._answer_at)
            if code == 0:
                return self._keep()
            error = failed(code)
            raise LimitPoint(error.message, self._keep()) if code == LimitPoint.code and self._answer.limited else error

    def _keep(self) -> Solution:
        a, out = self._answer, Solution()
        out.tip_position_m, out.tip_rotation = self._position.copy(), self._rotation.copy()
        out.tendon_length_m, out.tensions_N = self._length.copy(), self._found.copy()
        out.relative_error, out.iterations, out.fraction = a.relative_error, a.iterations, a.fraction
        out.limited = bool(a.limited)
        out.stable = None if a.stable < 0 else a.stable == 1
        out.eigenvalue, out.energy_J, out.work_J, out.residual = a.eigenvalue, a.energy, a.work, a.residual
        out.critical_points = [
            Critical("bifurcation" if c.kind == 1 else "limit_point", c.fraction, None if c.negative < 0 else c.negative)
            for c in a.critical[:a.ncritical]] if a.ncritical else []
        return out

    def _places(self, where: Any) -> Array:
        if where is None:
            where = self._points
        if isinstance(where, (int, np.integer)):
            if not 2 <= where <= MOST:
                raise ValueError("a shape has two points or more, not %d" % where)
            # as the program has them, to the last bit
            length = self._length_m
            s = length * np.arange(where) / (where - 1)
            s[-1] = length
            return s
        return numbers(np.atleast_1d(where), (-1,), "places")

    def shape(self, places: Any = None) -> Shape:
        """The last answer's centreline at so many equally spaced points (None: as many as the case asks for), or at these
        arclengths (n,) [m], clipped to the length."""
        s = self._places(places)
        position, rotation = np.empty((len(s), 3)), np.empty((len(s), 3, 3))
        with self._lock:
            check(library.stiffaxis_shape(self._handle, len(s), s.ctypes.data, position.ctypes.data, rotation.ctypes.data))
        return Shape(s, position, rotation)

    def along(self, places: Any = None) -> Along:
        """Strains, wrenches and tensions of the last answer; places (n,) [m] as in ``shape``."""
        s = self._places(places)
        strain, wrench, tension = np.empty((len(s), 6)), np.empty((len(s), 6)), np.empty((len(s), self._ntendon))
        with self._lock:
            check(library.stiffaxis_along(self._handle, len(s), s.ctypes.data, strain.ctypes.data, wrench.ctypes.data,
                                          tension.ctypes.data))
        return Along(s, strain, wrench, tension)

    def derivatives(self, s_m: Optional[float] = None) -> Derivatives:
        """Of the pose at s_m [m] (None: the tip) at the last answer, from its own factors: no differences are taken."""
        n, m = self._ntendon, self._nload
        arrays = [np.zeros((n, 6)), np.zeros((n, 6)), np.zeros((m, 6)), np.zeros((6, 6)), np.zeros((6, 6)), np.zeros((6, 6)),
                  np.zeros((n, n))]
        data = DerivativesData(*(a.ctypes.data for a in arrays))
        with self._lock:
            at = self._length_m if s_m is None else float(s_m)
            check(library.stiffaxis_derive(self._handle, at, ctypes.byref(data)))
        return Derivatives(*arrays)


class Rod(Handle):
    """A rod, ready to be solved: routing, K(s) and quadrature are made. Made by ``Section.rod`` or ``Case.rod``.

    ``solve``, ``shape``, ``along`` and ``derivatives`` work on a ``State`` of the calling thread's own: any number of threads may
    share one rod.

    length_m: [m]. ntendon, nload: how many tendons and loads. points: of the shapes that the case asks for.
    """

    def __init__(self, pointer: int) -> None:
        super().__init__(pointer, library.stiffaxis_rod_free)
        self.length_m: float = library.stiffaxis_rod_length(pointer)
        self.ntendon: int = library.stiffaxis_rod_tendons(pointer)
        self.nload: int = library.stiffaxis_rod_loads(pointer)
        self.points: int = library.stiffaxis_rod_points(pointer)
        self._own = threading.local()

    def close(self) -> None:
        """As every handle's; the threads' own last answers go, too. A ``State`` that was asked for stays."""
        super().close()
        self._own = threading.local()

    def _names(self, function: Any, count: int) -> Tuple[str, ...]:
        names, room = [], ctypes.create_string_buffer(_NAME_ROOM)
        for i in range(count):
            check(function(self._handle, i, room, _NAME_ROOM))
            names.append(room.value.decode("utf-8", "replace"))
        return tuple(names)

    @property
    def tendons(self) -> Tuple[str, ...]:
        """(ntendon,) their names, or kind and number."""
        return self._names(library.stiffaxis_rod_tendon_name, self.ntendon)

    @property
    def loads(self) -> Tuple[str, ...]:
        """(nload,) names: point loads, line loads, then gravity where there is any."""
        return self._names(library.stiffaxis_rod_load_name, self.nload)

    @property
    def critical_tension_N(self) -> Array:
        """(ntendon,) the tension at which each alone eats its own length [N]."""
        return np.array([library.stiffaxis_rod_critical_tension(self._handle, i) for i in range(self.ntendon)])

    @property
    def requests(self) -> List[Dict[str, Array]]:
        """The solutions that the case asks for, as arguments of ``solve``: tension_N (ntendon,) [N], pull_m (ntendon,) [m], load
        (nload,) [-]."""
        all_of_them = []
        for i in range(library.stiffaxis_rod_solutions(self._handle)):
            t, p, f = np.zeros(self.ntendon), np.zeros(self.ntendon), np.zeros(self.nload)
            check(library.stiffaxis_rod_solution(self._handle, i, t.ctypes.data, p.ctypes.data, f.ctypes.data))
            all_of_them.append({"tension_N": t, "pull_m": p, "load": f})
        return all_of_them

    def state(self) -> State:
        """A new state, at rest."""
        return State(self)

    def _state(self) -> State:
        self._handle
        own = self._own
        state: Optional[State] = getattr(own, "state", None)
        if state is None:
            state = own.state = State(self)
        return state

    def solve(self, tension_N: Any = None, **request: Any) -> Solution:
        """``State.solve`` of the calling thread's state: tension_N (ntendon,) [N], and its other arguments."""
        return self._state().solve(tension_N, **request)

    def shape(self, places: Any = None) -> Shape:
        """``State.shape`` of the calling thread's last answer: positions (n, 3) [m] and rotations (n, 3, 3)."""
        return self._state().shape(places)

    def along(self, places: Any = None) -> Along:
        """``State.along`` of the calling thread's last answer: strains and wrenches (n, 6), tensions (n, ntendon) [N]."""
        return self._state().along(places)

    def derivatives(self, s_m: Optional[float] = None) -> Derivatives:
        """``State.derivatives`` of the calling thread's last answer, at s_m [m]."""
        return self._state().derivatives(s_m)

    def batch(self, tensions_N: Any, threads: int = 0) -> Tuple[Array, Array, NDArray[np.intc]]:
        """Tips for rows of tensions (n, ntendon) [N] on so many threads (0: all cores), each from rest.

        Positions (n, 3) [m], rotations (n, 3, 3) and outcomes (n,): 0, or the code of what failed, with nan in its row.
        """
        rows = numbers(tensions_N, (-1, self.ntendon), "tensions_N")
        position, rotation = np.empty((len(rows), 3)), np.empty((len(rows), 3, 3))
        outcome = np.empty(len(rows), np.intc)
        check(library.stiffaxis_batch(self._handle, min(index(threads), MOST), len(rows), rows.ctypes.data, None, position.ctypes.data,
                                      rotation.ctypes.data, outcome.ctypes.data))
        return position, rotation, outcome
