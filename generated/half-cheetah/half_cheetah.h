/*
 * A policy for HalfCheetah-v5, score 4739.82 in validation, trained by tpg-train 0.1.0 with seed 1.
 * Made by tpg-codegen 0.1.0 from a tangled program graph; do not edit.
 * Options: --lang c --prefix half_cheetah --profile fast
 * Graph SHA-256: 909066e89f0f3337d020b7a767128fa97ceedc04b0735efd6eaaa64d4265eb6f
 * 1 team, 1 edge, 1 program, 198 distinct operations.
 * A decision takes at most 198 operations.
 * Computes in f32 with own maths.
 */
#ifndef HALF_CHEETAH_H
#define HALF_CHEETAH_H

#include <stdint.h>

#ifdef __cplusplus
extern "C" {
#endif

#define HALF_CHEETAH_OUTPUTS 6U

/* What the policy sees. Values outside the ranges are legal, NaN and infinities too. */
typedef struct half_cheetah_state {
    float height; /* -0.34811118 to 0.32100078 */
    float pitch; /* -0.31290776 to 0.8274705 */
    float back_thigh_angle; /* -0.8690334 to 1.0284743 */
    float back_shin_angle; /* -0.8524031 to 0.8351676 */
    float back_foot_angle; /* -0.7908598 to 1.0157791 */
    float front_thigh_angle; /* -1.45669 to 0.910225 */
    float front_shin_angle; /* -0.5692593 to 0.7971728 */
    float front_foot_angle; /* -0.71902794 to 0.48435938 */
    float vx; /* -2.05449 to 8.979934 */
    float vz; /* -2.1145165 to 2.032654 */
    float pitch_speed; /* -7.227758 to 6.8752904 */
    float back_thigh_speed; /* -20.901438 to 24.91285 */
    float back_shin_speed; /* -23.527529 to 19.608913 */
    float back_foot_speed; /* -24.752438 to 24.158678 */
    float front_thigh_speed; /* -29.509106 to 33.256 */
    float front_shin_speed; /* -19.919209 to 13.197348 */
    float front_foot_speed; /* -12.631708 to 15.106824 */
} half_cheetah_state_t;

/* The values that the policy answers, each in its range and never NaN. */
typedef struct half_cheetah_action {
    float back_thigh; /* -1 to 1 */
    float back_shin; /* -1 to 1 */
    float back_foot; /* -1 to 1 */
    float front_thigh; /* -1 to 1 */
    float front_shin; /* -1 to 1 */
    float front_foot; /* -1 to 1 */
} half_cheetah_action_t;

/* The answer to a state. Pure and reentrant: no globals, no memory, no side effect but *action. */
void half_cheetah_infer(const half_cheetah_state_t *state, half_cheetah_action_t *action);

#ifndef HALF_CHEETAH_NO_SELFTEST
/* Runs embedded states and returns how many gave another action than the graph's interpreter did: 0 is good.
 * A change by 1 % is noticed in 117 of 117 constants.
 */
uint32_t half_cheetah_selftest(void);
#endif

#ifdef __cplusplus
}
#endif

#endif
