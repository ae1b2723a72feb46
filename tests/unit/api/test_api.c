// tests/unit/api/test_api.c
#include "api/stiffaxis.h"
#include "tests/test.h"

#include <pthread.h>
#include <string.h>

static const char text[] =
    "format: 1\n"
    "title: two tendons\n"
    "materials:\n"
    "  soft:  {E_MPa: 0.66, nu: 0.3}\n"
    "  stiff: {E_MPa: 15.93, nu: 0.3}\n"
    "section:\n"
    "  model: classical\n"
    "  shapes:\n"
    "    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3.2}, material: soft}\n"
    "    - {sector: {outer_radius_mm: 4, inner_radius_mm: 3.2, mid_angle_rad: pi, "
    "width_rad: pi/8}, material: stiff}\n"
    "rod:\n"
    "  length_mm: 120\n"
    "  tendons:\n"
    "    - {name: t1, radius_mm: 3.6, angle_rad: 0}\n"
    "    - {radius_mm: 3.6, angle_rad: pi}\n"
    "  tensions_N: [[0.49, 0], [0, 0.67]]\n";

static stiffaxis_rod *make_rod(int nsetting, const char *const *settings)
{
    stiffaxis_case *c = NULL;
    stiffaxis_section *section = NULL;
    stiffaxis_rod *rod = NULL;
    CHECK(stiffaxis_case_read(text, "two.yaml", 0, NULL, 0, &c) == STIFFAXIS_OK);
    CHECK(stiffaxis_section_make(c, &section) == STIFFAXIS_OK);
    CHECK(stiffaxis_rod_make(section, nsetting, settings, &rod) == STIFFAXIS_OK);
    stiffaxis_case_free(c); // what was made from it keeps it
    stiffaxis_section_free(section);
    return rod;
}

// the paper's Eq. 18 for this tube: EA of both materials
static void the_section_is_the_closed_form(void)
{
    stiffaxis_case *c = NULL;
    stiffaxis_section *section = NULL;
    stiffaxis_station station = {0};
    double K[36], slope[36];
    const double ring = 4e-3 * 4e-3 - 3.2e-3 * 3.2e-3, width = 3.14159265358979323846 / 8;
    CHECK(stiffaxis_case_read(text, "two.yaml", 0, NULL, 0, &c) == STIFFAXIS_OK);
    CHECK(strcmp(stiffaxis_case_title(c), "two tendons") == 0);
    CHECK(stiffaxis_case_has_section(c) && stiffaxis_case_has_rod(c));
    CHECK(stiffaxis_section_make(c, &section) == STIFFAXIS_OK);
    CHECK(stiffaxis_section_station(section, 0, &station) == STIFFAXIS_OK);
    const double EA = ring * (0.66e6 * (8 * width - width / 2) + 15.93e6 * width / 2);
    CHECK_NEAR(station.EA / EA, 1, 1e-13); // sums of a few terms
    const double s = 0.05;
    CHECK(stiffaxis_section_at(section, 1, &s, K, slope) == STIFFAXIS_OK);
    CHECK(memcmp(K, station.K, sizeof K) == 0); // it does not vary
    CHECK(slope[14] == 0);
    CHECK(stiffaxis_section_station(section, stiffaxis_section_count(section), &station) ==
          STIFFAXIS_INPUT);
    CHECK(strstr(stiffaxis_error(), "station"));
    stiffaxis_section_free(section);
    stiffaxis_case_free(c);
}

static void a_state_outlives_what_it_was_made_from(void)
{
    stiffaxis_rod *rod = make_rod(0, NULL);
    stiffaxis_state *state = NULL;
    stiffaxis_solution answer = {0};
    double tension[2], pull[2], end[3];
    char name[16];
    CHECK(stiffaxis_state_make(rod, &state) == STIFFAXIS_OK);
    CHECK(stiffaxis_shape(state, 1, NULL, end, NULL) == STIFFAXIS_INPUT); // there is no answer
    stiffaxis_case_free(NULL);
    CHECK(strstr(stiffaxis_error(), "before a solution")); // what is freed takes no words along
    CHECK(stiffaxis_rod_solutions(rod) == 2 && stiffaxis_rod_loads(rod) == 0);
    CHECK(stiffaxis_rod_solution(rod, 1, tension, pull, NULL) == STIFFAXIS_OK);
    CHECK(tension[1] == 0.67 && pull[1] != pull[1]);
    CHECK(stiffaxis_rod_tendon_name(rod, 1, name, sizeof name) == STIFFAXIS_OK);
    CHECK(strcmp(name, "tendon 2") == 0);
    CHECK(stiffaxis_rod_tendon_name(rod, 1, name, 8) == STIFFAXIS_INPUT);
    CHECK(stiffaxis_rod_tendon_name(rod, 2, name, sizeof name) == STIFFAXIS_INPUT);
    stiffaxis_rod_free(rod);

    const stiffaxis_request request = {.tension = tension, .pull = pull};
    CHECK(stiffaxis_solve(state, &request, &answer) == STIFFAXIS_OK);
    CHECK(stiffaxis_shape(state, 1, NULL, end, NULL) == STIFFAXIS_OK);
    CHECK(memcmp(end, answer.tip_position, sizeof end) == 0);
    tension[0] = -1;
    CHECK(stiffaxis_solve(state, &request, &answer) == STIFFAXIS_INPUT);
    CHECK(stiffaxis_error()[0] != '\0');
    CHECK(stiffaxis_shape(state, 1, NULL, end, NULL) == STIFFAXIS_INPUT); // nor after a failure
    CHECK(stiffaxis_along(state, 1, NULL, NULL, NULL, NULL) == STIFFAXIS_INPUT);
    CHECK(stiffaxis_derive(state, 0, &(stiffaxis_derivatives){0}) == STIFFAXIS_INPUT);
    stiffaxis_state_free(state);
}

