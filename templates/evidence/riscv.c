/* A RISC-V hart of QEMU's virt machine in machine mode, with semihosting; it counts nothing. */
#include "board.h"

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20, APPLICATION_EXIT = 0x20026 };

uintptr_t board_entry;

void begin(void);

__asm__(".section .text.start, \"ax\"\n"
        ".global _start\n"
        "_start:\n"
        "    la sp, stack_top\n"
        "    la t0, fault\n"
        "    csrw mtvec, t0\n"
        "    li t0, 0x2000\n" /* mstatus.FS: the floating-point unit */
        "    csrs mstatus, t0\n"
        "    j begin\n"
        ".text\n");

static void ask_host(const uintptr_t operation, const void *argument)
{
    register uintptr_t a0 __asm__("a0") = operation;
    register const void *a1 __asm__("a1") = argument;
    /* The three belong together: full width, and on one page. */
    __asm__ volatile(".option push\n\t.option norvc\n\t.balign 16\n\t"
                     "slli zero, zero, 0x1f\n\tebreak\n\tsrai zero, zero, 7\n\t.option pop"
                     : "+r"(a0)
                     : "r"(a1)
                     : "memory");
}

static void leave(const uintptr_t code)
{
    const uintptr_t block[2] = {APPLICATION_EXIT, code};
    ask_host(SYS_EXIT_EXTENDED, block);
    for (;;) {
    }
}

__attribute__((used, aligned(4))) static void fault(void)
{
    board_write("fault\n");
    leave(98);
}

void begin(void)
{
    leave((uintptr_t)firmware());
}

void board_write(const char *text)
{
    ask_host(SYS_WRITE0, text);
}

void board_clear_flags(void)
{
    __asm__ volatile("csrw fflags, zero");
}

unsigned board_flags(void)
{
    uintptr_t fflags;
    __asm__ volatile("csrr %0, fflags" : "=r"(fflags));
    return (unsigned)((fflags >> 4 & 1u) | (fflags >> 2 & 2u) | (fflags & 4u)); /* NV, DZ, OF */
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
