// tests/unit/io/test_store.c
#include "io/store.h"

#include "base/door.h"
#include "io/hdf5_door.h"
#include "tests/unit/io/grid_mesh.h"
#include "tests/unit/io/scratch.h"

#include <signal.h>
#include <stdint.h>
#include <sys/resource.h>
#include <sys/wait.h>

static void write_some(store *s)
{
    const double numbers[6] = {1, -2.5, 1e-300, NAN, 5, 6};
    const int indices[3] = {0, 7, -1};
    CHECK_OK(store_real(s, "section/K", 2, (const size_t[]){2, 3}, numbers, "N"));
    CHECK_OK(store_real(s, "section/EA_N", 0, NULL, &numbers[1], "N"));
    CHECK_OK(store_integer(s, "fem/mesh/conn", 1, (const size_t[]){3}, indices));
    CHECK_OK(store_real(s, "fem/none", 2, (const size_t[]){0, 3}, numbers, "m"));
    CHECK_OK(store_text(s, "case/text", "format: 1\n\xc3\xa9", 12));
    CHECK_OK(store_text(s, "case/empty", "", 0));
}

// the plane mesh's nodes on n levels up to 1
static double *levels_of(const mesh *plane, int n)
{
    double *xyz = calloc((size_t)n * (size_t)plane->nnode, 3 * sizeof *xyz);
    for (int i = 0; xyz && i < n * plane->nnode; i++) {
        memcpy(xyz + 3 * i, plane->xyz + 3 * (i % plane->nnode), sizeof(double[2]));
        xyz[3 * i + 2] = (double)(i / plane->nnode) / (n - 1);
    }
    return xyz;
}

static void make_file(const char *path)
{
    store *s = NULL;
    mesh plane = grid_mesh(2, 2);
    double *xyz = levels_of(&plane, 3), *u = calloc((size_t)plane.nnode * 3, 3 * sizeof *u);
    const store_field field = {"displacement_m", 3, u};
    const store_layers layers = {.order = 2, .nlayer = 1, .last = 3, .xyz = xyz};
    const store_grid_piece pieces[2] = {{&plane, NULL, NULL, 1, &field},
                                        {&plane, &layers, u, 1, &field}};
    CHECK_OK(store_create(path, &s));
    write_some(s);
    CHECK_OK(store_grid(s, 2, pieces));
    CHECK_OK(store_commit(s));
    free(u);
    free(xyz);
    mesh_free(&plane);
}

static void what_is_written_reads_back(const char *path)
{
    store *s = NULL;
    int rank = 0, *indices = NULL;
    size_t shape[4] = {0}, length = 0;
    double *numbers = NULL;
    char *text = NULL;
    CHECK_OK(store_open(path, &s));

    CHECK_OK(store_read_real(s, "section/K", &rank, shape, &numbers));
    CHECK(rank == 2 && shape[0] == 2 && shape[1] == 3 && shape[2] == 0);
    CHECK(numbers && numbers[1] == -2.5 && numbers[2] == 1e-300 && isnan(numbers[3]));
    free(numbers);
    CHECK_OK(store_read_real(s, "section/EA_N", &rank, shape, &numbers));
    CHECK(rank == 0 && numbers && numbers[0] == -2.5);
    free(numbers);
    CHECK_OK(store_read_integer(s, "fem/mesh/conn", &rank, shape, &indices));
    CHECK(rank == 1 && shape[0] == 3 && indices && indices[1] == 7 && indices[2] == -1);
    free(indices);
    CHECK_OK(store_read_real(s, "fem/none", &rank, shape, &numbers));
    CHECK(rank == 2 && shape[0] == 0 && shape[1] == 3);
    free(numbers);
    CHECK_OK(store_read_text(s, "case/text", &text, &length));
    CHECK(length == 12 && text && strcmp(text, "format: 1\n\xc3\xa9") == 0);
    free(text);
    CHECK_OK(store_read_text(s, "case/empty", &text, &length));
    CHECK(length == 0 && text && text[0] == '\0');
    free(text);
    store_close(s);
}

