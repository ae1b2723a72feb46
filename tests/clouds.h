// tests/clouds.h
// Files of points written for the readers' tests, in every form that a scanner's program has.
#pragma once

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <unistd.h>

typedef struct cloud_file {
    char path[64];
    FILE *stream;
} cloud_file;

static inline cloud_file cloud_file_new(const char *suffix)
{
    cloud_file f = {0};
    (void)snprintf(f.path, sizeof f.path, "/tmp/stiffaxis-cloud-XXXXXX%s", suffix);
    const int fd = mkstemps(f.path, (int)strlen(suffix));
    f.stream = fd >= 0 ? fdopen(fd, "wb") : NULL;
    if (!f.stream) {
        (void)fprintf(stderr, "%s cannot be made\n", f.path);
        exit(1);
    }
    return f;
}

static inline const char *cloud_file_close(cloud_file *f)
{
    (void)fclose(f->stream);
    f->stream = NULL;
    return f->path;
}

static inline void cloud_file_remove(const cloud_file *f)
{
    (void)remove(f->path);
}

static inline void cloud_file_bits(cloud_file *f, uint64_t bits, int size, int big)
{
    for (int i = 0; i < size; i++) {
        (void)fputc((int)(bits >> 8 * (big ? size - 1 - i : i) & 255), f->stream);
    }
}

static inline void cloud_file_float(cloud_file *f, double value, int size, int big)
{
    const float single = (float)value;
    uint32_t half = 0;
    uint64_t whole = 0;
    memcpy(&half, &single, 4);
    memcpy(&whole, &value, 8);
    cloud_file_bits(f, size == 4 ? half : whole, size, big);
}

// form 0: text, 1: little, 2: big endian; around 0: nothing else, 1: other properties, an element
// behind, 2: lists among the properties and elements in front too
static inline void cloud_file_ply(cloud_file *f, int form, const char *type, int around, int count,
                                  const double (*p)[3])
{
    static const char *const forms[] = {"ascii", "binary_little_endian", "binary_big_endian"};
    const int size = strcmp(type, "float") == 0 ? 4 : 8, big = form == 2;
    fprintf(f->stream, "ply\nformat %s 1.0\ncomment element vertex 99\n", forms[form]);
    if (around == 2) {
        fprintf(f->stream, "element camera 1\nproperty double t\nelement face 2\n"
                           "property list uchar int vertex_indices\nproperty uchar flag\n");
    }
    fprintf(f->stream, "element vertex %d\n", count);
    if (around > 0) {
        fprintf(f->stream, "property uchar red\n");
    }
    if (around == 2) {
        fprintf(f->stream, "property list ushort short seen_by\n");
    }
    fprintf(f->stream, "property %s x\nproperty %s y\n", type, type);
    if (around > 0) {
        fprintf(f->stream, "property double quality\n");
    }
    fprintf(f->stream, "property %s z\n", type);
    if (around > 0) {
        fprintf(f->stream, "element face 1\nproperty list uchar int vertex_index\n");
    }
    fprintf(f->stream, "end_header\n");
    if (around == 2 && form == 0) {
        fprintf(f->stream, "0.5\n3 0 1 2 7\n4 0 1 2 3 7\n");
    } else if (around == 2) {
        cloud_file_float(f, 0.5, 8, big);
        for (int face = 0; face < 2; face++) {
            cloud_file_bits(f, (uint64_t)(3 + face), 1, big);
            for (int i = 0; i < 3 + face; i++) {
                cloud_file_bits(f, (uint64_t)i, 4, big);
            }
            cloud_file_bits(f, 7, 1, big);
        }
    }
    for (int i = 0; i < count; i++) {
        if (form == 0) {
            fprintf(f->stream, "%s", around > 0 ? "200 " : "");
            for (int k = 0; around == 2 && k <= i % 3; k++) {
                fprintf(f->stream, "%d ", k == 0 ? i % 3 : k);
            }
            fprintf(f->stream, "%.17g %.17g ", p[i][0], p[i][1]);
            fprintf(f->stream, "%s%.17g\n", around > 0 ? "0.75 " : "", p[i][2]);
            continue;
        }
        if (around > 0) {
            cloud_file_bits(f, 200, 1, big);
        }
        for (int k = 0; around == 2 && k <= i % 3; k++) {
            cloud_file_bits(f, (uint64_t)(k == 0 ? i % 3 : k), 2, big);
        }
        cloud_file_float(f, p[i][0], size, big);
        cloud_file_float(f, p[i][1], size, big);
        if (around > 0) {
            cloud_file_float(f, 0.75, 8, big);
        }
        cloud_file_float(f, p[i][2], size, big);
    }
    if (around > 0 && form == 0) {
        fprintf(f->stream, "3 0 1 2\n");
    } else if (around > 0) {
        cloud_file_bits(f, 0, 1, big);
    }
}

