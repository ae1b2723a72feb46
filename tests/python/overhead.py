"""What a rod solve through Python costs beyond the same solve from C (the argument: microseconds of that one)."""

import sys
import time

import numpy as np
import stiffaxis

ROUNDS, SOLVES = 20, 500
MOST = 50  # microseconds, the project's own figure

with stiffaxis.Case(sys.argv[1]) as case, case.rod() as rod, rod.state() as state:
    tensions = np.array([0.49, 0.0]), np.array([0.5, 0.0])
    best = 1e9
    for _ in range(ROUNDS):
        start = time.process_time()
        for i in range(SOLVES):
            state.solve(tensions[i % 2])
        best = min(best, (time.process_time() - start) / SOLVES)
python, c = 1e6 * best, float(sys.argv[2])
print("python: a solve takes %.2f us of CPU, %.2f us from C: overhead %.2f us" % (python, c, python - c))
assert python > c, "the solves were left out"
assert python - c < MOST
