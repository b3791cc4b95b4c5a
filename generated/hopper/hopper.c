/*
 * A policy for Hopper-v5 of Gymnasium, score 2393.91 in validation, trained by tpg-train 0.1.0 with seed 3.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix hopper --profile fast
 * Graph SHA-256: 1af2a66e78e8b96cad2d84d003874cb9e2f7b95eb2aade9c8018959b080a4043
 * 1 team, 1 edge, 1 program, 60 distinct operations.
 * Computes in f32 with own maths.
 */
#include "hopper.h"

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

/* An output in its range. NaN fails both comparisons, and becomes 0.0f. */
static float hopper_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void hopper_infer(const hopper_state_t *state, hopper_action_t *action)
{
    const float term = 2.4094844f * state->obs[0]
        - 16.831106f * state->obs[1]
        - 0.9726171f * state->obs[2]
        + 1.2704073f * state->obs[3]
        - 0.30623376f * state->obs[4]
        + 0.32980627f * state->obs[5]
        - 0.14272827f * state->obs[6];
    const float thigh = term
        - 0.67063546f * state->obs[7]
        + 0.084569946f * state->obs[8]
        + 0.10996343f * state->obs[9]
        - 0.0139268385f * state->obs[10]
        - 4.385427f;
    const float term_2 = -0.48055917f * state->obs[0]
        - 15.44946f * state->obs[1]
        + 1.6838492f * state->obs[2]
        - 1.7118963f * state->obs[3]
        - 0.05598478f * state->obs[4]
        + 0.3226204f * state->obs[6]
        - 0.8628424f * state->obs[7];
    const float leg = term_2 - 0.12721324f * state->obs[8] - 0.0822124f * state->obs[9] - 1.109722f;
    const float term_3 = 3.3940566f * state->obs[0]
        + 0.5165295f * state->obs[1]
        + 2.143888f * state->obs[2]
        - 0.25035787f * state->obs[3]
        - 0.83269984f * state->obs[5]
        + 0.02263618f * state->obs[6]
        + 0.46339342f * state->obs[7];
    const float foot = term_3
        + 0.13614666f * state->obs[8]
        - 0.039877187f * state->obs[9]
        - 0.0018393787f * state->obs[10]
        - 2.0928748f;

    action->thigh = hopper_clamp(thigh, -1.0f, 1.0f);
    action->leg = hopper_clamp(leg, -1.0f, 1.0f);
    action->foot = hopper_clamp(foot, -1.0f, 1.0f);
}
#ifndef HOPPER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold: of some flags, such as clang's -fno-honor-nans and -ffp-contract=fast, no macro
 * tells, nor of a processor that flushes small numbers to 0. */
static uint32_t hopper_arithmetic(void)
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

