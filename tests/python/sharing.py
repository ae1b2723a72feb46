"""Threads, child processes, the collector and the end of the program meet in the library, and nothing is lost. The last line is
printed with daemon threads still inside."""

import gc
import locale
import os
import signal
import sys
import threading
import time

import numpy as np
import stiffaxis

path = sys.argv[1]
classical = {"section.model": "classical"}
case = stiffaxis.Case(path)
section = case.section()
rod = section.rod()
wanted = rod.solve([0.49, 0], cold=True).tip_position_m
rows = np.column_stack([np.linspace(0.1, 0.9, 400), np.zeros(400)])

# --- closed by one thread while another one is in it
for _ in range(5):
    shared, outcomes = section.rod(), []
    thread = threading.Thread(target=lambda: outcomes.append(shared.batch(rows, threads=1)[2].any()))
    thread.start()
    while thread.is_alive() and not outcomes and not shared.closed:
        time.sleep(0.002)
        shared.close()
    thread.join()
    assert outcomes == [False]

# --- strains and wrenches of a rod whose tendon is an expression, by threads that share it
helix = stiffaxis.Case(path, {**classical, "rod.tendons.t1.angle_rad": "pi*s/L"}).rod()
places, seen = np.linspace(0, 0.12, 150), {}


def feel(tension, rounds):
    for _ in range(rounds):
        helix.solve([tension, 0], cold=True)
        told = helix.along(places)
        seen.setdefault(tension, []).append((told.strain, told.wrench))


for tension in 0.1, 0.2, 0.3, 0.4:
    feel(tension, 1)
threads = [threading.Thread(target=feel, args=(tension, 30)) for tension in seen]
[t.start() for t in threads], [t.join() for t in threads]
for alone, *together in seen.values():
    assert all(np.array_equal(alone, told) for told in together)

# --- children go on with what they find, in the midst of what other threads do
stop = threading.Event()


def busy():
    while not stop.is_set():
        stiffaxis.Case(path, classical).section()


threads = [threading.Thread(target=busy) for _ in range(2)]
[t.start() for t in threads]
for _ in range(5):
    child = os.fork()
    if child == 0:
        signal.alarm(20)
        same = np.array_equal(rod.solve([0.49, 0], cold=True).tip_position_m, wanted)
        same = same and np.array_equal(stiffaxis.Case(path).section()[0].K, section[0].K)
        same = same and not rod.batch(rows[:4], threads=2)[2].any()
        os._exit(0 if same else 1)
    assert os.waitpid(child, 0)[1] == 0
stop.set()
[t.join() for t in threads]


# --- the collector frees things between a failure and its words
class Node:
    pass


gc.set_threshold(1)
for _ in range(20):
    node = Node()
    node.me, node.case = node, stiffaxis.Case(path, classical)
    del node
    try:
        stiffaxis.Case.from_text("format: 1\nx: [")
    except stiffaxis.InputError as error:
        assert error.line, repr(str(error))
gc.set_threshold(700)

# --- a locale with commas (LOCPATH, where the test could make one)
try:
    locale.setlocale(locale.LC_ALL, "de_DE.UTF-8")
except locale.Error:
    print("sharing: no locale with commas")
else:
    assert locale.str(1.5) == "1,5"
    try:
        stiffaxis.Case(path, {"materials.soft.nu": 0.75})
    except stiffaxis.InputError as error:
        assert "nu = 0.75" in str(error), error
    assert np.array_equal(stiffaxis.Case(path).section()[0].K, section[0].K)
    assert locale.str(1.5) == "1,5"


# --- the end of the program
def forever(work):
    while True:
        work()


for work in lambda: rod.batch(rows, threads=1), lambda: stiffaxis.Case(path, classical).section():
    threading.Thread(target=forever, args=(work,), daemon=True).start()
time.sleep(0.05)
print("shared by threads, children and the collector")
