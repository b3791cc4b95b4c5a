/*
 * A policy for HalfCheetah-v5, score 5578.21 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix half_cheetah --profile fast
 * Graph SHA-256: 7ef378f3cc5a30791a19fb60e0bce0a2d1d8baa319d08a1c65bdbecc6eddd4bf
 * 1 team, 1 edge, 1 program, 145 distinct operations.
 * A decision takes at most 145 operations.
 * Computes in f32 with own maths.
 */
#include "half_cheetah.h"

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
static float half_cheetah_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void half_cheetah_infer(const half_cheetah_state_t *state, half_cheetah_action_t *action)
{
    const float term = 0.65299785f * state->height
        - 0.30417895f * state->pitch
        + 0.08986901f * state->back_thigh_angle
        + 0.1527143f * state->back_shin_angle
        + 0.10618001f * state->front_thigh_angle
        + 0.2887228f * state->front_shin_angle;
    const float term_2 = term
        - 0.042333245f * state->front_foot_angle
        + 0.030733766f * state->vx
        + 0.3018588f * state->vz
        - 0.07872877f * state->pitch_speed
        - 0.065849066f * state->back_thigh_speed
        + 0.00862241f * state->back_shin_speed;
    const float back_thigh = term_2
        + 0.02093927f * state->back_foot_speed
        - 0.035348557f * state->front_thigh_speed
        - 0.032005753f * state->front_shin_speed
        - 0.0015801959f * state->front_foot_speed
        + 0.25798228f;
    const float back_shin = state->front_thigh_speed + 0.024565589f;
    const float term_3 = -0.6643476f * state->height
        + 0.9206936f * state->back_shin_angle
        - 0.35221323f * state->back_foot_angle
        + 0.59571f * state->front_shin_angle
        - 0.12767485f * state->front_foot_angle
        - 0.093680136f * state->vx;
    const float term_4 = term_3
        + 0.13345654f * state->vz
        - 0.021074038f * state->pitch_speed
        + 0.031236362f * state->back_thigh_speed
        + 0.030699003f * state->back_foot_speed
        - 0.03184241f * state->front_thigh_speed
        + 0.011127887f * state->front_shin_speed;
    const float back_foot = term_4 + 0.021415437f * state->front_foot_speed + 0.0912914f;
    const float term_5 = -2.4914157f * state->height
        - 0.42017677f * state->back_thigh_angle
        - 0.4775143f * state->back_shin_angle
        - 0.15708983f * state->front_thigh_angle
        - 0.91896254f * state->front_shin_angle
        - 0.8898691f * state->front_foot_angle;
    const float term_6 = term_5
        - 0.025057836f * state->vx
        - 0.24128f * state->vz
        + 0.06779719f * state->pitch_speed
        + 0.017799746f * state->back_thigh_speed
        - 0.0094479555f * state->back_shin_speed
        - 0.031343386f * state->back_foot_speed;
    const float front_thigh = term_6
        - 0.007135808f * state->front_thigh_speed
        + 0.038320307f * state->front_shin_speed
        - 0.010964609f * state->front_foot_speed
        - 0.4173823f;
    const float term_7 = 0.33716694f * state->height
        + 0.32924032f * state->back_thigh_angle
        - 1.103007f * state->back_shin_angle
        + 0.716227f * state->back_foot_angle
        - 0.6825805f * state->front_thigh_angle
        + 1.313297f * state->front_shin_angle;
    const float term_8 = term_7
        - 0.09976387f * state->front_foot_angle
        - 0.023090838f * state->vx
        + 0.39377627f * state->vz
        - 0.011995308f * state->pitch_speed
        + 0.015915005f * state->back_thigh_speed
        + 0.008061846f * state->back_shin_speed;
    const float front_shin = term_8
        + 0.01730848f * state->front_thigh_speed
        - 0.016408563f * state->front_shin_speed
        + 0.007713775f * state->front_foot_speed
        + 0.24237464f;
    const float term_9 = 1.1094741f * state->height
        + 0.0f
        - 0.1943114f * state->back_thigh_angle
        + 0.30722198f * state->back_shin_angle
        + 0.13936892f * state->front_thigh_angle
        + 0.31880283f * state->front_shin_angle;
    const float term_10 = term_9
        - 0.7904248f * state->front_foot_angle
        + 0.09822248f * state->vx
        - 0.16976257f * state->vz
        - 0.034448557f * state->pitch_speed
        + 0.018111259f * state->back_shin_speed
        + 0.0048697935f * state->back_foot_speed;
    const float front_foot =
        term_10 + 0.021317588f * state->front_thigh_speed + 0.014080553f * state->front_foot_speed;

    action->back_thigh = half_cheetah_clamp(back_thigh, -1.0f, 1.0f);
    action->back_shin = half_cheetah_clamp(back_shin, -1.0f, 1.0f);
    action->back_foot = half_cheetah_clamp(back_foot, -1.0f, 1.0f);
    action->front_thigh = half_cheetah_clamp(front_thigh, -1.0f, 1.0f);
    action->front_shin = half_cheetah_clamp(front_shin, -1.0f, 1.0f);
    action->front_foot = half_cheetah_clamp(front_foot, -1.0f, 1.0f);
}

