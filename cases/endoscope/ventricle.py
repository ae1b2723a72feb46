#!/usr/bin/env python3
"""A SYNTHETIC lateral ventricle with a choroid-plexus-like band, targets on it and an entry line: no patient's anatomy.

    python3 ventricle.py [--triangles N | --size MM] [--widths FACTOR] [--targets N] [--out DIR]

writes, in mm, beside itself or into DIR:
    ventricle.stl   the wall, closed, its triangles' normals outward
    plexus.stl      the band, an open sheet, to look at
    targets.csv     x, y, z, name
    entry.csv       two points of each entry line
and prints sizes measured on the wall. The same options give the same bytes.

Axes (right ventricle): x to the side from the midplane, y forward, z up; y = 0 and z = 0 at the foramen of Monro.

How it is made: two curves, a C (frontal horn, body, atrium, temporal horn) and the occipital horn, each with an ellipse across
it whose half axes vary along it; the wall is where the smooth union of both is zero (docs/endoscope.md says where the numbers
come from). The zero set is found in a grid's cells (surface nets) and every vertex is then put onto it.
"""
import argparse
import math
import os
import struct
import sys

# --- the anatomy, in mm: x, y, z of the middle, half width across (to the side), half height; chosen before any scope was tried, but for
# the horns' ends, made smooth after the first counts (the clinical scope's was 7 before and after)

C_CURVE = [  # name of the stretch that begins here
    ("frontal horn", 14.5, 20.0, 5.5, 8.2, 11.5),
    ("body", 11.5, 0.0, 8.0, 9.0, 11.5),  # at the foramen of Monro
    ("", 13.0, -18.0, 11.0, 8.5, 9.5),
    ("atrium", 17.0, -36.0, 10.0, 9.0, 9.5),
    ("", 23.0, -50.0, 2.0, 10.0, 12.0),  # its middle
    ("temporal horn", 29.0, -51.0, -11.0, 8.0, 9.0),
    ("", 33.0, -42.0, -21.0, 6.0, 6.0),
    ("", 33.5, -28.0, -25.0, 5.5, 4.5),
    ("", 31.5, -16.0, -26.0, 4.8, 4.0),
]
MONRO, ATRIUM, ATRIUM_MIDDLE, TEMPORAL = 1, 3, 4, 5
OCCIPITAL_CURVE = [
    ("", 23.5, -50.0, 1.0, 9.0, 10.0),
    ("occipital horn", 23.0, -63.0, -2.0, 7.0, 7.5),
]
# the horns end as half ellipsoids, so much longer than their last node
FRONTAL_CAP, TEMPORAL_CAP, OCCIPITAL_CAP = 14.0, 12.0, 17.0
BLEND = 6.0  # where the curves meet, over this depth

# the band lies on the inner side of the C: floor of the body, front of the atrium, roof of the temporal horn, to the midplane's side
BAND_TILT = (15.0, 35.0, 55.0)  # its lateral edge, middle and medial edge, from straight inward [deg]
BAND_END = 12.0  # it begins at the foramen of Monro and ends so far before the temporal horn's tip
PLEXUS = 3.2  # its surface lies so far off the wall

ENTRIES = [  # a point on the skull, and one that the line goes towards
    # Kaufman's point: on the forehead, 45 mm above the nasion, towards the midline 30 mm above the inion: along the body
    ("forehead", (30.0, 75.0, 18.0), (0.0, -100.0, -10.0)),
    # Kocher's point: 10 mm before the coronal suture, towards the foramen of Monro: steeply down
    ("Kocher", (30.0, 20.0, 54.0), (6.0, 0.0, 0.0)),
]

LABEL = "SYNTHETIC lateral ventricle, not a patient's: stiffaxis cases/endoscope/ventricle.py, mm"


def add(a, b, share=1.0):
    return (a[0] + share * b[0], a[1] + share * b[1], a[2] + share * b[2])


def dot(a, b):
    return a[0] * b[0] + a[1] * b[1] + a[2] * b[2]


def cross(a, b):
    return (a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0])


def unit(a):
    return add((0.0, 0.0, 0.0), a, 1.0 / math.sqrt(dot(a, a)))


# --- a curve with an ellipse across it


