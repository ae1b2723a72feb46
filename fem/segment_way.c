// fem/segment_way.c
#include "fem/segment_way.h"

#include "fem/unknowns.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <sys/resource.h>
#include <unistd.h>

typedef struct way {
    const char *name;
    way_cost (*cost)(const segment_problem *p, int nrank);
    status (*solve)(const segment_problem *p, const way_wants *wants, way_run *out);
} way;

static const way ways[] = {
    [WAY_AUTO] = {"auto", NULL, NULL},
    [WAY_DOUBLING] = {"doubling", way_cost_doubling, way_doubling},
    [WAY_DIRECT] = {"direct", way_cost_direct, way_direct},
    [WAY_ITERATIVE] = {"iterative", way_cost_iterative, way_iterative},
};

const char *segment_way_name(int w)
{
    return ways[w].name;
}

static int from_environment(const char *name, int otherwise)
{
    const char *text = getenv(name);
    return text ? (int)strtol(text, NULL, 10) : otherwise;
}

// memory that one rank may have [byte]
static double memory_of_rank(int nrank)
{
    double bytes = (double)sysconf(_SC_PHYS_PAGES) * (double)sysconf(_SC_PAGESIZE);
    struct rlimit room;
    if (getrlimit(RLIMIT_AS, &room) == 0 && room.rlim_cur != RLIM_INFINITY) {
        bytes = fmin(bytes, (double)room.rlim_cur * nrank);
    }
    return bytes / nrank;
}

double segment_memory(void)
{
    return memory_of_rank(from_environment("OMPI_COMM_WORLD_SIZE", 1));
}

// what fits counts before what is fast
static int cheapest(const way_cost *cost, double memory)
{
    int best = WAY_DIRECT;
    double least = INFINITY;
    for (int w = WAY_DOUBLING; w <= WAY_ITERATIVE; w++) {
        const bool fits = cost[w].bytes <= memory;
        const double seconds = cost[w].seconds * (fits ? 1 : 1e6);
        if (cost[w].possible && seconds < least) {
            least = seconds;
            best = w;
        }
    }
    return best;
}

static void tell(const way_cost *cost, int asked, char *why)
{
    int used = snprintf(why, SEGMENT_WHY_WORDS, "%s",
                        asked == WAY_AUTO ? "predicted" : "asked for; predicted");
    for (int w = WAY_DOUBLING; w <= WAY_ITERATIVE && used < SEGMENT_WHY_WORDS; w++) {
        const size_t room = (size_t)(SEGMENT_WHY_WORDS - used);
        const char *comma = w > WAY_DOUBLING ? "," : ":";
        used += cost[w].possible
                    ? snprintf(why + used, room, "%s %s %.2g s, %.2g GB", comma, ways[w].name,
                               cost[w].seconds, 1e-9 * cost[w].bytes)
                    : snprintf(why + used, room, "%s %s not of this kind", comma, ways[w].name);
    }
}

void segment_share(body_spec *spec)
{
    const int rank = from_environment("OMPI_COMM_WORLD_RANK", 0);
    const int nrank = from_environment("OMPI_COMM_WORLD_SIZE", 1);
    // a prism's nodes are those of its plane mesh, and each rank may double it by itself
    if (nrank > 1 && (spec->shape.place || spec->matter)) {
        const level_share share = level_share_of(spec, rank, nrank);
        spec->hold_first = share.from;
        spec->hold_last = share.to;
    }
}

int segment_way_choose(int asked, const segment_problem *p, way_cost *out, char *why)
{
    way_cost cost[WAY_ITERATIVE + 1] = {{0}};
    const int nrank = from_environment("OMPI_COMM_WORLD_SIZE", 1);
    for (int w = WAY_DOUBLING; w <= WAY_ITERATIVE; w++) {
        cost[w] = ways[w].cost(p, nrank);
    }
    const int taken = asked != WAY_AUTO ? asked : cheapest(cost, memory_of_rank(nrank));
    *out = cost[taken];
    if (why) {
        tell(cost, asked, why);
    }
    return taken;
}

status segment_way_solve(int asked, const segment_problem *p, const way_wants *wants, way_run *run,
                         int *taken, char why[SEGMENT_WHY_WORDS])
{
    status st = OK;
    way_cost cost = {0};
    *taken = segment_way_choose(asked, p, &cost, why);
    TRY(ways[*taken].solve(p, wants, run));

done:
    return st;
}
