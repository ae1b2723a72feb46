"""What goes wrong says so: with the place in the case, without a crash, whatever the order of things."""

import gc
import sys
import threading

import numpy as np
import stiffaxis
from failing import fails

path = sys.argv[1]


# --- a mistake in a case has its place
text = open(path).read()
at = text.replace("outer_radius_mm: 4,", "outer_radus_mm: 4,", 1)
error = fails(stiffaxis.InputError, "did you mean 'outer_radius_mm'?", stiffaxis.Case.from_text, at, name="mine.yaml")
line = at[: at.index("outer_radus_mm")].count("\n") + 1
assert (error.file, error.line, error.code) == ("mine.yaml", line, 2) and error.column > 1, vars(error)
fails(ValueError, "mine.yaml", stiffaxis.Case.from_text, at, name="mine.yaml")  # as Python has it
error = fails(stiffaxis.InputError, "--set 'rod.lengthmm=3'", stiffaxis.Case, path, {"rod.lengthmm": 3})
assert error.line is None
fails(stiffaxis.InputError, "/nowhere.yaml", stiffaxis.Case, "/nowhere.yaml")
fails(stiffaxis.InputError, "larger than 8 MB", stiffaxis.Case.from_text, "a: " + "x" * (9 << 20))
fails(ValueError, "NUL", stiffaxis.Case, "a\0b")
fails(TypeError, "mapping", stiffaxis.Case, path, "rod.length_mm=3")
only_section = stiffaxis.Case.from_text(text[: text.index("rod:")])
assert only_section.has_section and not only_section.has_rod
fails(stiffaxis.InputError, "no 'rod'", only_section.rod)

# --- a request
case = stiffaxis.Case(path)
section = case.section()
rod = section.rod()
fails(stiffaxis.InputError, "before a solution", rod.shape)
fails(stiffaxis.InputError, "tension", rod.solve, [-1, 0])
fails(stiffaxis.InputError, "nan N", rod.solve, [np.nan, 0])
fails(ValueError, "wanted (2,)", rod.solve, [0.1])
fails(ValueError, "wanted (4, 4)", rod.solve, [0.1, 0], base=np.eye(3))
fails(ValueError, "wanted (6,)", rod.solve, [0.1, 0], tip_wrench=[1, 2])
fails(stiffaxis.InputError, "", rod.solve, [0.1, 0], base=np.ones((4, 4)))
fails(stiffaxis.NumericError, "", rod.solve, [1e3, 0])
fails(ValueError, "two points", rod.shape, 1)
fails(stiffaxis.InputError, "finite", section.stiffness, [0.1, np.inf])
rod.solve([0.1, 0])
for what, place in (rod.shape, [np.nan]), (rod.along, [np.inf]), (rod.derivatives, np.nan):
    fails(stiffaxis.InputError, "finite", what, place)

# --- other values: only what they touch is made again
first = rod.solve([0.49, 0], cold=True).tip_position_m
longer = section.rod({"rod.length_mm": 150, "materials.soft.E_MPa": 0.7})
assert abs(longer.length_m - 0.15) < 1e-15
assert not np.array_equal(longer.solve([0.49, 0]).tip_position_m, first)
assert np.array_equal(case.rod(["rod.length_mm=120"]).solve([0.49, 0], cold=True).tip_position_m, first)
base = np.eye(4)
base[:3, 3] = 1, 2, 3
assert np.abs(rod.solve([0.49, 0], base=base, cold=True).tip_position_m - first - [1, 2, 3]).max() < 1e-15
assert section.stiffness(0.05).shape == (6, 6) and section.stiffness([0, 0.05, 1]).shape == (3, 6, 6)

# --- closing in any order; what was made goes on
state = rod.state()
case.close(), section.close(), rod.close(), rod.close()
fails(ValueError, "this Rod is closed", rod.solve, [0.1, 0])
fails(ValueError, "this Case is closed", case.section)
fails(ValueError, "this Section is closed", section.stiffness, 0)
assert np.array_equal(state.solve([0.49, 0], cold=True).tip_position_m, first)
state.close()
fails(ValueError, "this State is closed", state.solve, [0.1, 0])

# --- threads share a rod; each has its own last answer
with stiffaxis.Case(path) as case:
    rod = case.rod()
rows = np.column_stack([np.linspace(0.1, 0.9, 32), np.zeros(32)])
wanted = np.array([rod.solve(row, cold=True).tip_position_m for row in rows])
wrong = []


def work(offset):
    for i in list(range(offset, 32)) + list(range(offset)):
        tip = rod.solve(rows[i], cold=True).tip_position_m
        if not (np.array_equal(tip, wanted[i]) and np.array_equal(rod.shape(2).position_m[1], tip)):
            wrong.append(i)


threads = [threading.Thread(target=work, args=(8 * k,)) for k in range(4)]
[t.start() for t in threads], [t.join() for t in threads]
assert not wrong, wrong
position, rotation, outcome = rod.batch(np.vstack([rows, [[-1, 0]]]), threads=2)
assert np.array_equal(position[:-1], wanted) and outcome[-1] == 2 and np.isnan(position[-1]).all() and rotation.shape == (33, 3, 3)

# --- what is thrown away is given back
def resident():
    return int(open("/proc/self/statm").read().split()[1]) * 4096


def make_and_drop():
    for _ in range(20):
        stiffaxis.Case(path, {"section.model": "classical"}).rod().solve([0.1, 0])
    gc.collect()


make_and_drop()
before = resident()
make_and_drop(), make_and_drop()
assert resident() - before < 4 << 20, "grows by %d bytes" % (resident() - before)
print("errors, threads and memory as they should be")
