#!/bin/sh
# VTK's own reader opens a result's grid: areas, volumes, orientation and fields are what they should be. Needs python3-vtk9,
# which nothing else here does: without it the script says so and is content.
set -eu

python=
for candidate in python3 /usr/bin/python3; do
    if "$candidate" -c 'from vtkmodules.vtkIOHDF import vtkHDFReader' 2>/dev/null; then
        python=$candidate
        break
    fi
done
if [ -z "$python" ] || [ ! -x "${STIFFAXIS:-}" ]; then
    echo "skipped: no python3 with VTK 9.1, or no program"
    exit 0
fi
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

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
    "$STIFFAXIS" section "$work/case.yaml" --set "section.mesh.kind=$kind" --json --quiet >"$work/section.json"
    # without the other programs that comparisons ask
    env PATH="$work/nothing" "$STIFFAXIS" run "$work/case.yaml" --set "section.mesh.kind=$kind" --out "$work/$kind" --quiet >"$work/log"
    "$python" "$work/check.py" "$work/$kind/result.hdf" "${pair#*:}" "$work/section.json"
done
