/*
 * A policy for Swimmer-v5 of Gymnasium, score 358.95 in validation, trained by tpg-train 0.1.0 with seed 4.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 5f637141a7dc44d91b53d43bb274cbcfc9c048366af102d518443668c2fcf5ea
 * 1 team, 1 edge, 1 program, 28 distinct operations.
 * A decision takes at most 28 operations.
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
static float swimmer_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void swimmer_infer(const swimmer_state_t *state, swimmer_action_t *action)
{
    const float term = 0.7118727f * state->angle
        - 0.11251226f * state->angle_1
        - 0.69512516f * state->angle_2
        + 0.3123265f * state->vy
        - 0.27881774f * state->spin
        + 0.183991f * state->speed_1
        - 0.12982675f * state->speed_2;
    const float rotor_1 = term - 0.023436766f;
    const float term_2 = 0.26692712f * state->angle_1
        - 0.65130556f * state->angle_2
        - 0.31501192f * state->vx
        + 0.26088122f * state->vy
        - 0.35128272f * state->spin
        + 0.2057382f * state->speed_1
        + 0.08384997f * state->speed_2;
    const float rotor_2 = term_2 + 0.08995213f;

    action->rotor_1 = swimmer_clamp(rotor_1, -1.0f, 1.0f);
    action->rotor_2 = swimmer_clamp(rotor_2, -1.0f, 1.0f);
}

#ifndef SWIMMER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
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
    static const swimmer_state_t states[6] = {
        { -0.20323594f, -1.1910177f, 0.2598124f, -0.36338776f, -1.4888479f, 1.5853858f, -0.41966468f, -5.7735367f },
        { 0.8981445f, 0.6243391f, -0.058569092f, 0.5969186f, -2.7539806f, -1.7633986f, -0.49815387f, -3.723551f },
        { 1.1692394f, 1.2207154f, 1.2448785f, -0.5943667f, -1.0768665f, -0.14119682f, -1.0756276f, -8.006371f },
        { -1.0277425f, -0.88737875f, 0.060203478f, -0.23242228f, -2.8298142f, -2.988855f, 5.0327764f, 2.941224f },
        { -1.0565478f, -0.9770789f, 1.2294828f, 1.1927146f, -2.20877f, 0.8217478f, -4.2435904f, 2.136793f },
        { 0.56269425f, -0.1615916f, -0.55035204f, 1.4780854f, -3.0694587f, 0.97678906f, 4.0207562f, -6.8373165f },
    };
    static const swimmer_action_t actions[6] = {
        { -0.44940814f, -1.0f },
        { 0.60968125f, -0.4070042f },
        { 0.3507906f, -1.0f },
        { -0.20341079f, 1.0f },
        { -1.0f, -1.0f },
        { 1.0f, -0.95032704f },
    };
    uint32_t failures = swimmer_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 6U; vector++) {
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
