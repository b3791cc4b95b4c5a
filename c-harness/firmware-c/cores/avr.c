/* The platform on an AVR under QEMU: the serial port for output. Nothing ends the machine, so that the last line does. QEMU
 * cannot read this machine's timers while it counts instructions. */
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
}

uint32_t platform_count(void)
{
    return 0U;
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
