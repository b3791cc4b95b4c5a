/* The platform on a machine with an operating system. It does not count instructions. */
#include "platform.h"

#include <stdio.h>
#include <stdlib.h>

void platform_print(const char *text)
{
    (void)fputs(text, stdout);
}

void platform_exit(int code)
{
    exit(code);
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