static void absent_or_other_kinds_are_errors(const char *path)
{
    store *s = NULL;
    int rank = 0;
    size_t shape[4] = {0};
    double *numbers = NULL;
    CHECK_OK(store_open(path, &s));
    CHECK(store_has(s, "section/K") && store_has(s, "section"));
    const char *absent[] = {"section/none", "none/none", "", "/", "section/K/x"};
    for (size_t i = 0; i < sizeof absent / sizeof *absent; i++) {
        CHECK(!store_has(s, absent[i]));
        CHECK(store_read_real(s, absent[i], &rank, shape, &numbers) == ERR_FILE);
        CHECK(numbers == NULL);
        status_clear();
    }
    const char *other[] = {"section", "case/text", "fem/mesh/conn"};
    for (size_t i = 0; i < sizeof other / sizeof *other; i++) {
        CHECK(store_read_real(s, other[i], &rank, shape, &numbers) == ERR_FILE);
        CHECK(strstr(status_message(), path) != NULL);
        status_clear();
    }
    store_close(s);
}

// six times the volume of a tetrahedron
static double six_volumes(const double *a, const double *b, const double *c, const double *d)
{
    double u[3], v[3], w[3];
    for (int k = 0; k < 3; k++) {
        u[k] = b[k] - a[k];
        v[k] = c[k] - a[k];
        w[k] = d[k] - a[k];
    }
    return (u[1] * v[2] - u[2] * v[1]) * w[0] + (u[2] * v[0] - u[0] * v[2]) * w[1] +
           (u[0] * v[1] - u[1] * v[0]) * w[2];
}

// area or volume by VTK's conventions of corner order, negative where an element is inside out.
// VTK's wedge has the normal of its corners 0, 1, 2 away from 3, 4, 5
static double vtk_size(int type, const double *const *x)
{
    static const int wedge[3][4] = {{0, 2, 1, 3}, {1, 2, 5, 3}, {1, 5, 4, 3}};
    static const int hex[6][4] = {{0, 1, 3, 7}, {0, 1, 7, 5}, {0, 5, 7, 4},
                                  {1, 2, 3, 7}, {1, 2, 7, 6}, {1, 6, 7, 5}};
    const double up[3] = {x[0][0], x[0][1], x[0][2] + 1};
    double sum = 0;
    if (type == 5) {
        return six_volumes(x[0], x[1], x[2], up) / 2;
    }
    if (type == 9) {
        return (six_volumes(x[0], x[1], x[2], up) + six_volumes(x[0], x[2], x[3], up)) / 2;
    }
    const int n = type == 13 ? 3 : 6;
    for (int i = 0; i < n; i++) {
        const int *t = type == 13 ? wedge[i] : hex[i];
        sum += six_volumes(x[t[0]], x[t[1]], x[t[2]], x[t[3]]) / 6;
    }
    return sum;
}

typedef struct grid_read {
    int *npoint, *ncell, *nindex, *offset, *conn, *type, *material, *part;
    double *xyz;
    size_t n[8];
} grid_read;

static void read_grid(const store *s, grid_read *g)
{
    const struct {
        const char *name;
        int **to;
    } arrays[8] = {
        {"VTKHDF/NumberOfPoints", &g->npoint},
        {"VTKHDF/NumberOfCells", &g->ncell},
        {"VTKHDF/NumberOfConnectivityIds", &g->nindex},
        {"VTKHDF/Offsets", &g->offset},
        {"VTKHDF/Connectivity", &g->conn},
        {"VTKHDF/Types", &g->type},
        {"VTKHDF/CellData/material", &g->material},
        {"VTKHDF/CellData/part", &g->part},
    };
    int rank = 0;
    size_t shape[4];
    for (int i = 0; i < 8; i++) {
        CHECK_OK(store_read_integer(s, arrays[i].name, &rank, shape, arrays[i].to));
        CHECK(rank == 1);
        g->n[i] = shape[0];
    }
    CHECK_OK(store_read_real(s, "VTKHDF/Points", &rank, shape, &g->xyz));
    CHECK(rank == 2 && shape[1] == 3);
}

static void grid_read_free(grid_read *g)
{
    int *arrays[] = {g->npoint, g->ncell, g->nindex,   g->offset,
                     g->conn,   g->type,  g->material, g->part};
    for (size_t i = 0; i < sizeof arrays / sizeof *arrays; i++) {
        free(arrays[i]);
    }
    free(g->xyz);
}

