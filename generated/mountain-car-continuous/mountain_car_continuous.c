/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix mountain_car_continuous --profile fast
 * Graph SHA-256: 2df7341b545eca60de0f638be2a5ace6a42c8fd5e00a17155052b0a540adac4d
 * 1 teams (1 on the longest walk), 2 edges, 2 programs, 4 distinct operations.
 * Computes in f32 with own maths.
 */
#include "mountain_car_continuous.h"

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

static float mountain_car_continuous_min(float a, float b)
{
    return (a < b) ? a : b;
}

/* An output in its range. What is neither in it nor below is NaN. */
static float mountain_car_continuous_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

void mountain_car_continuous_infer(const mountain_car_continuous_state_t *state, mountain_car_continuous_action_t *action)
{
    float out0;

    {
        const volatile float constant = 0.0F;
        const float zero = constant;
        float best = zero;
        uint32_t way = 1U;
        const float v2 = mountain_car_continuous_min(state->velocity[0], 0.0F);

        if (v2 >= best) {
            way = 2U;
        }

        if (way == 1U) {
            goto leaf_0;
        } else {
            goto leaf_1;
        }
    }

leaf_0:
    {
        const float v4 = state->velocity[0] - 0.04839926F;

        out0 = v4;
    }
    goto answered;

leaf_1:
    {
        const float v6 = state->velocity[0] * 4.846634F;
        const float v7 = 0.0F + v6;

        out0 = v7;
    }

answered:
    action->force = mountain_car_continuous_clamp(out0, -1.0F, 1.0F, 0.0F);
}

#ifndef MOUNTAIN_CAR_CONTINUOUS_NO_SELFTEST

uint32_t mountain_car_continuous_selftest(void)
{
    static const mountain_car_continuous_state_t states[16] = {
        { { -0.47552583F }, { -0.058746282F } },
        { { -0.12619168F }, { -0.03929456F } },
        { { -0.689357F }, { 0.02948543F } },
        { { -0.3700413F }, { -0.048628625F } },
        { { 0.37460595F }, { 0.02892737F } },
        { { -0.33013713F }, { 0.010809279F } },
        { { -1.0209728F }, { -0.03305154F } },
        { { -0.38377252F }, { -0.03076798F } },
        { { 0.5838583F }, { 0.05772969F } },
        { { 0.50481147F }, { -0.05134585F } },
        { { -0.5813686F }, { -0.0027576855F } },
        { { -0.48479804F }, { -0.06808235F } },
        { { -1.1119446F }, { -0.044081867F } },
        { { -0.25405505F }, { -0.032461453F } },
        { { -1.0408504F }, { -0.05593636F } },
        { { 0.58383024F }, { 0.027299343F } },
    };
    static const mountain_car_continuous_action_t actions[16] = {
        { -0.10714554F },
        { -0.08769382F },
        { 0.14290509F },
        { -0.09702788F },
        { 0.14020038F },
        { 0.05238862F },
        { -0.0814508F },
        { -0.07916724F },
        { 0.2797947F },
        { -0.09974511F },
        { -0.051156946F },
        { -0.1164816F },
        { -0.09248112F },
        { -0.08086071F },
        { -0.10433562F },
        { 0.13230991F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        mountain_car_continuous_action_t action;

        mountain_car_continuous_infer(&states[vector], &action);
        if ((action.force < actions[vector].force) || (action.force > actions[vector].force)) {
            failures++;
        }
    }
    return failures;
}
#endif
