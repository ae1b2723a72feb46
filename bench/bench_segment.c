// bench/bench_segment.c
// The compliance of the paper's Fig. 4 segment (cases/fig4_compliance.yaml) against CPU time: whole
// processes of ours by each way and tolerance, and CalculiX's on decks of our meshes, in one run.
#include "app/calculix_door.h"
#include "bench/bench.h"
#include "meshes/mesher.h"

#include <fcntl.h>
#include <math.h>
#include <string.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

// tip motion under a unit E-proportional load through the stiffness centre, clamped, nu 0.3: two
// ladders of meshes apart by 1.7e-7 at their limits (bench_segment_reference) [m/N]
static const double REFERENCE = 0.6820060e-3; // bench_segment_reference

enum { RUNS = 5, MOST_PATH = 4096, MOST_LAYERS = 64 };
// runs longer than this are not repeated [s]
static const double LONG_RUN = 1;

typedef struct timed {
    double cpu;   // [s]
    double error; // relative to the reference
    double said;  // what the program says of it; NAN: nothing
    long dofs;
} timed;

static double seconds(struct timeval t)
{
    return (double)t.tv_sec + 1e-6 * (double)t.tv_usec;
}

// --- ours

static double number_behind(const char *text, const char *key)
{
    const char *at = strstr(text, key);
    at = at ? strchr(at, ':') : NULL;
    return at ? strtod(at + 1, NULL) : NAN;
}

// runs the words with stdout into `text`; CPU seconds, negative where it failed
static double run_words(char *const *words, char *text, size_t size)
{
    int ends[2], state = 0;
    struct rusage usage;
    size_t used = 0;
    if (pipe(ends) != 0) {
        return -1;
    }
    const pid_t child = fork();
    if (child == 0) {
        const int null = open("/dev/null", O_WRONLY);
        (void)dup2(ends[1], 1);
        (void)dup2(null, 2);
        (void)close(ends[0]);
        (void)execv(words[0], words);
        _exit(127);
    }
    (void)close(ends[1]);
    for (ssize_t got = 1; got > 0; used += got > 0 ? (size_t)got : 0) {
        char spare[4096];
        const bool room = used + 1 < size;
        got = read(ends[0], room ? text + used : spare, room ? size - 1 - used : sizeof spare);
        got = got < 0 ? 0 : got;
        if (!room) {
            used -= (size_t)got;
        }
    }
    text[used] = '\0';
    (void)close(ends[0]);
    const bool ended = child > 0 && wait4(child, &state, 0, &usage) == child;
    return ended && WIFEXITED(state) && WEXITSTATUS(state) == 0
               ? seconds(usage.ru_utime) + seconds(usage.ru_stime)
               : -1;
}

// best CPU time of several runs; false where it does not run
static bool ours(const char *program, const char *method, const char *tolerance, timed *out)
{
    static char text[1 << 20];
    char set[2][64];
    (void)snprintf(set[0], sizeof set[0], "fem.method=%s", method);
    (void)snprintf(set[1], sizeof set[1], "fem.tolerance=%s", tolerance);
    char file[] = "cases/fig4_compliance.yaml", fem[] = "fem", json[] = "--json",
         option[] = "--set";
    char path[MOST_PATH];
    (void)snprintf(path, sizeof path, "%s", program);
    char *const words[] = {path, fem, file, json, option, set[0], option, set[1], NULL};
    *out = (timed){.cpu = INFINITY};
    for (int i = 0; i < RUNS && (i == 0 || out->cpu < LONG_RUN); i++) {
        const double cpu = run_words(words, text, sizeof text);
        if (cpu < 0) {
            return false;
        }
        out->cpu = fmin(out->cpu, cpu);
    }
    out->error = fabs(number_behind(text, "\"shortening_m\"") / -REFERENCE - 1);
    out->said = number_behind(text, "\"relative_error\"");
    out->dofs = (long)number_behind(text, "\"dofs\"");
    return true;
}

static void tell(const char *who, const char *what, const timed *t)
{
    printf("%-22s %-22s %9ld %9.3f %9.1e", who, what, t->dofs, t->cpu, t->error);
    if (isnan(t->said)) {
        printf("\n");
    } else {
        printf(" %9.1e\n", t->said);
    }
    bench_point(who, 1e3 * t->cpu, fmax(t->error, 1e-9));
}

// what the targets are held to: the cheapest run of the program's own choice within an error
typedef struct cheapest {
    double within, limit; // [1], [s]
    double cpu;           // of the cheapest so far
} cheapest;

static cheapest wanted[] = {{1e-4, 0.3, INFINITY}, {3e-5, 2, INFINITY}, {1e-5, 2, INFINITY}};
enum { WANTED = sizeof wanted / sizeof *wanted };

static void count_in(const timed *t)
{
    for (int i = 0; i < WANTED; i++) {
        if (t->error <= wanted[i].within) {
            wanted[i].cpu = fmin(wanted[i].cpu, t->cpu);
        }
    }
}

// one row per tolerance, the loosest first
static void table_of(const char *program, const char *method, int n, const char *const *tolerances)
{
    for (int i = 0; i < n; i++) {
        timed t;
        char what[40];
        (void)snprintf(what, sizeof what, "tolerance %s", tolerances[i]);
        if (!ours(program, method, tolerances[i], &t)) {
            printf("%-22s %-22s did not end well\n", method, what);
            continue;
        }
        tell(method, what, &t);
        if (strcmp(method, "auto") == 0) {
            count_in(&t);
        }
    }
}

