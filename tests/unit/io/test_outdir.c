// tests/unit/io/test_outdir.c
#include "io/outdir.h"

#include "tests/unit/io/scratch.h"

#include <signal.h>
#include <sys/wait.h>

// one file with the text given, in the directory being written
static void write_file(const outdir *d, const char *name, const char *text)
{
    char path[4096];
    CHECK_OK(outdir_path(d, name, path, sizeof path));
    write_whole(path, text, strlen(text));
}

static void write_results(const char *path, bool force, const char *text)
{
    outdir *d = NULL;
    CHECK_OK(outdir_open(path, force, &d));
    if (d) {
        write_file(d, "result.txt", text);
        CHECK_OK(outdir_commit(d));
    }
}

static bool holds(const char *dir, const char *name, const char *wanted)
{
    char path[1024];
    size_t size = 0;
    (void)snprintf(path, sizeof path, "%s/%s", dir, name);
    char *text = read_whole(path, &size);
    const bool same = text && strcmp(text, wanted) == 0;
    free(text);
    return same;
}

static void refuse(const char *path, bool force, const char *words)
{
    outdir *d = NULL;
    CHECK(outdir_open(path, force, &d) == ERR_INPUT);
    CHECK(d == NULL);
    CHECK(strstr(status_message(), words) != NULL);
    status_clear();
}

static void a_new_directory_appears_at_the_end_only(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "a/b/out");
    outdir *d = NULL;
    CHECK_OK(outdir_open(path.text, false, &d));
    write_file(d, "result.txt", "one");
    CHECK(!exists(path.text));
    CHECK_OK(outdir_commit(d));
    CHECK(holds(path.text, "result.txt", "one"));
    CHECK(count_entries(scratch_file(dir, "a/b").text, "out") == 1);
}

static void an_existing_one_is_replaced_by_force_only(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "again");
    write_results(path.text, false, "one");
    refuse(path.text, false, "--force");
    CHECK(holds(path.text, "result.txt", "one"));

    write_results(scratch_file(dir, "again/").text, true, "two");
    CHECK(holds(path.text, "result.txt", "two"));
    CHECK(count_entries(dir->path, "again") == 1);
}

static void what_others_wrote_is_never_replaced(const scratch *dir)
{
    const scratch_path theirs = scratch_file(dir, "theirs"), file = scratch_file(dir, "file"),
                       empty = scratch_file(dir, "empty"), link = scratch_file(dir, "link");
    CHECK(mkdir(theirs.text, 0777) == 0);
    write_whole(scratch_file(dir, "theirs/thesis.tex").text, "years", 5);
    refuse(theirs.text, true, "not written by this program");
    CHECK(holds(theirs.text, "thesis.tex", "years"));

    // a marker that is a link, or a directory, is no marker
    CHECK(symlink("thesis.tex", scratch_file(dir, "theirs/.stiffaxis").text) == 0);
    refuse(theirs.text, true, "not written by this program");

    write_whole(file.text, "x", 1);
    refuse(file.text, true, "not a directory");
    CHECK(mkdir(empty.text, 0777) == 0);
    refuse(empty.text, false, "--force");
    write_results(empty.text, true, "one");
    CHECK(holds(empty.text, "result.txt", "one"));

    CHECK(symlink(empty.text, link.text) == 0);
    refuse(link.text, true, "symbolic link");
    refuse("", true, "a name of its own");
    refuse("/", true, "a name of its own");
    refuse(".", true, "a name of its own");
    refuse(scratch_file(dir, "..").text, true, "a name of its own");
}

// one foreign thing among our files keeps the whole directory
static void what_was_added_keeps_the_directory(const scratch *dir)
{
    const scratch_path out = scratch_file(dir, "mixed"), notes = scratch_file(dir, "mixed/notes"),
                       inner = scratch_file(dir, "mixed/inner"),
                       marker = scratch_file(dir, "mixed/.stiffaxis"),
                       ours = scratch_file(dir, "mixed/result.txt");
    write_results(out.text, false, "one");
    write_whole(notes.text, "mine", 4);
    refuse(out.text, true, "'notes' in it was not written by this program");
    CHECK(mkdir(inner.text, 0777) == 0);
    refuse(out.text, true, "'inner'"); // the first by name
    CHECK(unlink(notes.text) == 0 && rmdir(inner.text) == 0);
    CHECK(symlink("/etc/passwd", notes.text) == 0);
    refuse(out.text, true, "'notes'");
    CHECK(unlink(notes.text) == 0);

    // a name of ours that is a link or a directory now is not ours any more
    CHECK(unlink(ours.text) == 0 && symlink("/etc/passwd", ours.text) == 0);
    refuse(out.text, true, "'result.txt'");
    CHECK(unlink(ours.text) == 0 && mkdir(ours.text, 0777) == 0);
    refuse(out.text, true, "'result.txt'");
    CHECK(rmdir(ours.text) == 0);

    // and a marker with other words is no marker, though it lists everything
    write_whole(ours.text, "one", 3);
    write_whole(marker.text, "result.txt\n.stiffaxis\n", 22);
    refuse(out.text, true, "'.stiffaxis'");
    write_whole(marker.text, "", 0);
    refuse(out.text, true, "not written by this program");
    CHECK(holds(out.text, "result.txt", "one"));
}

