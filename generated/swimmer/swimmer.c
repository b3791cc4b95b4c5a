/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 67b166ee4a50b89decc98f05d051db452a31b90cf0a8686482eef25ad207213a
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 28 distinct operations.
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

/* An output in its range. What is neither in it nor below is NaN. */
static float swimmer_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

void swimmer_infer(const swimmer_state_t *state, swimmer_action_t *action)
{
    const float v2 = state->obs[0] * 0.7118727F;
    const float v5 = state->obs[1] * (-0.11251226F);
    const float v6 = v2 + v5;
    const float v9 = state->obs[2] * (-0.69512516F);
    const float v10 = v6 + v9;
    const float v13 = state->obs[4] * 0.3123265F;
    const float v14 = v10 + v13;
    const float v17 = state->obs[5] * (-0.27881774F);
    const float v18 = v14 + v17;
    const float v21 = state->obs[6] * 0.183991F;
    const float v22 = v18 + v21;
    const float v25 = state->obs[7] * (-0.12982675F);
    const float v26 = v22 + v25;
    const float v28 = v26 + (-0.023436766F);
    const float v30 = state->obs[1] * 0.26692712F;
    const float v32 = state->obs[2] * (-0.65130556F);
    const float v33 = v30 + v32;
    const float v36 = state->obs[3] * (-0.31501192F);
    const float v37 = v33 + v36;
    const float v39 = state->obs[4] * 0.26088122F;
    const float v40 = v37 + v39;
    const float v42 = state->obs[5] * (-0.35128272F);
    const float v43 = v40 + v42;
    const float v45 = state->obs[6] * 0.2057382F;
    const float v46 = v43 + v45;
    const float v48 = state->obs[7] * 0.08384997F;
    const float v49 = v46 + v48;
    const float v51 = v49 + 0.08995213F;

    action->action_0 = swimmer_clamp(v28, -1.0F, 1.0F, 0.0F);
    action->action_1 = swimmer_clamp(v51, -1.0F, 1.0F, 0.0F);
}
#ifndef SWIMMER_NO_SELFTEST

uint32_t swimmer_selftest(void)
{
    static const swimmer_state_t states[16] = {
        { { -0.20323594F, -1.1910177F, 0.2598124F, -0.36338776F, -1.4888479F, 1.5853858F, -0.41966468F, -5.7735367F } },
        { { 0.8981445F, 0.6243391F, -0.058569092F, 0.5969186F, -2.7539806F, -1.7633986F, -0.49815387F, -3.723551F } },
        { { 1.1692394F, 1.2207154F, 1.2448785F, -0.5943667F, -1.0768665F, -0.14119682F, -1.0756276F, -8.006371F } },
        { { -1.0277425F, -0.88737875F, 0.060203478F, -0.23242228F, -2.8298142F, -2.988855F, 5.0327764F, 2.941224F } },
        { { -0.8893963F, 0.25632825F, 0.63687915F, 0.9388802F, -1.9027259F, 3.4035683F, -3.8444383F, 1.9373685F } },
        { { 0.73282564F, 0.26117977F, 1.1113759F, 0.065891534F, -0.16249146F, 3.1715584F, -1.6805282F, 1.8296406F } },
        { { -0.48483858F, -0.76649946F, 0.19041255F, 1.560818F, -1.0684297F, 3.060109F, 5.086074F, 6.0648017F } },
        { { 0.5661633F, 0.06951574F, 0.40976918F, 0.57385F, 0.7817097F, -0.20328663F, 1.5073341F, 1.5204996F } },
        { { -0.9899026F, -0.72668636F, -0.23488401F, 0.029863315F, -0.94637644F, -1.833778F, 0.9014512F, -3.8029535F } },
        { { 0.93388784F, 0.4721116F, -0.80828613F, 0.71360666F, -0.94506806F, -1.8423402F, 4.9554005F, 0.43473297F } },
        { { 1.0512866F, -0.6845272F, -0.6612933F, -0.58249414F, -0.70962954F, 2.8576467F, 3.8895934F, -7.1489267F } },
        { { 0.8711602F, 1.3537266F, 1.189419F, -0.61543924F, -3.1743267F, -3.5325012F, 0.84733194F, 3.3239248F } },
        { { 0.67934954F, 1.367628F, 0.68895024F, -0.6804009F, 1.1193943F, -0.54618776F, -0.68521315F, 2.2229836F } },
        { { 0.7338877F, -1.3206555F, 0.8565288F, 0.41346246F, -3.286753F, -1.3837763F, 2.805225F, 7.589132F } },
        { { 0.8382341F, 0.3615428F, 0.08675511F, 0.4039286F, -0.6766732F, 2.7078872F, 3.242952F, -1.3135585F } },
        { { -1.0124564F, 0.17835632F, -0.36634147F, 1.7034618F, -0.9214818F, -2.7292998F, -4.764646F, -3.0440998F } },
    };
    static const swimmer_action_t actions[16] = {
        { -0.44940814F, -1.0F },
        { 0.60968125F, -0.4070042F },
        { 0.3507906F, -1.0F },
        { -0.20341079F, 1.0F },
        { -1.0F, -1.0F },
        { -1.0F, -1.0F },
        { -1.0F, -0.5291038F },
        { 0.46770015F, 0.37380776F },
        { 0.39220896F, 0.30342188F },
        { 1.0F, 1.0F },
        { 1.0F, -0.46674034F },
        { -0.66452277F, 0.7363179F },
        { -0.085380435F, 0.7499442F },
        { -1.0F, -0.1085392F },
        { 0.27315468F, -0.5679967F },
        { -0.51786333F, -0.6776091F },
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
