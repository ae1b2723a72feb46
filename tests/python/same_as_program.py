"""Sections and rods through Python are those of the program's --json, to the last bit."""

import json
import math
import sys

import numpy as np
import stiffaxis


def same(ours, theirs, what):
    ours = ours.tolist() if isinstance(ours, np.ndarray) else ours
    if isinstance(theirs, list):
        assert len(ours) == len(theirs), what
        for i, (a, b) in enumerate(zip(ours, theirs)):
            same(a, b, "%s[%d]" % (what, i))
    elif theirs is None:  # null: not a number, or not known
        assert ours is None or math.isnan(ours), "%s: %r, wanted null" % (what, ours)
    else:
        assert ours == theirs, "%s: %r, wanted %r" % (what, ours, theirs)


def sections(section, told):
    same(len(section), len(told["stations"]), "stations")
    same(section.sections_solved, told["sections_solved"], "sections_solved")
    same(section.interpolation_relative_error, told["interpolation_relative_error"], "interpolation")
    for station, wanted in zip(section, told["stations"]):
        for key in ("s_m", "area_m2", "EA_N", "stiffness_centre_m", "principal_angle_rad", "isotropic", "EI_Nm2", "EI_centre_Nm2",
                    "GJ_Nm2", "shear_centre_m", "K", "relative_error", "K_relative_error"):
            same(getattr(station, key), wanted[key], key)


def derivatives(got, wanted):
    for key in ("by_tension_per_N", "by_pull_per_m", "by_load_factor", "compliance_space", "compliance_body"):
        same(getattr(got, key), wanted[key], key)


def solution(answer, rod, wanted):
    for key in ("tip_position_m", "tip_rotation", "tendon_length_m", "tensions_N", "iterations", "stable", "eigenvalue", "fraction",
                "relative_error", "residual", "energy_J", "work_J"):
        same(getattr(answer, key), wanted[key], key)
    same([c.kind for c in answer.critical_points], [c["kind"] for c in wanted["critical_points"]], "critical points")
    shape, along = rod.shape(), rod.along()
    column = lambda key: [point[key] for point in wanted["shape"]]
    same(shape.s_m, column("s_m"), "s_m")
    same(shape.position_m, column("p_m"), "p_m")
    same(along.strain[:, :3] - [0, 0, 1], column("strain"), "strain")
    same(along.strain[:, 3:], column("curvature_per_m"), "curvature")
    same(along.wrench[:, :3], column("force_N"), "force")
    same(along.wrench[:, 3:], column("moment_Nm"), "moment")
    same(along.tension_N, column("tension_N"), "tension")
    if "tip_derivatives" in wanted:
        derivatives(rod.derivatives(), wanted["tip_derivatives"])


section_json, rod_json, case_path = sys.argv[1:4]
settings = [text for text in sys.argv[4:] if text != "--set"]
told = json.load(open(rod_json))
with stiffaxis.Case(case_path, settings) as case:
    section = case.section()
    sections(section, json.load(open(section_json)))
    assert section.document() == json.load(open(section_json))
    rod = section.rod()
    assert list(rod.tendons) == told["tendons"] and list(rod.loads) == told["loads"] and rod.length_m == told["length_m"]
    assert len(rod.requests) == len(told["solutions"]) > 0
    for request, wanted in zip(rod.requests, told["solutions"]):
        try:
            answer = rod.solve(cold=True, stability=True, **request)
        except stiffaxis.LimitPoint as limit:
            answer = limit.solution
        solution(answer, rod, wanted)
print("same bits: %s" % case_path.rsplit("/", 1)[-1])
