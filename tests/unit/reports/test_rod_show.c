#include "reports/figure_rod_style.h"
#include "tests/test.h"
#include "tests/unit/reports/synthetic.h"

// n solutions of two tendons and one load without any shape
static rod_result bare(int n)
{
    rod_result rod = {0};
    const rod_result sizes = {.ntendon = 2, .npoint = 2, .nload = 1, .nsolution = n};
    CHECK_OK(rod_result_make(&sizes, &rod));
    (void)snprintf(rod.tendon_name[0], RESULT_NAME, "a");
    (void)snprintf(rod.tendon_name[1], RESULT_NAME, "b");
    (void)snprintf(rod.load_name[0], RESULT_NAME, "weight");
    for (int i = 0; i < n; i++) {
        rod.run[i].pull[0] = rod.run[i].pull[1] = NAN;
        rod.run[i].load[0] = 1;
        rod.run[i].fraction = 1;
    }
    return rod;
}

static void release(rod_result *rod)
{
    run_result r = {.rod = *rod};
    run_result_free(&r);
    *rod = (rod_result){0};
}

static void a_grid_is_told_by_its_lines(void)
{
    rod_result rod = bare(30);
    rod_show s = {0};
    for (int i = 0; i < 30; i++) {
        rod.run[i].tension[0] = 0.1 * (i / 10);
        rod.run[i].tension[1] = 0.05 * (i % 10);
    }
    CHECK_OK(rod_show_make(&rod, &s));
    CHECK(s.sweep && s.nline == 3);
    for (int i = 0; i < s.nline; i++) {
        CHECK(s.line[i].first == 10 * i && s.line[i].count == 10);
        CHECK(s.line[i].lead.kind == GIVEN_TENSION && s.line[i].lead.index == 1);
    }
    CHECK(rod_show_line_of(&s, 0) == 0 && rod_show_line_of(&s, 9) == 0);
    CHECK(rod_show_line_of(&s, 10) == 1 && rod_show_line_of(&s, 29) == 2);
    CHECK(s.nshown == 24 && s.shown[0] == 0 && s.shown[23] == 29);
    rod_show_free(&s);
    release(&rod);
}

static void there_and_back_is_one_sweep(void)
{
    rod_result rod = bare(21);
    rod_show s = {0};
    for (int i = 0; i < 21; i++) {
        rod.run[i].load[0] = i <= 10 ? i : 20 - i;
    }
    CHECK_OK(rod_show_make(&rod, &s));
    CHECK(s.sweep && s.nline == 1 && s.factors_vary);
    CHECK(s.line[0].count == 21 && s.line[0].lead.kind == GIVEN_LOAD);
    rod_show_free(&s);
    release(&rod);
}

static void chance_is_no_sweep(void)
{
    rod_result rod = bare(40);
    rod_show s = {0};
    for (int i = 0; i < 40; i++) {
        rod.run[i].tension[0] = fmod(0.618 * (i + 1), 1);
        rod.run[i].tension[1] = fmod(0.755 * (i + 1), 1);
    }
    CHECK_OK(rod_show_make(&rod, &s));
    CHECK(!s.sweep && s.nshown == 40);
    rod_show_free(&s);
    release(&rod);
}

// a found tension is no given one: the pulled length is what is swept
static void pulled_lengths_lead_where_they_are_given(void)
{
    rod_result rod = bare(9);
    rod_show s = {0};
    char text[160];
    for (int i = 0; i < 9; i++) {
        rod.run[i].pull[0] = 1e-3 * i;
        rod.run[i].tension[0] = i > 3 ? 0.1 * i : 0;
    }
    CHECK_OK(rod_show_make(&rod, &s));
    CHECK(s.sweep && s.nline == 1 && s.line[0].lead.kind == GIVEN_PULL);
    CHECK_NEAR(rod_quantity_value(&rod.run[8], s.line[0].lead), 8, 1e-15); // mm
    rod_label(&s, 2, text, sizeof text);
    CHECK(strcmp(text, "a drawn 2 mm (slack)") == 0);
    rod_label(&s, 8, text, sizeof text);
    CHECK(strcmp(text, "a drawn 8 mm (0.8 N)") == 0);
    rod_show_free(&s);
    release(&rod);
}

static void labels_tell_factors_that_are_not_one(void)
{
    rod_result rod = bare(2);
    rod_show s = {0};
    char text[160];
    rod.run[0].tension[1] = 0.5;
    CHECK_OK(rod_show_make(&rod, &s));
    rod_label(&s, 0, text, sizeof text);
    CHECK(strcmp(text, "b 0.5 N") == 0);
    rod_label(&s, 1, text, sizeof text);
    CHECK(strcmp(text, "no tension") == 0);
    rod_show_free(&s);
    rod.run[1].load[0] = -2;
    CHECK_OK(rod_show_make(&rod, &s));
    rod_label(&s, 1, text, sizeof text);
    CHECK(strcmp(text, "no tension, weight ×−2") == 0);
    rod_show_free(&s);
    release(&rod);
}

static void many_solutions_are_sorted_soon(void)
{
    rod_result rod = bare(20000);
    rod_show s = {0};
    for (int i = 0; i < 20000; i++) {
        rod.run[i].tension[0] = fmod(0.618 * (i + 1), 1);
    }
    CHECK_OK(rod_show_make(&rod, &s));
    CHECK(s.nshown == 60 && s.shown[59] == 19999);
    char words[80];
    rod_show_words(&s, words, sizeof words);
    CHECK(strcmp(words, "60 of 20000 solutions, at equal steps") == 0);
    rod_show_free(&s);
    release(&rod);
}

static void long_curves_are_thinned_but_for_their_ends(void)
{
    static const int sizes[] = {2, 81, 501, 502, 20001};
    for (size_t i = 0; i < sizeof sizes / sizeof *sizes; i++) {
        const rod_result rod = {.npoint = sizes[i]};
        int count = 0, last = -1;
        for (int k = 0; k < rod.npoint; k = rod_next_point(&rod, k)) {
            CHECK(k > last);
            last = k;
            count++;
        }
        CHECK(last == rod.npoint - 1);
        CHECK(count <= 502 && (rod.npoint > 501 ? count > 200 : count == rod.npoint));
    }
}

int main(void)
{
    long_curves_are_thinned_but_for_their_ends();
    a_grid_is_told_by_its_lines();
    there_and_back_is_one_sweep();
    chance_is_no_sweep();
    pulled_lengths_lead_where_they_are_given();
    labels_tell_factors_that_are_not_one();
    many_solutions_are_sorted_soon();
    return test_failures != 0;
}
