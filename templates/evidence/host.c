/* This machine, as a board: it writes and raises flags; it counts nothing. */
#include "board.h"

#include <fenv.h>
#include <stdio.h>

uintptr_t board_entry;

int main(void)
{
    return firmware();
}

void board_write(const char *text)
{
    (void)fputs(text, stdout);
}

void board_clear_flags(void)
{
    (void)feclearexcept(FE_ALL_EXCEPT);
}

unsigned board_flags(void)
{
    const int raised = fetestexcept(FE_INVALID | FE_DIVBYZERO | FE_OVERFLOW);
    return (raised & FE_INVALID ? 1u : 0u) | (raised & FE_DIVBYZERO ? 2u : 0u) |
           (raised & FE_OVERFLOW ? 4u : 0u);
}

uint32_t board_clock(void)
{
    return 0;
}

uint32_t board_instructions(const uint32_t before, const uint32_t after)
{
    return after - before;
}

void board_empty(void)
{
}

void board_known(void)
{
}

void board_mark(void)
{
}
