/*
 * A policy for space-invaders, score 59.61 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix space_invaders --profile fast
 * Graph SHA-256: bef23f1de19c20c11a459497109ab6a19d5d0f0a423df75b3466968c4c8c0dbb
 * 6 teams (5 on the longest walk), 31 edges, 29 programs, 18 distinct operations.
 * A decision takes at most 27 bids and 24 operations.
 * Computes in f32 with own maths.
 */
#include "space_invaders.h"

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

static float space_invaders_min(float a, float b)
{
    return (a < b) ? a : b;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
space_invaders_action_t space_invaders_infer(const space_invaders_state_t *state)
{
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_1 = fabsf(state->alien_right_at[1]);
        if (to_team_1 >= best) {
            best = to_team_1;
            next = 2U;
        }

        const float left = state->bullet_near[5] / state->bullet_near[10];
        if (left >= best) {
            best = left;
            next = 1U;
        }

        const float to_team_1_2 = fabsf(state->bullet_at);
        if (to_team_1_2 >= best) {
            best = to_team_1_2;
            next = 2U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 3U;
        }

        const float fire = -0.011686859f * state->own_bullet_at[0];
        if (fire >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_LEFT;
        }
        if (next == 2U) {
            goto team_1;
        }
        if (next == 4U) {
            return SPACE_INVADERS_FIRE;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float right = state->alien_right_at[0] + state->own_bullet_near[1];
        if (right >= best) {
            best = right;
            next = 1U;
        }

        const float to_team_3 = fabsf(state->alien_right_at[1]);
        if (to_team_3 >= best) {
            best = to_team_3;
            next = 2U;
        }

        const float to_team_4 = fabsf(state->alien_at);
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 3U;
        }

        if (0.0f >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_RIGHT;
        }
        if (next == 2U) {
            goto team_3;
        }
        if (next == 3U) {
            goto team_4;
        }
        goto team_5;
    }

team_1:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float right = state->alien_right_at[0] + state->own_bullet_near[1];
        if (right >= best) {
            best = right;
            next = 1U;
        }

        const float fire = -0.011686859f * state->own_bullet_at[0];
        if (fire >= best) {
            best = fire;
            next = 2U;
        }

        const float to_team_3 = fabsf(state->alien_right_at[1]);
        if (to_team_3 >= best) {
            best = to_team_3;
            next = 3U;
        }

        if (0.0f >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_RIGHT;
        }
        if (next == 2U) {
            return SPACE_INVADERS_FIRE;
        }
        if (next == 4U) {
            goto team_5;
        }
    }

team_3:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float fire = -0.02626852f * state->own_bullet_at[0];
        if (fire >= best) {
            best = fire;
            next = 1U;
        }

        const float left = state->bullet_near[1] / state->bullet_near[0];
        if (left >= best) {
            best = left;
            next = 3U;
        }

        const float right = state->bullet_near[7] / state->bullet_near[6];
        if (right >= best) {
            best = right;
            next = 2U;
        }

        const float left_2 = space_invaders_min(state->alien_near, state->bullet_near[8]);
        if (left_2 >= best) {
            best = left_2;
            next = 3U;
        }

        const float to_team_4 = fabsf(state->alien_at);
        if (to_team_4 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_FIRE;
        }
        if (next == 2U) {
            return SPACE_INVADERS_RIGHT;
        }
        if (next == 3U) {
            return SPACE_INVADERS_LEFT;
        }
    }

team_4:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float left = state->bullet_near[1] / state->bullet_near[0];
        if (left >= best) {
            best = left;
            next = 3U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float left_2 = state->bullet_near[4] / state->bullet_near[0];
        if (left_2 >= best) {
            best = left_2;
            next = 3U;
        }

        const float fire = -0.026904494f * state->own_bullet_at[0];
        if (fire >= best) {
            best = fire;
            next = 1U;
        }

        const float left_3 = state->bullet_near[1] / state->alien_right_near[0];
        if (left_3 >= best) {
            best = left_3;
            next = 3U;
        }

        const float to_team_5_2 = state->bullet_near[7] / state->bullet_near[3];
        if (to_team_5_2 >= best) {
            best = to_team_5_2;
            next = 2U;
        }

        const float left_4 = state->bullet_near[9] / state->bullet_near[0];
        if (left_4 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_FIRE;
        }
        if (next == 3U) {
            return SPACE_INVADERS_LEFT;
        }
    }

