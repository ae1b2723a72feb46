// tests/unit/io/test_expression.c
#include "io/expression.h"
#include "tests/test.h"

#include <string.h>
#include <time.h>

static const double PI = 3.14159265358979323846;

static const expression_scope along_the_rod = {
    .has_L = true, .has_s = true, .L = 0.12, .no_L = "no length", .no_s = "does not vary"};

static double value_of(const char *text)
{
    calculator *c = NULL;
    expression_error error = {0};
    double value = NAN;
    CHECK_OK(calculator_make(&c));
    if (expression_value(c, text, &along_the_rod, &value, &error) != OK) {
        printf("%s: %d: %s\n", text, error.position, error.words);
    }
    calculator_free(c);
    return value;
}

static void plain_numbers_are_read_as_c_reads_them(void)
{
    static const char *const numbers[] = {"0",     "4",       "-4",  "+4",
                                          "3.2",   ".5",      "5.",  "1e3",
                                          "1E-3",  "-1.5e+2", "0.1", "123456789.123456789",
                                          "5e-324"};
    for (size_t i = 0; i < sizeof numbers / sizeof *numbers; i++) {
        CHECK(value_of(numbers[i]) == strtod(numbers[i], NULL));
    }
}

static void arithmetic_follows_the_usual_rules(void)
{
    CHECK_NEAR(value_of("pi/8"), PI / 8, 1e-15);
    CHECK_NEAR(value_of("2+3*4^2"), 50, 1e-15);
    CHECK_NEAR(value_of("-2^2"), -4, 1e-15);
    CHECK_NEAR(value_of("2^3^2"), 512, 1e-15);
    CHECK_NEAR(value_of("(1 + 2) * 3"), 9, 1e-15);
    CHECK_NEAR(value_of("1/3"), 1.0 / 3, 1e-15);
    CHECK_NEAR(value_of("L/2"), 0.06, 1e-15);
    CHECK_NEAR(value_of("1 - -1"), 2, 1e-15);
    CHECK_NEAR(value_of("L > 0.1 ? 2 : 3"), 2, 1e-15);
}

static void functions_are_those_of_c(void)
{
    CHECK_NEAR(value_of("sin(0.3)"), sin(0.3), 1e-15);
    CHECK_NEAR(value_of("cos(pi/3)"), cos(PI / 3), 1e-15);
    CHECK_NEAR(value_of("atan2(1, -2)"), atan2(1, -2), 1e-15);
    CHECK_NEAR(value_of("sqrt(2) + exp(1)"), sqrt(2) + exp(1), 1e-15);
    CHECK_NEAR(value_of("log(2)"), log(2), 1e-15); // natural, as ln
    CHECK_NEAR(value_of("ln(2)"), log(2), 1e-15);
    CHECK_NEAR(value_of("log10(1000)"), 3, 1e-15);
    CHECK_NEAR(value_of("min(3, 1, 2) + max(1, 5)"), 6, 1e-15);
    CHECK_NEAR(value_of("abs(-2) + sign(-3) + rint(1.6)"), 3, 1e-15);
    CHECK_NEAR(value_of("sum(1, 2, 3) / avg(1, 3)"), 3, 1e-15);
}

static void an_expression_in_s_is_compiled_once(void)
{
    calculator *c = NULL;
    expression_error error = {0};
    const expression *turn = NULL, *wave = NULL;
    CHECK_OK(calculator_make(&c));
    CHECK_OK(expression_compile(c, "pi*s/L", &along_the_rod, &turn, &error));
    CHECK_OK(expression_compile(c, "1 + sin(2*pi*s/L)^2", &along_the_rod, &wave, &error));
    for (int i = 0; i <= 10; i++) {
        const double s = 0.012 * i, sine = sin(2 * PI * s / 0.12);
        CHECK_WITHIN(expression_at(turn, s), PI * s / 0.12, 1e-15);
        CHECK_NEAR(expression_at(wave, s), 1 + sine * sine, 1e-14);
    }
    calculator_free(c);
    calculator_free(NULL);
}

static void s_is_found_as_a_name_only(void)
{
    CHECK(expression_uses("pi*s/L", 's') && expression_uses("s", 's') &&
          expression_uses("2*(s)", 's') && expression_uses("3*y", 'y'));
    CHECK(!expression_uses("sin(L)", 's') && !expression_uses("abs(pi)", 's') &&
          !expression_uses("s1+as", 's') && !expression_uses("", 's') &&
          !expression_uses("exp(max(1,2))", 'x'));
}

