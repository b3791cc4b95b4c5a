/*
 * A policy for BipedalWalker-v3 of Gymnasium, score 323.31 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix bipedal_walker --profile fast
 * Graph SHA-256: 930bc482e9b2dac7e8b66894e062e74b70c9fa9eb26564bd3db1278638a9bb94
 * 1 team, 1 edge, 1 program, 192 distinct operations.
 * A decision takes at most 192 operations.
 * Computes in f32 with own maths.
 */
#include "bipedal_walker.h"

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

/* An output in its range. NaN fails both comparisons, and becomes 0.0f. */
static float bipedal_walker_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void bipedal_walker_infer(const bipedal_walker_state_t *state, bipedal_walker_action_t *action)
{
    const float term = 0.43313652f * state->hull_angle
        + 0.006045125f * state->hull_spin
        - 0.9406402f * state->vx
        + 1.1379249f * state->vy
        - 0.27293232f * state->hip_1_angle
        - 1.2722539f * state->hip_1_speed
        + 0.99190795f * state->knee_1_angle;
    const float term_2 = term
        - 0.46254736f * state->knee_1_speed
        - 0.36908358f * state->contact_1
        + 0.42084303f * state->hip_2_angle
        + 0.23321724f * state->hip_2_speed
        - 0.11389011f * state->knee_2_angle
        + 0.43208057f * state->knee_2_speed;
    const float term_3 = term_2
        - 0.010095447f * state->contact_2
        + 4.4875813f * state->lidar_0
        - 9.051807f * state->lidar_1
        - 1.3506355f * state->lidar_2
        + 8.500628f * state->lidar_3
        - 6.9748583f * state->lidar_4
        - 0.7869225f * state->lidar_5;
    const float hip_1 = term_3
        + 7.8863435f * state->lidar_6
        - 3.1613417f * state->lidar_7
        + 0.09573793f * state->lidar_8
        - 6.447783f * state->lidar_9
        + 5.9709144f;
    const float term_4 = -0.6784458f * state->hull_angle
        + 2.167693f * state->hull_spin
        + 3.1354392f * state->vx
        - 5.378494f * state->vy
        - 0.7907029f * state->hip_1_angle
        + 0.15056907f * state->hip_1_speed
        - 2.3365674f * state->knee_1_angle;
    const float term_5 = term_4
        - 0.04153449f * state->knee_1_speed
        + 0.29449865f * state->contact_1
        + 0.37659582f * state->hip_2_angle
        + 0.058632873f * state->hip_2_speed
        + 2.3247058f * state->knee_2_angle
        + 0.3777262f * state->knee_2_speed;
    const float term_6 = term_5
        - 0.011592703f * state->contact_2
        + 10.344545f * state->lidar_0
        - 7.4077225f * state->lidar_1
        + 2.2106109f * state->lidar_2
        - 9.954698f * state->lidar_3
        - 1.1742669f * state->lidar_4
        - 8.619116f * state->lidar_5;
    const float knee_1 = term_6
        + 1.6254114f * state->lidar_6
        + 1.084647f * state->lidar_7
        - 0.3101107f * state->lidar_8
        + 18.147518f * state->lidar_9
        - 13.862106f;
    const float term_7 = 2.1542137f * state->hull_angle
        - 2.1436977f * state->hull_spin
        + 1.353505f * state->vx
        - 1.4395895f * state->vy
        + 1.4794261f * state->hip_1_angle
        + 0.19376321f * state->hip_1_speed
        + 0.22323757f * state->knee_1_angle;
    const float term_8 = term_7
        + 0.19982354f * state->knee_1_speed
        + 0.14311513f * state->contact_1
        - 0.81286705f * state->hip_2_angle
        - 0.44202605f * state->hip_2_speed
        + 0.28939056f * state->knee_2_angle
        + 0.08988224f * state->knee_2_speed;
    const float term_9 = term_8
        - 0.035194054f * state->contact_2
        - 1.4962751f * state->lidar_0
        - 2.571821f * state->lidar_1
        + 7.4698043f * state->lidar_2
        - 4.813802f * state->lidar_3
        + 0.45718148f * state->lidar_4
        + 8.570346f * state->lidar_5;
    const float hip_2 = term_9
        + 0.043355696f * state->lidar_6
        - 1.7338103f * state->lidar_7
        - 0.52388465f * state->lidar_8
        + 1.151409f * state->lidar_9
        - 2.5815685f;
    const float term_10 = -1.0676469f * state->hull_angle
        - 1.2909809f * state->hull_spin
        - 0.8371953f * state->vx
        - 2.8452365f * state->vy
        + 0.021685855f * state->hip_1_angle
        - 0.06468743f * state->hip_1_speed
        - 0.13105504f * state->knee_1_angle;
    const float term_11 = term_10
        + 0.0043608746f * state->knee_1_speed
        - 0.018771987f * state->contact_1
        + 0.17987023f * state->hip_2_angle
        - 0.24441965f * state->hip_2_speed
        - 1.5290816f * state->knee_2_angle
        - 0.3734259f * state->knee_2_speed;
    const float term_12 = term_11
        - 0.023268756f * state->contact_2
        + 0.32405788f * state->lidar_0
        + 5.7792134f * state->lidar_1
        - 7.545338f * state->lidar_2
        + 1.5639713f * state->lidar_3
        - 4.1553626f * state->lidar_4;
    const float knee_2 = term_12
        + 4.670011f * state->lidar_5
        - 5.031331f * state->lidar_6
        + 2.1768126f * state->lidar_7
        - 0.6732741f * state->lidar_8
        - 8.497251f * state->lidar_9
        + 9.79428f;

    action->hip_1 = bipedal_walker_clamp(hip_1, -1.0f, 1.0f);
    action->knee_1 = bipedal_walker_clamp(knee_1, -1.0f, 1.0f);
    action->hip_2 = bipedal_walker_clamp(hip_2, -1.0f, 1.0f);
    action->knee_2 = bipedal_walker_clamp(knee_2, -1.0f, 1.0f);
}

