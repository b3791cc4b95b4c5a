/*
 * The platform on the cores of Arm and RISC-V under QEMU: picolibc's semihosting for output and end.
 *
 * On Arm, -icount shift=10 makes an instruction last 1,024 ns, of which SysTick counts TICKS in a thousand instructions. On
 * RISC-V, with shift=0, minstret is the counter.
 */
#include "platform.h"

#include <stdint.h>
#include <stdio.h>
#include <stdlib.h>

static uint32_t started;

#if defined(__arm__)

#define SYST_CSR (*(volatile uint32_t *)0xe000e010U)
#define SYST_RVR (*(volatile uint32_t *)0xe000e014U)
#define SYST_CVR (*(volatile uint32_t *)0xe000e018U)

void platform_count_from(void)
{
    SYST_RVR = 0xffffffU;
    SYST_CSR = 5U;
    SYST_CVR = 0U;
    started = SYST_CVR;
}

uint32_t platform_count(void)
{
    const uint32_t ticks = (started - SYST_CVR) & 0xffffffU;

    return (uint32_t)((((uint64_t)ticks * 1000U) + (TICKS / 2U)) / TICKS);
}

#else

static uint32_t counter(void)
{
    uint32_t value;

    __asm volatile(".option push\n.option arch, +zicsr\ncsrr %0, minstret\n.option pop" : "=r"(value));
    return value;
}

void platform_count_from(void)
{
    started = counter();
}

uint32_t platform_count(void)
{
    return counter() - started;
}

#endif

void platform_print(const char *text)
{
    (void)fputs(text, stdout);
}

void platform_exit(int code)
{
    exit(code);
}

uint32_t platform_stack_used(void)
{
    return 0U;
}
