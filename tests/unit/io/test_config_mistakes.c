// tests/unit/io/test_config_mistakes.c
// Every mistake gets one line with file, line and column, and ERR_INPUT.
#include "io/config.h"
#include "tests/test.h"
#include "tests/unit/io/case_file.h"

typedef struct mistake {
    const char *text;
    int line, column;
    const char
        *words; // the whole of the message behind "error: "; "..." at its end stands for anything
} mistake;

// what stands before a case that is about its rod, or about its section
#define BASE "format: 1\nmaterials: {}\n"
#define ROD BASE "rod:\n  length_mm: 120\n"
#define RING                                                                                       \
    BASE "rod: {length_mm: 120}\nsection:\n  shapes:\n    - material: soft\n      annulus: "       \
         "{inner_radius_mm: 1, "

static const mistake keys[] = {
    {BASE "rod:\n  lenght_mm: 120\n", 4, 3, "unknown key 'lenght_mm' (did you mean 'length_mm'?)"},
    {RING "outer_radus_mm: 4}\n", 7, 37,
     "unknown key 'outer_radus_mm' (did you mean 'outer_radius_mm'?)"},
    {RING "outer_radus: 4}\n", 7, 37,
     "unknown key 'outer_radus' (did you mean 'outer_radius_mm'?)"},
    {RING "outer_radius: 4}\n", 7, 37,
     "key 'outer_radius' needs its unit: outer_radius_mm, outer_radius_m, outer_radius_cm, "
     "outer_radius_um"},
    {RING "outer_radius_inch: 4}\n", 7, 37,
     "unknown unit 'inch' of key 'outer_radius'; known are outer_radius_mm, outer_radius_m, "
     "outer_radius_cm, "
     "outer_radius_um"},
    {RING "outer_radius_N: 4}\n", 7, 37, "unknown unit 'N' of key 'outer_radius'; known are ..."},
    {BASE "colour: red\n", 3, 1,
     "unknown key 'colour'; known here are format, title, materials, section, rod, loads"},
    {"format: 1\nmaterials:\n  soft: {E_MPa: 1, nu_mm: 0.3}\n", 3, 20,
     "key 'nu_mm' has no unit; write 'nu'"},
    {"format: 1\nmaterials:\n  soft: {E_MPa: 1, Nu: 0.3}\n", 3, 20,
     "unknown key 'Nu' (did you mean 'nu'?)"},
    {"format: 1\nmaterials:\n  soft: {E_mpa: 1, nu: 0.3}\n", 3, 10,
     "unknown unit 'mpa' of key 'E'; known are E_MPa, E_kPa, E_Pa, E_GPa"},
    {ROD "  length_mm: 130\n", 5, 3, "key 'length_mm' is given twice, first on line 4"},
    {ROD "  length_m: 0.13\n", 5, 3, "'length_mm' and 'length_m' are the same key, in two units"},
    {BASE "rod: {length_mm: 1}\nformat: 1\n", 4, 1, "key 'format' is given twice, first on line 1"},
    {"materials: {}\n", 1, 1, "key 'format' is missing in the case"},
    {BASE "rod:\n  points: 3\n", 4, 3, "key 'length_mm' is missing in 'rod'"},
    {"format: 1\nmaterials:\n  soft: {nu: 0.3}\n", 3, 9, "key 'E_MPa' is missing in 'soft'"},
    {BASE "section:\n  shapes:\n    - {annulus: {outer_radius_mm: 4, inner_radius_mm: 3}}\n", 5, 7,
     "key 'material' is missing in this entry of 'shapes'"},
    {BASE "section:\n  shapes:\n    - {material: soft}\n", 5, 7,
     "one of annulus, sector is missing in this entry of 'shapes'"},
    {RING "outer_radius_mm: 4}\n      sector: {outer_radius_mm: 4, inner_radius_mm: 3}\n", 8, 7,
     "'annulus' and 'sector' exclude each other"},
    {BASE "loads:\n  - {at: stiffness_centre, at_mm: [0, 0]}\n", 4, 28,
     "'at' and 'at_mm' exclude each other"},
    {BASE "bad\x1b[31mkey: 1\n", 3, 4, "the control character U+001B"},
    {BASE "Title: words\n", 3, 1, "unknown key 'Title' (did you mean 'title'?)"},
    {BASE "\"bad\\ekey\\n\": 1\n", 3, 1, "the control character U+001B in a text"},
    {BASE "\"badkey\\n\": 1\n", 3, 1, "unknown key 'badkey'; known here are ..."},
    {BASE "rod: {length_mm: 1}\n\"\": 1\n", 4, 1, "an empty key"},
};

