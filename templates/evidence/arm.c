/*
 * A Cortex-M with nothing but a vector table: QEMU loads the image, .data included, and answers
 * semihosting.
 *
 * Instructions: under -icount shift=10 QEMU's time is 1024 ns per instruction, exactly; SysTick
 * counts these boards' 25 MHz down, one tick each 40 ns. A tick is cut off at either end, 1/25.6
 * of an instruction, so the nearest whole number is the count. 24 bits last 655 359 instructions.
 */
#include "board.h"

#define NS_PER_INSTRUCTION 1024u
#define NS_PER_TICK 40u
#define CPACR (*(volatile uint32_t *)0xE000ED88u)
#define SYSTICK ((volatile uint32_t *)0xE000E010u) /* control, reload, value */

enum { SYS_WRITE0 = 0x04, SYS_EXIT_EXTENDED = 0x20, APPLICATION_EXIT = 0x20026 };

extern uint32_t stack_top;
uintptr_t board_entry;

static void ask_host(const uint32_t operation, const void *argument)
{
    register uint32_t r0 __asm__("r0") = operation;
    register const void *r1 __asm__("r1") = argument;
    __asm__ volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

static void leave(const uint32_t code)
{
    const uint32_t block[2] = {APPLICATION_EXIT, code};
    ask_host(SYS_EXIT_EXTENDED, block);
    for (;;) {
    }
}

static void fault(void)
{
    board_write("fault\n");
    leave(98);
}

static void reset(void)
{
    CPACR |= 0xFu << 20; /* the floating-point unit */
    __asm__ volatile("dsb\n\tisb" ::: "memory");
    SYSTICK[1] = 0xFFFFFFu;
    SYSTICK[2] = 0;
    SYSTICK[0] = 5; /* on, the processor's clock, no interrupt */
    leave((uint32_t)firmware());
}

__attribute__((section(".vectors"), used)) static const struct {
    uint32_t *stack;
    board_routine *reset, *faults[5];
} vectors = {&stack_top, reset, {fault, fault, fault, fault, fault}};

void board_write(const char *text)
{
    ask_host(SYS_WRITE0, text);
}

void board_clear_flags(void)
{
#ifdef __ARM_FP
    __asm__ volatile("vmsr fpscr, %0" : : "r"(0));
#endif
}

unsigned board_flags(void)
{
    uint32_t fpscr = 0;
#ifdef __ARM_FP
    __asm__ volatile("vmrs %0, fpscr" : "=r"(fpscr));
#endif
    return fpscr & 7u; /* IOC, DZC, OFC */
}

uint32_t board_clock(void)
{
    return SYSTICK[2];
}

uint32_t board_instructions(const uint32_t before, const uint32_t after)
{
    const uint32_t ticks = (before - after) & 0xFFFFFFu;
    return (ticks * NS_PER_TICK + NS_PER_INSTRUCTION / 2u) / NS_PER_INSTRUCTION;
}

__attribute__((naked)) void board_empty(void)
{
    __asm__("bx lr");
}

__attribute__((naked)) void board_known(void)
{
    __asm__(".rept 64\n\tnop\n\t.endr\n\tbx lr");
}

__attribute__((naked)) void board_mark(void)
{
    __asm__("ldr r0, =board_entry\n\tmov r1, sp\n\tstr r1, [r0]\n\tbx lr\n\t.ltorg");
}