def second_derivatives(t, y, flat):
    """of the cubic spline through y at t; its ends straight, or `flat`: without slope"""
    n = len(t)
    slope = [0.0] + [(y[i + 1] - y[i]) / (t[i + 1] - t[i]) for i in range(n - 1)] + [0.0]
    upper, m = [0.0] * n, [0.0] * n
    for i in range(n):
        before, after = (t[i] - t[i - 1] if i > 0 else 0.0), (t[i + 1] - t[i] if i < n - 1 else 0.0)
        if not flat and i in (0, n - 1):
            continue
        pivot = 2 * (before + after) - (before * upper[i - 1] if i > 0 else 0.0)
        upper[i] = after / pivot
        m[i] = (6 * (slope[i + 1] - slope[i]) - (before * m[i - 1] if i > 0 else 0.0)) / pivot
    for i in range(n - 2, -1, -1):
        m[i] -= upper[i] * m[i + 1]
    return m


class Curve:
    def __init__(self, nodes, caps, widths):
        self.caps = caps  # at its beginning and its end
        rows = [(n[1], n[2], n[3], n[4] * widths, n[5] * widths) for n in nodes]
        self.t = [0.0]
        for a, b in zip(rows, rows[1:]):
            self.t.append(self.t[-1] + math.dist(a[:3], b[:3]))
        self.names = [(t, n[0]) for t, n in zip(self.t, nodes) if n[0]]
        # per stretch: x, y, z, half width, half height as cubics in t from its beginning
        self.pieces = [[] for _ in rows[1:]]
        for column, y in enumerate(zip(*rows)):
            m = second_derivatives(self.t, y, flat=column >= 3)
            for i, piece in enumerate(self.pieces):
                h = self.t[i + 1] - self.t[i]
                slope = (y[i + 1] - y[i]) / h - h * (2 * m[i] + m[i + 1]) / 6
                piece.append((y[i], slope, m[i] / 2, (m[i + 1] - m[i]) / (6 * h)))
        self.starts = []
        for i in range(2 * len(self.pieces) + 1):
            t = self.t[-1] * i / (2 * len(self.pieces))
            self.starts.append((t, *self.at(t)))

    def piece(self, t):
        i = 0
        while i < len(self.pieces) - 1 and t > self.t[i + 1]:
            i += 1
        return self.pieces[i], t - self.t[i]

    def at(self, t):
        piece, s = self.piece(t)
        return tuple(c[0] + s * (c[1] + s * (c[2] + s * c[3])) for c in piece[:3])

    def nearest(self, p):
        x, y, z = p
        t = min([((a - x) ** 2 + (b - y) ** 2 + (c - z) ** 2, t) for t, a, b, c in self.starts])[1]
        for _ in range(4):
            piece, s = self.piece(t)
            g = slope = speed = 0.0
            for c, w in zip(piece, p):
                d0 = c[0] + s * (c[1] + s * (c[2] + s * c[3])) - w
                d1 = c[1] + s * (2 * c[2] + s * 3 * c[3])
                g += d0 * d1
                speed += d1 * d1
                slope += d1 * d1 + d0 * (2 * c[2] + 6 * s * c[3])
            before = t
            t = min(max(t - g / max(slope, 0.2 * speed), 0.0), self.t[-1])
            if abs(t - before) < 1e-7:
                break
        return t

    def frame(self, t):
        """middle, u to the side, v away from the C's inside, tangent, half width, half height"""
        piece, s = self.piece(t)
        tangent = unit(tuple(c[1] + s * (2 * c[2] + s * 3 * c[3]) for c in piece[:3]))
        u = unit(add((1.0, 0.0, 0.0), tangent, -tangent[0]))
        half = [c[0] + s * (c[1] + s * (c[2] + s * c[3])) for c in piece[3:]]
        return self.at(t), u, cross(tangent, u), tangent, half[0], half[1]

    def field(self, p):
        """about the distance to the wall, negative within; at the ends half an ellipsoid"""
        middle, u, v, tangent, a, b = self.frame(self.nearest(p))
        q = add(p, middle, -1.0)
        x, y, z = dot(q, u), dot(q, v), dot(q, tangent)
        cap = self.caps[z > 0]
        k0 = math.sqrt((x / a) ** 2 + (y / b) ** 2 + (z / cap) ** 2)
        k1 = math.sqrt((x / (a * a)) ** 2 + (y / (b * b)) ** 2 + (z / (cap * cap)) ** 2)
        return k0 * (k0 - 1.0) / k1 if k1 > 0 else -min(a, b)


