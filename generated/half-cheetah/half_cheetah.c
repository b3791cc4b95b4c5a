/*
 * A policy for HalfCheetah-v5, score 4739.82 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix half_cheetah --profile fast
 * Graph SHA-256: 909066e89f0f3337d020b7a767128fa97ceedc04b0735efd6eaaa64d4265eb6f
 * 1 team, 1 edge, 1 program, 198 distinct operations.
 * A decision takes at most 198 operations.
 * Computes in f32 with own maths.
 */
#include "half_cheetah.h"

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
static float half_cheetah_clamp(float value, float low, float high)
{
    if (value >= low) {
        return (value > high) ? high : value;
    }
    return (value < low) ? low : 0.0f;
}

void half_cheetah_infer(const half_cheetah_state_t *state, half_cheetah_action_t *action)
{
    const float term = 1.4008873f * state->height
        + 0.09387724f * state->pitch
        - 0.18976228f * state->back_thigh_angle
        - 0.12725973f * state->back_shin_angle
        - 1.6832566f * state->back_foot_angle
        + 0.38527772f * state->front_thigh_angle;
    const float term_2 = term
        + 0.4094602f * state->front_shin_angle
        + 0.08500024f * state->vx
        - 0.10341745f * state->vz
        - 0.15919156f * state->pitch_speed
        - 0.022208741f * state->back_thigh_speed
        - 0.026848406f * state->back_shin_speed;
    const float back_thigh = term_2
        - 0.022946933f * state->back_foot_speed
        + 0.018442832f * state->front_thigh_speed
        - 0.02791334f * state->front_shin_speed
        - 0.021624371f * state->front_foot_speed
        + 0.0508656f;
    const float term_3 = -1.1853826f * state->height
        - 0.3723432f * state->pitch
        + 0.042402733f * state->back_thigh_angle
        + 0.33647406f * state->back_shin_angle
        + 0.1202205f * state->back_foot_angle
        - 0.12960166f * state->front_thigh_angle;
    const float term_4 = term_3
        - 0.043244623f * state->front_shin_angle
        + 0.40792063f * state->front_foot_angle
        - 0.0307495f * state->vx
        - 0.093859464f * state->vz
        + 0.0531134f * state->pitch_speed
        - 0.04513471f * state->back_thigh_speed;
    const float term_5 = term_4
        - 0.002819547f * state->back_shin_speed
        - 0.029158877f * state->back_foot_speed
        + 0.013162317f * state->front_thigh_speed
        - 0.017216053f * state->front_shin_speed
        + 0.039490286f * state->front_foot_speed;
    const float back_shin = term_5 + 0.054933626f;
    const float term_6 = 0.12277543f * state->height
        + 0.051600974f * state->pitch
        + 1.2118318f * state->back_thigh_angle
        - 0.4268653f * state->back_shin_angle
        - 0.40210655f * state->back_foot_angle
        + 0.47833714f * state->front_thigh_angle;
    const float term_7 = term_6
        + 0.8851195f * state->front_shin_angle
        + 0.11428689f * state->front_foot_angle
        + 0.07447019f * state->vx
        + 0.4652907f * state->vz
        - 0.01510865f * state->pitch_speed
        - 0.012634864f * state->back_thigh_speed;
    const float term_8 = term_7
        - 0.004542586f * state->back_shin_speed
        - 0.010618708f * state->back_foot_speed
        + 0.023100879f * state->front_thigh_speed
        + 0.022929158f * state->front_shin_speed
        - 0.016002292f * state->front_foot_speed;
    const float back_foot = term_8 - 0.16678137f;
    const float term_9 = -1.418642f * state->height
        + 0.43121094f * state->pitch
        + 0.056831904f * state->back_thigh_angle
        - 0.11759443f * state->back_shin_angle
        + 0.38178843f * state->back_foot_angle
        - 0.2822201f * state->front_thigh_angle;
    const float term_10 = term_9
        - 0.8116351f * state->front_shin_angle
        + 0.62498f * state->front_foot_angle
        - 0.11484541f * state->vx
        - 0.05127445f * state->vz
        + 0.14062005f * state->pitch_speed
        - 0.012118952f * state->back_thigh_speed;
    const float term_11 = term_10
        + 0.009986786f * state->back_shin_speed
        - 0.038676754f * state->back_foot_speed
        + 0.0007840264f * state->front_thigh_speed
        + 0.004478204f * state->front_shin_speed
        + 0.005064627f * state->front_foot_speed;
    const float front_thigh = term_11 + 0.0014363579f;
    const float term_12 = -0.11193159f * state->height
        + 0.3165f * state->pitch
        + 0.46301544f * state->back_thigh_angle
        - 0.224833f * state->back_shin_angle
        + 0.45676583f * state->back_foot_angle
        - 0.35732824f * state->front_thigh_angle;
    const float term_13 = term_12
        + 0.73909867f * state->front_foot_angle
        + 0.0034187804f * state->vx
        - 0.026946642f * state->vz
        - 0.008634697f * state->pitch_speed
        - 0.0042703478f * state->back_thigh_speed
        + 0.009634706f * state->back_shin_speed;
    const float front_shin = term_13
        - 0.020781748f * state->back_foot_speed
        - 0.021359142f * state->front_thigh_speed
        - 0.045049116f * state->front_shin_speed
        + 0.021782797f * state->front_foot_speed
        - 0.12608574f;
    const float term_14 = 0.93854785f * state->height
        + 0.05506858f * state->pitch
        + 0.17329441f * state->back_shin_angle
        + 0.11109171f * state->back_foot_angle
        - 0.494372f * state->front_thigh_angle
        + 0.8358307f * state->front_shin_angle;
    const float term_15 = term_14
        + 0.09513146f * state->front_foot_angle
        - 0.13991123f * state->vx
        + 0.30567983f * state->vz
        + 0.10073735f * state->pitch_speed
        - 0.01967937f * state->back_thigh_speed
        + 0.045426693f * state->back_shin_speed;
    const float front_foot = term_15
        + 0.0011335313f * state->back_foot_speed
        + 0.0071149385f * state->front_thigh_speed
        + 0.0075003016f * state->front_shin_speed
        - 0.049951147f * state->front_foot_speed
        + 0.5277141f;

    action->back_thigh = half_cheetah_clamp(back_thigh, -1.0f, 1.0f);
    action->back_shin = half_cheetah_clamp(back_shin, -1.0f, 1.0f);
    action->back_foot = half_cheetah_clamp(back_foot, -1.0f, 1.0f);
    action->front_thigh = half_cheetah_clamp(front_thigh, -1.0f, 1.0f);
    action->front_shin = half_cheetah_clamp(front_shin, -1.0f, 1.0f);
    action->front_foot = half_cheetah_clamp(front_foot, -1.0f, 1.0f);
}

