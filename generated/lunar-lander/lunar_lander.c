/*
 * A policy for LunarLander-v3 of Gymnasium, score 264.01 in validation, trained by tpg-train 0.1.0 with seed 10.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix lunar_lander --profile fast
 * Graph SHA-256: ce37c65d5105962339cb88f7c7c4ecd4f1ff21c9a9214bb268d2dbf6d10ddc5c
 * 1 team, 4 edges, 4 programs, 23 distinct operations.
 * A decision takes at most 4 bids and 23 operations.
 * Computes in f32 with own maths.
 */
#include "lunar_lander.h"

#include <float.h>

#if defined(__FAST_MATH__) || defined(__ASSOCIATIVE_MATH__) || defined(__RECIPROCAL_MATH__) || defined(__NO_SIGNED_ZEROS__)
#error "fast-math, or a part of it, reorders operations: the policy would act differently"
#endif
#if defined(__FINITE_MATH_ONLY__) && (__FINITE_MATH_ONLY__ > 0)
#error "-ffinite-math-only drops NaN and infinities: the policy would act differently"
#endif
/* 16 only widens types narrower than float. */
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
#if defined(__clang_major__) && (__clang_major__ >= 13) /* no macro reveals -fassociative-math */
#pragma clang fp reassociate(off)
#endif

/* The highest bid wins; of equal bids, the last. NaN and minus infinity never win. */
lunar_lander_action_t lunar_lander_infer(const lunar_lander_state_t *state)
{
    float best = 0.0f;
    lunar_lander_action_t action = LUNAR_LANDER_NONE;
    const float left_engine = 0.54824466f * state->x
        + 0.41400775f * state->y
        - 1.3129216f * state->angle
        - 1.5008805f * state->spin;
    if (left_engine >= best) {
        best = left_engine;
        action = LUNAR_LANDER_LEFT_ENGINE;
    }

    const float main_engine = -0.7259825f * state->y - 2.4281847f * state->vy - 0.2920304f;
    if (main_engine >= best) {
        best = main_engine;
        action = LUNAR_LANDER_MAIN_ENGINE;
    }

    const float right_engine = -0.50036424f * state->x
        + 0.32095438f * state->y
        - 1.462079f * state->vx
        + 1.0567017f * state->vy
        + 1.1205845f * state->angle
        - 0.700306f * state->right_leg
        + 0.4441619f;
    if (right_engine >= best) {
        action = LUNAR_LANDER_RIGHT_ENGINE;
    }

    return action;
}

#ifndef LUNAR_LANDER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t lunar_lander_arithmetic(void)
{
    const volatile float numbers[6] = { 0.0f, FLT_MAX, 1.0002441f, 16777216.0f, 41.0f, FLT_MIN };
    const float zero = numbers[0];
    const float most = numbers[1];
    const float near_one = numbers[2];
    const float large = numbers[3];
    const float dividend = numbers[4];
    const float smallest = numbers[5];
    const float infinite = most + most;
    const float nan = infinite * zero;
    const float fused = (near_one * near_one) - 1.0004883f;
    const float reordered = (large + 1.0f) - large;
    const float quotient = dividend / 41.0f;
    uint32_t wrong = 0U;

    wrong += ((nan >= zero) || (nan <= zero)) ? 1U : 0U;
    wrong += (infinite > FLT_MAX) ? 0U : 1U;
    wrong += (fused > zero) ? 1U : 0U;
    wrong += (reordered > zero) ? 1U : 0U;
    wrong += (quotient < 1.0f) ? 1U : 0U;
    wrong += ((smallest * 0.5f) > zero) ? 0U : 1U;
    return wrong;
}

