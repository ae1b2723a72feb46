#include "meshes/pixel_image.h"

#include "base/memory.h"

status pixel_image_make(int nx, int ny, const double pitch[2], pixel_image *out)
{
    status st = OK;
    pixel_image p = {.n = {nx, ny}};
    const size_t count = (size_t)nx * (size_t)ny;

    for (int d = 0; d < 2; d++) {
        p.pitch[d] = pitch[d];
        p.corner[d] = -pitch[d] * p.n[d] / 2;
    }
    TRY(TAKE(p.at, count));
    for (size_t i = 0; i < count; i++) {
        p.at[i] = PIXEL_NONE;
    }
    *out = p;

done:
    return st;
}

void pixel_image_free(pixel_image *p)
{
    free(p->at);
    *p = (pixel_image){0};
}

status pixel_image_finer(const pixel_image *p, int factor, pixel_image *out)
{
    status st = OK;
    const double pitch[2] = {p->pitch[0] / factor, p->pitch[1] / factor};
    TRY(pixel_image_make(p->n[0] * factor, p->n[1] * factor, pitch, out));
    out->corner[0] = p->corner[0];
    out->corner[1] = p->corner[1];
    for (int j = 0; j < out->n[1]; j++) {
        for (int i = 0; i < out->n[0]; i++) {
            out->at[(long)j * out->n[0] + i] = (short)pixel_at(p, i / factor, j / factor);
        }
    }

done:
    return st;
}

// the material that most of four have; `turn` chooses where two are level
static int majority(const int four[4], int turn)
{
    int best = four[0], votes = 0;
    for (int i = 0; i < 4; i++) {
        const int candidate = four[turn ? 3 - i : i];
        int count = 0;
        for (int k = 0; k < 4; k++) {
            count += four[k] == candidate;
        }
        if (count > votes) {
            votes = count;
            best = candidate;
        }
    }
    return best;
}

status pixel_image_coarser(const pixel_image *p, pixel_image *out)
{
    status st = OK;
    const double pitch[2] = {2 * p->pitch[0], 2 * p->pitch[1]};
    TRY(pixel_image_make((p->n[0] + 1) / 2, (p->n[1] + 1) / 2, pitch, out));
    out->corner[0] = p->corner[0];
    out->corner[1] = p->corner[1];
    for (int j = 0; j < out->n[1]; j++) {
        for (int i = 0; i < out->n[0]; i++) {
            const int four[4] = {pixel_at(p, 2 * i, 2 * j), pixel_at(p, 2 * i + 1, 2 * j),
                                 pixel_at(p, 2 * i, 2 * j + 1), pixel_at(p, 2 * i + 1, 2 * j + 1)};
            out->at[(long)j * out->n[0] + i] = (short)majority(four, (i + j) % 2);
        }
    }

done:
    return st;
}

// --- parts

// marks the part of the pixel `from` in part[], by way of the list todo[]; returns its size
static int flood(const pixel_image *p, int from, int label, int *part, int *todo)
{
    static const int step[4][2] = {{1, 0}, {-1, 0}, {0, 1}, {0, -1}};
    int count = 0, done = 0;
    part[from] = label;
    todo[count++] = from;
    while (done < count) {
        const int at = todo[done++], x = at % p->n[0], y = at / p->n[0];
        for (int k = 0; k < 4; k++) {
            const int i = x + step[k][0], j = y + step[k][1];
            const int next = j * p->n[0] + i;
            if (pixel_at(p, i, j) != PIXEL_NONE && part[next] == 0) {
                part[next] = label;
                todo[count++] = next;
            }
        }
    }
    return count;
}

static bool touches_another(const pixel_image *p, const int *part, int label)
{
    for (int at = 0; at < p->n[0] * p->n[1]; at++) {
        const int x = at % p->n[0], y = at / p->n[0];
        for (int k = 0; k < 4 && part[at] == label; k++) {
            const int i = x + (k % 2 ? 1 : -1), j = y + (k / 2 ? 1 : -1);
            if (pixel_at(p, i, j) != PIXEL_NONE && part[j * p->n[0] + i] != label) {
                return true;
            }
        }
    }
    return false;
}

status pixel_image_parts(const pixel_image *p, int *solid, pixel_part *apart)
{
    status st = OK;
    int *part = NULL, *todo = NULL, nlabel = 0, smallest = 0;
    const int n = p->n[0] * p->n[1];
    *solid = 0;
    *apart = (pixel_part){0};

    TRY(TAKE(part, (size_t)n));
    TRY(TAKE(todo, (size_t)n));
    for (int i = 0; i < n; i++) {
        if (p->at[i] == PIXEL_NONE || part[i] != 0) {
            continue;
        }
        const int count = flood(p, i, ++nlabel, part, todo);
        *solid += count;
        if (apart->count == 0 || count <= apart->count) {
            *apart = (pixel_part){.count = count, .at = {i % p->n[0], i / p->n[0]}};
            smallest = nlabel;
        }
    }
    if (nlabel < 2) {
        *apart = (pixel_part){0};
    } else {
        apart->touches = touches_another(p, part, smallest);
    }

done:
    free(part);
    free(todo);
    return st;
}
