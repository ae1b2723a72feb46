// app/calculix_files.c
#include "app/calculix_files.h"

#include "base/memory.h"

#include <math.h>
#include <string.h>

// Corners first, then the middles of the edges at the bottom, at the top and between the two, as
// CalculiX has them, in the lattice order of base/element.h: node of the plane face + 9 (6) * k.
static const int hex_nodes[20] = {0, 2, 8,  6,  18, 20, 26, 24, 1,  5,
                                  7, 3, 19, 23, 25, 21, 9,  11, 17, 15};
static const int prism_nodes[15] = {0, 2, 5, 12, 14, 17, 1, 4, 3, 13, 16, 15, 6, 8, 11};

// of a quadrilateral's nodes: the value in its middle by the eight others
enum { QUAD_MIDDLE = 4 };
static const double serendipity[9] = {-0.25, 0.5, -0.25, 0.5, 0, 0.5, -0.25, 0.5, -0.25};

enum { PER_LINE = 10, MOST_WORDS = 128 };

static int node_number(const body *b, int plane_node, int level)
{
    return 1 + plane_node + b->plane->nnode * level;
}

// the numbers of one element's nodes
static int element_nodes(const body *b, const mesh_block *block, int e, int layer, int *number)
{
    const bool quad = block->shape == SHAPE_QUAD;
    const int *lattice = quad ? hex_nodes : prism_nodes, n = quad ? 20 : 15;
    const int *conn = block->conn + (size_t)e * (size_t)block->per_elem;
    for (int i = 0; i < n; i++) {
        const int k = lattice[i] / block->per_elem, a = lattice[i] % block->per_elem;
        number[i] = node_number(b, conn[a], 2 * layer + k);
    }
    return n;
}

// numbers have at most 20 characters: CalculiX reads no more, and cuts an exponent off
static void write_nodes(const body *b, const bool *used, FILE *file)
{
    fprintf(file, "*NODE, NSET=ALL\n");
    for (int level = 0; level < b->nlevel; level++) {
        for (int i = 0; i < b->plane->nnode; i++) {
            const int number = node_number(b, i, level);
            double x[3];
            if (used[number]) {
                body_node(b, i, level, x);
                fprintf(file, "%d, %.12g, %.12g, %.12g\n", number, 1e3 * x[0], 1e3 * x[1],
                        1e3 * x[2]);
            }
        }
    }
}

static void write_list(const int *number, int n, FILE *file)
{
    for (int i = 0; i < n; i++) {
        fprintf(file, "%d%s", number[i],
                i + 1 == n                     ? "\n"
                : i % PER_LINE == PER_LINE - 1 ? ",\n"
                                               : ", ");
    }
}

// the elements of one block and material, as one set where there are any; their nodes are marked
static void write_elements(const calculix_problem *p, int block, int material, int *count,
                           bool *used, FILE *file)
{
    const body *b = p->body;
    const mesh_block *of = &b->plane->block[block];
    const char *kind = of->shape != SHAPE_QUAD ? "C3D15" : p->reduced ? "C3D20R" : "C3D20";
    bool begun = false;
    for (int layer = 0; layer < b->nlayer; layer++) {
        for (int e = 0; e < of->nelem; e++) {
            int number[20];
            if (body_material(b, block, e, layer) != material) {
                continue;
            }
            if (!begun) {
                fprintf(file, "*ELEMENT, TYPE=%s, ELSET=M%d\n", kind, material);
                begun = true;
            }
            const int n = element_nodes(b, of, e, layer, number);
            fprintf(file, "%d,\n", ++*count);
            write_list(number, n, file);
            for (int i = 0; i < n; i++) {
                used[number[i]] = true;
            }
        }
    }
    if (begun) {
        const struct material *m = &b->spec.materials[material];
        fprintf(file, "*MATERIAL, NAME=MAT%d_%d\n*ELASTIC\n%.12g, %.12g\n", material, block,
                1e-6 * m->E, m->nu);
        fprintf(file, "*SOLID SECTION, ELSET=M%d, MATERIAL=MAT%d_%d\n", material, material, block);
    }
}

static void write_set(const body *b, const char *name, int level, const bool *used, FILE *file)
{
    fprintf(file, "*NSET, NSET=%s\n", name);
    for (int i = 0; i < b->plane->nnode; i++) {
        const int number = node_number(b, i, level);
        if (used[number]) {
            fprintf(file, "%d,\n", number);
        }
    }
}

// --- loads

static void write_force(int number, const double *f, double unit, FILE *file)
{
    for (int d = 0; d < 3; d++) {
        if (f[d] != 0) {
            fprintf(file, "%d, %d, %.12g\n", number, d + 1, unit * f[d]);
        }
    }
}

// nodal forces of the wrench [nplane][3], those in the middle of quadrilaterals shared out
static void tip_forces(const calculix_problem *p, vec6 wrench, double *f)
{
    const mesh *plane = p->body->plane;
    const size_t n = 3 * (size_t)plane->nnode;
    memset(f, 0, n * sizeof *f);
    for (int j = 0; j < 6; j++) {
        for (size_t i = 0; i < n; i++) {
            f[i] += wrench.a[j] * p->fit->force[(size_t)j * n + i];
        }
    }
    for (int k = 0; k < plane->nblock; k++) {
        const mesh_block *block = &plane->block[k];
        for (int e = 0; block->shape == SHAPE_QUAD && e < block->nelem; e++) {
            const int *conn = block->conn + 9 * (size_t)e;
            double *middle = f + 3 * (size_t)conn[QUAD_MIDDLE];
            for (int a = 0; a < 9; a++) {
                for (int d = 0; a != QUAD_MIDDLE && d < 3; d++) {
                    f[3 * (size_t)conn[a] + (size_t)d] += serendipity[a] * middle[d];
                }
            }
            memset(middle, 0, 3 * sizeof *middle);
        }
    }
}

