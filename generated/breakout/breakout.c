/*
 * A policy for breakout, score 62.03 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix breakout --profile fast
 * Graph SHA-256: 07cacc72ff4d8168b411fe5271192326d495f22fd6bbc61534f2b1b6fe3ba596
 * 5 teams (5 on the longest walk), 14 edges, 14 programs, 8 distinct operations.
 * A decision takes at most 14 bids and 9 operations.
 * Computes in f32 with own maths.
 */
#include "breakout.h"

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

static float breakout_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float breakout_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
breakout_action_t breakout_infer(const breakout_state_t *state)
{
    {
        const float to_team_3 = breakout_negate_if_less(state->trail_at[1], state->paddle_at[0]);

        if ((to_team_3 >= -FLT_MAX) && !(0.0f >= to_team_3)) {
            goto team_3;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_2 = state->trail_at[1] + state->brick_near;
        if (to_team_2 >= best) {
            best = to_team_2;
            next = 1U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float right = state->ball_at[1] - state->paddle_at[1];
        if (right >= best) {
            next = 3U;
        }

        if (next == 2U) {
            return BREAKOUT_STAY;
        }
        if (next == 3U) {
            return BREAKOUT_RIGHT;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float stay = state->ball_near / state->trail_near;
        if (stay >= best) {
            best = stay;
            next = 1U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float to_team_3 = breakout_negate_if_less(state->trail_at[1], state->paddle_at[1]);
        if (to_team_3 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return BREAKOUT_STAY;
        }
        if (next == 2U) {
            goto team_4;
        }
    }

team_3:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float right = state->ball_at[1] - state->paddle_at[1];
        if (right >= best) {
            best = right;
            next = 1U;
        }

        const float to_team_4 = breakout_negate_if_less(state->ball_at[0], state->trail_at[0]);
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 2U;
        }

        if (0.0f >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return BREAKOUT_RIGHT;
        }
        if (next == 3U) {
            return BREAKOUT_LEFT;
        }
    }

team_4:
    {
        float best = -FLT_MAX;
        breakout_action_t action = BREAKOUT_RIGHT;
        const float left = breakout_max(state->trail_at[0], state->paddle_at[2]);
        if (left >= best) {
            best = left;
            action = BREAKOUT_LEFT;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            action = BREAKOUT_LEFT;
        }

        const float right = breakout_negate_if_less(state->ball_at[1], state->paddle_at[1]);
        if (right >= best) {
            action = BREAKOUT_RIGHT;
        }

        return action;
    }
}

/* A place in the image; row -1 if there is none. */
typedef struct breakout_place {
    int32_t row;
    int32_t column;
    int32_t contrast;
} breakout_place_t;

/* The first cell that is not 0. */
static breakout_place_t breakout_first(const uint8_t *image, uint32_t stride)
{
    breakout_place_t place = { -1, -1, 0 };
    uint32_t row;
    uint32_t column;

    for (row = 0U; (row < 10U) && (place.row < 0); row++) {
        for (column = 0U; (column < 10U) && (place.row < 0); column++) {
            if (image[(row * stride) + (column * 4U)] != 0U) {
                place.row = (int32_t)row;
                place.column = (int32_t)column;
            }
        }
    }
    return place;
}

/* The last cell that is not 0. */
static breakout_place_t breakout_last(const uint8_t *image, uint32_t stride)
{
    breakout_place_t place = { -1, -1, 0 };
    uint32_t row;
    uint32_t column;

    for (row = 10U; (row > 0U) && (place.row < 0); row--) {
        for (column = 10U; (column > 0U) && (place.row < 0); column--) {
            if (image[((row - 1U) * stride) + ((column - 1U) * 4U)] != 0U) {
                place.row = (int32_t)row - 1;
                place.column = (int32_t)column - 1;
            }
        }
    }
    return place;
}

/* The cell so far down and to the right of a place; 0 outside the image. */
static uint8_t breakout_cell(const uint8_t *image, uint32_t stride, breakout_place_t from, int32_t down, int32_t right)
{
    const int32_t row = from.row + down;
    const int32_t column = from.column + right;

    if ((from.row < 0) || (row < 0) || (row >= 10) || (column < 0) || (column >= 10)) {
        return 0U;
    }
    return image[((uint32_t)row * stride) + ((uint32_t)column * 4U)];
}

void breakout_look(const uint8_t *image, uint32_t stride, breakout_state_t *state)
{
    const breakout_place_t place_0 = breakout_first(&image[0U], stride);
    const breakout_place_t place_1 = breakout_last(&image[0U], stride);
    const breakout_place_t place_2 = breakout_last(&image[1U], stride);
    const breakout_place_t place_3 = breakout_first(&image[2U], stride);
    const breakout_place_t place_4 = breakout_last(&image[2U], stride);

    state->paddle_at[0] = (float)place_0.row;
    state->paddle_at[1] = (float)place_0.column;
    state->paddle_at[2] = (float)place_1.column;
    state->ball_at[0] = (float)place_2.row;
    state->ball_at[1] = (float)place_2.column;
    state->ball_near = (float)breakout_cell(&image[1U], stride, place_0, -1, 0);
    state->trail_at[0] = (float)place_3.column;
    state->trail_at[1] = (float)place_4.column;
    state->trail_near = (float)breakout_cell(&image[2U], stride, place_0, 0, 2);
    state->brick_near = (float)breakout_cell(&image[3U], stride, place_0, -2, 3);
}

#ifndef BREAKOUT_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t breakout_arithmetic(void)
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

uint32_t breakout_selftest(void)
{
    static const breakout_state_t states[24] = {
        { { 3.0248566f, -0.19616291f, 4.965602f }, { 1.1932458f, 1.836906f }, 0.7106102f, { 3.6108818f, 0.526527f }, 0.8747811f, 0.7066241f },
        { { 3.8325715f, 4.7720914f, -0.005404772f }, { 1.6391757f, 3.5345972f }, 0.28022873f, { 8.910324f, 8.123549f }, 0.94711745f, 0.13324392f },
        { { 2.436841f, 3.8030224f, 2.9733443f }, { -0.8630246f, -0.51080316f }, 0.18512952f, { 4.2552495f, 1.6813247f }, 0.08841649f, 0.10045459f },
        { { 8.910168f, 5.949953f, 0.08245458f }, { 4.7967205f, 6.307476f }, 0.7046505f, { 1.2342087f, 8.531366f }, 0.12823077f, 0.6325227f },
        { { -0.091101155f, 5.181184f, 5.5371523f }, { 1.3659892f, 4.5289f }, 0.39559788f, { 6.3788643f, 1e-45f }, 0.6178056f, 0.14471415f },
        { { -0.091101155f, 5.181184f, 5.5371523f }, { 1.3659892f, 4.5289f }, 0.39559788f, { 6.3788643f, 0.0f }, 0.6178056f, 0.14471415f },
        { { 5.623348f, 4.2842703f, 1.2898779f }, { 2.0084214f, 4.2842712f }, 0.6537789f, { 2.621315f, 4.680949f }, 0.25482947f, 0.35628444f },
        { { 5.623348f, 4.284271f, 1.2898779f }, { 2.0084214f, 4.284271f }, 0.653779f, { 2.6213148f, 4.680949f }, 0.25482944f, 0.3562844f },
        { { 8.040552f, 6.0278854f, 0.86228f }, { 2.3782396f, 2.367703f }, 0.95000315f, { 1.4386849f, 6.3740673f }, 0.14904189f, 0.19533342f },
        { { 8.040552f, 6.0278854f, 0.86228f }, { 2.3782396f, 2.367703f }, 0.95000315f, { 1.4386849f, 6.3740673f }, 0.1490419f, 0.19533342f },
        { { -0.012772577f, 4.120739f, 3.1138506f }, { 2.463988f, 4.1207395f }, 0.32934213f, { 3.47588f, 4.5333366f }, 0.4601912f, 0.1876602f },
        { { -0.012772577f, 4.120739f, 3.1138506f }, { 2.4639883f, 4.120739f }, 0.32934213f, { 3.4758797f, 4.5333366f }, 0.4601912f, 0.18766019f },
        { { 1.9541881f, 6.820471f, 2.6418095f }, { 3.5057507f, 6.062663f }, 0.3659894f, { 4.38931f, 1.9541881f }, 0.24195254f, 0.13106775f },
        { { 1.9541882f, 6.820471f, 2.6418095f }, { 3.5057507f, 6.062663f }, 0.3659894f, { 4.38931f, 1.9541881f }, 0.24195254f, 0.13106775f },
        { { 4.044978f, 1.3058653f, -0.2517892f }, { 2.7876706f, 3.2903748f }, 0.5890062f, { 4.9977083f, 1.8414073f }, 0.10470076f, 0.14310175f },
        { { 4.044978f, 1.3058654f, -0.2517892f }, { 2.7876706f, 3.2903745f }, 0.5890062f, { 4.9977083f, 1.8414074f }, 0.10470076f, 0.14310175f },
        { { 7.1986675f, 3.2970738f, 0.43240392f }, { 4.006215f, 6.5369415f }, 0.7516899f, { 4.30272f, 2.5929847f }, 0.46656865f, 0.64688337f },
        { { 7.1986675f, 3.2970736f, 0.43240392f }, { 4.006215f, 6.536942f }, 0.7516899f, { 4.30272f, 2.5929847f }, 0.46656862f, 0.64688337f },
        { { 4.7968273f, 2.0789614f, 3.0186257f }, { 6.77606f, 3.9342418f }, 0.846681f, { 4.9661293f, 0.0f }, 0.3484919f, 0.6995759f },
        { { 4.7968273f, 2.0789614f, 3.0186257f }, { 6.77606f, 3.9342418f }, 0.846681f, { 4.9661293f, -1e-45f }, 0.3484919f, 0.6995759f },
        { { 5.9609737f, 7.745001f, 7.3842983f }, { 4.276662f, 1.8760397f }, 0.22896147f, { 5.536767f, 5.9609737f }, 0.506289f, 0.32381773f },
        { { 5.9609737f, 7.745001f, 7.3842983f }, { 4.2766623f, 1.8760397f }, 0.22896145f, { 5.536767f, 5.9609733f }, 0.506289f, 0.3238177f },
        { { 8.361813f, 4.812211f, 8.573872f }, { 3.3743558f, 2.4680023f }, 0.7561342f, { 1.0554873f, 4.8122106f }, 0.5637429f, 0.8465383f },
        { { 8.361813f, 4.812211f, 8.573872f }, { 3.3743558f, 2.4680023f }, 0.7561343f, { 1.0554874f, 4.812211f }, 0.5637429f, 0.8465383f },
    };
    static const breakout_action_t actions[24] = {
        BREAKOUT_RIGHT,
        BREAKOUT_LEFT,
        BREAKOUT_STAY,
        BREAKOUT_RIGHT,
        BREAKOUT_LEFT,
        BREAKOUT_STAY,
        BREAKOUT_RIGHT,
        BREAKOUT_LEFT,
        BREAKOUT_STAY,
        BREAKOUT_LEFT,
        BREAKOUT_RIGHT,
        BREAKOUT_LEFT,
        BREAKOUT_LEFT,
        BREAKOUT_STAY,
        BREAKOUT_RIGHT,
        BREAKOUT_STAY,
        BREAKOUT_STAY,
        BREAKOUT_RIGHT,
        BREAKOUT_RIGHT,
        BREAKOUT_LEFT,
        BREAKOUT_LEFT,
        BREAKOUT_STAY,
        BREAKOUT_STAY,
        BREAKOUT_LEFT,
    };
    uint32_t failures = breakout_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (breakout_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
