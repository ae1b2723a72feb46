#include "section/kernel.h"

#include <string.h>

enum { MOST = ELEMENT_MAX_PLANE_NODES };

// --- channels

channel_strains channel_strains_make(double k)
{
    channel_strains s = {.count = k == 0 ? VALUE : CHANNELS};
    s.a[ALONG_X][XX][0] = s.a[ALONG_X][XY][1] = s.a[ALONG_X][XZ][2] = 1;
    s.a[ALONG_Y][YY][1] = s.a[ALONG_Y][XY][0] = s.a[ALONG_Y][YZ][2] = 1;
    // k S e_z x u and k S (y d/dx - x d/dy) u
    s.a[VALUE][YZ][0] = k;
    s.a[VALUE][XZ][1] = -k;
    s.a[TURNING][XZ][0] = s.a[TURNING][YZ][1] = s.a[TURNING][ZZ][2] = k;
    return s;
}

// a channel's values at point q of all nodes
static void channel_at(const plane_element *e, int q, int channel, double *f)
{
    const int n = e->nnode;
    const double *N = e->N + q * n, *Nx = e->Nx + q * n, *Ny = e->Ny + q * n;
    if (channel == TURNING) {
        for (int i = 0; i < n; i++) {
            f[i] = e->y[q] * Nx[i] - e->x[q] * Ny[i];
        }
    } else {
        memcpy(f, channel == VALUE ? N : channel == ALONG_X ? Nx : Ny, (size_t)n * sizeof *f);
    }
}

// --- products of channels

// int f_a,i f_b,j at i nnode + j
typedef struct channel_products {
    node_pairs a[CHANNELS][CHANNELS];
} channel_products;

// one point's share, for a <= b
static void add_products(int n, int channels, double weight, double f[CHANNELS][MOST],
                         channel_products *p)
{
    for (int a = 0; a < channels; a++) {
        for (int b = a; b < channels; b++) {
            for (int i = 0; i < n; i++) {
                const double c = weight * f[a][i], *g = f[b];
                double *to = p->a[a][b] + i * n;
                const int end = a == b ? i + 1 : n;
                for (int j = 0; j < end; j++) {
                    to[j] += c * g[j];
                }
            }
        }
    }
}

// what is symmetric: a product with itself, and of b and a that of a and b
static void complete_products(int n, int channels, channel_products *p)
{
    for (int a = 0; a < channels; a++) {
        for (int b = a; b < channels; b++) {
            for (int i = 0; i < n; i++) {
                for (int j = 0; j < (a == b ? i : n); j++) {
                    p->a[b][a][j * n + i] = p->a[a][b][i * n + j];
                }
            }
        }
    }
}

static void multiply_channels(const plane_element *e, const double *weight, int first, int last,
                              int channels, channel_products *p)
{
    const int n = e->nnode;
    double f[CHANNELS][MOST];
    for (int a = 0; a < channels; a++) {
        for (int b = a; b < channels; b++) {
            memset(p->a[a][b], 0, (size_t)(n * n) * sizeof(double));
        }
    }
    for (int q = first; q < last; q++) {
        for (int a = 0; a < channels; a++) {
            channel_at(e, q, a, f[a]);
        }
        add_products(n, channels, weight[q], f, p);
    }
    complete_products(n, channels, p);
}

// --- blocks

typedef struct channel_stiffness {
    double a[CHANNELS][CHANNELS][9]; // strains_a^T Q strains_b
} channel_stiffness;

static void join_channels(const channel_strains *s, const mat6 *Q, channel_stiffness *H)
{
    memset(H, 0, sizeof *H);
    for (int b = 0; b < s->count; b++) {
        double stress[6][3] = {{0}};
        for (int i = 0; i < 36; i++) {
            for (int c = 0; c < 3; c++) {
                stress[i / 6][c] += Q->a[i / 6][i % 6] * s->a[b][i % 6][c];
            }
        }
        for (int a = 0; a < s->count; a++) {
            for (int i = 0; i < 6; i++) {
                for (int c = 0; c < 9; c++) {
                    H->a[a][b][c] += s->a[a][i][c / 3] * stress[i][c % 3];
                }
            }
        }
    }
}

// Most of H is zero where no material couples much.
static void add_scaled(int n, double c, const double *from, double *to)
{
    for (int k = 0; c != 0 && k < n * n; k++) {
        to[k] += c * from[k];
    }
}

// (3.12): with N_i strains_TURNING added as an imaginary part to a node's strains
static void add_wave(const channel_products *p, const channel_stiffness *H, int n, int entry,
                     element_blocks *blocks)
{
    double *real = blocks->wave[0][entry], *imaginary = blocks->wave[1][entry];
    add_scaled(n, H->a[TURNING][TURNING][entry], p->a[VALUE][VALUE], real);
    for (int c = 0; c < CHANNELS; c++) {
        add_scaled(n, H->a[c][TURNING][entry], p->a[c][VALUE], imaginary);
        add_scaled(n, -H->a[TURNING][c][entry], p->a[VALUE][c], imaginary);
    }
}

static void add_blocks(const channel_products *p, const channel_stiffness *H, int channels, int n,
                       element_blocks *blocks)
{
    for (int entry = 0; entry < 9; entry++) {
        for (int a = 0; a < channels; a++) {
            for (int b = 0; b < channels; b++) {
                add_scaled(n, H->a[a][b][entry], p->a[a][b], blocks->E[entry]);
            }
        }
        if (channels > VALUE) {
            add_wave(p, H, n, entry, blocks);
        }
    }
}

static void clear_blocks(int n, int channels, element_blocks *blocks)
{
    const size_t size = (size_t)(n * n) * sizeof(double);
    for (int entry = 0; entry < 9; entry++) {
        memset(blocks->E[entry], 0, size);
        if (channels > VALUE) {
            memset(blocks->wave[0][entry], 0, size);
            memset(blocks->wave[1][entry], 0, size);
        }
    }
}

void kernel_blocks(const matter *m, const plane *p, const plane_element *e, matter_element *at,
                   const channel_strains *s, element_blocks *blocks)
{
    const int n = e->nnode, run = at->law->polar ? 1 : e->npoint;
    channel_products products;
    channel_stiffness H;
    clear_blocks(n, s->count, blocks);
    for (int q = 0; q < e->npoint; q += run) {
        join_channels(s, matter_stiffness(m, p, e, q, at), &H);
        multiply_channels(e, at->weight, q, q + run, s->count, &products);
        add_blocks(&products, &H, s->count, n, blocks);
    }
}
