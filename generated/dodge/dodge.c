/*
 * A policy for dodge, score 11.39 in validation, trained by tpg-train 0.1.0 with seed 3.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix dodge --profile fast
 * Graph SHA-256: cdea7daabca328e27e33a768eb228f4f6759f7262ab7fd254d28e16436a5fda2
 * 2 teams (2 on the longest walk), 13 edges, 12 programs, 9 distinct operations.
 * A decision takes at most 13 bids and 12 operations.
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

static float dodge_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float dodge_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. No team leads back to one above it. */
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

        /* Volatile: for a 0 that they know, compilers may take max(0, x), which is wrong for NaN. */
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

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
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
    static const dodge_state_t states[24] = {
        { { -798.83746f, -3437.4966f, 791.021f, -2299.293f }, { 212.05965f, 1.6848818f, -54.47656f, -486.28622f, 524.6935f, 289.2737f }, { 431.5829f, 0.6176731f }, { 15.913524f, 42.22681f, 453.45972f }, 71.45833f, 991.03235f },
        { { 3378.0115f, 3662.7864f, -3004.4658f, -1280.5398f }, { 428.33246f, -0.8213245f, -680.8234f, -631.51245f, -440.81866f, 35.73496f }, { 194.94572f, -3.292668f }, { 16.072735f, 158.56268f, 694.9953f }, 27.602592f, 579.67206f },
        { { 1890.2844f, 1676.4972f, -2265.736f, 3712.0955f }, { 41.05384f, 1.0601817f, 425.44437f, 113.88391f, 559.45074f, -168.96976f }, { 424.5209f, 3.3775117f }, { 54.166958f, 100.13097f, 281.72845f }, 57.8414f, 571.86273f },
        { { 3575.2573f, -1270.4752f, 3336.788f, 4064.8442f }, { 878.32214f, 1.8593637f, 21.318727f, 209.8958f, 96.05679f, 160.06702f }, { 419.22214f, 1.1870021f }, { 97.05278f, 10.423394f, 240.56326f }, 107.23047f, 365.8804f },
        { { -617.7782f, 1882.3066f, 795.99634f, 1992.4148f }, { 390.7505f, -0.24648851f, 285.7298f, 1.4403389f, -204.84738f, -16.838478f }, { 359.09845f, 2.6948938f }, { 25.900803f, 80.76247f, 440.5667f }, 113.26691f, 478.42664f },
        { { 3104.142f, 606.593f, 2465.5693f, 1655.3938f }, { 216.38388f, 1.4317148f, 408.1176f, -522.2744f, -392.74335f, -247.39374f }, { 576.2643f, 3.256627f }, { 42.30739f, 107.36534f, 32.376587f }, 42.15695f, 618.57166f },
        { { 3104.142f, 606.5931f, 2465.5693f, 1655.3938f }, { 216.38388f, 1.4317148f, 408.1176f, -522.27435f, -392.74335f, -247.39374f }, { 576.2642f, 3.256627f }, { 42.30739f, 107.36533f, 32.376587f }, 42.15695f, 618.57166f },
        { { 3297.731f, 157.44336f, 2479.7046f, -3470.246f }, { 536.77185f, 1.5207624f, -159.80493f, 206.58484f, -217.4386f, 193.8223f }, { -8.663156f, 1.6554084f }, { 16.01442f, 41.363197f, 123.960236f }, 95.614746f, 197.92169f },
        { { 3297.731f, 157.44336f, 2479.7046f, -3470.246f }, { 536.77185f, 1.5207624f, -159.80493f, 206.58484f, -217.4386f, 193.8223f }, { -8.663155f, 1.6554084f }, { 16.01442f, 41.363197f, 123.960236f }, 95.614746f, 197.92169f },
        { { -2253.343f, -980.5414f, -2488.0098f, 3886.4893f }, { 517.2704f, 0.4612049f, 360.90265f, -10.143138f, -60.122368f, -424.02148f }, { 373.89725f, -3.3733325f }, { 77.90141f, 28.824085f, 48.42575f }, 81.9922f, 451.79865f },
        { { -2253.3433f, -980.5414f, -2488.0098f, 3886.4893f }, { 517.2704f, 0.4612049f, 360.90265f, -10.143139f, -60.122368f, -424.02148f }, { 373.89722f, -3.3733325f }, { 77.90141f, 28.824085f, 48.42575f }, 81.9922f, 451.79865f },
        { { -1806.9297f, -2267.8477f, -2096.5068f, 1668.9263f }, { 312.06067f, 0.9900876f, 416.30298f, -344.63043f, 73.90817f, -365.7718f }, { 358.6526f, -0.92476547f }, { 74.52872f, 66.40674f, 48.310547f }, 126.43193f, 433.18134f },
        { { -1806.9297f, -2267.8477f, -2096.5068f, 1668.9263f }, { 312.06064f, 0.9900876f, 416.30298f, -344.63046f, 73.90817f, -365.7718f }, { 358.65262f, -0.92476547f }, { 74.52872f, 66.40674f, 48.310547f }, 126.43193f, 433.18134f },
        { { 2719.586f, 2539.5542f, -287.588f, -981.75195f }, { 807.9346f, 2.4222698f, 480.29712f, 444.0135f, -48.41954f, -490.27368f }, { 15.815617f, -1.2124087f }, { 100.48186f, 28.263432f, 939.29785f }, 135.06879f, 955.11346f },
        { { 2719.586f, 2539.5542f, -287.588f, -981.75195f }, { 807.9346f, 2.4222698f, 480.29712f, 444.0135f, -48.41954f, -490.27368f }, { 15.815617f, -1.2124088f }, { 100.48186f, 28.263432f, 939.29785f }, 135.06879f, 955.1135f },
        { { 2599.6626f, 2352.3467f, -64.96975f, -1051.0215f }, { 792.40027f, 2.3710055f, 486.50238f, 440.82758f, -38.51516f, -496.9613f }, { 14.326385f, -1.10726f }, { 97.18524f, 25.765759f, 931.3623f }, 134.84009f, 945.6887f },
        { { 2599.6626f, 2352.3467f, -64.96974f, -1051.0215f }, { 792.40027f, 2.3710055f, 486.50238f, 440.82758f, -38.51516f, -496.9613f }, { 14.3263855f, -1.10726f }, { 97.18524f, 25.765759f, 931.3623f }, 134.84009f, 945.6887f },
        { { 2276.7197f, -2530.2207f, 2325.7896f, 3594.4897f }, { 206.12613f, -1.4778936f, 380.2417f, 59.81105f, 566.78467f, -273.73022f }, { 142.99884f, 0.6987829f }, { 99.44357f, 76.8197f, 238.97363f }, 64.48468f, 381.97247f },
        { { 2276.7197f, -2530.2207f, 2325.7896f, 3594.4897f }, { 206.12613f, -1.4778936f, 380.2417f, 59.81105f, 566.78467f, -273.73022f }, { 142.99883f, 0.6987829f }, { 99.44357f, 76.8197f, 238.97362f }, 64.48468f, 381.97247f },
        { { 2034.6342f, -1525.0503f, 3353.4863f, 3325.0532f }, { 156.02145f, -1.8098788f, 473.59158f, 308.53122f, 485.62012f, -282.2525f }, { 82.09217f, 1.580962f }, { 80.201614f, 62.285378f, 116.23959f }, 73.18042f, 390.62344f },
        { { 2034.634f, -1525.0503f, 3353.4863f, 3325.0532f }, { 156.02145f, -1.8098788f, 473.59155f, 308.53125f, 485.62012f, -282.2525f }, { 82.09218f, 1.580962f }, { 80.201614f, 62.285378f, 116.23959f }, 73.18042f, 390.6234f },
        { { 2224.581f, -885.3187f, 95.03696f, 2000.2317f }, { 93.337845f, -0.90076184f, -197.34354f, -264.7657f, 154.04504f, -15.384529f }, { 474.7207f, -2.0466628f }, { 57.420174f, 119.26599f, 485.12756f }, 132.82382f, 959.84827f },
        { { 2224.581f, -885.3187f, 95.03696f, 2000.2316f }, { 93.337845f, -0.90076184f, -197.34354f, -264.7657f, 154.04503f, -15.384529f }, { 474.72067f, -2.0466628f }, { 57.420177f, 119.26598f, 485.12756f }, 132.82384f, 959.84827f },
        { { 2424.101f, -2016.6783f, -1675.6036f, 383.6394f }, { -2.476739f, -3.0949252f, 143.10101f, 70.07106f, -119.31879f, -486.71844f }, { 401.16824f, -2.8499196f }, { 99.45795f, 90.889084f, 465.39154f }, 186.15265f, 866.5599f },
    };
    static const dodge_action_t actions[24] = {
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_FIELD_BASE_UP,
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_FIELD_BASE_UP,
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_FIELD_BASE_UP,
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_FIELD_BASE_UP,
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_FIELD_BASE_UP,
        DODGE_FIELD_BASE_UP,
    };
    uint32_t failures = dodge_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (dodge_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
