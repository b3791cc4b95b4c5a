/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix dodge --profile fast
 * Graph SHA-256: cdea7daabca328e27e33a768eb228f4f6759f7262ab7fd254d28e16436a5fda2
 * 2 teams (2 on the longest walk), 13 edges, 12 programs, 9 distinct operations.
 * Computes in f32 with own maths.
 */
#include "dodge.h"

#include <float.h>
#include <math.h>

#ifdef __FAST_MATH__
#error "fast-math reorders operations and drops NaN: the policy would act differently"
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

static float dodge_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
}

static float dodge_max(float a, float b)
{
    return (a > b) ? a : b;
}

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

uint16_t dodge_infer(const dodge_state_t *state)
{
    uint32_t vertex;

    {
        float best = -FLT_MAX;
        uint32_t way = 4U;
        const float v5 = state->detour[0] - state->second[0];

        if (v5 >= best) {
            best = v5;
            way = 1U;
        }
        const float v7 = fabsf(state->ahead[2]);

        if (v7 >= best) {
            best = v7;
            way = 4U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 1U;
        }
        const float v12 = 634.5653F / state->near[3];

        if (v12 >= best) {
            best = v12;
            way = 2U;
        }
        const float v1 = fabsf(state->second[1]);

        if (v1 >= best) {
            best = v1;
            way = 3U;
        }
        const float v10 = dodge_negate_if_less(state->ahead[0], state->near[3]);

        if (v10 >= best) {
            best = v10;
            way = 4U;
        }
        const float v13 = 634.5653F / state->detour[0];

        if (v13 >= best) {
            best = v13;
            way = 4U;
        }
        const float v14 = dodge_max(state->ahead[0], state->near[3]);

        if (v14 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 7U;
            goto decided;
        } else if (way == 2U) {
            goto team_1;
        } else if (way == 3U) {
            vertex = 8U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_1:
    {
        float best = -FLT_MAX;
        uint32_t way = 2U;
        const float v13 = 634.5653F / state->detour[0];

        if (v13 >= best) {
            best = v13;
            way = 2U;
        }
        const float v10 = dodge_negate_if_less(state->ahead[0], state->near[3]);

        if (v10 >= best) {
            best = v10;
            way = 2U;
        }
        const float v16 = state->left[3] - state->second[0];

        if (v16 >= best) {
            best = v16;
            way = 1U;
        }
        const float v14 = dodge_max(state->ahead[0], state->near[3]);

        if (v14 >= best) {
            best = v14;
            way = 2U;
        }
        const float v17 = state->ahead[0] - state->near[3];

        if (v17 >= best) {
            way = 2U;
        }

        if (way == 1U) {
            vertex = 13U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

decided:
    return (uint16_t)vertex;
}

#ifndef DODGE_NO_SELFTEST

uint32_t dodge_selftest(void)
{
    static const dodge_state_t states[16] = {
        { { -798.83746F, -3437.4966F, 791.021F, -2299.293F }, { 212.05965F, 1.6848818F, -54.47656F, -486.28622F, 524.6935F, 289.2737F }, { 431.5829F, 0.6176731F }, { 15.913524F, 42.22681F, 453.45972F }, { 71.45833F }, { 991.03235F } },
        { { 3378.0115F, 3662.7864F, -3004.4658F, -1280.5398F }, { 428.33246F, -0.8213245F, -680.8234F, -631.51245F, -440.81866F, 35.73496F }, { 194.94572F, -3.292668F }, { 16.072735F, 158.56268F, 694.9953F }, { 27.602592F }, { 579.67206F } },
        { { 1890.2844F, 1676.4972F, -2265.736F, 3712.0955F }, { 41.05384F, 1.0601817F, 425.44437F, 113.88391F, 559.45074F, -168.96976F }, { 424.5209F, 3.3775117F }, { 54.166958F, 100.13097F, 281.72845F }, { 57.8414F }, { 571.86273F } },
        { { 3575.2573F, -1270.4752F, 3336.788F, 4064.8442F }, { 878.32214F, 1.8593637F, 21.318727F, 209.8958F, 96.05679F, 160.06702F }, { 419.22214F, 1.1870021F }, { 97.05278F, 10.423394F, 240.56326F }, { 107.23047F }, { 365.8804F } },
        { { -1124.8735F, -2010.8927F, 733.0926F, -1840.8464F }, { 879.11945F, 1.2328835F, -396.96448F, 168.97462F, -191.97238F, -345.2574F }, { 981.8462F, 0.31207782F }, { 150.47227F, 40.817093F, 268.76456F }, { 35.105484F }, { 397.16187F } },
        { { 3115.5522F, 3112.2192F, -3546.6563F, 2975.4136F }, { 954.06354F, 3.4190483F, -524.45306F, -646.45294F, -660.88696F, 117.9205F }, { 690.69293F, 2.2476573F }, { 154.08562F, 119.88452F, 101.180916F }, { 169.1945F }, { 426.2807F } },
        { { -530.19257F, 1231.2355F, 2493.1882F, -3803.85F }, { 789.8062F, 0.070713416F, -669.37335F, -259.6227F, 384.3261F, 677.9456F }, { 833.99927F, 0.9277416F }, { 85.59583F, 80.84578F, 401.96103F }, { 219.38673F }, { 817.0618F } },
        { { -571.72845F, -3641.5515F, 432.3262F, -1034.407F }, { 988.5522F, -1.0695077F, -510.89288F, -645.68726F, -248.48212F, -327.23398F }, { 225.79639F, 2.7256804F }, { 122.10313F, 37.226376F, 845.8132F }, { 219.46246F }, { 492.51877F } },
        { { 3431.8682F, 2158.4348F, 962.03827F, 3257.0532F }, { 760.2836F, 3.9889047F, 122.89778F, 169.90729F, 538.37476F, 50.35659F }, { 573.91437F, 2.7944722F }, { 93.22262F, 44.11603F, 564.32495F }, { 196.54494F }, { 736.4109F } },
        { { 2237.2332F, -1285.6869F, 1140.5077F, -3031.0828F }, { 627.25574F, 0.48678848F, 429.87347F, -308.5574F, -647.1051F, -436.11035F }, { 714.60223F, -3.3201003F }, { 66.42155F, 133.03542F, 463.55753F }, { 17.308285F }, { 404.24536F } },
        { { -672.4921F, -2690.0313F, -3550.8337F, -396.24017F }, { 495.13977F, 1.2436103F, 111.58345F, 44.397903F, 527.90344F, -260.42932F }, { -75.11345F, 0.7757317F }, { 100.31682F, 132.72739F, 767.19147F }, { 17.26403F }, { 598.62836F } },
        { { -2291.3562F, -3615.7856F, -1878.1842F, -3135.6338F }, { 576.10443F, 1.7927446F, 38.848972F, -82.10994F, -505.07462F, 24.341017F }, { 962.45825F, 0.028473236F }, { 92.4454F, 156.99352F, 718.46423F }, { 11.294075F }, { 116.96155F } },
        { { -311.5763F, 1095.8895F, -2064.5693F, 710.2563F }, { 630.50824F, 1.0800585F, 688.9965F, -583.93335F, -320.43134F, 366.17368F }, { 136.33942F, -0.49700496F }, { 131.10669F, 1.2852933F, 789.2338F }, { 234.0893F }, { 53.1927F } },
        { { 1818.303F, -3816.9702F, 725.0706F, -445.36856F }, { 461.35953F, -2.3833697F, -585.32446F, 462.39255F, 276.6533F, -55.959427F }, { 838.521F, -0.18550445F }, { 51.04028F, 86.204414F, 800.6376F }, { 24.827412F }, { 915.56085F } },
        { { -2274.8215F, -455.37036F, 1385.8036F, -1838.7356F }, { -79.99636F, -3.1306596F, -521.2054F, 420.90524F, 223.99902F, 394.8199F }, { 769.39044F, 3.4903958F }, { 63.00807F, 66.22725F, 922.5188F }, { 100.541725F }, { 384.14124F } },
        { { -2250.9756F, 2637.7083F, -1344.5947F, -1225.853F }, { 839.82007F, 3.933066F, -138.74998F, 150.554F, -76.777F, -439.83112F }, { 400.82498F, 0.64301753F }, { 78.15145F, 2.1564908F, 840.6795F }, { 88.21128F }, { 615.3496F } },
    };
    static const uint16_t actions[16] = {
        7U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U, 0U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (dodge_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
