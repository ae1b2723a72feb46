// app/versions.c
#include "app/versions.h"

#include "reports/scripts.h"

#include <dlfcn.h>
#include <stdio.h>
#include <string.h>

static const char *const names[LIBRARY_COUNT] = {
    "libyaml", "muParser", "CHOLMOD", "OpenBLAS", "cairo", "gmsh",   "PETSc", "MUMPS",
    "HDF5",    "MPI",      "libpng",  "three.js", "GSL",   "Embree", "NLopt",
};

typedef void (*any_function)(void);

const char *library_name(int library)
{
    return names[library];
}

// what any library that is loaded for everybody has under that name; NULL where there is none
static void *find_symbol(const char *symbol)
{
    void *found = NULL;
    void *program = dlopen(NULL, RTLD_LAZY);
    if (program) {
        found = dlsym(program, symbol);
        (void)dlclose(program);
    }
    return found;
}

static any_function find_function(const char *symbol)
{
    any_function function = NULL;
    void *found = find_symbol(symbol);
    memcpy(&function, &found, sizeof function);
    return function;
}

static bool text_version(const char *symbol, char *text, size_t size)
{
    const any_function function = find_function(symbol);
    if (function) {
        (void)snprintf(text, size, "%s", ((const char *(*)(void))function)());
    }
    return function != NULL;
}

static bool muparser_version(char *text, size_t size)
{
    const any_function create = find_function("mupCreate"),
                       version = find_function("mupGetVersion"),
                       release = find_function("mupRelease");
    if (!create || !version || !release) {
        return false;
    }
    void *parser = ((void *(*)(int))create)(0);
    (void)snprintf(text, size, "%s", ((const char *(*)(void *))version)(parser));
    ((void (*)(void *))release)(parser);
    text[strcspn(text, " ")] = '\0'; // its build date and options follow
    return true;
}

static bool cholmod_version(char *text, size_t size)
{
    const any_function function = find_function("cholmod_version");
    int v[3] = {0};
    if (function) {
        (void)((int (*)(int *))function)(v);
        (void)snprintf(text, size, "%d.%d.%d", v[0], v[1], v[2]);
    }
    return function != NULL;
}

static bool blas_version(char *text, size_t size)
{
    char words[256] = "";
    if (!text_version("openblas_get_config", words, sizeof words)) {
        return false;
    }
    // "OpenBLAS 0.3.21 ...": its options follow
    const char *start = strchr(words, ' ');
    start = start ? start + 1 : words;
    (void)snprintf(text, size, "%.*s", (int)strcspn(start, " "), start);
    return true;
}

// "Open MPI v4.1.4, package: ..."
static bool mpi_version(char *text, size_t size)
{
    enum { LONGEST = 8192 }; // of all MPIs there are
    char words[LONGEST] = "";
    int length = 0;
    const any_function function = find_function("MPI_Get_library_version");
    if (function) {
        (void)((int (*)(char *, int *))function)(words, &length);
        words[strcspn(words, ",\n")] = '\0';
        (void)snprintf(text, size, "%s", words);
    }
    return function != NULL;
}

static bool png_version(char *text, size_t size)
{
    const any_function function = find_function("png_get_libpng_ver");
    if (function) {
        (void)snprintf(text, size, "%s", ((const char *(*)(const void *))function)(NULL));
    }
    return function != NULL;
}

static bool gsl_loaded_version(char *text, size_t size)
{
    const char *const *version = find_symbol("gsl_version");
    if (version) {
        (void)snprintf(text, size, "%s", *version);
    }
    return version != NULL;
}

static bool nlopt_loaded_version(char *text, size_t size)
{
    const any_function function = find_function("nlopt_version");
    int v[3] = {0};
    if (function) {
        ((void (*)(int *, int *, int *))function)(&v[0], &v[1], &v[2]);
        (void)snprintf(text, size, "%d.%d.%d", v[0], v[1], v[2]);
    }
    return function != NULL;
}

static bool petsc_version(char *text, size_t size)
{
    const any_function function = find_function("PetscGetVersionNumber");
    int v[4] = {0};
    if (function) {
        (void)((int (*)(int *, int *, int *, int *))function)(&v[0], &v[1], &v[2], &v[3]);
        (void)snprintf(text, size, "%d.%d.%d", v[0], v[1], v[2]);
    }
    return function != NULL;
}

static bool hdf5_version(char *text, size_t size)
{
    const any_function function = find_function("H5get_libversion");
    unsigned v[3] = {0};
    if (function) {
        (void)((int (*)(unsigned *, unsigned *, unsigned *))function)(&v[0], &v[1], &v[2]);
        (void)snprintf(text, size, "%u.%u.%u", v[0], v[1], v[2]);
    }
    return function != NULL;
}

// the version in the file name of a library that has no function for it: libgmsh.so.4.8.4,
// libembree3.so.3.13.5, libdmumps-5.5.so
static bool file_version(const char *prefix, char *text, size_t size)
{
    char line[1024];
    bool found = false;
    FILE *maps = fopen("/proc/self/maps", "r");
    while (maps && !found && fgets(line, sizeof line, maps)) {
        const char *name = strrchr(line, '/');
        found = name && strncmp(name + 1, prefix, strlen(prefix)) == 0;
        if (found) {
            const char *behind = strstr(name, ".so.");
            const char *digits = behind ? behind : name;
            digits += strcspn(digits, "0123456789");
            size_t length = strspn(digits, "0123456789.");
            length -= length > 0 && digits[length - 1] == '.';
            (void)snprintf(text, size, "%.*s", (int)length, digits);
        }
    }
    if (maps) {
        (void)fclose(maps);
    }
    return found;
}

bool library_version(int library, char *text, size_t size)
{
    switch (library) {
    case LIBRARY_YAML:
        return text_version("yaml_get_version_string", text, size);
    case LIBRARY_MUPARSER:
        return muparser_version(text, size);
    case LIBRARY_CHOLMOD:
        return cholmod_version(text, size);
    case LIBRARY_BLAS:
        return blas_version(text, size);
    case LIBRARY_CAIRO:
        return text_version("cairo_version_string", text, size);
    case LIBRARY_GMSH:
        return file_version("libgmsh", text, size);
    case LIBRARY_PETSC:
        return petsc_version(text, size);
    case LIBRARY_MUMPS:
        return file_version("libdmumps", text, size);
    case LIBRARY_HDF5:
        return hdf5_version(text, size);
    case LIBRARY_MPI:
        return mpi_version(text, size);
    case LIBRARY_PNG:
        return png_version(text, size);
    case LIBRARY_THREE:
        (void)snprintf(text, size, "r%s", three_revision);
        return true;
    case LIBRARY_GSL:
        return gsl_loaded_version(text, size);
    case LIBRARY_EMBREE:
        return file_version("libembree", text, size);
    case LIBRARY_NLOPT:
        return nlopt_loaded_version(text, size);
    default:
        return false;
    }
}

void versions_loaded(char *text, size_t size)
{
    size_t used = (size_t)snprintf(text, size, "stiffaxis " STIFFAXIS_VERSION "\n");
    for (int i = 0; i < LIBRARY_COUNT; i++) {
        char version[64];
        if (used < size && library_version(i, version, sizeof version)) {
            used += (size_t)snprintf(text + used, size - used, "%s %s\n", names[i], version);
        }
    }
}
