/* The hash of what an episode did, as the host's. */
#ifndef HASH_H
#define HASH_H

#include <stdint.h>

#define HASH_START 0xcbf29ce484222325U

/* One step of FNV-1a. */
static inline uint64_t hash_bits(uint64_t before, uint32_t bits)
{
    return (before ^ bits) * 0x100000001b3U;
}

/* The same over a value's bits; the core is little-endian. */
static inline uint64_t hash_value(uint64_t before, float value)
{
    const uint8_t *bytes = (const uint8_t *)&value;
    uint32_t bits = 0U;

    for (uint32_t at = 0U; at < (uint32_t)sizeof value; at++) {
        bits |= (uint32_t)bytes[at] << (8U * at);
    }
    return hash_bits(before, bits);
}

#endif
