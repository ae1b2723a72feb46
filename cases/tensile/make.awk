# The SYNTHETIC tensile tests of soft_synthetic.csv, no measurement: awk -f make.awk > soft_synthetic.csv
# Five bars of a rubber (neo-Hookean in tension) whose moduli scatter by 3 % about 0.66 MPa, gripped with some slack.
function uniform() { seed = (16807 * seed) % 2147483647; return seed / 2147483647 }
function normal() { return sqrt(-2 * log(uniform())) * cos(6.283185307179586 * uniform()) }
# slack clamps take hold one after another: the strain counts from half of `toe`
function stress(E, strain, toe,    stretch) {
    if (strain < toe) return 0.5 * E * strain * strain / toe
    stretch = 1 + strain - 0.5 * toe
    return E / 3 * (stretch - 1 / (stretch * stretch))
}
BEGIN {
    seed = 20206; length_mm = 25; area_mm2 = 8
    print "# SYNTHETIC data made by cases/tensile/make.awk: no measurement"
    print "Test;tension, first loading"
    print "Gauge length [mm];" length_mm
    print "Area [mm^2];" area_mm2
    print ""
    print "Specimen;Extension;Force"
    print ";(mm);(N)"
    for (bar = 1; bar <= 5; bar++) {
        E = 0.66 * (1 + 0.03 * normal()); toe = 0.004 + 0.003 * uniform()
        for (i = 0; i <= 200; i++) {
            strain = 0.12 * i / 200
            printf "bar %d;%.4f;%.5f\n", bar, length_mm * strain, area_mm2 * stress(E, strain, toe) + 0.002 * normal()
        }
    }
}