static void wrong_arithmetic_is_shown_where_it_is_wrong(void)
{
    static const struct {
        const char *text;
        int position;
        const char *words;
    } wrong[] = {
        {"", 0, "nothing to compute"},
        {"1+", 2, "ends too early"},
        {"1*/2", 2, "an operator where"},
        {"1 2", 2, "operator is missing"},
        {"2pi", 1, "operator is missing"},
        {"2 sin(1)", 2, "operator is missing"},
        {"sin", 3, "wants parentheses"},
        {"sin 1", 4, "wants parentheses"},
        {"sin()", 4, "too few"},
        {"atan2(1)", 7, "too few"},
        {"()", 1, "parenthesis"},
        {"(1", 2, "')' is missing"},
        {"1)", 1, "')' without '('"},
        {"1,2", 1, "one number is wanted"},
        {"(1,2)", 2, "outside of a function"},
        {"min(1,(2,3))", 8, "outside of a function"},
        {"s=1", 1, "nothing is assigned"},
        {"1 == = 2", 5, "nothing is assigned"},
        {"\"text\"", 0, "'\"' cannot stand"},
        {"1 & 2", 2, "'&' cannot stand"},
        {"1;2", 1, "';' cannot stand"},
        {"0x10", 1, "operator is missing before 'x10'"},
        {"#ff", 0, "'#' cannot stand"},
        {"1..2", 2, "operator is missing"},
        {"e", 0, "unknown name 'e'"},
        {"_pi", 0, "unknown name '_pi' in arithmetic (did you mean 'pi'?)"},
        {"l/2", 0, "did you mean 'L'?"},
        {"sqr(2)", 0, "did you mean 'sqrt'?"},
        {"rnd()", 0, "unknown name"},
        {"system(1)", 0, "unknown name 'system'"},
        {"1 ? 2", 0, "'? :' is not complete"},
    };
    calculator *c = NULL;
    CHECK_OK(calculator_make(&c));
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        expression_error error = {.position = -1};
        double value = 0;
        const status st = expression_value(c, wrong[i].text, &along_the_rod, &value, &error);
        if (st != ERR_INPUT || error.position != wrong[i].position ||
            !strstr(error.words, wrong[i].words)) {
            test_failures++;
            printf("%s: got %d at %d: %s\n", wrong[i].text, st, error.position, error.words);
        }
        CHECK(value_of("1+1") == 2); // and a mistake leaves nothing behind
    }
    calculator_free(c);
}

static void names_that_are_not_known_yet_say_why(void)
{
    const expression_scope nothing = {.no_L = "the length comes first", .no_s = "it does not vary"};
    calculator *c = NULL;
    expression_error error = {0};
    double value = 0;
    CHECK_OK(calculator_make(&c));
    CHECK_OK(expression_value(c, "2*L", &along_the_rod, &value, &error));
    CHECK(expression_value(c, "2*L", &nothing, &value, &error) == ERR_INPUT);
    CHECK(error.position == 2 && strstr(error.words, "the length comes first"));
    CHECK(expression_value(c, "2+s", &nothing, &value, &error) == ERR_INPUT);
    CHECK(error.position == 2 && strstr(error.words, "it does not vary"));
    calculator_free(c);
}

// a field stands in loops over stations: an evaluation is some 20 ns, and 20 times that on a busy
// machine is still right
static void evaluation_is_fast(void)
{
    calculator *c = NULL;
    expression_error error = {0};
    const expression *e = NULL;
    double sum = 0;
    CHECK_OK(calculator_make(&c));
    CHECK_OK(expression_compile(c, "pi/4 - (pi/8)*(s/L)", &along_the_rod, &e, &error));
    const int n = 200000;
    const clock_t start = clock();
    for (int i = 0; i < n; i++) {
        sum += expression_at(e, 0.12 * i / n);
    }
    const double ns = 1e9 * (double)(clock() - start) / CLOCKS_PER_SEC / n;
    printf("%.1f ns for one evaluation\n", ns);
    CHECK(ns < 400);
    CHECK_NEAR(sum / n, PI / 4 - PI / 16, 1e-5);
    calculator_free(c);
}

int main(void)
{
    plain_numbers_are_read_as_c_reads_them();
    arithmetic_follows_the_usual_rules();
    functions_are_those_of_c();
    an_expression_in_s_is_compiled_once();
    s_is_found_as_a_name_only();
    wrong_arithmetic_is_shown_where_it_is_wrong();
    names_that_are_not_known_yet_say_why();
    evaluation_is_fast();
    return test_failures != 0;
}
