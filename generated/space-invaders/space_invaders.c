/*
 * A policy for space-invaders, score 66.88 in validation, trained by tpg-train 0.1.0 with seed 4.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix space_invaders --profile fast
 * Graph SHA-256: 2a7b9c8d4594307dd8bf2ad54345a496599b5de7ca0dfd4ea2d75fa06ffc0f6d
 * 5 teams (5 on the longest walk), 25 edges, 25 programs, 18 distinct operations.
 * A decision takes at most 25 bids and 24 operations.
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

static float space_invaders_min(float a, float b)
{
    return (a < b) ? a : b;
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
        uint32_t next = 3U;
        const float to_team_2 = space_invaders_max(-0.009387939f, state->alien_at[0]);
        if (to_team_2 >= best) {
            best = to_team_2;
            next = 1U;
        }

        const float left = state->bullet_near[4] * state->bullet_at[0];
        if (left >= best) {
            best = left;
            next = 2U;
        }

        const float left_2 = state->bullet_at[0] * state->bullet_near[1];
        if (left_2 >= best) {
            best = left_2;
            next = 2U;
        }

        const float to_team_1 = space_invaders_max(-0.025351083f, state->alien_at[0]);
        if (to_team_1 >= best) {
            next = 3U;
        }

        if (next == 1U) {
            goto team_2;
        }
        if (next == 2U) {
            return SPACE_INVADERS_LEFT;
        }
    }

    {
        float best = -FLT_MAX;
        uint32_t next = 3U;
        const float to_team_2 = space_invaders_max(-0.011006754f, state->alien_at[0]);
        if (to_team_2 >= best) {
            best = to_team_2;
            next = 1U;
        }

        const float to_team_3 = space_invaders_min(state->bullet_at[1], state->alien_right_at[0]);
        if (to_team_3 >= best) {
            best = to_team_3;
            next = 3U;
        }

        const float left = state->bullet_near[4] * state->bullet_at[0];
        if (left >= best) {
            best = left;
            next = 2U;
        }

        const float to_team_3_2 = space_invaders_min(0.0f, state->own_bullet_near);
        if (to_team_3_2 >= best) {
            next = 3U;
        }

        if (next == 2U) {
            return SPACE_INVADERS_LEFT;
        }
        if (next == 3U) {
            goto team_3;
        }
    }

team_2:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float to_team_4 = space_invaders_max(0.005276723f, state->alien_at[1]);
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 1U;
        }

        const float right = space_invaders_min(state->cannon_at[1], state->bullet_near[0]);
        if (right >= best) {
            best = right;
            next = 2U;
        }

        const float left = state->bullet_near[2] * state->cannon_at[0];
        if (left >= best) {
            best = left;
            next = 4U;
        }

        const float left_2 = state->bullet_at[0] * state->bullet_near[1];
        if (left_2 >= best) {
            best = left_2;
            next = 4U;
        }

        const float left_3 = state->bullet_near[3] * state->bullet_at[1];
        if (left_3 >= best) {
            best = left_3;
            next = 4U;
        }

        const float to_team_3 = space_invaders_min(state->cannon_at[1], state->alien_right_at[0]);
        if (to_team_3 >= best) {
            best = to_team_3;
            next = 3U;
        }

        const float left_4 = state->cannon_at[1] * state->bullet_near[2];
        if (left_4 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            goto team_4;
        }
        if (next == 2U) {
            return SPACE_INVADERS_RIGHT;
        }
        if (next == 4U) {
            return SPACE_INVADERS_LEFT;
        }
    }

team_3:
    {
        float best = -FLT_MAX;
        uint32_t next = 4U;
        const float right = space_invaders_min(state->cannon_at[1], state->alien_right_at[0]);
        if (right >= best) {
            best = right;
            next = 3U;
        }

        const float fire = space_invaders_min(state->alien_near, state->alien_at[1]);
        if (fire >= best) {
            best = fire;
            next = 1U;
        }

        const float to_team_4 = space_invaders_max(0.006655848f, state->alien_at[1]);
        if (to_team_4 >= best) {
            best = to_team_4;
            next = 2U;
        }

        const float right_2 = space_invaders_min(state->cannon_at[1], state->bullet_near[0]);
        if (right_2 >= best) {
            best = right_2;
            next = 3U;
        }

        const float left = state->bullet_near[2] * state->bullet_at[1];
        if (left >= best) {
            best = left;
            next = 4U;
        }

        const float left_2 = state->bullet_at[0] * state->bullet_near[1];
        if (left_2 >= best) {
            next = 4U;
        }

        if (next == 1U) {
            return SPACE_INVADERS_FIRE;
        }
        if (next == 3U) {
            return SPACE_INVADERS_RIGHT;
        }
        if (next == 4U) {
            return SPACE_INVADERS_LEFT;
        }
    }

team_4:
    {
        float best = -FLT_MAX;
        space_invaders_action_t action = SPACE_INVADERS_FIRE;
        const float fire = state->alien_right_at[1] + state->alien_left_near[2];
        if (fire >= best) {
            best = fire;
            action = SPACE_INVADERS_FIRE;
        }

        const float fire_2 =
            space_invaders_negate_if_less(state->alien_left_near[1], state->alien_left_near[0]);
        if (fire_2 >= best) {
            best = fire_2;
            action = SPACE_INVADERS_FIRE;
        }

        const float left = state->bullet_near[2] * state->bullet_at[1];
        if (left >= best) {
            best = left;
            action = SPACE_INVADERS_LEFT;
        }

        if (0.0f >= best) {
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
    const space_invaders_place_t place_3 = space_invaders_first(&image[3U], stride);
    const space_invaders_place_t place_4 = space_invaders_last(&image[3U], stride);
    const space_invaders_place_t place_5 = space_invaders_first(&image[5U], stride);
    const space_invaders_place_t place_6 = space_invaders_last(&image[5U], stride);

    state->cannon_at[0] = (float)place_0.column;
    state->cannon_at[1] = (float)place_1.row;
    state->alien_at[0] = (float)place_2.row;
    state->alien_at[1] = (float)place_2.column;
    state->alien_near = (float)space_invaders_cell(&image[1U], stride, place_0, -1, -2);
    state->alien_left_near[0] = (float)space_invaders_cell(&image[2U], stride, place_0, -2, 1);
    state->alien_left_near[1] = (float)space_invaders_cell(&image[2U], stride, place_0, -1, 3);
    state->alien_left_near[2] = (float)space_invaders_cell(&image[2U], stride, place_0, 4, -4);
    state->alien_right_at[0] = (float)place_3.row;
    state->alien_right_at[1] = (float)place_4.column;
    state->own_bullet_near = (float)space_invaders_cell(&image[4U], stride, place_0, -4, 0);
    state->bullet_at[0] = (float)place_5.column;
    state->bullet_at[1] = (float)place_6.row;
    state->bullet_near[0] = (float)space_invaders_cell(&image[5U], stride, place_0, -4, 0);
    state->bullet_near[1] = (float)space_invaders_cell(&image[5U], stride, place_0, -3, 0);
    state->bullet_near[2] = (float)space_invaders_cell(&image[5U], stride, place_0, -2, 0);
    state->bullet_near[3] = (float)space_invaders_cell(&image[5U], stride, place_0, -2, 1);
    state->bullet_near[4] = (float)space_invaders_cell(&image[5U], stride, place_0, -1, 0);
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
        { { 3.0248566f, -0.19616291f }, { 4.965602f, 1.1932458f }, 0.2836906f, { 0.7106102f, 0.46108818f, 0.1526527f }, { 7.747811f, 6.066241f }, 0.48325714f, { 4.7720914f, -0.005404772f }, { 0.26391757f, 0.4534597f, 0.28022873f, 0.99103236f, 0.91235495f } },
        { { 8.471175f, 0.33243912f }, { 2.436841f, 3.8030224f }, 0.39733443f, { 0.013697542f, 0.048919685f, 0.18512952f }, { 4.2552495f, 1.6813247f }, 0.08841649f, { 0.0045458893f, 8.910168f }, { 0.6949953f, 0.108245455f, 0.57967204f, 0.73074764f, 0.7046505f } },
        { { 1.2342087f, 8.531366f }, { 0.28230762f, 5.3252273f }, 0.80388886f, { 0.5813457f, 0.89960766f, 0.3793073f }, { 3.7683718f, 8.2218895f }, 0.3385435f, { 5.2581854f, 1.8172845f }, { 0.22682902f, 0.5718627f, 0.9364328f, 0.3449127f, 0.90732276f } },
        { { 8.961968f, 7.893838f }, { 6.3242044f, 4.1522765f }, 0.6499256f, { 0.568612f, 0.61433357f, 0.47202012f }, { 5.4837527f, 5.0657988f }, 0.065146215f, { 1.4056326f, 3.2051163f }, { 0.3658804f, 0.36268634f, 0.2545297f, 0.58948886f, 0.2752873f } },
        { { 7.6034403f, 4.813712f }, { 6.055111f, 7.270483f }, 0.2730502f, { 0.6212412f, 0.89740884f, 0.061198592f }, { 1.3357649f, 1.0548251f }, 0.73576653f, { 7.7575674f, 1.8516524f }, { 0.73233306f, 0.055299334f, 0.111906275f, 0.7451749f, 0.7805425f } },
        { { 7.60344f, 4.813712f }, { 6.055111f, 7.270483f }, 0.2730502f, { 0.6212412f, 0.8974088f, 0.061198592f }, { 1.3357649f, 1.0548251f }, 0.73576653f, { 7.7575674f, 1.8516524f }, { 0.73233306f, 0.055299334f, 0.11190628f, 0.7451749f, 0.78054243f } },
        { { 5.8096695f, 5.778118f }, { 0.78445745f, 5.074916f }, 0.7735326f, { 0.33396637f, 0.47089702f, 0.4087906f }, { 5.074917f, 1.8826957f }, 0.4920326f, { 1.5864272f, -0.18677998f }, { 0.15220815f, 0.3776549f, 0.24287918f, 0.9749421f, 0.0794218f } },
        { { 5.8096695f, 5.778118f }, { 0.78445745f, 5.0749164f }, 0.7735326f, { 0.3339664f, 0.47089702f, 0.40879056f }, { 5.0749164f, 1.8826957f }, 0.4920326f, { 1.5864273f, -0.18677999f }, { 0.15220815f, 0.3776549f, 0.24287918f, 0.9749421f, 0.0794218f } },
        { { 4.6809397f, 4.3207445f }, { 6.7371883f, 2.7111526f }, 0.5956359f, { 0.31062055f, 0.25224143f, 0.22871599f }, { 2.7111526f, 1.5388427f }, 0.08863926f, { 1.8842902f, 3.145852f }, { 0.55492806f, 0.48039466f, 0.22821856f, 0.07750225f, 0.33037806f } },
        { { 4.6809397f, 4.3207445f }, { 6.7371883f, 2.7111523f }, 0.5956359f, { 0.31062055f, 0.25224146f, 0.22871599f }, { 2.7111526f, 1.5388427f }, 0.08863925f, { 1.8842902f, 3.145852f }, { 0.55492806f, 0.4803947f, 0.22821857f, 0.07750225f, 0.33037806f } },
        { { 7.3770766f, 6.293498f }, { 2.1553094f, 4.375427f }, 0.18649796f, { 0.56964207f, 0.83072793f, 0.38468498f }, { 7.341204f, -0.5338738f }, 0.64028823f, { 2.7532644f, 1.0887212f }, { 0.507771f, 0.7828196f, 0.6563172f, 0.37395233f, 0.30339003f } },
        { { 7.377077f, 6.293498f }, { 2.1553092f, 4.3754272f }, 0.18649796f, { 0.56964207f, 0.83072793f, 0.38468498f }, { 7.3412046f, -0.5338738f }, 0.64028823f, { 2.7532644f, 1.088721f }, { 0.507771f, 0.7828196f, 0.65631723f, 0.37395233f, 0.30339003f } },
        { { 6.2272835f, 6.7250366f }, { 1.8900946f, 2.7481818f }, 0.3039418f, { 0.47473955f, 0.70660436f, 0.42237622f }, { 7.2278147f, 1.1709919f }, 0.8646536f, { 2.9254932f, 2.2854695f }, { 0.43668532f, 0.6460773f, 0.8170272f, 0.49465507f, 0.58933294f } },
        { { 6.2272835f, 6.7250366f }, { 1.8900948f, 2.7481818f }, 0.3039418f, { 0.47473955f, 0.70660436f, 0.42237622f }, { 7.2278147f, 1.1709919f }, 0.8646536f, { 2.9254932f, 2.2854695f }, { 0.43668532f, 0.6460773f, 0.8170272f, 0.49465507f, 0.58933294f } },
        { { 3.2062654f, 5.6266775f }, { 3.2778158f, 0.04180479f }, 0.6209705f, { 0.29171437f, 0.3631984f, 0.3744244f }, { 5.12068f, 3.971807f }, 0.94358504f, { 3.5113888f, 4.9287004f }, { 0.36622554f, 0.40310556f, 0.8835983f, 0.5612514f, 0.93348134f } },
        { { 3.2062654f, 5.626677f }, { 3.2778158f, 0.04180479f }, 0.6209705f, { 0.29171437f, 0.36319843f, 0.3744244f }, { 5.12068f, 3.971807f }, 0.94358504f, { 3.511389f, 4.9287004f }, { 0.36622554f, 0.4031056f, 0.8835983f, 0.5612514f, 0.93348134f } },
        { { 6.2605247f, 3.917576f }, { 4.2864814f, 1.9342368f }, 0.33323586f, { 0.4602545f, 0.36979812f, 0.75622785f }, { 4.286481f, 6.572097f }, 0.34258032f, { 2.9250538f, 4.4986544f }, { 0.83355296f, 0.53191257f, 0.69887495f, 0.5965739f, 0.57509923f } },
        { { 6.2605247f, 3.9175763f }, { 4.286481f, 1.9342368f }, 0.33323586f, { 0.4602545f, 0.36979812f, 0.75622785f }, { 4.286481f, 6.572097f }, 0.34258032f, { 2.925054f, 4.4986544f }, { 0.83355296f, 0.53191257f, 0.69887495f, 0.59657395f, 0.57509923f } },
        { { 5.4951577f, 4.4719267f }, { 2.8831775f, 0.21066353f }, 0.17874068f, { 0.44647962f, 0.4617998f, 0.6984881f }, { 5.742752f, 5.545534f }, 0.08677624f, { 3.5113292f, 6.0151715f }, { 0.81437767f, 0.45975822f, 0.5966033f, 0.756184f, 0.82110715f } },
        { { 5.4951572f, 4.4719267f }, { 2.8831773f, 0.21066353f }, 0.17874068f, { 0.44647962f, 0.4617998f, 0.6984881f }, { 5.742752f, 5.545534f }, 0.08677624f, { 3.5113292f, 6.015172f }, { 0.81437767f, 0.45975822f, 0.5966033f, 0.756184f, 0.82110715f } },
        { { 3.4544349f, 1.8694429f }, { 2.84018f, 5.216563f }, 0.17978132f, { 0.45780563f, 0.61393976f, 0.2968213f }, { 4.5913124f, 4.172785f }, 0.69816995f, { 3.732719f, 6.7300606f }, { 0.8317231f, 0.34846747f, 0.5895587f, 0.6792252f, 0.76088774f } },
        { { 3.4544349f, 1.8694429f }, { 2.8401802f, 5.216563f }, 0.17978132f, { 0.45780563f, 0.61393976f, 0.2968213f }, { 4.5913124f, 4.172785f }, 0.69816995f, { 3.732719f, 6.7300606f }, { 0.8317231f, 0.34846747f, 0.5895587f, 0.6792252f, 0.76088774f } },
        { { 6.592314f, 1.3137561f }, { 6.654947f, 3.3151145f }, 0.28306705f, { 0.7563524f, 0.8482702f, 0.8749243f }, { 0.3300951f, 5.857856f }, 0.8266672f, { 0.8793685f, 3.8206527f }, { 0.74408233f, 0.1829091f, 0.13371679f, 0.8676827f, 0.87701833f } },
        { { 6.592314f, 1.3137562f }, { 6.6549463f, 3.3151145f }, 0.28306705f, { 0.7563524f, 0.8482702f, 0.8749243f }, { 0.3300951f, 5.857856f }, 0.8266672f, { 0.87936854f, 3.820653f }, { 0.74408233f, 0.1829091f, 0.13371679f, 0.8676827f, 0.87701833f } },
    };
    static const space_invaders_action_t actions[24] = {
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_LEFT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_RIGHT,
        SPACE_INVADERS_FIRE,
        SPACE_INVADERS_FIRE,
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
