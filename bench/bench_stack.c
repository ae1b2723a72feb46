// bench/bench_stack.c
// A printed robot as a stack of 500 slices of 400 x 400 pixels, twelve of them distinct: reading
// the case and its images, and K(s).
#include "app/case.h"
#include "bench/bench.h"
#include "tests/png_files.h"

#include <math.h>
#include <unistd.h>

enum { SLICES = 500, PIXELS = 400, DISTINCT = 12, MOST_PATH = 256 };

static const double limit = 10; // [s] CPU

static const char case_text[] = "format: 1\n"
                                "materials:\n"
                                "  soft: {E_MPa: 0.66, nu: 0.3}\n"
                                "  stiff: {E_MPa: 15.93, nu: 0.3}\n"
                                "section:\n"
                                "  png:\n"
                                "    file: slice_%03d.png\n"
                                "    pitch_mm: [0.02, 0.02]\n"
                                "    layer_mm: 0.24\n"
                                "    parts:\n"
                                "      - {colour: '#ff0000', material: soft}\n"
                                "      - {colour: '#00ff00', material: stiff}\n";

// the constant-NC section with its strip at another angle in each twelfth of the stack
static int two_materials(double x, double y, const void *context)
{
    const double radius = hypot(x, y) / (PIXELS / 2.0), angle = 0.26 * *(const int *)context;
    if (radius > 0.99 || radius < 0.75) {
        return 0;
    }
    const double away = remainder(atan2(y, x) - angle, 2 * acos(-1.0));
    return fabs(away) < acos(-1.0) / 8 ? 2 : 1;
}

static status write_text(const char *path, const char *text)
{
    FILE *file = fopen(path, "w");
    const bool good = file && fputs(text, file) >= 0;
    return file && fclose(file) == 0 && good ? OK
                                             : status_fail(ERR_RESOURCE, "cannot write %s", path);
}

static status write_stack(const char *directory)
{
    status st = OK;
    char path[MOST_PATH];
    for (int k = 0; k < DISTINCT && st == OK; k++) {
        const png_bytes image = png_draw(PIXELS, PIXELS, two_materials, &k);
        for (int i = 0; i < SLICES; i++) {
            (void)snprintf(path, sizeof path, "%s/slice_%03d.png", directory, i);
            if (i * DISTINCT / SLICES == k && !png_write(path, image)) {
                st = status_fail(ERR_RESOURCE, "cannot write %s", path);
            }
        }
        free(image.at);
    }
    TRY(st);
    (void)snprintf(path, sizeof path, "%s/stack.yaml", directory);
    TRY(write_text(path, case_text));

done:
    return st;
}

static void remove_stack(const char *directory)
{
    char path[MOST_PATH];
    for (int i = 0; i < SLICES; i++) {
        (void)snprintf(path, sizeof path, "%s/slice_%03d.png", directory, i);
        (void)unlink(path);
    }
    (void)snprintf(path, sizeof path, "%s/stack.yaml", directory);
    (void)unlink(path);
    (void)rmdir(directory);
}

static status measure(const char *directory, int *missed)
{
    status st = OK;
    char path[MOST_PATH], words[SECTION_EFFORT_WORDS];
    case_data c = {0};
    section_result r = {0};
    (void)snprintf(path, sizeof path, "%s/stack.yaml", directory);
    const double begin = bench_cpu_ms();
    TRY(case_open(&(case_request){.path = path}, &c));
    const double read = bench_cpu_ms();
    TRY(section_along(&c.file.section, c.materials, c.length, &r));
    const double solved = bench_cpu_ms();
    printf("%d slices of %d x %d pixels, %d distinct: read %.2f s, %s %.2f s; error of K %.1e\n",
           SLICES, PIXELS, PIXELS, DISTINCT, 1e-3 * (read - begin),
           section_effort_words(&r.effort, words), 1e-3 * (solved - read),
           r.station[0].law.relative_error);
    *missed =
        bench_target("a stack of 500 slices, 12 distinct", 1e-3 * (solved - begin), limit, "CPU s");

done:
    section_result_free(&r);
    case_free(&c);
    return st;
}

int main(void)
{
    status st = OK;
    int missed = 0;
    char directory[] = "/tmp/stiffaxis-bench-XXXXXX";
    if (!mkdtemp(directory)) {
        printf("no temporary directory\n");
        return 1;
    }
    TRY(write_stack(directory));
    TRY(measure(directory, &missed));

done:
    remove_stack(directory);
    if (st != OK) {
        printf("error: %s\n", status_message());
    }
    return st != OK || missed;
}
