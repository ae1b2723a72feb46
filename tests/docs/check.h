// What stands before the pieces of C in docs/verification.md.
#include "tests/test.h"

int main(void);
int main(void)
{
