/*
 * The platform on an AVR under QEMU: the serial port for output; nothing ends the machine, so the last line does.
 *
 * -icount shift=6 makes an instruction last 64 ns, and QEMU's timer 1 ticks every 62.
 */
#include "platform.h"

#include <avr/io.h>
#include <stdint.h>

void platform_print(const char *text)
{
    UCSR0B = (uint8_t)(1U << TXEN0);
    for (const char *at = text; *at != '\0'; at++) {
        while ((UCSR0A & (1U << UDRE0)) == 0U) {
        }
        UDR0 = (uint8_t)*at;
    }
}

void platform_exit(int code)
{
    (void)code;
    for (;;) {
    }
}

void platform_count_from(void)
{
    TCCR1A = 0U;
    TCCR1B = 1U;
    TCNT1 = 0U;
}

uint32_t platform_count(void)
{
    const uint16_t ticks = TCNT1;

    return (((uint32_t)ticks * 62U) + 32U) / 64U;
}

uint32_t platform_stack_used(void)
{
    return 0U;
}

uint32_t platform_stack_of(void (*function)(void *argument), void *argument)
{
    function(argument);
    return 0U;
}
