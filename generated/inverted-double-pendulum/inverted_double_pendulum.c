/*
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix inverted_double_pendulum --profile fast
 * Graph SHA-256: c2a4564156a88eb4a1801ee60afdb589122425609075ccfdd0cb96b607b2ae6f
 * 1 teams (1 on the longest walk), 1 edges, 1 programs, 14 distinct operations.
 * Computes in f32 with own maths.
 */
#include "inverted_double_pendulum.h"

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
static float inverted_double_pendulum_clamp(float value, float low, float high, float nan)
{
    return (value >= low) ? ((value > high) ? high : value) : ((value < low) ? low : nan);
}

void inverted_double_pendulum_infer(const inverted_double_pendulum_state_t *state, inverted_double_pendulum_action_t *action)
{
    const float v2 = state->obs[0] * (-0.48305112F);
    const float v5 = state->obs[1] * (-2.4732687F);
    const float v6 = v2 + v5;
    const float v9 = state->obs[2] * (-6.5629725F);
    const float v10 = v6 + v9;
    const float v13 = state->obs[4] * (-0.45679966F);
    const float v14 = v10 + v13;
    const float v17 = state->obs[5] * (-0.2828851F);
    const float v18 = v14 + v17;
    const float v21 = state->obs[6] * (-0.9611906F);
    const float v22 = v18 + v21;
    const float v25 = state->obs[7] * (-0.9364736F);
    const float v26 = v22 + v25;
    const float v28 = v26 + 0.44827595F;

    action->action = inverted_double_pendulum_clamp(v28, -1.0F, 1.0F, 0.0F);
}
#ifndef INVERTED_DOUBLE_PENDULUM_NO_SELFTEST

uint32_t inverted_double_pendulum_selftest(void)
{
    static const inverted_double_pendulum_state_t states[16] = {
        { { 0.0211067F, -0.12018729F, 0.014646072F, 0.99559784F, 0.9959746F, 0.08444619F, -0.07498883F, -0.20602275F, 0.00018739054F } },
        { { 0.16145936F, -0.014980235F, 0.009544096F, 0.99473846F, 0.99582976F, -0.062123664F, -0.19881363F, 0.37727702F, 0.00020617747F } },
        { { 0.27244136F, -0.10638329F, -0.052025657F, 0.99746895F, 0.9968069F, -0.31277797F, -0.3571786F, -0.18342711F, 1.2762486e-5F } },
        { { -0.040894106F, -0.1180896F, -0.11615404F, 1.0011306F, 0.9989869F, -0.25888783F, 0.0061992044F, 0.1961848F, 0.00010232527F } },
        { { -0.061527446F, 0.10772489F, -0.10883074F, 0.9985603F, 0.9997844F, 0.010768366F, 0.22524205F, -0.048328586F, -1.158141e-5F } },
        { { 0.26093745F, -0.052771006F, 0.022360142F, 0.99604523F, 0.99555814F, 0.0053633125F, 0.25045425F, -0.072258525F, 0.00020366139F } },
        { { 0.2950903F, 0.09107637F, 0.050466146F, 0.99771935F, 0.9986568F, 0.0035104759F, 0.029930117F, 0.01617603F, 7.418763e-5F } },
        { { 0.11529132F, -0.12416644F, -0.07921386F, 0.9970403F, 0.99657655F, -0.1138624F, -0.21640839F, 0.09790449F, -0.000112356356F } },
        { { 0.2461331F, 0.02963668F, -0.085570365F, 0.9984755F, 0.99655455F, -0.17616017F, 0.28267628F, 0.06278382F, 0.00022022586F } },
        { { -0.04690513F, -0.07099319F, -0.10634243F, 0.99687284F, 1.0003442F, 0.18094292F, -0.34475988F, 0.2883448F, 0.00022911979F } },
        { { 0.26333344F, -0.1084341F, -0.13255505F, 0.9942257F, 0.9981757F, 0.08912088F, 0.14400838F, 0.357798F, 0.00012463913F } },
        { { -0.11793829F, 0.032090746F, -0.03024875F, 0.9971461F, 0.99865955F, 0.13787243F, -0.36625484F, 0.2505693F, 4.4195885e-6F } },
        { { -0.15453553F, -0.05903535F, 0.061565492F, 1.0010821F, 1.0001155F, 0.030502133F, -0.024403183F, 0.039320737F, -4.901948e-5F } },
        { { 0.23239565F, 0.07219008F, -0.029213062F, 0.9944231F, 0.9979453F, -0.10756799F, 0.28685012F, -0.05737035F, -0.00018246175F } },
        { { -0.146728F, -0.056957297F, -0.072438434F, 0.9961488F, 1.0000541F, 0.114389546F, -0.2313781F, 0.27624127F, 0.00018031856F } },
        { { 0.06265484F, 0.09879191F, 0.058655325F, 0.9984521F, 1.0004706F, 0.12518005F, 0.2930258F, 0.096718445F, 6.0681177e-5F } },
    };
    static const inverted_double_pendulum_action_t actions[16] = {
        { 0.42537805F },
        { -0.25483772F },
        { 1.0F },
        { 0.9496311F },
        { 0.29482794F },
        { -0.32335618F },
        { -0.7518281F },
        { 0.9128586F },
        { 0.08178374F },
        { 0.89765096F },
        { 0.50454915F },
        { 0.24659862F },
        { -0.21396568F },
        { -0.29822752F },
        { 0.6099576F },
        { -1.0F },
    };
    uint32_t failures = 0U;
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        inverted_double_pendulum_action_t action;

        inverted_double_pendulum_infer(&states[vector], &action);
        if ((action.action < actions[vector].action) || (action.action > actions[vector].action)) {
            failures++;
        }
    }
    return failures;
}
#endif
