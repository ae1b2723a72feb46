// api/turn.c
#include "api/handles.h"

#include <locale.h>
#include <pthread.h>

static pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;
static pthread_once_t once = PTHREAD_ONCE_INIT;
static _Thread_local bool mine;
static locale_t plain, before; // before: of the thread whose turn it is

// A fork in the midst of another thread's turn waits for its end: the child would have a lock that
// nobody opens. Our own forks are in the midst of our own turn.
static void before_fork(void)
{
    if (!mine) {
        (void)pthread_mutex_lock(&turn);
    }
}

static void after_fork(void)
{
    if (!mine) {
        (void)pthread_mutex_unlock(&turn);
    }
}

static void prepare(void)
{
    plain = newlocale(LC_ALL_MASK, "C", (locale_t)0);
    (void)pthread_atfork(before_fork, after_fork, after_fork);
}

void turn_begin(void)
{
    (void)pthread_once(&once, prepare);
    (void)pthread_mutex_lock(&turn);
    mine = true;
    // numbers have points, whatever the locale of the program that we are part of
    before = plain ? uselocale(plain) : (locale_t)0;
}

void turn_end(void)
{
    if (before) {
        (void)uselocale(before);
    }
    mine = false;
    (void)pthread_mutex_unlock(&turn);
}