// --- CalculiX

static const material both[2] = {{.name = "soft", .E = 0.66e6, .nu = 0.3},
                                 {.name = "stiff", .E = 15.93e6, .nu = 0.3}};

static status fig4_plane(double size, mesh *out)
{
    static const double outer = 4e-3, inner = 3.2e-3;
    outline items[2] = {
        {.kind = KIND_ANNULUS, .outer = outer, .inner = inner, .material = 0},
        {.kind = KIND_SECTOR,
         .outer = outer,
         .inner = inner,
         .mid_angle = M_PI,
         .width = M_PI / 8,
         .material = 1},
    };
    const section_outline o = {.count = 2, .items = items, .size = outer};
    const mesh_options options = {.kind = MESH_MAPPED, .order = 2, .size = size * outer};
    return section_mesh_make(&o, &options, out);
}

// 20 mm in layers that double from `first` at both ends [mm]
static int layers_from(double first, double *z)
{
    double height[MOST_LAYERS], total = 0;
    int half = 0;
    while (total < 10 && half < MOST_LAYERS / 2) {
        height[half] = ldexp(first, half);
        total += height[half++];
    }
    for (int i = 0; i < 2 * half; i++) {
        z[i + 1] = z[i] + height[i < half ? i : 2 * half - 1 - i] * 10e-3 / total;
    }
    return 2 * half;
}

// size over the radius; first layer [mm]
static status calculix(double size, double first, bool reduced, timed *out)
{
    status st = OK;
    static const double centre = -2.1232764e-3; // the stiffness centre, Eq. 18 to 20 of the paper
    const vec6 wrench = {{0, 0, 1, 0, -centre, 0}};
    double z[MOST_LAYERS + 1] = {0};
    vec6 motion;
    mesh plane = {0};
    body b = {0};
    body_spec spec = {.plane = &plane, .materials = both, .order = 2, .layer = z};
    TRY(fig4_plane(size, &plane));
    spec.nlayer = layers_from(first, z);
    TRY(body_make(&spec, &b));
    const calculix_ask ask = {.body = &b, .reduced = reduced, .nload = 1, .wrench = &wrench};
    *out = (timed){.cpu = INFINITY, .said = NAN, .dofs = 3 * (long)body_node_count(&b)};
    for (int i = 0; i < RUNS && (i == 0 || out->cpu < LONG_RUN); i++) {
        double cpu = 0;
        TRY(calculix_tip(&ask, &motion, &cpu));
        out->cpu = fmin(out->cpu, cpu);
    }
    out->error = fabs((motion.a[2] - centre * motion.a[4]) / REFERENCE - 1);

done:
    body_free(&b);
    mesh_free(&plane);
    return st;
}

static void table_of_calculix(void)
{
    static const double meshes[][2] = {
        {0.4, 0.4}, {0.4, 0.1}, {0.25, 0.1}, {0.2, 0.05}, {0.1, 0.02}};
    char path[MOST_PATH];
    if (!calculix_find(path, sizeof path)) {
        printf("CalculiX is not installed\n");
        return;
    }
    for (int reduced = 0; reduced < 2; reduced++) {
        const char *who = reduced ? "CalculiX C3D20R" : "CalculiX C3D20";
        for (size_t i = 0; i < sizeof meshes / sizeof *meshes; i++) {
            timed t;
            char what[40];
            (void)snprintf(what, sizeof what, "%g mm, from %g mm", 4 * meshes[i][0], meshes[i][1]);
            if (calculix(meshes[i][0], meshes[i][1], reduced, &t) == OK) {
                tell(who, what, &t);
            } else {
                printf("%-22s %-22s %s\n", who, what, status_message());
                status_clear();
            }
        }
    }
}

int main(int argc, char **argv)
{
    static const char *const tolerances[] = {"1e-3", "1e-4", "3e-5", "1e-5"};
    char program[MOST_PATH];
    const char *slash = strrchr(argv[0], '/');
    int fails = 0;
    (void)argc;
    (void)setvbuf(stdout, NULL, _IOLBF, 0);
    (void)snprintf(program, sizeof program, "%.*sstiffaxis", slash ? (int)(slash - argv[0]) + 1 : 0,
                   argv[0]);
    bench_axes("CPU time of the process [ms]", "relative error of the compliance");
    printf("Fig. 4 compliance against %.8g mm/N; CPU of whole processes, best of %d\n",
           1e3 * REFERENCE, RUNS);
    printf("%-22s %-22s %9s %9s %9s %9s\n", "way", "", "unknowns", "CPU s", "error", "said");
    table_of(program, "auto", 4, tolerances);
    table_of(program, "doubling", 3, tolerances);
    table_of(program, "direct", 2, tolerances);
    table_of(program, "iterative", 2, tolerances);
    table_of_calculix();
    for (int i = 0; i < WANTED; i++) {
        char label[96];
        (void)snprintf(label, sizeof label, "Fig. 4 compliance, error below %g, whole process",
                       wanted[i].within);
        fails += bench_target(label, wanted[i].cpu, wanted[i].limit, "s");
    }
    return fails != 0;
}
