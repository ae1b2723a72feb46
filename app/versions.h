// app/versions.h
// The versions of the libraries that this process has loaded, asked from the libraries themselves:
// no foreign header is needed, and what is told is what runs.
#pragma once

#include <stdbool.h>
#include <stddef.h>

typedef enum library {
    LIBRARY_YAML,
    LIBRARY_MUPARSER,
    LIBRARY_CHOLMOD,
    LIBRARY_BLAS,
    LIBRARY_CAIRO,
    LIBRARY_GMSH,
    LIBRARY_PETSC,
    LIBRARY_MUMPS,
    LIBRARY_HDF5,
    LIBRARY_MPI,
    LIBRARY_PNG,
    LIBRARY_THREE,
    LIBRARY_GSL,
    LIBRARY_EMBREE,
    LIBRARY_NLOPT,
    LIBRARY_COUNT
} library;

const char *library_name(int library);

// "5.5.1"; false where the library is not loaded.
bool library_version(int library, char *text, size_t size);

// One line "name version" for this program and for each library that is loaded.
void versions_loaded(char *text, size_t size);
