/*
 * A policy for eye, score 83.64 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix eye --profile fast
 * Graph SHA-256: 341c772999931a4009a4dfc71578afe431a9c97694bd8bc3198e804daaa27ff4
 * 1 team, 2 edges, 2 programs, 10 distinct operations.
 * A decision takes at most 2 bids and 6 operations.
 * Computes in f32 with own maths.
 */
#include "eye.h"

#include <float.h>
#include <math.h>

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
static float eye_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. */
void eye_infer(const eye_state_t *state, eye_action_t *action)
{
    float tilt;
    float pan;

    const float to_leaf_0 = fabsf(state->image_bright[2]);
    const float to_leaf_1 = fabsf(state->image_dark[2]);

    if ((to_leaf_0 >= -FLT_MAX) && !(to_leaf_1 >= to_leaf_0)) {
        tilt = 1.1559905f * state->image_bright[0] - 13.0104475f;
        pan = 1.4439558f * state->image_bright[1] - 22.61637f;
    } else {
        tilt = 1.2042711f * state->image_dark[0] - 13.660074f;
        pan = 1.4263186f * state->image_dark[1] - 22.020496f;
    }

    action->tilt = eye_clamp(tilt, -2.0f, 2.0f);
    action->pan = eye_clamp(pan, -2.0f, 2.0f);
}

/* A place in the image; row -1 if there is none. */
typedef struct eye_place {
    int32_t row;
    int32_t column;
    int32_t contrast;
} eye_place_t;

/* The brightest window, and the darkest. */
typedef struct eye_windows {
    eye_place_t bright;
    eye_place_t dark;
} eye_windows_t;

/* The middle of a window, of which so many follow. */
static eye_place_t eye_middle_3(int32_t left, int32_t contrast)
{
    const int32_t number = 659 - left;
    const eye_place_t place = { (number / 30) + 1, (number % 30) + 1, contrast };

    return place;
}

/* The windows of 3 by 3 cells with the greatest and with the smallest sum; the first of equal ones. */
static eye_windows_t eye_windows_3(const uint8_t *image, uint32_t stride)
{
    eye_windows_t found;
    int32_t left = 660; /* windows that follow, below the sum: one comparison finds the first of equal ones */
    int32_t high = -1;
    int32_t low = INT32_MAX;
    uint32_t total = 0U;
    int32_t mean;
    uint32_t row;
    uint32_t column;

    for (row = 0U; row < 22U; row++) {
        const uint8_t *const cells = &image[row * stride];
        uint32_t column_0 =
            (uint32_t)cells[0U] + cells[0U + (1U * stride)] + cells[0U + (2U * stride)];
        uint32_t column_1 =
            (uint32_t)cells[1U] + cells[1U + (1U * stride)] + cells[1U + (2U * stride)];

        total += cells[0U];
        total += cells[1U];
        for (column = 2U; column < 32U; column++) {
            const uint8_t *const cell = &cells[column * 1U];
            const uint32_t newest = (uint32_t)cell[0] + cell[1U * stride] + cell[2U * stride];
            const int32_t sum = (int32_t)(newest + column_0 + column_1) * 65536;

            total += cell[0];
            left--;
            high = ((sum + left) > high) ? (sum + left) : high;
            low = ((sum - left) < low) ? (sum - left) : low;
            column_0 = column_1;
            column_1 = newest;
        }
    }
    for (row = 22U; row < 24U; row++) {
        for (column = 0U; column < 32U; column++) {
            total += image[(row * stride) + (column * 1U)];
        }
    }
    mean = (int32_t)((total * 9U) / 768U);
    found.bright = eye_middle_3(high % 65536, (high / 65536) - mean);
    left = (low + 65535) / 65536;
    found.dark = eye_middle_3((left * 65536) - low, mean - left);
    return found;
}

void eye_look(const uint8_t *image, uint32_t stride, eye_state_t *state)
{
    const eye_windows_t windows_0 = eye_windows_3(&image[0U], stride);

    state->image_bright[0] = (float)windows_0.bright.row;
    state->image_bright[1] = (float)windows_0.bright.column;
    state->image_bright[2] = (float)windows_0.bright.contrast;
    state->image_dark[0] = (float)windows_0.dark.row;
    state->image_dark[1] = (float)windows_0.dark.column;
    state->image_dark[2] = (float)windows_0.dark.contrast;
}

#ifndef EYE_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t eye_arithmetic(void)
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

uint32_t eye_selftest(void)
{
    static const eye_state_t states[6] = {
        { { 9.257171f, 2.491895f, 1369.1056f }, { 5.0444655f, 8.794409f, 1630.8505f } },
        { { 10.605028f, 4.7322335f, 2007.6226f }, { 16.252354f, 14.980972f, 1324.695f } },
        { { 2.287569f, 8.181444f, 1040.6901f }, { 6.4452605f, 30.722004f, 2093.8545f } },
        { { 21.783703f, 4.1305614f, 788.755f }, { 11.046951f, 12.317368f, 31.43586f } },
        { { 3.7765594f, 19.522938f, 716.1621f }, { 12.759396f, 14.827236f, 716.1621f } },
        { { 20.414246f, 14.958313f, 1635.819f }, { 17.927961f, 8.916489f, 1635.8188f } },
    };
    static const eye_action_t actions[6] = {
        { -2.0f, -2.0f },
        { -0.7511358f, -2.0f },
        { -2.0f, 2.0f },
        { 2.0f, -2.0f },
        { 1.7056971f, -0.87213326f },
        { 2.0f, -1.0172272f },
    };
    uint32_t failures = eye_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 6U; vector++) {
        eye_action_t action;

        eye_infer(&states[vector], &action);
        if (!((action.tilt >= actions[vector].tilt) && (action.tilt <= actions[vector].tilt)) ||
            !((action.pan >= actions[vector].pan) && (action.pan <= actions[vector].pan))) {
            failures++;
        }
    }
    return failures;
}
#endif
