/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: fb10bab75b353452c0f7ee6bdd8a9c4e3c9c4e8b9c699923ea61c53a75923706
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 67 distinct operations.
 * Computes in f32 with own maths.
 */
#include "hopper.h"

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
static float hopper_clamp(float value, float low, float high, float nan)
{
    const float raised = (value < low) ? low : value;
    const float limited = (raised > high) ? high : raised;
    return (isnan(value) != 0) ? nan : limited;
}

void hopper_infer(const hopper_state_t *state, hopper_action_t *action)
{
    const float v3 = state->obs[0] * 17.223093F;
    const float v4 = 0.0F + v3;
    const float v7 = state->obs[1] * (-57.310635F);
    const float v8 = v4 + v7;
    const float v11 = state->obs[2] * (-2.666162F);
    const float v12 = v8 + v11;
    const float v15 = state->obs[3] * 38.50292F;
    const float v16 = v12 + v15;
    const float v19 = state->obs[4] * (-3.6437075F);
    const float v20 = v16 + v19;
    const float v23 = state->obs[5] * (-4.3315954F);
    const float v24 = v20 + v23;
    const float v27 = state->obs[6] * 10.520559F;
    const float v28 = v24 + v27;
    const float v31 = state->obs[8] * (-4.0487485F);
    const float v32 = v28 + v31;
    const float v35 = state->obs[9] * 2.2844436F;
    const float v36 = v32 + v35;
    const float v39 = state->obs[10] * (-0.93529904F);
    const float v40 = v36 + v39;
    const float v42 = v40 + (-0.40775383F);
    const float v44 = state->obs[0] * 1.3736471F;
    const float v45 = 0.0F + v44;
    const float v47 = state->obs[1] * (-18.891891F);
    const float v48 = v45 + v47;
    const float v50 = state->obs[2] * (-7.4346485F);
    const float v51 = v48 + v50;
    const float v53 = state->obs[3] * (-15.671401F);
    const float v54 = v51 + v53;
    const float v56 = state->obs[4] * (-1.4999967F);
    const float v57 = v54 + v56;
    const float v59 = state->obs[5] * (-1.8972312F);
    const float v60 = v57 + v59;
    const float v62 = state->obs[6] * (-3.5186489F);
    const float v63 = v60 + v62;
    const float v66 = state->obs[7] * (-5.763084F);
    const float v67 = v63 + v66;
    const float v69 = state->obs[8] * 1.0130048F;
    const float v70 = v67 + v69;
    const float v72 = state->obs[9] * (-2.2987392F);
    const float v73 = v70 + v72;
    const float v75 = state->obs[10] * 1.3076066F;
    const float v76 = v73 + v75;
    const float v78 = v76 + (-1.099076F);
    const float v80 = state->obs[0] * 10.411505F;
    const float v81 = 0.0F + v80;
    const float v83 = state->obs[1] * (-5.8839245F);
    const float v84 = v81 + v83;
    const float v86 = state->obs[2] * 50.929966F;
    const float v87 = v84 + v86;
    const float v89 = state->obs[3] * (-2.9071462F);
    const float v90 = v87 + v89;
    const float v92 = state->obs[4] * (-5.4191236F);
    const float v93 = v90 + v92;
    const float v95 = state->obs[5] * (-3.7370574F);
    const float v96 = v93 + v95;
    const float v98 = state->obs[6] * (-6.636422F);
    const float v99 = v96 + v98;
    const float v101 = state->obs[7] * (-0.2007767F);
    const float v102 = v99 + v101;
    const float v104 = state->obs[8] * (-0.35769776F);
    const float v105 = v102 + v104;
    const float v107 = state->obs[9] * 3.292033F;
    const float v108 = v105 + v107;
    const float v110 = state->obs[10] * (-2.2646153F);
    const float v111 = v108 + v110;
    const float v113 = v111 + (-2.010129F);

    action->action_0 = hopper_clamp(v42, -1.0F, 1.0F, 0.0F);
    action->action_1 = hopper_clamp(v78, -1.0F, 1.0F, 0.0F);
    action->action_2 = hopper_clamp(v113, -1.0F, 1.0F, 0.0F);
}
#ifndef HOPPER_NO_SELFTEST