static const mistake values[] = {
    {BASE "rod:\n  length_mm: long\n", 4, 14, "'length_mm': expected a number, found 'long'"},
    {BASE "rod:\n  length_mm: [1, 2]\n", 4, 14, "'length_mm': expected a number, found a list"},
    {BASE "rod:\n  length_mm: {a: 1}\n", 4, 14, "'length_mm': expected a number, found a map"},
    {BASE "rod:\n  length_mm:\n", 4, 13, "'length_mm': expected a number, found nothing"},
    {BASE "rod:\n  length_mm: 4 mm\n", 4, 16,
     "'length_mm': an operator is missing before 'mm': units stand in the key's name, numbers "
     "alone here"},
    {BASE "rod:\n  length_mm: 4,5\n", 4, 15,
     "'length_mm': ',' in arithmetic: one number is wanted, with a point for the decimals"},
    {BASE "rod:\n  length_mm: -120\n", 4, 14,
     "'length_mm': -120 mm is out of range, 0.001 mm to 10000 mm"},
    {BASE "rod:\n  length_m: 11\n", 4, 13, "'length_m': 11 m is out of range, 1e-06 m to 10 m"},
    {BASE "rod:\n  length_mm: 1e400\n", 4, 14, "'length_mm': this is not a finite number"},
    {BASE "rod:\n  length_mm: 1/0\n", 4, 14, "'length_mm': this is not a finite number"},
    {BASE "rod:\n  length_mm: .nan\n", 4, 14, "'length_mm': '.' cannot stand in arithmetic"},
    {BASE "rod:\n  length_mm: 2*L\n", 4, 16,
     "'length_mm': L is not known here: the length of the rod comes first"},
    {"format: 1\nmaterials:\n  soft: {E_MPa: 1, nu: 0.6}\n", 3, 24,
     "'nu': 0.6 is out of range, -0.999 to 0.4999"},
    {"format: 1\nmaterials:\n  soft: {E_MPa: -1, nu: 0.3}\n", 3, 17,
     "'E_MPa': -1 MPa is out of range, 1e-09 MPa to 1e+10 MPa"},
    {"format: 2\n", 1, 9, "'format': 2 is out of range, only 1 is known"},
    {ROD "  points: 10.5\n", 5, 11, "'points': expected a whole number, found '10.5'"},
    {ROD "  points: many\n", 5, 11, "'points': expected a number, found 'many'"},
    {ROD "  pictures: yes\n", 5, 13, "'pictures': expected true or false, found 'yes'"},
    {ROD "  pictures: 1\n", 5, 13, "'pictures': expected true or false, found '1'"},
    {BASE "section: {model: clasical, shapes: []}\n", 3, 18,
     "'model': expected one of full, classical, found 'clasical' (did you mean 'classical'?)"},
    {BASE "section: {model: beam, shapes: []}\n", 3, 18,
     "'model': expected one of full, classical, found 'beam'"},
    {BASE "section: {model: [full], shapes: []}\n", 3, 18,
     "'model': expected one of full, classical, found a list"},
    {BASE "title: [a, b]\n", 3, 8, "'title': expected a text, found a list"},
    {BASE "title:\nrod: {length_mm: 1}\n", 3, 7, "'title': expected a text, found nothing"},
    {BASE "loads: [{force_N: [0, 1]}]\n", 3, 19,
     "'force_N': expected a list of 3 numbers, found 2"},
    {BASE "loads: [{force_N: 0.5}]\n", 3, 19,
     "'force_N': expected a list of 3 numbers, found '0.5'"},
    {BASE "loads: [{force_N: [0, 0, up]}]\n", 3, 26, "'force_N': expected a number, found 'up'"},
    {BASE "loads: [{at_mm: [0, 0, 0]}]\n", 3, 17, "'at_mm': expected rows of 2, found a row of 3"},
    {BASE "loads: [{at_mm: [[0, 0], [1, 1]]}]\n", 3, 17,
     "'at_mm': 2 entries, at most 1 are allowed"},
    {ROD "  tensions_N: 0.5\n", 5, 15,
     "'tensions_N': expected a list of rows of numbers, found '0.5'"},
    {ROD "  tensions_N: [[1, 2], [3]]\n", 5, 24,
     "'tensions_N': expected rows of 2, found a row of 1"},
    {ROD "  tensions_N: [[1, 2], 3]\n", 5, 24,
     "'tensions_N': expected a row of numbers, [a, b, ...], found '3'"},
    {ROD "  tensions_N: [1, [2]]\n", 5, 19, "'tensions_N': expected a number, found a list"},
    {ROD "  tensions_N: []\n", 5, 15, "'tensions_N': the list is empty"},
    {ROD "  tensions_N: [[], []]\n", 5, 16,
     "'tensions_N': expected at least one number in a row, found a list"},
    {ROD "  tensions_N: [[1, -2]]\n", 5, 20, "'tensions_N': -2 N is out of range, 0 N at least"},
    {ROD "  tendons: {t1: 1}\n", 5, 12, "'tendons': expected a list, found a map"},
    {ROD "  tendons: [5]\n", 5, 13,
     "this entry of 'tendons': expected a map of keys, found a single value"},
    {BASE "rod: 5\n", 3, 6, "'rod': expected a map of keys, found a single value"},
    {BASE "rod:\nloads: []\n", 3, 5, "'rod': expected a map of keys, found nothing"},
    {"format: 1\nmaterials: [soft]\n", 2, 12, "'materials': expected a map of names, found a list"},
};

