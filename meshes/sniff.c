// meshes/sniff.c
#include "meshes/sniff.h"

#include <stdio.h>
#include <string.h>

static const struct {
    const char *bytes;
    size_t count;
    const char *words;
} known[] = {
    {"\x89PNG\r\n\x1a\n", 8, "a PNG image"},
    {"\xff\xd8\xff", 3, "a JPEG image"},
    {"GIF8", 4, "a GIF image"},
    {"BM", 2, "a BMP image"},
    {"II*\0", 4, "a TIFF image"},
    {"MM\0*", 4, "a TIFF image"},
    {"%PDF", 4, "a PDF document"},
    {"\x7f"
     "ELF",
     4, "a program"},
    {"MZ", 2, "a program"},
    {"#!", 2, "a script"},
    {"\x1f\x8b", 2, "compressed by gzip"},
    {"PK\3\4", 4, "a ZIP archive"},
    {"BZh", 3, "compressed by bzip2"},
    {"\x89HDF\r\n\x1a\n", 8, "an HDF5 file"},
    {"ISO-10303-21;", 13, "a STEP file"},
    {"$MeshFormat", 11, "a MSH file"},
    {"AutoCAD Binary DXF", 18, "a binary DXF file"},
    {"<?xml", 5, "an XML file"},
    {"<svg", 4, "an SVG image"},
    {"solid ", 6, "an STL file"},
    {"version https://git-lfs", 23, "a pointer of git-lfs, not the file itself"},
};

static bool is_text(const input_file *f, size_t count)
{
    for (size_t i = 0; i < count; i++) {
        const unsigned char c = f->bytes[i];
        if ((c < 32 && c != '\t' && c != '\r' && c != '\n') || c == 127) {
            return false;
        }
    }
    return true;
}

const char *sniff_words(const input_file *f, char words[SNIFF_WORDS])
{
    for (size_t i = 0; i < sizeof known / sizeof *known; i++) {
        if (f->count >= known[i].count && memcmp(f->bytes, known[i].bytes, known[i].count) == 0) {
            (void)snprintf(words, SNIFF_WORDS, "%s", known[i].words);
            return words;
        }
    }
    const size_t head = f->count < 40 ? f->count : 40;
    if (head == 0) {
        (void)snprintf(words, SNIFF_WORDS, "empty");
    } else if (is_text(f, head)) {
        const size_t line = strcspn((const char *)f->bytes, "\r\n");
        (void)snprintf(words, SNIFF_WORDS, "text that begins with '%.*s'",
                       (int)(line < head ? line : head), (const char *)f->bytes);
    } else {
        (void)snprintf(words, SNIFF_WORDS, "of an unknown kind");
    }
    return words;
}