#ifndef BIPEDAL_WALKER_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t bipedal_walker_arithmetic(void)
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

uint32_t bipedal_walker_selftest(void)
{
    static const bipedal_walker_state_t states[6] = {
        { -0.61270064f, -4.1961627f, 0.9656018f, -2.806754f, -1.3591121f, 2.1061022f, -0.24449022f, -3.473473f, 4.373905f, 1.2982574f, -0.16742843f, 0.48511934f, -4.005405f, 1.3195878f, -0.09308055f, -0.43954256f, 0.9820647f, 0.82470983f, 0.89423496f, -0.73351216f, -0.3126318f, -0.039395504f, -0.20533113f, -0.97260493f },
        { -2.8342214f, -3.1487048f, 0.2552497f, -2.3186753f, -2.5860555f, -3.995454f, 3.0851495f, 1.949953f, 0.5412273f, 0.50059414f, 2.307476f, 1.2858573f, -2.7657912f, 4.765683f, -0.7435385f, 0.26504543f, 0.60777766f, 0.16269131f, 0.7992153f, -0.24138537f, -0.046325635f, 0.84437793f, -0.32291302f, 0.25163704f },
        { -1.3714406f, -2.7317097f, 0.7186272f, 4.364328f, -0.9744423f, 4.0732274f, 3.1176965f, 3.893838f, 3.6621022f, 0.09567823f, 1.4992557f, 0.43110192f, 1.1433358f, 2.3601005f, 0.29675052f, 0.21315971f, -0.8697076f, -0.51887345f, -0.15897672f, -0.2682392f, -0.27462733f, -0.4909406f, 0.17897768f, -0.4494254f },
        { 2.4511247f, 1.5411043f, -2.8354604f, 1.2069616f, -0.86157006f, -2.466124f, 3.0378983f, 0.3900973f, 4.7022586f, -1.5387092f, -2.3123543f, -2.2765956f, -1.0283812f, 4.4015822f, 0.75981915f, -0.8658829f, 0.7264193f, 0.9164791f, 0.8547621f, -0.74921864f, -0.9235042f, -0.9441242f, 0.16845787f, 0.43762353f },
        { 1.0743423f, 0.7644059f, 3.6437602f, -0.21745218f, 1.154896f, -1.8299885f, -1.9994687f, -2.8616793f, 1.4977715f, -0.39650998f, 3.6231658f, 0.31024447f, 4.460904f, 4.4975657f, 0.12375207f, -0.71843547f, 0.80203164f, -0.14330037f, -0.13826086f, -0.97599334f, -0.9399671f, 0.6635956f, -0.15953697f, -0.67120856f },
        { 0.16886024f, -0.18883172f, 2.2470083f, -2.3602517f, -0.008637506f, -1.1454599f, 1.0009583f, 0.99311465f, 1.663329f, -0.68392354f, 2.322349f, -1.380172f, -1.12099f, 2.3065033f, -0.13044906f, -0.30312777f, -0.15607469f, -0.397948f, -0.35161886f, 0.39868152f, -0.39619192f, 0.36488804f, 0.49544373f, -0.08442681f },
    };
    static const bipedal_walker_action_t actions[6] = {
        { 1.0f, -1.0f, 1.0f, 1.0f },
        { -1.0f, -1.0f, -1.0f, 1.0f },
        { 1.0f, -1.0f, -1.0f, 1.0f },
        { 1.0f, -1.0f, -1.0f, -1.0f },
        { 1.0f, 1.0f, 0.9774101f, 0.0053749084f },
        { -0.034945965f, -0.9268303f, 1.0f, 1.0f },
    };
    uint32_t failures = bipedal_walker_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 6U; vector++) {
        bipedal_walker_action_t action;

        bipedal_walker_infer(&states[vector], &action);
        if (!((action.hip_1 >= actions[vector].hip_1) && (action.hip_1 <= actions[vector].hip_1)) ||
            !((action.knee_1 >= actions[vector].knee_1) && (action.knee_1 <= actions[vector].knee_1)) ||
            !((action.hip_2 >= actions[vector].hip_2) && (action.hip_2 <= actions[vector].hip_2)) ||
            !((action.knee_2 >= actions[vector].knee_2) && (action.knee_2 <= actions[vector].knee_2))) {
            failures++;
        }
    }
    return failures;
}
#endif