team_5:
    {
        float best = -FLT_MAX;
        space_invaders_action_t action = SPACE_INVADERS_RIGHT;
        const float fire = state->own_bullet_at[1] * state->cannon_at;
        if (fire >= best) {
            best = fire;
            action = SPACE_INVADERS_FIRE;
        }

        const float fire_2 = -0.011686859f * state->own_bullet_at[0];
        if (fire_2 >= best) {
            best = fire_2;
            action = SPACE_INVADERS_FIRE;
        }

        const float left = state->bullet_near[4] / state->bullet_near[0];
        if (left >= best) {
            best = left;
            action = SPACE_INVADERS_LEFT;
        }

        const float left_2 = state->bullet_near[1] / state->bullet_near[0];
        if (left_2 >= best) {
            best = left_2;
            action = SPACE_INVADERS_LEFT;
        }

        const float fire_3 = state->bullet_near[2] / state->bullet_near[0];
        if (fire_3 >= best) {
            best = fire_3;
            action = SPACE_INVADERS_FIRE;
        }

        const float right = state->alien_right_near[1] * state->own_bullet_near[0];
        if (right >= best) {
            action = SPACE_INVADERS_RIGHT;
        }

        return action;
    }
}

/* A place in the image; row -1 if there is none. */
typedef struct space_invaders_place {
    int32_t row;
    int32_t column;
    int32_t contrast;
} space_invaders_place_t;

/* The first cell that is not 0. */
static space_invaders_place_t space_invaders_first(const uint8_t *image, uint32_t stride)
{
    space_invaders_place_t place = { -1, -1, 0 };
    uint32_t row;
    uint32_t column;

    for (row = 0U; (row < 10U) && (place.row < 0); row++) {
        for (column = 0U; (column < 10U) && (place.row < 0); column++) {
            if (image[(row * stride) + (column * 6U)] != 0U) {
                place.row = (int32_t)row;
                place.column = (int32_t)column;
            }
        }
    }
    return place;
}

/* The last cell that is not 0. */
static space_invaders_place_t space_invaders_last(const uint8_t *image, uint32_t stride)
{
    space_invaders_place_t place = { -1, -1, 0 };
    uint32_t row;
    uint32_t column;

    for (row = 10U; (row > 0U) && (place.row < 0); row--) {
        for (column = 10U; (column > 0U) && (place.row < 0); column--) {
            if (image[((row - 1U) * stride) + ((column - 1U) * 6U)] != 0U) {
                place.row = (int32_t)row - 1;
                place.column = (int32_t)column - 1;
            }
        }
    }
    return place;
}

/* The cell so far down and to the right of a place; 0 outside the image. */
static uint8_t space_invaders_cell(const uint8_t *image, uint32_t stride, space_invaders_place_t from, int32_t down, int32_t right)
{
    const int32_t row = from.row + down;
    const int32_t column = from.column + right;

    if ((from.row < 0) || (row < 0) || (row >= 10) || (column < 0) || (column >= 10)) {
        return 0U;
    }
    return image[((uint32_t)row * stride) + ((uint32_t)column * 6U)];
}

void space_invaders_look(const uint8_t *image, uint32_t stride, space_invaders_state_t *state)
{
    const space_invaders_place_t place_0 = space_invaders_first(&image[0U], stride);
    const space_invaders_place_t place_1 = space_invaders_last(&image[1U], stride);
    const space_invaders_place_t place_2 = space_invaders_first(&image[3U], stride);
    const space_invaders_place_t place_3 = space_invaders_first(&image[4U], stride);
    const space_invaders_place_t place_4 = space_invaders_first(&image[5U], stride);

    state->cannon_at = (float)place_0.row;
    state->alien_at = (float)place_1.column;
    state->alien_near = (float)space_invaders_cell(&image[1U], stride, place_0, -2, 0);
    state->alien_right_at[0] = (float)place_2.row;
    state->alien_right_at[1] = (float)place_2.column;
    state->alien_right_near[0] = (float)space_invaders_cell(&image[3U], stride, place_0, -3, -4);
    state->alien_right_near[1] = (float)space_invaders_cell(&image[3U], stride, place_0, 4, 0);
    state->own_bullet_at[0] = (float)place_3.row;
    state->own_bullet_at[1] = (float)place_3.column;
    state->own_bullet_near[0] = (float)space_invaders_cell(&image[4U], stride, place_0, 0, -4);
    state->own_bullet_near[1] = (float)space_invaders_cell(&image[4U], stride, place_0, 1, 1);
    state->bullet_at = (float)place_4.column;
    state->bullet_near[0] = (float)space_invaders_cell(&image[5U], stride, place_0, -3, -4);
    state->bullet_near[1] = (float)space_invaders_cell(&image[5U], stride, place_0, -2, 0);
    state->bullet_near[2] = (float)space_invaders_cell(&image[5U], stride, place_0, -2, 3);
    state->bullet_near[3] = (float)space_invaders_cell(&image[5U], stride, place_0, -2, 4);
    state->bullet_near[4] = (float)space_invaders_cell(&image[5U], stride, place_0, -1, 0);
    state->bullet_near[5] = (float)space_invaders_cell(&image[5U], stride, place_0, -1, 1);
    state->bullet_near[6] = (float)space_invaders_cell(&image[5U], stride, place_0, -1, 3);
    state->bullet_near[7] = (float)space_invaders_cell(&image[5U], stride, place_0, 0, -4);
    state->bullet_near[8] = (float)space_invaders_cell(&image[5U], stride, place_0, 2, 1);
    state->bullet_near[9] = (float)space_invaders_cell(&image[5U], stride, place_0, 3, -4);
    state->bullet_near[10] = (float)space_invaders_cell(&image[5U], stride, place_0, 3, 3);
}

