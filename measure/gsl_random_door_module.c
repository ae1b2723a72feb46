// measure/gsl_random_door_module.c
#include "measure/gsl_door.h"

#include <gsl/gsl_cdf.h>
#include <gsl/gsl_errno.h>
#include <gsl/gsl_randist.h>
#include <gsl/gsl_rng.h>

#include <stdlib.h>

struct gsl_random {
    gsl_rng *generator;
};

static void random_free(gsl_random *g)
{
    if (g) {
        gsl_rng_free(g->generator);
        free(g);
    }
}

static status random_make(unsigned long seed, gsl_random **out)
{
    gsl_random *g = calloc(1, sizeof *g);
    (void)gsl_set_error_handler_off();
    if (g) {
        g->generator = gsl_rng_alloc(gsl_rng_mt19937);
    }
    if (!g || !g->generator) {
        free(g);
        return status_fail(ERR_RESOURCE, "out of memory for random numbers");
    }
    gsl_rng_set(g->generator, seed);
    *out = g;
    return OK;
}

static double random_uniform(gsl_random *g)
{
    return gsl_rng_uniform(g->generator);
}

static double random_normal(gsl_random *g)
{
    return gsl_ran_ugaussian(g->generator);
}

static double student(double share, double freedom)
{
    (void)gsl_set_error_handler_off();
    return gsl_cdf_tdist_Pinv((1 + share) / 2, freedom);
}

const gsl_random_door *stiffaxis_gsl_random_door(void)
{
    static const gsl_random_door door = {
        .make = random_make,
        .free = random_free,
        .uniform = random_uniform,
        .normal = random_normal,
        .student = student,
    };
    return &door;
}
