/* Functions of the machine that the control loop runs on: print, count instructions, end. */
#ifndef PLATFORM_H
#define PLATFORM_H

#include <stdint.h>

void platform_print(const char *text);
void platform_exit(int code) __attribute__((noreturn));

/* A counter of instructions, from platform_count_from on; 0 where the machine has none. */
void platform_count_from(void);
uint32_t platform_count(void);

/* Bytes of stack that were written to since reset; 0 where nobody knows. */
uint32_t platform_stack_used(void);

#endif
