/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix mountain_car --profile fast
 * Graph SHA-256: 619c5b1aa69f78a0619c4a681268039cf054605380d24d4a3f9d9b1441495474
 * 2 teams (2 on the longest walk), 7 edges, 6 programs, 11 distinct operations.
 * Computes in f32 with own maths.
 */
#include "mountain_car.h"

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

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

uint16_t mountain_car_infer(const mountain_car_state_t *state)
{
    uint32_t vertex;

    {
        float best = -FLT_MAX;
        uint32_t way = 3U;
        const float v3 = state->position[0] * (-2.5000443F);
        const float v5 = v3 + (-1.089072F);

        if (v5 >= best) {
            best = v5;
            way = 2U;
        }
        const float v7 = state->position[0] * 2.3253112F;
        const float v10 = state->velocity[0] * 96.694336F;
        const float v11 = v7 + v10;
        const float v13 = v11 + (-1.0729886F);

        if (v13 >= best) {
            best = v13;
            way = 1U;
        }
        const float v15 = state->velocity[0] + (-1.0512869F);

        if (v15 >= best) {
            best = v15;
            way = 2U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            way = 3U;
        }

        if (way == 1U) {
            vertex = 2U;
            goto decided;
        } else if (way == 2U) {
            goto team_1;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

team_1:
    {
        float best = -FLT_MAX;
        uint32_t way = 2U;
        const float v7 = state->position[0] * 2.3253112F;
        const float v10 = state->velocity[0] * 96.694336F;
        const float v11 = v7 + v10;
        const float v13 = v11 + (-1.0729886F);

        if (v13 >= best) {
            best = v13;
            way = 1U;
        }
        const float v17 = state->position[0] * (-2.1966188F);
        const float v19 = state->velocity[0] * 99.67122F;
        const float v20 = v17 + v19;
        const float v22 = v20 + (-1.033289F);

        if (v22 >= best) {
            best = v22;
            way = 1U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            way = 2U;
        }

        if (way == 1U) {
            vertex = 2U;
            goto decided;
        } else {
            vertex = 0U;
            goto decided;
        }
    }

decided:
    return (uint16_t)vertex;
}

#ifndef MOUNTAIN_CAR_NO_SELFTEST

uint32_t mountain_car_selftest(void)
{
    static const mountain_car_state_t states[16] = {
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
    static const uint16_t actions[16] = {
        0U, 0U, 2U, 0U, 2U, 0U, 0U, 0U, 2U, 0U, 0U, 0U, 0U, 0U, 0U, 2U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (mountain_car_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
