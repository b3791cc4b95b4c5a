/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix lunar_lander --profile fast
 * Graph SHA-256: 4860121d1ea3ffdf89e9ada410cfbcba3eec3d600e5fe2f31f6c9ab863872977
 * 1 teams (1 on the longest walk), 4 edges, 4 programs, 23 distinct operations.
 * Computes in f32 with own maths.
 */
#include "lunar_lander.h"

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

uint16_t lunar_lander_infer(const lunar_lander_state_t *state)
{
    uint32_t vertex;

    {
        const volatile float constant = 0.0F;
        const float zero = constant;
        float best = zero;
        uint32_t way = 1U;
        const float v3 = state->obs[0] * 0.54824466F;
        const float v6 = state->obs[1] * 0.41400775F;
        const float v7 = v3 + v6;
        const float v10 = state->obs[4] * (-1.3129216F);
        const float v11 = v7 + v10;
        const float v14 = state->obs[5] * (-1.5008805F);
        const float v15 = v11 + v14;

        if (v15 >= best) {
            best = v15;
            way = 2U;
        }
        const float v17 = state->obs[1] * (-0.7259825F);
        const float v20 = state->obs[3] * (-2.4281847F);
        const float v21 = v17 + v20;
        const float v23 = v21 + (-0.2920304F);

        if (v23 >= best) {
            best = v23;
            way = 3U;
        }
        const float v25 = state->obs[0] * (-0.50036424F);
        const float v27 = state->obs[1] * 0.32095438F;
        const float v28 = v25 + v27;
        const float v31 = state->obs[2] * (-1.462079F);
        const float v32 = v28 + v31;
        const float v34 = state->obs[3] * 1.0567017F;
        const float v35 = v32 + v34;
        const float v37 = state->obs[4] * 1.1205845F;
        const float v38 = v35 + v37;
        const float v41 = state->obs[7] * (-0.700306F);
        const float v42 = v38 + v41;
        const float v44 = v42 + 0.4441619F;

        if (v44 >= best) {
            way = 4U;
        }

        if (way == 1U) {
            vertex = 0U;
            goto decided;
        } else if (way == 2U) {
            vertex = 1U;
            goto decided;
        } else if (way == 3U) {
            vertex = 2U;
            goto decided;
        } else {
            vertex = 3U;
            goto decided;
        }
    }

decided:
    return (uint16_t)vertex;
}

#ifndef LUNAR_LANDER_NO_SELFTEST

uint32_t lunar_lander_selftest(void)
{
    static const lunar_lander_state_t states[16] = {
        { { -0.4875717F, -2.0980814F, 1.9312036F, -5.613508F, -2.7182243F, 4.2122045F, 0.46108818F, 0.1526527F } },
        { { 1.8739054F, 1.0331204F, -0.33485687F, 1.5441828F, -5.0333405F, -4.7216487F, 0.4534597F, 0.28022873F } },
        { { 2.4551618F, 2.0617747F, 8.942349F, -7.3351216F, -1.9643234F, -0.39395505F, 0.39733443F, 0.013697542F } },
        { { -2.2554016F, -1.5743524F, 0.5104994F, -4.6373506F, -5.172111F, -7.990908F, 0.99101675F, 0.6949953F } },
        { { -1.9587727F, 0.39836013F, 4.614952F, 4.093011F, -3.475596F, 9.062733F, 0.12823077F, 0.6325227F } },
        { { 1.5194442F, 0.40672827F, 7.992153F, -2.4138536F, -0.29107258F, 8.44378F, 0.3385435F, 0.6258185F } },
        { { -1.0913578F, -1.3658549F, 1.4372544F, 8.728656F, -1.9488846F, 8.146455F, 0.9961968F, 0.8893838F } },
        { { 1.1621023F, 0.07613831F, 2.9985113F, 1.37224F, 1.4367582F, -0.5595976F, 0.6483753F, 0.60657984F } },
        { { -2.174269F, -1.2971836F, -1.5897672F, -2.682392F, -1.7255344F, -4.909406F, 0.58948886F, 0.2752873F } },
        { { 1.9505429F, 0.77055216F, -5.670921F, 2.4139233F, -1.7231401F, -4.932248F, 0.98349655F, 0.53900975F } },
        { { 2.2022586F, -1.2244658F, -4.6247087F, -7.2466288F, -1.292302F, 7.606329F, 0.8799096F, 0.06705855F } },
        { { 1.8160483F, 2.2911978F, 8.547621F, -7.4921865F, -5.802548F, -9.441242F, 0.58422893F, 0.71881175F } },
        { { 1.4047858F, 2.3151753F, 4.985565F, -7.976382F, 2.0547006F, -1.4743857F, 0.43527922F, 0.6502973F } },
        { { 1.5217214F, -2.3216858F, 6.178295F, 0.17678353F, -6.008281F, -3.708896F, 0.77451867F, 0.98424685F } },
        { { 1.7454512F, 0.5798385F, 0.699479F, 0.10572243F, -1.2319939F, 7.206802F, 0.81706184F, 0.43020892F } },
        { { -2.2226267F, 0.26387098F, -2.5254076F, 9.791858F, -1.6799787F, -7.2984695F, 0.0387948F, 0.32251278F } },
    };
    static const uint16_t actions[16] = {
        2U, 1U, 2U, 1U, 0U, 2U, 3U, 0U, 1U, 1U, 2U, 1U, 2U, 1U, 0U, 3U
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (lunar_lander_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
