/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix lunar_lander_continuous --profile fast
 * Graph SHA-256: 21140b6a4c0651fa6f8a83087689cd7d36775e4af62ea92655ec41dd4fa1ed3d
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 12 distinct operations.
 * Computes in f32 with own maths.
 */
#include "lunar_lander_continuous.h"

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

/* An output in its range. What is neither in it nor below is NaN. */
static float lunar_lander_continuous_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

void lunar_lander_continuous_infer(const lunar_lander_continuous_state_t *state, lunar_lander_continuous_action_t *action)
{
    const float v2 = state->obs[1] * (-8.037243F);
    const float v5 = state->obs[3] * (-11.026979F);
    const float v6 = v2 + v5;
    const float v8 = v6 + (-1.8125842F);
    const float v11 = state->obs[0] * (-18.706825F);
    const float v14 = state->obs[5] * 2.1564276F;
    const float v15 = v11 + v14;
    const float v18 = state->obs[4] * 14.484438F;
    const float v19 = v15 + v18;
    const float v22 = state->obs[2] * (-6.0377746F);
    const float v23 = v19 + v22;
    const float v25 = v23 + 0.24678662F;

    action->action_0 = lunar_lander_continuous_clamp(v8, -1.0F, 1.0F, 0.0F);
    action->action_1 = lunar_lander_continuous_clamp(v25, -1.0F, 1.0F, 0.0F);
}
#ifndef LUNAR_LANDER_CONTINUOUS_NO_SELFTEST

uint32_t lunar_lander_continuous_selftest(void)
{
    static const lunar_lander_continuous_state_t states[16] = {
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
    static const lunar_lander_continuous_action_t actions[16] = {
        { 1.0F, -1.0F },
        { -1.0F, -1.0F },
        { 1.0F, -1.0F },
        { 1.0F, -1.0F },
        { -1.0F, -1.0F },
        { 1.0F, -1.0F },
        { -1.0F, 1.0F },
        { -1.0F, -1.0F },
        { 1.0F, 1.0F },
        { -1.0F, -1.0F },
        { 1.0F, -1.0F },
        { 1.0F, -1.0F },
        { 1.0F, -1.0F },
        { 1.0F, -1.0F },
        { -1.0F, -1.0F },
        { -1.0F, 1.0F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        lunar_lander_continuous_action_t action;

        lunar_lander_continuous_infer(&states[vector], &action);
        if ((action.action_0 < actions[vector].action_0) || (action.action_0 > actions[vector].action_0) ||
            (action.action_1 < actions[vector].action_1) || (action.action_1 > actions[vector].action_1)) {
            failures++;
        }
    }
    return failures;
}
#endif
