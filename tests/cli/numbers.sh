#!/bin/sh
# The orders of other tools in docs/numbers.md: permutations that need no sign, SONATA's own rule, and digits that the tools' makers
# have printed, against the program's K in each order.
set -u
. "$STIFFAXIS_SOURCE/tests/cli/helpers"

command -v python3 >/dev/null || {
    echo "numbers: no python3 here"
    exit 0
}
cat >"$work/square.yaml" <<'END'
format: 1
title: the unit square of ANBA4's own test
materials:
  one: {E_Pa: 1, nu: 0.33}
section:
  model: full
  shapes:
    - {rectangle: {width_m: 1, height_m: 1}, material: one}
END
expect 0 "$program" section "$work/square.yaml" --json
cp "$work/out" "$work/square.json"
for name in becas_s2 yu_pipe; do
    expect 0 "$program" section "$source/cases/$name.yaml" --json
    cp "$work/out" "$work/$name.json"
done

python3 - "$source/docs/numbers.md" "$work" <<'END' || fail 'an order is not right'
import json, re, sys
page, work = open(sys.argv[1]).read(), sys.argv[2]
OURS = 'nx ny nz mx my mz'.split()
orders = {name.strip(): order.split() for name, order in re.findall(r'^\| ([\w, ]+) \| `((?:[nm][xyz] ?){6})` \|', page, re.M)}
wrong = []
if len(orders) != 5:
    wrong.append(f'{len(orders)} rows of orders, not 5')

def moved(K, order):
    return [[K[OURS.index(a)][OURS.index(b)] for b in order] for a in order]

def K_of(name):
    return json.load(open(f'{work}/{name}.json'))['stations'][0]['K']

for tool, order in orders.items():
    first, second = order[:3], order[3:]
    axes = ''.join(n[1] for n in first)
    # forces and moments by the same turn of the axes, which is a rotation: no sign changes
    if sorted(order) != sorted(OURS) or len({n[0] for n in first}) != 1 or axes != ''.join(n[1] for n in second) or axes not in 'xyzxyz':
        wrong.append(f'{tool}: {order} is no turn of the axes')

# SONATA's rule: each 3x3 block is T^T M T with T the inverse of B
K, B = K_of('becas_s2'), [[0, 0, 1], [1, 0, 0], [0, 1, 0]]
T = [list(row) for row in zip(*B)]
def block(i, j):
    m = [row[3 * j:3 * j + 3] for row in K[3 * i:3 * i + 3]]
    return [[sum(T[p][a] * m[p][q] * T[q][b] for p in range(3) for q in range(3)) for b in range(3)] for a in range(3)]
turned = [block(i, 0)[a] + block(i, 1)[a] for i in range(2) for a in range(3)]
if turned != moved(K, orders['VABS, SONATA']):
    wrong.append("VABS, SONATA: not SONATA's own rule")

def printed(tool, name, entries, part, scale=lambda i, j: 1):
    """entries (row, column, value) as printed, row and column from 1 in the tool's order; part: of sqrt(K_ii K_jj)"""
    K = moved(K_of(name), orders[tool])
    for i, j, value in entries:
        ours = K[i - 1][j - 1] / scale(i, j)
        if not abs(ours - value) <= part * (K[i - 1][i - 1] / scale(i, i) * K[j - 1][j - 1] / scale(j, j)) ** 0.5:
            wrong.append(f'{tool}: {name} entry {i}, {j} is {ours:.6g}, printed {value:.6g}')

# half a unit of the last digit of the smallest, 2 digits; coarse meshes; the meshes of the tables
printed('BECAS', 'becas_s2', [(1, 1, .128), (2, 2, .192), (3, 3, .55), (4, 4, .000459), (6, 6, .000277), (2, 6, -.00393), (3, 5, .0113)], 5e-3)
printed('ANBA4', 'square', [(1, 1, .311064), (2, 2, .311064), (3, 3, 1), (4, 4, 1 / 12), (5, 5, 1 / 12), (6, 6, .0528559)], 1e-3)
lbf, inch = 4.4482216152605, 0.0254
printed('VABS, SONATA', 'yu_pipe',
        [(1, 1, 1.03892e7), (2, 2, 7.8531e5), (3, 3, 3.29279e5), (1, 4, 98457.5), (2, 5, -8218.05), (3, 6, -52098.1), (4, 4, 687275),
         (5, 5, 1882380), (6, 6, 5389870)], 1e-3, lambda i, j: lbf * inch ** ((i > 3) + (j > 3)))
# SoRoSim's diag([G*Ix, E*Iy, E*Iz, E*A, G*A, G*A]) on a square: torsion first, then two equal bendings, stretch, two equal shears
d = [moved(K_of('square'), orders['SoRoSim'])[i][i] for i in range(6)]
if not (abs(d[3] - 1) < 1e-6 and abs(d[1] - 1 / 12) < 1e-6 and abs(d[1] - d[2]) < 1e-6 and abs(d[4] - d[5]) < 1e-6 and d[0] < d[1] < d[4]):
    wrong.append(f'SoRoSim: {d} is not torsion, bending twice, stretch, shear twice')
print('\n'.join(wrong))
sys.exit(bool(wrong))
END
finish
