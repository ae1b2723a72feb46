// app/compare_published.c
// The section's 6x6 against a table that someone published, `section.reference`.
#include "app/compare_rows.h"

#include <math.h>

static const char *const name[6] = {"nx", "ny", "nz", "mx", "my", "mz"};
static const char *const unit[2][2] = {{"N", "N m"}, {"N m", "N m^2"}};

// differences are measured on sqrt(K_ii K_jj), docs/theory.md (6.1): a small coupling is held as
// tightly as the diagonal, and no tighter
status compare_published(const case_data *c, const compare_section *section, run_result *r)
{
    const section_reference *reference = &c->file.section.reference;
    const mat6 *K = &section->full.K;
    for (int k = 0; k < reference->K.nrow; k++) {
        const double *row = reference->K.a + (size_t)3 * (size_t)k;
        const int i = (int)row[0] - 1, j = (int)row[1] - 1;
        const double ours = K->a[i][j], size = sqrt(K->a[i][i] * K->a[j][j]);
        compare_judge(compare_add(r, unit[i >= MX][j >= MX],
                                  "section: K[%s,%s], ours (full) against the published", name[i],
                                  name[j]),
                      ours, row[2], fabs(ours - row[2]) / size,
                      (tolerance){reference->tolerance,
                                  reference->source ? reference->source : "as the case states"});
    }
    return OK;
}
