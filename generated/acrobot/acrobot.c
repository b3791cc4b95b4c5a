/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix acrobot --profile fast
 * Graph SHA-256: c746bc981049f428c5e9cd92b39b159c476562abde6afb37fa55ace167b590d0
 * 1 teams (1 on the longest walk), 4 edges, 4 programs, 26 distinct operations.
 * Computes in f32 with own maths.
 */
#include "acrobot.h"

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

uint16_t acrobot_infer(const acrobot_state_t *state)
{
    uint32_t vertex;

    {
        float best = -FLT_MAX;
        uint32_t way = 2U;
        const float v3 = state->cos_theta_1[0] * (-2.7205236F);
        const float v6 = state->sin_theta_2[0] * (-1.2175102F);
        const float v7 = v3 + v6;
        const float v10 = state->omega_1[0] * (-0.49445456F);
        const float v11 = v7 + v10;
        const float v14 = state->omega_2[0] * 0.22029561F;
        const float v15 = v11 + v14;
        const float v17 = v15 + 2.3143518F;

        if (v17 >= best) {
            best = v17;
            way = 1U;
        }
        const float v19 = state->cos_theta_1[0] * (-3.3904653F);
        const float v22 = state->sin_theta_1[0] * (-0.12505245F);
        const float v23 = v19 + v22;
        const float v26 = state->cos_theta_2[0] * 0.27461419F;
        const float v27 = v23 + v26;
        const float v29 = state->omega_1[0] * (-0.4058117F);
        const float v30 = v27 + v29;
        const float v32 = v30 / 2.6443782F;

        if (v32 >= best) {
            best = v32;
            way = 1U;
        }
        const volatile float constant = 0.0F;
        const float zero = constant;

        if (zero >= best) {
            best = zero;
            way = 2U;
        }
        const float v34 = state->cos_theta_1[0] * (-2.6076918F);
        const float v36 = state->omega_2[0] * (-0.080515005F);
        const float v37 = v34 + v36;
        const float v39 = state->sin_theta_2[0] * (-1.831776F);
        const float v40 = v37 + v39;
        const float v42 = state->cos_theta_2[0] * 0.10326636F;
        const float v43 = v40 + v42;
        const float v45 = state->sin_theta_1[0] * 2.957902F;
        const float v46 = v43 + v45;
        const float v48 = v46 + (-0.69571906F);

        if (v48 >= best) {
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

#ifndef ACROBOT_NO_SELFTEST

uint32_t acrobot_selftest(void)
{
    static const acrobot_state_t states[16] = {
        { { -0.19502868F }, { -0.83923256F }, { 0.19312036F }, { -0.5613508F }, { -5.4364486F }, { 11.909728F } },
        { { -0.077823654F }, { -0.6946946F }, { 0.74956214F }, { 0.41324815F }, { -0.42079356F }, { 4.366074F } },
        { { -0.80108094F }, { -0.47216487F }, { -0.09308055F }, { -0.43954256F }, { 12.34099F }, { 23.318121F } },
        { { 0.89423496F }, { -0.73351216F }, { -0.3126318F }, { -0.039395504F }, { -2.5802672F }, { -27.499756F } },
        { { -0.90216064F }, { -0.62974095F }, { 0.051049944F }, { -0.46373504F }, { -10.344222F }, { -22.593761F } },
        { { 0.98203355F }, { 0.3899906F }, { -0.7835091F }, { 0.15934406F }, { 5.79932F }, { 11.572715F } },
        { { -0.5531582F }, { 0.9062733F }, { -0.7435385F }, { 0.26504543F }, { 7.63756F }, { 4.5999885F } },
        { { 0.7992153F }, { -0.24138537F }, { -0.046325635F }, { 0.84437793F }, { -4.0578446F }, { 7.1148696F } },
        { { -0.4365431F }, { -0.54634196F }, { 0.14372544F }, { 0.87286556F }, { -3.8977692F }, { 23.03356F } },
        { { 0.9923936F }, { 0.7787676F }, { 0.46484092F }, { 0.030455325F }, { 3.7680407F }, { 3.8799171F } },
        { { 0.22866715F }, { -0.05595976F }, { 0.29675052F }, { 0.21315971F }, { -10.929068F }, { -14.670802F } },
        { { -0.15897672F }, { -0.2682392F }, { -0.27462733F }, { -0.4909406F }, { 2.2491F }, { -12.707204F } },
        { { 0.7802172F }, { 0.30822086F }, { -0.5670921F }, { 0.24139233F }, { -3.4462802F }, { -13.945603F } },
        { { 0.96699303F }, { 0.078019455F }, { 0.8809034F }, { -0.48978633F }, { -5.8115807F }, { -20.48936F } },
        { { -0.20567624F }, { 0.7606329F }, { 0.75981915F }, { -0.8658829F }, { 9.128454F }, { 25.912836F } },
        { { 0.8547621F }, { -0.74921864F }, { -0.9235042F }, { -0.9441242F }, { 2.116904F }, { 12.373514F } },
    };
    static const uint16_t actions[16] = {
        2U, 2U, 2U, 0U, 2U, 0U, 0U, 2U, 2U, 0U, 2U, 0U, 0U, 0U, 2U, 2U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (acrobot_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