class Ventricle:
    def __init__(self, widths):
        self.c = Curve(C_CURVE, (FRONTAL_CAP, TEMPORAL_CAP), widths)
        self.occipital = Curve(OCCIPITAL_CURVE, (OCCIPITAL_CURVE[0][4], OCCIPITAL_CAP), widths)

    def field(self, p):
        f, g = self.c.field(p), self.occipital.field(p)
        h = max(BLEND - abs(f - g), 0.0) / BLEND
        return min(f, g) - h * h * BLEND / 4

    def slope(self, p, step=1e-4):
        f = self.field(p)
        d = tuple((self.field(tuple(p[j] + (step if i == j else 0.0) for j in range(3))) - f) / step for i in range(3))
        return f, d

    def onto_wall(self, p):
        """p moved along the slope until the field is zero, and that slope"""
        f, d = self.slope(p)
        norm = dot(d, d)
        for _ in range(6):
            p = add(p, d, -f / norm)
            f = self.field(p)
            if abs(f) < 1e-7:
                break
        return p, d


# --- the zero set: surface nets

CORNERS = [(i, j, k) for i in (0, 1) for j in (0, 1) for k in (0, 1)]
EDGES = [(a, b) for a in range(8) for b in range(a + 1, 8) if sum(x != y for x, y in zip(CORNERS[a], CORNERS[b])) == 1]
SIDES = [(axis, side) for axis in range(3) for side in (0, 1)]


def surface_cells(shape, size, start):
    """the grid's cells that the wall passes through, from one to the next: {cell: its corners' values}"""
    value = {}

    def at(i, j, k):
        if (i, j, k) not in value:
            value[i, j, k] = shape.field((i * size, j * size, k * size))
        return value[i, j, k]

    i, j, k = (round(x / size) for x in start)
    while at(i, j, k + 1) < 0:
        k += 1
    cells, waiting = {}, [(i, j, k)]
    while waiting:
        cell = waiting.pop()
        if cell in cells:
            continue
        f = [at(cell[0] + c[0], cell[1] + c[1], cell[2] + c[2]) for c in CORNERS]
        cells[cell] = f
        for axis, side in SIDES:
            inside = [f[n] < 0 for n in range(8) if CORNERS[n][axis] == side]
            if any(inside) and not all(inside):
                waiting.append(tuple(cell[n] + (2 * side - 1 if n == axis else 0) for n in range(3)))
    return cells


def cell_vertex(cell, f, size):
    """the middle of where the cell's edges pass through the wall"""
    sums, n = [0.0, 0.0, 0.0], 0
    for a, b in EDGES:
        if (f[a] < 0) != (f[b] < 0):
            share = f[a] / (f[a] - f[b])
            for m in range(3):
                sums[m] += cell[m] + CORNERS[a][m] + share * (CORNERS[b][m] - CORNERS[a][m])
            n += 1
    return tuple(size * s / n for s in sums)


def cut(vertex, quad):
    """a quadrangle by its shorter diagonal"""
    a, b, c, d = quad
    if math.dist(vertex[a], vertex[c]) <= math.dist(vertex[b], vertex[d]):
        return [(a, b, c), (a, c, d)]
    return [(a, b, d), (b, c, d)]


def wall(shape, size):
    """vertices, the slopes there, and triangles, counter-clockwise seen from outside"""
    cells = surface_cells(shape, size, shape.c.at(shape.c.t[MONRO]))
    order = sorted(cells)
    number = {cell: n for n, cell in enumerate(order)}
    vertex, slope = zip(*(shape.onto_wall(cell_vertex(cell, cells[cell], size)) for cell in order))
    triangle = []
    for cell in order:
        f = cells[cell]
        for axis in range(3):
            # the edge from corner 0 along this axis, and the four cells around it
            along = CORNERS.index(tuple(int(n == axis) for n in range(3)))
            if (f[0] < 0) == (f[along] < 0):
                continue
            one, two = (axis + 1) % 3, (axis + 2) % 3
            around = [tuple(cell[n] - (n == one and i) - (n == two and j) for n in range(3)) for i, j in ((0, 0), (1, 0), (1, 1), (0, 1))]
            quad = [number[c] for c in around]
            triangle += cut(vertex, quad if f[0] < 0 else quad[::-1])
    return vertex, slope, triangle