uint32_t hopper_selftest(void)
{
    static const hopper_state_t states[16] = {
        { { 1.2749393F, -0.19162531F, -0.15911323F, -0.74819285F, -0.58423537F, 2.5303397F, -0.2890705F, -4.189943F, 5.583267F, 3.0214138F, -0.5022853F } },
        { { 1.3992729F, -0.18335128F, -0.42302904F, -0.44808277F, -0.59323436F, 3.8353937F, 3.148842F, 4.5498886F, -5.1927505F, -3.7337322F, -0.5909326F } },
        { { 1.2712737F, -0.2205501F, -0.59360653F, -0.7920235F, 0.044403665F, 0.4710965F, -3.1282177F, -4.764169F, 7.272404F, 2.8049757F, -11.752636F } },
        { { 1.4010254F, 0.090466775F, -0.07335526F, -0.74294233F, 1.1559635F, -0.1799908F, 1.0169796F, 2.974244F, 1.3190638F, 6.6132813F, -3.6207805F } },
        { { 1.327848F, 0.1735035F, -0.36382148F, -0.22715648F, -0.5893359F, 0.27887473F, 0.55484986F, 4.4323473F, -2.1167798F, 6.7568774F, 14.885904F } },
        { { 1.6214169F, 0.091192365F, -0.22364175F, -0.1962565F, 0.15640672F, 2.0822787F, -0.205787F, 1.2634538F, 1.6857672F, -8.917962F, -7.783102F } },
        { { 1.2877666F, -0.06779255F, -0.34466675F, -0.7030676F, 0.21067525F, 0.50439423F, 2.9793615F, 1.326546F, -3.9835422F, 1.422098F, -4.113694F } },
        { { 1.1688409F, 0.20009534F, -0.20477326F, 0.17613451F, -0.65853775F, 0.47403818F, -2.7529974F, -1.5001208F, 5.6637073F, 6.246655F, -12.988243F } },
        { { 1.6027914F, 0.18914026F, 0.10335722F, -0.8685956F, -1.222254F, -0.64674294F, 0.64906013F, 2.038319F, 4.219818F, 7.7938113F, 7.478348F } },
        { { 1.0605303F, 0.061301872F, -0.2942115F, -0.4713862F, 0.36874446F, 2.9665678F, -3.530114F, 3.0295336F, 0.26539972F, -9.723317F, -5.563344F } },
        { { 1.5396787F, 0.20042081F, 0.04124197F, -0.23978306F, 0.06896592F, 1.5747837F, -0.7395223F, 3.595259F, 4.744491F, -2.1233068F, -13.33576F } },
        { { 1.3818849F, -0.06438799F, 0.15271558F, -0.5597877F, -0.9705519F, -0.596216F, -1.3447878F, -2.9401438F, -2.8249846F, 5.5170617F, 7.8943367F } },
        { { 1.1540945F, 0.14037588F, 0.050403148F, -0.39801762F, 1.0670427F, 2.7763937F, 0.9020459F, 4.0050364F, 4.2360773F, 8.456F, 2.633524F } },
        { { 1.4306924F, 0.15717927F, -0.20718576F, -0.24403638F, 0.8860677F, 1.9347864F, -1.7012323F, 0.33882442F, 4.0716977F, 3.5758147F, 8.192992F } },
        { { 1.2326488F, 0.050768055F, -0.5292823F, -0.18188003F, 0.13622595F, 2.9791713F, -1.6716987F, -5.4536242F, -4.3898764F, 3.6528065F, -12.4503765F } },
        { { 1.2839403F, 0.13415517F, -0.2646364F, -0.9423173F, -0.27085796F, 1.1681386F, -2.4942894F, -5.1371655F, -0.5659518F, -0.060557555F, 4.6635385F } },
    };
    static const hopper_action_t actions[16] = {
        { -1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F },
        { -1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F },
        { -1.0F, 1.0F, -1.0F },
        { 1.0F, -1.0F, -1.0F },
        { -1.0F, -1.0F, 1.0F },
        { -1.0F, -1.0F, 1.0F },
        { -1.0F, 1.0F, -1.0F },
        { -1.0F, -1.0F, 1.0F },
        { 1.0F, 1.0F, 1.0F },
        { -1.0F, -1.0F, 1.0F },
        { -1.0F, 1.0F, -1.0F },
        { 1.0F, 1.0F, 1.0F },
        { -1.0F, 1.0F, 1.0F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        hopper_action_t action;

        hopper_infer(&states[vector], &action);
        if ((action.action_0 < actions[vector].action_0) || (action.action_0 > actions[vector].action_0) ||
            (action.action_1 < actions[vector].action_1) || (action.action_1 > actions[vector].action_1) ||
            (action.action_2 < actions[vector].action_2) || (action.action_2 > actions[vector].action_2)) {
            failures++;
        }
    }
    return failures;
}
#endif
