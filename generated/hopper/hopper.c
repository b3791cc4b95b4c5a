/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: 45db48cea868239f6c7da6d4b7ab29f24a36ef767f572bf3ef94bc12a4be3468
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 60 distinct operations.
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

/* An output in its range. What is neither in it nor below is NaN. */
static float hopper_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

void hopper_infer(const hopper_state_t *state, hopper_action_t *action)
{
    const float v2 = state->obs[0] * 2.4094844F;
    const float v5 = state->obs[1] * (-16.831106F);
    const float v6 = v2 + v5;
    const float v9 = state->obs[2] * (-0.9726171F);
    const float v10 = v6 + v9;
    const float v13 = state->obs[3] * 1.2704073F;
    const float v14 = v10 + v13;
    const float v17 = state->obs[4] * (-0.30623376F);
    const float v18 = v14 + v17;
    const float v21 = state->obs[5] * 0.32980627F;
    const float v22 = v18 + v21;
    const float v25 = state->obs[6] * (-0.14272827F);
    const float v26 = v22 + v25;
    const float v29 = state->obs[7] * (-0.67063546F);
    const float v30 = v26 + v29;
    const float v33 = state->obs[8] * 0.084569946F;
    const float v34 = v30 + v33;
    const float v37 = state->obs[9] * 0.10996343F;
    const float v38 = v34 + v37;
    const float v41 = state->obs[10] * (-0.0139268385F);
    const float v42 = v38 + v41;
    const float v44 = v42 + (-4.385427F);
    const float v46 = state->obs[0] * (-0.48055917F);
    const float v48 = state->obs[1] * (-15.44946F);
    const float v49 = v46 + v48;
    const float v51 = state->obs[2] * 1.6838492F;
    const float v52 = v49 + v51;
    const float v54 = state->obs[3] * (-1.7118963F);
    const float v55 = v52 + v54;
    const float v57 = state->obs[4] * (-0.05598478F);
    const float v58 = v55 + v57;
    const float v60 = state->obs[6] * 0.3226204F;
    const float v61 = v58 + v60;
    const float v63 = state->obs[7] * (-0.8628424F);
    const float v64 = v61 + v63;
    const float v66 = state->obs[8] * (-0.12721324F);
    const float v67 = v64 + v66;
    const float v69 = state->obs[9] * (-0.0822124F);
    const float v70 = v67 + v69;
    const float v72 = v70 + (-1.109722F);
    const float v74 = state->obs[0] * 3.3940566F;
    const float v76 = state->obs[1] * 0.5165295F;
    const float v77 = v74 + v76;
    const float v79 = state->obs[2] * 2.143888F;
    const float v80 = v77 + v79;
    const float v82 = state->obs[3] * (-0.25035787F);
    const float v83 = v80 + v82;
    const float v85 = state->obs[5] * (-0.83269984F);
    const float v86 = v83 + v85;
    const float v88 = state->obs[6] * 0.02263618F;
    const float v89 = v86 + v88;
    const float v91 = state->obs[7] * 0.46339342F;
    const float v92 = v89 + v91;
    const float v94 = state->obs[8] * 0.13614666F;
    const float v95 = v92 + v94;
    const float v97 = state->obs[9] * (-0.039877187F);
    const float v98 = v95 + v97;
    const float v100 = state->obs[10] * (-0.0018393787F);
    const float v101 = v98 + v100;
    const float v103 = v101 + (-2.0928748F);

    action->action_0 = hopper_clamp(v44, -1.0F, 1.0F, 0.0F);
    action->action_1 = hopper_clamp(v72, -1.0F, 1.0F, 0.0F);
    action->action_2 = hopper_clamp(v103, -1.0F, 1.0F, 0.0F);
}
#ifndef HOPPER_NO_SELFTEST

