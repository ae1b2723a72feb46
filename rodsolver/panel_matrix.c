// rodsolver/panel_matrix.c
#include "rodsolver/panel_matrix.h"

#include <math.h>

enum { UNKNOWNS = PANEL_UNKNOWNS };

int panel_factor_symmetric(double A[UNKNOWNS][UNKNOWNS], double *product)
{
    int negative = 0;
    for (int j = 0; j < UNKNOWNS; j++) {
        const double pivot = A[j][j];
        if (pivot == 0 || !isfinite(pivot)) {
            return -1;
        }
        negative += pivot < 0;
        *product *= fabs(pivot);
        const double reciprocal = 1 / pivot;
        double column[UNKNOWNS];
        for (int i = j + 1; i < UNKNOWNS; i++) {
            column[i] = A[i][j];
            A[i][j] *= reciprocal;
        }
        for (int i = j + 1; i < UNKNOWNS; i++) {
            for (int l = j + 1; l <= i; l++) {
                A[i][l] -= A[i][j] * column[l];
            }
        }
        A[j][j] = reciprocal;
    }
    return negative;
}

int panel_factor_general(double A[UNKNOWNS][UNKNOWNS], int exchange[UNKNOWNS], double *product)
{
    int sign = 1;
    for (int j = 0; j < UNKNOWNS; j++) {
        int best = j;
        for (int i = j + 1; i < UNKNOWNS; i++) {
            best = fabs(A[i][j]) > fabs(A[best][j]) ? i : best;
        }
        exchange[j] = best;
        if (A[best][j] == 0 || !isfinite(A[best][j])) {
            return 0;
        }
        for (int l = 0; best != j && l < UNKNOWNS; l++) {
            const double swap = A[j][l];
            A[j][l] = A[best][l];
            A[best][l] = swap;
        }
        sign = (best != j) != (A[j][j] < 0) ? -sign : sign;
        *product *= fabs(A[j][j]);
        for (int i = j + 1; i < UNKNOWNS; i++) {
            const double c = A[i][j] /= A[j][j];
            for (int l = j + 1; l < UNKNOWNS; l++) {
                A[i][l] -= c * A[j][l];
            }
        }
    }
    return sign;
}

void panel_solve_symmetric(const double A[UNKNOWNS][UNKNOWNS], double *b)
{
    for (int i = 1; i < UNKNOWNS; i++) {
        for (int l = 0; l < i; l++) {
            b[i] -= A[i][l] * b[l];
        }
    }
    for (int i = 0; i < UNKNOWNS; i++) {
        b[i] *= A[i][i];
    }
    for (int i = UNKNOWNS - 1; i > 0; i--) {
        for (int l = 0; l < i; l++) {
            b[l] -= A[i][l] * b[i];
        }
    }
}

void panel_solve_columns(const double A[UNKNOWNS][UNKNOWNS], double b[UNKNOWNS][3])
{
    for (int i = 1; i < UNKNOWNS; i++) {
        for (int l = 0; l < i; l++) {
            for (int c = 0; c < 3; c++) {
                b[i][c] -= A[i][l] * b[l][c];
            }
        }
    }
    for (int i = 0; i < UNKNOWNS; i++) {
        for (int c = 0; c < 3; c++) {
            b[i][c] *= A[i][i];
        }
    }
    for (int i = UNKNOWNS - 1; i > 0; i--) {
        for (int l = 0; l < i; l++) {
            for (int c = 0; c < 3; c++) {
                b[l][c] -= A[i][l] * b[i][c];
            }
        }
    }
}

void panel_solve_general(const double A[UNKNOWNS][UNKNOWNS], const int *exchange, double *b)
{
    for (int i = 0; i < UNKNOWNS; i++) {
        const double swap = b[exchange[i]];
        b[exchange[i]] = b[i];
        b[i] = swap;
    }
    for (int i = 1; i < UNKNOWNS; i++) {
        for (int l = 0; l < i; l++) {
            b[i] -= A[i][l] * b[l];
        }
    }
    for (int i = UNKNOWNS - 1; i >= 0; i--) {
        for (int l = i + 1; l < UNKNOWNS; l++) {
            b[i] -= A[i][l] * b[l];
        }
        b[i] /= A[i][i];
    }
}
