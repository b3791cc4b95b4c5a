/*
 * A policy for mountain-car-continuous, score 99.43 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix mountain_car_continuous --profile fast
 * Graph SHA-256: 2df7341b545eca60de0f638be2a5ace6a42c8fd5e00a17155052b0a540adac4d
 * 1 team, 2 edges, 2 programs, 4 distinct operations.
 * A decision takes at most 2 bids and 3 operations.
 * Computes in f32 with own maths.
 */
#include "mountain_car_continuous.h"

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

static float mountain_car_continuous_min(float a, float b)
{
    return (a < b) ? a : b;
}

/* An output in its range. NaN fails both comparisons, and becomes 0.0f. */
static float mountain_car_continuous_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. */
void mountain_car_continuous_infer(const mountain_car_continuous_state_t *state, mountain_car_continuous_action_t *action)
{
    float force;

    const float to_leaf_1 = mountain_car_continuous_min(state->velocity, 0.0f);

    if (to_leaf_1 >= 0.0f) {
        force = 4.846634f * state->velocity + 0.0f;
    } else {
        force = state->velocity - 0.04839926f;
    }

    action->force = mountain_car_continuous_clamp(force, -1.0f, 1.0f);
}

#ifndef MOUNTAIN_CAR_CONTINUOUS_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t mountain_car_continuous_arithmetic(void)
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

uint32_t mountain_car_continuous_selftest(void)
{
    static const mountain_car_continuous_state_t states[24] = {
        { -0.47552583f, -0.058746282f },
        { -0.12619168f, -0.03929456f },
        { -0.689357f, 0.02948543f },
        { -0.3700413f, -0.048628625f },
        { -0.4596662f, -0.0f },
        { -0.4596662f, -1e-45f },
        { -0.5112884f, -1e-45f },
        { -0.5112884f, -0.0f },
        { -0.87772655f, 0.0f },
        { -0.87772655f, -1e-45f },
        { -0.5249338f, -1e-45f },
        { -0.5249338f, -0.0f },
        { -0.9393909f, 0.0f },
        { -0.9393909f, -1e-45f },
        { -0.089292645f, -1e-45f },
        { -0.089292645f, -0.0f },
        { -0.4164105f, 0.0f },
        { -0.4164105f, -1e-45f },
        { -0.9285363f, -1e-45f },
        { -0.9285363f, 0.0f },
        { -0.93450916f, -0.0f },
        { -0.93450916f, -1e-45f },
        { 0.47084665f, -1e-45f },
        { 0.47084665f, 0.0f },
    };
    static const mountain_car_continuous_action_t actions[24] = {
        { -0.10714554f },
        { -0.08769382f },
        { 0.14290509f },
        { -0.09702788f },
        { 0.0f },
        { -0.04839926f },
        { -0.04839926f },
        { 0.0f },
        { 0.0f },
        { -0.04839926f },
        { -0.04839926f },
        { 0.0f },
        { 0.0f },
        { -0.04839926f },
        { -0.04839926f },
        { 0.0f },
        { 0.0f },
        { -0.04839926f },
        { -0.04839926f },
        { 0.0f },
        { 0.0f },
        { -0.04839926f },
        { -0.04839926f },
        { 0.0f },
    };
    uint32_t failures = mountain_car_continuous_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        mountain_car_continuous_action_t action;

        mountain_car_continuous_infer(&states[vector], &action);
        if (!((action.force >= actions[vector].force) && (action.force <= actions[vector].force))) {
            failures++;
        }
    }
    return failures;
}
#endif
