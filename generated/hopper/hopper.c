/*
 * A policy for Hopper-v5 of Gymnasium, score 2393.91 in validation, trained by tpg-train 0.1.0 with seed 3.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: 7eb551e1a4ae94a14031d271c973bb4a4dd0a017a738c426437aa239fa7b9ce4
 * 1 team, 1 edge, 1 program, 60 distinct operations.
 * A decision takes at most 60 operations.
 * Computes in f32 with own maths.
 */
#include "hopper.h"

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
static float hopper_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void hopper_infer(const hopper_state_t *state, hopper_action_t *action)
{
    const float term = 2.4094844f * state->height
        - 16.831106f * state->pitch
        - 0.9726171f * state->thigh_angle
        + 1.2704073f * state->leg_angle
        - 0.30623376f * state->foot_angle
        + 0.32980627f * state->vx
        - 0.14272827f * state->vz;
    const float thigh = term
        - 0.67063546f * state->pitch_speed
        + 0.084569946f * state->thigh_speed
        + 0.10996343f * state->leg_speed
        - 0.0139268385f * state->foot_speed
        - 4.385427f;
    const float term_2 = -0.48055917f * state->height
        - 15.44946f * state->pitch
        + 1.6838492f * state->thigh_angle
        - 1.7118963f * state->leg_angle
        - 0.05598478f * state->foot_angle
        + 0.3226204f * state->vz
        - 0.8628424f * state->pitch_speed;
    const float leg =
        term_2 - 0.12721324f * state->thigh_speed - 0.0822124f * state->leg_speed - 1.109722f;
    const float term_3 = 3.3940566f * state->height
        + 0.5165295f * state->pitch
        + 2.143888f * state->thigh_angle
        - 0.25035787f * state->leg_angle
        - 0.83269984f * state->vx
        + 0.02263618f * state->vz
        + 0.46339342f * state->pitch_speed;
    const float foot = term_3
        + 0.13614666f * state->thigh_speed
        - 0.039877187f * state->leg_speed
        - 0.0018393787f * state->foot_speed
        - 2.0928748f;

    action->thigh = hopper_clamp(thigh, -1.0f, 1.0f);
    action->leg = hopper_clamp(leg, -1.0f, 1.0f);
    action->foot = hopper_clamp(foot, -1.0f, 1.0f);
}

#ifndef HOPPER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t hopper_arithmetic(void)
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

uint32_t hopper_selftest(void)
{
    static const hopper_state_t states[4] = {
        { 1.160104f, -0.13523732f, -0.23954001f, -0.861511f, -0.56095904f, 2.8757875f, -0.25413963f, -0.44330215f, 6.5772467f, 4.529355f, -0.5022853f },
        { 1.3029174f, -0.13171338f, -0.58455014f, -0.53114593f, -0.5704712f, 4.358932f, 2.917252f, 0.8846019f, -7.3532085f, -4.289092f, -0.5909326f },
        { 1.1558936f, -0.14755645f, -0.80754155f, -0.90976024f, 0.10353037f, 0.53553545f, -2.8731844f, -0.5305484f, 8.76084f, 4.2468076f, -11.752636f },
        { 1.3049304f, -0.015093548f, -0.1274309f, -0.85573107f, 1.2784809f, -0.20440064f, 0.9506601f, 0.6452031f, 1.0647932f, 9.2183275f, -3.6207805f },
    };
    static const hopper_action_t actions[4] = {
        { 1.0f, 0.61642337f, -0.4131987f },
        { 0.38199186f, 1.0f, -1.0f },
        { 1.0f, -1.0f, 0.5387583f },
        { -1.0f, -1.0f, 1.0f },
    };
    uint32_t failures = hopper_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 4U; vector++) {
        hopper_action_t action;

        hopper_infer(&states[vector], &action);
        if (!((action.thigh >= actions[vector].thigh) && (action.thigh <= actions[vector].thigh)) ||
            !((action.leg >= actions[vector].leg) && (action.leg <= actions[vector].leg)) ||
            !((action.foot >= actions[vector].foot) && (action.foot <= actions[vector].foot))) {
            failures++;
        }
    }
    return failures;
}
#endif
