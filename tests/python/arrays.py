"""What users hand over: arrays of any layout, cases made in Python, paths and texts in any script, what leaves the process."""

import copy
import os
import pathlib
import pickle
import shutil
import sys

import numpy as np
import stiffaxis
from failing import fails

path = sys.argv[1]

case = stiffaxis.Case(pathlib.Path(path))
section = case.section()
rod = section.rod()
wanted = rod.solve([0.5, 0.25], cold=True).tip_position_m  # exact in single precision, too

# --- layouts, widths, byte orders; what is no number
fixed = np.array([0.5, 0.25])
fixed.flags.writeable = False
for row in (fixed, np.array([0.25, 0.5])[::-1], np.array([0.5, 9, 0.25, 9])[::2], np.array([0.5, 0.25], ">f8"), (0.5, 0.25),
            np.array([0.5, 0.25], np.float32), np.array([0.5, 0.25], ">f4"), np.array([0.5, 0.25], object)):
    assert np.array_equal(rod.solve(row, cold=True).tip_position_m, wanted), row
for table in (np.asfortranarray([[0.5, 0.25]] * 3), np.full((6, 4), 0.25, ">f4")[::2, ::2] * np.array([2, 1], ">f4")):
    assert np.array_equal(rod.batch(table, threads=np.int64(2))[0], [wanted] * 3), table
assert rod.batch(np.empty((0, 2)))[0].shape == (0, 3)
places = np.linspace(0, 0.12, 9)
assert np.array_equal(rod.shape(places[::2]).position_m, rod.shape(places).position_m[::2])
assert np.array_equal(rod.shape(0.03).position_m, rod.shape([0.03]).position_m) and rod.shape([]).position_m.shape == (0, 3)
for row in [1j, 0], ["0.1", "0"], np.array(["2020-01-01"] * 2, "M8[D]"):
    fails(TypeError, "real numbers", rod.solve, row)
for row in 0.1, [0.1], [0.1, 0, 0], [[0.1, 0]], []:
    fails(ValueError, "wanted (2,)", rod.solve, row)
fails(ValueError, "wanted (n, 2)", rod.batch, [0.1, 0])
fails(TypeError, "integer", rod.batch, [[0.1, 0]], threads=1.5)
answer = rod.solve([0.5, 0.25])
before = answer.tip_position_m.copy()
rod.solve([0.1, 0])
assert np.array_equal(answer.tip_position_m, before) and answer.tip_position_m.flags.owndata  # the answer's own

# --- a case made in Python: the file's numbers
made = {
    "format": 1, "title": 'größe "Δ" 😀',
    "materials": {"soft": {"E_MPa": 0.66, "nu": 0.3}, "stiff": {"E_MPa": np.float64(15.93), "nu": 0.3}},
    "section": {"shapes": [
        {"annulus": {"outer_radius_mm": 4, "inner_radius_mm": 3.2}, "material": "soft"},
        {"sector": {"outer_radius_mm": 4, "inner_radius_mm": 3.2, "mid_angle_rad": "pi", "width_rad": "pi/8"}, "material": "stiff"}]},
    "rod": {"length_mm": np.int64(120), "tendons": [{"radius_mm": np.float32(3.6), "angle_rad": 0}], "tensions_N": np.array([[0.49]])},
}
by_dict = stiffaxis.Case.from_dict(made)
assert by_dict.title == made["title"] and by_dict.rod().requests[0]["tension_N"] == [0.49]
assert np.array_equal(by_dict.section()[0].K, section[0].K)
fails(stiffaxis.InputError, "expected a number", stiffaxis.Case.from_dict, {**made, "rod": {"length_mm": np.nan}})
fails(stiffaxis.InputError, "unknown key 'materails'", stiffaxis.Case.from_dict, {**made, "materails": {}})
fails(TypeError, "no value of a case", stiffaxis.Case.from_dict, {**made, "title": object()})
assert stiffaxis.Case(path, {"title": "größe", "rod.tensions_N": np.array([[0.1, 0.2]])}).rod().requests[0]["tension_N"][1] == 0.2

# --- names of files
folder = pathlib.Path("größe Δ 😀 and spaces")
folder.mkdir()
shutil.copy(path, folder / "fäll.yaml")
for name in folder / "fäll.yaml", str(folder / "fäll.yaml"), os.fsencode(folder / "fäll.yaml"):
    assert stiffaxis.Case(name).title == case.title
fails(stiffaxis.InputError, "größe", stiffaxis.Case, folder)

# --- what may leave the process, and what may not
for thing in answer, section[0], rod.shape(3), rod.along(3), rod.derivatives():
    again = pickle.loads(pickle.dumps(thing))
    assert type(again) is type(thing) and repr(again) == repr(thing)
limit = pickle.loads(pickle.dumps(stiffaxis.LimitPoint("words", answer)))
assert str(limit) == "words" and np.array_equal(limit.solution.tip_position_m, before)
error = pickle.loads(pickle.dumps(stiffaxis.InputError("a.yaml:3:4: error: words")))
assert (error.line, error.column) == (3, 4)
for thing in case, section, rod, rod.state():
    for way in pickle.dumps, copy.copy, copy.deepcopy:
        fails(TypeError, "a %s lives in this process alone" % type(thing).__name__, way, thing)
print("arrays, cases and files as users hand them over")