// the cells of one piece: all of positive size, and together as large as the piece
static double piece_size(const grid_read *g, int piece)
{
    int cell = 0, offset = piece, index = 0, point = 0;
    double sum = 0;
    for (int i = 0; i < piece; i++) {
        cell += g->ncell[i];
        offset += g->ncell[i];
        index += g->nindex[i];
        point += g->npoint[i];
    }
    CHECK(g->offset[offset] == 0 && g->offset[offset + g->ncell[piece]] == g->nindex[piece]);
    for (int i = 0; i < g->ncell[piece]; i++) {
        const double *corner[8] = {0};
        const int first = g->offset[offset + i], n = g->offset[offset + i + 1] - first;
        CHECK(n >= 3 && n <= 8 && g->part[cell + i] == piece);
        for (int k = 0; k < n && k < 8; k++) {
            const int node = g->conn[index + first + k];
            CHECK(node >= 0 && node < g->npoint[piece]);
            corner[k] = &g->xyz[3 * (size_t)(point + node)];
        }
        const double size = vtk_size(g->type[cell + i], corner);
        CHECK(size > 0);
        sum += size;
    }
    return sum;
}

// layers of their own order, the quad's upper one a hole
static void high_order_cells_are_cut_into_linear_ones(const scratch *dir, int order, int along)
{
    const scratch_path path = scratch_file(dir, "grid.hdf");
    const int nlevel = 2 * along + 1, matter[6] = {0, 1, 1, -1, 1, 0};
    store *s = NULL;
    grid_read g = {0};
    mesh plane = grid_mesh(2, order);
    const int nsolid = nlevel * plane.nnode;
    double *u = calloc((size_t)nsolid, 3 * sizeof *u), *xyz = levels_of(&plane, nlevel);
    for (int i = 0; i < nsolid; i++) {
        u[3 * i + 2] = 0.5 * xyz[3 * i + 2]; // half as high again
    }
    const store_field field = {"displacement_m", 3, u}, none = {"displacement_m", 3, NULL};
    const store_layers whole = {.order = along, .nlayer = 2, .last = nlevel, .xyz = xyz},
                       holed = {.order = along,
                                .nlayer = 2,
                                .matter = matter,
                                .last = nlevel,
                                .xyz = xyz};
    const store_grid_piece pieces[3] = {{&plane, NULL, NULL, 1, &none},
                                        {&plane, &whole, u, 1, &field},
                                        {&plane, &holed, NULL, 1, &field}};
    CHECK_OK(store_create(path.text, &s));
    CHECK_OK(store_grid(s, 3, pieces));
    CHECK_OK(store_commit(s));
    CHECK_OK(store_open(path.text, &s));
    read_grid(s, &g);

    const int p2 = order * order, high = 2 * along;
    CHECK(g.n[0] == 3 && g.npoint[0] == plane.nnode && g.npoint[1] == nsolid);
    CHECK(g.ncell[0] == 3 * p2 && g.ncell[1] == 3 * p2 * high);
    CHECK(g.ncell[2] == 3 * p2 * high - p2 * along);
    CHECK(g.nindex[0] == (4 + 2 * 3) * p2 && g.nindex[1] == (8 + 2 * 6) * p2 * high);
    CHECK(g.n[3] == (size_t)(g.ncell[0] + g.ncell[1] + g.ncell[2] + 3) && g.n[5] == g.n[3] - 3);
    CHECK(g.material[0] == 0 && g.material[p2] == 1 && g.material[3 * p2] == 0);
    CHECK(g.material[g.n[5] - 1] == 0);      // the last triangle of the upper layer, by its matter
    CHECK_NEAR(piece_size(&g, 0), 2, 1e-14); // area of the strip, exact but for rounding
    CHECK_NEAR(piece_size(&g, 1), 2 * 1.5, 1e-13);
    CHECK_NEAR(piece_size(&g, 2), 2 - 0.5, 1e-13);

    grid_read_free(&g);
    store_close(s);
    free(u);
    free(xyz);
    mesh_free(&plane);
}

static void pieces_with_other_fields_are_refused(const scratch *dir)
{
    store *s = NULL;
    mesh m = grid_mesh(2, 1);
    double *u = calloc((size_t)m.nnode, 3 * sizeof *u);
    const store_field one = {"displacement_m", 3, u}, other = {"stress_Pa", 1, u};
    const store_grid_piece pieces[2] = {{&m, NULL, NULL, 1, &one}, {&m, NULL, NULL, 1, &other}};
    CHECK_OK(store_create(scratch_file(dir, "fields.hdf").text, &s));
    CHECK(store_grid(s, 2, pieces) == ERR_BUG);
    status_clear();
    store_abandon(s);
    CHECK(count_entries(dir->path, "fields") == 0);
    free(u);
    mesh_free(&m);
}