static const mistake arithmetic[] = {
    {RING "outer_radius_mm: 4*(1+q)}\n", 7, 59,
     "'outer_radius_mm': unknown name 'q' in arithmetic; known are ..."},
    {RING "outer_radius_mm: 4*sni(1)}\n", 7, 56,
     "'outer_radius_mm': unknown name 'sni' in arithmetic (did you mean 'sin'?)"},
    {RING "outer_radius_mm: '4*sni(1)'}\n", 7, 57, "'outer_radius_mm': unknown name 'sni' ..."},
    {RING "outer_radius_mm: 4*}\n", 7, 56, "'outer_radius_mm': the arithmetic ends too early"},
    {RING "outer_radius_mm: 4**2}\n", 7, 56,
     "'outer_radius_mm': an operator where a number is wanted"},
    {RING "outer_radius_mm: (4+1}\n", 7, 58, "'outer_radius_mm': ')' is missing"},
    {RING "outer_radius_mm: 4+1)}\n", 7, 57, "'outer_radius_mm': ')' without '('"},
    {RING "outer_radius_mm: s=3}\n", 7, 55,
     "'outer_radius_mm': '=' in arithmetic: nothing is assigned here"},
    {RING "outer_radius_mm: 4 $ 5}\n", 7, 56, "'outer_radius_mm': '$' cannot stand in arithmetic"},
    {RING "outer_radius_mm: 4 \xC3\xB7 5}\n", 7, 56,
     "'outer_radius_mm': this character cannot stand in arithmetic"},
    {RING "outer_radius_mm: s - 60}\n", 7, 54,
     "'outer_radius_mm': -60 mm at s = 0 mm is out of range, 0.001 mm to 1000 mm"},
    {RING "outer_radius_mm: 60/(s - 60)^2}\n", 7, 54,
     "'outer_radius_mm': this is not a finite number at s = 60 mm"},
    {ROD "  tendons: [{end_mm: s/2}]\n", 5, 22,
     "'end_mm': s may not stand here: this number does not vary along the rod"},
};

