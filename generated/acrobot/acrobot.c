/*
 * A policy for acrobot, score -71.88 in validation, trained by tpg-train 0.1.0 with seed 11.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix acrobot --profile fast
 * Graph SHA-256: c746bc981049f428c5e9cd92b39b159c476562abde6afb37fa55ace167b590d0
 * 1 team, 4 edges, 4 programs, 26 distinct operations.
 * A decision takes at most 4 bids and 26 operations.
 * Computes in f32 with own maths.
 */
#include "acrobot.h"

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
acrobot_action_t acrobot_infer(const acrobot_state_t *state)
{
    float best = -FLT_MAX;
    acrobot_action_t action = ACROBOT_TORQUE_MINUS_1;
    const float torque_1 = -2.7205236f * state->cos_theta_1
        - 1.2175102f * state->sin_theta_2
        - 0.49445456f * state->omega_1
        + 0.22029561f * state->omega_2
        + 2.3143518f;
    if (torque_1 >= best) {
        best = torque_1;
        action = ACROBOT_TORQUE_1;
    }

    const float term = -3.3904653f * state->cos_theta_1
        - 0.12505245f * state->sin_theta_1
        + 0.27461419f * state->cos_theta_2
        - 0.4058117f * state->omega_1;
    const float torque_1_2 = term / 2.6443782f;
    if (torque_1_2 >= best) {
        best = torque_1_2;
        action = ACROBOT_TORQUE_1;
    }

    if (0.0f >= best) {
        best = 0.0f;
        action = ACROBOT_TORQUE_MINUS_1;
    }

    const float torque_minus_1_2 = -2.6076918f * state->cos_theta_1
        - 0.080515005f * state->omega_2
        - 1.831776f * state->sin_theta_2
        + 0.10326636f * state->cos_theta_2
        + 2.957902f * state->sin_theta_1
        - 0.69571906f;
    if (torque_minus_1_2 >= best) {
        action = ACROBOT_TORQUE_MINUS_1;
    }

    return action;
}

#ifndef ACROBOT_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t acrobot_arithmetic(void)
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

uint32_t acrobot_selftest(void)
{
    static const acrobot_state_t states[24] = {
        { -0.19502868f, -0.83923256f, 0.19312036f, -0.5613508f, -5.4364486f, 11.909728f },
        { -0.077823654f, -0.6946946f, 0.74956214f, 0.41324815f, -0.42079356f, 4.366074f },
        { -0.80108094f, -0.47216487f, -0.09308055f, -0.43954256f, 12.34099f, 23.318121f },
        { 0.89423496f, -0.73351216f, -0.3126318f, -0.039395504f, -2.5802672f, -27.499756f },
        { -0.08403872f, 0.64652467f, -0.97819173f, -0.42278814f, 5.181203f, 5.3633842f },
        { -0.41004747f, 0.2336877f, 0.18640348f, 0.8290949f, 3.1818066f, -5.967111f },
        { -0.41004747f, 0.2336877f, 0.18640348f, 0.8290949f, 3.1818066f, -5.9671116f },
        { -0.08403872f, 0.64652467f, -0.97819173f, -0.42278814f, 5.181203f, 5.3633847f },
        { 0.149315f, -0.47528398f, 0.065581545f, 0.45966673f, 8.708905f, 13.425913f },
        { 0.149315f, -0.47528398f, 0.065581545f, 0.45966673f, 8.708904f, 13.425913f },
        { -0.81921196f, -0.5176666f, -0.5353048f, 0.14006776f, 4.465238f, -9.147562f },
        { -0.81921196f, -0.5176666f, -0.5353048f, 0.14006776f, 4.4652386f, -9.147562f },
        { -0.93091834f, 0.22297108f, -0.96875715f, -0.05454752f, -8.058701f, -21.63081f },
        { -0.93091834f, 0.22297108f, -0.96875715f, -0.05454752f, -8.058701f, -21.630808f },
        { -0.08057103f, -0.037815593f, 0.5196743f, -0.45046628f, 0.28779703f, -8.837265f },
        { -0.080571026f, -0.037815593f, 0.5196743f, -0.45046628f, 0.28779703f, -8.837265f },
        { -0.087255776f, -0.10546856f, 0.52744234f, -0.44668323f, -0.45583346f, -10.732405f },
        { -0.087255776f, -0.10546856f, 0.52744234f, -0.44668323f, -0.4558335f, -10.732405f },
        { 0.9256835f, 0.18963873f, 0.2702074f, -0.50520563f, 0.4663645f, -0.81937593f },
        { 0.9256835f, 0.18963873f, 0.2702074f, -0.50520563f, 0.4663645f, -0.819376f },
        { -0.28740084f, -0.041983984f, 0.7362236f, 0.13804492f, 1.4199258f, -8.222328f },
        { -0.28740084f, -0.041983984f, 0.7362236f, 0.13804492f, 1.4199257f, -8.222328f },
        { -0.6225854f, 0.066108935f, 0.53745174f, 0.25331536f, -0.052606724f, -10.009249f },
        { -0.6225854f, 0.06610894f, 0.53745174f, 0.25331533f, -0.052606724f, -10.009249f },
    };
    static const acrobot_action_t actions[24] = {
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_MINUS_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_1,
        ACROBOT_TORQUE_MINUS_1,
    };
    uint32_t failures = acrobot_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (acrobot_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