static void the_same_numbers_give_the_same_bytes(const scratch *dir)
{
    size_t n[2] = {0};
    const scratch_path path[2] = {scratch_file(dir, "one.hdf"), scratch_file(dir, "two.hdf")};
    char *bytes[2];
    for (int i = 0; i < 2; i++) {
        make_file(path[i].text);
        bytes[i] = read_whole(path[i].text, &n[i]);
    }
    CHECK(bytes[0] && bytes[1] && n[0] == n[1] && memcmp(bytes[0], bytes[1], n[0]) == 0);
    free(bytes[0]);
    free(bytes[1]);
}

static void the_file_appears_at_the_end_only(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "late.hdf");
    store *s = NULL;
    CHECK_OK(store_create(path.text, &s));
    write_some(s);
    CHECK(!exists(path.text));
    CHECK_OK(store_commit(s));
    CHECK(exists(path.text) && count_entries(dir->path, "late") == 1);

    CHECK_OK(store_create(path.text, &s));
    store_abandon(s);
    store_abandon(NULL);
    CHECK(count_entries(dir->path, "late") == 1);
    CHECK_OK(store_open(path.text, &s)); // the first one still stands
    store_close(s);
    store_close(NULL);

    CHECK(store_create("/nowhere/at/all.hdf", &s) == ERR_RESOURCE);
    status_clear();
}

// runs in a child: the disk is full after `room` bytes
static int write_on_a_full_disk(const char *path, rlim_t room)
{
    static double numbers[100000];
    const struct rlimit limit = {room, room};
    store *s = NULL;
    (void)signal(SIGXFSZ, SIG_IGN);
    if (setrlimit(RLIMIT_FSIZE, &limit) != 0 || store_create(path, &s) != OK) {
        return 100;
    }
    status st = store_real(s, "big", 1, (const size_t[]){100000}, numbers, "m");
    if (st == OK) {
        st = store_commit(s);
    } else {
        store_abandon(s);
    }
    return st;
}

static void a_full_disk_or_a_kill_leaves_nothing(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "full.hdf");
    int how = 0;
    // the file has 800 kB and a little; HDF5's own handlers at exit take part
    for (rlim_t room = 0; room < 800000; room += room < 10000 ? 800 : 79000) {
        const pid_t writer = fork();
        if (writer == 0) {
            exit(write_on_a_full_disk(path.text, room));
        }
        CHECK(waitpid(writer, &how, 0) == writer && WIFEXITED(how));
        CHECK(WEXITSTATUS(how) == ERR_RESOURCE);
        CHECK(count_entries(dir->path, "full") == 0);
    }

    const pid_t child = fork();
    if (child == 0) {
        store *s = NULL;
        (void)store_create(path.text, &s);
        write_some(s);
        (void)raise(SIGKILL);
    }
    CHECK(waitpid(child, &how, 0) == child && WIFSIGNALED(how));
    CHECK(!exists(path.text));
}

static void refuse(const char *path, status code, const char *words)
{
    store *s = NULL;
    CHECK(store_open(path, &s) == code);
    CHECK(s == NULL);
    CHECK(strstr(status_message(), words) && !strchr(status_message(), '\n'));
    if (!strstr(status_message(), words)) {
        printf("%s\n", status_message());
    }
    status_clear();
}

static void what_is_no_result_is_refused(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "wrong.hdf"), pipe = scratch_file(dir, "pipe");
    refuse(path.text, ERR_INPUT, "cannot open");
    refuse(dir->path, ERR_FILE, "not a regular file");
    CHECK(mkfifo(pipe.text, 0600) == 0);
    refuse(pipe.text, ERR_FILE, "not a regular file");
    refuse("/dev/zero", ERR_FILE, "not a regular file");
    write_whole(path.text, "", 0);
    refuse(path.text, ERR_FILE, "not an HDF5 file");
    write_whole(path.text, "format: 1\ntitle: no result\n", 27);
    refuse(path.text, ERR_FILE, "not an HDF5 file");
    write_whole(path.text, "\x89HDF\r\n\x1a\n", 8);
    refuse(path.text, ERR_FILE, "HDF5 cannot open");
}

// an HDF5 file with one root attribute; none where name is NULL
static void make_foreign(const char *path, const char *name, const char *text)
{
    door_function found = NULL;
    hdf5_file *file = NULL;
    void *image = NULL;
    size_t bytes = 0;
    CHECK_OK(door_open("hdf5", HDF5_DOOR_SYMBOL, &found));
    const hdf5_door *door = ((hdf5_door_table_function)found)();
    (void)unlink(path);
    CHECK_OK(door->create(path, &file));
    if (name) {
        const hdf5_array array = hdf5_text_of(strlen(text));
        CHECK_OK(door->put(file, "/", name, &array, text));
    }
    CHECK_OK(door->image(file, &image, &bytes));
    door->close(file);
    write_whole(path, image, bytes);
    free(image);
}

