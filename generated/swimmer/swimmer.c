/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix swimmer --profile fast
 * Graph SHA-256: 35a11094e952120a0c89ca943b4ff1134c6ba90081ecb5709019d335cc6126a5
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
    const float v2 = state->obs[0] * 1.0105755F;
    const float v5 = state->obs[1] * (-0.16823284F);
    const float v6 = v2 + v5;
    const float v9 = state->obs[2] * (-0.66660637F);
    const float v10 = v6 + v9;
    const float v13 = state->obs[3] * (-0.016324192F);
    const float v14 = v10 + v13;
    const float v17 = state->obs[4] * 0.29036057F;
    const float v18 = v14 + v17;
    const float v21 = state->obs[5] * (-0.20999737F);
    const float v22 = v18 + v21;
    const float v25 = state->obs[6] * 0.25208098F;
    const float v26 = v22 + v25;
    const float v29 = state->obs[7] * (-0.055112995F);
    const float v30 = v26 + v29;
    const float v32 = v30 + 0.0054187076F;
    const float v34 = state->obs[1] * 0.5448633F;
    const float v36 = state->obs[2] * (-0.86861455F);
    const float v37 = v34 + v36;
    const float v39 = state->obs[3] * (-0.15368144F);
    const float v40 = v37 + v39;
    const float v42 = state->obs[4] * 0.3506624F;
    const float v43 = v40 + v42;
    const float v45 = state->obs[5] * (-0.31806582F);
    const float v46 = v43 + v45;
    const float v48 = state->obs[7] * 0.007038943F;
    const float v49 = v46 + v48;
    const float v51 = v49 + 0.056389466F;

    action->action_0 = swimmer_clamp(v32, -1.0F, 1.0F, 0.0F);
    action->action_1 = swimmer_clamp(v51, -1.0F, 1.0F, 0.0F);
}
#ifndef SWIMMER_NO_SELFTEST

uint32_t swimmer_selftest(void)
{
    static const swimmer_state_t states[16] = {
        { { -0.18946126F, -1.2959744F, 0.31253108F, -0.3656646F, -1.5069641F, 1.5969504F, -0.4453211F, -5.7376924F } },
        { { 0.9129435F, 0.5764053F, -0.020676892F, 0.59662116F, -2.7835355F, -1.7686481F, -0.52578074F, -3.6900826F } },
        { { 1.1842905F, 1.1915146F, 1.3434699F, -0.5971197F, -1.0912578F, -0.13830131F, -1.1177517F, -7.967938F } },
        { { -1.0147346F, -0.9827976F, 0.1036267F, -0.23442917F, -2.8600547F, -3.0002575F, 5.1440015F, 2.9669673F } },
        { { -0.8762598F, 0.19683468F, 0.7071571F, 0.9392876F, -1.9245842F, 3.4242618F, -3.9560723F, 1.9642754F } },
        { { 0.7474709F, 0.20183861F, 1.2037503F, 0.064499535F, -0.16861548F, 3.1910872F, -1.7378381F, 1.8566723F } },
        { { -0.47132578F, -0.8581214F, 0.23989938F, 1.5625074F, -1.0827447F, 3.079078F, 5.198637F, 6.0869246F } },
        { { 0.5806535F, 0.0041541653F, 0.46947104F, 0.573505F, 0.7841226F, -0.20070286F, 1.5300543F, 1.5478896F } },
        { { -0.97685957F, -0.8170577F, -0.20520248F, 0.028397048F, -0.95958793F, -1.839381F, 0.9089609F, -3.7693932F } },
        { { 0.94872004F, 0.4193961F, -0.8053069F, 0.71354973F, -0.9582677F, -1.8479861F, 5.064683F, 0.4633815F } },
        { { 1.066228F, -0.7735743F, -0.6514689F, -0.5852226F, -0.7207005F, 2.8755994F, 3.9721193F, -7.111488F } },
        { { 0.8859341F, 1.3287038F, 1.2854278F, -0.61823565F, -3.2076821F, -3.5466332F, 0.85348296F, 3.3492243F } },
        { { 0.69394505F, 1.3430418F, 0.76165307F, -0.6833312F, 1.1248604F, -0.5453257F, -0.7175361F, 2.2495594F } },
        { { 0.7485339F, -1.4296842F, 0.9370355F, 0.4127869F, -3.3211248F, -1.3871198F, 2.8605282F, 7.6094875F } },
        { { 0.8529774F, 0.30535415F, 0.1314148F, 0.40323338F, -0.6874462F, 2.725088F, 3.3092442F, -1.2828835F } },
        { { -0.9994343F, 0.116413556F, -0.3427817F, 1.7054452F, -0.93446815F, -2.739399F, -4.899381F, -3.011419F } },
    };
    static const swimmer_action_t actions[16] = {
        { -0.73934066F, -1.0F },
        { 0.46910545F, -0.14278679F },
        { -0.0144785745F, -0.76434934F },
        { 0.012825747F, -0.5608351F },
        { -1.0F, -1.0F },
        { -1.0F, -1.0F },
        { -0.49792832F, -1.0F },
        { 0.8394138F, -0.08757901F },
        { -0.16347703F, 0.0071026683F },
        { 1.0F, 1.0F },
        { 1.0F, -0.92669934F },
        { -0.32563138F, -0.21435432F },
        { 0.12046579F, 0.8153262F },
        { -0.00031275582F, -1.0F },
        { 0.85489434F, -1.0F },
        { -1.0F, 0.67789793F },
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