#ifndef HALF_CHEETAH_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t half_cheetah_arithmetic(void)
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

uint32_t half_cheetah_selftest(void)
{
    static const half_cheetah_state_t states[6] = {
        { -0.07578986f, -0.25904292f, 0.38371366f, -0.5330364f, -0.256026f, 0.12841003f, 0.039639257f, -0.58023244f, 7.6160426f, 0.81788206f, -0.2668682f, 3.098456f, -20.858036f, -14.216486f, -1.0536168f, -3.8012333f, 26.079159f },
        { 0.104447864f, 0.18322857f, -0.2453996f, -0.28069317f, 0.059489693f, -0.5808663f, -0.23219113f, -0.7645519f, -0.011227606f, 0.22987776f, -2.9131105f, -15.481769f, -20.81011f, 28.089489f, 12.569345f, -6.814314f, 4.193876f },
        { 0.04025006f, 0.059504054f, -0.122952946f, 0.9559731f, -0.50550264f, -0.048385065f, 0.24792176f, 0.18149675f, 7.8906145f, -0.24487121f, -0.34584013f, 16.211998f, -9.342992f, 6.8405757f, -10.739514f, -4.7367754f, 3.778403f },
        { 0.11295933f, -0.12406071f, 0.8056822f, 1.0433483f, 0.71596986f, 0.17778979f, 0.072533906f, 0.30335397f, 4.229935f, 0.5182273f, -0.40509468f, 5.803657f, 3.5664914f, -25.781918f, -13.061291f, -1.3435308f, -7.1803136f },
        { -0.005122496f, 0.05396527f, 0.36537558f, -0.7767403f, -0.4881826f, -1.1814283f, -0.17240855f, 0.19574022f, -0.26951623f, -0.31146538f, -2.008696f, 13.862792f, -14.506106f, -26.290506f, -9.055798f, 1.0319378f, -22.62699f },
        { 0.042995207f, -0.041013375f, 0.5557198f, 0.91620827f, -0.15619135f, 0.25741085f, -0.18438356f, -0.70920914f, 7.220109f, 1.584975f, 2.167218f, -1.2055126f, -23.925524f, 28.501541f, -0.859973f, -4.5588894f, 23.797058f },
    };
    static const half_cheetah_action_t actions[6] = {
        { 0.22811124f, -1.0f, -0.5498477f, 0.19192213f, 1.0f, 0.6829221f },
        { 1.0f, 1.0f, -0.21259508f, -1.0f, 0.7901198f, 0.6737919f },
        { 0.17607817f, -1.0f, 1.0f, -1.0f, -1.0f, 0.80795836f },
        { 0.5713017f, -1.0f, 0.047581315f, -1.0f, -0.17570387f, -0.0016072616f },
        { -1.0f, -1.0f, -1.0f, 1.0f, 1.0f, -1.0f },
        { 1.0f, -0.83540744f, 1.0f, -1.0f, -0.5668902f, 1.0f },
    };
    uint32_t failures = half_cheetah_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 6U; vector++) {
        half_cheetah_action_t action;

        half_cheetah_infer(&states[vector], &action);
        if (!((action.back_thigh >= actions[vector].back_thigh) && (action.back_thigh <= actions[vector].back_thigh)) ||
            !((action.back_shin >= actions[vector].back_shin) && (action.back_shin <= actions[vector].back_shin)) ||
            !((action.back_foot >= actions[vector].back_foot) && (action.back_foot <= actions[vector].back_foot)) ||
            !((action.front_thigh >= actions[vector].front_thigh) && (action.front_thigh <= actions[vector].front_thigh)) ||
            !((action.front_shin >= actions[vector].front_shin) && (action.front_shin <= actions[vector].front_shin)) ||
            !((action.front_foot >= actions[vector].front_foot) && (action.front_foot <= actions[vector].front_foot))) {
            failures++;
        }
    }
    return failures;
}
#endif