uint32_t hopper_selftest(void)
{
    static const hopper_state_t states[16] = {
        { { 1.160104F, -0.13523732F, -0.23954001F, -0.861511F, -0.56095904F, 2.8757875F, -0.25413963F, -0.44330215F, 6.5772467F, 4.529355F, -0.5022853F } },
        { { 1.3029174F, -0.13171338F, -0.58455014F, -0.53114593F, -0.5704712F, 4.358932F, 2.917252F, 0.8846019F, -7.3532085F, -4.289092F, -0.5909326F } },
        { { 1.1558936F, -0.14755645F, -0.80754155F, -0.90976024F, 0.10353037F, 0.53553545F, -2.8731844F, -0.5305484F, 8.76084F, 4.2468076F, -11.752636F } },
        { { 1.3049304F, -0.015093548F, -0.1274309F, -0.85573107F, 1.2784809F, -0.20440064F, 0.9506601F, 0.6452031F, 1.0647932F, 9.2183275F, -3.6207805F } },
        { { 1.2208766F, 0.020272017F, -0.50714964F, -0.28794736F, -0.56635046F, 0.31708267F, 0.5243566F, 0.866743F, -3.3768165F, 9.405783F, 14.885904F } },
        { { 1.5580788F, -0.014784518F, -0.32389644F, -0.25393227F, 0.22192079F, 2.366583F, -0.1773126F, 0.38527074F, 1.5388409F, -11.0568F, -7.783102F } },
        { { 1.1748378F, -0.08249661F, -0.4821092F, -0.8118365F, 0.27928418F, 0.5733771F, 2.7609103F, 0.39485678F, -5.790032F, 2.441542F, -4.113694F } },
        { { 1.0382361F, 0.03159755F, -0.29923016F, 0.15600055F, -0.6394988F, 0.53887856F, -2.527053F, -0.034618545F, 6.681234F, 8.7397175F, -12.988243F } },
        { { 1.5366849F, 0.026931753F, 0.10358063F, -0.9940519F, -1.235363F, -0.7348468F, 0.6112633F, 0.5030015F, 4.814678F, 10.759439F, 7.478348F } },
        { { 0.91382724F, -0.027514957F, -0.4161504F, -0.55679864F, 0.44636786F, 3.3715441F, -3.2439241F, 0.6536037F, -0.2973073F, -12.108143F, -5.563344F } },
        { { 1.4641918F, 0.031736165F, 0.02237901F, -0.3018469F, 0.12949337F, 1.7898343F, -0.6696705F, 0.73955834F, 5.4929376F, -2.186776F, -13.33576F } },
        { { 1.282945F, -0.0810466F, 0.1681055F, -0.65411216F, -0.9693066F, -0.67742485F, -1.2280134F, -0.25341138F, -4.292332F, 7.7872763F, 7.8943367F } },
        { { 1.0212979F, 0.006162872F, 0.03435518F, -0.47603354F, 1.184489F, 3.1554184F, 0.8446366F, 0.8018186F, 4.835697F, 11.623888F, 2.633524F } },
        { { 1.3390068F, 0.013319481F, -0.30238396F, -0.306529F, 0.99319327F, 2.1989639F, -1.5568249F, 0.24478531F, 4.6231995F, 5.253093F, 8.192992F } },
        { { 1.111528F, -0.03200134F, -0.72345215F, -0.23810647F, 0.20058915F, 3.3858676F, -1.5295808F, -0.63530207F, -6.315311F, 5.353601F, -12.4503765F } },
        { { 1.1704429F, 0.0035134556F, -0.37748766F, -1.0752057F, -0.22971018F, 1.3276974F, -2.2884011F, -0.5872204F, -1.3720185F, 0.5060221F, 4.6635385F } },
    };
    static const hopper_action_t actions[16] = {
        { 1.0F, 0.61642337F, -0.4131987F },
        { 0.38199186F, 1.0F, -1.0F },
        { 1.0F, -1.0F, 0.5387583F },
        { -1.0F, -1.0F, 1.0F },
        { -1.0F, -1.0F, 0.33341646F },
        { -0.88781524F, -1.0F, 1.0F },
        { -1.0F, 1.0F, -0.08842802F },
        { 0.538012F, -1.0F, 0.8297403F },
        { -1.0F, -1.0F, 1.0F },
        { -1.0F, -1.0F, -1.0F },
        { -1.0F, -1.0F, 1.0F },
        { -0.122573376F, 0.7112788F, 1.0F },
        { -0.99637914F, -1.0F, -0.47736347F },
        { -0.14495182F, -1.0F, 0.53913355F },
        { 1.0F, -1.0F, -1.0F },
        { -1.0F, -0.60727006F, -0.30365634F },
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
