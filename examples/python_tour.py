#!/usr/bin/env python3
"""stiffaxis from Python in one sitting: a section, its rod, a load, derivatives, a small inverse problem, a sweep.

    /usr/bin/python3 python_tour.py constant_nc.yaml      # stiffaxis example constant_nc > constant_nc.yaml

Cells begin with "# %%", as notebooks and editors have them. Pictures are written (python_tour.png) where matplotlib is installed.
"""

# %% A case: the file, or the file with other values of its keys
import sys

import numpy as np
import stiffaxis

path = sys.argv[1] if len(sys.argv) > 1 else "constant_nc.yaml"
case = stiffaxis.Case(path)
print("case              %s, rod of %.0f mm" % (case.title, 1e3 * case.length_m))

# %% The section: centres, axes, the 6x6 stiffness, each with its error
section = case.section()
station = section[0]
print("stiffness centre  (%.4f, %.4f) mm" % tuple(1e3 * station.stiffness_centre_m))
print("EA                %.4f N, relative error of K %.1e" % (station.EA_N, station.relative_error))
with np.printoptions(precision=4, suppress=False, linewidth=120):
    print(station.K)

# %% The rod: made once, solved many times
rod = section.rod()
answer = rod.solve([0.49, 0.0])  # N, one per tendon
print("tendons           %s" % ", ".join(rod.tendons))
print("tip               %s mm" % np.round(1e3 * answer.tip_position_m, 3))
shape = rod.shape(61)  # of the last answer: s, positions, rotations
along = rod.along(61)  # strains, wrenches, tensions
print("curvature         %.2f to %.2f 1/m" % (along.strain[:, 3:5].min(), along.strain[:, 3:5].max()))

# %% A weight of 10 mN hangs on the tip
loaded = rod.solve([0.49, 0.0], tip_wrench=[0, -0.01, 0, 0, 0, 0])
print("with 10 mN        %s mm" % np.round(1e3 * loaded.tip_position_m, 3))

# %% Derivatives come with the solve: Newton's method for the tensions that bring the tip to x = 60 mm
target, tension = 60e-3, 0.3
for step in range(20):
    tip = rod.solve([tension, 0.0])
    slope = (tip.tip_rotation @ rod.derivatives().by_tension_per_N[0, :3])[0]
    miss = target - tip.tip_position_m[0]
    if abs(miss) < 1e-9:
        break
    tension = max(tension + miss / slope, tension / 2)
print("x = 60 mm         at %.4f N, after %d steps" % (tension, step))

# %% A sweep on all cores, and the same rod with another value of one key
tensions = np.column_stack([np.linspace(0, 0.98, 50), np.zeros(50)])
tips, rotations, outcome = rod.batch(tensions)
print("sweep             %d of %d solved" % (np.sum(outcome == 0), len(outcome)))
wider = section.rod({"rod.tendons.t1.radius_mm": 3.7})
moved = wider.solve([0.49, 0.0]).tip_position_m - answer.tip_position_m
print("tendon 0.1 mm out moves the tip by %.2f mm" % (1e3 * np.linalg.norm(moved)))

# %% Mistakes have their place
try:
    stiffaxis.Case(path, {"rod.lenght_mm": 100})
except stiffaxis.InputError as error:
    print("a mistake         %s" % error)

# %% Pictures
try:
    import matplotlib
except ImportError:
    print("no matplotlib, no picture")
else:
    matplotlib.use("Agg")
    from matplotlib import pyplot

    figure, axes = pyplot.subplots(figsize=(4, 4))
    for row in tensions[::7]:
        rod.solve(row)
        x, _, z = 1e3 * rod.shape(61).position_m.T
        axes.plot(x, z, label="%.2f N" % row[0])
    axes.set(xlabel="x [mm]", ylabel="z [mm]", aspect="equal")
    axes.legend()
    figure.savefig("python_tour.png", dpi=150)
    print("picture           python_tour.png")