#ifndef HALF_CHEETAH_NO_SELFTEST

/* Counts the rules of arithmetic that do not hold. No macro reveals some flags, such as clang's -fno-honor-nans and
 * -ffp-contract=fast, nor a processor that flushes subnormal numbers to zero. */
static uint32_t half_cheetah_arithmetic(void)
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

uint32_t half_cheetah_selftest(void)
{
    static const half_cheetah_state_t states[7] = {
        { -0.07880321f, -0.22123992f, 0.26294416f, -0.48227736f, -0.27833334f, 0.225264f, 0.06078638f, -0.5353276f, 7.598215f, 0.81597406f, -0.4123589f, 5.5429873f, -19.237198f, -11.843935f, -1.0476578f, -10.638998f, 14.858075f },
        { 0.26235643f, 0.7671644f, -0.61620206f, -0.27241188f, 0.07687293f, -0.51623315f, -0.55054253f, -0.66015863f, -0.011692463f, 0.06492519f, -3.4462726f, -16.8507f, -19.194275f, 23.7193f, 14.112349f, -16.334492f, 3.447543f },
        { 0.14084078f, 0.49066037f, -0.44509056f, 0.75608236f, -0.55919313f, 0.040437493f, 0.5292002f, -0.01944395f, 7.872162f, -0.5414644f, -0.5029001f, 21.347994f, -8.923966f, 5.857044f, -11.82639f, -12.407413f, 3.2309241f },
        { 0.27846718f, 0.08042318f, 0.8526186f, 0.8287494f, 0.8159356f, 0.27688697f, 0.13476431f, 0.06308425f, 4.2198157f, 0.43322963f, -0.57083535f, 8.803412f, 2.638168f, -21.566063f, -14.410127f, -5.9933114f, -2.4827228f },
        { 0.0689725f, 0.23515753f, -0.0873861f, -0.38233146f, 0.38647518f, -0.62007725f, 0.28697774f, 0.17840676f, 1.382556f, 1.1478083f, 4.2851563f, 18.609167f, 14.71431f, -18.297089f, -13.124823f, -12.441492f, -5.925833f },
        { -0.04957751f, 0.4005462f, -0.26378378f, 0.4309231f, -0.55438143f, -0.4515694f, -0.5213895f, 0.18727915f, 1.2085862f, -1.9763299f, 2.7256782f, 5.6832013f, -17.811033f, -10.879902f, -16.231077f, -17.891973f, 14.507892f },
        { -0.19715157f, -0.19449334f, -0.39061677f, -0.49634016f, -0.15492357f, 0.110197656f, 0.24234572f, 0.2517616f, 7.466725f, 1.1454207f, -3.6581893f, 4.6244698f, -21.707367f, 15.5850725f, 22.22132f, 11.943088f, 2.590241f },
    };
    static const half_cheetah_action_t actions[7] = {
        { 1.0f, 0.36934918f, 1.0f, -1.0f, 0.30958205f, -1.0f },
        { 1.0f, -0.2914577f, -1.0f, -1.0f, -0.47346228f, -0.52365845f },
        { 1.0f, -1.0f, -0.8347878f, -1.0f, -0.017966531f, -1.0f },
        { -0.44181174f, -0.06919034f, 0.6815315f, -0.12856959f, 1.0f, 0.39272866f },
        { -1.0f, -0.522647f, -0.29551712f, 1.0f, 1.0f, 1.0f },
        { 0.92113787f, 1.0f, -1.0f, 1.0f, 1.0f, -1.0f },
        { 1.0f, -0.7074124f, 1.0f, -1.0f, -1.0f, -1.0f },
    };
    uint32_t failures = half_cheetah_arithmetic();
    uint32_t vector;

    for (vector = 0U; vector < 7U; vector++) {
        half_cheetah_action_t action;

        half_cheetah_infer(&states[vector], &action);
        if (!((action.back_thigh >= actions[vector].back_thigh) && (action.back_thigh <= actions[vector].back_thigh)) ||
            !((action.back_shin >= actions[vector].back_shin) && (action.back_shin <= actions[vector].back_shin)) ||
            !((action.back_foot >= actions[vector].back_foot) && (action.back_foot <= actions[vector].back_foot)) ||
            !((action.front_thigh >= actions[vector].front_thigh) && (action.front_thigh <= actions[vector].front_thigh)) ||
            !((action.front_shin >= actions[vector].front_shin) && (action.front_shin <= actions[vector].front_shin)) ||
            !((action.front_foot >= actions[vector].front_foot) && (action.front_foot <= actions[vector].front_foot))) {
            failures++;
        }
    }
    return failures;
}
#endif
