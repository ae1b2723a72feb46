# The SYNTHETIC clouds of this folder, no measurement: awk -f make.awk ../measured/helical_nc_0.98N.csv > helical_0.98N.ply
# Points of the surface of a tube of 4 mm around a made line (tendon at 3.65 mm, friction 0.05), as a scanner on a bench sees
# them: noise of 0.05 mm, 30 % of the surface missing in patches, 2 % strays; turned and shifted into the scanner's own frame.
function uniform() { seed = (16807 * seed) % 2147483647; return seed / 2147483647 }
function normal() { return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform()) }
# by 20 degrees about x, 50 about z, then away: rod_mm into scan_mm
function place(p,    y, z) {
    y = cos(a) * p[2] - sin(a) * p[3]; z = sin(a) * p[2] + cos(a) * p[3]
    return sprintf("%.2f %.2f %.2f", cos(b) * p[1] - sin(b) * y + 30, sin(b) * p[1] + cos(b) * y - 12, z + 200)
}
# the made line has a scanner's errors already: smoothed by the parabola through nine (near the ends five) neighbours
function pair(i, d, step) { return x[i - step, d] + x[i + step, d] }
function smooth(i, d) {
    if (i > 4 && i < n - 3)
        return (59 * x[i, d] + 54 * pair(i, d, 1) + 39 * pair(i, d, 2) + 14 * pair(i, d, 3) - 21 * pair(i, d, 4)) / 231
    if (i > 2 && i < n - 1) return (17 * x[i, d] + 12 * pair(i, d, 1) - 3 * pair(i, d, 2)) / 35
    return x[i, d]
}
function cell(s, phi) { return missing[int(12 * (s - 1) / n), int(6 * phi / 6.2831854)] }
BEGIN { FS = ","; seed = 20206; a = 20 * 3.141592653589793 / 180; b = 50 * 3.141592653589793 / 180 }
/^[0-9]/ { n++; for (d = 1; d <= 3; d++) x[n, d] = $(d + 1) }
END {
    points = 4000; strays = 80
    for (i = 0; i < 12; i++) for (k = 0; k < 6; k++) missing[i, k] = uniform() < 0.3
    for (i = 1; i <= n; i++) for (d = 1; d <= 3; d++) p[i, d] = smooth(i, d)
    print "ply\nformat ascii 1.0"
    print "comment SYNTHETIC: made by cases/scan/make.awk, not measured"
    print "element vertex " points + strays
    print "property float x\nproperty float y\nproperty float z\nend_header"
    for (done = 0; done < points;) {
        s = 1 + uniform() * (n - 1); phi = 6.283185307179586 * uniform()
        if (cell(s, phi)) continue
        i = int(s); i = i < n ? i : n - 1; r = 4 + 0.05 * normal()
        for (d = 1; d <= 3; d++) t[d] = p[i + 1, d] - p[i, d]
        size = sqrt(t[1] ^ 2 + t[2] ^ 2 + t[3] ^ 2)
        # u and v across the line: u = t x (0, 1, 0), v = t x u
        ux = -t[3]; uz = t[1]; usize = sqrt(ux ^ 2 + uz ^ 2)
        ux /= usize; uz /= usize
        vx = t[2] * uz / size; vy = (t[3] * ux - t[1] * uz) / size; vz = -t[2] * ux / size
        q[1] = p[i, 1] + (s - i) * t[1] + r * (cos(phi) * ux + sin(phi) * vx)
        q[2] = p[i, 2] + (s - i) * t[2] + r * sin(phi) * vy
        q[3] = p[i, 3] + (s - i) * t[3] + r * (cos(phi) * uz + sin(phi) * vz)
        print place(q); done++
    }
    for (k = 0; k < strays; k++) { for (d = 1; d <= 3; d++) q[d] = 120 * (uniform() - (d < 3 ? 0.5 : 0)); print place(q) }
}
