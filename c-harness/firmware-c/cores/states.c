/*
 * Answers of each shipped policy to STATES states, a third of which are any bits: a hash, and the instructions of it. The
 * same program runs on every core; only platform.h differs.
 */
#include "platform.h"
#include "policies.h"
#include "report.h"

#include <stdint.h>
#include <string.h>

#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off") /* A state is a product and a sum, each rounded. */
#else
#pragma STDC FP_CONTRACT OFF
#endif

/* Xorshift. */
static uint32_t drawn(uint32_t *bits)
{
    *bits ^= *bits << 13;
    *bits ^= *bits >> 17;
    *bits ^= *bits << 5;
    return *bits;
}

#if defined(__AVR__)

/* Any bits but tiny numbers and huge ones: avr-libc rounds a quotient that is denormal to a neighbour. Zeros, infinities and
 * NaN stay. */
static uint32_t tamed(uint32_t bits)
{
    const uint32_t exponent = (bits >> 23) & 255U;

    if (exponent == 0U) {
        return bits & 0x80000000U;
    }
    return (exponent == 255U) ? bits : ((bits & 0x807fffffU) | ((96U + (exponent & 63U)) << 23));
}

#else

static uint32_t tamed(uint32_t bits)
{
    return bits;
}

#endif

static void draw(const policy_t *policy, uint32_t index, uint32_t *random, float *state)
{
    for (uint8_t input = 0U; input < policy->inputs; input++) {
        const uint32_t bits = drawn(random);

        if ((index % 3U) == 0U) {
            const uint32_t any = tamed(bits);

            memcpy(&state[input], &any, sizeof any);
        } else {
            const float way = (float)(bits >> 8) * policy->step[input];

            state[input] = policy->low[input] + way;
        }
    }
}

/* FNV-1a over the bytes of a number, least first. */
static uint64_t hashed(uint64_t before, uint32_t bits)
{
    uint64_t hash = before;

    for (uint8_t byte = 0U; byte < 4U; byte++) {
        hash = (hash ^ ((bits >> (8U * byte)) & 0xffU)) * 0x100000001b3U;
    }
    return hash;
}

static void nothing(void)
{
}

/* Instructions of a call that does nothing. */
static uint32_t around(void)
{
    void (*volatile called)(void) = nothing;

    platform_count_from();
    called();
    return platform_count();
}

static void run(const policy_t *policy, uint32_t overhead)
{
    uint64_t hash = 0xcbf29ce484222325U;
    uint32_t random = 1U;
    uint32_t instructions = 0U;
    uint32_t worst = 0U;
    report_t line;

    for (uint32_t index = 0U; index < (uint32_t)STATES; index++) {
        float state[MOST_VALUES];
        uint32_t bits[MOST_VALUES];
        uint32_t gross;
        uint32_t net;

        draw(policy, index, &random, state);
        gross = policy->answer(state, bits);
        net = (gross > overhead) ? (gross - overhead) : 0U;
        instructions += net;
        worst = (net > worst) ? net : worst;
        for (uint8_t at = 0U; at < policy->answers; at++) {
            hash = hashed(hash, bits[at]);
        }
    }
    report_begin(&line, "policy ");
    report_word(&line, policy->name);
    report_unsigned(&line, "actions", (uint32_t)STATES);
    report_hexadecimal(&line, "hash", hash);
    report_unsigned(&line, "instructions", instructions);
    report_unsigned(&line, "worst", worst);
    report_print(&line);
}

int main(void)
{
    const uint32_t overhead = around();
    report_t line;

    for (uint8_t at = 0U; at < policy_count; at++) {
        run(&policies[at], overhead);
    }
    report_begin(&line, "done");
    report_print(&line);
    /* Where main returns to nothing, as on an AVR. */
    platform_exit(0);
}