// What PCD's columns are packed with: runs, and copies of what came before.
static inline size_t cloud_lzf_pack(const unsigned char *from, size_t count, unsigned char *to)
{
    size_t n = 0, at = 0;
    while (at < count) {
        size_t best = 0, back = 0;
        for (size_t b = 1; b <= at && b <= 8192; b++) {
            size_t same = 0;
            while (at + same < count && same < 264 && from[at + same - b] == from[at + same]) {
                same++;
            }
            if (same > best) {
                best = same;
                back = b;
            }
        }
        if (best >= 3) {
            const size_t length = best - 2, off = back - 1;
            to[n++] = (unsigned char)((length < 7 ? length : 7) << 5 | off >> 8);
            if (length >= 7) {
                to[n++] = (unsigned char)(length - 7);
            }
            to[n++] = (unsigned char)off;
            at += best;
        } else {
            to[n++] = 0; // a run of one
            to[n++] = from[at++];
        }
    }
    return n;
}

// form 0: text, 1: binary, 2: packed; around 0: x y z as floats, 1: doubles between other fields,
// 2: whole numbers where the points have them is left to PLY: floats with a field of many counts
static inline void cloud_file_pcd(cloud_file *f, int form, int around, int count,
                                  const double (*p)[3])
{
    static const char *const heads[] = {
        "FIELDS x y z\nSIZE 4 4 4\nTYPE F F F\nCOUNT 1 1 1\n",
        "FIELDS rgb x y _ z\nSIZE 4 8 8 1 8\nTYPE U F F U F\nCOUNT 1 1 1 3 1\n",
        "FIELDS vfh z y x label\nSIZE 4 4 4 4 2\nTYPE F F F F I\nCOUNT 5 1 1 1 1\n"};
    static const char *const forms[] = {"ascii", "binary", "binary_compressed"};
    // field: bytes of an entry, how many, the axis or -1
    static const int fields[3][5][3] = {{{4, 1, 0}, {4, 1, 1}, {4, 1, 2}},
                                        {{4, 1, -1}, {8, 1, 0}, {8, 1, 1}, {1, 3, -1}, {8, 1, 2}},
                                        {{4, 5, -1}, {4, 1, 2}, {4, 1, 1}, {4, 1, 0}, {2, 1, -1}}};
    const int nfield = around == 0 ? 3 : 5;
    fprintf(f->stream, "# .PCD v0.7 - Point Cloud Data file format\nVERSION 0.7\n%s",
            heads[around]);
    fprintf(f->stream, "WIDTH %d\nHEIGHT 1\nVIEWPOINT 0 0 0 1 0 0 0\nPOINTS %d\nDATA %s\n", count,
            count, forms[form]);
    cloud_file raw = *f;
    char *bytes = NULL;
    size_t size = 0;
    raw.stream = form == 2 ? open_memstream(&bytes, &size) : f->stream;
    // packed: all of a field, then all of the next
    for (int step = 0; step < nfield * count; step++) {
        const int k = form == 2 ? step / count : step % nfield;
        const int i = form == 2 ? step % count : step / nfield;
        const int *field = fields[around][k];
        for (int c = 0; c < field[1]; c++) {
            if (form == 0) {
                fprintf(raw.stream, "%.17g%s", field[2] >= 0 ? p[i][field[2]] : 1.0,
                        k == nfield - 1 && c == field[1] - 1 ? "\n" : " ");
            } else if (field[2] >= 0) {
                cloud_file_float(&raw, p[i][field[2]], field[0], 0);
            } else {
                cloud_file_bits(&raw, 1, field[0], 0);
            }
        }
    }
    if (form == 2) {
        (void)fclose(raw.stream);
        unsigned char *packed = malloc(2 * size + 16);
        const size_t n = packed ? cloud_lzf_pack((unsigned char *)bytes, size, packed) : 0;
        cloud_file_bits(f, n, 4, 0);
        cloud_file_bits(f, size, 4, 0);
        (void)fwrite(packed, 1, n, f->stream);
        free(packed);
        free(bytes);
    }
}