// numbers of the nodes that carry a rigid cap's motion and rotation
static int reference_node(const body *b)
{
    return 1 + b->plane->nnode * b->nlevel;
}

static void write_cap(const body *b, FILE *file)
{
    const int reference = reference_node(b);
    double x[3];
    body_origin(b, b->nlevel - 1, x);
    for (int i = 0; i < 2; i++) {
        fprintf(file, "*NODE\n%d, %.12g, %.12g, %.12g\n", reference + i, 1e3 * x[0], 1e3 * x[1],
                1e3 * x[2]);
    }
    fprintf(file, "*RIGID BODY, NSET=TIP, REF NODE=%d, ROT NODE=%d\n", reference, reference + 1);
}

static void write_step(const calculix_problem *p, vec6 wrench, double *f, FILE *file)
{
    const body *b = p->body;
    fprintf(file, "*STEP\n*STATIC, SOLVER=SPOOLES\n*CLOAD, OP=NEW\n");
    if (p->cap) {
        write_force(reference_node(b), wrench.a, 1, file);
        write_force(reference_node(b) + 1, wrench.a + 3, 1e3, file);
    } else {
        tip_forces(p, wrench, f);
        for (int i = 0; i < b->plane->nnode; i++) {
            write_force(node_number(b, i, b->nlevel - 1), f + 3 * (size_t)i, 1, file);
        }
    }
    fprintf(file, "*NODE PRINT, NSET=TIP\nU\n*END STEP\n");
}

static int material_count(const body *b)
{
    int most = -1;
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int e = 0; e < b->plane->block[k].nelem; e++) {
            for (int layer = 0; layer < b->nlayer; layer++) {
                const int material = body_material(b, k, e, layer);
                most = material > most ? material : most;
            }
        }
    }
    return most + 1;
}

status calculix_write(const calculix_problem *p, FILE *file)
{
    status st = OK;
    const body *b = p->body;
    const size_t nnode = body_node_count(b) + 1;
    bool *used = NULL;
    double *f = NULL;
    int count = 0;
    TRY(TAKE(used, nnode));
    TRY(TAKE(f, 3 * (size_t)b->plane->nnode));
    for (int k = 0; k < b->plane->nblock; k++) {
        for (int m = 0; m < material_count(b); m++) {
            write_elements(p, k, m, &count, used, file);
        }
    }
    write_nodes(b, used, file);
    write_set(b, "BASE", 0, used, file);
    write_set(b, "TIP", b->nlevel - 1, used, file);
    if (p->cap) {
        write_cap(b, file);
    }
    fprintf(file, "*BOUNDARY\nBASE, 1, 3\n");
    for (int i = 0; i < p->nload; i++) {
        write_step(p, p->wrench[i], f, file);
    }

done:
    free(f);
    free(used);
    return st;
}

// --- answers

static void fill_middles(const mesh *plane, double *u)
{
    for (int k = 0; k < plane->nblock; k++) {
        const mesh_block *block = &plane->block[k];
        for (int e = 0; block->shape == SHAPE_QUAD && e < block->nelem; e++) {
            const int *conn = block->conn + 9 * (size_t)e;
            for (int d = 0; d < 3; d++) {
                double sum = 0;
                for (int a = 0; a < 9; a++) {
                    sum += a == QUAD_MIDDLE ? 0 : serendipity[a] * u[3 * conn[a] + d];
                }
                u[3 * conn[QUAD_MIDDLE] + d] = sum;
            }
        }
    }
}

// the rows of one step
static int read_rows(const body *b, FILE *file, double *u)
{
    const int first = node_number(b, 0, b->nlevel - 1);
    char line[MOST_WORDS];
    int rows = 0, number = 0;
    double x[3];
    while (fgets(line, sizeof line, file)) {
        const int found = sscanf(line, "%d %lf %lf %lf", &number, &x[0], &x[1], &x[2]);
        if (found != 4) {
            if (rows > 0) {
                break;
            }
            continue;
        }
        const int i = number - first;
        if (i < 0 || i >= b->plane->nnode || !isfinite(x[0] + x[1] + x[2])) {
            return -1;
        }
        for (int d = 0; d < 3; d++) {
            u[3 * i + d] = 1e-3 * x[d];
        }
        rows++;
    }
    return rows;
}

// nodes of the tip that CalculiX has
static int tip_nodes(const mesh *plane)
{
    int n = plane->nnode;
    for (int k = 0; k < plane->nblock; k++) {
        n -= plane->block[k].shape == SHAPE_QUAD ? plane->block[k].nelem : 0;
    }
    return n;
}

status calculix_read(const calculix_problem *p, FILE *file, double *u)
{
    const mesh *plane = p->body->plane;
    char line[MOST_WORDS];
    for (int i = 0; i < p->nload; i++) {
        double *own = u + (size_t)i * 3 * (size_t)plane->nnode;
        bool found = false;
        while (!found && fgets(line, sizeof line, file)) {
            found = strstr(line, "displacements") != NULL;
        }
        if (!found || read_rows(p->body, file, own) != tip_nodes(plane)) {
            return status_fail(ERR_NUMERIC, "CalculiX printed no displacements for load %d of %d",
                               i + 1, p->nload);
        }
        fill_middles(plane, own);
    }
    return OK;
}