// Which number belongs where, by central differences of the tip; verify_rod_derivatives holds how
// exact they are.
static void derivatives_are_those_of_the_tip(void)
{
    stiffaxis_rod *rod = make_rod(0, NULL);
    stiffaxis_state *state = NULL;
    stiffaxis_solution answer = {0}, plus = {0}, minus = {0};
    double tension[2] = {0.49, 0.1}, rate[2][6];
    const double h = 1e-5;
    const stiffaxis_request request = {.tension = tension};
    CHECK(stiffaxis_state_make(rod, &state) == STIFFAXIS_OK);
    CHECK(stiffaxis_solve(state, &request, &answer) == STIFFAXIS_OK);
    CHECK(stiffaxis_derive(state, 0.12, &(stiffaxis_derivatives){.tension = rate[0]}) ==
          STIFFAXIS_OK);
    tension[0] += h;
    CHECK(stiffaxis_solve(state, &request, &plus) == STIFFAXIS_OK);
    tension[0] -= 2 * h;
    CHECK(stiffaxis_solve(state, &request, &minus) == STIFFAXIS_OK);
    for (int i = 0; i < 3; i++) {
        double moved = 0;
        for (int j = 0; j < 3; j++) {
            moved += answer.tip_rotation[i][j] * rate[0][j];
        }
        const double slope = (plus.tip_position[i] - minus.tip_position[i]) / (2 * h);
        CHECK_WITHIN(moved, slope, 1e-8 * 0.2); // ten times the rod's tolerance
    }
    stiffaxis_state_free(state);
    stiffaxis_rod_free(rod);
}

static void settings_make_another_rod(void)
{
    const char *longer[] = {"rod.length_mm=200"}, *wrong[] = {"rod.lengthmm=200"};
    stiffaxis_rod *rod = make_rod(1, longer);
    stiffaxis_case *c = NULL;
    CHECK_NEAR(stiffaxis_rod_length(rod), 0.2, 1e-16);
    stiffaxis_rod_free(rod);
    CHECK(stiffaxis_case_read(text, "two.yaml", 1, wrong, 0, &c) == STIFFAXIS_INPUT);
    CHECK(strstr(stiffaxis_error(), "did you mean 'length_mm'?") && !c);
    CHECK(stiffaxis_case_read("format: 1\nmaterials: [\n", "bad.yaml", 0, NULL, 0, &c) ==
          STIFFAXIS_INPUT);
    CHECK(strncmp(stiffaxis_error(), "bad.yaml:", 9) == 0 && !c);
    CHECK(stiffaxis_case_open("/nowhere/case.yaml", 0, NULL, 0, &c) == STIFFAXIS_INPUT);
    stiffaxis_case_free(NULL);
}

// --- threads

static void *solve_alone(void *tip)
{
    stiffaxis_rod *rod = make_rod(0, NULL);
    stiffaxis_state *state = NULL;
    stiffaxis_solution answer = {0};
    const double tension[2] = {0.49, 0};
    CHECK(stiffaxis_state_make(rod, &state) == STIFFAXIS_OK);
    CHECK(stiffaxis_solve(state, &(stiffaxis_request){.tension = tension, .cold = 1}, &answer) ==
          STIFFAXIS_OK);
    memcpy(tip, answer.tip_position, sizeof answer.tip_position);
    stiffaxis_state_free(state);
    stiffaxis_rod_free(rod);
    return NULL;
}

static void threads_find_the_same(void)
{
    pthread_t thread[4];
    double tip[4][3], position[2][3];
    int outcome[2];
    for (int i = 0; i < 4; i++) {
        CHECK(pthread_create(&thread[i], NULL, solve_alone, tip[i]) == 0);
    }
    for (int i = 0; i < 4; i++) {
        CHECK(pthread_join(thread[i], NULL) == 0);
        CHECK(memcmp(tip[i], tip[0], sizeof tip[0]) == 0);
    }
    const double rows[2][2] = {{0.49, 0}, {-1, 0}};
    stiffaxis_rod *rod = make_rod(0, NULL);
    CHECK(stiffaxis_batch(rod, 2, 2, rows[0], NULL, position[0], NULL, outcome) == STIFFAXIS_OK);
    CHECK(memcmp(position[0], tip[0], sizeof tip[0]) == 0 && outcome[0] == STIFFAXIS_OK);
    CHECK(outcome[1] == STIFFAXIS_INPUT && position[1][0] != position[1][0]);
    stiffaxis_rod_free(rod);
}

int main(void)
{
    the_section_is_the_closed_form();
    a_state_outlives_what_it_was_made_from();
    derivatives_are_those_of_the_tip();
    settings_make_another_rod();
    threads_find_the_same();
    return test_failures != 0;
}