static const mistake yaml[] = {
    {"", 1, 1, "the case is empty"},
    {"# only a comment\n", 1, 1, "the case is empty"},
    {"- a\n- b\n", 1, 1, "a case is a map of keys (`format: 1` ...), not a list"},
    {"just words\n", 1, 1, "a case is a map of keys (`format: 1` ...), not a single value"},
    {"format: 1\nrod:\n\tlength_mm: 1\n", 3, 1, "a tab in the indentation; use spaces"},
    {"format: 1\nrod:\n  \tlength_mm: 1\n", 3, 3, "a tab in the indentation; use spaces"},
    {"format: 1\nloads:\n  -\ta: 1\n    b: 2\n", 3, 4, "a tab where YAML wants spaces"},
    {"format: 1\ntitle: &name words\n", 2, 8, "a case has no anchors ('&name')"},
    {"format: 1\nrod: &rod {length_mm: 1}\n", 2, 6, "a case has no anchors ('&name')"},
    {"format: 1\ntitle: *name\n", 2, 8, "a case has no aliases ('*name')"},
    {"format: 1\n*name : 3\n", 2, 1, "a case has no aliases ('*name')"},
    {"format: 1\ntitle: !!str words\n", 2, 8, "a case has no tags ('!name')"},
    {"format: 1\nrod: !python/object {a: 1}\n", 2, 6, "a case has no tags ('!name')"},
    {"%YAML 1.1\n---\nformat: 1\n", 1, 1,
     "a case has no YAML directives ('%' at the start of a line)"},
    {"format: 1\n---\nformat: 1\n", 2, 1, "a second document; a case is one"},
    {"format: 1\n? [a, b]\n: 3\n", 2, 3, "a key must be a plain name, not a list or a map"},
    {"format: 1\n{a: 1}: 3\n", 2, 1, "a key must be a plain name, not a list or a map"},
    {"format: 1\nrod: {length_mm: 1\nloads: []\n", 3, 6,
     "not valid YAML: ',' or '}' is missing (in the map that begins on line 2)"},
    {"format: 1\n  rod: 2\n", 2, 6,
     "not valid YAML: a ': ' where no key can stand; look at the indentation and the line above, "
     "or put the text in quotes"},
    {"format: 1\ntitle: \"open\nrod: 1\n", 4, 1,
     "not valid YAML: the closing quote is missing (of the text that begins on line 2)"},
    {"format: 1\ntitle: @home\n", 2, 8, "not valid YAML: '@' cannot begin a value; quote it"},
    {"format: 1\ntitle: \"a\\0b\"\n", 2, 8, "a NUL character inside a text"},
    {"format: 1\ntitle: caf\xE9\n", 2, 11, "the byte 0xE9 is not UTF-8 text"},
    {"\xFF\xFE"
     "f\n",
     1, 1, "the byte 0xFF is not UTF-8 text"},
    {"format: 1\ntitle: \x07\n", 2, 8, "the control character U+0007"},
};

static bool says(const char *message, const char *words)
{
    const size_t n = strlen(words);
    if (n > 3 && strcmp(words + n - 3, "...") == 0) {
        return strncmp(message, words, n - 3) == 0;
    }
    return strcmp(message, words) == 0;
}

