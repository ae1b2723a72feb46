#include "meshes/pixel_tree.h"

#include "base/memory.h"

void pixel_tree_free(pixel_tree *t)
{
    free(t->level);
    *t = (pixel_tree){0};
}

static unsigned char *level_at(const pixel_tree *t, int i, int j)
{
    return &t->level[(long)j * t->image->n[0] + i];
}

static void set_level(const pixel_tree *t, int i, int j, int size, int level)
{
    for (int b = j; b < j + size; b++) {
        for (int a = i; a < i + size; a++) {
            *level_at(t, a, b) = (unsigned char)level;
        }
    }
}

// the pixels around a square, those at its corners too, are like those in it; width: of the rim
static bool rim_is_plain(const pixel_image *p, int i, int j, int size, int width)
{
    const int own = pixel_at(p, i, j);
    for (int w = 1; w <= width; w++) {
        for (int k = -w; k < size + w; k++) {
            if (pixel_at(p, i + k, j - w) != own || pixel_at(p, i + k, j + size + w - 1) != own ||
                pixel_at(p, i - w, j + k) != own || pixel_at(p, i + size + w - 1, j + k) != own) {
                return false;
            }
        }
    }
    return true;
}

// whether four squares of one level below make one
static bool may_merge(const pixel_tree *t, const pixel_tree_rule *rule, int i, int j, int level)
{
    const pixel_image *p = t->image;
    const int size = 1 << level, half = size / 2, own = pixel_at(p, i, j);
    if (own == PIXEL_NONE || i + size > p->n[0] || j + size > p->n[1]) {
        return false;
    }
    for (int k = 0; k < 4; k++) {
        const int a = i + k % 2 * half, b = j + k / 2 * half;
        if (pixel_at(p, a, b) != own || *level_at(t, a, b) != level - 1) {
            return false;
        }
    }
    return rim_is_plain(p, i, j, size, rule->rim);
}

// first place >= 0 of the squares of this size
static int first_place(int offset, int size)
{
    return (size - offset % size) % size;
}

static bool merge_level(pixel_tree *t, const pixel_tree_rule *rule, int level)
{
    const int size = 1 << level;
    bool any = false;
    for (int j = first_place(t->offset[1], size); j < t->image->n[1]; j += size) {
        for (int i = first_place(t->offset[0], size); i < t->image->n[0]; i += size) {
            if (may_merge(t, rule, i, j, level)) {
                set_level(t, i, j, size, level);
                any = true;
            }
        }
    }
    return any;
}

bool pixel_tree_leaf(const pixel_tree *t, int i, int j, int *size)
{
    if (pixel_at(t->image, i, j) == PIXEL_NONE) {
        return false;
    }
    *size = 1 << *level_at(t, i, j);
    return (i + t->offset[0]) % *size == 0 && (j + t->offset[1]) % *size == 0;
}

// the least level beside the square's side k, at every `step` pixels; a high one where there is
// nothing
static int level_beside(const pixel_tree *t, int i, int j, int size, int k, int step)
{
    int least = 99;
    for (int a = 0; a < size; a += step) {
        const int x = k == 1 ? i + size : k == 3 ? i - 1 : i + a;
        const int y = k == 0 ? j - 1 : k == 2 ? j + size : j + a;
        if (pixel_at(t->image, x, y) != PIXEL_NONE && *level_at(t, x, y) < least) {
            least = *level_at(t, x, y);
        }
    }
    return least;
}

// in a balanced tree a neighbour of the next lower level covers half a side
bool pixel_tree_split(const pixel_tree *t, int i, int j, int size, int k)
{
    return size > 1 && level_beside(t, i, j, size, k, size / 2) < *level_at(t, i, j);
}

// one round; true where a square was divided, which others may not yet know of
static bool balance_once(pixel_tree *t)
{
    bool any = false;
    int size = 1;
    for (int j = 0; j < t->image->n[1]; j++) {
        for (int i = 0; i < t->image->n[0]; i++) {
            if (!pixel_tree_leaf(t, i, j, &size) || size < 4) {
                continue;
            }
            const int level = *level_at(t, i, j);
            for (int k = 0; k < 4; k++) {
                if (level_beside(t, i, j, size, k, 1) < level - 1) {
                    set_level(t, i, j, size, level - 1);
                    any = true;
                    break;
                }
            }
        }
    }
    return any;
}

status pixel_tree_make(const pixel_image *p, const pixel_tree_rule *rule, pixel_tree *out)
{
    status st = OK;
    pixel_tree t = {.image = p};
    int top = 0, size = 0;

    TRY(TAKE(t.level, (size_t)p->n[0] * (size_t)p->n[1]));
    while (1 << top < p->n[0] + 1 || 1 << top < p->n[1] + 1) {
        top++;
    }
    for (int d = 0; d < 2; d++) {
        t.offset[d] = (1 << top) / 2 - p->n[d] / 2;
    }
    for (int level = 1; level <= top && level <= rule->top; level++) {
        if (!merge_level(&t, rule, level)) {
            break;
        }
    }
    while (balance_once(&t)) {
    }
    for (int j = 0; j < p->n[1]; j++) {
        for (int i = 0; i < p->n[0]; i++) {
            t.nleaf += pixel_tree_leaf(&t, i, j, &size);
        }
    }
    *out = t;
    t = (pixel_tree){0};

done:
    pixel_tree_free(&t);
    return st;
}
