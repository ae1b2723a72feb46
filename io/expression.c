// io/expression.c
#include "io/expression.h"

#include "base/memory.h"
#include "io/expression_scan.h"
#include "io/number.h"

#include <math.h>
#include <muParserDLL.h>
#include <string.h>

enum { VARIABLE_X, VARIABLE_Y, VARIABLE_S, VARIABLES };

struct expression {
    muParserHandle_t parser;
    double *variable; // [3] muParser reads x, y and s here
    expression *next;
};

struct calculator {
    expression *constant; // reused for every value that does not vary
    expression *compiled;
};

status calculator_make(calculator **out)
{
    return memory_take((void **)out, 1, sizeof **out);
}

static void expression_free(expression *e)
{
    if (e && e->parser) {
        mupRelease(e->parser);
    }
    if (e) {
        free(e->variable);
    }
    free(e);
}

void calculator_free(calculator *c)
{
    while (c && c->compiled) {
        expression *e = c->compiled;
        c->compiled = e->next;
        expression_free(e);
    }
    if (c) {
        expression_free(c->constant);
    }
    free(c);
}

static status make_parser(expression **out)
{
    status st = OK;
    expression *e = NULL;
    TRY(TAKE(e, 1));
    TRY(TAKE(e->variable, VARIABLES));
    e->parser = mupCreate(muBASETYPE_FLOAT);
    if (!e->parser) {
        TRY(status_fail(ERR_RESOURCE, "out of memory while starting muParser"));
    }
    mupClearConst(e->parser);
    mupDefineConst(e->parser, "pi", 3.14159265358979323846);
    *out = e;
    e = NULL;

done:
    expression_free(e);
    return st;
}

// muParser's codes (ecXXX in its C++ header), as words of ours
static const char *error_words(int code)
{
    switch (code) {
    case 0:
        return "an operator where a number is wanted";
    case 2:
        return "the arithmetic ends too early";
    case 3:
        return "a ',' where a number is wanted";
    case 4: // more values than operators take
    case 5:
    case 6:
    case 12:
        return "an operator is missing";
    case 7:
        return "a parenthesis where a number is wanted";
    case 11:
        return "')' is missing";
    case 14:
        return "too many arguments";
    case 15:
        return "too few arguments";
    case 25:
        return "nothing to compute";
    case 32:
    case 33:
    case 34:
        return "'? :' is not complete";
    default:
        return "not arithmetic";
    }
}

static status parser_error(muParserHandle_t parser, const char *text, expression_error *error)
{
    const int length = (int)strlen(text);
    const int position = mupGetErrorPos(parser);
    const char *words = error_words(mupGetErrorCode(parser));
    mupErrorReset(parser);
    return expression_refuse(error,
                             position < 0        ? 0
                             : position > length ? length
                                                 : position,
                             "%s", words);
}

// compiles by evaluating once; *value is the result with s as it stands
static status set_text(expression *e, const char *text, const expression_scope *scope,
                       double *value, expression_error *error)
{
    mupErrorReset(e->parser);
    mupClearVar(e->parser);
    if (scope->has_L) {
        mupDefineConst(e->parser, "L", scope->L);
    }
    if (scope->has_s) {
        mupDefineVar(e->parser, "s", &e->variable[VARIABLE_S]);
    }
    if (scope->has_place) {
        mupDefineVar(e->parser, "x", &e->variable[VARIABLE_X]);
        mupDefineVar(e->parser, "y", &e->variable[VARIABLE_Y]);
    }
    mupSetExpr(e->parser, text);
    if (!mupError(e->parser)) {
        int nvalue = 0;
        const double *values = mupEvalMulti(e->parser, &nvalue);
        if (!mupError(e->parser) && nvalue == 1) {
            *value = values[0];
            return OK;
        }
    }
    return parser_error(e->parser, text, error);
}

status expression_value(calculator *c, const char *text, const expression_scope *scope,
                        double *value, expression_error *error)
{
    status st = OK;
    if (number_read(text, value)) {
        return OK;
    }
    TRY(expression_scan(text, scope, error));
    if (!c->constant) {
        TRY(make_parser(&c->constant));
    }
    TRY(set_text(c->constant, text, scope, value, error));

done:
    return st;
}

status expression_compile(calculator *c, const char *text, const expression_scope *scope,
                          const expression **out, expression_error *error)
{
    status st = OK;
    double unused = 0;
    expression *e = NULL;
    TRY(expression_scan(text, scope, error));
    TRY(make_parser(&e));
    TRY(set_text(e, text, scope, &unused, error));
    e->next = c->compiled;
    c->compiled = e;
    *out = e;
    e = NULL;

done:
    expression_free(e);
    return st;
}

double expression_at(const expression *e, double s)
{
    return expression_at_place(e, 0, 0, s);
}

double expression_at_place(const expression *e, double x, double y, double s)
{
    e->variable[VARIABLE_X] = x;
    e->variable[VARIABLE_Y] = y;
    e->variable[VARIABLE_S] = s;
    const double value = mupEval(e->parser);
    if (mupError(e->parser)) {
        mupErrorReset(e->parser);
        return NAN;
    }
    return value;
}
