/*
 * A policy for InvertedDoublePendulum-v5 of Gymnasium, score 9359.83 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix inverted_double_pendulum --profile fast
 * Graph SHA-256: 23d21c6ffc354225d2aca850c679caec7d888893b4bcea35fcb70a647fa62729
 * 1 team, 1 edge, 1 program, 14 distinct operations.
 * A decision takes at most 14 operations.
 * Computes in f32 with own maths.
 */
#include "inverted_double_pendulum.h"

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

/* An output in its range. NaN fails both comparisons, and becomes 0.0f. */
static float inverted_double_pendulum_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void inverted_double_pendulum_infer(const inverted_double_pendulum_state_t *state, inverted_double_pendulum_action_t *action)
{
    const float term = -0.48305112f * state->x
        - 2.4732687f * state->sin_1
        - 6.5629725f * state->sin_2
        - 0.45679966f * state->cos_2
        - 0.2828851f * state->v
        - 0.9611906f * state->omega_1
        - 0.9364736f * state->omega_2;
    const float force = term + 0.44827595f;

    action->force = inverted_double_pendulum_clamp(force, -1.0f, 1.0f);
}

#ifndef INVERTED_DOUBLE_PENDULUM_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t inverted_double_pendulum_arithmetic(void)
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

uint32_t inverted_double_pendulum_selftest(void)
{
    static const inverted_double_pendulum_state_t states[5] = {
        { 0.0211067f, -0.12018729f, 0.014646072f, 0.99559784f, 0.9959746f, 0.08444619f, -0.07498883f, -0.20602275f, 0.00018739054f },
        { 0.16145936f, -0.014980235f, 0.009544096f, 0.99473846f, 0.99582976f, -0.062123664f, -0.19881363f, 0.37727702f, 0.00020617747f },
        { 0.27244136f, -0.10638329f, -0.052025657f, 0.99746895f, 0.9968069f, -0.31277797f, -0.3571786f, -0.18342711f, 1.2762486e-5f },
        { -0.040894106f, -0.1180896f, -0.11615404f, 1.0011306f, 0.9989869f, -0.25888783f, 0.0061992044f, 0.1961848f, 0.00010232527f },
        { -0.04626462f, 0.07975637f, 0.07271474f, 0.99738246f, 0.9966867f, 0.14861381f, 0.1651704f, 0.27195576f, 0.00016246014f },
    };
    static const inverted_double_pendulum_action_t actions[5] = {
        { 0.42537805f },
        { -0.25483772f },
        { 1.0f },
        { 0.9496311f },
        { -1.0f },
    };
    uint32_t failures = inverted_double_pendulum_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 5U; vector++) {
        inverted_double_pendulum_action_t action;

        inverted_double_pendulum_infer(&states[vector], &action);
        if (!((action.force >= actions[vector].force) && (action.force <= actions[vector].force))) {
            failures++;
        }
    }
    return failures;
}
#endif
