#!/bin/sh
# h5py reads a result without help: what stands in it is what --json says, to the last bit, every dataset tells its unit. Needs
# python3-h5py, which nothing else here does: without it the script says so and is content.
set -eu
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

python_with 'h5py, numpy' /usr/bin/python3 python3
if [ -z "$python" ]; then
    echo "skipped: no python3 with h5py"
    exit 0
fi

cat >"$work/check.py" <<'END'
import json, sys
import h5py
import numpy as np

file, rod_json, section_json, case = sys.argv[1:]
told, stations = json.load(open(rod_json)), json.load(open(section_json))["stations"]
solutions = told["solutions"]


def numbers(rows):
    return np.array([[np.nan if v is None else v for v in row] for row in rows])


with h5py.File(file, "r") as f:
    assert f.attrs["schema"].decode() == "stiffaxis/result/3" and f.attrs["creator"].decode().startswith("stiffaxis ")
    count = []

    def look(name, item):
        if isinstance(item, h5py.Dataset):
            assert "unit" in item.attrs, name
            count.append(item[()])  # every one can be read

    f.visititems(look)
    assert f["case/text"][()].decode() == open(case).read()
    assert f["case/title"][()].decode() == told["title"]
    rod = f["rod"]
    for ours, theirs, unit in (("tip_p_m", "tip_position_m", "m"), ("tension_N", "tensions_N", "N"), ("pull_m", "pulls_m", "m"),
                               ("tendon_length_m", "tendon_length_m", "m")):
        assert rod[ours].attrs["unit"].decode() == unit
        assert np.array_equal(rod[ours][:], numbers(s[theirs] for s in solutions), equal_nan=True), ours
    assert np.array_equal(rod["tip_R"][:], [s["tip_rotation"] for s in solutions])
    for i, solution in enumerate(solutions):
        assert np.array_equal(rod["shape/%d/p_m" % i][:], [p["p_m"] for p in solution["shape"]])
    for key in ("K", "EA_N", "stiffness_centre_m", "shear_centre_m", "EI_Nm2", "GJ_Nm2", "K_relative_error"):
        assert np.array_equal(f["section"][key][:], [s[key] for s in stations]), key
    print("h5py: %d datasets with their units" % len(count))
END
case=$source/cases/constant_nc.yaml
"$program" rod "$case" --out "$work/rod" --json --quiet >"$work/rod.json"
"$program" section "$case" --json --quiet >"$work/section.json"
"$python" "$work/check.py" "$work/rod/result.hdf" "$work/rod.json" "$work/section.json" "$case"
