/*
 * A policy for LunarLander-v3 of Gymnasium, score 264.01 in validation, trained by tpg-train 0.1.0 with seed 10.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix lunar_lander --profile fast
 * Graph SHA-256: ad96108fa65d5dffc581ce1af877a56cad69189aa93145c12a119d53a26e489d
 * 1 team, 4 edges, 4 programs, 23 distinct operations.
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
#if defined(__clang_major__) && (__clang_major__ >= 13) /* no macro tells of -fassociative-math */
#pragma clang fp reassociate(off)
#endif

/* The highest bid wins, of equal bids the last; NaN and minus infinity never win. */
lunar_lander_action_t lunar_lander_infer(const lunar_lander_state_t *state)
{
    float best = 0.0f;
    lunar_lander_action_t action = LUNAR_LANDER_NONE;
    const float left_engine = 0.54824466f * state->obs[0]
        + 0.41400775f * state->obs[1]
        - 1.3129216f * state->obs[4]
        - 1.5008805f * state->obs[5];
    if (left_engine >= best) {
        best = left_engine;
        action = LUNAR_LANDER_LEFT_ENGINE;
    }

    const float main_engine = -0.7259825f * state->obs[1] - 2.4281847f * state->obs[3] - 0.2920304f;
    if (main_engine >= best) {
        best = main_engine;
        action = LUNAR_LANDER_MAIN_ENGINE;
    }

    const float right_engine = -0.50036424f * state->obs[0]
        + 0.32095438f * state->obs[1]
        - 1.462079f * state->obs[2]
        + 1.0567017f * state->obs[3]
        + 1.1205845f * state->obs[4]
        - 0.700306f * state->obs[7]
        + 0.4441619f;
    if (right_engine >= best) {
        action = LUNAR_LANDER_RIGHT_ENGINE;
    }

    return action;
}

#ifndef LUNAR_LANDER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold: of some flags, such as clang's -fno-honor-nans and -ffp-contract=fast, no macro
 * tells, nor of a processor that flushes small numbers to 0. */
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
    static const lunar_lander_state_t states[16] = {
        { { -0.4875717f, -2.0980814f, 1.9312036f, -5.613508f, -2.7182243f, 4.2122045f, 0.46108818f, 0.1526527f } },
        { { 1.8739054f, 1.0331204f, -0.33485687f, 1.5441828f, -5.0333405f, -4.7216487f, 0.4534597f, 0.28022873f } },
        { { 2.4551618f, 2.0617747f, 8.942349f, -7.3351216f, -1.9643234f, -0.39395505f, 0.39733443f, 0.013697542f } },
        { { -2.2554016f, -1.5743524f, 0.5104994f, -4.6373506f, -5.172111f, -7.990908f, 0.99101675f, 0.6949953f } },
        { { -1.9587727f, 0.39836013f, 4.614952f, 4.093011f, -3.475596f, 9.062733f, 0.12823077f, 0.6325227f } },
        { { 1.5194442f, 0.40672827f, 7.992153f, -2.4138536f, -0.29107258f, 8.44378f, 0.3385435f, 0.6258185f } },
        { { -1.0913578f, -1.3658549f, 1.4372544f, 8.728656f, -1.9488846f, 8.146455f, 0.9961968f, 0.8893838f } },
        { { 1.1621023f, 0.07613831f, 2.9985113f, 1.37224f, 1.4367582f, -0.5595976f, 0.6483753f, 0.60657984f } },
        { { -2.174269f, -1.2971836f, -1.5897672f, -2.682392f, -1.7255344f, -4.909406f, 0.58948886f, 0.2752873f } },
        { { 1.9505429f, 0.77055216f, -5.670921f, 2.4139233f, -1.7231401f, -4.932248f, 0.98349655f, 0.53900975f } },
        { { 2.2022586f, -1.2244658f, -4.6247087f, -7.2466288f, -1.292302f, 7.606329f, 0.8799096f, 0.06705855f } },
        { { 1.8160483f, 2.2911978f, 8.547621f, -7.4921865f, -5.802548f, -9.441242f, 0.58422893f, 0.71881175f } },
        { { 1.4047858f, 2.3151753f, 4.985565f, -7.976382f, 2.0547006f, -1.4743857f, 0.43527922f, 0.6502973f } },
        { { 1.5217214f, -2.3216858f, 6.178295f, 0.17678353f, -6.008281f, -3.708896f, 0.77451867f, 0.98424685f } },
        { { 1.7454512f, 0.5798385f, 0.699479f, 0.10572243f, -1.2319939f, 7.206802f, 0.81706184f, 0.43020892f } },
        { { -2.2226267f, 0.26387098f, -2.5254076f, 9.791858f, -1.6799787f, -7.2984695f, 0.0387948f, 0.32251278f } },
    };
    static const lunar_lander_action_t actions[16] = {
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_NONE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_RIGHT_ENGINE,
        LUNAR_LANDER_NONE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_MAIN_ENGINE,
        LUNAR_LANDER_LEFT_ENGINE,
        LUNAR_LANDER_NONE,
        LUNAR_LANDER_RIGHT_ENGINE,
    };
    uint32_t failures = lunar_lander_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        if (lunar_lander_infer(&states[vector]) != actions[vector]) {
            failures++;
        }
    }
    return failures;
}
#endif
