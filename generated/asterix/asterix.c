/*
 * A policy for asterix, score 18.18 in validation, trained by tpg-train 0.1.0 with seed 2.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix asterix --profile fast
 * Graph SHA-256: 4061f7d0b45d5d0664d2fb6680afe7f598172fed250250341c63b04254539c66
 * 14 teams (14 on the longest walk), 57 edges, 56 programs, 38 distinct operations.
 * A decision takes at most 57 bids and 46 operations.
 * Computes in f32 with own maths.
 */
#include "asterix.h"

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

static float asterix_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float asterix_min(float a, float b)
{
    return (a < b) ? a : b;
}

static float asterix_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
asterix_action_t asterix_infer(const asterix_state_t *state)
{
    {
        const float to_team_1 = state->player_at[0] + state->gold_near[7];

        if (!(to_team_1 >= 0.0f)) {
            goto team_9;
        }
    }

    {
        const float up = state->gold_near[2] / state->trail_near[5];

        if ((up >= -FLT_MAX) && !(0.0f >= up)) {
            return ASTERIX_UP;
        }
    }

    {
        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        float best = zero;
        uint32_t next = 1U;
        const float stay = state->gold_near[6] / state->enemy_near[5];
        if (stay >= best) {
            best = stay;
            next = 3U;
        }

        const float to_team_3 = asterix_max(state->player_at[1], state->player_at[0]);
        if (to_team_3 >= best) {
            best = to_team_3;
            next = 2U;
        }

        const float stay_2 = state->gold_near[3] / 0.0f;
        if (stay_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            goto team_8;
        }
        if (next == 3U) {
            return ASTERIX_STAY;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_11 = state->gold_near[3] / state->enemy_near[13];
        if (to_team_11 >= best) {
            best = to_team_11;
            next = 1U;
        }

        const float down = asterix_negate_if_less(state->enemy_near[4], state->player_at[1]);
        if (down >= best) {
            best = down;
            next = 2U;
        }

        const float stay = fabsf(state->enemy_near[2]);
        if (stay >= best) {
            best = stay;
            next = 3U;
        }

        if (0.0f >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_11;
        }
        if (next == 2U) {
            return ASTERIX_DOWN;
        }
        if (next == 3U) {
            return ASTERIX_STAY;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float stay = state->gold_near[4] - state->enemy_near[4];
        if (stay >= best) {
            best = stay;
            next = 1U;
        }

        const float term = asterix_min(state->enemy_near[12], state->gold_at[3]);
        const float up = asterix_negate_if_less(term, -1.2375401f);
        if (up >= best) {
            best = up;
            next = 2U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 3U;
        }

        const float to_team_5_2 = state->enemy_near[11] - 0.058283113f;
        if (to_team_5_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return ASTERIX_STAY;
        }
        if (next == 2U) {
            return ASTERIX_UP;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_6 = state->gold_near[3] / state->enemy_near[11];
        if (to_team_6 >= best) {
            best = to_team_6;
            next = 1U;
        }

        const float to_team_7 = state->enemy_near[0] + 0.095409065f;
        if (to_team_7 >= best) {
            best = to_team_7;
            next = 2U;
        }

        const float stay = state->gold_near[5] / 0.0f;
        if (stay >= best) {
            best = stay;
            next = 3U;
        }

        const float stay_2 = fabsf(state->enemy_near[2]);
        if (stay_2 >= best) {
            best = stay_2;
            next = 3U;
        }

        const float stay_3 = state->gold_near[1] / state->enemy_near[13];
        if (stay_3 >= best) {
            best = stay_3;
            next = 3U;
        }

        if (0.0f >= best) {
            next = 4U;
        }

        if (next == 2U) {
            goto team_7;
        }
        if (next == 3U) {
            return ASTERIX_STAY;
        }
        if (next == 4U) {
            goto team_8;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float stay = state->gold_near[4] - state->enemy_near[4];
        if (stay >= best) {
            best = stay;
            next = 3U;
        }

        const float stay_2 = fabsf(state->enemy_near[10]);
        if (stay_2 >= best) {
            best = stay_2;
            next = 3U;
        }

        const float to_team_7 = state->enemy_near[0] + 0.09617237f;
        if (to_team_7 >= best) {
            best = to_team_7;
            next = 1U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float stay_3 = fabsf(state->enemy_near[2]);
        if (stay_3 >= best) {
            next = 3U;
        }

        if (next == 2U) {
            goto team_8;
        }
        if (next == 3U) {
            return ASTERIX_STAY;
        }
    }

team_7:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float left = state->enemy_near[2] * state->enemy_near[0];
        if (left >= best) {
            best = left;
            next = 1U;
        }

        const float stay = fabsf(state->enemy_near[7]);
        if (stay >= best) {
            best = stay;
            next = 2U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 3U;
        }

        const float to_team_10 = state->gold_near[0] - state->enemy_near[4];
        if (to_team_10 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return ASTERIX_LEFT;
        }
        if (next == 2U) {
            return ASTERIX_STAY;
        }
        if (next == 4U) {
            goto team_10;
        }
    }

team_8:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_10 = state->gold_near[0] - state->enemy_near[4];
        if (to_team_10 >= best) {
            best = to_team_10;
            next = 1U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float stay = state->gold_near[3] / state->enemy_near[13];
        if (stay >= best) {
            next = 3U;
        }

        if (next == 1U) {
            goto team_10;
        }
        if (next == 3U) {
            return ASTERIX_STAY;
        }
    }

team_9:
    {
        const float to_team_10 = state->gold_near[0] - state->enemy_near[4];

        if (!(to_team_10 >= 0.0f)) {
            return ASTERIX_UP;
        }
    }

team_10:
    {
        const float to_team_11 = state->trail_near[0] - state->enemy_near[3];

        if (!(to_team_11 >= 0.0f)) {
            goto team_13;
        }
    }

team_11:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float stay = 0.5620203f / state->gold_at[1];
        if (stay >= best) {
            best = stay;
            next = 2U;
        }

        const float to_team_12 = state->gold_at[3] / state->player_at[1];
        if (to_team_12 >= best) {
            best = to_team_12;
            next = 3U;
        }

        const float to_team_12_2 = state->gold_at[0] / state->player_at[2];
        if (to_team_12_2 >= best) {
            best = to_team_12_2;
            next = 3U;
        }

        const float to_team_12_3 = asterix_min(state->trail_near[1], -0.026303096f);
        if (to_team_12_3 >= best) {
            best = to_team_12_3;
            next = 3U;
        }

        const float up = state->gold_near[8] / state->enemy_near[6];
        if (up >= best) {
            best = up;
            next = 1U;
        }

        const float stay_2 = state->gold_near[1] / state->enemy_near[13];
        if (stay_2 >= best) {
            best = stay_2;
            next = 2U;
        }

        const float to_team_12_4 = state->gold_at[3] - state->player_at[1];
        if (to_team_12_4 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return ASTERIX_UP;
        }
        if (next == 2U) {
            return ASTERIX_STAY;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 2U;
        const float stay = fabsf(state->enemy_near[2]);
        if (stay >= best) {
            best = stay;
            next = 2U;
        }

        const float stay_2 = asterix_negate_if_less(state->enemy_near[8], -0.08727101f);
        if (stay_2 >= best) {
            best = stay_2;
            next = 2U;
        }

        const float stay_3 = asterix_negate_if_less(state->enemy_near[9], -1.0024955f);
        if (stay_3 >= best) {
            best = stay_3;
            next = 2U;
        }

        if (0.014311783f >= best) {
            best = 0.014311783f;
            next = 2U;
        }

        const float stay_5 = state->trail_near[4] / state->enemy_near[13];
        if (stay_5 >= best) {
            best = stay_5;
            next = 2U;
        }

        const float to_team_13 = 0.034219213f * state->gold_at[2];
        if (to_team_13 >= best) {
            best = to_team_13;
            next = 1U;
        }

        const float to_team_13_2 = 0.033292964f * state->gold_at[2];
        if (to_team_13_2 >= best) {
            best = to_team_13_2;
            next = 1U;
        }

        const float stay_6 = fabsf(state->enemy_near[1]);
        if (stay_6 >= best) {
            next = 2U;
        }

        if (next == 2U) {
            return ASTERIX_STAY;
        }
    }

team_13:
    {
        float best = -FLT_MAX;
        asterix_action_t action = ASTERIX_DOWN;
        const float stay = asterix_negate_if_less(state->enemy_near[8], -0.084591985f);
        if (stay >= best) {
            best = stay;
            action = ASTERIX_STAY;
        }

        const float up = state->player_at[1] - state->gold_at[0];
        if (up >= best) {
            best = up;
            action = ASTERIX_UP;
        }

        const float trail_near_2_term = fabsf(state->trail_near[2]);
        const float stay_2 = asterix_max(trail_near_2_term, state->trail_near[3]);
        if (stay_2 >= best) {
            best = stay_2;
            action = ASTERIX_STAY;
        }

        if (0.0f >= best) {
            action = ASTERIX_DOWN;
        }

        return action;
    }
}

/* A place in the image; row -1 if there is none. */
typedef struct asterix_place {
    int32_t row;
    int32_t column;
    int32_t contrast;
} asterix_place_t;

/* The first cell that is not 0. */
static asterix_place_t asterix_first(const uint8_t *image, uint32_t stride)
{
    asterix_place_t place = { -1, -1, 0 };
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
static asterix_place_t asterix_last(const uint8_t *image, uint32_t stride)
{
    asterix_place_t place = { -1, -1, 0 };
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
static uint8_t asterix_cell(const uint8_t *image, uint32_t stride, asterix_place_t from, int32_t down, int32_t right)
{
    const int32_t row = from.row + down;
    const int32_t column = from.column + right;

    if ((from.row < 0) || (row < 0) || (row >= 10) || (column < 0) || (column >= 10)) {
        return 0U;
    }
    return image[((uint32_t)row * stride) + ((uint32_t)column * 4U)];
}

void asterix_look(const uint8_t *image, uint32_t stride, asterix_state_t *state)
{
    const asterix_place_t place_0 = asterix_first(&image[0U], stride);
    const asterix_place_t place_1 = asterix_last(&image[0U], stride);
    const asterix_place_t place_2 = asterix_first(&image[3U], stride);
    const asterix_place_t place_3 = asterix_last(&image[3U], stride);

    state->player_at[0] = (float)place_0.row;
    state->player_at[1] = (float)place_1.row;
    state->player_at[2] = (float)place_1.column;
    state->enemy_near[0] = (float)asterix_cell(&image[1U], stride, place_0, -2, -2);
    state->enemy_near[1] = (float)asterix_cell(&image[1U], stride, place_0, -1, -1);
    state->enemy_near[2] = (float)asterix_cell(&image[1U], stride, place_0, -1, 0);
    state->enemy_near[3] = (float)asterix_cell(&image[1U], stride, place_0, 0, -1);
    state->enemy_near[4] = (float)asterix_cell(&image[1U], stride, place_0, 0, 1);
    state->enemy_near[5] = (float)asterix_cell(&image[1U], stride, place_0, 0, 2);
    state->enemy_near[6] = (float)asterix_cell(&image[1U], stride, place_0, 0, 3);
    state->enemy_near[7] = (float)asterix_cell(&image[1U], stride, place_0, 1, -1);
    state->enemy_near[8] = (float)asterix_cell(&image[1U], stride, place_0, 1, 0);
    state->enemy_near[9] = (float)asterix_cell(&image[1U], stride, place_0, 1, 1);
    state->enemy_near[10] = (float)asterix_cell(&image[1U], stride, place_0, 1, 3);
    state->enemy_near[11] = (float)asterix_cell(&image[1U], stride, place_0, 2, -2);
    state->enemy_near[12] = (float)asterix_cell(&image[1U], stride, place_0, 2, 0);
    state->enemy_near[13] = (float)asterix_cell(&image[1U], stride, place_0, 4, -1);
    state->trail_near[0] = (float)asterix_cell(&image[2U], stride, place_0, -4, -2);
    state->trail_near[1] = (float)asterix_cell(&image[2U], stride, place_0, -2, 2);
    state->trail_near[2] = (float)asterix_cell(&image[2U], stride, place_0, -2, 3);
    state->trail_near[3] = (float)asterix_cell(&image[2U], stride, place_0, 1, -4);
    state->trail_near[4] = (float)asterix_cell(&image[2U], stride, place_0, 4, -4);
    state->trail_near[5] = (float)asterix_cell(&image[2U], stride, place_0, 4, -1);
    state->gold_at[0] = (float)place_2.row;
    state->gold_at[1] = (float)place_2.column;
    state->gold_at[2] = (float)place_3.row;
    state->gold_at[3] = (float)place_3.column;
    state->gold_near[0] = (float)asterix_cell(&image[3U], stride, place_0, -4, -2);
    state->gold_near[1] = (float)asterix_cell(&image[3U], stride, place_0, -3, 2);
    state->gold_near[2] = (float)asterix_cell(&image[3U], stride, place_0, -1, 0);
    state->gold_near[3] = (float)asterix_cell(&image[3U], stride, place_0, 0, -2);
    state->gold_near[4] = (float)asterix_cell(&image[3U], stride, place_0, 0, -1);
    state->gold_near[5] = (float)asterix_cell(&image[3U], stride, place_0, 0, 1);
    state->gold_near[6] = (float)asterix_cell(&image[3U], stride, place_0, 0, 2);
    state->gold_near[7] = (float)asterix_cell(&image[3U], stride, place_0, 1, -4);
    state->gold_near[8] = (float)asterix_cell(&image[3U], stride, place_0, 4, -1);
}

#ifndef ASTERIX_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t asterix_arithmetic(void)
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

uint32_t asterix_selftest(void)
{
    static const asterix_state_t states[24] = {
        { { 3.0248566f, -0.19616291f, 4.965602f }, { 0.21932457f, 0.2836906f, 0.7106102f, 0.46108818f, 0.1526527f, 0.8747811f, 0.7066241f, 0.48325714f, 0.5772091f, 0.09945952f, 0.26391757f, 0.4534597f, 0.28022873f, 0.99103236f }, { 0.91235495f, 0.94711745f, 0.13324392f, 0.3436841f, 0.48030224f, 0.39733443f }, { -0.8630246f, -0.51080316f, 0.85129523f, 4.2552495f }, { 0.26813248f, 0.08841649f, 0.10045459f, 0.99101675f, 0.6949953f, 0.108245455f, 0.57967204f, 0.73074764f, 0.7046505f } },
        { { 1.2342087f, 8.531366f, 0.28230762f }, { 0.6325227f, 0.80388886f, 0.5813457f, 0.89960766f, 0.3793073f, 0.4768372f, 0.922189f, 0.3385435f, 0.6258185f, 0.28172845f, 0.22682902f, 0.5718627f, 0.9364328f, 0.3449127f }, { 0.90732276f, 0.9961968f, 0.8893838f, 0.73242044f, 0.5152277f, 0.6499256f }, { 4.68612f, 5.143336f, 3.7202013f, 5.4837527f }, { 0.60657984f, 0.065146215f, 0.24056327f, 0.42051163f, 0.3658804f, 0.36268634f, 0.2545297f, 0.58948886f, 0.2752873f } },
        { { 7.901086f, 5.5411043f, 1.1645395f }, { 0.6206962f, 0.36287686f, 0.2533876f, 0.98349655f, 0.53900975f, 0.9404517f, 0.25510684f, 0.26876456f, 0.13766856f, 0.39716187f, 0.88031644f, 0.8799096f, 0.06705855f, 0.86320966f }, { 0.95823956f, 0.92738104f, 0.12539066f, 0.03824791f, 0.027937882f, 0.58422893f }, { 6.1881175f, 6.8095717f, 8.630351f, 6.4927826f }, { 0.10118092f, 0.6635079f, 0.4262807f, 0.43527922f, 0.6502973f, 0.80434424f, 0.03566284f, 0.8089148f, 0.5088392f } },
        { { -0.7812382f, 2.145552f, 6.7451863f }, { 0.98424685f, 0.8490902f, 0.6159677f, 0.534974f, 0.5052861f, 0.40196106f, 0.8603401f, 0.81706184f, 0.43020892f, 0.055474676f, 0.5527742f, 0.37372962f, 0.9895929f, 0.36631155f }, { 0.13507651f, 0.0387948f, 0.32251278f, 0.26626146f, 0.29617855f, 0.84071004f }, { 6.6314454f, 1.3266485f, 7.458132f, 7.606371f }, { 0.49251875f, 0.9189292f, 0.76348084f, 0.6174363f, 0.8975895f, 0.782076f, 0.9986131f, 0.5877841f, 0.6213623f } },
        { { -0.3153261f, 2.8547306f, 4.4868536f }, { 0.4793802f, 0.05113866f, 0.31214082f, 0.42453605f, 0.02692262f, 0.14881745f, 0.69390786f, 0.08647592f, 0.3960029f, 0.021177355f, 0.37264788f, 0.7292069f, 0.26612604f, 0.79642594f }, { 0.58993626f, 0.69455147f, 0.8654436f, 0.21177265f, 0.72443867f, 0.8786657f }, { 1.559799f, 7.694519f, 1.0883734f, -0.36704087f }, { 0.80662143f, 0.7505628f, 0.36305004f, 0.24377736f, 0.6388166f, 0.21140522f, 0.3539229f, 0.3153261f, 0.37962788f } },
        { { -0.31532612f, 2.8547306f, 4.4868536f }, { 0.4793802f, 0.05113866f, 0.31214082f, 0.42453605f, 0.02692262f, 0.14881745f, 0.69390786f, 0.08647592f, 0.3960029f, 0.021177355f, 0.37264788f, 0.7292069f, 0.26612604f, 0.79642594f }, { 0.58993626f, 0.69455147f, 0.8654436f, 0.21177265f, 0.72443867f, 0.8786657f }, { 1.559799f, 7.694519f, 1.0883734f, -0.36704087f }, { 0.80662143f, 0.7505628f, 0.36305004f, 0.24377736f, 0.6388166f, 0.21140522f, 0.3539229f, 0.3153261f, 0.37962788f } },
        { { -0.315747f, 2.7103543f, 4.4294357f }, { 0.47460258f, 0.029989854f, 0.32591194f, 0.41751873f, 0.028449884f, 0.15357941f, 0.7009709f, 0.07968499f, 0.38751286f, 0.040434446f, 0.39486915f, 0.729233f, 0.26932043f, 0.7920277f }, { 0.5949198f, 0.6954346f, 0.8817463f, 0.2135692f, 0.7175852f, 0.8787209f }, { 1.6529422f, 7.7298603f, 1.360542f, -0.4077796f }, { 0.8154948f, 0.7548014f, 0.35017717f, 0.25281686f, 0.64168763f, 0.20982987f, 0.37601894f, 0.31574696f, 0.35644555f } },
        { { -0.31574696f, 2.7103543f, 4.4294357f }, { 0.47460258f, 0.029989854f, 0.32591194f, 0.41751873f, 0.028449886f, 0.15357941f, 0.7009709f, 0.07968499f, 0.38751286f, 0.04043445f, 0.39486915f, 0.729233f, 0.26932043f, 0.7920277f }, { 0.5949198f, 0.6954346f, 0.8817463f, 0.2135692f, 0.7175852f, 0.8787209f }, { 1.6529422f, 7.7298603f, 1.360542f, -0.40777957f }, { 0.8154948f, 0.7548014f, 0.35017717f, 0.25281686f, 0.64168763f, 0.20982987f, 0.37601894f, 0.31574696f, 0.35644555f } },
        { { -0.55477595f, 0.5809357f, 0.8430903f }, { 0.6039772f, 0.6026739f, 0.6094209f, 0.719151f, 0.73905194f, 0.6495992f, 0.9686949f, 0.42193308f, 0.55762947f, 0.23788616f, 0.26169837f, 0.35546932f, 0.7093915f, 0.7973767f }, { 0.39890945f, 0.2927618f, 0.42917818f, 0.1778017f, 0.11981174f, 0.74251604f }, { 1.2550008f, 3.8549454f, 2.2449226f, 4.299819f }, { 0.7390519f, 0.7629092f, 0.6778069f, 0.2981245f, 0.4359966f, 0.7425331f, 0.7741337f, 0.3638535f, 0.943702f } },
        { { -0.55477595f, 0.5809357f, 0.8430903f }, { 0.6039772f, 0.6026739f, 0.6094209f, 0.719151f, 0.73905194f, 0.6495992f, 0.9686949f, 0.4219331f, 0.55762947f, 0.23788616f, 0.26169837f, 0.3554693f, 0.7093915f, 0.79737675f }, { 0.39890945f, 0.2927618f, 0.42917818f, 0.1778017f, 0.11981174f, 0.74251604f }, { 1.2550008f, 3.8549452f, 2.2449226f, 4.299819f }, { 0.73905194f, 0.7629092f, 0.677807f, 0.2981245f, 0.4359966f, 0.7425331f, 0.7741337f, 0.3638535f, 0.943702f } },
        { { -0.46013674f, -0.4318494f, -0.554137f }, { 0.6579317f, 0.5257369f, 0.6675675f, 0.7120172f, 0.71579456f, 0.70257986f, 0.93292713f, 0.5184226f, 0.58924556f, 0.23745558f, 0.28828233f, 0.1420877f, 0.97983265f, 0.95468783f }, { 0.40207475f, 0.14376044f, 0.40463716f, 0.1555973f, 0.15921226f, 0.83825624f }, { 0.3101182f, 3.1712208f, 1.3137941f, 3.8060741f }, { 0.8583782f, 0.8114822f, 0.83357275f, 0.41388834f, 0.27219748f, 0.7080405f, 0.8207408f, 0.4601367f, 0.89607155f } },
        { { -0.4601367f, -0.43184936f, -0.554137f }, { 0.6579317f, 0.5257369f, 0.6675675f, 0.7120172f, 0.71579456f, 0.70257986f, 0.93292713f, 0.5184226f, 0.58924556f, 0.23745558f, 0.28828233f, 0.1420877f, 0.97983265f, 0.95468783f }, { 0.40207475f, 0.14376044f, 0.40463716f, 0.1555973f, 0.15921226f, 0.83825624f }, { 0.3101182f, 3.1712208f, 1.3137941f, 3.8060741f }, { 0.8583782f, 0.8114822f, 0.83357275f, 0.41388834f, 0.27219748f, 0.7080405f, 0.8207408f, 0.4601367f, 0.89607155f } },
        { { -0.4452669f, 0.4892673f, 4.037759f }, { 0.7992619f, 0.40994865f, 0.17160726f, 0.53475595f, 0.8418889f, 0.485498f, 0.95379484f, 0.65247095f, 0.8389255f, 0.8291788f, 0.7704823f, 0.35582387f, 0.18454081f, 0.9506438f }, { 0.910213f, 0.55087185f, 0.060091257f, 0.94164026f, 0.3881228f, 0.9002708f }, { 2.4559093f, 2.8395467f, 1.7815764f, 2.9685793f }, { 0.9523678f, 0.55111146f, 0.7219081f, 0.35536158f, 0.835842f, 0.7999344f, 0.8087615f, 0.4452669f, 0.88543344f } },
        { { -0.44526693f, 0.4892673f, 4.037759f }, { 0.7992619f, 0.40994865f, 0.17160726f, 0.53475595f, 0.8418889f, 0.485498f, 0.95379484f, 0.65247095f, 0.8389255f, 0.8291788f, 0.7704823f, 0.35582387f, 0.18454081f, 0.9506438f }, { 0.910213f, 0.55087185f, 0.060091257f, 0.94164026f, 0.3881228f, 0.9002708f }, { 2.4559093f, 2.8395467f, 1.7815764f, 2.9685793f }, { 0.9523678f, 0.55111146f, 0.7219081f, 0.35536158f, 0.835842f, 0.7999344f, 0.8087615f, 0.4452669f, 0.88543344f } },
        { { -0.40520903f, 0.23180264f, 3.794989f }, { 0.829401f, 0.41816556f, 0.18807667f, 0.5390365f, 0.8399831f, 0.53002834f, 0.9847673f, 0.60273063f, 0.8776604f, 0.88878286f, 0.7787999f, 0.311235f, 0.19433841f, 0.9429457f }, { 0.9178455f, 0.61010396f, 0.052376445f, 0.931152f, 0.31865102f, 0.85562813f }, { 2.9227767f, 2.7479186f, 2.1011424f, 2.7658653f }, { 0.96379864f, 0.56434083f, 0.7437526f, 0.33938646f, 0.8387208f, 0.74700224f, 0.8157997f, 0.405209f, 0.8780291f } },
        { { -0.405209f, 0.23180264f, 3.794989f }, { 0.829401f, 0.41816556f, 0.18807667f, 0.5390365f, 0.8399831f, 0.53002834f, 0.9847673f, 0.60273063f, 0.8776604f, 0.88878286f, 0.7787999f, 0.311235f, 0.19433841f, 0.9429457f }, { 0.9178455f, 0.61010396f, 0.05237645f, 0.931152f, 0.31865102f, 0.85562813f }, { 2.9227767f, 2.7479186f, 2.1011424f, 2.7658653f }, { 0.96379864f, 0.56434083f, 0.7437526f, 0.33938646f, 0.8387208f, 0.74700224f, 0.8157997f, 0.405209f, 0.8780291f } },
        { { -0.09447323f, 6.8449793f, 0.70737875f }, { 0.3155192f, 0.5934504f, 0.49122572f, 0.46362942f, 0.39281428f, 0.84052944f, 0.39655578f, 0.74273634f, 0.8687279f, 0.0025528935f, 0.4427232f, 0.85926425f, 0.8638476f, 0.1280008f }, { 0.06139291f, 0.64760804f, 0.18406233f, 0.30091226f, 0.2950223f, 0.15079108f }, { 8.690601f, -0.45721298f, 6.211344f, 4.8551607f }, { 0.8855437f, 0.18380675f, 0.16841814f, 0.5915824f, 0.21739769f, 0.23139724f, 0.7112917f, 0.09447323f, 0.76074016f } },
        { { -0.094473235f, 6.8449793f, 0.70737875f }, { 0.3155192f, 0.5934504f, 0.49122572f, 0.46362942f, 0.39281428f, 0.84052944f, 0.39655578f, 0.74273634f, 0.8687279f, 0.0025528935f, 0.4427232f, 0.85926425f, 0.8638476f, 0.1280008f }, { 0.06139291f, 0.64760804f, 0.18406233f, 0.30091226f, 0.2950223f, 0.15079108f }, { 8.690601f, -0.45721298f, 6.211344f, 4.8551607f }, { 0.8855437f, 0.18380675f, 0.16841814f, 0.5915824f, 0.21739769f, 0.23139724f, 0.7112917f, 0.09447323f, 0.76074016f } },
        { { -0.13432743f, 6.694372f, 0.5097412f }, { 0.37939763f, 0.5544832f, 0.5002085f, 0.49941725f, 0.49674493f, 0.87020326f, 0.29915798f, 0.5928055f, 0.8444058f, 0.1437689f, 0.4061584f, 0.7766905f, 0.95915604f, 0.22847196f }, { 0.18367305f, 0.5746914f, 0.2854349f, 0.23361835f, 0.4271899f, 0.15492174f }, { 8.443251f, 0.38747203f, 4.9308777f, 4.6832476f }, { 0.89384294f, 0.15840968f, 0.24231493f, 0.45755976f, 0.12747395f, 0.32815647f, 0.63542867f, 0.13432741f, 0.6662954f } },
        { { -0.13432741f, 6.694372f, 0.5097412f }, { 0.37939763f, 0.5544832f, 0.5002085f, 0.49941725f, 0.49674493f, 0.87020326f, 0.29915798f, 0.5928055f, 0.8444058f, 0.1437689f, 0.4061584f, 0.7766905f, 0.95915604f, 0.22847196f }, { 0.18367305f, 0.5746914f, 0.2854349f, 0.23361835f, 0.4271899f, 0.15492174f }, { 8.443251f, 0.38747203f, 4.9308777f, 4.6832476f }, { 0.89384294f, 0.15840968f, 0.24231493f, 0.45755976f, 0.12747395f, 0.32815647f, 0.63542867f, 0.13432741f, 0.6662954f } },
        { { -0.49959671f, -0.9033656f, 3.6893373f }, { 0.6239749f, 0.23416924f, 0.49430466f, 0.9073572f, 0.52471054f, 0.16135994f, 0.3514564f, 0.63634574f, 0.85050726f, 0.07486358f, 0.11537579f, 0.8503386f, 0.7492471f, 0.62287235f }, { 0.870064f, 0.75980794f, 0.4024126f, 0.6019033f, 0.38487995f, 0.24500865f }, { 4.3053484f, 4.789057f, 2.1302328f, 8.439566f }, { 0.75048435f, 0.032033682f, 0.2949258f, 0.70788825f, 0.8872566f, 0.32021433f, 0.92609847f, 0.49959671f, 0.08969185f } },
        { { -0.49959674f, -0.9033656f, 3.6893373f }, { 0.6239749f, 0.23416924f, 0.49430466f, 0.9073572f, 0.52471054f, 0.16135992f, 0.3514564f, 0.63634574f, 0.85050726f, 0.074863575f, 0.11537579f, 0.8503386f, 0.7492471f, 0.62287235f }, { 0.8700641f, 0.75980794f, 0.4024126f, 0.6019033f, 0.38487995f, 0.24500863f }, { 4.3053484f, 4.789057f, 2.1302328f, 8.439566f }, { 0.75048435f, 0.03203368f, 0.2949258f, 0.70788825f, 0.8872566f, 0.3202143f, 0.92609847f, 0.49959671f, 0.08969185f } },
        { { -0.5085935f, 0.09266615f, 4.029354f }, { 0.54573494f, 0.3348893f, 0.5488664f, 0.7940073f, 0.46876466f, 0.22594357f, 0.30905208f, 0.6818404f, 0.80826306f, 0.07598305f, 0.19040307f, 0.73888516f, 0.7588916f, 0.5516513f }, { 0.7839339f, 0.6861637f, 0.39572704f, 0.6559315f, 0.44700032f, 0.33840835f }, { 4.6970167f, 4.4585795f, 2.575141f, 7.6811337f }, { 0.6852785f, 0.102431975f, 0.31663582f, 0.6349798f, 0.78191686f, 0.39731503f, 0.8588504f, 0.50859344f, 0.073988646f } },
        { { -0.50859344f, 0.09266615f, 4.029354f }, { 0.5457349f, 0.3348893f, 0.5488664f, 0.7940073f, 0.46876466f, 0.22594357f, 0.30905205f, 0.6818404f, 0.80826306f, 0.07598305f, 0.19040307f, 0.73888516f, 0.7588916f, 0.55165124f }, { 0.7839339f, 0.68616366f, 0.39572704f, 0.6559315f, 0.44700032f, 0.33840835f }, { 4.6970167f, 4.458579f, 2.575141f, 7.6811333f }, { 0.6852784f, 0.10243198f, 0.31663585f, 0.6349797f, 0.78191686f, 0.39731503f, 0.85885036f, 0.50859344f, 0.073988646f } },
    };
    static const asterix_action_t actions[24] = {
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_STAY,
        ASTERIX_STAY,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_STAY,
        ASTERIX_STAY,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_STAY,
        ASTERIX_STAY,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_STAY,
        ASTERIX_STAY,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_STAY,
        ASTERIX_STAY,
        ASTERIX_UP,
    };
    uint32_t failures = asterix_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (asterix_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
