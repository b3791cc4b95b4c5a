/*
 * A policy for LunarLanderContinuous-v3 of Gymnasium, score 284.81 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix lunar_lander_continuous --profile fast
 * Graph SHA-256: f233abff0d84f6b23d274ff7e785b3758728cdea4ae76155154ea0fef268d463
 * 1 team, 1 edge, 1 program, 12 distinct operations.
 * A decision takes at most 12 operations.
 * Computes in f32 with own maths.
 */
#include "lunar_lander_continuous.h"

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
static float lunar_lander_continuous_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void lunar_lander_continuous_infer(const lunar_lander_continuous_state_t *state, lunar_lander_continuous_action_t *action)
{
    const float main_engine = -8.037243f * state->y - 11.026979f * state->vy - 1.8125842f;
    const float side_engine = -18.706825f * state->x
        + 2.1564276f * state->spin
        + 14.484438f * state->angle
        - 6.0377746f * state->vx
        + 0.24678662f;

    action->main_engine = lunar_lander_continuous_clamp(main_engine, -1.0f, 1.0f);
    action->side_engine = lunar_lander_continuous_clamp(side_engine, -1.0f, 1.0f);
}

#ifndef LUNAR_LANDER_CONTINUOUS_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t lunar_lander_continuous_arithmetic(void)
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

uint32_t lunar_lander_continuous_selftest(void)
{
    static const lunar_lander_continuous_state_t states[6] = {
        { -0.4875717f, -2.0980814f, 1.9312036f, -5.613508f, -2.7182243f, 4.2122045f, 0.46108818f, 0.1526527f },
        { 1.8739054f, 1.0331204f, -0.33485687f, 1.5441828f, -5.0333405f, -4.7216487f, 0.4534597f, 0.28022873f },
        { 2.4551618f, 2.0617747f, 8.942349f, -7.3351216f, -1.9643234f, -0.39395505f, 0.39733443f, 0.013697542f },
        { -2.2554016f, -1.5743524f, 0.5104994f, -4.6373506f, -5.172111f, -7.990908f, 0.99101675f, 0.6949953f },
        { 0.00887796f, 0.017397601f, 0.10015877f, -0.12299003f, 0.06848491f, -0.023829998f, 0.003970624f, 0.013177075f },
        { -0.016448123f, -0.012438183f, -0.045395926f, -0.021112017f, 0.041318804f, -0.057381433f, 0.0072859633f, 0.0055997646f },
    };
    static const lunar_lander_continuous_action_t actions[6] = {
        { 1.0f, -1.0f },
        { -1.0f, -1.0f },
        { 1.0f, -1.0f },
        { 1.0f, -1.0f },
        { -0.5962045f, 0.41654983f },
        { -1.0f, 1.0f },
    };
    uint32_t failures = lunar_lander_continuous_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 6U; vector++) {
        lunar_lander_continuous_action_t action;

        lunar_lander_continuous_infer(&states[vector], &action);
        if (!((action.main_engine >= actions[vector].main_engine) && (action.main_engine <= actions[vector].main_engine)) ||
            !((action.side_engine >= actions[vector].side_engine) && (action.side_engine <= actions[vector].side_engine))) {
            failures++;
        }
    }
    return failures;
}
#endif
