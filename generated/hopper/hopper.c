/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: d294bc47b0222a94abc7c3659d8c794cb0ec1da057122320417bd26ad0a90e67
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 61 distinct operations.
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
    const float v3 = state->obs[0] * 0.91893643F;
    const float v4 = 0.0F + v3;
    const float v7 = state->obs[1] * (-6.9197044F);
    const float v8 = v4 + v7;
    const float v11 = state->obs[2] * (-1.281848F);
    const float v12 = v8 + v11;
    const float v15 = state->obs[3] * 1.7175211F;
    const float v16 = v12 + v15;
    const float v19 = state->obs[4] * (-0.54383606F);
    const float v20 = v16 + v19;
    const float v23 = state->obs[5] * (-0.33684945F);
    const float v24 = v20 + v23;
    const float v27 = state->obs[6] * 0.27482417F;
    const float v28 = v24 + v27;
    const float v31 = state->obs[7] * (-1.0601645F);
    const float v32 = v28 + v31;
    const float v35 = state->obs[8] * (-0.4680834F);
    const float v36 = v32 + v35;
    const float v39 = state->obs[9] * (-0.8199166F);
    const float v40 = v36 + v39;
    const float v42 = v40 + (-1.4247644F);
    const float v44 = state->obs[0] * 2.0718632F;
    const float v45 = 0.0F + v44;
    const float v47 = state->obs[1] * (-15.372457F);
    const float v48 = v45 + v47;
    const float v50 = state->obs[2] * (-2.2944324F);
    const float v51 = v48 + v50;
    const float v53 = state->obs[3] * 8.713481F;
    const float v54 = v51 + v53;
    const float v56 = state->obs[4] * 1.3414459F;
    const float v57 = v54 + v56;
    const float v59 = state->obs[5] * (-0.6442023F);
    const float v60 = v57 + v59;
    const float v62 = state->obs[6] * 0.116932996F;
    const float v63 = v60 + v62;
    const float v65 = state->obs[7] * 0.8644801F;
    const float v66 = v63 + v65;
    const float v68 = state->obs[8] * 0.35530937F;
    const float v69 = v66 + v68;
    const float v71 = state->obs[9] * (-0.674285F);
    const float v72 = v69 + v71;
    const float v75 = state->obs[10] * 0.07043329F;
    const float v76 = v72 + v75;
    const float v78 = v76 + (-1.887191F);
    const float v80 = state->obs[0] * 6.816188F;
    const float v81 = 0.0F + v80;
    const float v83 = state->obs[1] * 7.027345F;
    const float v84 = v81 + v83;
    const float v86 = state->obs[2] * 1.1816889F;
    const float v87 = v84 + v86;
    const float v89 = state->obs[3] * 9.409367F;
    const float v90 = v87 + v89;
    const float v92 = state->obs[5] * (-0.81106883F);
    const float v93 = v90 + v92;
    const float v95 = state->obs[6] * (-0.30011207F);
    const float v96 = v93 + v95;
    const float v98 = state->obs[8] * 0.12846981F;
    const float v99 = v96 + v98;
    const float v101 = state->obs[10] * (-0.043976225F);
    const float v102 = v99 + v101;
    const float v104 = v102 + (-6.7089043F);

    action->action_0 = hopper_clamp(v42, -1.0F, 1.0F, 0.0F);
    action->action_1 = hopper_clamp(v78, -1.0F, 1.0F, 0.0F);
    action->action_2 = hopper_clamp(v104, -1.0F, 1.0F, 0.0F);
}
#ifndef HOPPER_NO_SELFTEST

