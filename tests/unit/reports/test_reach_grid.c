// tests/unit/reports/test_reach_grid.c
// What ParaView sees of a reach study: the wall with the map's state at its corners, the bodies as
// lines with their clearance.
#include "base/memory.h"
#include "reports/result.h"
#include "tests/reach_results.h"
#include "tests/unit/io/scratch.h"

#include <string.h>

enum { VTK_LINE = 3, VTK_TRIANGLE = 5 };

typedef struct numbers {
    int rank, *integer;
    size_t shape[4];
    double *real;
} numbers;

static numbers integers_of(const store *s, const char *name)
{
    numbers n = {0};
    CHECK_OK(store_read_integer(s, name, &n.rank, n.shape, &n.integer));
    return n;
}

static numbers reals_of(const store *s, const char *name)
{
    numbers n = {0};
    CHECK_OK(store_read_real(s, name, &n.rank, n.shape, &n.real));
    return n;
}

static void drop(numbers *n)
{
    free(n->integer);
    free(n->real);
}

static int nearest_sample(const reach_result *r, const double *p)
{
    int best = -1;
    double least = INFINITY;
    for (int k = 0; k < r->nmap; k++) {
        const double *q = r->map_point[k];
        const double d = hypot(hypot(p[0] - q[0], p[1] - q[1]), p[2] - q[2]);
        if (d < least) {
            least = d;
            best = k;
        }
    }
    return best;
}

static int points_of(const reach_result *r, int scope)
{
    int n = 0;
    for (int k = 0; k < r->ntarget; k++) {
        n += r->scope[scope].answer[k].npoint;
    }
    return n;
}

static void check_cells(const store *s, const reach_result *r)
{
    numbers points = integers_of(s, "VTKHDF/NumberOfPoints");
    numbers cells = integers_of(s, "VTKHDF/NumberOfCells");
    numbers types = integers_of(s, "VTKHDF/Types"), conn = integers_of(s, "VTKHDF/Connectivity");
    CHECK(points.shape[0] == 1 + EGG_SCOPES && points.integer[0] == r->nvertex);
    CHECK(cells.integer[0] == r->ntriangle);
    CHECK(memcmp(conn.integer, r->triangle, (size_t)r->ntriangle * sizeof *r->triangle) == 0);
    for (int i = 0; i < r->nscope; i++) {
        CHECK(points.integer[1 + i] == points_of(r, i));
        // every body is one line
        CHECK(cells.integer[1 + i] == points_of(r, i) / EGG_BODY * (EGG_BODY - 1));
    }
    for (size_t i = 0; i < types.shape[0]; i++) {
        CHECK(types.integer[i] == ((int)i < r->ntriangle ? VTK_TRIANGLE : VTK_LINE));
    }
    drop(&points);
    drop(&cells);
    drop(&types);
    drop(&conn);
}

static void check_fields(const store *s, const reach_result *r)
{
    numbers state = reals_of(s, "VTKHDF/PointData/scope_2_state");
    numbers room = reals_of(s, "VTKHDF/PointData/clearance_m");
    numbers target = reals_of(s, "VTKHDF/PointData/target_count");
    numbers place = reals_of(s, "VTKHDF/Points");
    const size_t n = (size_t)r->nvertex;
    int count[3] = {0};
    for (size_t k = 0; k < n; k++) {
        const int sample = nearest_sample(r, r->vertex[k]);
        CHECK(state.real[k] == r->scope[1].state[sample]);
        CHECK(isnan(room.real[k]) && isnan(target.real[k]));
        count[r->scope[1].state[sample]]++;
    }
    CHECK(count[MAP_REACHED] > 0 && count[MAP_NOT_REACHED] > 0);
    // the first scope's first body
    const reach_answer *a = &r->scope[0].answer[0];
    for (int k = 0; k < 3 * a->npoint; k++) {
        CHECK(place.real[3 * n + (size_t)k] == a->point[k / 3][k % 3]);
    }
    CHECK(memcmp(room.real + n, a->room, (size_t)a->npoint * sizeof *a->room) == 0);
    CHECK(target.real[n] == 1 && isnan(state.real[n]));
    drop(&state);
    drop(&room);
    drop(&target);
    drop(&place);
}

static void the_wall_and_the_bodies_are_in_the_grid(void)
{
    run_result r = {.title = "egg"};
    store *s = NULL;
    char *name = NULL;
    size_t length = 0;
    const scratch dir = scratch_make();
    const scratch_path path = scratch_file(&dir, "result.hdf");
    CHECK_OK(memory_take((void **)&r.case_text, 1, 8));
    CHECK_OK(reach_results_make(false, true, false, &r.reach));
    CHECK_OK(result_store_write(&r, path.text));
    CHECK_OK(store_open(path.text, &s));
    if (s) {
        check_cells(s, &r.reach);
        check_fields(s, &r.reach);
        CHECK_OK(store_read_text(s, "part/0", &name, &length));
        CHECK(name && strcmp(name, "synthetic tissue") == 0);
    }
    free(name);
    store_close(s);
    run_result_free(&r);
    scratch_remove(&dir);
}

int main(void)
{
    the_wall_and_the_bodies_are_in_the_grid();
    return test_failures != 0;
}
