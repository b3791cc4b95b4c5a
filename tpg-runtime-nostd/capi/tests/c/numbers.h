/* Random numbers for tests, the same on every machine. */
#ifndef NUMBERS_H
#define NUMBERS_H

#include <stdint.h>

/* The seed, and then where the sequence is. */
static uint64_t state;

/* SplitMix64. */
static uint64_t number(void)
{
    uint64_t z;

    state += 0x9E3779B97F4A7C15U;
    z = state;
    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9U;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBU;
    return z ^ (z >> 31);
}

#endif
