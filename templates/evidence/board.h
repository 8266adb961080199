/* What a board gives to the program that measures; arm.c, riscv.c and host.c are boards. */
#ifndef BOARD_H
#define BOARD_H

#include <stdint.h>

typedef void board_routine(void);

int firmware(void); /* what a board runs; its result is the exit code */

void board_write(const char *text); /* to whoever started the board */

/* Flags raised since they were cleared: 1 invalid, 2 division by zero, 4 overflow. */
void board_clear_flags(void);
unsigned board_flags(void);

/* A clock that instructions drive, and the instructions between two readings of it. */
uint32_t board_clock(void);
uint32_t board_instructions(uint32_t before, uint32_t after);

board_routine board_empty; /* returns at once: one instruction, no stack */
board_routine board_known; /* BOARD_KNOWN instructions, the return included */
board_routine board_mark; /* keeps the stack pointer it is entered with in board_entry */
#define BOARD_KNOWN 65u
extern uintptr_t board_entry;

#endif
