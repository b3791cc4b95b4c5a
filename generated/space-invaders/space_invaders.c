/*
 * A policy for space-invaders, score 80.39 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix space_invaders --profile fast
 * Graph SHA-256: aa7897b6b178fc99ebd8050d3e58d064855680089d016b30128b58cad8a6e11a
 * 6 teams (5 on the longest walk), 33 edges, 33 programs, 23 distinct operations.
 * A decision takes at most 28 bids and 25 operations.
 * Computes in f32 with own maths.
 */
#include "space_invaders.h"

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

static float space_invaders_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float space_invaders_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
space_invaders_action_t space_invaders_infer(const space_invaders_state_t *state)
{
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_3 = state->alien_at[1] + state->alien_at[2];
        if (to_team_3 >= best) {
            best = to_team_3;
            next = 1U;
        }

        const float left = state->alien_left_near - 0.013731253f;
        if (left >= best) {
            best = left;
            next = 2U;
        }

        const float to_team_1 = state->cannon_at[3] + state->cannon_at[0];
        if (to_team_1 >= best) {
            best = to_team_1;
            next = 3U;
        }

        if (0.0f >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_3;
        }
        if (next == 2U) {
            return SPACE_INVADERS_LEFT;
        }
        if (next == 4U) {
            return SPACE_INVADERS_RIGHT;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 5U;
        const float to_team_2 = state->alien_at[0] + state->cannon_at[2];
        if (to_team_2 >= best) {
            best = to_team_2;
            next = 1U;
        }

        const float left = state->alien_left_at + state->own_bullet_at[1];
        if (left >= best) {
            best = left;
            next = 4U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float fire = space_invaders_max(state->bullet_at[0], state->alien_left_at);
        if (fire >= best) {
            best = fire;
            next = 3U;
        }

        const float left_2 = state->alien_at[1] + state->alien_at[0];
        if (left_2 >= best) {
            best = left_2;
            next = 4U;
        }

        const float to_team_4 = 0.0f * state->alien_right_near;
        if (to_team_4 >= best) {
            next = 5U;
        }

        if (next == 2U) {
            return SPACE_INVADERS_RIGHT;
        }
        if (next == 3U) {
            return SPACE_INVADERS_FIRE;
        }
        if (next == 4U) {
            return SPACE_INVADERS_LEFT;
        }
        if (next == 5U) {
            goto team_4;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float left = state->alien_at[1] + state->alien_at[0];
        if (left >= best) {
            best = left;
            next = 1U;
        }

        const float to_team_4 = state->cannon_at[3] + state->own_bullet_at[0];
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 3U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 2U;
        }

        const float to_team_4_2 = state->cannon_at[3] + state->cannon_at[0];
        if (to_team_4_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_LEFT;
        }
        if (next == 2U) {
            return SPACE_INVADERS_FIRE;
        }
        goto team_4;
    }

team_3:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float left = state->alien_at[1] + state->alien_at[0];
        if (left >= best) {
            best = left;
            next = 3U;
        }

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
        const volatile float constant = 0.0f;
        const float zero = constant;
        if (zero >= best) {
            best = zero;
            next = 1U;
        }

        const float to_team_4 =
            space_invaders_negate_if_less(state->cannon_at[3], state->cannon_at[2]);
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 2U;
        }

        const float to_team_4_2 = state->cannon_at[3] + state->cannon_at[0];
        if (to_team_4_2 >= best) {
            best = to_team_4_2;
            next = 2U;
        }

        const float left_2 = state->cannon_at[1] + state->bullet_at[1];
        if (left_2 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_STAY;
        }
        if (next == 3U) {
            return SPACE_INVADERS_LEFT;
        }
    }