static void removing_follows_no_link(const scratch *dir)
{
    const scratch_path kept = scratch_file(dir, "kept"), out = scratch_file(dir, "linked");
    CHECK(mkdir(kept.text, 0777) == 0 && mkdir(out.text, 0777) == 0);
    write_whole(scratch_file(dir, "kept/precious.txt").text, "yes", 3);
    CHECK(symlink(kept.text, scratch_file(dir, "linked/elsewhere").text) == 0);
    CHECK(symlink(scratch_file(dir, "kept/precious.txt").text,
                  scratch_file(dir, "linked/precious.txt").text) == 0);
    CHECK_OK(disk_remove_tree(out.text));
    CHECK(!exists(out.text));
    CHECK(holds(kept.text, "precious.txt", "yes"));
}

static void giving_up_leaves_what_was_there(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "given_up");
    outdir *d = NULL;
    write_results(path.text, false, "one");
    CHECK_OK(outdir_open(path.text, true, &d));
    write_file(d, "result.txt", "two");
    outdir_abandon(d);
    outdir_abandon(NULL);
    CHECK(holds(path.text, "result.txt", "one"));
    CHECK(count_entries(dir->path, "given_up") == 1);
}

// something that came while we were at work is not overwritten
static void a_late_comer_is_respected(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "late");
    outdir *d = NULL;
    CHECK_OK(outdir_open(path.text, false, &d));
    write_file(d, "result.txt", "ours");
    CHECK(mkdir(path.text, 0777) == 0);
    write_whole(scratch_file(dir, "late/result.txt").text, "theirs", 6);
    CHECK(outdir_commit(d) == ERR_INPUT);
    status_clear();
    CHECK(holds(path.text, "result.txt", "theirs"));
    CHECK(count_entries(dir->path, "late") == 1);
}

static void a_killed_run_leaves_the_target_alone(const scratch *dir)
{
    const scratch_path path = scratch_file(dir, "killed");
    write_results(path.text, false, "one");
    const pid_t child = fork();
    if (child == 0) {
        outdir *d = NULL;
        if (outdir_open(path.text, true, &d) == OK) {
            write_file(d, "result.txt", "half");
            (void)raise(SIGKILL);
        }
        _exit(1);
    }
    int how = 0;
    CHECK(waitpid(child, &how, 0) == child && WIFSIGNALED(how) && WTERMSIG(how) == SIGKILL);
    CHECK(holds(path.text, "result.txt", "one"));
    write_results(path.text, true, "two");
    CHECK(holds(path.text, "result.txt", "two"));
}

static void names_inside_are_plain(const scratch *dir)
{
    char path[4096];
    outdir *d = NULL;
    CHECK_OK(outdir_open(scratch_file(dir, "names").text, false, &d));
    const char *wrong[] = {"", ".", "..", "../x", "a/b", "/etc/passwd", ".stiffaxis"};
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        CHECK(outdir_path(d, wrong[i], path, sizeof path) == ERR_BUG);
        status_clear();
    }
    CHECK(outdir_path(d, "result.hdf", path, 10) == ERR_INPUT);
    status_clear();
    outdir_abandon(d);
}

int main(void)
{
    const scratch dir = scratch_make();
    a_new_directory_appears_at_the_end_only(&dir);
    an_existing_one_is_replaced_by_force_only(&dir);
    what_others_wrote_is_never_replaced(&dir);
    what_was_added_keeps_the_directory(&dir);
    removing_follows_no_link(&dir);
    giving_up_leaves_what_was_there(&dir);
    a_late_comer_is_respected(&dir);
    a_killed_run_leaves_the_target_alone(&dir);
    names_inside_are_plain(&dir);
    scratch_remove(&dir);
    return test_failures != 0;
}
