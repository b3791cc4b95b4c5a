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
    static const dodge_state_t states[16] = {
        { { -798.83746f, -3437.4966f, 791.021f, -2299.293f }, { 212.05965f, 1.6848818f, -54.47656f, -486.28622f, 524.6935f, 289.2737f }, { 431.5829f, 0.6176731f }, { 15.913524f, 42.22681f, 453.45972f }, 71.45833f, 991.03235f },
        { { 3378.0115f, 3662.7864f, -3004.4658f, -1280.5398f }, { 428.33246f, -0.8213245f, -680.8234f, -631.51245f, -440.81866f, 35.73496f }, { 194.94572f, -3.292668f }, { 16.072735f, 158.56268f, 694.9953f }, 27.602592f, 579.67206f },
        { { 1890.2844f, 1676.4972f, -2265.736f, 3712.0955f }, { 41.05384f, 1.0601817f, 425.44437f, 113.88391f, 559.45074f, -168.96976f }, { 424.5209f, 3.3775117f }, { 54.166958f, 100.13097f, 281.72845f }, 57.8414f, 571.86273f },
        { { 3575.2573f, -1270.4752f, 3336.788f, 4064.8442f }, { 878.32214f, 1.8593637f, 21.318727f, 209.8958f, 96.05679f, 160.06702f }, { 419.22214f, 1.1870021f }, { 97.05278f, 10.423394f, 240.56326f }, 107.23047f, 365.8804f },
        { { -1124.8735f, -2010.8927f, 733.0926f, -1840.8464f }, { 879.11945f, 1.2328835f, -396.96448f, 168.97462f, -191.97238f, -345.2574f }, { 981.8462f, 0.31207782f }, { 150.47227f, 40.817093f, 268.76456f }, 35.105484f, 397.16187f },
        { { 3115.5522f, 3112.2192f, -3546.6563f, 2975.4136f }, { 954.06354f, 3.4190483f, -524.45306f, -646.45294f, -660.88696f, 117.9205f }, { 690.69293f, 2.2476573f }, { 154.08562f, 119.88452f, 101.180916f }, 169.1945f, 426.2807f },
        { { -530.19257f, 1231.2355f, 2493.1882f, -3803.85f }, { 789.8062f, 0.070713416f, -669.37335f, -259.6227f, 384.3261f, 677.9456f }, { 833.99927f, 0.9277416f }, { 85.59583f, 80.84578f, 401.96103f }, 219.38673f, 817.0618f },
        { { -571.72845f, -3641.5515f, 432.3262f, -1034.407f }, { 988.5522f, -1.0695077f, -510.89288f, -645.68726f, -248.48212f, -327.23398f }, { 225.79639f, 2.7256804f }, { 122.10313f, 37.226376f, 845.8132f }, 219.46246f, 492.51877f },
        { { 3431.8682f, 2158.4348f, 962.03827f, 3257.0532f }, { 760.2836f, 3.9889047f, 122.89778f, 169.90729f, 538.37476f, 50.35659f }, { 573.91437f, 2.7944722f }, { 93.22262f, 44.11603f, 564.32495f }, 196.54494f, 736.4109f },
        { { 2237.2332f, -1285.6869f, 1140.5077f, -3031.0828f }, { 627.25574f, 0.48678848f, 429.87347f, -308.5574f, -647.1051f, -436.11035f }, { 714.60223f, -3.3201003f }, { 66.42155f, 133.03542f, 463.55753f }, 17.308285f, 404.24536f },
        { { -672.4921f, -2690.0313f, -3550.8337f, -396.24017f }, { 495.13977f, 1.2436103f, 111.58345f, 44.397903f, 527.90344f, -260.42932f }, { -75.11345f, 0.7757317f }, { 100.31682f, 132.72739f, 767.19147f }, 17.26403f, 598.62836f },
        { { -2291.3562f, -3615.7856f, -1878.1842f, -3135.6338f }, { 576.10443f, 1.7927446f, 38.848972f, -82.10994f, -505.07462f, 24.341017f }, { 962.45825f, 0.028473236f }, { 92.4454f, 156.99352f, 718.46423f }, 11.294075f, 116.96155f },
        { { -311.5763f, 1095.8895f, -2064.5693f, 710.2563f }, { 630.50824f, 1.0800585f, 688.9965f, -583.93335f, -320.43134f, 366.17368f }, { 136.33942f, -0.49700496f }, { 131.10669f, 1.2852933f, 789.2338f }, 234.0893f, 53.1927f },
        { { 1818.303f, -3816.9702f, 725.0706f, -445.36856f }, { 461.35953f, -2.3833697f, -585.32446f, 462.39255f, 276.6533f, -55.959427f }, { 838.521f, -0.18550445f }, { 51.04028f, 86.204414f, 800.6376f }, 24.827412f, 915.56085f },
        { { -2274.8215f, -455.37036f, 1385.8036f, -1838.7356f }, { -79.99636f, -3.1306596f, -521.2054f, 420.90524f, 223.99902f, 394.8199f }, { 769.39044f, 3.4903958f }, { 63.00807f, 66.22725f, 922.5188f }, 100.541725f, 384.14124f },
        { { -2250.9756f, 2637.7083f, -1344.5947f, -1225.853f }, { 839.82007f, 3.933066f, -138.74998f, 150.554f, -76.777f, -439.83112f }, { 400.82498f, 0.64301753f }, { 78.15145f, 2.1564908f, 840.6795f }, 88.21128f, 615.3496f },
    };
    static const dodge_action_t actions[16] = {
        DODGE_FIELD_BASE_UP,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
        DODGE_PLAN,
    };
    uint32_t failures = dodge_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (dodge_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
