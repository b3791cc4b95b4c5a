/*
 * A policy for cartpole, score 500 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix cartpole --profile fast
 * Graph SHA-256: b5cd35e439ef2cb063083c5c6d233008b3172426fbda1ff61d89268cd8839ef5
 * 1 team, 2 edges, 2 programs, 2 distinct operations.
 * A decision takes at most 2 bids and 2 operations.
 * Computes in f32 with own maths.
 */
#include "cartpole.h"

#include <float.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "fast-math, or a part of it, reorders operations: the policy would act differently"
#endif
#if defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ > 0)
#error "-ffinite-math-only drops NaN and infinities: the policy would act differently"
#endif
/* 16 only widens types narrower than float. */
#if defined(FLT_EVAL_METHOD) && (FLT_EVAL_METHOD != 0) && (FLT_EVAL_METHOD != 16)
#error "float expressions must be computed in float: the policy would act differently"
#endif
/* A product and a sum are rounded each: nothing may fuse them. */
#if defined(__GNUC__) && !defined(__clang__)
#pragma GCC optimize("fp-contract=off") /* GCC ignores the standard's pragma, and fuses in GNU modes and in C++. */
#elif defined(_MSC_VER) && !defined(__clang__)
#pragma fp_contract(off)
#else
#pragma STDC FP_CONTRACT OFF
#endif
#if defined(__clang_major__) && (__clang_major__ >= 13) /* no macro reveals -fassociative-math */
#pragma clang fp reassociate(off)
#endif

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. */
cartpole_action_t cartpole_infer(const cartpole_state_t *state)
{
    const float left = state->v / -3.2907495f;
    const float right = state->theta + state->omega;

    return ((left >= -FLT_MAX) && !(right >= left)) ? CARTPOLE_LEFT : CARTPOLE_RIGHT;
}

#ifndef CARTPOLE_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t cartpole_arithmetic(void)
{
    const volatile float numbers[6] = { 0.0f, FLT_MAX, 1.0002441f, 16777216.0f, 41.0f, FLT_MIN };
    const float zero = numbers[0];
    const float most = numbers[1];
    const float near_one = numbers[2];
    const float large = numbers[3];
    const float dividend = numbers[4];
    const float smallest = numbers[5];
    const float infinite = most + most;
    const float nan = infinite * zero;
    const float fused = (near_one * near_one) - 1.0004883f;
    const float reordered = (large + 1.0f) - large;
    const float quotient = dividend / 41.0f;
    uint32_t wrong = 0U;

    wrong += ((nan >= zero) || (nan <= zero)) ? 1U : 0U;
    wrong += (infinite > FLT_MAX) ? 0U : 1U;
    wrong += (fused > zero) ? 1U : 0U;
    wrong += (reordered > zero) ? 1U : 0U;
    wrong += (quotient < 1.0f) ? 1U : 0U;
    wrong += ((smallest * 0.5f) > zero) ? 0U : 1U;
    return wrong;
}

uint32_t cartpole_selftest(void)
{
    static const cartpole_state_t states[5] = {
        { -0.9361377f, -0.44416824f, 0.08089407f, -0.29353777f },
        { -2.0765705f, 0.23748176f, -0.032598697f, -0.36226624f },
        { 3.5978985f, 0.23317035f, -0.014026452f, 0.075386174f },
        { -3.8451886f, -0.24565889f, -0.03898949f, -0.23075496f },
        { -1.9484f, 0.18415692f, 0.34806383f, -0.40402582f },
    };
    static const cartpole_action_t actions[5] = {
        CARTPOLE_LEFT,
        CARTPOLE_LEFT,
        CARTPOLE_RIGHT,
        CARTPOLE_LEFT,
        CARTPOLE_RIGHT,
    };
    uint32_t failures = cartpole_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 5U; vector++) {
        if (cartpole_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