def check_wall(vertex, slope, triangle):
    edges = set()
    for t in triangle:
        for k in range(3):
            edge = (t[k], t[(k + 1) % 3])
            if edge in edges:
                sys.exit("ventricle.py: the wall meets itself at this size of triangles: ask for more of them")
            edges.add(edge)
        a, b, c = (vertex[n] for n in t)
        normal = cross(add(b, a, -1), add(c, a, -1))
        if any(dot(normal, slope[n]) <= 0 for n in t):
            sys.exit("ventricle.py: the wall folds at this size of triangles: ask for more of them")
    if any((b, a) not in edges for a, b in edges):
        sys.exit("ventricle.py: the wall is open at this size of triangles: ask for more of them")


def area_and_volume(vertex, triangle):
    area = volume = 0.0
    for t in triangle:
        a, b, c = (vertex[n] for n in t)
        normal = cross(add(b, a, -1), add(c, a, -1))
        area += math.sqrt(dot(normal, normal)) / 2
        volume += dot(a, normal) / 6
    return area, volume


# --- the band and its targets


def band_point(shape, t, tilt):
    """the wall seen from the C's middle at t, `tilt` from straight inward to the midplane's side; then off it"""
    middle, u, v, _, a, b = shape.c.frame(t)
    angle = math.radians(tilt)
    ray = unit(add(add((0.0, 0.0, 0.0), u, -a * math.sin(angle)), v, -b * math.cos(angle)))
    near, far = 0.0, 3 * max(a, b)
    while far - near > 1e-9:
        half = (near + far) / 2
        near, far = (half, far) if shape.field(add(middle, ray, half)) < 0 else (near, half)
    foot = add(middle, ray, near)
    return add(foot, unit(shape.slope(foot)[1]), -PLEXUS)


def arc_lengths(shape, first, last, n):
    """n parameters of the C, at equal lengths along the band's middle, in the middle of n equal parts"""
    fine = [first + (last - first) * i / 400 for i in range(401)]
    places = [band_point(shape, t, BAND_TILT[1]) for t in fine]
    length = [0.0]
    for a, b in zip(places, places[1:]):
        length.append(length[-1] + math.dist(a, b))
    out, i = [], 0
    for k in range(n):
        want = length[-1] * (k + 0.5) / n
        while length[i + 1] < want:
            i += 1
        out.append(fine[i] + (fine[i + 1] - fine[i]) * (want - length[i]) / (length[i + 1] - length[i]))
    return out, length[-1]


def make_targets(shape, n):
    first, last = shape.c.t[MONRO], shape.c.t[-1] + TEMPORAL_CAP - BAND_END
    ts, length = arc_lengths(shape, first, last, n)
    count, rows = {}, []
    for k, t in enumerate(ts):
        name = [words for start, words in shape.c.names if start <= t][-1]
        count[name] = count.get(name, 0) + 1
        lane = k % 3
        words = "%s %d %s" % (name, count[name], ("lateral", "middle", "medial")[lane])
        rows.append((band_point(shape, t, BAND_TILT[lane]), words))
    return rows, length


def band_sheet(shape, n=60):
    first, last = shape.c.t[MONRO], shape.c.t[-1] + TEMPORAL_CAP - BAND_END
    rows = [[band_point(shape, first + (last - first) * i / n, tilt) for tilt in BAND_TILT] for i in range(n + 1)]
    vertex = [p for row in rows for p in row]
    triangle = []
    for i in range(n):
        for j in range(2):
            a = 3 * i + j
            triangle += [(a, a + 3, a + 4), (a, a + 4, a + 1)]
    return vertex, triangle


# --- files


def write_stl(path, label, vertex, triangle):
    data = [label.encode().ljust(80)[:80], struct.pack("<I", len(triangle))]
    for t in triangle:
        a, b, c = (vertex[n] for n in t)
        normal = unit(cross(add(b, a, -1), add(c, a, -1)))
        data.append(struct.pack("<12fH", *normal, *a, *b, *c, 0))
    with open(path, "wb") as file:
        file.write(b"".join(data))


def write_csv(path, remark, rows):
    with open(path, "w", encoding="ascii", newline="\n") as file:
        file.write("# %s\n# %s\nx [mm],y [mm],z [mm],name\n" % (LABEL, remark))
        for p, name in rows:
            file.write("%.4f,%.4f,%.4f,%s\n" % (*p, name))


def across(vertex, keep, axis):
    values = [p[axis] for p in vertex if keep(p)]
    return max(values) - min(values) if values else float("nan")


