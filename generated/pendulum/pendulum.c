/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix pendulum --profile fast
 * Graph SHA-256: e371857f5f2d98485533a900f5b0c18626fc44af90b3ad69194605f6c7bd3e14
 * 1 teams (1 on the longest walk), 2 edges, 2 programs, 14 distinct operations.
 * Computes in f32 with own maths.
 */
#include "pendulum.h"

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

static float pendulum_min(float a, float b)
{
    return (a < b) ? a : b;
}

/* An output in its range. What is neither in it nor below is NaN. */
static float pendulum_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

/* Teams in an order in which every one comes after all that lead to it: control only goes forward. */

void pendulum_infer(const pendulum_state_t *state, pendulum_action_t *action)
{
    float out0;

    {
        float best = -FLT_MAX;
        uint32_t way = 2U;
        const float v2 = pendulum_min(state->cos_theta[0], state->sin_theta[0]);

        if (v2 >= best) {
            best = v2;
            way = 1U;
        }
        const float v5 = state->cos_theta[0] * 4.407756F;

        if (v5 >= best) {
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
        const float v7 = state->sin_theta[0] * 6.6331344F;
        const float v8 = 0.0F + v7;
        const float v11 = state->cos_theta[0] * (-22.268024F);
        const float v12 = (-0.38278264F) + v11;
        const float v15 = state->omega[0] * 2.6018698F;
        const float v16 = v8 + v15;
        const float v17 = v12 * v16;

        out0 = v17;
    }
    goto answered;

leaf_1:
    {
        const float v19 = state->sin_theta[0] * 9.448936F;
        const float v20 = 0.0F + v19;
        const float v23 = state->omega[0] * 1.7750591F;
        const float v24 = v20 + v23;
        const float v25 = (-1.6007409F) * v24;

        out0 = v25;
    }

answered:
    action->torque = pendulum_clamp(out0, -2.0F, 2.0F, 0.0F);
}

#ifndef PENDULUM_NO_SELFTEST

uint32_t pendulum_selftest(void)
{
    static const pendulum_state_t states[16] = {
        { { -0.19502868F }, { -0.83923256F }, { 1.5449629F } },
        { { -0.5613508F }, { -0.43261883F }, { 3.3697636F } },
        { { -0.077823654F }, { -0.6946946F }, { 5.996497F } },
        { { 0.41324815F }, { -0.03348569F }, { 1.2353462F } },
        { { -0.80108094F }, { -0.47216487F }, { -0.7446444F } },
        { { -0.43954256F }, { 0.9820647F }, { 6.5976787F } },
        { { 0.89423496F }, { -0.73351216F }, { -2.5010543F } },
        { { -0.039395504F }, { -0.20533113F }, { -7.7808394F } },
        { { -0.90216064F }, { -0.62974095F }, { 0.40839955F } },
        { { -0.46373504F }, { -0.823167F }, { -6.3927264F } },
        { { 0.98203355F }, { 0.3899906F }, { -6.2680726F } },
        { { 0.15934406F }, { 0.46149522F }, { 3.2744086F } },
        { { -0.5531582F }, { 0.9062733F }, { -5.948308F } },
        { { 0.26504543F }, { 0.60777766F }, { 1.3015305F } },
        { { 0.7992153F }, { -0.24138537F }, { -0.37060508F } },
        { { 0.84437793F }, { -0.32291302F }, { 2.0130963F } },
    };
    static const pendulum_action_t actions[16] = {
        { -2.0F },
        { 2.0F },
        { -2.0F },
        { -2.0F },
        { -2.0F },
        { 2.0F },
        { 2.0F },
        { 2.0F },
        { -2.0F },
        { -2.0F },
        { 2.0F },
        { -2.0F },
        { -2.0F },
        { -2.0F },
        { 2.0F },
        { -0.8358754F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        pendulum_action_t action;

        pendulum_infer(&states[vector], &action);
        if ((action.torque < actions[vector].torque) || (action.torque > actions[vector].torque)) {
            failures++;
        }
    }
    return failures;
}
#endif