uint32_t hopper_selftest(void)
{
    static const hopper_state_t states[16] = {
        { { 1.160104f, -0.13523732f, -0.23954001f, -0.861511f, -0.56095904f, 2.8757875f, -0.25413963f, -0.44330215f, 6.5772467f, 4.529355f, -0.5022853f } },
        { { 1.3029174f, -0.13171338f, -0.58455014f, -0.53114593f, -0.5704712f, 4.358932f, 2.917252f, 0.8846019f, -7.3532085f, -4.289092f, -0.5909326f } },
        { { 1.1558936f, -0.14755645f, -0.80754155f, -0.90976024f, 0.10353037f, 0.53553545f, -2.8731844f, -0.5305484f, 8.76084f, 4.2468076f, -11.752636f } },
        { { 1.3049304f, -0.015093548f, -0.1274309f, -0.85573107f, 1.2784809f, -0.20440064f, 0.9506601f, 0.6452031f, 1.0647932f, 9.2183275f, -3.6207805f } },
        { { 1.2208766f, 0.020272017f, -0.50714964f, -0.28794736f, -0.56635046f, 0.31708267f, 0.5243566f, 0.866743f, -3.3768165f, 9.405783f, 14.885904f } },
        { { 1.5580788f, -0.014784518f, -0.32389644f, -0.25393227f, 0.22192079f, 2.366583f, -0.1773126f, 0.38527074f, 1.5388409f, -11.0568f, -7.783102f } },
        { { 1.1748378f, -0.08249661f, -0.4821092f, -0.8118365f, 0.27928418f, 0.5733771f, 2.7609103f, 0.39485678f, -5.790032f, 2.441542f, -4.113694f } },
        { { 1.0382361f, 0.03159755f, -0.29923016f, 0.15600055f, -0.6394988f, 0.53887856f, -2.527053f, -0.034618545f, 6.681234f, 8.7397175f, -12.988243f } },
        { { 1.5366849f, 0.026931753f, 0.10358063f, -0.9940519f, -1.235363f, -0.7348468f, 0.6112633f, 0.5030015f, 4.814678f, 10.759439f, 7.478348f } },
        { { 0.91382724f, -0.027514957f, -0.4161504f, -0.55679864f, 0.44636786f, 3.3715441f, -3.2439241f, 0.6536037f, -0.2973073f, -12.108143f, -5.563344f } },
        { { 1.4641918f, 0.031736165f, 0.02237901f, -0.3018469f, 0.12949337f, 1.7898343f, -0.6696705f, 0.73955834f, 5.4929376f, -2.186776f, -13.33576f } },
        { { 1.282945f, -0.0810466f, 0.1681055f, -0.65411216f, -0.9693066f, -0.67742485f, -1.2280134f, -0.25341138f, -4.292332f, 7.7872763f, 7.8943367f } },
        { { 1.0212979f, 0.006162872f, 0.03435518f, -0.47603354f, 1.184489f, 3.1554184f, 0.8446366f, 0.8018186f, 4.835697f, 11.623888f, 2.633524f } },
        { { 1.3390068f, 0.013319481f, -0.30238396f, -0.306529f, 0.99319327f, 2.1989639f, -1.5568249f, 0.24478531f, 4.6231995f, 5.253093f, 8.192992f } },
        { { 1.111528f, -0.03200134f, -0.72345215f, -0.23810647f, 0.20058915f, 3.3858676f, -1.5295808f, -0.63530207f, -6.315311f, 5.353601f, -12.4503765f } },
        { { 1.1704429f, 0.0035134556f, -0.37748766f, -1.0752057f, -0.22971018f, 1.3276974f, -2.2884011f, -0.5872204f, -1.3720185f, 0.5060221f, 4.6635385f } },
    };
    static const hopper_action_t actions[16] = {
        { 1.0f, 0.61642337f, -0.4131987f },
        { 0.38199186f, 1.0f, -1.0f },
        { 1.0f, -1.0f, 0.5387583f },
        { -1.0f, -1.0f, 1.0f },
        { -1.0f, -1.0f, 0.33341646f },
        { -0.88781524f, -1.0f, 1.0f },
        { -1.0f, 1.0f, -0.08842802f },
        { 0.538012f, -1.0f, 0.8297403f },
        { -1.0f, -1.0f, 1.0f },
        { -1.0f, -1.0f, -1.0f },
        { -1.0f, -1.0f, 1.0f },
        { -0.122573376f, 0.7112788f, 1.0f },
        { -0.99637914f, -1.0f, -0.47736347f },
        { -0.14495182f, -1.0f, 0.53913355f },
        { 1.0f, -1.0f, -1.0f },
        { -1.0f, -0.60727006f, -0.30365634f },
    };
    uint32_t failures = hopper_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 16U; vector++) {
        hopper_action_t action;

        hopper_infer(&states[vector], &action);
        if (!((action.thigh >= actions[vector].thigh) && (action.thigh <= actions[vector].thigh)) ||
            !((action.leg >= actions[vector].leg) && (action.leg <= actions[vector].leg)) ||
            !((action.foot >= actions[vector].foot) && (action.foot <= actions[vector].foot))) {
            failures++;
        }
    }
    return failures;
}
#endif