uint32_t hopper_selftest(void)
{
    static const hopper_state_t states[16] = {
        { { 1.2560515F, -0.1611841F, -0.2313386F, -0.0032347406F, -0.56855816F, 2.5162601F, -0.2943385F, -0.88315904F, 2.4370065F, 0.03432496F, -0.5022853F } },
        { { 1.429221F, -0.15666766F, -0.56274456F, -0.00014942366F, -0.578151F, 3.814056F, 3.3922026F, 1.5682654F, -2.4213083F, -0.020238306F, -0.5909326F } },
        { { 1.2509462F, -0.1769729F, -0.77694315F, -0.003685346F, 0.101565436F, 0.46847016F, -3.3388116F, -1.0442231F, 3.1985457F, 0.032576725F, -11.752636F } },
        { { 1.431662F, -0.007202168F, -0.1236501F, -0.0031807616F, 1.2864783F, -0.17899592F, 1.1061646F, 1.1263149F, 0.51451135F, 0.06333751F, -3.6207805F } },
        { { 1.3297418F, 0.038124014F, -0.48839608F, 0.0021218352F, -0.5739953F, 0.2773175F, 0.6106139F, 1.5352964F, -1.0345219F, 0.064497374F, 14.885904F } },
        { { 1.7386192F, -0.0068061007F, -0.31236875F, 0.002439506F, 0.22095968F, 2.0706913F, -0.20503196F, 0.64645743F, 0.67983776F, -0.06211283F, -7.783102F } },
        { { 1.2739172F, -0.09358913F, -0.46434298F, -0.002770825F, 0.27880946F, 0.50158274F, 3.2104652F, 0.66415405F, -1.8761426F, 0.021406824F, -4.113694F } },
        { { 1.1082796F, 0.052639354F, -0.2886751F, 0.0062679155F, -0.6477638F, 0.4713955F, -2.9364557F, -0.12869413F, 2.4732726F, 0.060376164F, -12.988243F } },
        { { 1.7126778F, 0.046659447F, 0.098252356F, -0.004472555F, -1.2486804F, -0.64315206F, 0.7116374F, 0.8637985F, 1.8223021F, 0.07287299F, 7.478348F } },
        { { 0.9574266F, -0.023122033F, -0.40098503F, -0.0003889972F, 0.44730982F, 2.950062F, -3.7697728F, 1.1418229F, 0.03947205F, -0.06861791F, -5.563344F } },
        { { 1.6247756F, 0.05281701F, 0.02025262F, 0.0019920259F, 0.12774858F, 1.5660189F, -0.77736676F, 1.3005025F, 2.0588484F, -0.007230435F, -13.33576F } },
        { { 1.4050034F, -0.09173072F, 0.16023293F, -0.0012978192F, -0.9803681F, -0.5929062F, -1.4264048F, -0.5326044F, -1.3538126F, 0.054483026F, 7.8943367F } },
        { { 1.0877411F, 0.020041065F, 0.031756554F, 0.000365277F, 1.1916895F, 2.7609458F, 0.982919F, 1.4154404F, 1.8296326F, 0.07822168F, 2.633524F } },
        { { 1.4729816F, 0.029213315F, -0.29170454F, 0.0019482994F, 0.9987717F, 1.9240195F, -1.8086274F, 0.3871093F, 1.755523F, 0.038803015F, 8.192992F } },
        { { 1.1971502F, -0.02887199F, -0.6961695F, 0.002587305F, 0.19944717F, 2.9625957F, -1.7769578F, -1.2376074F, -2.0593364F, 0.0394249F, -12.4503765F } },
        { { 1.2685881F, 0.016645448F, -0.3638468F, -0.00523046F, -0.23450063F, 1.1616355F, -2.659038F, -1.1488444F, -0.33533874F, 0.009430986F, 4.6635385F } },
    };
    static const hopper_action_t actions[16] = {
        { 0.28393698F, 1.0F, -1.0F },
        { 1.0F, 1.0F, -1.0F },
        { 0.39149582F, 1.0F, 1.0F },
        { -1.0F, 1.0F, 1.0F },
        { -0.64667934F, 1.0F, 0.86990356F },
        { -1.0F, 1.0F, 1.0F },
        { 1.0F, 1.0F, -0.6885495F },
        { -1.0F, -1.0F, 1.0F },
        { -1.0F, 1.0F, 1.0F },
        { -1.0F, 0.28287745F, -1.0F },
        { -1.0F, 0.63109946F, 1.0F },
        { 1.0F, 0.5328443F, 1.0F },
        { -1.0F, 1.0F, -1.0F },
        { -1.0F, 1.0F, 1.0F },
        { 1.0F, -1.0F, -1.0F },
        { 0.4558823F, -0.8895056F, 1.0F },
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
