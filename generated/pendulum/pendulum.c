/*
 * A policy for pendulum, score -151.98 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix pendulum --profile fast
 * Graph SHA-256: e371857f5f2d98485533a900f5b0c18626fc44af90b3ad69194605f6c7bd3e14
 * 1 team, 2 edges, 2 programs, 14 distinct operations.
 * A decision takes at most 2 bids and 9 operations.
 * Computes in f32 with own maths.
 */
#include "pendulum.h"

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

static float pendulum_min(float a, float b)
{
    return (a < b) ? a : b;
}

/* An output in its range. NaN fails both comparisons, and becomes 0.0f. */
static float pendulum_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. */
void pendulum_infer(const pendulum_state_t *state, pendulum_action_t *action)
{
    float torque;

    const float to_leaf_0 = pendulum_min(state->cos_theta, state->sin_theta);
    const float to_leaf_1 = 4.407756f * state->cos_theta;

    if ((to_leaf_0 >= -FLT_MAX) && !(to_leaf_1 >= to_leaf_0)) {
        const float term = 6.6331344f * state->sin_theta + 0.0f + 2.6018698f * state->omega;
        torque = (-22.268024f * state->cos_theta - 0.38278264f) * term;
    } else {
        const float term = 9.448936f * state->sin_theta + 0.0f + 1.7750591f * state->omega;
        torque = -1.6007409f * term;
    }

    action->torque = pendulum_clamp(torque, -2.0f, 2.0f);
}

#ifndef PENDULUM_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t pendulum_arithmetic(void)
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

uint32_t pendulum_selftest(void)
{
    static const pendulum_state_t states[24] = {
        { -0.19502868f, -0.83923256f, 1.5449629f },
        { -0.5613508f, -0.43261883f, 3.3697636f },
        { -0.077823654f, -0.6946946f, 5.996497f },
        { 0.41324815f, -0.03348569f, 1.2353462f },
        { -0.0118376175f, -0.052177325f, 2.7455611f },
        { -0.037968032f, -0.16735381f, 0.71945584f },
        { -0.011837617f, -0.052177325f, 2.7455611f },
        { -1e-45f, 0.617188f, -3.3860345f },
        { -0.0f, 0.617188f, -3.3860345f },
        { -0.015439926f, -0.06805542f, 1.6421089f },
        { -0.015439927f, -0.06805542f, 1.6421089f },
        { -1e-45f, 0.014884114f, -1.6167369f },
        { -0.0f, 0.014884114f, -1.6167369f },
        { 0.0f, 0.5531384f, 1.4334705f },
        { -1e-45f, 0.5531384f, 1.4334705f },
        { -0.09280777f, -0.40907395f, -0.61817133f },
        { -0.09280776f, -0.40907395f, -0.61817133f },
        { -0.14127159f, -0.6226907f, -1.3091669f },
        { -0.1412716f, -0.6226907f, -1.3091669f },
        { -1e-45f, 0.7445885f, -3.7643542f },
        { -0.0f, 0.7445885f, -3.7643542f },
        { -0.0f, 0.5799874f, -4.1548405f },
        { -1e-45f, 0.5799874f, -4.1548405f },
        { -0.116872914f, -0.5151472f, -7.7639093f },
    };
    static const pendulum_action_t actions[24] = {
        { -2.0f },
        { 2.0f },
        { -2.0f },
        { -2.0f },
        { -0.81014085f },
        { 0.48700768f },
        { -2.0f },
        { 1.8052529f },
        { 0.28595847f },
        { -2.0f },
        { -0.14889415f },
        { 1.5723987f },
        { 2.0f },
        { -2.0f },
        { -2.0f },
        { -2.0f },
        { 2.0f },
        { 2.0f },
        { -2.0f },
        { 1.8585643f },
        { -0.566051f },
        { 2.0f },
        { 2.0f },
        { -2.0f },
    };
    uint32_t failures = pendulum_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        pendulum_action_t action;

        pendulum_infer(&states[vector], &action);
        if (!((action.torque >= actions[vector].torque) && (action.torque <= actions[vector].torque))) {
            failures++;
        }
    }
    return failures;
}
#endif
