/* The platform on an AVR under simavr: the serial port for output, the first timer for cycles. */
#include "platform.h"

#include <avr/interrupt.h>
#include <avr/io.h>
#include <avr/sleep.h>
#include <stdint.h>

/* How often the timer of 16 bits was full. */
static volatile uint16_t full;

ISR(TIMER1_OVF_vect)
{
    full++;
}

void platform_print(const char *text)
{
    UCSR0B = (uint8_t)(1U << TXEN0);
    for (const char *at = text; *at != '\0'; at++) {
        while ((UCSR0A & (1U << UDRE0)) == 0U) {
        }
        UDR0 = (uint8_t)*at;
    }
}

/* simavr ends where the processor sleeps and nothing can wake it. */
void platform_exit(int code)
{
    (void)code;
    cli();
    sleep_enable();
    for (;;) {
        sleep_cpu();
    }
}

/* A cycle a tick. */
void platform_count_from(void)
{
    cli();
    TCCR1A = 0U;
    TCCR1B = (uint8_t)(1U << CS10);
    TIMSK1 = (uint8_t)(1U << TOIE1);
    TIFR1 = (uint8_t)(1U << TOV1);
    full = 0U;
    sei();
    TCNT1 = 0U;
}

uint32_t platform_count(void)
{
    uint16_t low;
    uint16_t high;

    cli();
    low = TCNT1;
    high = full;
    /* It was full after interrupts were off. */
    if (((TIFR1 & (1U << TOV1)) != 0U) && (low < 0x8000U)) {
        high++;
    }
    sei();
    return ((uint32_t)high << 16) | low;
}

uint32_t platform_stack_used(void)
{
    return 0U;
}
