/*
 * A policy for dodge, score 11.39 in validation, trained by tpg-train 0.1.0 with seed 3.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix dodge --profile fast
 * Graph SHA-256: cdea7daabca328e27e33a768eb228f4f6759f7262ab7fd254d28e16436a5fda2
 * 2 teams (2 on the longest walk), 13 edges, 12 programs, 9 distinct operations.
 * Computes in f32 with own maths.
 */
#include "dodge.h"

#include <float.h>
#include <math.h>

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

static float dodge_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float dodge_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* The highest bid wins, of equal bids the last; NaN and minus infinity never win. Every team comes after all that lead to it. */
dodge_action_t dodge_infer(const dodge_state_t *state)
{
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float field_base_up = state->detour - state->second[0];
        if (field_base_up >= best) {
            best = field_base_up;
            next = 1U;
        }

        const float plan = fabsf(state->ahead[2]);
        if (plan >= best) {
            best = plan;
            next = 4U;
        }

        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 1U;
        }

        const float to_team_1 = 634.5653f / state->near[3];
        if (to_team_1 >= best) {
            best = to_team_1;
            next = 2U;
        }

        const float field_base_down = fabsf(state->second[1]);
        if (field_base_down >= best) {
            best = field_base_down;
            next = 3U;
        }

        const float plan_2 = dodge_negate_if_less(state->ahead[0], state->near[3]);
        if (plan_2 >= best) {
            best = plan_2;
            next = 4U;
        }

        const float plan_3 = 634.5653f / state->detour;
        if (plan_3 >= best) {
            best = plan_3;
            next = 4U;
        }

        const float plan_4 = dodge_max(state->ahead[0], state->near[3]);
        if (plan_4 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return DODGE_FIELD_BASE_UP;
        }
        if (next == 3U) {
            return DODGE_FIELD_BASE_DOWN;
        }
        if (next == 4U) {
            return DODGE_PLAN;
        }
    }

    {
        float best = -FLT_MAX;
        dodge_action_t action = DODGE_PLAN;
        const float plan = 634.5653f / state->detour;
        if (plan >= best) {
            best = plan;
            action = DODGE_PLAN;
        }

        const float plan_2 = dodge_negate_if_less(state->ahead[0], state->near[3]);
        if (plan_2 >= best) {
            best = plan_2;
            action = DODGE_PLAN;
        }

        const float field_wrist_up = state->left[3] - state->second[0];
        if (field_wrist_up >= best) {
            best = field_wrist_up;
            action = DODGE_FIELD_WRIST_UP;
        }

        const float plan_3 = dodge_max(state->ahead[0], state->near[3]);
        if (plan_3 >= best) {
            best = plan_3;
            action = DODGE_PLAN;
        }

        const float plan_4 = state->ahead[0] - state->near[3];
        if (plan_4 >= best) {
            action = DODGE_PLAN;
        }

        return action;
    }
}

#ifndef DODGE_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold: of some flags, such as clang's -fno-honor-nans and -ffp-contract=fast, no macro
 * tells, nor of a processor that flushes small numbers to 0. */
static uint32_t dodge_arithmetic(void)
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

uint32_t dodge_selftest(void)
{
    static const dodge_state_t states[5] = {
        { { -798.83746f, -3437.4966f, 791.021f, -2299.293f }, { 212.05965f, 1.6848818f, -54.47656f, -486.28622f, 524.6935f, 289.2737f }, { 431.5829f, 0.6176731f }, { 15.913524f, 42.22681f, 453.45972f }, 71.45833f, 991.03235f },
        { { 3378.0115f, 3662.7864f, -3004.4658f, -1280.5398f }, { 428.33246f, -0.8213245f, -680.8234f, -631.51245f, -440.81866f, 35.73496f }, { 194.94572f, -3.292668f }, { 16.072735f, 158.56268f, 694.9953f }, 27.602592f, 579.67206f },
        { { 1890.2844f, 1676.4972f, -2265.736f, 3712.0955f }, { 41.05384f, 1.0601817f, 425.44437f, 113.88391f, 559.45074f, -168.96976f }, { 424.5209f, 3.3775117f }, { 54.166958f, 100.13097f, 281.72845f }, 57.8414f, 571.86273f },
        { { 3575.2573f, -1270.4752f, 3336.788f, 4064.8442f }, { 878.32214f, 1.8593637f, 21.318727f, 209.8958f, 96.05679f, 160.06702f }, { 419.22214f, 1.1870021f }, { 97.05278f, 10.423394f, 240.56326f }, 107.23047f, 365.8804f },
        { { -617.7782f, 1882.3066f, 795.99634f, 1992.4148f }, { 390.7505f, -0.24648851f, 285.7298f, 1.4403389f, -204.84738f, -16.838478f }, { 359.09845f, 2.6948938f }, { 25.900803f, 80.76247f, 440.5667f }, 113.26691f, 478.42664f },
    };
    static const dodge_action_t actions[5] = {
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
    };
    uint32_t failures = dodge_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 5U; vector++) {
        if (dodge_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
