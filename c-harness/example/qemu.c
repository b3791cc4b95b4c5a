/*
 * The platform under QEMU: semihosting for output and end, SysTick as a counter of instructions.
 *
 * With -icount shift=10 an instruction takes 1,024 ns of QEMU's time, and SysTick on mps2-an386 ticks every 40 ns: 25.6
 * ticks an instruction, exact for up to 655,359 of them.
 */
#include "platform.h"

#include <stdint.h>

#define SYS_WRITE0 0x04
#define SYS_EXIT_EXTENDED 0x20
#define STOPPED_APPLICATION_EXIT 0x20026

#define SYST_CSR (*(volatile uint32_t *)0xe000e010U)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014U)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018U)

static uint32_t started;

static void semihosting(int operation, const void *argument)
{
    register int r0 __asm("r0") = operation;
    register const void *r1 __asm("r1") = argument;

    __asm volatile("bkpt 0xab" : "+r"(r0) : "r"(r1) : "memory");
}

void platform_print(const char *text)
{
    semihosting(SYS_WRITE0, text);
}

void platform_exit(int code)
{
    const uint32_t block[2] = { STOPPED_APPLICATION_EXIT, (uint32_t)code };

    for (;;) {
        semihosting(SYS_EXIT_EXTENDED, block);
    }
}

void platform_count_from(void)
{
    SYST_RVR = 0xffffffU;
    SYST_CSR = 5U;
    SYST_CVR = 0U;
    started = SYST_CVR;
}

uint32_t platform_count(void)
{
    const uint32_t now = SYST_CVR;

    /* Divided by 25.6, rounded. */
    return ((((started - now) & 0xffffffU) * 5U) + 64U) / 128U;
}