team_4:
    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float fire = state->cannon_at[0] + state->bullet_at[1];
        if (fire >= best) {
            best = fire;
            next = 2U;
        }

        const float to_team_5 = state->cannon_at[2] + state->cannon_at[1];
        if (to_team_5 >= best) {
            best = to_team_5;
            next = 1U;
        }

        const float to_team_5_2 = state->cannon_at[3] + state->cannon_at[0];
        if (to_team_5_2 >= best) {
            best = to_team_5_2;
            next = 1U;
        }

        const float fire_2 =
            space_invaders_negate_if_less(state->bullet_near[2], state->own_bullet_near);
        if (fire_2 >= best) {
            best = fire_2;
            next = 2U;
        }

        const float fire_3 = space_invaders_max(state->bullet_near[1], state->alien_at[1]);
        if (fire_3 >= best) {
            best = fire_3;
            next = 2U;
        }

        const float left = state->cannon_at[1] + state->bullet_at[2];
        if (left >= best) {
            next = 3U;
        }

        if (next == 2U) {
            return SPACE_INVADERS_FIRE;
        }
        if (next == 3U) {
            return SPACE_INVADERS_LEFT;
        }
    }

    {
        float best = -FLT_MAX;
        space_invaders_action_t action = SPACE_INVADERS_FIRE;
        const float fire = space_invaders_max(state->bullet_near[0], state->alien_at[1]);
        if (fire >= best) {
            best = fire;
            action = SPACE_INVADERS_FIRE;
        }

        const float right = state->cannon_at[0] * state->bullet_at[3];
        if (right >= best) {
            best = right;
            action = SPACE_INVADERS_RIGHT;
        }

        const float fire_2 = state->cannon_at[3] * state->bullet_at[2];
        if (fire_2 >= best) {
            best = fire_2;
            action = SPACE_INVADERS_FIRE;
        }

        const float left = state->cannon_at[3] + state->bullet_at[2];
        if (left >= best) {
            best = left;
            action = SPACE_INVADERS_LEFT;
        }

        const float fire_3 = state->alien_at[0] - state->bullet_at[3];
        if (fire_3 >= best) {
            best = fire_3;
            action = SPACE_INVADERS_FIRE;
        }

        const float right_2 = state->bullet_at[0] / 0.16811664f;
        if (right_2 >= best) {
            best = right_2;
            action = SPACE_INVADERS_RIGHT;
        }

        const float left_2 = state->cannon_at[1] + state->bullet_at[2];
        if (left_2 >= best) {
            best = left_2;
            action = SPACE_INVADERS_LEFT;
        }

        const float fire_4 = state->cannon_at[3] * state->bullet_at[0];
        if (fire_4 >= best) {
            action = SPACE_INVADERS_FIRE;
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
    const space_invaders_place_t place_1 = space_invaders_last(&image[0U], stride);
    const space_invaders_place_t place_2 = space_invaders_first(&image[1U], stride);
    const space_invaders_place_t place_3 = space_invaders_last(&image[1U], stride);
    const space_invaders_place_t place_4 = space_invaders_first(&image[2U], stride);
    const space_invaders_place_t place_5 = space_invaders_first(&image[4U], stride);
    const space_invaders_place_t place_6 = space_invaders_first(&image[5U], stride);
    const space_invaders_place_t place_7 = space_invaders_last(&image[5U], stride);

    state->cannon_at[0] = (float)place_0.row;
    state->cannon_at[1] = (float)place_0.column;
    state->cannon_at[2] = (float)place_1.row;
    state->cannon_at[3] = (float)place_1.column;
    state->alien_at[0] = (float)place_2.row;
    state->alien_at[1] = (float)place_2.column;
    state->alien_at[2] = (float)place_3.row;
    state->alien_left_at = (float)place_4.column;
    state->alien_left_near = (float)space_invaders_cell(&image[2U], stride, place_0, 0, -1);
    state->alien_right_near = (float)space_invaders_cell(&image[3U], stride, place_0, 2, -4);
    state->own_bullet_at[0] = (float)place_5.row;
    state->own_bullet_at[1] = (float)place_5.column;
    state->own_bullet_near = (float)space_invaders_cell(&image[4U], stride, place_0, 0, -1);
    state->bullet_at[0] = (float)place_6.row;
    state->bullet_at[1] = (float)place_6.column;
    state->bullet_at[2] = (float)place_7.row;
    state->bullet_at[3] = (float)place_7.column;
    state->bullet_near[0] = (float)space_invaders_cell(&image[5U], stride, place_0, -2, 2);
    state->bullet_near[1] = (float)space_invaders_cell(&image[5U], stride, place_0, -1, -4);
    state->bullet_near[2] = (float)space_invaders_cell(&image[5U], stride, place_0, 4, 0);
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
        { { 3.0248566f, -0.19616291f, 4.965602f, 1.1932458f }, { 1.836906f, 6.1061025f, 3.6108818f }, 0.526527f, 0.8747811f, 0.7066241f, { 3.8325715f, 4.7720914f }, 0.09945952f, { 1.6391757f, 3.5345972f, 1.8022872f, 8.910324f }, { 0.91235495f, 0.94711745f, 0.13324392f } },
        { { 2.436841f, 3.8030224f, 2.9733443f, -0.8630246f }, { -0.51080316f, 0.85129523f, 4.2552495f }, 1.6813247f, 0.08841649f, 0.10045459f, { 8.910168f, 5.949953f }, 0.108245455f, { 4.7967205f, 6.307476f, 6.0465055f, 1.2342087f }, { 0.9531366f, 0.12823077f, 0.6325227f } },
        { { 7.0388885f, 4.8134565f, 7.9960766f, 2.7930732f }, { 3.7683718f, 8.2218895f, 2.3854349f }, 5.2581854f, 0.28172845f, 0.22682902f, { 4.718627f, 8.364327f }, 0.3449127f, { 8.073228f, 8.961968f, 7.893838f, 6.3242044f }, { 0.5152277f, 0.6499256f, 0.568612f } },
        { { 5.143336f, 3.7202013f, 5.4837527f, 5.0657988f }, { -0.3485379f, 1.4056326f, 3.2051163f }, 2.6588042f, 0.36268634f, 0.2545297f, { 4.8948884f, 1.752873f }, 0.8901086f, { 5.5411043f, 1.1645395f, 5.2069616f, 2.6287687f }, { 0.2533876f, 0.98349655f, 0.53900975f } },
        { { 4.6585894f, 0.59535086f, 5.481292f, 5.3872795f }, { 2.5496373f, 2.7665567f, 5.1326685f }, 1.9643068f, 0.19022492f, 0.5648037f, { 5.4908285f, 4.1827097f }, 0.23947802f, { 4.4214754f, -0.0068734894f, 4.881879f, 3.1574688f }, { 0.3587888f, 0.57854974f, 0.7423154f } },
        { { 6.3314266f, 4.5339355f, 6.727784f, 6.3999977f }, { 1.8936076f, 5.335739f, 7.9895105f }, -0.84192f, 0.2469871f, 0.20067364f, { 5.365844f, 7.315606f }, 0.3330018f, { 5.9968796f, 0.771888f, -0.055609122f, 6.0618277f }, { 0.761317f, 0.66944826f, 0.8235915f } },
        { { 6.331426f, 4.5339355f, 6.727784f, 6.399997f }, { 1.8936076f, 5.335739f, 7.9895105f }, -0.84192f, 0.2469871f, 0.20067364f, { 5.365844f, 7.3156056f }, 0.3330018f, { 5.996879f, 0.771888f, -0.055609126f, 6.0618277f }, { 0.761317f, 0.66944826f, 0.8235915f } },
        { { 5.188699f, 2.655776f, 2.4355903f, 7.658065f }, { 4.506919f, 8.339846f, 4.7742567f }, -0.66308224f, 0.23485115f, 0.7574208f, { 5.4039354f, 7.4115486f }, 0.8240906f, { 3.1467528f, 1.2813895f, 1.6357708f, 7.3393965f }, { 0.79827845f, 0.49892855f, 0.38283908f } },
        { { 5.188699f, 2.655776f, 2.4355903f, 7.6580653f }, { 4.5069184f, 8.339846f, 4.7742567f }, -0.66308224f, 0.23485115f, 0.7574208f, { 5.4039354f, 7.4115486f }, 0.8240906f, { 3.146753f, 1.2813895f, 1.6357707f, 7.3393965f }, { 0.79827845f, 0.49892855f, 0.38283908f } },
        { { 5.1123962f, 2.74542f, 2.6807704f, 7.899313f }, { 4.298333f, 8.276058f, 4.735652f }, -0.8012366f, 0.23230305f, 0.7456368f, { 5.5994644f, 7.877427f }, 0.84113073f, { 3.2607765f, 1.2474401f, 1.6998761f, 7.323201f }, { 0.8125471f, 0.470142f, 0.39398682f } },
        { { 5.1123962f, 2.74542f, 2.6807704f, 7.899313f }, { 4.298333f, 8.276057f, 4.735652f }, -0.8012366f, 0.23230307f, 0.7456368f, { 5.599465f, 7.8774266f }, 0.84113073f, { 3.2607765f, 1.2474402f, 1.6998761f, 7.323201f }, { 0.8125471f, 0.470142f, 0.39398682f } },
        { { 6.5575905f, 2.4768605f, 3.4972987f, 4.732809f }, { 6.036771f, 3.4972978f, 1.1583629f }, 5.7386703f, 0.28438646f, 0.68844223f, { 6.969203f, 1.0505211f }, 0.21905878f, { 7.608121f, 3.8055258f, 6.5332212f, 2.426598f }, { 0.042759813f, 0.72310483f, 0.5541378f } },
        { { 6.5575905f, 2.4768605f, 3.4972987f, 4.732809f }, { 6.0367703f, 3.4972978f, 1.1583629f }, 5.7386703f, 0.28438643f, 0.68844223f, { 6.969203f, 1.0505213f }, 0.2190588f, { 7.608121f, 3.8055258f, 6.5332212f, 2.4265978f }, { 0.04275981f, 0.72310483f, 0.5541378f } },
        { { 6.1131687f, 1.6650932f, 5.1484566f, 5.4423265f }, { 5.0725164f, 4.587715f, 2.2988982f }, 6.700575f, 0.16078812f, 0.7986624f, { 7.7822237f, 3.5203977f }, 0.3047259f, { 6.8210955f, 6.177108f, 8.070484f, 1.4596179f }, { 0.12592474f, 0.51089823f, 0.60333025f } },
        { { 6.1131687f, 1.6650932f, 5.1484566f, 5.4423265f }, { 5.0725164f, 4.587715f, 2.2988982f }, 6.700575f, 0.16078812f, 0.7986624f, { 7.7822237f, 3.520398f }, 0.3047259f, { 6.8210955f, 6.177108f, 8.070484f, 1.4596179f }, { 0.12592475f, 0.51089823f, 0.60333025f } },
        { { 6.7761574f, -0.5349239f, 6.7119064f, 7.4343185f }, { 3.8697853f, 3.4801269f, 6.352686f }, 3.9786296f, 0.709628f, 0.92653346f, { 2.4928207f, 6.6030617f }, 0.09243156f, { -0.13710266f, 7.2292747f, 8.366816f, 5.779643f }, { 0.46491706f, 0.050719112f, 0.99752486f } },
        { { 6.7761574f, -0.53492385f, 6.7119064f, 7.4343185f }, { 3.8697853f, 3.4801269f, 6.352686f }, 3.9786294f, 0.709628f, 0.92653346f, { 2.4928207f, 6.6030617f }, 0.09243156f, { -0.13710266f, 7.2292747f, 8.366816f, 5.779643f }, { 0.46491706f, 0.050719112f, 0.99752486f } },
        { { 4.6585894f, 0.59535086f, 5.4812922f, 5.38728f }, { 2.5496373f, 2.7665567f, 5.1326685f }, 1.9643068f, 0.19022492f, 0.5648037f, { 5.4908285f, 4.1827097f }, 0.23947802f, { 4.421475f, -0.0068734894f, 4.881879f, 3.1574688f }, { 0.35878882f, 0.5785498f, 0.7423154f } },
        { { 3.9095845f, 0.17530736f, 5.6408415f, 4.0331783f }, { 5.490053f, 0.59594214f, 7.536952f }, 7.294544f, 0.57139695f, 0.15141302f, { 1.6055336f, 3.8803635f }, 0.82431865f, { 4.7010603f, 2.293231f, 6.933263f, 5.049471f }, { 0.34898597f, 0.28867394f, 0.76350796f } },
        { { 3.9095845f, 0.17530736f, 5.6408415f, 4.033179f }, { 5.4900537f, 0.59594214f, 7.536952f }, 7.294544f, 0.571397f, 0.15141302f, { 1.6055335f, 3.8803632f }, 0.82431865f, { 4.7010603f, 2.293231f, 6.933263f, 5.049471f }, { 0.34898597f, 0.28867397f, 0.76350796f } },
        { { 0.59716296f, 5.4246063f, 0.33482903f, 6.0565624f }, { -0.21753213f, -0.18079573f, 6.4010944f }, 0.3473397f, 0.59101176f, 0.69501436f, { 4.8198166f, 0.06986078f }, 0.15675223f, { 0.41720045f, 0.2883265f, 4.954857f, 0.8008952f }, { 0.3515504f, 0.34063375f, 0.858503f } },
        { { 0.59716296f, 5.4246063f, 0.33482903f, 6.0565624f }, { -0.21753213f, -0.18079573f, 6.4010944f }, 0.3473397f, 0.59101176f, 0.69501436f, { 4.8198166f, 0.06986077f }, 0.15675223f, { 0.41720045f, 0.2883265f, 4.954857f, 0.8008952f }, { 0.3515504f, 0.34063375f, 0.858503f } },
        { { 1.3064253f, -0.2686646f, 1.7542703f, 4.6253824f }, { 0.58900285f, 5.342805f, 6.696905f }, 6.9761744f, 0.63436925f, 0.93406117f, { 1.6553426f, 1.5683043f }, 0.4524188f, { 0.4170357f, 2.4841714f, 3.2032738f, 7.48361f }, { 0.35381567f, 0.29269856f, 0.821069f } },
        { { 1.3064253f, -0.2686646f, 1.7542703f, 4.6253824f }, { 0.5890029f, 5.342805f, 6.696905f }, 6.9761744f, 0.63436925f, 0.93406117f, { 1.6553426f, 1.5683043f }, 0.4524188f, { 0.4170357f, 2.4841714f, 3.2032738f, 7.48361f }, { 0.35381567f, 0.29269856f, 0.821069f } },
    };
    static const space_invaders_action_t actions[24] = {
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_FIRE,
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
