// reports/csv_models.c
#include "reports/csv_kit.h"

#include <math.h>

// over sqrt(C_ii C_jj) of 3D, so that entries of all units stand in one column
status csv_models(const model_checks *m, const char *dir)
{
    static const char *const axis[6] = {"nx", "ny", "nz", "mx", "my", "mz"};
    csv *c = NULL;
    csv_header h = {0};
    csv_add_all(&h, "row column compliance_3d_ratio classical_off_ratio prismatic_off_ratio "
                    "turning_off_ratio");
    const status st = csv_table(dir, "models.csv", &h, &c);
    for (int k = 0; st == OK && k < 36; k++) {
        const int i = k / 6, j = k % 6;
        const double scale = sqrt(m->compliance.a[i][i] * m->compliance.a[j][j]);
        if (j < i) {
            continue;
        }
        csv_text(c, axis[i]);
        csv_text(c, axis[j]);
        csv_real(c, m->compliance.a[i][j] / scale);
        for (int k3 = 0; k3 < MODEL_CHECKS; k3++) {
            const model_check *one = &m->model[k3];
            csv_real(c,
                     one->why[0] ? NAN : (one->compliance.a[i][j] - m->compliance.a[i][j]) / scale);
        }
    }
    return st == OK ? csv_close(c) : st;
}
