// tests/unit/reports/test_shared_store.c
// A result whose levels ranks share out becomes the file that one process writes. Also run under
// mpirun by tests/cli/mpirun.sh.
#include "base/door.h"
#include "base/memory.h"
#include "fem/petsc_door.h"
#include "tests/test.h"
#include "tests/unit/reports/files.h"
#include "tests/unit/reports/synthetic.h"

typedef struct ranks {
    int rank, size;
} ranks;

// starts MPI, as whoever solves on several ranks does
static ranks start(void)
{
    door_function found = NULL;
    petsc_door_getter get = NULL;
    ranks r = {0, 1};
    CHECK_OK(door_open("petsc", PETSC_DOOR_SYMBOL, &found));
    memcpy(&get, &found, sizeof get);
    CHECK_OK(get()->start(&r.rank, &r.size));
    return r;
}

// rows [first, last) of the array stay
static void cut(double **rows, int first, int last, int nnode, int width)
{
    double *own = NULL;
    const size_t row = (size_t)nnode * (size_t)width;
    CHECK_OK(TAKE(own, (size_t)(last - first) * row));
    memcpy(own, *rows + (size_t)first * row, (size_t)(last - first) * row * sizeof *own);
    free(*rows);
    *rows = own;
}

// layers go to ranks in turn; with more ranks than layers the last ones have none
static void keep_share(ranks k, run_result *r)
{
    segment_body *b = &r->segment.body;
    const int per_rank = (b->nlayer + k.size - 1) / k.size;
    const int first = k.rank * per_rank, last = first + per_rank;
    b->shared = true;
    b->first = (first < b->nlayer ? first : b->nlayer) * b->order;
    b->last = last < b->nlayer ? last * b->order : b->nlevel;
    if (first >= b->nlayer) {
        b->first = b->last = b->nlevel;
    }
    cut(&b->node, b->first, b->last, b->plane.nnode, 3);
    for (int i = 0; i < r->segment.nload; i++) {
        cut(&r->segment.load[i].displacement, b->first, b->last, b->plane.nnode, 3);
        cut(&r->segment.load[i].stress, b->first, b->last, b->apart.nnode, 6);
    }
}

static void check_same_reals(const store *a, const store *b, const char *name)
{
    int rank[2] = {0};
    size_t shape[2][4] = {{0}}, n = 1;
    double *data[2] = {NULL, NULL};
    CHECK_OK(store_read_real(a, name, &rank[0], shape[0], &data[0]));
    CHECK_OK(store_read_real(b, name, &rank[1], shape[1], &data[1]));
    CHECK(rank[0] == rank[1] && memcmp(shape[0], shape[1], sizeof shape[0]) == 0);
    for (int i = 0; i < rank[0]; i++) {
        n *= shape[0][i];
    }
    const bool same = data[0] && data[1] && memcmp(data[0], data[1], n * sizeof *data[0]) == 0;
    CHECK(same && n > 0);
    if (!same) {
        printf("%s differs\n", name);
    }
    free(data[0]);
    free(data[1]);
}

static void check_same_integers(const store *a, const store *b, const char *name)
{
    int rank[2] = {0}, *data[2] = {NULL, NULL};
    size_t shape[2][4] = {{0}};
    CHECK_OK(store_read_integer(a, name, &rank[0], shape[0], &data[0]));
    CHECK_OK(store_read_integer(b, name, &rank[1], shape[1], &data[1]));
    CHECK(rank[0] == 1 && rank[1] == 1 && shape[0][0] == shape[1][0] && shape[0][0] > 0);
    CHECK(data[0] && data[1] && memcmp(data[0], data[1], shape[0][0] * sizeof(int)) == 0);
    free(data[0]);
    free(data[1]);
}

static void check_same_files(const char *shared, const char *alone)
{
    static const char *const reals[] = {"fem/node_m",
                                        "fem/level_m",
                                        "fem/load/0/displacement_m",
                                        "fem/load/1/stress_Pa",
                                        "fem/K",
                                        "VTKHDF/Points",
                                        "VTKHDF/PointData/displacement_m",
                                        "VTKHDF/PointData/stress_Pa",
                                        "VTKHDF/PointData/von_mises_Pa",
                                        "rod/tension_N",
                                        "section/K"};
    static const char *const integers[] = {
        "VTKHDF/NumberOfPoints", "VTKHDF/NumberOfCells",    "VTKHDF/NumberOfConnectivityIds",
        "VTKHDF/Offsets",        "VTKHDF/Connectivity",     "VTKHDF/Types",
        "VTKHDF/CellData/part",  "VTKHDF/CellData/material"};
    store *a = NULL, *b = NULL;
    CHECK_OK(store_open(shared, &a));
    CHECK_OK(store_open(alone, &b));
    for (size_t i = 0; a && b && i < sizeof reals / sizeof *reals; i++) {
        check_same_reals(a, b, reals[i]);
    }
    for (size_t i = 0; a && b && i < sizeof integers / sizeof *integers; i++) {
        check_same_integers(a, b, integers[i]);
    }
    store_close(a);
    store_close(b);
}

int main(void)
{
    const ranks k = start();
    char dir[64] = "", shared[128] = "", alone[128] = "";
    run_result r = {0}, back = {0};
    CHECK_OK(synthetic_make(2, 1, -0.5, &r));
    if (k.rank == 0) {
        scratch_make(dir);
        (void)snprintf(shared, sizeof shared, "%s/result.hdf", dir);
        (void)snprintf(alone, sizeof alone, "%s/kern.csv", dir);
        CHECK_OK(result_store_write(&r, alone));
    }
    keep_share(k, &r);
    CHECK_OK(result_store_write(&r, k.rank == 0 ? shared : NULL));
    if (k.rank == 0) {
        check_same_files(shared, alone);
        CHECK_OK(result_store_read(shared, &back)); // nothing of it is shared any more
        CHECK(!back.segment.body.shared && back.segment.body.last == back.segment.body.nlevel);
        run_result_free(&back);
    }
    // without a path nobody writes
    CHECK_OK(result_store_write(&r, NULL));
    if (k.rank == 0) {
        scratch_free(dir);
        printf("%d ranks\n", k.size);
    }
    synthetic_free(&r);
    return test_failures != 0;
}
