/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix pendulum --profile fast
 * Graph SHA-256: c034b28dcf32060bad568b03a753a01658350865786d56eddbd7ad5488a83f29
 * 1 teams (1 on the longest walk), 2 edges, 2 programs, 11 distinct operations.
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

static float pendulum_negate_if_less(float a, float b)
{
    return (a < b) ? -a : a;
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
        const volatile float constant = 0.0F;
        const float zero = constant;
        float best = zero;
        uint32_t way = 1U;
        const float v3 = pendulum_negate_if_less((-0.28330687F), state->cos_theta[0]);

        if (v3 >= best) {
            way = 2U;
        }

        if (way == 1U) {
            goto leaf_1;
        } else {
            goto leaf_0;
        }
    }

leaf_0:
    {
        const float v6 = state->sin_theta[0] / (-0.11899939F);
        const float v9 = (-0.03674821F) - state->omega[0];
        const float v10 = v6 + v9;
        const float v11 = v10 - state->omega[0];
        const float v12 = v11 / state->cos_theta[0];

        out0 = v12;
    }
    goto answered;

leaf_1:
    {
        const float v13 = state->sin_theta[0] / state->cos_theta[0];
        const float v15 = (-0.023996977F) - state->omega[0];
        const float v16 = v13 + v15;
        const float v17 = v16 - state->omega[0];
        const float v18 = v17 / state->cos_theta[0];

        out0 = v18;
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
        { 2.0F },
        { -2.0F },
        { -2.0F },
        { 2.0F },
        { 2.0F },
        { -2.0F },
        { 0.158242F },
        { -2.0F },
        { 2.0F },
        { -2.0F },
        { -2.0F },
        { -2.0F },
        { 2.0F },
        { -1.5980666F },
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