def tell(shape, size, vertex, triangle, targets, band):
    area, volume = area_and_volume(vertex, triangle)
    y = [p[1] for p in vertex]
    slab = max(size, 1.0)
    lines = [
        ("triangles", "%d of about %.2f mm" % (len(triangle), size)),
        ("volume", "%.2f mL" % (volume / 1000)),
        ("area", "%.1f cm^2" % (area / 100)),
        ("frontal horn, foramen of Monro to tip", "%.1f mm" % max(y)),
        ("frontal horns, both, across", "%.1f mm" % (2 * max(p[0] for p in vertex if p[1] > 0))),
        ("body, foramen of Monro to atrium along its middle", "%.1f mm" % (shape.c.t[ATRIUM] - shape.c.t[MONRO])),
        ("body across at its middle", "%.1f mm" % across(vertex, lambda p: abs(p[1] + 25) < slab and p[2] > -5, 0)),
        ("body's height at its middle", "%.1f mm" % across(vertex, lambda p: abs(p[1] + 25) < slab and p[2] > -5, 2)),
        ("occipital horn, atrium's middle to tip", "%.1f mm" % (C_CURVE[ATRIUM_MIDDLE][2] - min(y))),
        ("occipital horn across, 12 mm behind the atrium", "%.1f mm" % across(vertex, lambda p: abs(p[1] + 62) < slab, 0)),
        ("temporal horn along its middle", "%.1f mm" % (shape.c.t[-1] + TEMPORAL_CAP - shape.c.t[TEMPORAL])),
        ("temporal horn across at its middle", "%.1f mm" % across(vertex, lambda p: abs(p[1] + 28) < slab and p[2] < -12, 0)),
        ("temporal horn's height at its middle", "%.1f mm" % across(vertex, lambda p: abs(p[1] + 28) < slab and p[2] < -12, 2)),
        ("band, foramen of Monro to its end", "%.1f mm" % band),
        ("targets", "%d, %.1f mm off the wall" % (len(targets), PLEXUS)),
    ]
    print("SYNTHETIC lateral ventricle, mm; x to the side, y forward, z up from the foramen of Monro")
    for name, value in lines:
        print("  %-50s %s" % (name, value))


def main():
    here = os.path.dirname(os.path.abspath(__file__))
    parser = argparse.ArgumentParser(description="a synthetic lateral ventricle with targets and an entry line")
    parser.add_argument("--triangles", type=int, default=20000, help="about so many triangles of the wall (default 20000)")
    parser.add_argument("--size", type=float, help="the grid's spacing instead [mm]")
    parser.add_argument("--widths", type=float, default=1.0, help="factor on all widths and heights (default 1)")
    parser.add_argument("--targets", type=int, default=20, help="how many targets (default 20)")
    parser.add_argument("--out", default=here, help="where to (default: beside this file)")
    options = parser.parse_args()
    if not (500 <= options.triangles <= 2000000 and 0.5 <= options.widths <= 1.5 and 1 <= options.targets <= 1000):
        parser.error("500 to 2000000 triangles, widths by 0.5 to 1.5, 1 to 1000 targets")
    if options.size is not None and not 0.1 <= options.size <= 4:
        parser.error("a size of 0.1 to 4 mm")

    shape = Ventricle(options.widths)
    size = options.size
    if size is None:
        # a grid cuts a surface in 1.5 squares per square of its spacing, taken over all directions
        vertex, _, triangle = wall(shape, 4.0)
        size = math.sqrt(3 * area_and_volume(vertex, triangle)[0] / options.triangles)
    vertex, slope, triangle = wall(shape, size)
    check_wall(vertex, slope, triangle)
    targets, band = make_targets(shape, options.targets)
    os.makedirs(options.out, exist_ok=True)
    path = lambda name: os.path.join(options.out, name)
    write_stl(path("ventricle.stl"), LABEL, vertex, triangle)
    write_stl(path("plexus.stl"), LABEL.replace("ventricle,", "plexus,", 1), *band_sheet(shape))
    write_csv(path("targets.csv"), "on the choroid-plexus-like band, %.1f mm off the wall" % PLEXUS, targets)
    write_csv(path("entry.csv"), "entry lines: entry.point_mm and entry.towards_mm of a case",
              [(p, name + words) for name, *line in ENTRIES for p, words in zip(line, (" point", " towards"))])
    tell(shape, size, vertex, triangle, targets, band)


if __name__ == "__main__":
    main()
