// api/turn.c
#include "api/handles.h"

#include <pthread.h>

static pthread_mutex_t turn = PTHREAD_MUTEX_INITIALIZER;

void turn_begin(void)
{
    (void)pthread_mutex_lock(&turn);
    status_clear();
}

void turn_end(void)
{
    (void)pthread_mutex_unlock(&turn);
}
