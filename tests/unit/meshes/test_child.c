// tests/unit/meshes/test_child.c
#include "meshes/child.h"
#include "tests/test.h"

#include <errno.h>
#include <fcntl.h>
#include <signal.h>
#include <string.h>
#include <sys/socket.h>
#include <sys/stat.h>
#include <sys/wait.h>
#include <unistd.h>

typedef struct numbers {
    int count;
    double *value; // [count]
} numbers;

static int list_numbers(void *answer, child_part parts[CHILD_MOST_PARTS])
{
    numbers *n = answer;
    parts[0] = (child_part){(void **)&n->value, n->count, sizeof *n->value};
    return 1;
}

static child_job job_for(status (*work)(void *request, void *answer), void *request)
{
    return (child_job){.what = "the worker",
                       .seconds = 20,
                       .when_killed = ERR_FILE,
                       .sealed = true,
                       .request = request,
                       .work = work,
                       .answer_size = sizeof(numbers),
                       .list = list_numbers};
}

static status run(status (*work)(void *, void *), void *request, numbers *out)
{
    const child_job job = job_for(work, request);
    status_clear();
    return child_run(&job, out);
}

static status count_up(void *request, void *answer)
{
    numbers *n = answer;
    n->count = *(int *)request;
    n->value = malloc((size_t)n->count * sizeof *n->value);
    for (int i = 0; n->value && i < n->count; i++) {
        n->value[i] = i;
    }
    return n->value ? OK : ERR_RESOURCE;
}

static void an_answer_comes_back_whole(void)
{
    int count = 300000; // more than a pipe holds at once
    numbers n;
    const child_job job = job_for(count_up, &count);
    CHECK_OK(run(count_up, &count, &n));
    CHECK(n.count == count && n.value[count - 1] == count - 1);
    child_answer_free(&job, &n);
}

static status refuse(void *request, void *answer)
{
    (void)request;
    (void)answer;
    return status_fail_at(ERR_INPUT, 4, 2, "not this");
}

static status crash(void *request, void *answer)
{
    (void)request;
    (void)answer;
    (void)signal(SIGSEGV, SIG_DFL);
    (void)raise(SIGSEGV);
    return OK;
}

static status leave(void *request, void *answer)
{
    (void)request;
    (void)answer;
    _exit(0);
}

static status hang(void *request, void *answer)
{
    (void)request;
    (void)answer;
    while (pause() == -1) {
    }
    return OK;
}

static void what_goes_wrong_has_its_status(void)
{
    numbers n;
    int line = 0, column = 0;
    CHECK(run(refuse, NULL, &n) == ERR_INPUT);
    CHECK(strcmp(status_message(), "not this") == 0);
    CHECK(status_place(&line, &column) && line == 4 && column == 2);
    CHECK(run(crash, NULL, &n) == ERR_FILE && strstr(status_message(), "crashed"));
    CHECK(run(leave, NULL, &n) == ERR_FILE && strstr(status_message(), "without an answer"));
    child_job job = job_for(hang, NULL);
    job.seconds = 1;
    status_clear();
    CHECK(child_run(&job, &n) == ERR_RESOURCE && strstr(status_message(), "stopped after 1 s"));
}

// how many of the forbidden things were possible; value[0] is the count
static status break_out(void *request, void *answer)
{
    const char *folder = request;
    numbers *n = answer;
    char path[256], other[256];
    int possible = 0;
    (void)snprintf(path, sizeof path, "%s/new", folder);
    (void)snprintf(other, sizeof other, "%s/old", folder);
    possible += open(path, O_WRONLY | O_CREAT, 0600) >= 0;
    possible += open(other, O_RDWR) >= 0;
    possible += creat(path, 0600) >= 0;
    possible += unlink(other) == 0;
    possible += rename(other, path) == 0;
    possible += mkdir(path, 0700) == 0;
    possible += chmod(other, 0777) == 0;
    possible += symlink(other, path) == 0;
    possible += truncate(other, 0) == 0;
    possible += socket(AF_INET, SOCK_STREAM, 0) >= 0;
    const pid_t child = fork();
    if (child == 0) {
        _exit(0);
    }
    possible += child > 0;
    possible += system("exit 0") == 0;
    (void)execl("/bin/true", "true", (char *)NULL); // would end this without an answer
    // what it may do
    const int fd = open(other, O_RDONLY);
    char byte = 0;
    n->count = 2;
    n->value = calloc(2, sizeof *n->value);
    if (!n->value) {
        return ERR_RESOURCE;
    }
    n->value[0] = possible;
    n->value[1] = fd >= 0 && read(fd, &byte, 1) == 1;
    return OK;
}

static void a_sealed_child_leaves_no_trace(void)
{
    char folder[] = "/tmp/stiffaxis-child-XXXXXX", old[64];
    numbers n;
    CHECK(mkdtemp(folder) != NULL);
    (void)snprintf(old, sizeof old, "%s/old", folder);
    FILE *f = fopen(old, "w");
    CHECK(f && fputs("x", f) >= 0);
    if (f) {
        (void)fclose(f);
    }
    CHECK_OK(run(break_out, folder, &n));
    CHECK(n.count == 2 && n.value[0] == 0 && n.value[1] == 1);
    const child_job job = job_for(break_out, NULL);
    child_answer_free(&job, &n);
    struct stat about;
    CHECK(stat(old, &about) == 0 && about.st_size == 1);
    CHECK(remove(old) == 0 && rmdir(folder) == 0); // nothing else is there
}

static status take_memory(void *request, void *answer)
{
    (void)answer;
    return malloc(*(size_t *)request) ? OK : status_fail(ERR_RESOURCE, "no memory");
}

static void memory_has_an_end(void)
{
    size_t size = (size_t)100 << 20;
    numbers n;
    child_job job = job_for(take_memory, &size);
    job.memory = (size_t)200 << 20;
    CHECK_OK(child_run(&job, &n));
    child_answer_free(&job, &n);
    size *= 3;
    status_clear();
    CHECK(child_run(&job, &n) != OK);
}

int main(void)
{
    an_answer_comes_back_whole();
    what_goes_wrong_has_its_status();
    a_sealed_child_leaves_no_trace();
    memory_has_an_end();
    return test_failures != 0;
}
