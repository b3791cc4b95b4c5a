/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: f1fcd16d87e2426656b1d181341ac3b7f4221d042e81bf124407e8cab858f394
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 26 distinct operations.
 * Computes in f32 with own maths.
 */
#include "swimmer.h"

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

/* An output in its range. */
static float swimmer_clamp(float value, float low, float high, float nan)
{
    const float raised = (value < low) ? low : value;
    const float limited = (raised > high) ? high : raised;
    return (isnan(value) != 0) ? nan : limited;
}

void swimmer_infer(const swimmer_state_t *state, swimmer_action_t *action)
{
    const float v3 = state->obs[1] * 0.52979016F;
    const float v4 = 0.0F + v3;
    const float v7 = state->obs[2] * (-5.974702F);
    const float v8 = v4 + v7;
    const float v10 = v8 * state->obs[3];
    const float v11 = v8 + v10;
    const float v14 = state->obs[4] * 10.418471F;
    const float v15 = v11 + v14;
    const float v18 = state->obs[5] * 1.5990511F;
    const float v19 = v15 + v18;
    const float v22 = state->obs[6] * 4.344058F;
    const float v23 = v19 + v22;
    const float v26 = state->obs[7] * (-6.256689F);
    const float v27 = v23 + v26;
    const float v29 = v27 + 1.4570708F;
    const float v31 = state->obs[1] * 3.828739F;
    const float v32 = 0.0F + v31;
    const float v34 = state->obs[4] * 3.323152F;
    const float v35 = v32 + v34;
    const float v37 = state->obs[5] * (-3.6907132F);
    const float v38 = v35 + v37;
    const float v40 = state->obs[6] * 2.7172828F;
    const float v41 = v38 + v40;
    const float v43 = state->obs[7] * 1.6195582F;
    const float v44 = v41 + v43;
    const float v46 = v44 + (-0.8324088F);

    action->action_0 = swimmer_clamp(v29, -1.0F, 1.0F, 0.0F);
    action->action_1 = swimmer_clamp(v46, -1.0F, 1.0F, 0.0F);
}
#ifndef SWIMMER_NO_SELFTEST

uint32_t swimmer_selftest(void)
{
    static const swimmer_state_t states[16] = {
        { { -0.36975673F, -1.3418726F, 0.27714926F, -0.6257254F, -1.5323732F, 1.6257346F, -0.4764792F, -6.4562974F } },
        { { 0.7725577F, 0.7110614F, -0.08217751F, 0.6491395F, -2.8454046F, -1.8020054F, -0.5732258F, -4.085789F } },
        { { 1.0537281F, 1.385486F, 1.3888991F, -0.932364F, -1.104794F, -0.1415563F, -1.2850257F, -9.038243F } },
        { { -1.2249069F, -0.99849606F, 0.051869728F, -0.45186076F, -2.9241092F, -3.0563545F, 6.244255F, 3.621047F } },
        { { -1.081419F, 0.29488868F, 0.7027084F, 1.1031144F, -1.9619209F, 3.486785F, -4.69789F, 2.460235F } },
        { { 0.6010946F, 0.30037513F, 1.2382275F, -0.055831064F, -0.15580018F, 3.249305F, -2.0306323F, 2.3356636F } },
        { { -0.6618254F, -0.8617972F, 0.19882427F, 1.9287746F, -1.0960377F, 3.1352277F, 6.30995F, 7.233007F } },
        { { 0.42823803F, 0.0836279F, 0.4463911F, 0.6185146F, 0.82414895F, -0.20511001F, 1.8987591F, 1.9781872F } },
        { { -1.1856607F, -0.8167738F, -0.2811673F, -0.10366072F, -0.9693635F, -1.8740442F, 1.1519415F, -4.1776066F } },
        { { 0.80962944F, 0.5389118F, -0.92831147F, 0.8040501F, -0.96800554F, -1.8828082F, 6.1488805F, 0.7226571F } },
        { { 0.9313915F, -0.7690972F, -0.7624147F, -0.9166024F, -0.7236532F, 2.927992F, 4.835156F, -8.046735F } },
        { { 0.7445705F, 1.5359044F, 1.3263074F, -0.960339F, -3.281665F, -3.6128187F, 1.0852337F, 4.0635843F } },
        { { 0.545631F, 1.551625F, 0.7614761F, -1.0465796F, 1.1746186F, -0.55609584F, -0.80379695F, 2.790507F } },
        { { 0.6021961F, -1.488476F, 0.950606F, 0.40559044F, -3.3983479F, -1.4134326F, 3.4985523F, 8.995671F } },
        { { 0.71042067F, 0.41387275F, 0.081836015F, 0.39293367F, -0.68944913F, 2.7747016F, 4.0380993F, -1.298986F } },
        { { -1.2090527F, 0.20671251F, -0.42953077F, 2.1181428F, -0.94352627F, -2.79068F, -5.832147F, -3.3001034F } },
    };
    static const swimmer_action_t actions[16] = {
        { 1.0F, -1.0F },
        { -1.0F, -1.0F },
        { 1.0F, -1.0F },
        { -1.0F, 1.0F },
        { -1.0F, -1.0F },
        { -1.0F, -1.0F },
        { -1.0F, 1.0F },
        { 1.0F, 1.0F },
        { 1.0F, -1.0F },
        { 1.0F, 1.0F },
        { 1.0F, -1.0F },
        { -1.0F, 1.0F },
        { -1.0F, 1.0F },
        { -1.0F, 1.0F },
        { 1.0F, -1.0F },
        { -1.0F, -1.0F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        swimmer_action_t action;

        swimmer_infer(&states[vector], &action);
        if ((action.action_0 < actions[vector].action_0) || (action.action_0 > actions[vector].action_0) ||
            (action.action_1 < actions[vector].action_1) || (action.action_1 > actions[vector].action_1)) {
            failures++;
        }
    }
    return failures;
}
#endif