static void files_of_other_programs_are_told_so(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "foreign.hdf");
    make_foreign(path.text, NULL, NULL);
    refuse(path.text, ERR_FILE, "foreign.hdf: not a stiffaxis result");
    make_foreign(path.text, "schema", "another/result/1");
    refuse(path.text, ERR_FILE, "foreign.hdf: not a stiffaxis result");
    make_foreign(path.text, "schema", "stiffaxis/result/4");
    refuse(path.text, ERR_FILE, "its schema is 'stiffaxis/result/4'");
}

// every array of make_file; OK or ERR_FILE is all there may be
static int read_everything(const char *path)
{
    static const char *const names[] = {
        "section/K",           "section/EA_N",   "fem/mesh/conn",        "fem/none",    "case/text",
        "VTKHDF/Connectivity", "VTKHDF/Offsets", "VTKHDF/NumberOfCells", "VTKHDF/Types"};
    store *s = NULL;
    int rank = 0, gave_up = 0;
    size_t shape[4], length = 0;
    status st = store_open(path, &s);
    CHECK(st == OK || st == ERR_FILE);
    gave_up = strstr(status_message(), "gave up") != NULL;
    status_clear();
    for (size_t i = 0; s && !gave_up && i < sizeof names / sizeof *names; i++) {
        void *data = NULL;
        st = i < 4 && i != 2 ? store_read_real(s, names[i], &rank, shape, (double **)&data)
             : i == 4        ? store_read_text(s, names[i], (char **)&data, &length)
                             : store_read_integer(s, names[i], &rank, shape, (int **)&data);
        CHECK(st == OK || st == ERR_FILE);
        CHECK((st == OK) == (data != NULL));
        free(data);
        gave_up = strstr(status_message(), "gave up") != NULL;
        status_clear();
    }
    store_close(s);
    return gave_up;
}

// 64-bit linear congruence, so that every machine damages the same bits
static size_t next_random(uint64_t *state)
{
    *state = *state * 6364136223846793005u + 1442695040888963407u;
    return (size_t)(*state >> 33);
}

static void damaged_files_never_bring_us_down(const scratch *dir)
{
    enum { TRIALS = 300 };
    const scratch_path good = scratch_file(dir, "good.hdf"), bad = scratch_file(dir, "bad.hdf");
    uint64_t state = 2;
    size_t size = 0;
    int gave_up = 0;
    make_file(good.text);
    char *bytes = read_whole(good.text, &size);
    for (int i = 0; bytes && i < TRIALS; i++) {
        const size_t at = next_random(&state) % size;
        const char kept = bytes[at];
        // every third is cut off, the others have one bit or a whole byte wrong
        if (i % 3 == 0) {
            write_whole(bad.text, bytes, at);
        } else {
            bytes[at] = (char)(i % 3 == 1 ? bytes[at] ^ (1 << next_random(&state) % 8) : 0xff);
            write_whole(bad.text, bytes, size);
            bytes[at] = kept;
        }
        gave_up += read_everything(bad.text);
    }
    printf("%d damaged files of %zu bytes: HDF5's library gave up on %d of them\n", TRIALS, size,
           gave_up);
    free(bytes);
}

int main(void)
{
    const scratch dir = scratch_make();
    const scratch_path path = scratch_file(&dir, "result.hdf");
    CHECK(!door_is_open("hdf5"));
    make_file(path.text);
    what_is_written_reads_back(path.text);
    absent_or_other_kinds_are_errors(path.text);
    for (int order = 1; order <= ELEMENT_MAX_ORDER; order++) {
        high_order_cells_are_cut_into_linear_ones(&dir, order, 1 + order % 3);
    }
    pieces_with_other_fields_are_refused(&dir);
    the_same_numbers_give_the_same_bytes(&dir);
    the_file_appears_at_the_end_only(&dir);
    a_full_disk_or_a_kill_leaves_nothing(&dir);
    what_is_no_result_is_refused(&dir);
    files_of_other_programs_are_told_so(&dir);
    damaged_files_never_bring_us_down(&dir);
    scratch_remove(&dir);
    return test_failures != 0;
}
