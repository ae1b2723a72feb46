// app/cmd_doctor.c
// stiffaxis doctor: uses every library once on a small problem and tells its version, or why it
// does not work.
#include "app/doctor.h"
#include "app/document.h"
#include "app/interrupt.h"
#include "base/door.h"
#include "io/disk.h"
#include "io/json.h"

#include <stdlib.h>
#include <string.h>
#include <unistd.h>

// "CHOLMOD 3.0.14, OpenBLAS 0.3.21"; whether all of them are there
static bool name_libraries(const patient *p, const doctor_step *one, char *text, size_t size)
{
    size_t used = 0;
    bool all = one->nlibrary > 0;
    text[0] = '\0';
    for (int i = 0; i < one->nlibrary && used < size; i++) {
        char version[64] = "is not loaded";
        all = library_version(one->library[i], version, sizeof version) && all;
        used += (size_t)snprintf(text + used, size - used, "%s%s %s", i ? ", " : "",
                                 library_name(one->library[i]), version);
    }
    if (one->nlibrary == 0) {
        (void)snprintf(text, size, "%s", p->told);
    }
    return all;
}

// What came of a step, in words.
typedef struct verdict {
    char versions[256], why[1024]; // why it does not work; "" where it does
    const char *get;               // what brings what is missing; "" where nothing is
} verdict;

static void write_step(json *j, FILE *stream, const doctor_step *one, const verdict *v)
{
    const bool works = v->why[0] == '\0';
    if (!j) {
        const char *word = works ? "works" : one->needed ? "FAILS" : "missing";
        fprintf(stream, "%-26s %-*s", one->what, works && !v->versions[0] ? 0 : 9, word);
        fprintf(stream, "%s%s%s\n", v->versions, works || !v->versions[0] ? "" : ": ", v->why);
        if (v->get[0]) {
            fprintf(stream, "%-36sapt-get install %s\n", "", v->get);
        }
        return;
    }
    json_object(j, NULL);
    json_text(j, "what", one->what);
    json_text(j, "versions", v->versions);
    json_flag(j, "works", works);
    json_flag(j, "needed", one->needed);
    json_text(j, "message", v->why);
    json_text(j, "get", v->get);
    json_object_end(j);
}

// tries every step; *failed counts the needed ones that do not work
static void try_steps(patient *p, json *j, FILE *stream, int *failed)
{
    for (const doctor_step *one = doctor_steps; one->what && !interrupt_pending(); one++) {
        verdict v = {.get = ""};
        command_progress(p->cmd, one->what);
        p->told[0] = '\0';
        const bool works = one->try_it(p) == OK;
        if (!works) {
            (void)snprintf(v.why, sizeof v.why, "%s", status_message());
            char *hint = strstr(v.why, DOOR_HINT); // to here
            if (hint) {
                *hint = '\0';
            }
            status_clear();
            *failed += one->needed;
            p->told[0] = '\0';
        }
        if (!name_libraries(p, one, v.versions, sizeof v.versions) && !works && one->get) {
            v.get = one->get;
        }
        write_step(j, stream, one, &v);
    }
}

static status write_doctor(patient *p, FILE *stream, int *failed)
{
    status st = OK;
    json *j = NULL;
    if (p->cmd->json) {
        TRY(json_open(stream, &j));
        json_object(j, NULL);
        json_text(j, "schema", "stiffaxis/doctor/1");
        json_text(j, "version", STIFFAXIS_VERSION);
        json_array(j, "parts");
    } else {
        fprintf(stream, "stiffaxis " STIFFAXIS_VERSION "\n");
    }
    try_steps(p, j, stream, failed);
    if (j) {
        json_array_end(j);
        json_flag(j, "good", *failed == 0);
        json_object_end(j);
        st = json_close(j);
    }

done:
    return st;
}

static status make_directory(patient *p)
{
    const char *place = getenv("TMPDIR");
    (void)snprintf(p->directory, sizeof p->directory, "%.3000s/stiffaxis-doctor-XXXXXX",
                   place && place[0] == '/' ? place : "/tmp");
    if (!mkdtemp(p->directory)) {
        p->directory[0] = '\0';
        return status_fail(ERR_RESOURCE, "cannot make a temporary directory in %s",
                           place ? place : "/tmp");
    }
    return OK;
}

status cmd_doctor(command *cmd)
{
    status st = OK;
    document d = {0};
    patient *p = calloc(1, sizeof *p);
    int failed = 0;
    if (!p) {
        return status_fail(ERR_RESOURCE, "out of memory");
    }
    p->cmd = cmd;
    interrupt_hold(); // so that the directory does not stay behind
    TRY(make_directory(p));
    TRY(document_begin(&d));
    TRY(write_doctor(p, d.stream, &failed));
    TRY(document_end(&d, cmd, cmd->json ? "doctor.json" : "doctor.txt"));
    if (failed) {
        st = status_fail(ERR_RESOURCE, "%d of the parts that are needed do not work", failed);
    }

done:
    if (p->directory[0]) {
        (void)disk_remove_tree(p->directory);
    }
    document_free(&d);
    run_result_free(&p->r);
    case_free(&p->c);
    free(p);
    const status interrupted = interrupt_release();
    return interrupted != OK ? interrupted : st;
}
