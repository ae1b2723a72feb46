#!/bin/sh
# VTK's own reader opens a result's grid: areas, volumes, orientation and fields are what they should be, of a reach study the wall
# and the bodies. Needs python3-vtk9 or ParaView, which nothing else here does: without them the script says so and is content. Where
# ParaView is there (Debian's python3-paraview, which takes the place of python3-vtk9) it opens both files too, under xvfb.
set -eu
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

python_with vtkmodules.vtkIOHDF python3 /usr/bin/python3 pvpython
if [ -z "$python" ]; then
    echo "skipped: no python3 with VTK 9.1, and no pvpython"
    exit 0
fi

cat >"$work/case.yaml" <<'END'
format: 1
materials:
  soft:  {E_MPa: 0.66,  nu: 0.3}
  stiff: {E_MPa: 15.93, nu: 0.3}
section:
  shapes:
    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 2}, material: soft}
    - {sector: {outer_radius_mm: 4, inner_radius_mm: 2, mid_angle_rad: pi, width_rad: pi/2}, material: stiff}
fem:
  length_mm: 20
  layers: 4
  loads:
    - {name: push, force_N: [0, 0, -0.5]}
    - {name: pull, force_N: [0.1, 0, 0.5]}
END

cat >"$work/check.py" <<'END'
import json, sys
from vtkmodules.vtkFiltersGeneral import vtkWarpVector
from vtkmodules.vtkFiltersVerdict import vtkCellSizeFilter
from vtkmodules.vtkIOHDF import vtkHDFReader

file, cell_type = sys.argv[1], int(sys.argv[2])
area = json.load(open(sys.argv[3]))["stations"][0]["area_m2"]
length = 0.02

reader = vtkHDFReader()
assert reader.CanReadFile(file), "vtkHDFReader cannot read it"
reader.SetFileName(file)
reader.Update()
grid = reader.GetOutput()
assert grid.GetPointData().GetArray("displacement_m").GetNumberOfComponents() == 3
materials = grid.GetCellData().GetArray("material").GetRange()
assert materials == (0, 1), materials

# back to the undeformed segment, whose size is known
grid.GetPointData().SetActiveVectors("displacement_m")
warp = vtkWarpVector()
warp.SetInputData(grid)
warp.SetScaleFactor(-1)
sizes = vtkCellSizeFilter()
sizes.SetInputConnection(warp.GetOutputPort())
sizes.Update()
rest = sizes.GetOutput()


def outward(cell):
    """Volume by the divergence theorem over the cell's faces, as VTK orders them: negative where it is inside out."""
    total = 0
    for i in range(cell.GetNumberOfFaces()):
        p = [cell.GetFace(i).GetPoints().GetPoint(k) for k in range(cell.GetFace(i).GetNumberOfPoints())]
        for a, b, c in ((p[0], p[k], p[k + 1]) for k in range(1, len(p) - 1)):
            total += (a[0] * (b[1] * c[2] - b[2] * c[1]) - a[1] * (b[0] * c[2] - b[2] * c[0])
                      + a[2] * (b[0] * c[1] - b[1] * c[0])) / 6
    return total


size, signed, parts = {}, {}, rest.GetCellData().GetArray("part")
for i in range(rest.GetNumberOfCells()):
    part = int(parts.GetTuple1(i))
    solid = rest.GetCell(i).GetCellDimension() == 3
    assert solid == (part > 0), "part 0 is the section, the others are segments"
    assert not solid or rest.GetCellType(i) == cell_type, rest.GetCellType(i)
    value = rest.GetCellData().GetArray("Volume" if solid else "Area").GetTuple1(i)
    size[part] = size.get(part, 0) + value
    signed[part] = signed.get(part, 0) + (outward(rest.GetCell(i)) if solid else value)

# 1 %: straight edges on arcs; 1e-6: VTK's two ways to a volume where a hexahedron's faces are not quite flat
assert sorted(size) == [0, 1, 2], sorted(size)
for part in size:
    wanted = area if part == 0 else area * length
    assert abs(size[part] / wanted - 1) < 0.01, (part, size[part], wanted)
    assert abs(signed[part] / size[part] - 1) < 1e-6, (part, signed[part], size[part])
print("vtkHDFReader: %d cells, area %.6g m^2, volume %.6g m^3" % (rest.GetNumberOfCells(), size[0], size[1]))
END

# hexahedra from a mapped mesh, wedges from a free one
for pair in mapped:12 free:13; do
    kind=${pair%:*}
    "$program" section "$work/case.yaml" --set "section.mesh.kind=$kind" --json --quiet >"$work/section.json"
    # without the other programs that comparisons ask
    env PATH="$work/nothing" "$program" run "$work/case.yaml" --set "section.mesh.kind=$kind" --out "$work/$kind" --quiet >"$work/log"
    "$python" "$work/check.py" "$work/$kind/result.hdf" "${pair#*:}" "$work/section.json"
done

# --- a reach study: a box of 40 x 40 x 50 mm, and two scopes at three targets

box >"$work/box.stl"
printf 'name,x [mm],y [mm],z [mm]\nnear,0,6,25\nside,-8,0,22\nfar,19,19,-4\n' >"$work/targets.csv"
cat >"$work/box.yaml" <<'END'
format: 1
reach:
  tissue: box.stl
  tissue_unit: mm
  targets: targets.csv
  entry: {point_mm: [0, 0, -8], direction: [0, 0, 1]}
  synthetic: true
  source: made by a test
  map: {points: 200, seed: 3}
  scopes:
    - {name: long, radius_mm: 1.4, insertion_mm: [0, 60], constant_curvature: {length_mm: 20, bend_deg: [0, 180]}}
    - {name: short, radius_mm: 1.4, insertion_mm: [0, 10], constant_curvature: {length_mm: 15, bend_deg: [0, 90]}}
