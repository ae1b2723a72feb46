#include "base/triangle_rule.h"

#include "base/element.h"

// Symmetric rules: Strang and Fix (degree 2), Radon (5), Dunavant, Int. J. Num. Meth. Eng. 21
// (1985) 1129 (8 and 9), their digits completed by Newton's method on the moments.
//
// An orbit is all places of barycentric coordinates (a, b, 1 - a - b) in any order.
typedef struct orbit {
    int count; // 1: the middle, 3: a = b, 6
    double weight, a, b;
} orbit;

typedef struct symmetric_rule {
    int degree, norbit;
    orbit orbit[6];
} symmetric_rule;

static const symmetric_rule rules[] = {
    {2, 1, {{3, 1.0 / 3, 1.0 / 6, 1.0 / 6}}},
    {5,
     3,
     {{1, 0.225, 0, 0},
      {3, 0.125939180544827153, 0.101286507323456339, 0.101286507323456339},
      {3, 0.132394152788506181, 0.470142064105115090, 0.470142064105115090}}},
    {8,
     5,
     {{1, 0.144315607677787168, 0, 0},
      {3, 0.0950916342672846248, 0.459292588292723156, 0.459292588292723156},
      {3, 0.10321737053471825, 0.170569307751760207, 0.170569307751760207},
      {3, 0.0324584976231980803, 0.0505472283170309755, 0.0505472283170309755},
      {6, 0.0272303141744349943, 0.263112829634638113, 0.00839477740995760534}}},
    {9,
     6,
     {{1, 0.0971357962827988338, 0, 0},
      {3, 0.0313347002271390705, 0.489682519198737628, 0.489682519198737628},
      {3, 0.0778275410047742793, 0.437089591492936637, 0.437089591492936637},
      {3, 0.079647738927210253, 0.18820353561903273, 0.18820353561903273},
      {3, 0.0255776756586980313, 0.0447295133944527099, 0.0447295133944527099},
      {6, 0.0432835393772893773, 0.221962989160765696, 0.0368384120547362836}}},
};

static int add_point(int n, double x, double y, double w, double (*point)[3], double *weight)
{
    point[n][0] = x;
    point[n][1] = y;
    weight[n] = w / 2; // the triangle's area
    return n + 1;
}

static int add_orbit(int n, const orbit *o, double (*point)[3], double *weight)
{
    const double a = o->a, b = o->b, c = 1 - a - b, w = o->weight;
    if (o->count == 1) {
        return add_point(n, 1.0 / 3, 1.0 / 3, w, point, weight);
    }
    n = add_point(n, a, b, w, point, weight);
    n = add_point(n, b, c, w, point, weight);
    n = add_point(n, c, a, w, point, weight);
    if (o->count == 6) {
        n = add_point(n, b, a, w, point, weight);
        n = add_point(n, c, b, w, point, weight);
        n = add_point(n, a, c, w, point, weight);
    }
    return n;
}

// the collapsed square: x = (1+a)(1-b)/4, y = (1+b)/2, dx dy = (1-b)/8 da db, with one degree more
// in b
static int collapsed_rule(int degree, double (*point)[3], double *weight)
{
    double g[TRIANGLE_MAX_DEGREE / 2 + 2], w[TRIANGLE_MAX_DEGREE / 2 + 2];
    const int n = (degree + 1) / 2 + 1;
    gauss_legendre(n, g, w);
    for (int k = 0; k < n * n; k++) {
        const int i = k % n, j = k / n;
        (void)add_point(k, (1 + g[i]) * (1 - g[j]) / 4, (1 + g[j]) / 2,
                        w[i] * w[j] * (1 - g[j]) / 4, point, weight);
    }
    return n * n;
}

int triangle_rule(int degree, double (*point)[3], double *weight)
{
    for (int k = 0; k < (int)(sizeof rules / sizeof *rules); k++) {
        if (degree <= rules[k].degree) {
            int n = 0;
            for (int i = 0; i < rules[k].norbit; i++) {
                n = add_orbit(n, &rules[k].orbit[i], point, weight);
            }
            return n;
        }
    }
    return collapsed_rule(degree, point, weight);
}