static void check_mistake(const mistake *m)
{
    char where[96];
    config *cfg = NULL;
    small_case c;
    CHECK(case_text_read(m->text, 0, NULL, &c, &cfg) == ERR_INPUT);
    (void)snprintf(where, sizeof where, "%s:%d:%d: error: ", case_file_path, m->line, m->column);
    const char *message = status_message();
    if (strncmp(message, where, strlen(where)) != 0 || !says(message + strlen(where), m->words)) {
        test_failures++;
        printf("wanted %d:%d: %s\n   got %s\n", m->line, m->column, m->words, message);
    }
    status_clear();
    config_free(cfg);
}

static void every_mistake_has_its_line_and_column(void)
{
    const struct {
        const mistake *list;
        size_t count;
    } all[] = {{keys, sizeof keys / sizeof *keys},
               {values, sizeof values / sizeof *values},
               {arithmetic, sizeof arithmetic / sizeof *arithmetic},
               {yaml, sizeof yaml / sizeof *yaml}};
    for (size_t i = 0; i < sizeof all / sizeof *all; i++) {
        for (size_t j = 0; j < all[i].count; j++) {
            check_mistake(&all[i].list[j]);
        }
    }
}

static void a_mistake_in_an_override_is_shown_with_it(void)
{
    static const char *const wrong[][2] = {
        {"rod.lenght_mm=3", "unknown key 'lenght_mm' (did you mean 'length_mm'?)"},
        {"rod.length_mm=-3", "'length_mm': -3 mm is out of range, 0.001 mm to 10000 mm"},
        {"rod.length_mm=", "'length_mm': expected a number, found nothing"},
        {"rod.length_mm", "--set wants KEY=VALUE, with KEY like rod.length_mm"},
        {"=3", "--set wants KEY=VALUE, with KEY like rod.length_mm"},
        {"rod..length_mm=3", "--set wants KEY=VALUE, with KEY like rod.length_mm"},
        {"rod.length_mm.=3", "--set wants KEY=VALUE, with KEY like rod.length_mm"},
        {"title.short=x", "'title' is a single value and has no 'short'"},
        {"section.shapes.7.material=soft", "'shapes' has 2 entries, counted from 0"},
        {"section.shapes.99999999999999999999.material=soft",
         "'shapes' has 2 entries, counted from 0"},
        {"rod.tendons.t3.radius_mm=3",
         "'tendons' is a list: no entry is named 't3', and 't3' is no number (did you mean 't1'?)"},
        {"rod.tensions_N=[[1, 2", "not valid YAML: ',' or ']' is missing"},
        {"rod.tensions_N=*all", "a case has no aliases ('*name')"},
        {"rod={length_mm: 1, length_mm: 2}", "key 'length_mm' is given twice, first on line 1"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        char wanted[256];
        config *cfg = NULL;
        small_case c;
        CHECK(case_text_read(small_text, 1, wrong[i], &c, &cfg) == ERR_INPUT);
        (void)snprintf(wanted, sizeof wanted, "--set '%s': error: %s", wrong[i][0], wrong[i][1]);
        if (strcmp(status_message(), wanted) != 0) {
            test_failures++;
            printf("wanted %s\n   got %s\n", wanted, status_message());
        }
        status_clear();
        config_free(cfg);
    }
}

static void a_file_that_cannot_be_read_is_named(void)
{
    static const char *const wrong[][2] = {
        {"/tmp", "/tmp: error: this is a directory, not a case file"},
        {"/nowhere/case.yaml", "/nowhere/case.yaml: error: cannot open: No such file or directory"},
    };
    for (size_t i = 0; i < sizeof wrong / sizeof *wrong; i++) {
        config *cfg = NULL;
        CHECK(config_open(wrong[i][0], 0, NULL, &cfg) == ERR_INPUT && !cfg);
        CHECK(strcmp(status_message(), wrong[i][1]) == 0);
        status_clear();
    }
}

int main(void)
{
    every_mistake_has_its_line_and_column();
    a_mistake_in_an_override_is_shown_with_it();
    a_file_that_cannot_be_read_is_named();
    return test_failures != 0;
}