END
cat >"$work/reach.py" <<'END'
import json, sys
from vtkmodules.vtkIOHDF import vtkHDFReader

reader = vtkHDFReader()
reader.SetFileName(sys.argv[1])
reader.Update()
grid = reader.GetOutput()
told = json.load(open(sys.argv[2]))
LINE, TRIANGLE = 3, 5
part, clearance = grid.GetCellData().GetArray("part"), grid.GetPointData().GetArray("clearance_m")
target = grid.GetPointData().GetArray("target_count")
cells = {}
for i in range(grid.GetNumberOfCells()):
    cells.setdefault(int(part.GetTuple1(i)), []).append(i)
assert sorted(cells) == list(range(1 + len(told["scopes"]))), sorted(cells)

# part 0: the wall, whose area is the box's, in metres, with each scope's verdict
assert len(cells[0]) == 12 and all(grid.GetCellType(i) == TRIANGLE for i in cells[0])
area = sum(grid.GetCell(i).ComputeArea() for i in cells[0])
assert abs(area / (2 * 0.04 * 0.04 + 4 * 0.04 * 0.05) - 1) < 1e-6, area  # the surface is read in single precision
for i in range(len(told["scopes"])):
    low, high = grid.GetPointData().GetArray("scope_%d_state" % (i + 1)).GetRange()
    assert low in (0, 1, 2) and high in (0, 1, 2), (low, high)

# the others: the bodies as lines, target after target; places and clearances to the last bit
nbody = 0
for i, scope in enumerate(told["scopes"]):
    lines = iter(cells[1 + i])
    for number, answer in enumerate(scope["answers"]):
        body = answer["body"]
        nbody += 1
        for k in range(len(body["s_m"]) - 1):
            line = next(lines)
            assert grid.GetCellType(line) == LINE
            for end in (0, 1):
                at = grid.GetCell(line).GetPointId(end)
                assert list(grid.GetPoint(at)) == body["p_m"][k + end], (scope["name"], number, k)
                assert clearance.GetTuple1(at) == body["clearance_m"][k + end], (scope["name"], number, k)
                assert target.GetTuple1(at) == number + 1
    assert next(lines, None) is None, scope["name"]
print("vtkHDFReader: a wall of %d triangles, %d bodies of %d lines" % (len(cells[0]), nbody, grid.GetNumberOfCells() - len(cells[0])))
END
"$program" reach "$work/box.yaml" --out "$work/reach" --json --quiet >"$work/reach.json"
"$python" "$work/reach.py" "$work/reach/result.hdf" "$work/reach.json"

# --- ParaView itself

if ! command -v pvpython >/dev/null; then
    echo "ParaView skipped: no pvpython (apt-get install python3-paraview xvfb)"
    exit 0
fi
cat >"$work/open_both.py" <<'END'
import os, sys
from paraview.simple import (CreateRenderView, GetParaViewVersion, OpenDataFile, Render, SaveScreenshot, Show, Threshold,
                             UpdatePipeline, WarpByVector)
from vtkmodules.vtkIOHDF import vtkHDFReader


def opened(file, fields, parts):
    """The file by ParaView's choice of reader: as many cells and points as VTK's reader finds, with these fields and parts."""
    source = OpenDataFile(file)
    assert source is not None, "ParaView does not open " + file
    UpdatePipeline(proxy=source)
    info, reader = source.GetDataInformation(), vtkHDFReader()
    reader.SetFileName(file)
    reader.Update()
    grid = reader.GetOutput()
    assert info.GetNumberOfCells() == grid.GetNumberOfCells() > 0
    assert info.GetNumberOfPoints() == grid.GetNumberOfPoints() > 0
    found = set(source.PointData.keys()) | set(source.CellData.keys())
    assert set(fields) <= found, (fields, found)
    cells = {}
    for part in parts:
        piece = Threshold(Input=source, Scalars=["CELLS", "part"], LowerThreshold=part - 0.5, UpperThreshold=part + 0.5)
        UpdatePipeline(proxy=piece)
        cells[part] = piece.GetDataInformation().GetNumberOfCells()
    array = grid.GetCellData().GetArray("part")
    numbers = [array.GetTuple1(i) for i in range(grid.GetNumberOfCells())]
    assert cells == {part: numbers.count(part) for part in parts} and sum(cells.values()) == len(numbers), cells
    return source, cells


segment, cells = opened(sys.argv[1], ["displacement_m", "material", "part"], [0, 1, 2])
assert cells[1] == cells[2] and cells[1] % 4 == 0, cells  # the case's layers
reach, _ = opened(sys.argv[2], ["clearance_m", "target_count", "scope_1_state", "scope_2_state", "part"], [0, 1, 2])
warped = WarpByVector(Input=segment, Vectors=["POINTS", "displacement_m"], ScaleFactor=10)
if os.environ.get("DISPLAY"):
    view = CreateRenderView()
    Show(warped, view)
    Render(view)
    SaveScreenshot(sys.argv[3], view, ImageResolution=[640, 480])
    assert os.path.getsize(sys.argv[3]) > 2000
    picture = "drawn"
else:
    picture = "not drawn: no display"
print("ParaView %s: segments of %d cells and a reach study opened, %s" % (GetParaViewVersion(), cells[1], picture))
END
show=
if [ -z "${DISPLAY:-}" ] && command -v xvfb-run >/dev/null; then show='xvfb-run -a'; fi
$show pvpython "$work/open_both.py" "$work/mapped/result.hdf" "$work/reach/result.hdf" "$work/picture.png"
