#!/bin/sh
# A file includes only its own room and rooms below it; a foreign header appears in its one door.
set -eu
cd "${STIFFAXIS_SOURCE:-$(dirname "$0")/..}"

below() {
    case $1 in
    base) echo base ;;
    io) echo 'base io' ;;
    meshes) echo 'base meshes' ;;
    section) echo 'base meshes section' ;;
    rodsolver) echo 'base rodsolver' ;;
    measure) echo 'base io measure' ;;
    fem) echo 'base fem' ;;
    reach) echo 'base io rodsolver measure reach' ;;
    reports) echo 'base io meshes section rodsolver measure fem reach reports' ;;
    app) echo 'base io meshes section rodsolver measure fem reach reports app' ;;
    api) echo 'base io meshes section rodsolver measure fem reach reports app api' ;;
    esac
}

# header pattern, then the only file that may include it. gmsh's one door has several files: what it meshes for us,
# and what it reads itself in a sealed process
foreign='yaml.h io/yaml_door.c
muParserDLL.h io/expression.c
hdf5.h io/hdf5_inside.h
png.h meshes/png_door.c
gmshc.h meshes/(gmsh|gmsh_sides|cad|cad_cut|cad_sizes|cad_curves)_door_module.c
cholmod.h section/cholmod_door.c
omp.h section/cholmod_door.c
petsc fem/petsc_(inside\.h|[a-z_]*door_module\.c)
mpi.h (fem/petsc_[a-z_]*|io/hdf5_share_|reach/mpi_)door_module.c
gsl measure/gsl_[a-z_]*door_module.c
embree3 reach/embree_door_module.c
nlopt.h reach/nlopt_door_module.c
cairo reports/cairo_door.c'

bad=0
for room in base io meshes section rodsolver measure fem reach reports app api; do
    allowed=$(below $room | tr ' ' '|')
    wrong=$(grep -nE '^#include "' $room/*.c $room/*.h | grep -vE "#include \"($allowed)/" || true)
    if [ -n "$wrong" ]; then
        printf '%s may include only %s:\n%s\n' "$room" "$allowed" "$wrong"
        bad=1
    fi
done
while read -r header door; do
    wrong=$(grep -nE "^#include <$header" ./*/*.c ./*/*.h | grep -vE "^./$door:" || true)
    if [ -n "$wrong" ]; then
        printf '<%s> belongs to %s:\n%s\n' "$header" "$door" "$wrong"
        bad=1
    fi
done <<END
$foreign
END
[ $bad = 0 ] && echo "layers: every include points down"
exit $bad
