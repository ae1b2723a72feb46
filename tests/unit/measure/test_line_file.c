// measure/line_file.h: what is no measured line is told with its file and line.
#include "measure/line_file.h"

#include "tests/test.h"

#include <string.h>
#include <unistd.h>

static char folder[] = "/tmp/line_file_XXXXXX";

static bool made;

static status read_text(const char *text, centreline *out)
{
    char path[64];
    (void)snprintf(path, sizeof path, "%s/a.csv", folder);
    FILE *f = fopen(path, "w");
    (void)fputs(text, f);
    (void)fclose(f);
    made = false;
    return line_file_read(folder, &(key_text){"a.csv", {3, 7}}, 0.12, out, &made);
}

static void refused(const char *text, const char *words)
{
    centreline c = {0};
    CHECK(read_text(text, &c) == ERR_FILE);
    if (!strstr(status_message(), words)) {
        test_failures++;
        printf("'%s' does not say '%s'\n", status_message(), words);
    }
    status_clear();
    centreline_free(&c);
}

static void a_line_is_read_in_its_units(void)
{
    centreline c = {0};
    CHECK_OK(read_text("# made\nz_cm,x_mm,note_mm,s_m,y_um,sigma_um\n"
                       "0,0,7,0,0,50\n6,1,7,0.06,2000,\n12,3,7,0.12,0,60\n",
                       &c));
    CHECK(c.count == 3);
    CHECK_NEAR(c.s[1], 0.06, 1e-15);
    CHECK_NEAR(c.p[1].a[0], 1e-3, 1e-15);
    CHECK_NEAR(c.p[1].a[1], 2e-3, 1e-15);
    CHECK_NEAR(c.p[1].a[2], 0.06, 1e-15);
    CHECK_NEAR(c.sigma[0], 50e-6, 1e-15);
    CHECK(isnan(c.sigma[1]) && isnan(c.correlation_length));
    CHECK_NEAR(centreline_own_sigma(&c, 0), 50e-6, 1e-15); // none of its own is told
    CHECK(isnan(c.own[0]));
    centreline_free(&c);
    CHECK_OK(read_text("s_mm x_mm y_mm z_mm\n0 0 0 0\n120 0 0 120\n", &c));
    CHECK(c.count == 2 && isnan(c.sigma[0]) && !made);
    centreline_free(&c);
    CHECK_OK(read_text("s_mm,x_mm,y_mm,z_mm,sigma_mm,fit_sigma_mm\n0,0,0,0,0.2,0.01\n"
                       "120,0,0,120,0.3,0.02\n",
                       &c));
    CHECK_NEAR(c.sigma[1], 3e-4, 1e-15);
    CHECK_NEAR(centreline_own_sigma(&c, 1), 2e-5, 1e-15);
    centreline_free(&c);
    CHECK_OK(read_text("# Synthetic: computed\ns_mm x_mm y_mm z_mm\n0 0 0 0\n120 0 0 120\n", &c));
    CHECK(made);
    centreline_free(&c);
    CHECK_OK(read_text("s_mm,x_mm,y_mm,z_mm\r\n# the frame is free in its turn about z\r\n"
                       "# correlation_length_mm: 4.7\r\n0,0,0,0\r\n120,0,0,120\r\n",
                       &c));
    CHECK(c.turn_free && !made && c.count == 2);
    CHECK_NEAR(c.correlation_length, 4.7e-3, 1e-15);
    centreline_free(&c);
    refused("# correlation_length_mm: -1\ns_mm,x_mm,y_mm,z_mm\n0,0,0,0\n120,0,0,120\n",
            "correlation length");
}

static void what_is_none_is_refused(void)
{
    refused("", "a.csv");
    refused("s_mm,x_mm,y_mm,z_mm\n0,0,0,0\n", "two or more");
    refused("s_mm,x_mm,y_mm,z_mm\n0,0,0,0\n60,0,,60\n120,0,0,120\n", "a.csv:3: a measured line");
    refused("s_mm,x_mm,y_mm,z_mm\n0,0,0,0\n60,0,nan,60\n120,0,0,120\n", "a.csv:3");
    refused("s_mm,x_mm,y_mm,z_mm\n0,0,0,0\n60,0,0,60\n60,0,0,120\n", "a.csv:4: s does not ascend");
    refused("s_mm,x_mm,y_mm,z_mm\n-1,0,0,0\n60,0,0,60\n", "a.csv:2: s = -1 mm");
    refused("s_m,x_mm,y_mm,z_mm\n0,0,0,0\n60,0,0,60\n120,0,0,120\n", "is its unit right");
    refused("s_um,x_mm,y_mm,z_mm\n0,0,0,0\n60,0,0,60\n120,0,0,120\n", "is its unit right");
    refused("s_mm,x_m,y_m,z_m\n0,0,0,0\n60,0,0,60\n120,0,0,120\n", "right units");
    refused("s_mm,x_um,y_um,z_um\n0,0,0,0\n60,0,0,60\n120,0,0,120\n", "right units");
    refused("s,x,y,z\n0,0,0,0\n60,0,0,60\n120,0,0,120\n", "unit");
    refused("s_mm,x_mm,y_mm\n0,0,0\n60,0,0\n120,0,0\n", "z");
    refused("s_mm,x_mm,y_mm,z_mm,sigma_mm\n0,0,0,0,1\n60,0,0,60,-1\n120,0,0,120,1\n", "negative");
    refused("1,2,3,4,5,6,7,8,9,10\n1,2,3,4,5,6,7,8,9,10\n", "a.csv");
}

int main(void)
{
    if (!mkdtemp(folder)) {
        return 1;
    }
    a_line_is_read_in_its_units();
    what_is_none_is_refused();
    char path[64];
    (void)snprintf(path, sizeof path, "%s/a.csv", folder);
    (void)unlink(path);
    (void)rmdir(folder);
    return test_failures != 0;
}
