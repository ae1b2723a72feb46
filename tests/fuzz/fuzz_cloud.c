// fuzz_cloud SECONDS [SEED]: mutated point clouds of every format. Always points that are finite,
// or an error of one line.
#include "measure/cloud_read.h"

#include "tests/clouds.h"
#include "tests/fuzz/mutate.h"

#include <math.h>

enum { COUNT = 24, SEEDS = 17 };

static status read_cloud(const char *directory, const char *name, void *context)
{
    char path[512];
    point_cloud c = {0};
    cloud_report r;
    (void)context;
    (void)snprintf(path, sizeof path, "%s/%s", directory, name);
    status st = cloud_read(path, &(cloud_read_options){.unit = NAN}, &c, &r);
    for (size_t i = 0; i < c.count; i++) {
        const bool finite = isfinite(c.p[i][0] + c.p[i][1] + c.p[i][2]);
        st = finite ? st : status_fail(ERR_BUG, "point %zu is not finite", i);
    }
    point_cloud_free(&c);
    return st;
}

// a helix with a NaN in it
static void make_points(double (*p)[3])
{
    for (int i = 0; i < COUNT; i++) {
        p[i][0] = i == 5 ? (double)NAN : 4 * cos(0.5 * i);
        p[i][1] = 4 * sin(0.5 * i);
        p[i][2] = 0.25 * i;
    }
}

static void write_seed(cloud_file *f, int which, double (*points)[3])
{
    const double(*p)[3] = (const double(*)[3])points;
    static const char *const heads[] = {"x_mm;y_mm;z_mm;note\n", ""};
    if (which < 9) {
        cloud_file_ply(f, which % 3, which % 2 ? "float" : "double", which / 3, COUNT, p);
    } else if (which < 15) {
        cloud_file_pcd(f, which % 3, (which - 9) / 2, COUNT, p);
    } else {
        fputs(heads[which - 15], f->stream);
        for (int i = 0; i < COUNT; i++) {
            fprintf(f->stream, which == 15 ? "%.3f;%.17g;%g;a\n" : "%.3f %.17g %g\n", p[i][0],
                    p[i][1], p[i][2]);
        }
    }
}

int main(int argc, char **argv)
{
    double p[COUNT][3];
    mutant_seed seeds[SEEDS];
    char *bytes[SEEDS];
    make_points(p);
    for (int i = 0; i < SEEDS; i++) {
        cloud_file f = {0};
        f.stream = open_memstream(&bytes[i], &seeds[i].count);
        write_seed(&f, i, p);
        (void)cloud_file_close(&f);
        seeds[i].bytes = (const unsigned char *)bytes[i];
    }
    const int bad = mutants_main(
        argc, argv,
        (mutant_plan){.nseed = SEEDS, .seeds = seeds, .suffix = ".ply", .read = read_cloud});
    for (int i = 0; i < SEEDS; i++) {
        free(bytes[i]);
    }
    return bad;
}
