/* Reset: switch the FPU on, paint the stack, set variables up, run main, end QEMU with what it returned. */
#include "platform.h"

#include <stdint.h>

extern uint32_t _sidata[];
extern uint32_t _sdata[];
extern uint32_t _edata[];
extern uint32_t _sbss[];
extern uint32_t _ebss[];
extern uint32_t _estack[];
extern uint32_t _stack_limit[];

int main(void);
void Reset_Handler(void);
void start(void);
void fault(void);

#define PAINT 0xc5c5c5c5U

/* Naked: the compiler must not touch the FPU before it is on. CPACR: full access to coprocessors 10 and 11. */
__attribute__((naked)) void Reset_Handler(void)
{
    __asm volatile("ldr r0, =0xe000ed88\n"
                   "ldr r1, [r0]\n"
                   "orr r1, r1, #0xf00000\n"
                   "str r1, [r0]\n"
                   "dsb\n"
                   "isb\n"
                   "ldr r0, =_stack_limit\n"
                   "ldr r1, =0xc5c5c5c5\n"
                   "mov r2, sp\n"
                   "1: cmp r0, r2\n"
                   "itt lo\n"
                   "strlo r1, [r0], #4\n"
                   "blo 1b\n"
                   "b start\n");
}

void start(void)
{
    const uint32_t *from = _sidata;
    uint32_t *to = _sdata;

    while (to < _edata) {
        *to = *from;
        from++;
        to++;
    }
    to = _sbss;
    while (to < _ebss) {
        *to = 0U;
        to++;
    }
    platform_exit(main());
}

uint32_t platform_stack_used(void)
{
    const uint32_t *at = _stack_limit;

    while ((at < _estack) && (*at == PAINT)) {
        at++;
    }
    return (uint32_t)((uintptr_t)_estack - (uintptr_t)at);
}

void fault(void)
{
    platform_print("fault\n");
    platform_exit(70);
}

typedef void (*handler_t)(void);

__attribute__((section(".vectors"), used)) static const handler_t vectors[16] = {
    (handler_t)(uintptr_t)_estack, Reset_Handler, fault, fault, fault, fault, fault, 0, 0, 0, 0, fault, fault, 0,
    fault, fault,
};