uint32_t lunar_lander_selftest(void)
{
    static const lunar_lander_state_t states[24] = {
        { -0.4875717f, -2.0980814f, 1.9312036f, -5.613508f, -2.7182243f, 4.2122045f, 0.46108818f, 0.1526527f },
        { 1.8739054f, 1.0331204f, -0.33485687f, 1.5441828f, -5.0333405f, -4.7216487f, 0.4534597f, 0.28022873f },
        { 2.4551618f, 2.0617747f, 8.942349f, -7.3351216f, -1.9643234f, -0.39395505f, 0.39733443f, 0.013697542f },
        { -2.2554016f, -1.5743524f, 0.5104994f, -4.6373506f, -5.172111f, -7.990908f, 0.99101675f, 0.6949953f },
        { 1.0387384f, 0.44238466f, 0.5971899f, 3.1457105f, -0.05468493f, -0.95873404f, 0.6932144f, 0.2751418f },
        { 1.3139943f, 0.529343f, -7.286868f, -2.8032537f, -0.89447296f, 5.508158f, 0.37217993f, 0.7361491f },
        { 1.3139942f, 0.529343f, -7.286868f, -2.8032537f, -0.89447296f, 5.5081577f, 0.37217993f, 0.7361491f },
        { 1.7030365f, 0.15041351f, 5.7411337f, 7.281145f, -3.4290752f, 3.6632233f, 0.8786149f, 0.021453071f },
        { 1.7030365f, 0.15041351f, 5.7411337f, 7.281145f, -3.4290752f, 3.6632235f, 0.8786149f, 0.021453071f },
        { -1.2441941f, -0.8892949f, 4.835105f, 9.131565f, -2.9295275f, 5.422245f, 0.10783216f, 0.112151444f },
        { -1.244194f, -0.88929486f, 4.835105f, 9.131565f, -2.9295278f, 5.422245f, 0.10783216f, 0.112151444f },
        { 0.735566f, 0.35102636f, 4.468897f, -4.3545413f, -1.019023f, -5.423661f, 0.2784862f, 0.15045321f },
        { 0.735566f, 0.35102636f, 4.468897f, -4.354542f, -1.019023f, -5.423661f, 0.2784862f, 0.15045321f },
        { -1.6730781f, -1.2306519f, -3.984929f, -2.7925172f, 3.6611462f, -5.9295816f, 0.8001919f, 0.68859327f },
        { -1.6730781f, -1.2306519f, -3.9849288f, -2.7925172f, 3.661146f, -5.9295816f, 0.8001918f, 0.68859327f },
        { 0.57866883f, 0.48281384f, 5.3734503f, -3.030992f, -5.9273224f, 1.0540391f, 0.03317997f, 0.5852896f },
        { 0.57866883f, 0.48281384f, 5.3734503f, -3.030992f, -5.9273224f, 1.054039f, 0.03317997f, 0.5852896f },
        { -0.55297124f, -0.727368f, 2.9343948f, -3.398015f, -0.9786598f, -5.201234f, 0.29316938f, 0.36473095f },
        { -0.55297124f, -0.727368f, 2.9343948f, -3.398015f, -0.97865975f, -5.201234f, 0.29316938f, 0.36473095f },
        { -0.1553697f, -1.4987044f, -7.884555f, -2.8796697f, -0.49439234f, 1.3863206f, 0.5552788f, 0.2618819f },
        { -0.1553697f, -1.4987044f, -7.8845553f, -2.8796697f, -0.49439237f, 1.3863207f, 0.5552788f, 0.2618819f },
        { -1.149235f, -1.6482649f, -0.629048f, 1.236501f, -2.147839f, 1.9121361f, 0.34859198f, 0.44220048f },
        { -1.149235f, -1.6482649f, -0.62904793f, 1.236501f, -2.147839f, 1.9121361f, 0.34859198f, 0.44220048f },
        { -1.2906109f, -1.3961735f, 8.816626f, 2.5278673f, -2.3221276f, 1.17476f, 0.10013154f, 0.61022997f },
    };
    static const lunar_lander_action_t actions[24] = {
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_NONE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_NONE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_NONE,
        LUNAR_LANDER_LEFT_ENGINE,
    };
    uint32_t failures = lunar_lander_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 24U; vector++) {
        if (lunar_lander_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
