/*
 * A policy for asterix, score 18.77 in validation, trained by tpg-train 0.1.0 with seed 5.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix asterix --profile fast
 * Graph SHA-256: a3c82f56424c1df88866034091fa7737c88264df73cc0d7ed64bc0dbb1317f50
 * 11 teams (9 on the longest walk), 36 edges, 35 programs, 23 distinct operations.
 * A decision takes at most 31 bids and 23 operations.
 * Computes in f32 with own maths.
 */
#include "asterix.h"

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

static float asterix_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float asterix_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
asterix_action_t asterix_infer(const asterix_state_t *state)
{
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_1 = 0.04226071f / state->player_at;
        if (to_team_1 >= best) {
            best = to_team_1;
            next = 1U;
        }

        const float up = asterix_max(state->gold_near[2], state->gold_near[3]);
        if (up >= best) {
            best = up;
            next = 2U;
        }

        const float down = asterix_max(state->enemy_near[5], state->gold_near[12]);
        if (down >= best) {
            best = down;
            next = 3U;
        }

        if (0.0f >= best) {
            next = 4U;
        }

        if (next == 2U) {
            return ASTERIX_UP;
        }
        if (next == 3U) {
            return ASTERIX_DOWN;
        }
        if (next == 4U) {
            goto team_5;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_2 = 0.03143443f / state->enemy_at[2];
        if (to_team_2 >= best) {
            best = to_team_2;
            next = 1U;
        }

        const float up = asterix_max(state->gold_near[2], state->gold_near[5]);
        if (up >= best) {
            best = up;
            next = 2U;
        }

        if (0.0f >= best) {
            next = 3U;
        }

        if (next == 2U) {
            return ASTERIX_UP;
        }
        if (next == 3U) {
            goto team_12;
        }
    }

    {
        const float down = asterix_negate_if_less(state->gold_near[10], state->enemy_near[2]);

        if ((down >= -FLT_MAX) && !(0.0f >= down)) {
            return ASTERIX_DOWN;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 2U;
        const float to_team_4 = state->trail_at - state->trail_near[0];
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 1U;
        }

        const float to_team_4_2 = state->enemy_at[1] - state->trail_near[0];
        if (to_team_4_2 >= best) {
            best = to_team_4_2;
            next = 1U;
        }

        if (0.0f >= best) {
            next = 2U;
        }

        if (next == 2U) {
            goto team_12;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float up = asterix_max(state->gold_near[4], state->gold_near[5]);
        if (up >= best) {
            best = up;
            next = 3U;
        }

        const float to_team_5 = asterix_max(state->trail_near[1], 0.0651647f);
        if (to_team_5 >= best) {
            best = to_team_5;
            next = 1U;
        }

        const float down = state->gold_near[8] + state->gold_near[8];
        if (down >= best) {
            best = down;
            next = 2U;
        }

        const float up_2 = asterix_max(state->gold_near[4], state->gold_near[6]);
        if (up_2 >= best) {
            next = 3U;
        }

        if (next == 2U) {
            return ASTERIX_DOWN;
        }
        if (next == 3U) {
            return ASTERIX_UP;
        }
    }

team_5:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_10 = asterix_max(state->enemy_at[0], 0.0f);
        if (to_team_10 >= best) {
            best = to_team_10;
            next = 1U;
        }

        const float to_team_8 = asterix_max(state->gold_near[1], state->gold_near[0]);
        if (to_team_8 >= best) {
            best = to_team_8;
            next = 2U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 3U;
        }

        const float down = asterix_max(state->enemy_near[6], state->gold_near[9]);
        if (down >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_10;
        }
        if (next == 2U) {
            goto team_8;
        }
        if (next == 4U) {
            return ASTERIX_DOWN;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_7 = state->trail_at / state->enemy_near[0];
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

        const float down = asterix_max(state->enemy_near[6], state->gold_near[9]);
        if (down >= best) {
            next = 3U;
        }

        if (next == 2U) {
            return ASTERIX_STAY;
        }
        if (next == 3U) {
            return ASTERIX_DOWN;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 2U;
        const float down = asterix_max(state->gold_near[7], state->gold_near[11]);
        if (down >= best) {
            best = down;
            next = 1U;
        }

        const float to_team_12 = asterix_max(state->trail_near[2], state->enemy_near[1]);
        if (to_team_12 >= best) {
            best = to_team_12;
            next = 2U;
        }

        const float down_2 = asterix_max(state->gold_near[7], state->gold_near[9]);
        if (down_2 >= best) {
            best = down_2;
            next = 1U;
        }

        if (0.0f >= best) {
            next = 2U;
        }

        if (next == 1U) {
            return ASTERIX_DOWN;
        }
        goto team_12;
    }

team_8:
    {
        const float to_team_10 = asterix_max(state->enemy_at[2], state->trail_near[3]);

        if (!(to_team_10 >= 0.0f)) {
            goto team_12;
        }
    }

team_10:
    {
        float best = -FLT_MAX;
        uint32_t next = 2U;
        const float down = asterix_max(state->gold_near[7], state->gold_near[9]);
        if (down >= best) {
            best = down;
            next = 1U;
        }

        const float down_2 = asterix_max(state->gold_near[7], state->gold_near[11]);
        if (down_2 >= best) {
            best = down_2;
            next = 1U;
        }

        if (0.0f >= best) {
            next = 2U;
        }

        if (next == 1U) {
            return ASTERIX_DOWN;
        }
    }

team_12:
    {
        float best = -FLT_MAX;
        asterix_action_t action = ASTERIX_STAY;
        const float up = state->enemy_near[3] * state->enemy_at[1];
        if (up >= best) {
            best = up;
            action = ASTERIX_UP;
        }

        const float down = asterix_max(state->enemy_near[6], state->gold_near[11]);
        if (down >= best) {
            best = down;
            action = ASTERIX_DOWN;
        }

        const float up_2 = asterix_max(state->enemy_near[4], 0.0f);
        if (up_2 >= best) {
            best = up_2;
            action = ASTERIX_UP;
        }

        if (0.0f >= best) {
            action = ASTERIX_STAY;
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
    const asterix_place_t place_1 = asterix_first(&image[1U], stride);
    const asterix_place_t place_2 = asterix_last(&image[1U], stride);
    const asterix_place_t place_3 = asterix_last(&image[2U], stride);

    state->player_at = (float)place_0.row;
    state->enemy_at[0] = (float)place_1.row;
    state->enemy_at[1] = (float)place_2.row;
    state->enemy_at[2] = (float)place_2.column;
    state->enemy_near[0] = (float)asterix_cell(&image[1U], stride, place_0, -4, -2);
    state->enemy_near[1] = (float)asterix_cell(&image[1U], stride, place_0, -2, -3);
    state->enemy_near[2] = (float)asterix_cell(&image[1U], stride, place_0, -2, 3);
    state->enemy_near[3] = (float)asterix_cell(&image[1U], stride, place_0, 0, -1);
    state->enemy_near[4] = (float)asterix_cell(&image[1U], stride, place_0, 0, 1);
    state->enemy_near[5] = (float)asterix_cell(&image[1U], stride, place_0, 1, -3);
    state->enemy_near[6] = (float)asterix_cell(&image[1U], stride, place_0, 1, -2);
    state->trail_at = (float)place_3.row;
    state->trail_near[0] = (float)asterix_cell(&image[2U], stride, place_0, -4, -2);
    state->trail_near[1] = (float)asterix_cell(&image[2U], stride, place_0, -4, 2);
    state->trail_near[2] = (float)asterix_cell(&image[2U], stride, place_0, -3, 1);
    state->trail_near[3] = (float)asterix_cell(&image[2U], stride, place_0, 1, -1);
    state->gold_near[0] = (float)asterix_cell(&image[3U], stride, place_0, -4, 2);
    state->gold_near[1] = (float)asterix_cell(&image[3U], stride, place_0, -3, 1);
    state->gold_near[2] = (float)asterix_cell(&image[3U], stride, place_0, -2, -1);
    state->gold_near[3] = (float)asterix_cell(&image[3U], stride, place_0, -2, 0);
    state->gold_near[4] = (float)asterix_cell(&image[3U], stride, place_0, -1, -1);
    state->gold_near[5] = (float)asterix_cell(&image[3U], stride, place_0, -1, 0);
    state->gold_near[6] = (float)asterix_cell(&image[3U], stride, place_0, -1, 1);
    state->gold_near[7] = (float)asterix_cell(&image[3U], stride, place_0, 1, -2);
    state->gold_near[8] = (float)asterix_cell(&image[3U], stride, place_0, 1, 0);
    state->gold_near[9] = (float)asterix_cell(&image[3U], stride, place_0, 1, 2);
    state->gold_near[10] = (float)asterix_cell(&image[3U], stride, place_0, 2, 0);
    state->gold_near[11] = (float)asterix_cell(&image[3U], stride, place_0, 3, -1);
    state->gold_near[12] = (float)asterix_cell(&image[3U], stride, place_0, 4, -1);
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
        { 3.0248566f, { -0.19616291f, 4.965602f, 1.1932458f }, { 0.2836906f, 0.7106102f, 0.46108818f, 0.1526527f, 0.8747811f, 0.7066241f, 0.48325714f }, 4.7720914f, { 0.09945952f, 0.26391757f, 0.4534597f, 0.28022873f }, { 0.99103236f, 0.91235495f, 0.94711745f, 0.13324392f, 0.3436841f, 0.48030224f, 0.39733443f, 0.013697542f, 0.048919685f, 0.18512952f, 0.525525f, 0.26813248f, 0.08841649f } },
        { 0.0045458893f, { 8.910168f, 5.949953f, 0.08245458f }, { 0.57967204f, 0.73074764f, 0.7046505f, 0.22342087f, 0.9531366f, 0.12823077f, 0.6325227f }, 7.0388885f, { 0.5813457f, 0.89960766f, 0.3793073f, 0.4768372f }, { 0.922189f, 0.3385435f, 0.6258185f, 0.28172845f, 0.22682902f, 0.5718627f, 0.9364328f, 0.3449127f, 0.90732276f, 0.9961968f, 0.8893838f, 0.73242044f, 0.5152277f } },
        { 5.4992557f, { 4.68612f, 5.143336f, 3.7202013f }, { 0.6483753f, 0.60657984f, 0.065146215f, 0.24056327f, 0.42051163f, 0.3658804f, 0.36268634f }, 1.545297f, { 0.58948886f, 0.2752873f, 0.8901086f, 0.65411043f }, { 0.21645394f, 0.6206962f, 0.36287686f, 0.2533876f, 0.98349655f, 0.53900975f, 0.9404517f, 0.25510684f, 0.26876456f, 0.13766856f, 0.39716187f, 0.88031644f, 0.8799096f } },
        { -0.32941452f, { 7.632097f, 8.582396f, 8.27381f }, { 0.12539066f, 0.03824791f, 0.027937882f, 0.58422893f, 0.71881175f, 0.78095716f, 0.96303505f }, 6.4927826f, { 0.10118092f, 0.6635079f, 0.4262807f, 0.43527922f }, { 0.6502973f, 0.80434424f, 0.03566284f, 0.8089148f, 0.5088392f, 0.02187618f, 0.3145552f, 0.77451867f, 0.98424685f, 0.8490902f, 0.6159677f, 0.534974f, 0.5052861f } },
        { 0.14050665f, { 0.6613729f, 7.817936f, 8.045813f }, { 0.51598525f, 0.6635766f, 0.35362494f, 0.72111416f, 0.0866774f, 0.1022889f, 0.75934756f }, 8.434921f, { 0.57376564f, 0.6274667f, 0.64239395f, 0.068678126f }, { 0.63778436f, 0.86501527f, 0.23162153f, 0.08148548f, 0.49888456f, 0.5355507f, 0.12977406f, 0.49086994f, 0.6991857f, 0.8662176f, 0.6551198f, 0.47969997f, 0.30077374f } },
        { 4.047349f, { 1.2266506f, -0.32857364f, 4.4907613f }, { 0.085838184f, 0.72913766f, 0.12247644f, 0.30260822f, 0.24968061f, 0.5046439f, 0.38139665f }, 3.6811736f, { 0.45459402f, 0.60840774f, 0.42188945f, 0.39261436f }, { 0.8743708f, 0.24849357f, 0.6223467f, 0.20524901f, 0.25694558f, 0.16091664f, 0.4230052f, 0.50859195f, 0.09557882f, 0.61217284f, 0.5713033f, 0.6297183f, 0.62234664f } },
        { 4.047349f, { 1.2266507f, -0.32857364f, 4.4907618f }, { 0.085838184f, 0.72913766f, 0.12247644f, 0.3026082f, 0.24968061f, 0.5046439f, 0.38139665f }, 3.6811733f, { 0.45459402f, 0.60840774f, 0.42188948f, 0.39261436f }, { 0.8743708f, 0.24849358f, 0.62234664f, 0.20524901f, 0.2569456f, 0.16091663f, 0.42300522f, 0.5085919f, 0.09557882f, 0.61217284f, 0.57130325f, 0.6297183f, 0.62234664f } },
        { 0.67655575f, { 0.5633646f, 2.5481167f, 4.3824663f }, { 0.2461392f, 0.89698154f, 0.5877075f, 0.88570046f, 0.43555596f, 0.38392532f, 0.83753276f }, 1.6421838f, { 0.55683386f, 0.593408f, 0.85794485f, 0.70376253f }, { 0.4380957f, 0.13345957f, 0.39602074f, 0.7487921f, 0.4648038f, 0.36344245f, 0.49279734f, 0.30363435f, 0.46686345f, 0.6286307f, 0.17840517f, 0.19259405f, 0.7487921f } },
        { 0.67655575f, { 0.5633646f, 2.5481167f, 4.3824663f }, { 0.2461392f, 0.8969815f, 0.5877075f, 0.88570046f, 0.435556f, 0.38392532f, 0.83753276f }, 1.6421838f, { 0.55683386f, 0.593408f, 0.85794485f, 0.70376253f }, { 0.4380957f, 0.13345957f, 0.3960207f, 0.7487922f, 0.4648038f, 0.36344248f, 0.49279732f, 0.30363435f, 0.46686345f, 0.62863064f, 0.17840517f, 0.19259405f, 0.74879205f } },
        { 3.018898f, { 3.9659653f, 5.430334f, 3.8909254f }, { 0.69685555f, 0.21274978f, 0.57159686f, 0.58798945f, 0.818099f, 0.54336715f, 0.6158819f }, 5.7577724f, { 0.6247368f, 0.45284575f, 0.3143146f, 0.42948252f }, { 0.78333104f, 0.18779764f, 0.2787413f, 0.59835136f, 0.2338525f, 0.80522764f, 0.39576757f, 0.42879808f, 0.6285888f, 0.81216836f, 0.6818932f, 0.36240524f, 0.59835124f } },
        { 3.0188982f, { 3.9659653f, 5.4303346f, 3.8909256f }, { 0.69685555f, 0.21274978f, 0.5715968f, 0.5879895f, 0.818099f, 0.5433671f, 0.6158819f }, 5.7577724f, { 0.62473685f, 0.45284575f, 0.3143146f, 0.4294825f }, { 0.78333104f, 0.18779762f, 0.2787413f, 0.5983513f, 0.23385249f, 0.80522764f, 0.3957676f, 0.42879808f, 0.6285888f, 0.81216836f, 0.6818933f, 0.36240524f, 0.5983513f } },
        { 5.4843273f, { 5.92437f, 6.765149f, 0.8679322f }, { 0.76386774f, 0.470576f, 0.24586225f, 0.85981226f, 0.950598f, 0.8404565f, 0.18380255f }, 5.357828f, { 0.82573354f, 0.22232056f, 0.444171f, 0.88921046f }, { 0.05658868f, 0.14084598f, 0.8404565f, 0.81368697f, 0.4829293f, 0.7046733f, 0.3983866f, 0.4882903f, 0.47432125f, 0.3597504f, 0.47196746f, 0.5274271f, 0.24129066f } },
        { 5.4843273f, { 5.92437f, 6.765149f, 0.86793226f }, { 0.7638677f, 0.470576f, 0.24586225f, 0.85981226f, 0.950598f, 0.8404564f, 0.18380256f }, 5.357828f, { 0.8257335f, 0.22232056f, 0.44417104f, 0.88921046f }, { 0.05658868f, 0.14084598f, 0.8404565f, 0.81368697f, 0.4829293f, 0.7046733f, 0.3983866f, 0.4882903f, 0.47432125f, 0.3597504f, 0.47196746f, 0.5274271f, 0.24129066f } },
        { 8.883024f, { 3.6088123f, 1.5925832f, 8.261984f }, { 0.78235245f, 0.3090744f, 0.32016546f, 0.5782734f, 0.031761035f, 0.066712186f, 0.5964749f }, 3.971859f, { 0.42195255f, 0.117463976f, 0.38789123f, 0.06525487f }, { 0.64247596f, 0.525408f, 0.51609707f, 0.7724494f, 0.9511759f, 0.76837635f, 0.017897114f, 0.090169504f, 0.35360366f, 0.4872675f, 0.47391504f, 0.66926074f, 0.77244925f } },
        { 8.883025f, { 3.608812f, 1.5925831f, 8.261984f }, { 0.78235245f, 0.30907437f, 0.32016546f, 0.5782734f, 0.031761035f, 0.066712186f, 0.5964748f }, 3.9718592f, { 0.42195255f, 0.117463976f, 0.38789123f, 0.06525487f }, { 0.64247596f, 0.525408f, 0.516097f, 0.7724493f, 0.9511759f, 0.76837635f, 0.017897114f, 0.090169504f, 0.35360366f, 0.4872675f, 0.47391504f, 0.6692608f, 0.7724493f } },
        { 7.840247f, { 3.690827f, 2.7292376f, 8.0117035f }, { 0.74085677f, 0.4019844f, 0.29872847f, 0.56202996f, 0.06520973f, 0.061528087f, 0.51673543f }, 3.7221928f, { 0.40937668f, 0.10608539f, 0.478841f, 0.15555355f }, { 0.6528667f, 0.431391f, 0.5912316f, 0.7822695f, 0.89762723f, 0.61909723f, 0.023493435f, 0.15645826f, 0.45789635f, 0.47560328f, 0.4487512f, 0.71914077f, 0.7822695f } },
        { 7.840247f, { 3.690827f, 2.7292378f, 8.011703f }, { 0.7408567f, 0.4019844f, 0.29872847f, 0.56202996f, 0.06520973f, 0.061528087f, 0.5167354f }, 3.7221925f, { 0.40937668f, 0.10608539f, 0.47884104f, 0.15555355f }, { 0.6528667f, 0.431391f, 0.5912316f, 0.78226954f, 0.8976272f, 0.6190972f, 0.023493435f, 0.15645827f, 0.45789635f, 0.47560328f, 0.4487512f, 0.71914077f, 0.7822695f } },
        { 3.356666f, { 2.2585168f, 8.055592f, 0.09554622f }, { 0.619207f, 0.88777673f, 0.09476281f, 0.17921583f, 0.7546715f, 0.8704042f, 0.7967079f }, 0.7365469f, { 0.71251976f, 0.5083349f, 0.43849322f, 0.8047416f }, { 0.52345395f, 0.7032285f, 0.8342818f, 0.87040424f, 0.12263438f, 0.27936548f, 0.72531056f, 0.1838143f, 0.6666565f, 0.1448299f, 0.6927649f, 0.14497998f, 0.11922016f } },
        { 3.356666f, { 2.2585168f, 8.055592f, 0.095546216f }, { 0.619207f, 0.88777673f, 0.0947628f, 0.17921582f, 0.7546716f, 0.87040424f, 0.796708f }, 0.7365469f, { 0.71251976f, 0.5083349f, 0.4384932f, 0.8047416f }, { 0.52345395f, 0.7032285f, 0.8342818f, 0.87040424f, 0.12263438f, 0.27936548f, 0.72531056f, 0.18381429f, 0.6666565f, 0.1448299f, 0.6927649f, 0.14497998f, 0.11922015f } },
        { 5.291544f, { 0.8373852f, 6.0937834f, 3.6787896f }, { 0.5994179f, 0.3791803f, 0.12047373f, 0.13850588f, 0.35651147f, 0.71429265f, 0.40432602f }, 1.8874016f, { 0.48260647f, 0.7478223f, 0.29112917f, 0.32854217f }, { 0.38042438f, 0.62890196f, 0.34077406f, 0.71429265f, 0.50694025f, 0.6183276f, 0.68701017f, 0.6833489f, 0.4187196f, 0.19247764f, 0.5071604f, 0.053864226f, 0.21584263f } },
        { 5.291544f, { 0.8373852f, 6.0937834f, 3.6787896f }, { 0.5994179f, 0.3791803f, 0.12047373f, 0.13850588f, 0.35651147f, 0.7142926f, 0.40432602f }, 1.8874016f, { 0.48260647f, 0.7478223f, 0.29112917f, 0.32854214f }, { 0.38042438f, 0.62890196f, 0.34077403f, 0.71429265f, 0.5069403f, 0.6183277f, 0.68701017f, 0.6833489f, 0.4187196f, 0.19247766f, 0.5071604f, 0.053864222f, 0.21584263f } },
        { 2.97749f, { 5.3513784f, 1.7314119f, 2.4508805f }, { 0.7370353f, 0.6936934f, 0.58936924f, 0.30451363f, 0.26221478f, 0.052576467f, 0.2888788f }, 1.6428748f, { 0.8713699f, 0.11645608f, 0.076968014f, 0.2644351f }, { 0.83954644f, 0.13704228f, 0.4792858f, 0.7517796f, 0.21251523f, 0.655189f, 0.74065423f, 0.22820431f, 0.8941595f, 0.9387306f, 0.38515878f, 0.8164152f, 0.75177956f } },
        { 2.97749f, { 5.3513784f, 1.7314119f, 2.4508805f }, { 0.7370353f, 0.6936934f, 0.5893692f, 0.30451363f, 0.26221478f, 0.052576467f, 0.2888788f }, 1.642875f, { 0.87136984f, 0.11645608f, 0.076968014f, 0.2644351f }, { 0.83954644f, 0.13704228f, 0.47928578f, 0.75177956f, 0.21251523f, 0.6551889f, 0.74065423f, 0.22820431f, 0.89415944f, 0.9387306f, 0.38515878f, 0.8164152f, 0.75177956f } },
        { 6.185897f, { 1.7135084f, 3.942402f, 4.816188f }, { 0.40683013f, 0.46667826f, 0.5226928f, 0.43042374f, 0.15228286f, 0.2555036f, 0.40459144f }, 2.746996f, { 0.6264813f, 0.5022402f, 0.30887455f, 0.31996787f }, { 0.45821553f, 0.32312602f, 0.49814975f, 0.1761396f, 0.48948514f, 0.21237814f, 0.66042686f, 0.27672136f, 0.17621714f, 0.78460157f, 0.5561991f, 0.37049007f, 0.49814975f } },
    };
    static const asterix_action_t actions[24] = {
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_DOWN,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_DOWN,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_DOWN,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_DOWN,
        ASTERIX_UP,
        ASTERIX_UP,
        ASTERIX_DOWN,
        ASTERIX_DOWN,
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
