/*
 * A policy for mountain-car, score -98.59 in validation, trained by tpg-train 0.1.0 with seed 3.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix mountain_car --profile fast
 * Graph SHA-256: 619c5b1aa69f78a0619c4a681268039cf054605380d24d4a3f9d9b1441495474
 * 2 teams (2 on the longest walk), 7 edges, 6 programs, 11 distinct operations.
 * A decision takes at most 7 bids and 15 operations.
 * Computes in f32 with own maths.
 */
#include "mountain_car.h"

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

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
mountain_car_action_t mountain_car_infer(const mountain_car_state_t *state)
{
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_1 = -2.5000443f * state->position - 1.089072f;
        if (to_team_1 >= best) {
            best = to_team_1;
            next = 2U;
        }

        const float right =
            2.3253112f * state->position + 96.694336f * state->velocity - 1.0729886f;
        if (right >= best) {
            best = right;
            next = 1U;
        }

        const float to_team_1_2 = state->velocity - 1.0512869f;
        if (to_team_1_2 >= best) {
            best = to_team_1_2;
            next = 2U;
        }

        if (0.0f >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return MOUNTAIN_CAR_RIGHT;
        }
        if (next == 3U) {
            return MOUNTAIN_CAR_LEFT;
        }
    }

    {
        float best = -FLT_MAX;
        mountain_car_action_t action = MOUNTAIN_CAR_LEFT;
        const float right =
            2.3253112f * state->position + 96.694336f * state->velocity - 1.0729886f;
        if (right >= best) {
            best = right;
            action = MOUNTAIN_CAR_RIGHT;
        }

        const float right_2 =
            -2.1966188f * state->position + 99.67122f * state->velocity - 1.033289f;
        if (right_2 >= best) {
            best = right_2;
            action = MOUNTAIN_CAR_RIGHT;
        }

        if (0.0f >= best) {
            action = MOUNTAIN_CAR_LEFT;
        }

        return action;
    }
}

#ifndef MOUNTAIN_CAR_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t mountain_car_arithmetic(void)
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

uint32_t mountain_car_selftest(void)
{
    static const mountain_car_state_t states[24] = {
        { -0.47552583f, -0.058746282f },
        { -0.12619168f, -0.03929456f },
        { -0.689357f, 0.02948543f },
        { -0.3700413f, -0.048628625f },
        { -0.46217477f, 0.0001812678f },
        { -0.32290596f, 0.018861968f },
        { -0.436338f, 0.00075067574f },
        { -0.322906f, 0.018861968f },
        { -0.43562108f, 0.011925351f },
        { -0.46217477f, 0.00018126781f },
        { -0.93421817f, -0.010221928f },
        { -0.93421817f, -0.010221929f },
        { -0.30607378f, 0.018457185f },
        { -0.30607378f, 0.018457187f },
        { -0.78873765f, -0.0070157354f },
        { -0.78873765f, -0.007015736f },
        { -0.12322046f, 0.014059919f },
        { -0.12322046f, 0.01405992f },
        { -0.053916134f, 0.0123932855f },
        { -0.053916134f, 0.012393285f },
        { -0.9660803f, -0.010924128f },
        { -0.9660803f, -0.010924127f },
        { -0.9646678f, -0.010892997f },
        { -0.9646678f, -0.0108929975f },
    };
    static const mountain_car_action_t actions[24] = {
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_LEFT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_RIGHT,
        MOUNTAIN_CAR_LEFT,
    };
    uint32_t failures = mountain_car_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (mountain_car_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