#ifndef SPACE_INVADERS_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t space_invaders_arithmetic(void)
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

uint32_t space_invaders_selftest(void)
{
    static const space_invaders_state_t states[24] = {
        { 3.0248566f, -0.19616291f, 0.5965602f, { 1.1932458f, 1.836906f }, { 0.7106102f, 0.46108818f }, { 0.526527f, 7.747811f }, { 0.7066241f, 0.48325714f }, 4.7720914f, { 0.09945952f, 0.26391757f, 0.4534597f, 0.28022873f, 0.99103236f, 0.91235495f, 0.94711745f, 0.13324392f, 0.3436841f, 0.48030224f, 0.39733443f } },
        { -0.8630246f, -0.51080316f, 0.18512952f, { 4.2552495f, 1.6813247f }, { 0.08841649f, 0.10045459f }, { 8.910168f, 5.949953f }, { 0.108245455f, 0.57967204f }, 6.307476f, { 0.7046505f, 0.22342087f, 0.9531366f, 0.12823077f, 0.6325227f, 0.80388886f, 0.5813457f, 0.89960766f, 0.3793073f, 0.4768372f, 0.922189f } },
        { 2.3854349f, 5.2581854f, 0.28172845f, { 1.2682902f, 4.718627f }, { 0.9364328f, 0.3449127f }, { 8.073228f, 8.961968f }, { 0.8893838f, 0.73242044f }, 4.1522765f, { 0.6499256f, 0.568612f, 0.61433357f, 0.47202012f, 0.6483753f, 0.60657984f, 0.065146215f, 0.24056327f, 0.42051163f, 0.3658804f, 0.36268634f } },
        { 1.545297f, 4.8948884f, 0.2752873f, { 7.901086f, 5.5411043f }, { 0.21645394f, 0.6206962f }, { 2.6287687f, 1.533876f }, { 0.98349655f, 0.53900975f }, 8.404517f, { 0.25510684f, 0.26876456f, 0.13766856f, 0.39716187f, 0.88031644f, 0.8799096f, 0.06705855f, 0.86320966f, 0.95823956f, 0.92738104f, 0.12539066f } },
        { -0.29263067f, 1.3372178f, 0.99593747f, { 3.724218f, 3.8469634f }, { 0.7956114f, 0.2887153f }, { 4.266672f, 2.0602636f }, { 0.31643564f, 0.12274586f }, 3.6879978f, { 0.18587267f, 0.06820871f, 0.360259f, 0.45650584f, 0.5839412f, 0.5693772f, 0.27031988f, 0.03655745f, 0.15543982f, 0.93970156f, 0.7979287f } },
        { -0.29263064f, 1.3372179f, 0.99593747f, { 3.724218f, 3.8469636f }, { 0.7956114f, 0.28871533f }, { 4.266672f, 2.0602639f }, { 0.31643564f, 0.12274586f }, 3.6879978f, { 0.18587267f, 0.06820871f, 0.360259f, 0.45650584f, 0.5839412f, 0.5693772f, 0.27031988f, 0.03655745f, 0.15543984f, 0.93970156f, 0.7979287f } },
        { 1.4204905f, 5.2397003f, 0.233915f, { 6.4790306f, 6.886097f }, { 0.5081731f, 0.7470585f }, { 0.24024948f, 7.326915f }, { 0.43005323f, 0.40706635f }, 4.1884575f, { 0.56693935f, 0.5854809f, 0.5661155f, 0.44814718f, 0.56686616f, 0.7682406f, 0.4424805f, 0.096037924f, 0.49727815f, 0.43242884f, 0.47975308f } },
        { 1.4204906f, 5.2397003f, 0.233915f, { 6.4790306f, 6.8860965f }, { 0.5081731f, 0.74705845f }, { 0.24024948f, 7.326915f }, { 0.43005323f, 0.40706635f }, 4.1884575f, { 0.5669393f, 0.58548087f, 0.5661155f, 0.44814718f, 0.56686616f, 0.7682406f, 0.4424805f, 0.096037924f, 0.49727815f, 0.43242884f, 0.4797531f } },
        { 5.185446f, 1.3502251f, 0.4845882f, { 5.9933224f, 7.1610518f }, { 0.37499934f, 0.6506969f }, { 5.81631f, 5.892561f }, { 0.42327142f, 0.500537f }, 2.7214208f, { 0.56111354f, 0.2640798f, 0.44596148f, 0.3952422f, 0.12096262f, 0.7794819f, 0.3660434f, 0.494241f, 0.6668184f, 0.9074656f, 0.7317177f } },
        { 5.185446f, 1.3502252f, 0.4845882f, { 5.9933224f, 7.1610518f }, { 0.37499934f, 0.6506969f }, { 5.81631f, 5.892561f }, { 0.42327142f, 0.50053704f }, 2.7214208f, { 0.5611135f, 0.2640798f, 0.44596148f, 0.3952422f, 0.12096262f, 0.7794819f, 0.3660434f, 0.494241f, 0.6668184f, 0.9074656f, 0.7317177f } },
        { 3.9038339f, 6.651451f, 0.6075529f, { 6.0981245f, 7.0242877f }, { 0.119228736f, 0.83784676f }, { 3.162002f, 1.8154044f }, { 0.82735884f, 0.9261632f }, 8.37595f, { 0.10777937f, 0.6395956f, 0.88274705f, 0.16742016f, 0.4272456f, 0.8589799f, 0.06186995f, 0.14544684f, 0.81075585f, 0.8574598f, 0.5047077f } },
        { 3.9038339f, 6.651451f, 0.6075529f, { 6.0981245f, 7.024287f }, { 0.119228736f, 0.83784676f }, { 3.162002f, 1.8154044f }, { 0.82735884f, 0.9261632f }, 8.37595f, { 0.10777937f, 0.6395956f, 0.88274705f, 0.16742018f, 0.42724562f, 0.8589798f, 0.06186995f, 0.14544684f, 0.81075585f, 0.8574598f, 0.5047077f } },
        { 3.082695f, 6.8532276f, 0.058414243f, { 6.394457f, 7.2744837f }, { 0.46151274f, 0.4254263f }, { 6.2907763f, 4.0789785f }, { 0.70332634f, 0.88002753f }, 2.4837608f, { 0.7220112f, 0.12728861f, 0.108515605f, 0.8179685f, 0.9316865f, 0.6995666f, 0.48340684f, 0.034481734f, 0.9401896f, 0.44933867f, 0.25204664f } },
        { 3.0826952f, 6.8532276f, 0.058414243f, { 6.3944564f, 7.2744837f }, { 0.4615127f, 0.4254263f }, { 6.2907763f, 4.0789785f }, { 0.70332634f, 0.8800275f }, 2.4837608f, { 0.7220112f, 0.12728861f, 0.108515605f, 0.8179685f, 0.9316865f, 0.6995666f, 0.48340684f, 0.034481734f, 0.94018954f, 0.44933867f, 0.25204664f } },
        { 4.487611f, 1.7783551f, 0.19317555f, { 4.213765f, 7.95255f }, { 0.6043788f, 0.28403842f }, { 6.092188f, 6.4817886f }, { 0.3517785f, 0.41085643f }, 5.626354f, { 0.25855094f, 0.45979542f, 0.6381419f, 0.28528327f, 0.13973498f, 0.7427281f, 0.8668668f, 0.767568f, 0.1415307f, 0.55645895f, 0.4158324f } },
        { 4.487611f, 1.7783551f, 0.19317555f, { 4.213765f, 7.95255f }, { 0.6043788f, 0.2840384f }, { 6.092188f, 6.4817886f }, { 0.3517785f, 0.41085643f }, 5.6263537f, { 0.25855097f, 0.4597954f, 0.6381419f, 0.28528327f, 0.13973498f, 0.7427281f, 0.8668668f, 0.767568f, 0.1415307f, 0.5564589f, 0.41583237f } },
        { 2.9466743f, 7.2262545f, 0.49938375f, { 6.53876f, 7.1695457f }, { 0.87290466f, 0.08057229f }, { 1.9673166f, 6.7708607f }, { 0.17086178f, 0.63078547f }, 0.24318357f, { 0.7224244f, 0.09148176f, 0.074887305f, 0.7396648f, 0.119683444f, 0.59462225f, 0.68735933f, 0.57158244f, 0.10346146f, 0.14336193f, 0.1485297f } },
        { 2.9466743f, 7.2262545f, 0.49938375f, { 6.53876f, 7.169545f }, { 0.87290466f, 0.08057229f }, { 1.9673166f, 6.7708607f }, { 0.17086178f, 0.63078547f }, 0.24318358f, { 0.7224244f, 0.09148176f, 0.074887305f, 0.7396648f, 0.119683444f, 0.59462225f, 0.68735933f, 0.57158244f, 0.10346146f, 0.14336193f, 0.14852971f } },
        { 2.7382622f, 1.661361f, 0.8957179f, { 1.2973902f, 0.99946713f }, { 0.038191848f, 0.59760344f }, { 6.452841f, 5.708619f }, { 0.96457386f, 0.8227889f }, 5.480507f, { 0.69276047f, 0.0627981f, 0.4190132f, 0.9100932f, 0.85460365f, 0.6924534f, 0.9608815f, 0.39663154f, 0.15011358f, 0.55683327f, 0.12634842f } },
        { 2.7382622f, 1.661361f, 0.895718f, { 1.2973902f, 0.99946713f }, { 0.038191848f, 0.59760344f }, { 6.452841f, 5.708619f }, { 0.96457386f, 0.82278895f }, 5.480507f, { 0.69276047f, 0.0627981f, 0.4190132f, 0.9100932f, 0.85460365f, 0.6924534f, 0.9608815f, 0.39663154f, 0.15011358f, 0.55683327f, 0.1263484f } },
        { 2.6470728f, 1.8187921f, 0.8954315f, { 1.2853694f, 0.93966675f }, { 0.057692543f, 0.5972886f }, { 6.7613506f, 5.9389f }, { 0.96473193f, 0.8255608f }, 5.2663546f, { 0.66517603f, 0.05437907f, 0.40031326f, 0.90837574f, 0.8616077f, 0.68108773f, 0.9385482f, 0.43442923f, 0.17295182f, 0.54173875f, 0.1293281f } },
        { 2.6470728f, 1.8187921f, 0.8954315f, { 1.2853694f, 0.93966675f }, { 0.057692546f, 0.5972886f }, { 6.7613506f, 5.9389f }, { 0.96473193f, 0.8255608f }, 5.2663546f, { 0.66517603f, 0.05437907f, 0.40031326f, 0.90837574f, 0.8616077f, 0.68108773f, 0.9385482f, 0.43442923f, 0.17295183f, 0.54173875f, 0.12932812f } },
        { 2.879158f, 6.619794f, 0.61081827f, { 1.2993358f, 1.7876587f }, { 0.56797945f, 0.30682284f }, { 6.3853407f, 5.017715f }, { 0.6846968f, 0.48832303f }, 2.1113625f, { 0.4554265f, 0.47698444f, 0.15323454f, 0.69227266f, 0.42132676f, 0.2424342f, 0.3034594f, 0.6873784f, 0.5978025f, 0.46334702f, 0.6108576f } },
        { 2.879158f, 6.619794f, 0.61081827f, { 1.2993357f, 1.7876587f }, { 0.56797945f, 0.30682284f }, { 6.3853407f, 5.0177145f }, { 0.6846968f, 0.48832303f }, 2.1113625f, { 0.4554265f, 0.47698444f, 0.15323454f, 0.69227266f, 0.42132676f, 0.2424342f, 0.3034594f, 0.6873784f, 0.5978025f, 0.46334702f, 0.6108576f } },
    };
    static const space_invaders_action_t actions[24] = {
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
    };
    uint32_t failures = space_invaders_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (space_invaders_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
