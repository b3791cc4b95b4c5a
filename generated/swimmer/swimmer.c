/*
 * A policy for Swimmer-v5 of Gymnasium, score 358.95 in validation, trained by tpg-train 0.1.0 with seed 4.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 095336965ef6ceea06bec0d7e7b0935bcd6bdf25f3aa4006ec2b3978cd7c444c
 * 1 team, 1 edge, 1 program, 28 distinct operations.
 * Computes in f32 with own maths.
 */
#include "swimmer.h"

#include <float.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "fast-math, or a part of it, reorders operations: the policy would act differently"
#endif
#if defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ > 0)
#error "-ffinite-math-only drops NaN and infinities: the policy would act differently"
#endif
/* 16 widens what is narrower than float, and no float. */
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
#if defined(__clang_major__) && (__clang_major__ >= 13) /* no macro tells of -fassociative-math */
#pragma clang fp reassociate(off)
#endif

/* An output in its range. NaN fails both comparisons, and becomes 0.0f. */
static float swimmer_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void swimmer_infer(const swimmer_state_t *state, swimmer_action_t *action)
{
    const float term = 0.7118727f * state->obs[0]
        - 0.11251226f * state->obs[1]
        - 0.69512516f * state->obs[2]
        + 0.3123265f * state->obs[4]
        - 0.27881774f * state->obs[5]
        + 0.183991f * state->obs[6]
        - 0.12982675f * state->obs[7];
    const float rotor_1 = term - 0.023436766f;
    const float term_2 = 0.26692712f * state->obs[1]
        - 0.65130556f * state->obs[2]
        - 0.31501192f * state->obs[3]
        + 0.26088122f * state->obs[4]
        - 0.35128272f * state->obs[5]
        + 0.2057382f * state->obs[6]
        + 0.08384997f * state->obs[7];
    const float rotor_2 = term_2 + 0.08995213f;

    action->rotor_1 = swimmer_clamp(rotor_1, -1.0f, 1.0f);
    action->rotor_2 = swimmer_clamp(rotor_2, -1.0f, 1.0f);
}
#ifndef SWIMMER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold: of some flags, such as clang's -fno-honor-nans and -ffp-contract=fast, no macro
 * tells, nor of a processor that flushes small numbers to 0. */
static uint32_t swimmer_arithmetic(void)
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

uint32_t swimmer_selftest(void)
{
    static const swimmer_state_t states[16] = {
        { { -0.20323594f, -1.1910177f, 0.2598124f, -0.36338776f, -1.4888479f, 1.5853858f, -0.41966468f, -5.7735367f } },
        { { 0.8981445f, 0.6243391f, -0.058569092f, 0.5969186f, -2.7539806f, -1.7633986f, -0.49815387f, -3.723551f } },
        { { 1.1692394f, 1.2207154f, 1.2448785f, -0.5943667f, -1.0768665f, -0.14119682f, -1.0756276f, -8.006371f } },
        { { -1.0277425f, -0.88737875f, 0.060203478f, -0.23242228f, -2.8298142f, -2.988855f, 5.0327764f, 2.941224f } },
        { { -0.8893963f, 0.25632825f, 0.63687915f, 0.9388802f, -1.9027259f, 3.4035683f, -3.8444383f, 1.9373685f } },
        { { 0.73282564f, 0.26117977f, 1.1113759f, 0.065891534f, -0.16249146f, 3.1715584f, -1.6805282f, 1.8296406f } },
        { { -0.48483858f, -0.76649946f, 0.19041255f, 1.560818f, -1.0684297f, 3.060109f, 5.086074f, 6.0648017f } },
        { { 0.5661633f, 0.06951574f, 0.40976918f, 0.57385f, 0.7817097f, -0.20328663f, 1.5073341f, 1.5204996f } },
        { { -0.9899026f, -0.72668636f, -0.23488401f, 0.029863315f, -0.94637644f, -1.833778f, 0.9014512f, -3.8029535f } },
        { { 0.93388784f, 0.4721116f, -0.80828613f, 0.71360666f, -0.94506806f, -1.8423402f, 4.9554005f, 0.43473297f } },
        { { 1.0512866f, -0.6845272f, -0.6612933f, -0.58249414f, -0.70962954f, 2.8576467f, 3.8895934f, -7.1489267f } },
        { { 0.8711602f, 1.3537266f, 1.189419f, -0.61543924f, -3.1743267f, -3.5325012f, 0.84733194f, 3.3239248f } },
        { { 0.67934954f, 1.367628f, 0.68895024f, -0.6804009f, 1.1193943f, -0.54618776f, -0.68521315f, 2.2229836f } },
        { { 0.7338877f, -1.3206555f, 0.8565288f, 0.41346246f, -3.286753f, -1.3837763f, 2.805225f, 7.589132f } },
        { { 0.8382341f, 0.3615428f, 0.08675511f, 0.4039286f, -0.6766732f, 2.7078872f, 3.242952f, -1.3135585f } },
        { { -1.0124564f, 0.17835632f, -0.36634147f, 1.7034618f, -0.9214818f, -2.7292998f, -4.764646f, -3.0440998f } },
    };
    static const swimmer_action_t actions[16] = {
        { -0.44940814f, -1.0f },
        { 0.60968125f, -0.4070042f },
        { 0.3507906f, -1.0f },
        { -0.20341079f, 1.0f },
        { -1.0f, -1.0f },
        { -1.0f, -1.0f },
        { -1.0f, -0.5291038f },
        { 0.46770015f, 0.37380776f },
        { 0.39220896f, 0.30342188f },
        { 1.0f, 1.0f },
        { 1.0f, -0.46674034f },
        { -0.66452277f, 0.7363179f },
        { -0.085380435f, 0.7499442f },
        { -1.0f, -0.1085392f },
        { 0.27315468f, -0.5679967f },
        { -0.51786333f, -0.6776091f },
    };
    uint32_t failures = swimmer_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        swimmer_action_t action;

        swimmer_infer(&states[vector], &action);
        if (!((action.rotor_1 >= actions[vector].rotor_1) && (action.rotor_1 <= actions[vector].rotor_1)) ||
            !((action.rotor_2 >= actions[vector].rotor_2) && (action.rotor_2 <= actions[vector].rotor_2))) {
            failures++;
        }
    }
    return failures;
}
#endif
